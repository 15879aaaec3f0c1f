#include "taut/methods/boom_ropes/boom_ropes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/calc/verdict.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"
#include "taut/methods/boom_ropes/slip.hpp"

namespace taut::boom_ropes {
namespace {

using std::cos, std::max, std::sin;

/// More cases than this are not written out line by line; the two that govern always are.
constexpr std::size_t written_out = 12;

/// "case 2 (rated lift)"; of one without a name "case 2".
std::string case_words(const Input& in, std::size_t i) {
  const std::string& name = in.cases[i].name;
  return name.empty() ? fmt::format("case {}", i + 1) : fmt::format("case {} ({})", i + 1, name);
}

template <class T>
T force(const Input& in, const Case& one, std::string_view symbol, Sheet<T>& s) {
  const T G_3 = s.given(in.section_weight);
  const T f_0 = s.given(in.pad_friction);
  const T zeta = s.given(in.tackle_efficiency);
  const T G_n = s.given(one.suspended_weight);
  const T beta = s.given(one.luffing_angle);
  const T K = s.named("K", si::one, one.falls);
  switch (one.operation) {
    case Operation::lift:
      return s.eq("4", symbol, si::N, -G_n / (K * zeta) - (G_n + G_3) * (sin(beta) - f_0 * cos(beta)));
    case Operation::retract:
      return s.eq("5", symbol, si::N, -G_n * zeta / K + (G_n + G_3) * (-sin(beta) + f_0 * cos(beta)));
    case Operation::extend:
      return s.eq("4*", symbol, si::N, -G_n / (K * zeta) - (G_n + G_3) * (sin(beta) + f_0 * cos(beta)),
                  "as (4), pads pulling back: not printed");
  }
  return T{};
}

template <class T>
struct Shares {
  T lambda_1;
  T lambda_2;
};

template <class T>
Shares<T> shares(const Input& in, Sheet<T>& s, Output& out) {
  s.section("How the ropes share a change of F");
  const T C_1 = s.given(in.extension_stiffness);
  const T C_2 = s.given(in.retraction_stiffness);
  const T lambda_1 = s.eq("2", "lambda_1", si::one, C_1 / (2 * C_1 + C_2));
  const T lambda_2 = s.eq("2", "lambda_2", si::one, C_2 / (2 * C_1 + C_2));
  out.lambda_1 = value(lambda_1);
  out.lambda_2 = value(lambda_2);
  return {lambda_1, lambda_2};
}

template <class T>
struct Span {
  T highest;
  T lowest;
};

/// F of every case; the highest and the lowest are the ones that (3) needs.
template <class T>
Span<T> forces(const Input& in, Sheet<T>& s, Output& out) {
  out.F.resize(in.cases.size());
  for (std::size_t i = 0; i < in.cases.size(); ++i) out.F[i] = force(in, in.cases[i]);
  out.highest_case = static_cast<std::size_t>(std::max_element(out.F.begin(), out.F.end()) - out.F.begin());
  out.lowest_case = static_cast<std::size_t>(std::min_element(out.F.begin(), out.F.end()) - out.F.begin());
  Span<T> span;
  for (std::size_t i = 0; i < in.cases.size(); ++i) {
    const bool governs = i == out.highest_case || i == out.lowest_case;
    if (!governs && (std::is_same_v<T, double> || in.cases.size() > written_out)) continue;
    if constexpr (std::is_same_v<T, double>) {
      (i == out.highest_case ? span.highest : span.lowest) = out.F[i];
      if (i == out.lowest_case) span.lowest = out.F[i];
    } else {
      const std::string& name = in.cases[i].name;
      s.section(name.empty() ? fmt::format("Case {}", i + 1) : fmt::format("Case {}: {}", i + 1, name));
      const T F = force(in, in.cases[i], fmt::format("F_{}", i + 1), s);
      if (i == out.highest_case) span.highest = F;
      if (i == out.lowest_case) span.lowest = F;
    }
  }
  return span;
}

/// F0, the force on section 3 after tensioning, by which of the ropes was tensioned last: its pads hold as much.
template <class T>
struct Tensioned {
  T F_0e;
  T F_0r;

