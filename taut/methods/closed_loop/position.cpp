#include "taut/methods/closed_loop/position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "taut/base/expects.hpp"
#include "taut/calc/shown.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/math/degree.hpp"
#include "taut/methods/closed_loop/quick.hpp"
#include "taut/methods/closed_loop/sag.hpp"
#include "taut/methods/closed_loop/two_section.hpp"

namespace taut::closed_loop {
namespace {

constexpr double tonne_force = 1000 * standard_gravity;
/// Limits of the paper's formulas off midspan and on slopes, and how much too low a printed tension may be unremarked.
constexpr double local_slope_limit = 0.2;
constexpr double slope_limit = 10 * degree;
constexpr double remarked = 0.01;
/// Tensions this close count as equal: at a given winch pull T_lA is the same everywhere.
constexpr double alike_within = 1e-9;

template <class T>
void keep(const Paper<T>& p, Output& out) {
  out.P_b = value(p.P_b);
  out.T_b = value(p.T_b);
  out.T_n = value(p.T_n);
  out.T_up = value(p.T_up);
  out.T_lA_paper = value(p.T_lA);
}

template <class T>
void keep_forces(const Quick<T>& q, Output& out) {
  out.N = value(q.N);
  out.P_v = value(q.P_v);
  out.P_b_closed = value(q.P_b);
  out.phi = std::atan(value(q.m_x));
}

template <class T>
void keep_tensions(const Quick<T>& q, Output& out) {
  out.T_uA = value(q.T_uA);
  out.T_uB = value(q.T_uB);
  out.T_lA = value(q.T_lA);
  out.T_lB = value(q.T_lB);
  out.T_U = value(q.T_U);
  out.T_lLA = value(q.T_lLA);
  out.T_lLB = value(q.T_lLB);
  out.H_1 = value(q.H_1);
  out.H_2 = value(q.H_2);
  out.H_3 = value(q.H_3);
  out.H_4 = value(q.H_4);
  out.T_end_max = std::max({out.T_uA, out.T_uB, out.T_lA, out.T_lB});
}

template <class T>
Outcome no_vertical_load(const Case<T>& c, const Paper<T>& p) {
  return infeasible(
      fmt::format("no vertical load: P = {} by (3), the gathering line pulls the carriage up off the chord (slope {}); "
                  "steepen the line or add carriage weight",
                  shown(c.display, value(p.P), si::N), shown(c.display, value(c.alpha_s), si::rad)));
}

template <class T>
Outcome one_section(const Case<T>& c, const Case<double>& plain, Sheet<T>& s, Paper<T>& p, Output& out) {
  paper_tensions(c, s, p);
  keep(p, out);
  out.P_b_no_weight = value(p.P_b_no_weight);
  Quick<T> q{};
  Outcome o = quick_tensions(c, plain, s, q);
  keep_forces(q, out);
  if (o.ok()) keep_tensions(q, out);
  return o;
}

SectionRule rule_of(const Input& in) {
  return {
      .distance = *in.section_distance, .kind = in.distance_kind, .sag_of = in.sag_of, .position_of = in.position_of};
}

template <class T>
Outcome two_sections(const Input& in, const Case<T>& c, const Case<double>& plain, Sheet<T>& s, Paper<T>& p,
                     Output& out) {
  s.given(*in.section_distance);
  const SectionRule rule = rule_of(in);
  if (const auto printed = solve_as_printed(plain, rule, value(p.P), value(p.K))) {
    out.P_b_printed = printed->P_b;
    out.delta_f_printed = printed->delta_f;
    s.note([&] {
      return fmt::format("(11)-(16) as printed, unrounded, give P_b = {} and delta_f = {}.",
                         shown(c.display, printed->P_b, si::N), shown(c.display, printed->delta_f, si::m));
    });
  }
  SectionForces<T> f{};
  if (Outcome o = corrected_system(c, plain, rule, s, p, f.delta_f); !o.ok()) return o;
  keep(p, out);
  out.delta_f = value(f.delta_f);
  Outcome o = two_section_tensions(c, plain, rule, s, f);
  keep_forces(f.q, out);
  out.x_1 = f.at.x1;
  out.x_2 = f.at.x2;
  out.f_1 = f.at.f1;
  out.f_2 = f.at.f2;
  if (!o.ok()) return o;
  keep_tensions(f.q, out);
  out.T_12 = value(f.T_12);
  out.delta_f_closed = value(f.delta_f);
  return {};
}

/// Where the paper's formulas leave their range, and where they are unsafe.
template <class T>
void warn_of_paper(const Case<T>& c, const Output& out, Sheet<T>& s) {
  const auto force = [&c](double x) { return shown(c.display, x, si::N); };
  const double local = out.f / std::min(value(c.x), value(c.y));
  if (local > local_slope_limit || value(c.alpha) > slope_limit) {
    s.warn([&] {
      const double excess = out.P_b * std::sin(value(c.alpha_s));
      const std::string vertical =
          shown_below(out.T_lA_paper - std::abs(excess), out.T_lA_paper)
              ? fmt::format(
                    "Taking the roller force as vertical alone makes T_lA_paper about P_b sin(alpha_s) = {} "
                    "too {}. ",
                    force(std::abs(excess)), excess < 0 ? "small, which is unsafe" : "large")
              : std::string();
      return fmt::format(
          "The paper's formulas (P_b, T_b, T_n, T_up, T_lA_paper) are outside their range (sag/distance to the nearer "
          "support {:.2g}, limit 0.2; slope {}, limit {}). {}Build by {}.",
          local, shown(c.display, value(c.alpha_s), si::rad), shown(c.display, slope_limit, si::rad), vertical,
          local > local_slope_limit ? "the values that end in _exact: the closed-form tier is out of its range too"
                                    : "the closed-form tier");
    });
  }
  if (out.P_b <= 0) {  // nothing is said of one that has no value
    s.warn([&] {
      return fmt::format("By (1) the upper branch carries nothing (P_b = {}){}: close to lift-off.", force(out.P_b),
                         std::isfinite(out.P_b_closed)
                             ? fmt::format(", by the closed-form tier {}", force(out.P_b_closed))
                             : std::string());
    });
  }
  const Peak peak = peaks_of(out).return_rope;
  if (out.T_up < peak.tension * (1 - remarked)) {
    s.warn([&] {
      return fmt::format(
          "(7) is unsafe for the return rope: it gives {} in the upper branch, but the rope is pulled with up to {} "
          "({}).",
          force(out.T_up), force(peak.tension), peak.where);
    });
  }
  if (out.T_lA_paper < out.T_lA * (1 - remarked)) {
    s.warn([&] {
      return fmt::format("(9) is unsafe here: it gives T_lA = {}, the closed-form tier {}.", force(out.T_lA_paper),
                         force(out.T_lA));
    });
  }
}

/// Not of a carriage that leaves its stop: its sag is the one at which S is T_lB.
template <class T>
void warn_of_stop(const Input& in, const Case<T>& c, const Output& out, Sheet<T>& s) {
  if (in.mode == Mode::free_running) return;
  const double S = value(c.S);
  const double T_lB = std::isfinite(out.T_lB) ? out.T_lB : out.T_lB_exact;
  if (S <= T_lB) return;
  const auto force = [&c](double x) { return shown(c.display, x, si::N); };
  s.warn([&] {
    return fmt::format(
        "The gathering force S = {} exceeds T_lB = {}: when S acts on the free end of the return rope (variant 2) the "
        "carriage has left its stop; mode free_running finds the sag at which it leaves it.{}",
        force(S), force(T_lB),
        S > out.T_n ? fmt::format(" It also exceeds T_n = {} (variant 1).", force(out.T_n)) : std::string());
  });
}

template <class T>
bool is_elastic(const Case<T>& c) {
  return std::isfinite(c.EA_b) || std::isfinite(c.EA_T);
}

template <class T>
void warn_of_input(const Input& in, const Case<T>& c, Sheet<T>& s) {
  if (in.branch_distance > 0 || is_elastic(c)) {
    s.note(
        "branch_distance and the stiffnesses enter the exact catenaries only; at a given sag they change every tension "
        "by less than 0.2 % and 0.1 % (a vertical offset on steep slopes: about 0.5 % per metre).");
  }
}

/// The exact column. A position that the engine leaves without an answer has none: next to a support and deep under it
/// the ropes pull many times as hard as by the closed form, before their equilibrium ends.
template <class T>
Outcome add_exact(const Input& in, const Case<double>& plain, const Engine& engine, Sheet<T>& s, Output& out) {
  if (!engine.solve) return {};
  if (Outcome o = engine.solve(in, plain, out); !o.ok()) return o;
  s.section("Exact catenaries");
  const auto force = [&plain](double x) { return shown(plain.display, x, si::N); };
  s.note([&] {
    return fmt::format(
        "The same loop with {} catenaries, the roller at its place on the link, solved as a whole: P_b = {}, N = {}, "
        "T_uA = {}, T_uB = {}, T_lA = {}, T_lB = {}; unstretched loop {}. Left unbalanced at a "
        "node: at most {:.0e} of the tension; left open at a rope's end: at most {:.0e} of the span.",
        is_elastic(plain) ? "elastic" : "inextensible", force(out.P_b_exact), force(out.N_exact), force(out.T_uA_exact),
        force(out.T_uB_exact), force(out.T_lA_exact), force(out.T_lB_exact),
        shown(plain.display, out.loop_length_exact, si::m), out.residual_exact, out.closure_exact);
  });
  return {};
}

/// The areas, which are those of the load at midspan. A sag that is given is taken for the one there; one that follows
/// from a tension or a length is found there. Where that has none, the position of the deck keeps its answer.
template <class T>
Outcome areas_at_midspan(const Input& in, const Setting& at, const Case<T>& c, const Paper<T>& p, Sheet<T>& s,
                         Output& out) {
  if (c.midspan || in.mode == Mode::sag) return areas(in, c, p, s, out);
  Setting middle = at;
  middle.x = nullptr;
  Sheet<double> silent;
  const Case<double> plain = make_case(in, middle, silent);
  Case<double> found = plain;
  Output there;
  const auto without = [&](const Outcome& why) {
    s.warn([&] { return fmt::format("The ropes can't be sized for the load at midspan: {}", why.message); });
    return Outcome{};
  };
  if (Outcome o = set_sag(in, plain, at.engine != nullptr ? *at.engine : no_engine, silent, found, there); !o.ok()) {
    return without(o);
  }
  out.f_midspan = found.f;
  Case<T> load_at_midspan = c;
  load_at_midspan.f = s.named("f_m", si::m, found.f);
  s.note([&] {
    return fmt::format("f_m = {}: the sag with the carriage at midspan, by the same rule.",
                       shown(c.display, found.f, si::m));
  });
  const Outcome sized = areas(in, load_at_midspan, p, s, out);
  return sized.ok() ? sized : without(sized);
}

}  // namespace

template <class T>
Outcome solve_position(const Input& in, const Setting& at, Sheet<T>& s, Output& out) {
  Case<T> c = make_case(in, at, s);
  Case<double> plain;
  if constexpr (std::is_same_v<T, double>) {
    plain = c;
  } else {
    Sheet<double> silent;
    plain = make_case(in, at, silent);
  }
  out.x = value(c.x);
  out.q_b = at.q_b;
  out.q_T = at.q_T;
  Paper<T> p{};
  resolve_force(c, s, p);
  out.P = value(p.P);
  out.K = value(p.K);
  s.note([&] {
    return fmt::format("Nominal grade TU-{:.2g}/{:.2g}: transverse load / gathering pull in tonnes-force.",
                       out.P / tonne_force, value(c.S) / tonne_force);
  });
  if (!(out.P > 0)) return no_vertical_load(c, p);
  const Engine& engine = at.engine != nullptr ? *at.engine : no_engine;
  if (Outcome o = set_sag(in, plain, engine, s, c, out); !o.ok()) return o;
  plain.f = out.f;
  const bool single = in.carriage == Carriage::single;
  Outcome o = single ? one_section(c, plain, s, p, out) : two_sections(in, c, plain, s, p, out);
  if (!o.ok() && !engine.solve) return o;
  Outcome closed_form = o;
  if (o = add_exact(in, plain, engine, s, out); !o.ok()) return closed_form.ok() ? o : closed_form;
  if (!closed_form.ok()) {
    s.warn([&] {
      return fmt::format("The closed-form tier has no answer here, the exact catenaries have one: {}",
                         closed_form.message);
    });
  }
  if (in.head_efficiency < 1) {
    out.T_winch = pull_at_winch(in, out.T_lA);
    out.T_winch_exact = pull_at_winch(in, out.T_lA_exact);
  }
  warn_of_input(in, c, s);
  warn_of_paper(c, out, s);
  warn_of_stop(in, c, out, s);
  if (single && c.midspan) {
    const Printed printed = as_printed(plain, {.P = out.P,
                                               .K = out.K,
                                               .P_b = out.P_b,
                                               .P_b_no_weight = out.P_b_no_weight,
                                               .T_b = out.T_b,
                                               .T_n = out.T_n,
                                               .T_up = 0,
                                               .T_lA = 0});
    out.P_b_4_printed = printed.P_b_4;
    out.T_n_printed = printed.T_n;
    out.T_lA_printed = printed.T_lA;
  }
  if (in.safety_factor && in.wire_strength) return areas_at_midspan(in, at, c, p, s, out);
  return {};
}

template Outcome solve_position(const Input&, const Setting&, Sheet<double>&, Output&);
template Outcome solve_position(const Input&, const Setting&, Sheet<Num>&, Output&);

std::optional<catalogue::RopeStiffness> own_stiffness(const Input& in, double given,
                                                      const std::optional<catalogue::RopeRow>& rope) {
  if (in.mode != Mode::loop_length || std::isfinite(given) || !rope) return std::nullopt;
  return catalogue::stiffness_of(*rope);
}

Setting setting_of(const Input& in, const Ropes& ropes, std::size_t index, const Engine& engine,
                   const Display* display) {
  const auto EA_of = [](const std::optional<catalogue::RopeStiffness>& own) {
    return own ? std::optional(own->EA) : std::nullopt;
  };
  return {.x = in.position.empty() ? nullptr : &in.position[index],
          .q_b = ropes.q_b,
          .q_T = ropes.q_T,
          .EA_b = EA_of(own_stiffness(in, in.return_stiffness, ropes.return_rope)),
          .EA_T = EA_of(own_stiffness(in, in.traction_stiffness, ropes.traction_rope)),
          .engine = &engine,
          .display = display};
}

std::vector<Row> sweep(const Input& in, const Ropes& ropes, const Engine& engine, const Display* display) {
  std::vector<Row> rows(std::max<std::size_t>(1, in.position.size()));
  Sheet<double> silent;
  Input without_areas = in;  // they are the same wherever the carriage stands, and belong to the note
  without_areas.wire_strength.reset();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].outcome = solve_position(without_areas, setting_of(in, ropes, i, engine, display), silent, rows[i].out);
  }
  return rows;
}

