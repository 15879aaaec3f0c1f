#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/roots.hpp"
#include "taut/solve/exact/loop_system.hpp"
#include "taut/solve/exact/running_loop.hpp"

namespace taut::solve {
namespace {

constexpr double smallest_share = 1e-4;  // of the span
constexpr double largest_share = 2;
constexpr double stride = 1.12;
constexpr int narrowings = 40;
constexpr int edge_halvings = 44;
constexpr double beside_edge = 0.01;  ///< of the way from an edge of the feasible sags to the next probe
constexpr double meets = 1e-7;        // of what is given; a sign change that misses it is a jump between two equilibria

double value_of(LoopGiven given, const LoopState& s) {
  switch (given) {
    case LoopGiven::tension_at_A:
      return s.lower_A.T_start;
    case LoopGiven::length:
      return s.loop_length();
    case LoopGiven::tension_at_carriage:
      return s.lower_B.T_start;
  }
  return 0;
}

/// A sag and the equilibrium there, if there is one, with what is given minus its target. The sag is feasible where the
/// roller presses on the upper branch and the ropes are taut.
struct Probe {
  double sag = 0;
  double excess = 0;
  bool exists = false;
  bool ok = false;
  LoopState state;
};

using At = std::function<Probe(double sag, const LoopState* near)>;
/// What everybody finds at a sag, who does not come from another one.
using FromScratch = std::function<Probe(double sag)>;
using Measure = std::function<double(const Probe&)>;

struct Bracket {
  Probe low, high;
};

double excess_of(const Probe& p) { return p.excess; }
double pressure_of(const Probe& p) { return p.state.R_z; }

bool changes_sign(const Measure& m, const Probe& a, const Probe& b) { return (m(a) < 0) != (m(b) < 0); }

/// Where three neighbours turn back before they reach zero, a pair of roots may hide: narrows the turn by golden
/// section to a probe of the other sign.
std::optional<Probe> beyond_turn(const At& at, const Measure& m, Probe a, Probe b, Probe c) {
  if (changes_sign(m, a, b) || changes_sign(m, b, c)) return std::nullopt;
  const auto size = [&](const Probe& p) { return std::abs(m(p)); };
  if (size(b) >= size(a) || size(b) >= size(c)) return std::nullopt;
  for (int i = 0; i < narrowings; ++i) {
    const bool right = c.sag - b.sag > b.sag - a.sag;
    const double sag = right ? b.sag + 0.381966 * (c.sag - b.sag) : b.sag - 0.381966 * (b.sag - a.sag);
    const Probe p = at(sag, &b.state);
    if (!p.exists) return std::nullopt;
    if (changes_sign(m, p, b)) return p;
    if (size(p) < size(b)) {
      (right ? a : c) = b;
      b = p;
    } else {
      (right ? c : a) = p;
    }
  }
  return std::nullopt;
}

/// The last feasible probe on the way from a feasible one to one that is not.
Probe edge_of_feasible(const At& at, Probe inside, const Probe& outside) {
  double beyond = outside.sag;
  for (int i = 0; i < edge_halvings; ++i) {
    const double sag = (inside.sag + beyond) / 2;
    if (sag == inside.sag || sag == beyond) break;
    Probe p = at(sag, &inside.state);
    if (p.ok) {
      inside = std::move(p);
    } else {
      beyond = sag;
    }
  }
  return inside;
}

std::string quantity(LoopGiven given, double value) {
  return given == LoopGiven::length ? fmt::format("{:.6g} m", value) : fmt::format("{:.4g} kN", value / 1000);
}

/// The root in a bracket; empty when the equilibrium jumps or is lost there.
std::optional<Probe> root_in(const At& at, const FromScratch& from_scratch, const Bracket& b, double value) {
  const auto excess = [&](double f) {  // where the equilibrium is lost the root finder may ask for no number
    return std::isfinite(f) ? at(f, &b.low.state).excess : f;
  };
  const auto sag = find_root(excess, b.low.sag, b.high.sag);
  if (!sag || !std::isfinite(*sag)) return std::nullopt;
  Probe p = from_scratch(*sag);
  return p.ok && std::abs(p.excess) <= meets * value ? std::optional(p) : std::nullopt;
}

/// Takes probes in the order of their sags and finds up to two roots among the feasible ones. Feasible sags form
/// intervals; their ends are found too, because a root may lie between an end and the nearest probe.
class SagSearch {
 public:
  SagSearch(At at, FromScratch from_scratch, double value)
      : at_(std::move(at)), from_scratch_(std::move(from_scratch)), value_(value) {}

  void add(Probe p) {
    if (p.exists && (!best_ || p.state.R_z > best_->state.R_z)) best_ = p;
    if (!last_.empty()) join(last_.back(), p);
    if (p.ok) take(p);
    last_.push_back(std::move(p));
    if (last_.size() > 2) last_.erase(last_.begin());
  }
  const Probe* last() const { return last_.empty() ? nullptr : &last_.back(); }
  bool done() const { return found.size() >= 2; }
  /// The sag at which the roller comes closest to pressing; 0 without any equilibrium.
  double best_sag() const { return best_ ? best_->sag : 0; }

  Array<Probe> found;
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  bool jumped = false;  ///< a change of sign was no root

 private:
  /// Ends an interval between two probes, begins one, or finds one that is narrower than their distance.
  void join(const Probe& a, const Probe& p) {
    if (a.ok && !p.ok) {
      end(a, p);
    } else if (!a.ok && p.ok) {
      begin(p, a);
    } else if (!a.ok && last_.size() == 2 && last_[0].exists && a.exists && p.exists && !last_[0].ok) {
      const auto between = beyond_turn(at_, pressure_of, last_[0], a, p);
      if (!between || !between->ok) return;
      begin(*between, last_[0]);
      take(*between);
      end(*between, p);
    }
  }