  const T& last(const Input& in) const { return in.tensioned_last == Rope::extension ? F_0e : F_0r; }
};

template <class T>
struct Limits {
  T S10;
  T S20;
};

/// (3) with the F0 that makes each limit largest. Below 0 there is nothing to ask of a rope: tensioning itself is a
/// state with F = F0.
template <class T>
Limits<T> limits(const Span<T>& F, const Tensioned<T>& F_0, const Shares<T>& lambda, std::string_view no,
                 std::string_view mark, Sheet<T>& s) {
  const T none = s.named("0", si::N, 0.0);
  const auto symbol = [&](const char* stem) {
    if constexpr (std::is_same_v<T, double>) {
      return std::string_view{};
    } else {
      return fmt::format("{}{}", stem, mark);
    }
  };
  const T S10 = s.eq(no, symbol("S_10min"), si::N, max((F.highest - F_0.F_0e) * lambda.lambda_1, none));
  const T S20 = s.eq(no, symbol("S_20min"), si::N, max((F_0.F_0r - F.lowest) * lambda.lambda_2, none));
  return {S10, S20};
}

template <class T>
void pretension(const Input& in, const Span<T>& F, const Tensioned<T>& F_0, const Shares<T>& lambda, Sheet<T>& s,
                Output& out) {
  s.section("Least pretension");
  s.note([&] {
    return fmt::format(
        "Largest F: {}; smallest F: {}. Each limit is taken with the F_0 that makes "
        "it larger: F_0e for the extension rope, F_0r for the retraction rope.",
        case_words(in, out.highest_case), case_words(in, out.lowest_case));
  });
  const Limits<T> least = limits(F, F_0, lambda, "3", "", s);
  const T S_10b = s.eq("1", "S_10b", si::N, (least.S20 - F_0.last(in)) / 2);
  out.S10_min = value(least.S10);
  out.S20_min = value(least.S20);
  out.S10_balance = value(S_10b);
}

/// The same with the C1 that the published tensions show: kappa = C2/C1 is the fall of S2 per rise of S1.
template <class T>
void corrected(const Input& in, const Span<T>& F, const Tensioned<T>& F_0, Sheet<T>& s, Output& out) {
  const auto ratio = measured_ratio(in);
  if (!ratio) return;
  s.section("With the stiffness that the tensions of Table 2 show");
  const T kappa = s.named("kappa", si::one, *ratio);
  const T C_2 = s.given(in.retraction_stiffness);
  const T C_1c = s.eq("2*", "C_1c", si::N_per_m.in("MN/m"), C_2 / kappa);
  const T lambda_1 = s.eq("2*", "lambda_1c", si::one, C_1c / (2 * C_1c + C_2));
  const T lambda_2 = s.eq("2*", "lambda_2c", si::one, C_2 / (2 * C_1c + C_2));
  out.C1_corrected = value(C_1c);
  out.lambda_1_corrected = value(lambda_1);
  out.lambda_2_corrected = value(lambda_2);
  if (in.cases.empty()) return;
  const Limits<T> least = limits(F, F_0, Shares<T>{lambda_1, lambda_2}, "3*", "c", s);
  const T S_10bc = s.eq("1", "S_10bc", si::N, (least.S20 - F_0.last(in)) / 2);
  out.S10_min_corrected = value(least.S10);
  out.S20_min_corrected = value(least.S20);
  out.S10_balance_corrected = value(S_10bc);
  if (out.S20_min_corrected > out.S20_min) {
    s.warn([&] {
      const Display& display = s.display();
      return fmt::format(
          "C1 = {} contradicts the ratio of tension changes {:.3g}: the retraction rope needs S20 > {}, not {}. The "
          "smaller value is unsafe: the rope would go slack when {} is lifted.",
          display.brief(in.extension_stiffness, si::N_per_m.in("MN/m")), *ratio,
          display.brief(out.S20_min_corrected, si::N, Rounding::up), display.brief(out.S20_min, si::N),
          case_words(in, out.lowest_case));
    });
  }
}

/// A pretension of both ropes.
template <class T>
struct Pretension {
  T S10;
  T S20;
};

/// What is left of a pretension that the pads don't hold: section 3 slides until they hold `held`, while
/// kappa S1 + S2 stays, as both ropes see the same X.
template <class T>
Pretension<T> settled(const Pretension<T>& set, const T& held, const T& kappa, std::string_view mark, Sheet<T>& s) {
  const auto symbol = [&](const char* stem) { return fmt::format("{}{}", stem, mark); };
  const T S10 = s.eq("1*", symbol("S_10set"), si::N, (kappa * set.S10 + set.S20 - held) / (kappa + 2));
  const T S20 = s.eq("1*", symbol("S_20set"), si::N, 2 * S10 + held);
  return {S10, S20};
}

/// The pair that the corrected stiffness leaves.
Pretension<double> corrected_pair(const Output& out) {
  if (std::isnan(out.S10_set_corrected)) return {.S10 = out.S10_set, .S20 = out.S20_set};
  return {.S10 = out.S10_set_corrected, .S20 = out.S20_set_corrected};
}

/// A pretension and its least, with their symbols.
struct Asked {
  const char* set_symbol;
  const char* least_symbol;
  double set;
  double least;
};

/// The pretension by the printed and by the corrected stiffness, each against its own limit: the worse one counts.
template <class T>
void check_pretension(const char* name, const char* rule, const Asked& printed, const Asked& corrected, Sheet<T>& s) {
  const auto bound = [](const Asked& a) {
    return make_check("", a.set, si::N, {.sense = Sense::at_least, .limit = a.least, .rule = "", .trust = ""});
  };
  const bool by_corrected = !std::isnan(corrected.least) && !worse_state(bound(printed), bound(corrected));
  const Asked& worse = by_corrected ? corrected : printed;
  s.check(name, s.named(worse.set_symbol, si::N, worse.set), si::N,
          {Sense::at_least, s.named(worse.least_symbol, si::N, worse.least), rule, "derived"});
}

/// Of the input or of the sliding sections, which are the same ropes. `calibrated`: where the deck has the other one.
template <class T>
T as_set(const std::optional<double>& own, const std::optional<double>& sliding, const char* symbol, double calibrated,
         Sheet<T>& s) {
  if (own) return s.given(*own);
  return sliding ? s.given(*sliding) : s.named(symbol, si::N, calibrated);
}

/// Pretension as the user set it. The pads hold |F0| <= f0 G3 only: beyond, section 3 slides until they do.
template <class T>
void pretension_as_set(const Input& in, const Tensioned<T>& pads, Sheet<T>& s, Output& out) {
  s.section("The pretension as set");
  const std::optional<double> none;
  const Pretension<T> set{as_set(in.S10, in.sliding ? in.sliding->S10 : none, "S_10", calibrated_S10, s),
                          as_set(in.S20, in.sliding ? in.sliding->S20 : none, "S_20", calibrated_S20, s)};
  const double S_10 = value(set.S10), S_20 = value(set.S20);
  const T F_0 = s.eq("1", "F_0", si::N, set.S20 - 2 * set.S10);
  out.S10_set = S_10;
  out.S20_set = S_20;
  out.F0_set = value(F_0);
  if (F_0 < pads.F_0e || F_0 > pads.F_0r) {
    const T kappa = s.eq("", "kappa_C", si::one, s.given(in.retraction_stiffness) / s.given(in.extension_stiffness));
    const T& held = F_0 < pads.F_0e ? pads.F_0e : pads.F_0r;
    const Pretension<T> left = settled(set, held, kappa, "", s);
    out.S10_set = value(left.S10);
    out.S20_set = value(left.S20);
    out.F0_set = value(held);
    std::string by_printed;
    if (const auto ratio = measured_ratio(in)) {
      const Pretension<T> better = settled(set, held, s.named("kappa", si::one, *ratio), "c", s);
      out.S10_set_corrected = value(better.S10);
      out.S20_set_corrected = value(better.S20);
      by_printed = fmt::format(" (by the printed stiffness {} and {})", s.display().brief(out.S10_set, si::N),
                               s.display().brief(out.S20_set, si::N));
    }
    s.warn([&] {
      const Pretension<double> kept = corrected_pair(out);
      const auto force = [&](double x) { return s.display().brief(x, si::N); };
      return fmt::format(
          "S10 = {} and S20 = {} pull section 3 with {}, but its pads hold only {}: it slides until {} and {} are "
          "left{}. Tension the ropes so that |2 S10 - S20| stays below f0 G3.",
          force(S_10), force(S_20), force(std::abs(S_20 - 2 * S_10)), force(std::abs(out.F0_retraction)),
          force(kept.S10), force(kept.S20), by_printed);
    });
  }
  if (in.cases.empty()) return;
  const Pretension<double> better = corrected_pair(out);
  check_pretension("pretension of the extension rope", "Reutov 2021, (3): the extension rope stays taut in every case",
                   {"S_10", "S_10min", out.S10_set, out.S10_min},
                   {"S_10", "S_10min", better.S10, out.S10_min_corrected}, s);
  check_pretension(
      "pretension of the retraction rope", "Reutov 2021, (3): the retraction rope stays taut in every case",
      {"S_20", "S_20min", out.S20_set, out.S20_min}, {"S_20", "S_20min", better.S20, out.S20_min_corrected}, s);
}

/// Slip angles without ropes and without jamming, over the weights of the retract cases.
void free_slip_angles(const Input& in, Output& out) {
  const Case* light = nullptr;
  const Case* heavy = nullptr;
  for (const Case& c : in.cases) {
    if (c.operation != Operation::retract) continue;
    if (light == nullptr || c.suspended_weight < light->suspended_weight) light = &c;
    if (heavy == nullptr || c.suspended_weight > heavy->suspended_weight) heavy = &c;
  }
  if (light == nullptr) return;
  const auto angle = [&](const Case& c) {
    return free_slip_angle(in.section_weight, c.suspended_weight, in.slip_friction, in.tackle_efficiency, c.falls);
  };
  out.beta1_light = angle(*light);
  out.beta1_heavy = angle(*heavy);
}

}  // namespace

std::optional<double> measured_ratio(const Input& in) {
  if (in.stiffness_ratio) return in.stiffness_ratio;
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * b; };
  if (near(in.extension_stiffness, printed_C1) && near(in.retraction_stiffness, printed_C2)) return table_2_ratio;
  return std::nullopt;
}

