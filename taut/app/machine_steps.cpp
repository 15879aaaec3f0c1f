#include "taut/app/machine_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "taut/calc/sheet.hpp"
#include "taut/results/machine_beams.hpp"
#include "taut/results/machine_tables.hpp"

namespace taut::app {
namespace {

/// The answer with the largest tension.
results::Answer governing(const results::MachineRun& run) {
  results::Answer worst;
  std::optional<double> T_max;
  for (const results::Answer& one : results::answers_of(run)) {
    for (const auto& rope : one.result->ropes) {
      if (T_max && rope.T_max <= *T_max) continue;
      T_max = rope.T_max;
      worst = one;
    }
  }
  return worst;
}

/// How well a written law has to give the tension back that the solver found; a contact that is not at its law's limit
/// (at rest, or lifted) is not written.
constexpr double same_tension = 1e-6;

/// The elastic catenary of one span from its start on.
void write_span(Sheet<Num>& s, const machine::Reeving& rope, const solve::BranchResult& branch) {
  const std::string catenary = "Irvine 1981, elastic catenary";
  // a running rope's shape knows the tension less c (docs/theory/drives.md)
  const double above = branch.T_from - std::hypot(branch.H, branch.V_from);
  const double running = above > same_tension * branch.T_from ? above : 0;
  // at the rope's temperature, as it runs
  const double length = branch.unstretched * (1 + rope.thermal_strain) * (1 + running / rope.stiffness);
  const Num L = s.named("L", si::m, length);
  const Num EA = s.named("EA", si::N, rope.stiffness + running);
  const Num H = s.named("H", si::N, branch.H);
  const Num V_0 = s.named("V_0", si::N, branch.V_from);
  const Num w = s.named("w", si::N_per_m, rope.weight / (1 + rope.thermal_strain) / (1 + running / rope.stiffness));
  const Num V_1 = s.eq("", "V_1", si::N, V_0 + w * L, catenary);
  const Num T_0 = s.eq("", "T_0", si::N, sqrt(square(H) + square(V_0)), catenary);
  const Num T_1 = s.eq("", "T_1", si::N, sqrt(square(H) + square(V_1)), catenary);
  if (rope.weight > 0 && branch.H > 0 && std::isfinite(rope.stiffness)) {
    s.eq("", "x", si::m, H * L / EA + H / w * (asinh(V_1 / H) - asinh(V_0 / H)), catenary);
    s.eq("", "z", si::m, (V_0 * L + w * square(L) / 2) / EA + (T_1 - T_0) / w, catenary);
  }
  if (rope.breaking_force > 0) {
    const Num F_min = s.named("F_min", si::N, rope.breaking_force);
    if (running > 0) {
      const Num m = s.named("m", si::kg_per_m, rope.mass), v = s.named("v", si::m_per_s, rope.speed);
      const Num c = s.eq("", "c", si::N, m * square(v), "centrifugal tension of the running rope, in addition");
      s.eq("", "S", si::one, F_min / (max(T_0, T_1) + c), "breaking force over the largest tension");
    } else {
      s.eq("", "S", si::one, F_min / max(T_0, T_1), "breaking force over the largest tension");
    }
  }
}

/// The factor by which a contact at its limit raises the tension.
double limit_of(const machine::Node& node, double wrap) {
  const double bearing = node.law.efficiency > 0 ? 1 / node.law.efficiency : HUGE_VAL;
  return std::min(bearing, std::exp(node.law.friction * wrap));
}

bool at_limit(const machine::Node& node, const solve::ContactResult& c) {
  const double low = std::min(c.T_in, c.T_out);
  const double high = std::max(c.T_in, c.T_out);
  const double limit = limit_of(node, c.turning);
  return node.kind == machine::NodeKind::contact && low > 0 && limit > 1 &&
         std::abs(high - low * limit) <= same_tension * high;
}

/// The tension law at such a contact, from the smaller tension to the larger one.
void write_contact(Sheet<Num>& s, const machine::Node& node, const solve::ContactResult& c) {
  const bool grows = c.T_out >= c.T_in;
  const Num low = s.named(grows ? "T_in" : "T_out", si::N, grows ? c.T_in : c.T_out);
  const std::string high = grows ? "T_out" : "T_in";
  if (node.law.efficiency > 0 && limit_of(node, c.turning) >= 1 / node.law.efficiency) {
    const Num eta = s.named("eta", si::one, node.law.efficiency);
    s.eq("", high, si::N, low / eta, fmt::format("{}: efficiency of the sheave", node.name));
  } else {
    const Num mu = s.named("mu", si::one, node.law.friction);
    const Num theta = s.named("theta", si::rad, c.turning);
    s.eq("", high, si::N, low * exp(mu * theta), fmt::format("{}: Euler-Eytelwein", node.name));
  }
}

/// The span with the largest tension, and the contacts at their limits.
void write_ropes(Sheet<Num>& s, const results::Answer& state) {
  const solve::EquilibriumResult& e = *state.result;
  const auto worst =
      std::max_element(e.ropes.begin(), e.ropes.end(), [](const auto& a, const auto& b) { return a.T_max < b.T_max; });
  const solve::BranchResult& branch = e.branches[worst->branch];
  const machine::Reeving& rope = state.model->reevings[branch.reeving];
  const auto name = [&](int n) { return rope.nodes[n].name; };
  s.section(fmt::format("The span with the largest tension: {} from {} to {} ({})", rope.name, name(branch.from),
                        name(branch.to), state.words));
  write_span(s, rope, branch);
  std::set<std::string> written;
  for (const auto& c : e.contacts) {
    const machine::Reeving& own = state.model->reevings[c.reeving];
    const machine::Node& node = own.nodes[c.node];
    if (!at_limit(node, c) || !written.insert(node.name).second) continue;
    if (written.size() == 1) s.section(fmt::format("Losses where a rope runs over something ({})", state.words));
    write_contact(s, node, c);
  }
}

}  // namespace

void add_steps(const MachineDeck& deck, const results::MachineRun& run, Result& r) {
  Sheet<Num> s("statics", MachineDeck::describe(), &deck);
  const results::Answer state = governing(run);
  if (state.result != nullptr) write_ropes(s, state);
  results::write_beams(s, run);
  s.move_to(r);
}

}  // namespace taut::app
