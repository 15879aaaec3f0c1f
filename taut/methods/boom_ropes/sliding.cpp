#include "taut/methods/boom_ropes/sliding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/methods/boom_ropes/piecewise.hpp"

namespace taut::boom_ropes {
namespace {

using std::abs, std::cos, std::max, std::min, std::sin;

constexpr std::string_view model = "sliding model";

/// Everything at one position that does not depend on the unknowns.
template <class T>
struct Setting {
  T beta, G_n, W, S_k, f, d;
  T s;         ///< travel of each section
  T a, A;      ///< overlaps of sections 2-3 and 1-2
  T r_1, r_2;  ///< tension of the anchor branch over that of the branch at section 3
  T m_1, m_2;  ///< length-weighted mean tension of a rope over its tension at section 3
  T zero;
};

/// The friction-free direction of the section: +1 outward, -1 inward. Lifting pushes section 3 in.
double direction(Operation o) { return o == Operation::extend ? 1 : -1; }

std::string misfit(const Sliding& q, double travel) {
  if (travel < 0 || travel > q.stroke) {
    return fmt::format("the boom length is outside {:.6g} ... {:.6g} m", q.retracted_length,
                       q.retracted_length + 2 * q.stroke);
  }
  if (!(q.overlap_23 - travel > 0)) return "no overlap is left between sections 2 and 3: lengthen overlap_23";
  if (!(q.overlap_12 - travel > 0)) return "no overlap is left between sections 1 and 2: lengthen overlap_12";
  const double branch = q.overlap_23 + equaliser_distance - travel;
  if (!(branch < q.extension_length)) return "the extension rope is shorter than its branch at section 3";
  if (!(q.retraction_length > shortest_branch)) return "the retraction rope is shorter than its shortest branch";
  return {};
}

template <class T>
T mean_over_end(const T& anchor_length, const T& ratio, const T& end_length, const T& length) {
  return (anchor_length * ratio + end_length) / length;
}

Setting<double> plain(const Setting<double>& k) { return k; }
Setting<double> plain(const Setting<Num>& k) {
  return {.beta = k.beta.value(),
          .G_n = k.G_n.value(),
          .W = k.W.value(),
          .S_k = k.S_k.value(),
          .f = k.f.value(),
          .d = k.d.value(),
          .s = k.s.value(),
          .a = k.a.value(),
          .A = k.A.value(),
          .r_1 = k.r_1.value(),
          .r_2 = k.r_2.value(),
          .m_1 = k.m_1.value(),
          .m_2 = k.m_2.value(),
          .zero = k.zero.value()};
}

template <class T>
Setting<T> setting(const Input& in, const Sliding& q, const Position& at, Sheet<T>& s) {
  Setting<T> k;
  k.zero = s.named("0", si::N, 0.0);
  const double d = direction(q.operation);
  k.d = s.named("d", si::one, d);
  k.f = s.given(q.kinetic_friction);
  k.beta = s.given(q.luffing_angle[at.angle]);
  k.G_n = s.given(q.suspended_weight[at.weight]);
  const T L_b = s.given(q.boom_length[at.length]);
  const T K = s.named("K", si::one, falls_of(q));
  const T zeta = s.given(in.tackle_efficiency);
  k.W = s.eq("", "W", si::N, s.given(in.section_weight) + k.G_n, model);
  k.S_k = q.operation == Operation::retract ? s.eq("8", "S_k", si::N, k.G_n * zeta / K)
                                            : s.eq("8", "S_k", si::N, k.G_n / (K * zeta));
  k.s = s.eq("", "s", si::m, (L_b - s.given(q.retracted_length)) / 2, model);
  const T a_23 = s.given(q.overlap_23);
  const T a_12 = s.given(q.overlap_12);
  k.a = s.eq("", "a", si::m, a_23 - k.s, model);
  k.A = s.eq("", "A", si::m, a_12 - k.s, model);
  const T eta_1 = s.given(q.sheave_efficiency_1);
  const T eta_2 = s.given(q.sheave_efficiency_2);
  // The rope runs off section 3 into the anchor branch when the boom extends (extension rope) or retracts (retraction
  // rope); the branch it runs into is the tight one.
  k.r_1 = s.eq("6*", "r_1", si::one, d > 0 ? T(1 / eta_1) : eta_1);
  k.r_2 = s.eq("6*", "r_2", si::one, d > 0 ? eta_2 : T(1 / eta_2));
  const T l_1h = s.given(q.extension_length);
  const T l_2 = s.given(q.retraction_length);
  const T l_13 = s.eq("", "l_13", si::m, a_23 + s.named("e_1", si::m, equaliser_distance) - k.s, model);
  const T l_2a = s.eq("", "l_2a", si::m, min(k.A, l_2 - s.named("e_2", si::m, shortest_branch)), model);
  k.m_1 = s.eq("", "m_1", si::one, mean_over_end<T>(l_1h - l_13, k.r_1, l_13, l_1h), model);
  k.m_2 = s.eq("", "m_2", si::one, mean_over_end<T>(l_2a, k.r_2, l_2 - l_2a, l_2), model);
  return k;
}

/// Section 3 as a function of X.
template <class T>
struct Section3 {
  T S10, S20, C_1, C_2;
  T m_0;  ///< moment about the rear pads of all but the ropes
  T z_1, z_2;
  T V;            ///< weight across the boom
  bool on_axis;   ///< the ropes pull through the pads' axis: pad forces do not depend on X
  T N_f, N_r, R;  ///< on_axis only: pad forces and their friction

