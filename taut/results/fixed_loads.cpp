#include "taut/results/fixed_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "taut/base/array.hpp"

namespace taut::results {
namespace {

Vector3 described(const machine::Model& m, const machine::Place& place) {
  if (place.body == machine::ground) return place.at;
  const machine::Body& body = m.bodies[place.body];
  return body.position + body.orientation * place.at;
}

bool leads_up(const Vector3& way) { return way.z() > way.head<2>().norm(); }

/// What carries a drum is a winch on its stand, though its ropes lead up.
bool hangs(const machine::Model& m, int body) {
  bool held = false;
  for (const machine::Reeving& rope : m.reevings) {
    const std::size_t count = rope.nodes.size();
    for (const machine::Node& node : rope.nodes) {
      if (node.at.body == body && node.drum) return false;
    }
    for (std::size_t k = 0; k + (rope.closed ? 0 : 1) < count; ++k) {
      const machine::Place& one = rope.nodes[k].at;
      const machine::Place& next = rope.nodes[(k + 1) % count].at;
      if ((one.body == body) == (next.body == body)) continue;
      const Vector3 way = described(m, next) - described(m, one);
      if (!leads_up(one.body == body ? way : Vector3(-way))) return false;
      held = true;
    }
  }
  return held;
}

constexpr double same_place = 0.05;  ///< m, of a point; a round touches what is nearer than its radius
constexpr double above_foot = 0.05;  ///< of a beam's length: what stands lower is fixed at its foot

/// The straight line from the foot of a beam that stands on the ground to its free end, as built.
struct Upright {
  Vector3 foot, top;

  bool has(const machine::Node& node) const {
    const Vector3 axis = top - foot;
    const double part = (node.at.at - foot).dot(axis) / axis.squaredNorm();
    if (part < above_foot || part > 1 + same_place) return false;
    return (node.at.at - foot - part * axis).norm() < std::max(same_place, node.radius);
  }
};

std::optional<Upright> upright(const machine::Model& m, const machine::Beam& beam) {
  const machine::Place &foot = beam.pieces.front().start, &top = beam.pieces.back().end;
  const bool stands = foot.body == machine::ground || machine::stands_fast(m.bodies[foot.body]);
  if (!stands || top.body == machine::ground || machine::stands_fast(m.bodies[top.body])) return std::nullopt;
  return Upright{.foot = described(m, foot), .top = described(m, top)};
}

constexpr double of_load = 0.01;       ///< share of a load below which nobody asks who bears it
constexpr double no_direction = 1e-9;  ///< of a unit vector, or of metres: what is shorter points nowhere

/// Takes a direction in which a force does work out of what is left of space.
void take_out(const Vector3& way, std::vector<Vector3>& done) {
  Vector3 left = way;
  for (const Vector3& one : done) left -= one.dot(left) * one;
  if (left.norm() > no_direction) done.push_back(left.normalized());
}

/// Directions in which a place of a body can go, orthogonal unit vectors: along its slides, and across its axes where
/// the place is off the axis. A body that turns about one axis goes everywhere across it.
std::vector<Vector3> ways_of(const machine::Body& body, const Vector3& at) {
  std::vector<Vector3> ways;
  const Vector3 arm = body.orientation * at;
  std::vector<Vector3> axes;
  for (const machine::Freedom& one : body.free) {
    take_out(one.along, ways);
    take_out(one.about, axes);
  }
  const bool off_axis = axes.size() == 1 ? axes.front().cross(arm).norm() > no_direction : arm.norm() > no_direction;
  if (axes.empty() || !off_axis) return ways;
  for (const Vector3& unit : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()), Vector3(Vector3::UnitZ())}) {
    take_out(axes.size() == 1 ? Vector3(unit - axes.front().dot(unit) * axes.front()) : unit, ways);
  }
  return ways;
}

/// What of the loads on a body does no work in its freedoms, and their sizes, N.
struct BorneAcross {
  Vector3 across = Vector3::Zero();
  double size = 0;
};

BorneAcross borne_across(const machine::Model& model, int body) {
  BorneAcross all;
  for (const machine::Load& load : model.loads) {
    if (load.at.body != body || load.tightens) continue;
    Vector3 left = load.force;
    for (const Vector3& way : ways_of(model.bodies[body], load.at.at)) left -= way.dot(left) * way;
    all.across += left;
    all.size += load.force.norm();
  }
  return all;
}

