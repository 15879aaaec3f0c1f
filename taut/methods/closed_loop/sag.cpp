#include "taut/methods/closed_loop/sag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/methods/closed_loop/quick.hpp"

namespace taut::closed_loop {
namespace {

constexpr double smallest_sag = 1e-4;  // of the span
constexpr double largest_sag = 2;
constexpr double sag_step = 1.04;

/// The tension that the mode asks about.
double tension_of(const Input& in, const Quick<double>& q) { return in.mode == Mode::winch_pull ? q.T_lA : q.T_lLB; }

double target_of(const Input& in) { return in.mode == Mode::winch_pull ? pull_at_A(in) : in.gathering_force; }

Outcome out_of_reach(const Input& in, const Case<double>& c, double least, double most) {
  const char* what = in.mode == Mode::winch_pull ? "a tension at A of" : "a return rope tension at the carriage of";
  if (!(least <= most)) {
    return infeasible(
        fmt::format("no sag is feasible at x = {}: the roller lifts off or a rope goes slack at each; steepen the "
                    "gathering line or add carriage weight",
                    shown(c.display, c.x, si::m)));
  }
  return infeasible(
      fmt::format("{} {} is not possible at x = {}: it lies between {} and {} over all feasible sags; change {}", what,
                  shown(c.display, target_of(in), si::N), shown(c.display, c.x, si::m), shown(c.display, least, si::N),
                  shown(c.display, most, si::N),
                  in.mode == Mode::winch_pull ? "the winch pull" : "the gathering force or its angle"));
}

}  // namespace

double excess_of(const Input& in, const Case<double>& c, double sag) {
  Case<double> at = c;
  at.f = sag;
  const auto q = quick(at);
  return q ? tension_of(in, *q) - target_of(in) : Output::none;
}

Outcome find_sag(const Input& in, const Case<double>& c, FoundSag& found) {
  const double target = target_of(in);
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  int roots = 0;
  double low = smallest_sag * in.span;
  double e_low = excess_of(in, c, low);
  for (; low < largest_sag * in.span && roots < 2; low *= sag_step) {
    const double e_high = excess_of(in, c, low * sag_step);
    if (std::isfinite(e_low)) {
      least = std::min(least, e_low + target);
      most = std::max(most, e_low + target);
      if (!std::isfinite(e_high)) break;
      if ((e_low < 0) != (e_high < 0)) {
        if (++roots == 1) {
          found.low = low;
          found.high = low * sag_step;
        } else {
          const auto f = find_root([&](double sag) { return excess_of(in, c, sag); }, low, low * sag_step);
          found.second = f.value_or(Output::none);
        }
      }
    }
    e_low = e_high;
  }
  return roots > 0 ? Outcome{} : out_of_reach(in, c, least, most);
}

namespace {

template <class T>
void warn_of_second(double second, const Display* display, Sheet<T>& s) {
  if (!std::isfinite(second)) return;
  s.warn([&] {
    return fmt::format("The same is also reached at the deeper sag of {}; the smaller sag is used.",
                       shown(display, second, si::m));
  });
}

const char* condition_of(const Input& in) {
  if (in.mode == Mode::winch_pull) {
    return in.haul == Haul::in ? "the traction rope is pulled at A with winch_pull * head_efficiency"
                               : "the traction rope is held at A with winch_pull / head_efficiency";
  }
  if (in.mode == Mode::loop_length) return "the whole loop has the unstretched length loop_length";
  return "the return rope is pulled at the carriage with the gathering force S";
}

/// Which of the ropes do not stretch.
template <class T>
void warn_of_no_stretch(bool return_rope, bool traction_rope, Sheet<T>& s) {
  if (!return_rope && !traction_rope) return;
  s.warn([&] {
    const bool both = return_rope && traction_rope;
    const char* const one = return_rope ? "return" : "traction";
    return fmt::format(
        "The sag is found from the loop's length with {} stretch; real ropes sag much more (in the paper's example "
        "13.6 m instead of 10 m). Give {}.",
        both ? "ropes that do not" : fmt::format("a {} rope that does not", one),
        both ? "return_stiffness and traction_stiffness" : fmt::format("{}_stiffness", one));
  });
}

/// The sag by exact catenaries.
template <class T>
Outcome set_exact_sag(const Input& in, const Case<double>& plain, const Engine& engine, Sheet<T>& s, Case<T>& c,
                      Output& out) {
  ExactSag found;
  if (Outcome o = engine.sag(in, plain, found); !o.ok()) return o;
  s.section("Sag");
  if (in.mode == Mode::winch_pull) {
    s.given(*in.winch_pull);
    s.given(in.head_efficiency);
  }
  if (in.mode == Mode::loop_length) s.given(*in.loop_length);
  s.note([&] {
    return fmt::format("f = {}: the smallest sag at which {}, by exact catenaries.",
                       shown(plain.display, found.sag, si::m), condition_of(in));
  });
  if (in.mode == Mode::loop_length) warn_of_no_stretch(std::isinf(plain.EA_b), std::isinf(plain.EA_T), s);
  c.f = s.named("f", si::m, found.sag);
  out.f = found.sag;
  out.f_second = found.second;
  warn_of_second(found.second, plain.display, s);
  return {};
}

}  // namespace

template <class T>
Outcome set_sag(const Input& in, const Case<double>& plain, const Engine& engine, Sheet<T>& s, Case<T>& c,
                Output& out) {
  if (in.mode == Mode::sag) {
    c.f = s.given(*in.sag);
    out.f = value(c.f);
    return {};
  }
  if (engine.sag) return set_exact_sag(in, plain, engine, s, c, out);
  if (in.mode == Mode::loop_length || in.carriage == Carriage::two_section) {
    return infeasible("this mode needs exact catenaries here; without them give the sag (mode: sag)");
  }
  FoundSag found;
  if (Outcome o = find_sag(in, plain, found); !o.ok()) return o;
  const bool by_winch = in.mode == Mode::winch_pull;
  s.section("Sag");
  s.note(
      "The sag is the smallest at which the closed-form tier below gives the tension asked for; exact catenaries would "
      "give a slightly different one.");
  const auto pull = [&] {
    const T W = s.given(*in.winch_pull);
    const T eta_A = s.given(in.head_efficiency);
    return in.haul == Haul::in ? T(W * eta_A) : T(W / eta_A);
  };
  const T target = by_winch ? pull() : c.S;
  const auto gap = [&](const T& sag) {
    Case<double> at = plain;
    at.f = value(sag);
    const auto q = quick(at);
    return s.named(by_winch ? "T_lA" : "T_lLB", si::N, q ? tension_of(in, *q) : Output::none) - target;
  };
  const auto f = s.root("", "f", si::m, gap, found.low, found.high);
  if (!f) {
    return not_converged(fmt::format("the sag is not found between {} and {}: the case is barely feasible there",
                                     shown(c.display, found.low, si::m), shown(c.display, found.high, si::m)));
  }
  c.f = *f;
  out.f = value(c.f);
  out.f_second = found.second;
  warn_of_second(found.second, plain.display, s);
  return {};
}

template Outcome set_sag(const Input&, const Case<double>&, const Engine&, Sheet<double>&, Case<double>&, Output&);
template Outcome set_sag(const Input&, const Case<double>&, const Engine&, Sheet<Num>&, Case<Num>&, Output&);

}  // namespace taut::closed_loop