  T S1(const Setting<T>& k, const T& X) const { return max((S10 + C_1 * X) / k.m_1, k.zero); }
  T S2(const Setting<T>& k, const T& X) const { return max((S20 - C_2 * X) / k.m_2, k.zero); }
  T front(const Setting<T>& k, const T& S_1, const T& S_2) const {
    return on_axis ? N_f : T((m_0 + 2 * z_1 * S_1 - z_2 * S_2) / k.a);
  }
  /// |N_f| + |N_r| with N_r = V - N_f is the larger of V and |2 N_f - V|: one N_f less in the written line.
  T friction(const Setting<T>& k, const T& S_1, const T& S_2) const {
    return on_axis ? R : T(k.d * k.f * max(V, abs(2 * front(k, S_1, S_2) - V)));
  }
  T balance(const Setting<T>& k, const T& X) const {
    const T S_1 = S1(k, X);
    const T S_2 = S2(k, X);
    return 2 * S_1 - S_2 - k.S_k - k.W * sin(k.beta) - friction(k, S_1, S_2);
  }
};

/// Both calculations speak of the same ropes: what the deck gives for one of them holds for the other.
template <class T>
T pretension(const std::optional<double>& own, const std::optional<double>& of_input, std::string_view symbol,
             double calibrated, Sheet<T>& s) {
  if (own) return s.given(*own);
  return of_input ? s.given(*of_input) : s.named(symbol, si::N, calibrated);
}

template <class T>
Section3<T> section_3(const Input& in, const Sliding& q, const Setting<T>& k, Sheet<T>& s) {
  Section3<T> r{pretension(q.S10, in.S10, "S_10", calibrated_S10, s),
                pretension(q.S20, in.S20, "S_20", calibrated_S20, s),
                s.given(q.extension_stiffness),
                s.given(q.retraction_stiffness),
                T{},
                s.given(q.offset_extension),
                s.given(q.offset_retraction),
                s.eq("", "V", si::N, k.W * cos(k.beta), model),
                q.offset_extension == 0 && q.offset_retraction == 0,
                T{},
                T{},
                T{}};
  const T weights = s.given(in.section_weight) * s.given(q.center_3) + k.G_n * s.given(q.head_distance);
  r.m_0 = s.eq("", "M_30", si::N_m,
               cos(k.beta) * weights - s.given(q.offset_hoist) * k.G_n * sin(k.beta) - s.given(q.offset_lead) * k.S_k +
                   k.d * k.f * (s.given(q.pad_height_3) / 2) * k.W * cos(k.beta),
               model);
  if (r.on_axis) {
    r.N_f = s.eq("", "N_f", si::N, r.m_0 / k.a, model);
    r.N_r = s.eq("", "N_r", si::N, r.V - r.N_f, model);
    r.R = s.eq("", "R", si::N, k.d * k.f * (abs(r.N_f) + abs(r.N_r)), model);
  }
  return r;
}

/// Where the slope of a line through (x0, y0) and (x1, y1) meets 0; nothing when it never does.
void add_zero(std::vector<double>& breaks, double x0, double y0, double x1, double y1) {
  const double x = x0 - y0 * (x1 - x0) / (y1 - y0);
  if (y0 != y1 && std::isfinite(x)) breaks.push_back(x);
}

/// Every X at which the balance of section 3 bends: a rope goes slack, or a pad changes sides. Pad forces are linear
/// between the slack points; a zero taken from a neighbouring stretch is a break too many and does no harm.
std::vector<double> breaks_of(const Section3<double>& r, const Setting<double>& k) {
  std::vector<double> slack = {-r.S10 / r.C_1, r.S20 / r.C_2};
  std::sort(slack.begin(), slack.end());
  std::vector<double> breaks = slack;
  const double step = std::max(1.0, slack[1] - slack[0]);
  const double starts[] = {slack[0] - step, slack[0], slack[1]};
  const double ends[] = {slack[0], slack[1], slack[1] + step};
  const auto front = [&](double X) { return r.front(k, r.S1(k, X), r.S2(k, X)); };
  const double across = r.V;
  for (int i = 0; i < 3; ++i) {
    if (!(starts[i] < ends[i])) continue;
    const double y0 = front(starts[i]);
    const double y1 = front(ends[i]);
    add_zero(breaks, starts[i], y0, ends[i], y1);
    add_zero(breaks, starts[i], across - y0, ends[i], across - y1);
  }
  return breaks;
}

std::string jam(const Crossings& c, const char* what, const char* offset) {
  if (c.count == 1 && c.rising) return {};
  if (c.count > 1)
    return fmt::format("{} jams: {} equilibria, because friction grows with the force; reduce {}", what, c.count,
                       offset);
  return fmt::format("{} jams: its friction grows faster than the force that should move it; reduce {}", what, offset);
}

/// Section 2 as a function of the cylinder force.
template <class T>
struct Section2 {
  T m_0, F_0, across, z_c;