namespace {

/// T_uA, T_uB, T_lA, T_lB: exact where known, else by the closed-form tier.
std::array<double, 4> ends_of(const Output& o) {
  if (std::isfinite(o.T_lA_exact)) return {o.T_uA_exact, o.T_uB_exact, o.T_lA_exact, o.T_lB_exact};
  return {o.T_uA, o.T_uB, o.T_lA, o.T_lB};
}

}  // namespace

std::size_t worst_of(const std::vector<Row>& rows) {
  const auto sum = [](const Output& o) {
    const auto ends = ends_of(o);
    return ends[0] + ends[1] + ends[2] + ends[3];
  };
  const auto largest = [](const Output& o) {
    const auto ends = ends_of(o);
    return *std::max_element(ends.begin(), ends.end());
  };
  std::size_t worst = 0;
  bool any = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].outcome.ok()) continue;
    const Output& best = rows[worst].out;
    const Output& o = rows[i].out;
    const bool alike = any && std::abs(largest(o) - largest(best)) <= alike_within * largest(best);
    if (!any || (alike ? sum(o) > sum(best) : largest(o) > largest(best))) worst = i;
    any = true;
  }
  return worst;
}

namespace {

catalogue::RopeRow known_rope(const std::string& text) {
  const auto row = catalogue::find_rope_in_words(text);
  expects(row.has_value(), "complaints() has refused unknown ropes");
  return *row;
}

/// Over the rows that have an answer.
Peaks peaks_over(const std::vector<Row>& rows) {
  Peaks p;
  for (const Row& row : rows) {
    if (row.outcome.ok()) p = larger(p, peaks_of(row.out));
  }
  return p;
}

}  // namespace

