#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "taut/analysis/rope_clearance.hpp"
#include "taut/app/machine_beams.hpp"
#include "taut/app/machine_tables.hpp"

namespace taut::app {
namespace {

constexpr double fallen = std::numbers::pi / 3;  ///< rad

using analysis::ContactState;
using analysis::EquilibriumResult;

void add_tensions(const MachineRun& run, Result& r) {
  const auto all = answers_of(run);
  double worst = 0;
  std::string where;
  for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
    const model::Reeving& rope = run.model.reevings[i];
    double T_max = 0;
    std::string when;
    for (const Answer& a : all) {
      if (a.result->ropes[i].T_max <= T_max) continue;
      T_max = a.result->ropes[i].T_max;
      when = a.words;
    }
    if (T_max >= worst) {
      worst = T_max;
      where = fmt::format("{}, {}", rope.name, when);
    }
    const std::string symbol = fmt::format("{}.T_max", rope.name);
    r.values.push_back({symbol, T_max, si::N, symbol, fmt::format("largest tension of {} ({})", rope.name, when), {}});
    if (rope.breaking_force <= 0 || T_max <= 0) continue;
    r.values.push_back({fmt::format("{}.safety_factor", rope.name),
                        rope.breaking_force / T_max,
                        si::one,
                        fmt::format("{}.S", rope.name),
                        fmt::format("breaking force over the largest tension of {}", rope.name),
                        {}});
    r.checks.push_back(make_check(symbol, T_max, Sense::at_most, rope.breaking_force, si::N,
                                  "minimum breaking force of the rope", "user"));
  }
  if (run.model.reevings.empty()) return;
  r.values.insert(r.values.begin(), {"T_max", worst, si::N, "T_max", fmt::format("largest tension ({})", where), {}});
}

void add_clearance(const MachineRun& run, Result& r) {
  double least = std::numeric_limits<double>::infinity();
  double at = 0;
  for (const Answer& answer : answers_of(run)) {
    for (const model::Carriage& car : answer.model->carriages) {
      const Vector3& p = answer.result->state.bodies[static_cast<std::size_t>(car.body)].position;
      const double clearance = p.z() - analysis::ground_height(run.model.terrain, terrain_x(run.model, p));
      if (!(clearance < least)) continue;
      least = clearance;
      at = terrain_x(run.model, p);
    }
  }
  if (!std::isfinite(least)) return;
  r.values.push_back({"clearance_min",
                      least,
                      si::m,
                      "c_min",
                      fmt::format("least height of a carriage over the ground, at x = {:.6g} m", at),
                      {}});
  if (least < 0)
    r.warnings.push_back(fmt::format("a carriage is {:.4g} m below the ground at x = {:.6g} m", -least, at));
}

/// The least height of the ropes over the ground, fixed ends apart.
void add_rope_clearance(const MachineRun& run, Result& r) {
  double least = std::numeric_limits<double>::infinity();
  std::string where;
  for (const Answer& answer : answers_of(run)) {
    for (const auto& span : answer.result->spans) {
      const analysis::RopeClearance own = analysis::rope_clearance(run.model, span);
      if (!(own.height < least)) continue;
      least = own.height;
      const model::Reeving& rope = answer.model->reevings[static_cast<std::size_t>(span.reeving)];
      const auto name = [&](int n) { return rope.nodes[static_cast<std::size_t>(n)].name; };
      where = fmt::format("{} between {} and {} at x = {:.6g} m ({})", rope.name, name(span.from), name(span.to),
                          terrain_x(run.model, own.place), answer.words);
    }
  }
  if (where.empty()) return;
  r.values.push_back({"rope_clearance_min",
                      least,
                      si::m,
                      "c_r_min",
                      fmt::format("least height of a rope over the ground: {}", where),
                      {}});
  if (least < 0) r.warnings.push_back(fmt::format("a rope is {:.4g} m in the ground: {}", -least, where));
}

void add_places(const MachineRun& run, Result& r) {
  const auto first = std::find_if(run.equilibria.begin(), run.equilibria.end(),
                                  [](const EquilibriumRun& one) { return one.result.outcome.ok(); });
  if (first == run.equilibria.end()) return;
  for (std::size_t i = 0; i < run.model.bodies.size(); ++i) {
    const model::Body& body = run.model.bodies[i];
    if (body.free.empty() || body.of_rope || !told(body)) continue;
    const Vector3& p = first->result.state.bodies[i].position;
    const auto add = [&](const char* axis, double value) {
      const std::string name = fmt::format("{}.{}", body.name, axis);
      r.values.push_back({name, value, si::m, name, fmt::format("place of {} ({})", body.name, first->words), {}});
    };
    add("x", p.x());
    add("y", p.y());
    add("z", p.z());
  }
  for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
    const std::string name = fmt::format("{}.unstretched", run.model.reevings[i].name);
    r.values.push_back({name,
                        first->result.ropes[i].unstretched,
                        si::m,
                        name,
                        fmt::format("unstretched length of {} ({})", run.model.reevings[i].name, first->words),
                        {}});
  }
}

