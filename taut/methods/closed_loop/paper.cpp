#include "taut/methods/closed_loop/paper.hpp"

namespace taut::closed_loop {

template <class T>
void resolve_force(const Case<T>& c, Sheet<T>& s, Paper<T>& p) {
  s.section("The gathering force, resolved along the chord and the vertical");
  p.K = s.eq("2", "K", si::N, c.S * c.sin_g / c.cos_a);
  const T P = c.S * (c.cos_g + c.sin_g * c.m);
  p.P = s.eq("3", "P", si::N, c.has_weight ? P + c.W_c : P);
}

namespace {

template <class T>
void load_of_upper_branch(const Case<T>& c, Sheet<T>& s, Paper<T>& p) {
  s.section("Load that the upper branch carries");
  const T one_eta = 1.0 + c.eta;
  const T first = c.eta * (p.P * c.x - p.K * c.f * c.cos_a) / (c.x * one_eta);
  // (4) is the first term of (1) at midspan, with P and K put in; the carriage's weight does not fit its shape.
  p.P_b_no_weight = c.midspan && !c.has_weight && value(c.sin_g) > 0
                        ? s.eq("4", "P_b0", si::N,
                               c.S * c.sin_g * c.eta / (c.l * one_eta) * (c.l * (c.cos_g / c.sin_g + c.m) - 2.0 * c.f))
                        : s.eq("1", "P_b0", si::N, first);
  p.P_b = s.eq("1", "P_b", si::N,
               first + (c.x * (c.q_T - c.q_b) * c.eta - c.q_b * c.l * (1.0 - c.eta)) / (2.0 * c.cos_a * one_eta));
}

template <class T>
void midspan_ends(const Case<T>& c, Sheet<T>& s, Paper<T>& p) {
  const T cos2 = square(c.cos_a);
  p.T_up = s.eq("7", "T_up", si::N,
                (c.q_b * c.l * (c.l + 2.0 * c.f * c.sin_2a) + 2.0 * p.P_b * (c.l + c.f * c.sin_2a) * c.cos_a) /
                    (8.0 * c.f * cos2));
  // Uphill A is the upper support: the signs of (9) follow it.
  const auto toward_A = [&](double times) {
    const T rise = times * c.f * c.sin_2a;
    return c.downhill ? c.l - rise : c.l + rise;
  };
  const T load = s.eq("9*", "B_9", si::N_m, 4.0 * (p.P - p.P_b) * c.l * c.cos_a + 8.0 * p.K * c.f * cos2);
  const T weight = s.eq("9*", "Q_9", si::N, c.q_b * toward_A(1) + c.q_T * toward_A(3));
  p.T_lA = s.eq("9*", "T_lA_paper", si::N, (toward_A(1) * load + square(c.l) * weight) / (16.0 * c.l * c.f * cos2));
}

/// The same first order in the end slope for any x: T = H/cos(alpha) + the slope's share of the end reaction.
template <class T>
void ends_at_any_place(const Case<T>& c, Sheet<T>& s, Paper<T>& p) {
  const T reach = c.downhill ? c.x : c.y;
  const T V_u = s.eq("7*", "V_u", si::N, p.P_b * reach / c.l + c.w_b * c.l / 2.0);
  p.T_up = s.eq("7*", "T_up", si::N, p.T_b + c.sin_a * V_u);
  const T V_lA = s.eq("9*", "V_lA", si::N, p.T_n * c.cos_a * c.f / c.x + c.w_T * c.x / 2.0);
  p.T_lA = s.eq("9*", "T_lA_paper", si::N, c.downhill ? p.T_n - c.sin_a * V_lA : p.T_n + c.sin_a * V_lA);
}

}  // namespace

template <class T>
void paper_tensions(const Case<T>& c, Sheet<T>& s, Paper<T>& p) {
  load_of_upper_branch(c, s, p);
  s.section("Tensions by the paper's formulas (roller force taken as vertical)");
  p.T_b = c.midspan
              ? s.eq("5", "T_b", si::N, c.l * c.l / (8.0 * c.f * c.cos_a) * (c.q_b / c.cos_a + 2.0 * p.P_b / c.l))
              : s.eq("11", "T_b", si::N, c.x * c.y / (2.0 * c.f * c.cos_a) * (2.0 * p.P_b / c.l + c.q_b / c.cos_a));
  p.T_n = s.eq("6*", "T_n", si::N, p.T_b / c.eta + p.K);
  if (c.midspan) {
    midspan_ends(c, s, p);
  } else {
    s.note("(5), (7) and (9) hold with the load at midspan only; here their general form is used.");
    ends_at_any_place(c, s, p);
  }
}

Printed as_printed(const Case<double>& c, const Paper<double>& p) {
  Printed out;
  out.P_b_4 = c.S * c.eta / (c.l * (1 + c.eta)) * (c.l * (c.cos_g + c.sin_g * c.m) - 2 * c.l * c.sin_g);
  out.T_n = p.T_b + c.S * c.cos_g / c.cos_a;
  const double cos2 = c.cos_a * c.cos_a;
  const double tilt = c.downhill ? -c.f * c.sin_2a : c.f * c.sin_2a;
  out.T_lA = ((c.l + tilt) * ((p.P - p.P_b) * c.l + 2 * p.K * c.f * cos2) +
              c.l * c.l * (c.q_b * (c.l + tilt) + c.q_T * (c.l + 3 * tilt))) /
             (16 * c.l * c.f * cos2);
  return out;
}

template void resolve_force(const Case<double>&, Sheet<double>&, Paper<double>&);
template void resolve_force(const Case<Num>&, Sheet<Num>&, Paper<Num>&);
template void paper_tensions(const Case<double>&, Sheet<double>&, Paper<double>&);
template void paper_tensions(const Case<Num>&, Sheet<Num>&, Paper<Num>&);

}  // namespace taut::closed_loop