bool has_pretension(const Input& in) {
  if (in.S10 && in.S20) return true;
  return !in.cases.empty() && in.sliding && (in.sliding->S10 || in.sliding->S20);
}

double force(const Input& in, const Case& one) {
  Sheet<double> s;
  return force(in, one, "F", s);
}

namespace {

RopeTensions shared(const Pretension<double>& pretension, double change, double F, const Shares<double>& lambda) {
  RopeTensions t{.S1 = pretension.S10 + change * lambda.lambda_1,
                 .S2 = pretension.S20 - change * lambda.lambda_2,
                 .extension_slack = false,
                 .retraction_slack = false};
  // A limit pretension leaves exactly nothing in the governing case: rounding must not make that a slack rope.
  const double nothing = 1e-9 * (std::abs(F) + std::abs(pretension.S10) + std::abs(pretension.S20));
  if (t.S2 < -nothing) return {.S1 = -F / 2, .S2 = 0, .extension_slack = false, .retraction_slack = true};
  if (t.S1 < -nothing) return {.S1 = 0, .S2 = F, .extension_slack = true, .retraction_slack = false};
  t.S1 = std::max(t.S1, 0.0);
  t.S2 = std::max(t.S2, 0.0);
  return t;
}

}  // namespace

RopeTensions tensions(const Output& out, double F) {
  return shared({.S10 = out.S10_set, .S20 = out.S20_set}, out.F0_set - F, F,
                {.lambda_1 = out.lambda_1, .lambda_2 = out.lambda_2});
}