/// Tensions at both ends of each rope, of every equilibrium.
void add_ends(const MachineRun& run, Result& r) {
  for (const EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok()) continue;
    for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
      const auto own = [&](const auto& s) { return s.reeving == static_cast<int>(i); };
      const auto first = std::find_if(one.result.spans.begin(), one.result.spans.end(), own);
      const auto last = std::find_if(one.result.spans.rbegin(), one.result.spans.rend(), own);
      const auto add = [&](const char* end, int n, double T) {
        const model::Reeving& rope = one.model.reevings[i];
        const std::string name = fmt::format("{}.{}{}", rope.name, end, one.ending);
        r.values.push_back({name,
                            T,
                            si::N,
                            name,
                            fmt::format("tension of {} at {} ({})", rope.name,
                                        rope.nodes[static_cast<std::size_t>(n)].name, one.words),
                            {}});
      };
      add("T_start", first->from, first->T_from);
      add("T_end", last->to, last->T_to);
    }
  }
}

/// Words for a carriage that has left the span in which its rope's path has it; empty when it is there.
std::string beside_its_span(const model::Model& m, const EquilibriumResult& e, const model::Carriage& car) {
  const auto& nodes = m.reevings[static_cast<std::size_t>(car.reeving)].nodes;
  const auto n = static_cast<std::size_t>(car.node);
  const std::size_t after = n + static_cast<std::size_t>(car.rollers);
  if (n == 0 || after >= nodes.size()) return {};
  const Vector3 before = model::in_ground(e.state, nodes[n - 1].at);
  Vector3 way = model::in_ground(e.state, nodes[after].at) - before;
  way.z() = 0;
  const Vector3& place = e.state.bodies[static_cast<std::size_t>(car.body)].position;
  const double passed = (place - before).dot(way);
  if (way.norm() == 0 || (passed >= 0 && passed <= way.squaredNorm())) return {};
  return fmt::format("carriage {} stands at x = {:.6g} m, not between '{}' and '{}', where its rope's path has it",
                     car.name, place.x(), nodes[n - 1].name, nodes[after].name);
}

/// Angle by which a body is turned from where the deck has it, rad.
double turned_by(const model::Model& m, const EquilibriumResult& e, std::size_t body) {
  const double trace = (e.state.bodies[body].orientation * m.bodies[body].orientation.transpose()).trace();
  return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0));
}

/// Bodies that came to rest far from how they stand in the deck: a tower whose guys do not hold it lies down, which is
/// an equilibrium too.
void warn_of_fallen(const model::Model& m, const EquilibriumResult& e, const std::string& words,
                    std::set<std::string>& told, Result& r) {
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].beam >= 0) continue;
    const double angle = turned_by(m, e, b);
    if (angle <= fallen || !told.insert(m.bodies[b].name + " fallen").second) continue;
    r.warnings.push_back(
        fmt::format("{}: '{}' comes to rest turned by {:.3g} deg from where the deck has it: it falls over, or begins "
                    "far from its place; hold it by more ropes, or put it where it is meant to stand",
                    words, m.bodies[b].name, angle * 180 / std::numbers::pi));
  }
}

