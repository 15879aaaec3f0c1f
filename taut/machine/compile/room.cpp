#include "taut/machine/compile/room.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/machine/rounds.hpp"

namespace taut::machine {
namespace {

/// Neighbours reported, whichever way round: a tackle runs between two sheaves many times.
class Pairs {
 public:
  bool is_new(const std::string& a, const std::string& b) { return reported_.insert(std::minmax(a, b)).second; }
  bool empty() const { return reported_.empty(); }

 private:
  std::set<std::pair<std::string, std::string>> reported_;
};

const Body* body_under(const Model& model, const Node& node) {
  return node.at.body == ground ? nullptr : &model.bodies[node.at.body];
}

bool rests(const Body* body) { return body == nullptr || (body->free.empty() && body->driven.empty()); }

/// Whether the distance of two nodes never changes.
bool keep_apart(const Model& model, const Node& a, const Node& b) {
  return a.at.body == b.at.body || (rests(body_under(model, a)) && rests(body_under(model, b)));
}

struct Circle {
  Vector3 centre, axis;
  double radius = 0;  ///< > 0 where the path turns right-handed about the axis
};

Circle circle_of(const Model& model, const Node& node) {
  return {.centre = in_ground(model, node.at),
          .axis = turned(model, node.at.body) * node.axis,
          .radius = node.side * node.radius};
}

double across(const Vector3& d, const Vector3& axis) { return (d - d.dot(axis) * axis).norm(); }

/// Why no rope runs from one node to the next, in words; empty where one does.
std::string no_room(const Model& model, const Node& from, const Node& to) {
  const Circle a = circle_of(model, from), b = circle_of(model, to);
  const Vector3 d = b.centre - a.centre;
  const auto point_inside = [&](const Node& point, const Node& round, const Circle& circle) {
    const double apart = across(d, circle.axis), radius = std::abs(circle.radius);
    if (apart >= radius) return std::string();
    return fmt::format(
        "'{}' lies inside '{}': {:.4g} m from its axis, and the rope runs on a circle with a radius of {:.4g} m; move "
        "one of them, or make '{}' smaller",
        point.name, round.name, apart, radius, round.name);
  };
  if (a.radius == 0 && b.radius == 0) return {};
  if (a.radius == 0) return point_inside(from, to, b);
  if (b.radius == 0) return point_inside(to, from, a);
  if (a.axis.cross(b.axis).norm() > 1e-9) return {};
  const double apart = across(d, a.axis);
  const double needs = std::abs(a.radius - (a.axis.dot(b.axis) < 0 ? -b.radius : b.radius));
  if (apart > needs) return {};
  const bool crosses = needs > std::max(std::abs(a.radius), std::abs(b.radius));
  return fmt::format(
      "no rope runs from '{}' to '{}': their axes are {:.4g} m apart, and the radii of the rope there, {:.4g} m and "
      "{:.4g} m, {} {:.4g} m; move them apart{}",
      from.name, to.name, apart, std::abs(a.radius), std::abs(b.radius), crosses ? "add up to" : "differ by", needs,
      crosses ? ", or give another 'side'" : "");
}

}  // namespace

bool check_apart(const Array<Stop>& stops, const Array<Vector3>& places, bool closed, const DeckPlace& path,
                 std::vector<Complaint>& complaints) {
  Pairs reported;
  for (std::size_t k = closed ? 0 : 1; k < places.size(); ++k) {
    const std::size_t before = k == 0 ? places.size() - 1 : k - 1;
    const std::string &from = stops[before].node.name, &to = stops[k].node.name;
    if ((places[k] - places[before]).norm() > 0 || !reported.is_new(from, to)) continue;
    complaints.push_back({path.text(), fmt::format("'{}' and '{}' are at the same place", from, to)});
  }
  return reported.empty();
}

void check_room(const Model& model, const Array<Stop>& stops, bool closed, const DeckPlace& path,
                std::vector<Complaint>& complaints) {
  Pairs reported;
  for (std::size_t k = closed ? 0 : 1; k < stops.size(); ++k) {
    const Node &from = stops[k == 0 ? stops.size() - 1 : k - 1].node, &to = stops[k].node;
    if (!keep_apart(model, from, to)) continue;
    std::string why = no_room(model, from, to);
    if (!why.empty() && reported.is_new(from.name, to.name)) complaints.push_back({path.text(), std::move(why)});
  }
}

}  // namespace taut::machine
