#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/values.hpp"

/// A run of rope: lines in a row whose contacts all pass rope on. Each tension in it follows from the next one, so all
/// of its lines are taut or none is: slack is a state of the run. An iteration that took each line by itself would see
/// no stiffness in a slack one, and pass rope to and fro. Where an end of the run has no tension (a broken line, a drum
/// without torque or inertia), the others lose theirs, and what lies loose stays where it is.
namespace taut::solve::dynamics {
namespace {

struct RopeRun {
  Array<int> lines;            ///< along the path
  int begins = -1, ends = -1;  ///< contacts before the first and behind the last of them; -1: an anchor
};

bool passes_on(const Mechanism& m, const Values& now, int c) {
  return c >= 0 && !m.contacts[c].load && now.contacts[c].grip != Grip::stuck;
}

RopeRun run_through(const Mechanism& m, const Values& now, int line) {
  RopeRun run{.lines = {}, .begins = m.lines[line].contact[0]};
  int first = line;
  while (passes_on(m, now, run.begins) && m.contacts[run.begins].in >= 0) {
    first = m.contacts[run.begins].in;
    if (first == line) break;  // all round a closed rope
    run.begins = m.lines[first].contact[0];
  }
  int next = first;
  do {
    run.lines.push_back(next);
    run.ends = m.lines[next].contact[1];
    next = passes_on(m, now, run.ends) ? m.contacts[run.ends].out : -1;
  } while (next >= 0 && next != first);
  return run;
}

/// A slack line of a taut run counts as a spring that may push, by what it is shorter than its branch.
void may_push(const Line& line, bool damped, LineValues& is) {
  constexpr double less_than_none = -std::numeric_limits<double>::min();
  const double EA = (damped ? 2 : 1) * line.stiffness * is.gone;  // the bound of its damper is what it meets
  is.T = std::min(EA * (path_of(line, is) / is.L - 1), less_than_none);
  is.T_e = EA;
  is.T_rate = 0;
  const double hangs = line.weight == 0 ? 0 : std::copysign(most_hung, is.t.z()) * is.T;
  is.end_T = {is.T - hangs, is.T + hangs};
}

/// By how much a contact that slips misses its law, N.
double miss_at(const Mechanism& m, std::size_t i, const Values& now) {
  const ContactValues& is = now.contacts[i];
  const Pressure p = pressure(m.contacts[i], now);
  if (m.contacts[i].load) return std::abs(p.out - p.in - (is.grip == Grip::backward ? -is.drop : is.drop));
  if (is.grip == Grip::forward) return std::abs(p.out - is.ratio * p.in) / is.ratio;
  if (is.grip == Grip::backward) return std::abs(is.ratio * p.out - p.in) / is.ratio;
  return std::abs(p.out - p.in);
}

}  // namespace

void decide_runs(const Mechanism& m, const Values& before, Values& now) {
  const auto slack = [](const LineValues& line) { return !(line.T > 0); };
  if (m.contacts.empty() || std::none_of(now.lines.begin(), now.lines.end(), slack)) return;
  Array<char> seen(m.lines.size(), 0);
  for (std::size_t k = 0; k < m.lines.size(); ++k) {
    if (seen[k] || !slack(now.lines[k])) continue;
    const RopeRun run = run_through(m, now, static_cast<int>(k));
    for (const int i : run.lines) seen[i] = 1;
    if (run.lines.size() < 2) continue;
    bool taut = false, loosens = false;
    for (const int c : {run.begins, run.ends}) {
      if (c < 0) continue;
      const std::optional<double> given = given_tension(m, m.contacts[c], before, now.when, now);
      if (given) (*given > 0 ? taut : loosens) = true;
    }
    for (const int i : run.lines) {
      taut = taut || !slack(now.lines[i]);
      loosens = loosens || now.lines[i].gone == 0;
    }
    if (!taut || loosens) continue;
    for (const int i : run.lines) {
      LineValues& is = now.lines[i];
      if (slack(is) && !sags(m.lines[i], is)) may_push(m.lines[i], m.lines[i].damping > 0, is);
    }
  }
}

bool laws_hold(const Mechanism& m, const Values& now, double share, double floor) {
  double largest = 0;
  for (const LineValues& line : now.lines) largest = std::max(largest, line.T);
  const double allowed = std::max(share * largest, floor);
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const Contact& contact = m.contacts[i];
    const bool slips = contact.in >= 0 && contact.out >= 0 && now.contacts[i].grip != Grip::stuck;
    if (slips && !loose(contact, now) && miss_at(m, i, now) > allowed) return false;
  }
  return true;
}

}  // namespace taut::solve::dynamics