void add_warnings(const MachineRun& run, Result& r) {
  std::set<std::string> told;
  for (const auto& [m, e, point, words] : answers_of(run)) {
    warn_of_fallen(*m, *e, words, told, r);
    for (const auto& c : e->contacts) {
      const auto& node = m->reevings[static_cast<std::size_t>(c.reeving)].nodes[static_cast<std::size_t>(c.node)];
      if (c.state != ContactState::pulled && c.state != ContactState::lifted) continue;
      const bool pulled = c.state == ContactState::pulled;
      if (!told.insert(node.name + (pulled ? " pulled" : " lifted")).second) continue;
      if (pulled && node.at.body != model::ground) {
        r.warnings.push_back(
            fmt::format("{}: the rope presses '{}' downwards with {:.4g} kN: it would lift off its rope. Load the "
                        "carriage more, hang "
                        "the load lower or between the rollers, or slacken the rope",
                        words, node.name, c.force.norm() / 1e3));
        continue;
      }
      r.warnings.push_back(
          pulled ? fmt::format("{}: the rope pulls '{}' upwards with {:.4g} kN; it would lift off. Set the support "
                               "higher, slacken the rope, or say 'uplift: hold' where a guard holds it",
                               words, node.name, c.force.z() / 1e3)
                 : fmt::format("{}: the rope has lifted off '{}'", words, node.name));
    }
    for (const model::Carriage& car : m->carriages) {
      const std::string where = beside_its_span(*m, *e, car);
      if (!where.empty() && told.insert(car.name).second) r.warnings.push_back(fmt::format("{}: {}", words, where));
    }
    for (const auto& s : e->spans) {
      if (!s.slack) continue;
      const auto& rope = m->reevings[static_cast<std::size_t>(s.reeving)];
      const std::string name =
          fmt::format("{} between {} and {}", rope.name, rope.nodes[static_cast<std::size_t>(s.from)].name,
                      rope.nodes[static_cast<std::size_t>(s.to)].name);
      if (told.insert(name).second) r.warnings.push_back(fmt::format("{}: {} is slack", words, name));
    }
  }
}

}  // namespace

void add_values(const MachineRun& run, Result& r) {
  if (answers_of(run).empty()) return;
  add_tensions(run, r);
  add_clearance(run, r);
  add_rope_clearance(run, r);
  add_places(run, r);
  add_ends(run, r);
  add_drives(run, r);
  add_warnings(run, r);
}

std::vector<std::string> assumptions_of(const MachineDeck& deck) {
  const model::Machine& m = deck.machine;
  std::vector<std::string> all = {
      "Ropes are elastic catenaries between tangent points, without bending stiffness; weight per unstretched length; "
      "the "
      "rope's weight on a sheave counts as length, not as load.",
      "Statics: losses act against the motion that the analysis names; at rest without loss, with the band between "
      "both "
      "directions where friction decides."};
  for (const auto& car : m.carriages) {
    std::string held =
        car.mainline ? fmt::format("held by {}", *car.mainline) : "held along its track where a place is prescribed";
    all.push_back(
        car.hold == model::description::Hold::clamped
            ? fmt::format("Carriage {}: clamped to {}; tensions before and behind it differ.", car.name, car.rides)
            : fmt::format("Carriage {}: rolls on {} with {} tensions on both sides, {}; a point, its rollers' "
                          "radius and distance not counted.",
                          car.name, car.rides, car.friction > 0 ? "friction between the" : "equal", held));
  }
  for (const auto& drum : m.drums) {
    const bool thin = std::any_of(m.reevings.begin(), m.reevings.end(), [&](const auto& r) {
      const bool on = std::any_of(r.path.begin(), r.path.end(), [&](const auto& e) { return e.drum == drum.name; });
      const auto rope =
          std::find_if(m.ropes.begin(), m.ropes.end(), [&](const auto& one) { return one.name == r.rope; });
      return on && rope != m.ropes.end() && !rope->diameter && !rope->rope;
    });
    if (thin)
      all.push_back(
          fmt::format("Drum {}: its rope's diameter is not known; the rope lies on the core's radius.", drum.name));
  }
  const auto runs = [](const auto& one) { return one.motor && one.motor->speed; };
  if (std::any_of(m.sheaves.begin(), m.sheaves.end(), runs)) {
    all.emplace_back(
        "A rope with a speed carries the centrifugal tension m v^2 where the motion makes it run; supports, contact "
        "laws "
        "and its shape know the tension less that. At rest it stands.");
  }
  if (!m.rope_loads.empty()) {
    all.emplace_back(
        "Forces along a rope act at a share of the unstretched rope of their span; a rate is divided into equal point "
        "forces, each in the middle of its part.");
  }
  if (!m.guys.empty()) {
    all.emplace_back(
        "Guys are put up on the unloaded machine with its bodies held where they are given; then their "
        "lengths are kept.");
  }
  for (std::string& text : beam_assumptions(m)) all.push_back(std::move(text));
  return all;
}

}  // namespace taut::app