Peaks peaks_of_both_hauls(const Input& in, const Ropes& ropes, const Engine& engine, const std::vector<Row>& rows,
                          const Display* display) {
  Input other = in;
  other.haul = in.haul == Haul::in ? Haul::out : Haul::in;
  const std::vector<Row> others = sweep(other, ropes, engine, display);
  Peaks back = peaks_over(others);
  for (std::string* where : {&back.return_rope.where, &back.traction_rope.where, &back.deepest.where}) {
    *where += other.haul == Haul::out ? ", hauled out" : ", hauled in";
  }
  Peaks both = larger(peaks_over(rows), back);
  both.other.haul = other.haul;
  for (const Row& row : others) {
    if (row.outcome.ok()) continue;
    if (both.other.without_answer.empty()) both.other.reason = row.outcome.message;
    both.other.without_answer.push_back(row.out.x);
  }
  return both;
}

namespace {

/// Positions and the peaks of both hauls; not ok when no position has an answer as asked.
Outcome prove(const Input& in, const Engine& engine, Solved& solved, const Display* display) {
  solved.rows = sweep(in, solved.ropes, engine, display);
  const auto& rows = solved.rows;
  const bool any = std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.outcome.ok(); });
  if (any) solved.peaks = peaks_of_both_hauls(in, solved.ropes, engine, rows, display);
  return any ? Outcome{} : rows.front().outcome;
}

