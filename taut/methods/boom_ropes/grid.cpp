#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/methods/boom_ropes/sliding.hpp"

namespace taut::boom_ropes {
namespace {

using std::abs, std::max, std::min;

/// The largest |F_h| of the grid; empty when no position has an equilibrium.
std::optional<std::size_t> governing(const std::vector<SlidingPoint>& grid) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (grid[i].ok() && (!best || abs(grid[i].Fh) > abs(grid[*best].Fh))) best = i;
  }
  return best;
}

struct Extremes {
  double& high;
  double& low;
  void take(double x) const {
    high = std::isnan(high) ? x : max(high, x);
    low = std::isnan(low) ? x : min(low, x);
  }
};

void extremes(Output& out) {
  for (const SlidingPoint& p : out.grid) {
    if (!p.ok()) continue;
    Extremes{.high = out.Fh_max, .low = out.Fh_min}.take(p.Fh);
    Extremes{.high = out.S1_max, .low = out.S1_min}.take(p.S1);
    Extremes{.high = out.S2_max, .low = out.S2_min}.take(p.S2);
  }
}

void name_governing(const SlidingPoint& p, Output& out) {
  out.Fh = p.Fh;
  out.S1 = p.S1;
  out.S2 = p.S2;
  out.governing_angle = p.luffing_angle;
  out.governing_length = p.boom_length;
  out.governing_weight = p.suspended_weight;
}

template <class T>
void warn_of_gaps(const Sliding& q, Sheet<T>& s, const Output& out) {
  for (const SlidingPoint& p : out.grid) {
    if (!p.ok()) s.warn([&] { return fmt::format("No equilibrium at {}: {}.", place(p, s.display()), p.reason); });
    if (p.ok() && p.S1 < q.minimum_tension) {
      s.warn([&] { return fmt::format("The extension rope is slack at {}: raise S10.", place(p, s.display())); });
    }
    if (p.ok() && p.S2 < q.minimum_tension) {
      s.warn([&] { return fmt::format("The retraction rope is slack at {}: raise S20.", place(p, s.display())); });
    }
  }
}

template <class T>
void check_taut(const Sliding& q, Sheet<T>& s, const Output& out) {
  const T least = s.given(q.minimum_tension);
  s.check("extension rope stays taut", s.named("S_1min", si::N, out.S1_min), si::N,
          {Sense::at_least, least, "Reutov 2021: a slack rope jumps off its sheave; least of all sliding positions",
           "user"});
  s.check("retraction rope stays taut", s.named("S_2min", si::N, out.S2_min), si::N,
          {Sense::at_least, least, "Reutov 2021: a slack rope jumps off its sheave; least of all sliding positions",
           "user"});
}

}  // namespace

std::string place(const SlidingPoint& p, const Display& display) {
  return fmt::format("{}, {}, {}", display.quantity(p.boom_length, si::m), display.quantity(p.luffing_angle, si::rad),
                     display.quantity(p.suspended_weight, si::N));
}

template <class T>
Outcome compute_sliding(const Input& in, const Sliding& q, Sheet<T>& s, Output& out) {
  Sheet<double> plain_sheet;
  out.grid.clear();
  for (std::size_t w = 0; w < q.suspended_weight.size(); ++w) {
    for (std::size_t b = 0; b < q.luffing_angle.size(); ++b) {
      for (std::size_t l = 0; l < q.boom_length.size(); ++l) {
        slide(in, q, {.weight = w, .angle = b, .length = l}, plain_sheet, out.grid.emplace_back());
      }
    }
  }
  warn_of_gaps(q, s, out);
  const auto best = governing(out.grid);
  if (!best) {
    return infeasible(out.grid.empty() ? "sliding: boom_length, luffing_angle and suspended_weight need a value each"
                                       : fmt::format("sliding: no position has an equilibrium; at {}: {}",
                                                     place(out.grid.front(), s.display()), out.grid.front().reason));
  }
  out.governing_point = *best;
  const std::size_t lengths = q.boom_length.size();
  const std::size_t angles = q.luffing_angle.size();
  const Position at{.weight = *best / (lengths * angles), .angle = *best / lengths % angles, .length = *best % lengths};
  s.note([&] { return fmt::format("Largest cylinder force in amount: {}.", place(out.grid[*best], s.display())); });
  SlidingPoint p;
  const Outcome outcome = slide(in, q, at, s, p);
  name_governing(p, out);
  extremes(out);
  check_taut(q, s, out);
  return outcome;
}

template Outcome compute_sliding(const Input&, const Sliding&, Sheet<double>&, Output&);
template Outcome compute_sliding(const Input&, const Sliding&, Sheet<Num>&, Output&);

}  // namespace taut::boom_ropes
