#include "taut/methods/mast_section/position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/units/display.hpp"

namespace taut::mast_section {

// A hair wider than the words, so that "85 deg" passes however it was turned into radians.
const double least_branch_angle = -60 * std::numbers::pi / 180 - 1e-9;
const double largest_branch_angle = 85 * std::numbers::pi / 180 + 1e-9;

namespace {

// For double; Num brings its own along.
using std::abs;
using std::asin;
using std::atan;
using std::atan2;
using std::cos;
using std::exp;
using std::min;
using std::pow;
using std::sin;
using std::sqrt;
using std::tan;

/// What all positions share, as quantities of the sheet.
template <class T>
struct Mast {
  T T_sky, T_main, h_sky, h_main, f, c, sigma, pi, c2, c4;
};

template <class T>
T allowable(const Input& in, Sheet<T>& s) {
  if (in.allowable_stress) return s.given(*in.allowable_stress);
  const T f_y = s.named("f_y", si::Pa, allowable_stress(in) * *in.safety);
  const T n = s.given(*in.safety);
  return s.eq("", "[sigma]", si::Pa, f_y / n, "yield of the thinnest range over the safety");
}

template <class T>
Mast<T> mast_of(const Input& in, Sheet<T>& s) {
  s.section("Given");
  const T T_sky = s.given(in.skyline_force);
  const T T_main = s.given(in.mainline_force);
  const T h_sky = s.given(in.skyline_block_height);
  const T h_main = in.mainline_block_height ? s.given(*in.mainline_block_height)
                                            : s.eq("", "h_main", si::m, h_sky, "both blocks at one height");
  const T f = s.given(in.block_friction);
  const T c = s.given(in.tube_ratio);
  const T sigma = allowable(in, s);
  return {T_sky, T_main, h_sky, h_main, f, c, sigma, s.named("pi", si::one, std::numbers::pi), pow(c, 2), pow(c, 4)};
}

/// (10), (11) or the angle as given.
template <class T>
T branch_angle(const Input& in, std::size_t index, Sheet<T>& s, Output& out) {
  if (in.branch_angle) return s.given(*in.branch_angle);
  const Span& span = *in.span;
  s.section("Branch angle from the carriage's position");
  const T l = s.given(span.length);
  const T psi = s.given(span.chord_slope);
  const T w = s.given(span.rope_weight);
  const T Q = s.given(span.load);
  const T H = s.given(span.horizontal_tension);
  const T x = s.given(span.carriage_position.at(index));
  const T f_x = s.eq("11", "f_x", si::m, x * (l - x) / (2 * H) * (w / cos(psi) + 2 * Q / l));
  out.x = value(x);
  out.f_x = value(f_x);
  return s.eq("10", "alpha", si::rad, atan((f_x + x * tan(psi)) / x));
}

template <class T>
T wrap_angle(const Input& in, const Mast<T>& m, const T& alpha, Sheet<T>& s) {
  if (in.wrap == Wrap::paper)
    return s.eq("", "epsilon", si::rad, 2 * m.pi / 3, "Shoshin et al. 2022, 120 deg for any alpha");
  return s.eq("", "epsilon", si::rad, m.pi / 2 + alpha, "geometry of figure 5 of Shoshin et al. 2022");
}

/// Names of one rope's quantities.
struct RopeNames {
  const char* equation;
  const char* F_span;
  const char* R;
  const char* gamma;
};
constexpr RopeNames skyline{.equation = "5", .F_span = "F_span_sky", .R = "R_sky", .gamma = "gamma_sky"};
constexpr RopeNames mainline{.equation = "6", .F_span = "F_span_main", .R = "R_main", .gamma = "gamma_main"};

template <class T>
struct Block {
  T F_span, R, gamma;
};

/// Of the branch, of the wrap on a block, and between the rope's two sides there.
template <class T>
struct Angles {
  T alpha, epsilon, beta;
};

/// (1)-(9): the resultant on one block.
template <class T>
Block<T> block(const RopeNames& names, const T& T_max, const T& f, const Angles<T>& at, Sheet<T>& s) {
  const T &alpha = at.alpha, &epsilon = at.epsilon;
  const T F_span = s.eq("1", names.F_span, si::N, T_max * exp(-f * epsilon));
  const T R = s.eq(names.equation, names.R, si::N,
                   T_max * sqrt(exp(-2 * f * epsilon) + 1 - 2 * cos(at.beta) * exp(-f * epsilon)));
  const T gamma = s.eq("9*", names.gamma, si::rad, atan2(F_span * sin(alpha) + T_max, F_span * cos(alpha)));
  return {F_span, R, gamma};
}

template <class T>
struct Blocks {
  Block<T> sky, main;
};

template <class T>
struct Loads {
  T N, M;
  Angles<T> at;
  Blocks<T> blocks;
};

/// (1)-(9) for both ropes and figure 7.
template <class T>
Loads<T> loads(const Mast<T>& m, const T& alpha, const T& epsilon, Sheet<T>& s, Output& out) {
  s.section("Resultants on the blocks");
  const T beta = s.eq("7", "beta", si::rad, m.pi / 2 + alpha);
  const Angles<T> angles{alpha, epsilon, beta};
  const Block<T> sky = block(skyline, m.T_sky, m.f, angles, s);
  const T printed = s.eq("9", "gamma_sky_printed", si::rad, asin(min(m.T_sky * sin(beta) / sky.R, T(1.0))) - alpha);
  const Block<T> main = block(mainline, m.T_main, m.f, angles, s);
  s.section("Internal forces at the clamp");
  const char* figure = "Shoshin et al. 2022, figure 7";
  const T Q = s.eq("", "Q", si::N, sky.R * cos(sky.gamma) + main.R * cos(main.gamma), figure);
  const T N = s.eq("", "N", si::N, sky.R * sin(sky.gamma) + main.R * sin(main.gamma), figure);
  const T M = s.eq("", "M", si::N_m, sky.R * m.h_sky * cos(sky.gamma) + main.R * m.h_main * cos(main.gamma), figure);
  out.F_span_sky = value(sky.F_span);
  out.R_sky = value(sky.R);
  out.gamma_sky = value(sky.gamma);
  out.gamma_sky_printed = value(printed);
  out.F_span_main = value(main.F_span);
  out.R_main = value(main.R);
  out.gamma_main = value(main.gamma);
  out.Q = value(Q);
  out.N = value(N);
  out.M = value(M);
  return {N, M, angles, {sky, main}};
}

/// The root of x^3 - p x - q for p >= 0, q > 0 within a few units of the last place, by Newton's method from above
/// (the cubic is convex there), so that the sheet's own search starts on a hair's breadth.
double cubic_root(double p, double q) {
  const double r = std::cbrt(q);
  double x = std::min(std::sqrt(p) + r, r + p / (3 * r));  // both lie above the root
  for (int i = 0; i < 60; ++i) {
    const double next = x - (cube(x) - p * x - q) / (3 * square(x) - p);
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

/// sigma x^3 = n x + m.
struct Cubic {
  double n, m, sigma;
};

/// Solves the cubic, written by `f`, and stores the value.
template <class T, class F>
bool size(const char* no, const char* symbol, F&& f, const Cubic& cubic, Sheet<T>& s, double& out) {
  const double near = cubic_root(cubic.n / cubic.sigma, cubic.m / cubic.sigma);
  std::optional<T> x = s.root(no, symbol, si::m, f, std::nextafter(near, 0), std::nextafter(near, 2 * near));
  for (double hair = 4e-15; !x && hair < 1e-6; hair *= 16) {  // rounding may hide the change of sign that close by
    x = s.root(no, symbol, si::m, f, near * (1 - hair), near * (1 + hair));
  }
  if (x) out = value(*x);
  return x.has_value();
}

/// The table's line for the tube, exact.
template <class T>
bool tube_size(const char* symbol, const Mast<T>& m, const T& N, const T& M, Sheet<T>& s, double& out) {
  // The root's function is stored without allocation when it holds one pointer, hence the struct.
  const struct { T sigma, N, M, pi, c2, c4; } k{m.sigma, N, M, m.pi, m.c2, m.c4};
  const auto f = [&k](const T& D) {
    return k.sigma * cube(D) - 4 * k.N * D / (k.pi * (1 - k.c2)) - 32 * k.M / (k.pi * (1 - k.c4));
  };
  const double pi = value(m.pi);
  const Cubic cubic{4 * value(N) / (pi * (1 - value(k.c2))), 32 * value(M) / (pi * (1 - value(k.c4))), value(m.sigma)};
  return size("table*", symbol, f, cubic, s, out);
}

/// (15), (16) and the table of section kinds, with the table's rounded coefficients beside the exact ones.
template <class T>
bool ideal_sizes(const Mast<T>& m, const Loads<T>& at, Sheet<T>& s, Output& out) {
  const struct { T sigma, N, M, c2, c4; } k{m.sigma, at.N, at.M, m.c2, m.c4};
  const double N = value(at.N), M = value(at.M), sigma = value(m.sigma);
  const auto square_bar = [&k](const T& b) { return k.sigma * cube(b) - k.N * b - 6 * k.M; };
  const auto hollow = [&k](const T& B) { return k.sigma * cube(B) - T(4.0) / 3 * k.N * B - 6.4 * k.M; };
  const auto hollow_printed = [&k](const T& B) { return k.sigma * cube(B) - 1.33 * k.N * B - 6.41 * k.M; };
  const auto tube_printed = [&k](const T& D) {
    return k.sigma * cube(D) - 1.27 * k.N * D / (1 - k.c2) - 10 * k.M / (1 - k.c4);
  };
  s.section("Sizes by N/A + M/W = [sigma]");
  const bool found =
      size("16", "b_square", square_bar, {N, 6 * M, sigma}, s, out.b_square) &&
      size("table", "B_hollow_printed", hollow_printed, {1.33 * N, 6.41 * M, sigma}, s, out.B_hollow_printed) &&
      size("table*", "B_hollow", hollow, {4 * N / 3, 6.4 * M, sigma}, s, out.B_hollow) &&
      size("table", "D_tube_printed", tube_printed, {1.27 * N / (1 - value(k.c2)), 10 * M / (1 - value(k.c4)), sigma},
           s, out.D_tube_printed) &&
      tube_size("D_tube", m, at.N, at.M, s, out.D_tube);
  if (!found) return false;
  const T D = s.named("D_tube", si::m, out.D_tube);
  out.t_tube = value(s.eq("", "t_tube", si::m, D * (1 - m.c) / 2, "wall of the tube"));
  return true;
}

/// What a rope does to the mast: force down on its block, and moment at the clamp.
template <class T>
struct RopeLoad {
  T down, moment;
};

template <class T>
struct RopeStates {
  RopeLoad<T> in, out, rest;
  const RopeLoad<T>& of(RopeState state) const {
    return state == RopeState::hauled_in ? in : state == RopeState::paid_out ? out : rest;
  }
};

/// What each of the ropes does, for the sheet.
struct Pair {
  RopeState skyline, mainline;
  const char* heading;
};
using enum RopeState;
constexpr std::array mixed_pairs{
    Pair{.skyline = hauled_in, .mainline = paid_out, .heading = "Skyline hauled in, mainline paid out under load"},
    Pair{.skyline = paid_out, .mainline = hauled_in, .heading = "Skyline paid out under load, mainline hauled in"}};
constexpr std::array rest_pairs{
    Pair{.skyline = at_rest, .mainline = at_rest, .heading = "Ropes at rest, full force on both sides of the blocks"},
    Pair{.skyline = at_rest, .mainline = hauled_in, .heading = "Skyline at rest, mainline hauled in"},
    Pair{.skyline = hauled_in, .mainline = at_rest, .heading = "Skyline hauled in, mainline at rest"},
    Pair{.skyline = at_rest, .mainline = paid_out, .heading = "Skyline at rest, mainline paid out under load"},
    Pair{.skyline = paid_out, .mainline = at_rest, .heading = "Skyline paid out under load, mainline at rest"}};

/// Names of the quantities of a pair, and its place in the output.
struct PairNames {
  const char *N, *M, *D;
  double Output::*size;
};
constexpr PairNames mixed_names{.N = "N_mixed", .M = "M_mixed", .D = "D_tube_mixed", .size = &Output::D_tube_mixed};
constexpr PairNames rest_names{.N = "N_rest", .M = "M_rest", .D = "D_tube_rest", .size = &Output::D_tube_rest};

template <class T>
struct BothRopes {
  RopeStates<T> skyline, mainline;
};

/// Of several pairs the one that asks for the largest tube.
template <class T, std::size_t n>
bool worst_of(const std::array<Pair, n>& pairs, const PairNames& names, const Mast<T>& m, const BothRopes<T>& ropes,
              Sheet<T>& s, Output& out) {
  const double c2 = value(m.c2), c4 = value(m.c4), k_N = 4 / (std::numbers::pi * (1 - c2) * value(m.sigma)),
               k_M = 32 / (std::numbers::pi * (1 - c4) * value(m.sigma));
  const auto tube_of = [&](const Pair& pair) {
    const RopeLoad<T>&sky = ropes.skyline.of(pair.skyline), &main = ropes.mainline.of(pair.mainline);
    return cubic_root(k_N * std::abs(value(sky.down) + value(main.down)),
                      k_M * (value(sky.moment) + value(main.moment)));
  };
  const Pair& worst = *std::max_element(pairs.begin(), pairs.end(),
                                        [&](const Pair& a, const Pair& b) { return tube_of(a) < tube_of(b); });
  const RopeLoad<T>&sky = ropes.skyline.of(worst.skyline), &main = ropes.mainline.of(worst.mainline);
  s.section(worst.heading);
  const T N = s.eq("2*", names.N, si::N, sky.down + main.down);
  const T M = s.eq("3*", names.M, si::N_m, sky.moment + main.moment);
  return tube_size(names.D, m, abs(N), M, s, out.*names.size);
}

/// What a rope does in each state. `held`: the force on its span side while it is paid out, N; `at_drum`: that on its
/// drum side while it is at rest with `held` on its span side, N.
template <class T>
RopeStates<T> states_of(const Block<T>& in, const T& held, const T& at_drum, const T& height, const Mast<T>& m,
                        const Angles<T>& at) {
  const T bends = held * height * cos(at.alpha);
  return {.in = {.down = in.R * sin(in.gamma), .moment = in.R * height * cos(in.gamma)},
          .out = {.down = held * (sin(at.alpha) + exp(-m.f * at.epsilon)), .moment = bends},
          .rest = {.down = held * sin(at.alpha) + at_drum, .moment = bends}};
}

/// The ropes paid out under load: then the span side carries T_max and the drum side less. At rest the drum side may
/// have T_max too.
template <class T>
bool payout(const Input& in, const Mast<T>& m, const Angles<T>& at, const Blocks<T>& blocks, Sheet<T>& s, Output& out) {
  s.section("The same with the ropes paid out under load");
  T sky = m.T_sky, main = m.T_main;
  if (in.paid_out_force) {
    s.note("The brakes slip at paid_out_force: no rope is paid out under more.");
    const T slips = s.given(*in.paid_out_force);
    sky = s.eq("2*", "T_out_sky", si::N, min(m.T_sky, slips));
    main = s.eq("2*", "T_out_main", si::N, min(m.T_main, slips));
  }
  const T N = s.eq("2*", "N_payout", si::N, (sky + main) * (sin(at.alpha) + exp(-m.f * at.epsilon)));
  const T M = s.eq("3*", "M_payout", si::N_m, (sky * m.h_sky + main * m.h_main) * cos(at.alpha));
  out.N_payout = value(N);
  out.M_payout = value(M);
  // A steeply rising rope can pull the mast up when its drum side is slack: the other fibre governs then.
  if (!tube_size("D_tube_payout", m, abs(N), M, s, out.D_tube_payout)) return false;
  T drum_sky = m.T_sky, drum_main = m.T_main;
  if (in.paid_out_force) {
    s.note("At rest the friction of the block holds the drum side, which has the rope's full force at most.");
    drum_sky = s.eq("2*", "T_rest_sky", si::N, min(m.T_sky, sky * exp(m.f * at.epsilon)));
    drum_main = s.eq("2*", "T_rest_main", si::N, min(m.T_main, main * exp(m.f * at.epsilon)));
  }
  const BothRopes<T> ropes{.skyline = states_of(blocks.sky, sky, drum_sky, m.h_sky, m, at),
                           .mainline = states_of(blocks.main, main, drum_main, m.h_main, m, at)};
  return worst_of(mixed_pairs, mixed_names, m, ropes, s, out) && worst_of(rest_pairs, rest_names, m, ropes, s, out);
}

template <class T>
Outcome out_of_range(const Input& in, const T& alpha, const Sheet<T>& s, const Output& out) {
  const Display& display = s.display();
  std::string where = in.span ? fmt::format(" with the carriage at x = {} (f_x = {})", display.brief(out.x, si::m),
                                            display.brief(out.f_x, si::m))
                              : "";
  return infeasible(
      fmt::format("the branch angle is {}{}; the method holds from {} to {}: change the carriage position, the "
                  "horizontal tension or the chord slope",
                  display.brief(value(alpha), si::rad), where, display.brief(least_branch_angle, si::rad),
                  display.brief(largest_branch_angle, si::rad)));
}

}  // namespace

std::size_t position_count(const Input& in) { return in.span ? in.span->carriage_position.size() : 1; }

double allowable_stress(const Input& in) {
  if (in.allowable_stress) return *in.allowable_stress;
  const auto steel = catalogue::find_steel(in.steel.value_or(""));
  expects(steel.has_value() && in.safety.has_value(), "mast_section takes inputs without complaints");
  return catalogue::yield(*steel) / *in.safety;
}

double worst_tube(const Output& out) {
  return std::fmax(std::fmax(out.D_tube, out.D_tube_payout), std::fmax(out.D_tube_mixed, out.D_tube_rest));
}

template <class T>
Outcome compute_at(const Input& in, std::size_t index, Sheet<T>& s, Output& out) {
  const Mast<T> m = mast_of(in, s);
  out.sigma_allow = value(m.sigma);
  const T alpha = branch_angle(in, index, s, out);
  out.alpha = value(alpha);
  const bool in_range = out.alpha >= least_branch_angle && out.alpha <= largest_branch_angle;
  if (!in_range) return out_of_range(in, alpha, s, out);
  const T epsilon = wrap_angle(in, m, alpha, s);
  out.wrap = value(epsilon);
  const Loads<T> at = loads(m, alpha, epsilon, s, out);
  if (!ideal_sizes(m, at, s, out) || !payout(in, m, at.at, at.blocks, s, out)) {
    return not_converged(
        fmt::format("no section size follows from N = {:.4g} N and M = {:.4g} N m: check the forces "
                    "and the allowable stress {:.4g} Pa",
                    out.N, out.M, out.sigma_allow));
  }
  out.D_tube_worst = worst_tube(out);
  return {};
}

template Outcome compute_at<double>(const Input&, std::size_t, Sheet<double>&, Output&);
template Outcome compute_at<Num>(const Input&, std::size_t, Sheet<Num>&, Output&);

std::vector<Position> sweep(const Input& in) {
  std::vector<Position> all;
  Sheet<double> s;
  for (std::size_t i = 0; i < position_count(in); ++i) {
    Position p{.index = i, .out = {}, .outcome = {}};
    p.outcome = compute_at(in, i, s, p.out);
    all.push_back(std::move(p));
  }
  return all;
}

Governing governing_of(const std::vector<Position>& positions) {
  Governing g;
  std::array<double, sizes.size()> most{};
  most.fill(-1);
  for (const Position& p : positions) {
    if (!p.outcome.ok()) {
      if (most.front() < 0) g.outcome = p.outcome;
      continue;
    }
    g.outcome = {};
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      if (p.out.*sizes[k] > most[k]) most[k] = p.out.*sizes[k], g.of[k] = p.index;
    }
  }
  return g;
}

}  // namespace taut::mast_section