/// Ropes chosen, with what proved them, or the deck's own.
Outcome find_ropes(const Input& in, const Engine& engine, Solved& found, const Display* display) {
  if (in.choose_ropes) {
    return choose(
        *in.choose_ropes, *in.safety_factor, [&](Solved& solved) { return prove(in, engine, solved, display); }, found,
        display);
  }
  Ropes& ropes = found.ropes;
  if (in.return_rope) {
    ropes.return_rope = known_rope(*in.return_rope);
    ropes.q_b = ropes.return_rope->mass_per_length * standard_gravity;
  } else {
    ropes.q_b = *in.return_weight;
  }
  if (in.traction_rope) {
    ropes.traction_rope = known_rope(*in.traction_rope);
    ropes.q_T = ropes.traction_rope->mass_per_length * standard_gravity;
  } else {
    ropes.q_T = *in.traction_weight;
  }
  return {};
}

/// The exact values of a position that is solved already, for its note; the engine itself where it had none, and for
/// the sag at another place. Both passes have the same numbers to the bit, so that all of them may be taken over.
Engine known_answers(const Row& row, const Engine& engine) {
  if (!row.outcome.ok() || !std::isfinite(row.out.T_lA_exact)) return engine;
  Engine known;
  if (engine.sag) {
    known.sag = [&row, &engine](const Input& in, const Case<double>& c, ExactSag& found) {
      if (c.x != row.out.x) return engine.sag(in, c, found);
      found = {.sag = row.out.f, .second = row.out.f_second};
      return Outcome{};
    };
  }
  known.solve = [&row](const Input&, const Case<double>&, Output& out) {
    out = row.out;
    return Outcome{};
  };
  return known;
}

}  // namespace

Outcome ropes_of(const Input& in, Ropes& ropes, const Engine& engine) {
  Solved found;
  Outcome o = find_ropes(in, engine, found, nullptr);
  ropes = std::move(found.ropes);
  return o;
}

Outcome solve_deck(const Input& in, const Engine& engine, Sheet<Num>& s, Solved& found, Output& out,
                   const Display* display) {
  if (Outcome o = find_ropes(in, engine, found, display); !o.ok()) return o;
  if (found.rows.empty() && in.position.size() <= 1) {
    Outcome o = solve_position(in, setting_of(in, found.ropes, 0, engine, display), s, out);
    found.rows.push_back({o, out});
    return o;
  }
  if (found.rows.empty()) found.rows = sweep(in, found.ropes, engine, display);
  const std::size_t at = worst_of(found.rows);
  const Engine known = known_answers(found.rows[at], engine);
  Outcome o = solve_position(in, setting_of(in, found.ropes, at, known, display), s, out);
  if (!found.rows[at].outcome.ok() && found.rows.size() > 1) {
    o.message = fmt::format("none of the {} positions has an answer; the first: {}", found.rows.size(), o.message);
  }
  return o;
}

}  // namespace taut::closed_loop
