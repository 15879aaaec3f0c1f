#include "taut/results/fixed_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

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

}  // namespace

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

std::vector<std::string> fixed_load_warnings(const machine::Model& model) {
  Array<Vector3> sums(model.bodies.size(), Vector3::Zero());
  for (const machine::Load& load : model.loads) sums[load.at.body] += load.force;
  std::vector<std::string> all;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const machine::Body& body = model.bodies[i];
    if (!machine::stands_fast(body) || model.is_on_screw(static_cast<int>(i))) continue;
    if (body.mass > 0 && hangs(model, static_cast<int>(i))) {
      all.push_back(fmt::format(
          "'{}' cannot move, and hangs on ropes that do not feel its mass of {:.4g} kg: say what is 'free' of it",
          body.name, body.mass));
    }
    if (sums[i].norm() == 0) continue;
    all.push_back(
        fmt::format("'{}' cannot move, and bears its load of {:.4g} kN by itself: no rope feels it; say what is 'free' "
                    "where the ropes have to hold the body",
                    body.name, sums[i].norm() / 1e3));
  }
  return all;
}

}  // namespace taut::results