  T front(const Setting<T>& k, const T& F_h) const { return (m_0 + z_c * F_h) / k.A; }
  T balance(const Setting<T>& k, const T& F_h) const {
    const T M_f = front(k, F_h);
    return F_h - F_0 - k.d * k.f * (abs(M_f) + abs(across - M_f));
  }
};

template <class T>
struct Pulls {
  T S_1, S_2, N_f, N_r;
};

template <class T>
Section2<T> section_2(const Sliding& q, const Setting<T>& k, const Pulls<T>& p, Sheet<T>& s) {
  const T G_2 = s.given(q.section2_weight);
  const T p_2 = s.eq("", "p_2", si::m, s.given(q.overlap_23) + s.given(q.gap), model);
  const T y_r = s.eq("", "y_r", si::m, p_2 - k.a, model);
  const T ropes_1 = s.eq("", "R_1", si::N, 2 * (k.r_1 * p.S_1 + p.S_1), model);
  const T ropes_2 = s.eq("", "R_2", si::N, k.r_2 * p.S_2 + p.S_2, model);
  Section2<T> r;
  r.across = s.eq("", "V_2", si::N, (k.W + G_2) * cos(k.beta), model);
  r.z_c = s.given(q.offset_cylinder);
  r.m_0 =
      s.eq("", "M_20", si::N_m,
           G_2 * cos(k.beta) * s.given(q.center_2) + p.N_f * p_2 + p.N_r * y_r -
               k.d * k.f * (s.given(q.pad_height_3) / 2) * k.W * cos(k.beta) - s.given(q.offset_extension) * ropes_1 +
               s.given(q.offset_retraction) * ropes_2 + k.d * k.f * (s.given(q.pad_height_2) / 2) * r.across,
           model);
  r.F_0 = s.eq("", "F_h0", si::N, ropes_1 - ropes_2 + G_2 * sin(k.beta) - k.d * k.f * (abs(p.N_f) + abs(p.N_r)), model);
  return r;
}

/// The cylinder forces at which a pad of section 2 changes sides.
std::vector<double> breaks_of(const Section2<double>& r, const Setting<double>& k) {
  if (r.z_c == 0) return {r.F_0};
  return {-r.m_0 / r.z_c, (r.across * k.A - r.m_0) / r.z_c};
}

template <class T>
void take(const T& S_1, const T& S_2, const T& N_f, const T& N_r, SlidingPoint& out) {
  out.S1 = value(S_1);
  out.S2 = value(S_2);
  out.Nf = value(N_f);
  out.Nr = value(N_r);
}

/// The interval of X with the one equilibrium of section 3 in it, found in double.
Crossings find_X(const Input& in, const Sliding& q, const Position& at) {
  Sheet<double> s;
  const Setting<double> k = setting(in, q, at, s);
  const Section3<double> r = section_3(in, q, k, s);
  return crossings([&](double X) { return r.balance(k, X); }, breaks_of(r, k));
}

template <class T>
Outcome slide_section_2(const Sliding& q, const Setting<T>& k, const Setting<double>& k_plain, const Pulls<T>& p,
                        Sheet<T>& s, SlidingPoint& out) {
  s.section("Section 2 and its cylinder");
  const Section2<T> r = section_2(q, k, p, s);
  const Section2<double> plain{value(r.m_0), value(r.F_0), value(r.across), value(r.z_c)};
  const Crossings c = crossings([&](double F) { return plain.balance(k_plain, F); }, breaks_of(plain, k_plain));
  out.reason = jam(c, "section 2", "offset_cylinder or pad friction, or lengthen overlap_12");
  if (!out.ok()) return infeasible(out.reason);
  const auto F_h = s.root(
      "", "F_h", si::N, [&](const T& F) { return r.balance(k, F); }, c.low, c.high);
  if (!F_h) return not_converged(out.reason = "the cylinder force was bracketed but not found");
  const T M_f = s.eq("", "M_f", si::N, r.front(k, *F_h), model);
  const T M_r = s.eq("", "M_r", si::N, r.across - M_f, model);
  out.Fh = value(*F_h);
  out.Mf = value(M_f);
  out.Mr = value(M_r);
  return {};
}

}  // namespace

double sliding_pretension(const Input& in, const Sliding& q, Rope rope) {
  const bool extension = rope == Rope::extension;
  const std::optional<double>& own = extension ? q.S10 : q.S20;
  const std::optional<double>& of_input = extension ? in.S10 : in.S20;
  return own ? *own : of_input.value_or(extension ? calibrated_S10 : calibrated_S20);
}

int falls_of(const Sliding& q) {
  if (q.falls) return *q.falls;
  return q.operation == Operation::lift ? 8 : 6;
}

template <class T>
Outcome slide(const Input& in, const Sliding& q, const Position& at, Sheet<T>& s, SlidingPoint& out) {
  out = {};
  out.luffing_angle = q.luffing_angle[at.angle];
  out.boom_length = q.boom_length[at.length];
  out.suspended_weight = q.suspended_weight[at.weight];
  out.reason = misfit(q, (out.boom_length - q.retracted_length) / 2);
  if (!out.ok()) return infeasible(out.reason);
  s.section("Section 3 sliding");
  const Setting<T> k = setting(in, q, at, s);
  const Section3<T> r = section_3(in, q, k, s);
  const Crossings c = find_X(in, q, at);
  out.reason = jam(c, "section 3", "offset_extension, offset_retraction or pad friction, or lengthen overlap_23");
  if (!out.ok()) return infeasible(out.reason);
  const auto X = s.root(
      "1", "X", si::m, [&](const T& x) { return r.balance(k, x); }, c.low, c.high);
  if (!X) return not_converged(out.reason = "the rope elongation was bracketed but not found");
  out.X = value(*X);
  const T S_1 = s.eq("2", "S_1", si::N, r.S1(k, *X));
  const T S_2 = s.eq("2", "S_2", si::N, r.S2(k, *X));
  const T N_f = r.on_axis ? r.N_f : s.eq("", "N_f", si::N, r.front(k, S_1, S_2), model);
  const T N_r = r.on_axis ? r.N_r : s.eq("", "N_r", si::N, r.V - N_f, model);
  take(S_1, S_2, N_f, N_r, out);
  return slide_section_2<T>(q, k, plain(k), {S_1, S_2, N_f, N_r}, s, out);
}

template Outcome slide(const Input&, const Sliding&, const Position&, Sheet<double>&, SlidingPoint&);
template Outcome slide(const Input&, const Sliding&, const Position&, Sheet<Num>&, SlidingPoint&);

}  // namespace taut::boom_ropes
