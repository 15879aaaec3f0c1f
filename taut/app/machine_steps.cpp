#include "taut/app/machine_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "taut/calc/sheet.hpp"
#include "taut/calc/shown.hpp"
#include "taut/results/machine_beams.hpp"
#include "taut/results/machine_tables.hpp"

namespace taut::app {
namespace {

/// One span of a state.
struct ShownSpan {
  results::Answer state;
  const solve::BranchResult* branch = nullptr;
  double T = 0;  ///< the larger of the tensions at its ends, as its curve has them, N

  const machine::Reeving& rope() const { return state.model->reevings[branch->reeving]; }
};

/// The span with the largest tension of all states that can be shown; empty where there is none.
std::optional<ShownSpan> most_tense(const std::vector<results::Answer>& states) {
  std::optional<ShownSpan> most;
  for (const results::Answer& one : states) {
    for (const solve::BranchResult& branch : one.result->branches) {
      const double T = std::max(branch.T_from, branch.T_to);
      if (!most || T > most->T) most = {.state = one, .branch = &branch, .T = T};
    }
  }
  return most;
}

/// A tension, N, and which one it is: "largest tension of hoist (sweep, loads[0].mass = 12000 kg, hoist)".
struct KnownTension {
  double T = 0;
  std::string words;
};

/// The largest tension of one rope, or of all (no name), that the checks or the states have: at rest with the friction
/// of either sense, and in motions.
KnownTension largest_known(const std::vector<results::Answer>& states, const Result& r, const std::string& name) {
  KnownTension most;
  if (const Value* judged = r.find_value(name.empty() ? "T_max" : name + ".T_max")) {
    most = {.T = judged->value, .words = judged->label};
  }
  for (const results::Answer& one : states) {
    for (std::size_t i = 0; i < one.result->ropes.size(); ++i) {
      const std::string& own = one.model->reevings[i].name;
      const double T = one.result->ropes[i].T_max;
      if ((!name.empty() && own != name) || T <= most.T) continue;
      most = {.T = T, .words = fmt::format("largest tension of {} ({})", own, one.words)};
    }
  }
  return most;
}

/// How well a written law has to give the tension back that the solver found; a contact that is not at its law's limit
/// (at rest, or lifted) is not written.
constexpr double same_tension = 1e-6;

/// The elastic catenary of one span from its start on. `strength_words`: what its breaking force is divided by.
void write_span(Sheet<Num>& s, const machine::Reeving& rope, const solve::BranchResult& branch,
                const std::string& strength_words) {
  const std::string catenary = "Irvine 1981, elastic catenary";
  // differences of near numbers would not give the result again by the digits that are printed
  const std::string coordinates = catenary + ", without differences";
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
    s.eq("", "x", si::m, H * L / EA + 2 * H / w * atanh(w * L / (T_0 + T_1)), coordinates);
    s.eq("", "z", si::m, (V_0 + V_1) * L * (1 / (2 * EA) + 1 / (T_0 + T_1)), coordinates);
  }
  if (rope.breaking_force > 0) {
    const Num F_min = s.named("F_min", si::N, rope.breaking_force);
    if (running > 0) {
      const Num m = s.named("m", si::kg_per_m, rope.mass), v = s.named("v", si::m_per_s, rope.speed);
      const Num c = s.eq("", "c", si::N, m * square(v), "centrifugal tension of the running rope, in addition");
      s.eq("", "S", si::one, F_min / (max(T_0, T_1) + c), strength_words);
    } else {
      s.eq("", "S", si::one, F_min / max(T_0, T_1), strength_words);
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

/// "The span with the largest tension" only where none is larger: a state at rest is solved without friction, and bears
/// the friction of either sense; a motion has no span to show.
void write_most_tense(Sheet<Num>& s, const results::MachineRun& run, const std::vector<results::Answer>& states,
                      const ShownSpan& span, const Result& r) {
  const machine::Reeving& rope = span.rope();
  const auto name = [&](int n) { return rope.nodes[n].name; };
  const KnownTension all = largest_known(states, r, ""), own = largest_known(states, r, rope.name);
  const bool is_largest = !shown_below(span.T, all.T);
  s.section(fmt::format("{}: {} from {} to {} ({})",
                        is_largest ? "The span with the largest tension" : "The span shown, not the largest tension",
                        rope.name, name(span.branch->from), name(span.branch->to), span.state.words));
  if (!is_largest) {
    const double with_friction = span.state.result->ropes[span.branch->reeving].T_max;
    const bool by_friction = shown_below(span.T, with_friction) && !shown_below(with_friction, all.T);
    s.note(fmt::format("The {} is {}{}.", all.words, run.display.brief(all.T, si::N),
                       by_friction ? ", with friction of either sense; the span is shown without it" : ""));
  }
  write_span(s, rope, *span.branch,
             shown_below(span.T, own.T)
                 ? fmt::format("breaking force over the tension shown; the largest one of {} is {}", rope.name,
                               run.display.brief(own.T, si::N))
                 : std::string("breaking force over the largest tension"));
}

/// The contacts of a state that are at their limits.
void write_contacts(Sheet<Num>& s, const results::Answer& state) {
  std::set<std::string> written;
  for (const auto& c : state.result->contacts) {
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
  const std::vector<results::Answer> states = results::pictured_of(run);
  if (const auto span = most_tense(states)) {
    write_most_tense(s, run, states, *span, r);
    write_contacts(s, span->state);
  }
  results::write_beams(s, run);
  s.move_to(r);
}

}  // namespace taut::app
