#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "taut/analysis/running_loop.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/roots.hpp"

namespace taut::analysis {
namespace {

constexpr double smallest_share = 1e-4;  // of the span
constexpr double largest_share = 2;
constexpr double stride = 1.12;
constexpr int narrowings = 40;
constexpr double meets = 1e-7;  // of what is given; a sign change that misses it is a jump between two equilibria

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

/// A sag, what is given minus its target there, and the state; not feasible: `ok` is false.
struct Probe {
  double sag = 0;
  double excess = 0;
  bool ok = false;
  LoopState state;
};

using At = std::function<Probe(double sag, const LoopState* near)>;

struct Bracket {
  Probe low, high;
};

bool changes_sign(const Probe& a, const Probe& b) { return a.ok && b.ok && (a.excess < 0) != (b.excess < 0); }

/// Where three neighbours turn back before they reach zero, a pair of roots may hide: narrows the turn by golden
/// section until a sign change shows.
std::vector<Bracket> hidden(const At& at, Probe a, Probe b, Probe c) {
  if (!a.ok || !b.ok || !c.ok || changes_sign(a, b) || changes_sign(b, c)) return {};
  const auto size = [](const Probe& p) { return std::abs(p.excess); };
  if (size(b) >= size(a) || size(b) >= size(c)) return {};
  const Bracket outer{a, c};
  for (int i = 0; i < narrowings; ++i) {
    const bool right = c.sag - b.sag > b.sag - a.sag;
    const double sag = right ? b.sag + 0.381966 * (c.sag - b.sag) : b.sag - 0.381966 * (b.sag - a.sag);
    const Probe p = at(sag, &b.state);
    if (!p.ok) return {};
    if (changes_sign(p, b)) return {{outer.low, p}, {p, outer.high}};
    if (size(p) < size(b)) {
      (right ? a : c) = b;
      b = p;
    } else {
      (right ? c : a) = p;
    }
  }
  return {};
}

std::string quantity(LoopGiven given, double value) {
  return given == LoopGiven::length ? fmt::format("{:.6g} m", value) : fmt::format("{:.4g} kN", value / 1000);
}

Outcome out_of_reach(double x, LoopGiven given, double value, double least, double most, const Outcome& first) {
  if (!(least <= most)) return first;
  if (least <= value && value <= most) {
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
                  what, quantity(given, value), x, quantity(given, least), quantity(given, most), change));
}

/// The root in a bracket; empty when the equilibrium jumps or is lost there.
std::optional<Probe> root_in(const At& at, const Bracket& b, double value) {
  const auto excess = [&](double f) {  // where the equilibrium is lost the root finder may ask for no number
    return std::isfinite(f) ? at(f, &b.low.state).excess : f;
  };
  const auto sag = find_root(excess, b.low.sag, b.high.sag);
  if (!sag || !std::isfinite(*sag)) return std::nullopt;
  Probe p = at(*sag, nullptr);  // from scratch: what everybody finds at this sag
  return p.ok && std::abs(p.excess) <= meets * value ? std::optional(p) : std::nullopt;
}

/// The roots in their order, at most two; notes the range passed over.
struct SagSearch {
  std::vector<Probe> found;
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  Outcome first;  ///< of the smallest sag
};

SagSearch search(const RunningLoop& loop, const At& at, double value, double x) {
  SagSearch s;
  std::vector<Probe> last;  // up to two
  for (double sag = smallest_share * loop.span; sag < largest_share * loop.span; sag *= stride) {
    const bool known = !last.empty() && last.back().ok;
    Probe p = at(sag, known ? &last.back().state : nullptr);
    if (known && !p.ok) {  // a shorter stride first: the case may end here, or only the stride was too long
      const Probe half = at(sag / std::sqrt(stride), &last.back().state);
      if (half.ok) p = at(sag, &half.state);
    }
    if (p.ok) {
      s.least = std::min(s.least, p.excess + value);
      s.most = std::max(s.most, p.excess + value);
    } else if (last.empty()) {
      LoopState unused;
      s.first = solve_loop(loop, {x, sag}, unused);
    } else if (last.back().ok) {
      break;
    }
    std::vector<Bracket> brackets;
    if (!last.empty() && changes_sign(last.back(), p)) brackets = {{last.back(), p}};
    if (last.size() == 2 && brackets.empty()) brackets = hidden(at, last[0], last[1], p);
    for (const Bracket& b : brackets) {
      if (const auto root = root_in(at, b, value)) s.found.push_back(*root);
    }
    if (s.found.size() >= 2) break;
    last.push_back(p);
    if (last.size() > 2) last.erase(last.begin());
  }
  return s;
}

}  // namespace

Outcome find_loop_sag(const RunningLoop& loop, double x, LoopGiven given, double value, LoopSag& found) {
  expects(value > 0, "what is given in place of the sag is positive");
  const At at = [&](double sag, const LoopState* near) {
    Probe p{sag, 0, false, {}};
    p.ok = solve_loop(loop, {x, sag}, p.state, near).ok();
    p.excess = p.ok ? value_of(given, p.state) - value : std::numeric_limits<double>::quiet_NaN();
    return p;
  };
  const SagSearch s = search(loop, at, value, x);
  if (s.found.empty()) return out_of_reach(x, given, value, s.least, s.most, s.first);
  found.sag = s.found[0].sag;
  found.state = s.found[0].state;
  found.second = s.found.size() > 1 ? s.found[1].sag : std::numeric_limits<double>::quiet_NaN();
  return {};
}

}  // namespace taut::analysis