std::optional<RopeTensions> corrected_tensions(const Output& out, double F) {
  if (std::isnan(out.lambda_1_corrected)) return std::nullopt;
  return shared(corrected_pair(out), out.F0_set - F, F,
                {.lambda_1 = out.lambda_1_corrected, .lambda_2 = out.lambda_2_corrected});
}

template <class T>
Outcome compute(const Input& in, Sheet<T>& s, Output& out) {
  const Shares<T> lambda = shares(in, s, out);
  s.section("Force on section 3 after tensioning, boom horizontal");
  const T G_3 = s.given(in.section_weight);
  const T f_0 = s.given(in.pad_friction);
  const T F_0e = s.eq("2", "F_0e", si::N, -f_0 * G_3);
  const T F_0r = s.eq("2", "F_0r", si::N, f_0 * G_3);
  const Tensioned<T> F_0{F_0e, F_0r};
  out.F0_extension = value(F_0e);
  out.F0_retraction = value(F_0r);
  Span<T> F;
  if (!in.cases.empty()) {
    F = forces(in, s, out);
    pretension(in, F, F_0, lambda, s, out);
  }
  corrected(in, F, F_0, s, out);
  if (has_pretension(in)) {
    pretension_as_set(in, F_0, s, out);
  } else if (!in.cases.empty()) {
    out.F0_set = in.tensioned_last == Rope::extension ? out.F0_extension : out.F0_retraction;
    // the larger of printed and corrected: neither rope goes slack by either
    out.S10_set =
        std::fmax(std::max(out.S10_balance, out.S10_min), std::fmax(out.S10_balance_corrected, out.S10_min_corrected));
    out.S20_set = 2 * out.S10_set + out.F0_set;
  }
  free_slip_angles(in, out);
  if (!in.sliding) return {};
  return compute_sliding(in, *in.sliding, s, out);
}

template Outcome compute(const Input&, Sheet<double>&, Output&);
template Outcome compute(const Input&, Sheet<Num>&, Output&);

Outcome solve(const Input& in, Output& out) {
  Sheet<double> s;
  return compute(in, s, out);
}

}  // namespace taut::boom_ropes