/// Whether its freedoms are those that its ropes leave it, and not a drive, a beam or a screw bears what pulls there.
bool hangs_free(const machine::Model& model, int i) {
  const machine::Body& body = model.bodies[i];
  return !body.free.empty() && body.driven.empty() && !body.beam && !body.of_rope && !model.is_on_screw(i);
}

}  // namespace

std::vector<LoadAcross> load_across_warnings(const machine::Model& model) {
  std::vector<LoadAcross> all;
  for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) {
    if (!hangs_free(model, i)) continue;
    const BorneAcross borne = borne_across(model, i);
    const double share = borne.size > 0 ? borne.across.norm() / borne.size : 0;
    if (share < of_load) continue;
    // rails bear what presses on them, and the rest moves the body along them
    const bool whole = share > 1 - of_load;
    const bool guided = model.bodies[i].free.size() == 1 && !whole;
    all.push_back({.text = fmt::format("'{}' bears {} by itself, [{:.4g}, {:.4g}, {:.4g}] kN: it cannot move that way, "
                                       "and no rope feels it; z points up; say what is 'free' where the ropes have to "
                                       "hold the body",
                                       model.bodies[i].name, whole ? "its load" : "a part of its load",
                                       borne.across.x() / 1e3, borne.across.y() / 1e3, borne.across.z() / 1e3),
                   .unsafe = !guided});
  }
  return all;
}

std::vector<std::string> rope_beside_beam_warnings(const machine::Model& model) {
  std::vector<std::string> all;
  std::set<std::string> told;
  for (const machine::Beam& beam : model.beams) {
    const auto own = upright(model, beam);
    if (!own) continue;
    for (const machine::Reeving& rope : model.reevings) {
      for (const machine::Node& node : rope.nodes) {
        if (node.at.body != machine::ground || !own->has(node) || !told.insert(node.name).second) continue;
        all.push_back(
            fmt::format("'{}' holds '{}' as a fixed point of the ground, where '{}' stands: the beam feels nothing of "
                        "the rope; name a place of the beam ('{}.top', or 'body: {}')",
                        node.name, rope.name, beam.name, beam.name, beam.name));
      }
    }
  }
  return all;
}

std::vector<std::string> fixed_guy_warnings(const machine::Model& model, std::size_t first) {
  const auto is_fixed = [&](const machine::Node& end) {
    return end.at.body == machine::ground || machine::stands_fast(model.bodies[end.at.body]);
  };
  std::vector<std::string> all;
  for (std::size_t i = first; i < model.reevings.size(); ++i) {
    const machine::Reeving& guy = model.reevings[i];
    if (!is_fixed(guy.nodes.front()) || !is_fixed(guy.nodes.back())) continue;
    all.push_back(
        fmt::format("guy '{}' ends at fixed points, '{}' and '{}': it feels no load of the machine; say what "
                    "is 'free' of the body that it holds",
                    guy.name, guy.nodes.front().name, guy.nodes.back().name));
  }
  return all;
}

std::vector<std::string> fixed_load_warnings(const machine::Model& model, const Display& display) {
  Array<Vector3> sums(model.bodies.size(), Vector3::Zero());
  for (const machine::Load& load : model.loads) sums[load.at.body] += load.force;
  std::vector<std::string> all;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const machine::Body& body = model.bodies[i];
    if (!machine::stands_fast(body) || model.is_on_screw(static_cast<int>(i))) continue;
    if (body.mass > 0 && hangs(model, static_cast<int>(i))) {
      all.push_back(
          fmt::format("'{}' cannot move, and hangs on ropes that do not feel its mass of {}: say what is 'free' of it",
                      body.name, display.brief(body.mass, si::kg)));
    }
    if (sums[i].norm() == 0) continue;
    all.push_back(
        fmt::format("'{}' cannot move, and bears its load of {} by itself: no rope feels it; say what is 'free' "
                    "where the ropes have to hold the body",
                    body.name, display.brief(sums[i].norm(), si::N)));
  }
  return all;
}

}  // namespace taut::results
