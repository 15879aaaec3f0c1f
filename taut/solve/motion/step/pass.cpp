#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/values.hpp"

/// The ropes of a step for given places of bodies. The more rope a contact passes on, the less tension is behind it and
/// the more before it: each law by itself is one equation that falls, whose root is enclosed, and going round the
/// contacts comes to the common answer (a system of M-functions: Rheinboldt 1970).
namespace taut::solve::dynamics {
namespace {

constexpr int most_rounds_of_passing = 12;
constexpr int most_passes = 60;

struct PassingRope {
  const Mechanism& m;
  const Scheme& s;
  const Values& before;
  const Work& w;
  Values& now;
};

void pass_rope(const PassingRope& of, std::size_t i, double q, bool stuck) {
  of.now.q[of.m.contacts[i].column] = q;
  of.now.contacts[i].grip = stuck ? Grip::stuck : Grip::equal;
  follow_contact(of.m, of.s, of.before, of.w, i, of.now);
}

/// Rope passed where it goes with the rim.
double pass_with_rim(const PassingRope& of, std::size_t i) {
  const ContactValues& is = of.now.contacts[i];
  const std::size_t c = as_size(of.m.contacts[i].column);
  const auto rolled = [&] { return of.before.contacts[i].slipped + of.w.q_star[c] + of.s.reach * is.roll_rate; };
  double q = rolled();
  // the stretch of the rope that comes decides how much of it the rim takes along
  for (int k = 0; k < 3; ++k) {
    pass_rope(of, i, q, true);
    if (of.m.contacts[i].spin < 0) break;
    q = rolled();
  }
  return q;
}

/// How far a contact is from its bound for slip along the path (`forward`) or against it; falls with the rope passed.
double over_bound(const PassingRope& of, std::size_t i, bool forward) {
  const ContactValues& is = of.now.contacts[i];
  const Pressure p = pressure(of.m, static_cast<int>(i), of.now);
  if (of.m.contacts[i].load) {
    const double asked = is.holds && !forward ? -is.drop : is.drop;
    return p.out - p.in - asked;
  }
  const double ratio = p.in > 0 && p.out > 0 ? is.ratio : 1;
  return forward ? p.out - ratio * p.in : ratio * p.out - p.in;
}

/// The steepest_bound that `over_bound` can fall, N/m.
double steepest_bound(const PassingRope& of, std::size_t i) {
  const Contact& contact = of.m.contacts[i];
  double slope = 0;
  for (const int k : {contact.in, contact.out}) {
    if (k < 0) continue;
    const Line& line = of.m.lines[k];
    slope += line.stiffness * of.now.lines[k].gone * std::max(2.0, 1 + line.damping * of.s.slip_now) /
             some_length(of.now.lines[k]);
  }
  return slope * of.now.contacts[i].ratio;
}

/// The rope passed where `law` changes its sign, next to `from`; on a level at 0 its near end.
template <class Law>
void pass_until(const PassingRope& of, std::size_t i, double from, double at_from, double slope, Law law) {
  const double room = left_in(of.now.lines[at_from > 0 ? of.m.contacts[i].in : of.m.contacts[i].out]);
  const double sign = at_from > 0 ? 1 : -1;
  double low = 0, g_low = std::abs(at_from), step = g_low / slope, high = 0;
  double g_high = g_low;
  for (int k = 0; k < most_passes; ++k) {
    high = std::min(low + step, 0.999 * room);
    pass_rope(of, i, from + sign * high, false);
    g_high = sign * law();
    if (g_high <= 0 || high >= 0.999 * room) break;
    low = high;
    g_low = g_high;
    step *= 4;
  }
  if (g_high > 0) return;  // no more rope there is
  for (int k = 0; k < most_passes && high - low > 1e-15 * std::max(std::abs(from), high) && g_high != 0; ++k) {
    // a chord, held off the ends
    double part = g_low / (g_low - g_high);
    if (k % 3 == 2) part = 0.5;
    const double middle = low + std::clamp(part, 0.01, 0.99) * (high - low);
    pass_rope(of, i, from + sign * middle, false);
    const double g = sign * law();
    (g > 0 ? low : high) = middle;
    (g > 0 ? g_low : g_high) = g;
  }
  pass_rope(of, i, from + sign * high, false);
}

void end_grip(const PassingRope& of, std::size_t i, bool forward) {
  ContactValues& is = of.now.contacts[i];
  const Pressure p = pressure(of.m, static_cast<int>(i), of.now);
  const bool load = of.m.contacts[i].load;
  const bool one = load ? !is.holds || is.drop == 0 : is.log_ratio == 0 || p.in <= 0 || p.out <= 0;
  is.grip = one ? Grip::equal : forward ? Grip::forward : Grip::backward;
}

void pass_at_round(const PassingRope& of, std::size_t i) {
  const Contact& contact = of.m.contacts[i];
  if (!contact.load && std::isinf(of.now.contacts[i].log_ratio)) {
    pass_with_rim(of, i);
    return;
  }
  const double kept =
      of.before.q[contact.column] + (of.s.fresh ? 0 : of.s.h * loose_flow(contact, of.before.contacts[i], of.before));
  const bool held = contact.load && of.now.contacts[i].holds && of.now.contacts[i].drop > 0;
  pass_rope(of, i, kept, false);
  if (!held && loose(contact, of.now)) {
    of.now.contacts[i].grip = Grip::equal;
    return;
  }
  const double stuck = pass_with_rim(of, i);
  const double forward = over_bound(of, i, true);
  if (forward > 0) {
    pass_until(of, i, stuck, forward, steepest_bound(of, i), [&] { return over_bound(of, i, true); });
    end_grip(of, i, true);
    return;
  }
  const double backward = over_bound(of, i, false);
  if (backward < 0) {
    pass_until(of, i, stuck, backward, steepest_bound(of, i), [&] { return over_bound(of, i, false); });
    end_grip(of, i, false);
  }
}

void pass_at_drum(const PassingRope& of, std::size_t i) {
  const Contact& contact = of.m.contacts[i];
  const auto given = given_tension(of.m, contact, of.before, of.now.when, of.now);
  if (!given) {
    pass_with_rim(of, i);
    return;
  }
  const std::size_t line = as_size(contact.in >= 0 ? contact.in : contact.out), end = contact.in >= 0 ? 1 : 0;
  const double sense = contact.in >= 0 ? -1 : 1;
  const auto law = [&] {
    const LineValues& is = of.now.lines[line];
    const double EA = of.m.lines[line].stiffness * is.gone;
    return sense * ((is.T <= 0 ? EA * is.e : is.end_T[end]) - *given);
  };
  const double from = of.now.q[contact.column];
  pass_rope(of, i, from, false);
  const double g = law();
  const Line& rope = of.m.lines[line];
  const double slope = rope.stiffness * std::max(2.0, 1 + rope.damping * of.s.slip_now) / of.now.lines[line].L;
  if (g == 0 || !(rope.stiffness * of.now.lines[line].gone > 0)) return;
  double low = from, high = from, step = std::abs(g) / slope * (g > 0 ? 1 : -1);
  double g_low = g, g_high = g;
  for (int k = 0; k < most_passes && g_high * g > 0; ++k) {
    low = high;
    g_low = g_high;
    high += step;
    step *= 4;
    pass_rope(of, i, high, false);
    if (!(of.now.lines[line].L > 0)) {
      pass_rope(of, i, low, false);
      return;
    }
    g_high = law();
  }
  for (int k = 0; k < most_passes && g_high != 0 && std::abs(high - low) > 1e-15 * std::max(1.0, std::abs(high)); ++k) {
    const double part = k % 3 == 2 ? 0.5 : std::clamp(g_low / (g_low - g_high), 0.01, 0.99);
    const double middle = low + part * (high - low);
    pass_rope(of, i, middle, false);
    const double here = law();
    (here * g > 0 ? low : high) = middle;
    (here * g > 0 ? g_low : g_high) = here;
  }
  pass_rope(of, i, high, false);
}

}  // namespace

bool pass_ropes(const Mechanism& m, const Scheme& s, const Values& before, const Work& w, double tolerance,
                Values& now) {
  const PassingRope of{m, s, before, w, now};
  const std::size_t n = m.contacts.size();
  Array<double> T(m.lines.size());
  for (int round = 0; round < most_rounds_of_passing; ++round) {
    for (std::size_t k = 0; k < m.lines.size(); ++k) T[k] = now.lines[k].T;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = round % 2 == 0 ? k : n - 1 - k;
      const Contact& contact = m.contacts[i];
      if (contact.in < 0 || contact.out < 0) {
        pass_at_drum(of, i);
      } else {
        pass_at_round(of, i);
      }
    }
    double change = 0;
    for (std::size_t k = 0; k < m.lines.size(); ++k) change = std::max(change, std::abs(now.lines[k].T - T[k]));
    if (change <= tolerance) return true;
  }
  return false;
}

}  // namespace taut::solve::dynamics
