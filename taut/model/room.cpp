#include "taut/model/room.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

namespace taut::model {
namespace {

const Body* body_under(const Model& model, const Node& node) {
  return node.at.body == ground ? nullptr : &model.bodies[static_cast<std::size_t>(node.at.body)];
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
  const Body* body = body_under(model, node);
  const double radius = node.side * node.radius;
  if (body == nullptr) return {node.at.at, node.axis, radius};
  return {body->position + body->orientation * node.at.at, body->orientation * node.axis, radius};
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

bool check_apart(const std::vector<Stop>& stops, const std::vector<Vector3>& places, bool closed,
                 const std::string& path, std::vector<Complaint>& complaints) {
  bool apart = true;
  for (std::size_t k = closed ? 0 : 1; k < places.size(); ++k) {
    const std::size_t before = k == 0 ? places.size() - 1 : k - 1;
    if ((places[k] - places[before]).norm() > 0) continue;
    complaints.push_back(
        {path, fmt::format("'{}' and '{}' are at the same place", stops[before].node.name, stops[k].node.name)});
    apart = false;
  }
  return apart;
}

void check_room(const Model& model, const std::vector<Stop>& stops, bool closed, const std::string& path,
                std::vector<Complaint>& complaints) {
  for (std::size_t k = closed ? 0 : 1; k < stops.size(); ++k) {
    const Node &from = stops[k == 0 ? stops.size() - 1 : k - 1].node, &to = stops[k].node;
    if (!keep_apart(model, from, to)) continue;
    std::string why = no_room(model, from, to);
    if (!why.empty()) complaints.push_back({path, std::move(why)});
  }
}

}  // namespace taut::model