  /// The edges of an interval, each with a probe beside it: a turn between the edge and the nearest probe shows in
  /// whether it rises or falls there.
  void begin(const Probe& inside, const Probe& outside) {
    Probe edge = edge_of_feasible(at_, inside, outside);
    Probe by = beside(edge, inside);
    take(edge);
    if (by.ok) take(by);
  }
  void end(const Probe& inside, const Probe& outside) {
    Probe edge = edge_of_feasible(at_, inside, outside);
    Probe by = beside(edge, inside);
    if (by.ok) take(by);
    take(edge);
    run_.clear();
  }
  Probe beside(const Probe& edge, const Probe& inside) const {
    return at_(edge.sag + beside_edge * (inside.sag - edge.sag), &edge.state);
  }

  /// The next probe of a feasible interval.
  void take(const Probe& p) {
    if (!run_.empty() && !(p.sag > run_.back().sag)) return;
    least = std::min(least, p.excess + value_);
    most = std::max(most, p.excess + value_);
    if (!run_.empty() && changes_sign(excess_of, run_.back(), p)) {
      keep({.low = run_.back(), .high = p});
    } else if (run_.size() == 2) {
      if (const auto turn = beyond_turn(at_, excess_of, run_[0], run_[1], p); turn && turn->ok) {
        keep({.low = run_[0], .high = *turn});
        keep({.low = *turn, .high = p});
      }
    }
    run_.push_back(p);
    if (run_.size() > 2) run_.erase(run_.begin());
  }

  void keep(const Bracket& b) {
    if (auto root = root_in(at_, from_scratch_, b, value_)) {
      found.push_back(*std::move(root));
    } else {
      jumped = true;
    }
  }

  At at_;
  FromScratch from_scratch_;
  double value_;
  Array<Probe> last_;  ///< up to two
  Array<Probe> run_;   ///< up to two, of the feasible interval
  std::optional<Probe> best_;
};

void search(const RunningLoop& loop, const At& at, SagSearch& s) {
  for (double sag = smallest_share * loop.span; sag < largest_share * loop.span && !s.done(); sag *= stride) {
    const Probe* last = s.last();
    const bool known = last != nullptr && last->exists;
    Probe p = at(sag, known ? &last->state : nullptr);
    if (known && !p.exists) {  // a shorter stride first: the case may end here, or only the stride was too long
      const Probe half = at(sag / std::sqrt(stride), &last->state);
      if (half.exists) p = at(sag, &half.state);
    }
    s.add(std::move(p));
  }
}

Outcome out_of_reach(const RunningLoop& loop, double x, LoopGiven given, double value, const SagSearch& s) {
  if (!(s.least <= s.most)) {
    LoopState unused;
    const Outcome o = solve_loop(loop, {.x = x, .sag = std::max(s.best_sag(), smallest_share * loop.span)}, unused);
    return o.ok() ? not_converged(fmt::format("exact catenaries find no feasible sag at x = {:.4g} m", x)) : o;
  }
  if (s.jumped) {
    return not_converged(
        fmt::format("exact catenaries: {} is passed over in a jump between two equilibria at x = {:.4g} "
                    "m; lessen the sag that it would take, or move the carriage",
                    quantity(given, value), x));
  }
  const char* what = given == LoopGiven::tension_at_A ? "a tension of the traction rope at A of"
                     : given == LoopGiven::length     ? "a loop length of"
                                                      : "a tension of the return rope at the carriage of";
  const char* change = given == LoopGiven::tension_at_A ? "the winch pull"
                       : given == LoopGiven::length     ? "the loop's length"
                                                        : "the gathering force or its angle";
  return infeasible(
      fmt::format("{} {} is not possible at x = {:.4g} m: it lies between {} and {} over all feasible "
                  "sags; change {}",
                  what, quantity(given, value), x, quantity(given, s.least), quantity(given, s.most), change));
}

}  // namespace

Outcome find_loop_sag(const RunningLoop& loop, double x, LoopGiven given, double value, LoopSag& found) {
  expects(value > 0, "what is given in place of the sag is positive");
  const auto measured = [&](Probe p) {
    p.ok = p.exists && is_feasible(p.state);
    p.excess = p.exists ? value_of(given, p.state) - value : std::numeric_limits<double>::quiet_NaN();
    return p;
  };
  const At at = [&](double sag, const LoopState* near) {
    Probe p{.sag = sag, .excess = 0, .exists = false, .ok = false, .state = {}};
    p.exists = reach_loop(loop, {.x = x, .sag = sag}, p.state, near);
    return measured(std::move(p));
  };
  const FromScratch from_scratch = [&](double sag) {
    Probe p{.sag = sag, .excess = 0, .exists = false, .ok = false, .state = {}};
    p.exists = solve_loop(loop, {.x = x, .sag = sag}, p.state).ok();
    return measured(std::move(p));
  };
  SagSearch s(at, from_scratch, value);
  search(loop, at, s);
  if (s.found.empty()) return out_of_reach(loop, x, given, value, s);
  found.sag = s.found[0].sag;
  found.state = s.found[0].state;
  found.second = s.found.size() > 1 ? s.found[1].sag : std::numeric_limits<double>::quiet_NaN();
  return {};
}

}  // namespace taut::solve
