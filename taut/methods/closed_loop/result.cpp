#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "taut/base/stretches.hpp"
#include "taut/catalogue/lookup.hpp"
#include "taut/catalogue/rope_values.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/closed_loop/drawing.hpp"
#include "taut/methods/closed_loop/paper_choice.hpp"
#include "taut/methods/closed_loop/position.hpp"
#include "taut/methods/closed_loop/tables.hpp"
#include "taut/units/display.hpp"

namespace taut::closed_loop {
namespace {

constexpr double none = Output::none;

/// The limit is the deck's own; the breaking force is as good as its row of the catalogue.
std::string trust_of(const catalogue::RopeRow& rope) {
  if (rope.trust == catalogue::Trust::unverified) return catalogue::trust_words(rope);
  return fmt::format("limit: user; breaking force: {}", catalogue::to_text(rope.trust));
}

std::string carriage_at(double x, const Display& display) {
  return fmt::format("carriage at {}", display.brief(x, si::m));
}

/// The strength of one of the ropes, by what the deck gives: a factor on its breaking force, else that force alone.
void judge_rope(const Input& in, const char* role, const std::optional<catalogue::RopeRow>& rope, const Peak& peak,
                const Display& display, Result& r) {
  const std::string part = fmt::format("{} rope", role);
  if (!rope || !in.safety_factor) {
    if (in.safety_factor) {
      r.unmade.push_back(unknown_strength(role));
    } else {
      r.unjudged.push_back(part);
    }
    if (!rope) return;
  }
  Check c = in.safety_factor
                ? make_check(fmt::format("safety factor of the {}", part), rope->breaking_force / peak.tension, si::one,
                             {.sense = Sense::at_least,
                              .limit = *in.safety_factor,
                              .rule = fmt::format("breaking force of {} ({}) / largest tension ({}, {}) at least "
                                                  "safety_factor of the deck",
                                                  rope->id, display.brief(rope->breaking_force, si::N),
                                                  display.brief(peak.tension, si::N), place_of(peak, display)),
                              .trust = trust_of(*rope)})
                : catalogue::breaking_check(part, *rope, peak.tension);
  c.part = part;
  if (c.limits) c.covers = {part};
  c.where = carriage_at(peak.x, display);
  r.checks.push_back(std::move(c));
}

/// The deck's ropes by role, with the stiffness that it gives them and that of the catalogue in its place.
struct Stretch {
  const char* role;
  double given;
  std::optional<catalogue::RopeStiffness> own;
};

std::array<Stretch, 2> stretch_of(const Input& in, const Ropes& ropes) {
  return {Stretch{.role = "return",
                  .given = in.return_stiffness,
                  .own = own_stiffness(in, in.return_stiffness, ropes.return_rope)},
          Stretch{.role = "traction",
                  .given = in.traction_stiffness,
                  .own = own_stiffness(in, in.traction_stiffness, ropes.traction_rope)}};
}

void check_clearance(const Input& in, const Solved& found, const Deepest& deepest, const Display& display, Result& r) {
  if (!(deepest.sag > 0)) return;
  Check c = make_check("sag at the carriage", deepest.sag, si::m,
                       {.sense = Sense::at_most,
                        .limit = *in.clearance,
                        .rule = "sag under the chord at most clearance of the deck, hauled in and out",
                        .trust = "user"});
  c.where = carriage_at(deepest.x, display) + deepest.where;
  if (in.mode == Mode::loop_length) {
    for (const Stretch& rope : stretch_of(in, found.ropes)) {
      if (rope.own && rope.own->trust == catalogue::Trust::unverified)
        c.trust = fmt::format("UNVERIFIED: stiffness of the {} rope, {}", rope.role, to_text(*rope.own));
      if (std::isfinite(rope.given) || rope.own || !c.passes) continue;
      r.unmade.push_back(fmt::format(
          "the clearance holds with a {0} rope that does not stretch; a real one sags deeper: give {0}_stiffness",
          rope.role));
    }
  }
  r.checks.push_back(std::move(c));
}

/// Tensions and sag are checked hauled in and out. Where the other haul has no answer, they are not.
void tell_other_haul(const OtherHaul& other, std::size_t positions, const Display& display, Result& r) {
  if (other.without_answer.empty()) return;
  std::vector<std::string> places;
  places.reserve(other.without_answer.size());
  for (const double place : other.without_answer) places.push_back(display.brief(place, si::m));
  const bool at_all = places.size() == positions;
  r.unmade.push_back(
      fmt::format("hauled {} the loop has no answer {} (carriage at {}): {}; the checks are of both hauls: {}",
                  other.haul == Haul::in ? "in" : "out",
                  at_all ? "at all" : fmt::format("at {} of {} positions", places.size(), positions),
                  catalogue::listed(places), other.reason,
                  at_all ? "change what the reason names until both have one"
                         : "change what the reason names, or leave these positions out"));
  r.warnings.push_back(r.unmade.back());
}

/// `found`: the positions, with the peaks of both hauls.
void add_checks(const Input& in, const Solved& found, const Display& display, Result& r) {
  const auto& [ropes, rows, known] = found;
  const Peaks& peaks = *known;
  r.tables.push_back(ropes_table(ropes, peaks, display));
  if (in.choose_ropes) {
    r.choices["return rope"] = ropes.return_rope->id;
    r.choices["traction rope"] = ropes.traction_rope->id;
  }
  judge_rope(in, "return", ropes.return_rope, peaks.return_rope, display, r);
  judge_rope(in, "traction", ropes.traction_rope, peaks.traction_rope, display, r);
  if (in.clearance) check_clearance(in, found, peaks.deepest, display, r);
  tell_other_haul(peaks.other, rows.size(), display, r);
}

/// One quantity by each tier of the calculation, SI.
struct Tiers {
  double printed;
  double corrected;
  double exact = none;
};

/// Printed against corrected.
Comparison compared(const char* what, const char* symbol, const Unit& unit, const Tiers& by, const char* build_by) {
  return {.quantity = what,
          .symbol = symbol,
          .unit = unit,
          .printed = by.printed,
          .corrected = by.corrected,
          .exact = by.exact,
          .build_by = build_by,
          .printed_unsafe = false};
}

/// The same for what a rope must withstand: a printed value more than 1 % too low is unsafe. (Of a load that two
/// branches share, too small a part of one is too large a part of the other.)
Comparison demanded(const char* what, const char* symbol, const Unit& unit, const Tiers& by, const char* build_by) {
  Comparison c = compared(what, symbol, unit, by, build_by);
  c.printed_unsafe = by.printed < std::fmax(by.corrected, by.exact) * 0.99;
  return c;
}

void add(Result& r, Comparison c) {
  if (std::isfinite(c.printed) && std::isfinite(c.corrected)) r.comparisons.push_back(std::move(c));
}

void add_comparisons(const Input& in, const Output& o, Result& r) {
  const double exact_peak = std::isfinite(o.T_lA_exact) ? peaks_of(o).return_rope.tension : none;
  if (in.carriage == Carriage::two_section) {
    add(r, compared("load on the upper branch, (11)-(16)", "P_b", si::N,
                    {.printed = o.P_b_printed, .corrected = o.P_b, .exact = o.P_b_exact},
                    "corrected: sections distinguished, forces resolved on their own chords"));
    add(r, compared("sag of section 2, (11)-(16)", "delta_f", si::m,
                    {.printed = o.delta_f_printed, .corrected = o.delta_f, .exact = o.delta_f_exact},
                    "corrected: the same system"));
  }
  add(r, compared("load on the upper branch, (4)", "P_b0", si::N,
                  {.printed = o.P_b_4_printed, .corrected = o.P_b_no_weight}, "corrected: 2f in place of 2l"));
  Comparison load =
      compared(in.carriage == Carriage::single ? "load on the upper branch, (1)" : "load on the upper branch", "P_b",
               si::N, {.printed = o.P_b, .corrected = o.P_b_closed, .exact = o.P_b_exact},
               "corrected: roller force normal to the rope");
  load.printed_unsafe = false;  // too small a share of one branch is too large a share of the other
  add(r, load);
  add(r, demanded("traction rope at the carriage, (6)", "T_n", si::N, {.printed = o.T_n_printed, .corrected = o.T_n},
                  "corrected: T_b/eta + S sin(gamma)/cos(alpha)"));
  add(r, demanded("highest tension of the return rope, (7)", "T_up", si::N,
                  {.printed = o.T_up, .corrected = closed_form_peaks_of(o).return_rope.tension, .exact = exact_peak},
                  "corrected: the largest tension anywhere in the rope (in-haul: behind the sheave at B)"));
  add(r,
      demanded("traction rope at A, (9) as printed", "T_lA", si::N,
               {.printed = o.T_lA_printed, .corrected = o.T_lA, .exact = o.T_lA_exact}, "corrected: closed-form tier"));
  add(r, demanded("traction rope at A, (9) repaired", "T_lA", si::N,
                  {.printed = o.T_lA_paper, .corrected = o.T_lA, .exact = o.T_lA_exact},
                  "corrected: closed-form tier, roller force normal to the rope"));
  add(r, demanded("area of the return rope, (8)", "F_return", si::m2,
                  {.printed = o.F_return_paper, .corrected = o.F_return},
                  "corrected: (8*), sized for the rope behind the sheave"));
  add(r, demanded("area of the traction rope, (10)", "F_traction", si::m2,
                  {.printed = o.F_traction_paper, .corrected = o.F_traction},
                  "corrected: (10*), with the roller's push along the slope"));
}

void add_words(const Input& in, const Solved& found, const Display& display, Result& r) {
  const std::vector<Row>& rows = found.rows;
  r.assumptions = {"Statics of one span; both branches hang parallel, with the same sag at the carriage.",
                   "Ropes are parabolas (small sag): the closed-form tier is within 2 % of catenaries for sags up to "
                   "0.2 of the distance to the nearer support and ropes that weigh no more than the load; beyond, its "
                   "tensions are mostly too small.",
                   "Not in these numbers: rolling resistance, bending of the ropes over sheaves and rollers, splices, "
                   "wear, shocks at "
                   "intermediate supports, wind, temperature."};
  if (has_exact(rows)) {
    r.assumptions.emplace_back(
        "Values that end in _exact: the same loop with catenaries and equilibrium of every node; ropes are checked and "
        "chosen by these.");
  }
  for (const Stretch& rope : stretch_of(in, found.ropes)) {
    if (!rope.own) continue;
    r.assumptions.push_back(
        fmt::format("{0}_stiffness is not given: the {0} rope stretches as the catalogue has it, {1}.", rope.role,
                    to_text(*rope.own)));
  }
  const auto failed = static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.outcome.ok(); }));
  if (rows.size() > 1) {
    r.assumptions.emplace_back(
        "The values belong to the position with the largest tension at a rope end; the table lists all positions.");
  }
  if (rows.size() > 1 && in.mode == Mode::sag) {
    r.assumptions.emplace_back(
        "Every position has the sag of the deck: the winch slackens or tightens the loop as it moves.");
  }
  if (failed > 0 && failed < rows.size()) {
    const auto first = std::find_if(rows.begin(), rows.end(), [](const Row& row) { return !row.outcome.ok(); });
    const auto place = [&](const Row& row) { return "x = " + display.brief(row.out.x, si::m); };
    Stretches all;
    for (const Row& row : rows) all.take(row.outcome.ok() ? "" : row.outcome.message, place(row), {});
    r.missing.push_back({.analysis = "positions",
                         .missing = static_cast<int>(failed),
                         .places = static_cast<int>(rows.size()),
                         .first = place(*first),
                         .reason = first->outcome.message,
                         .all = all.few_places()});
    r.warnings.push_back(fmt::format("{} of {} positions have no answer; the table `positions` gives the reasons.",
                                     failed, rows.size()));
  }
  if (in.carriage == Carriage::two_section) {
    r.assumptions.emplace_back(
        "Two-section carriage: the roller rides with section 1, which is clamped to the lower branch; section 2 "
        "carries the "
        "gathering force.");
  }
}

}  // namespace

Result run(const Input& in) { return run(in, no_engine); }

Result run(const Input& in, const Engine& engine) { return run(in, engine, Display()); }

std::string unknown_strength(const std::string& role) {
  return fmt::format(
      "the safety_factor of the {0} rope is not checked: its breaking force is not known; name it by "
      "'{0}_rope', or give its 'breaking_force' under 'checks: ropes: {0}'",
      role);
}

Result run(const Input& in, const Engine& engine, const Display& display) {
  Result r = result_of(about(), Input::describe(), &in);
  Solved found;
  Output out;
  Sheet<Num> s(about().short_source, Input::describe(), &in);
  const Outcome outcome = solve_deck(in, engine, s, found, out, &display);
  const std::vector<Row>& rows = found.rows;
  if (outcome.ok()) {
    // a search for ropes has them already
    if (!found.peaks) found.peaks = peaks_of_both_hauls(in, found.ropes, engine, rows, &display);
    out.T_max = std::max(found.peaks->return_rope.tension, found.peaks->traction_rope.tension);
    prove_paper_choice(in, out, display, r.warnings);
  }
  r.status = outcome.status;
  r.message = outcome.message;
  r.values = values_of(Output::describe(), &out);
  s.move_to(r);
  if (!outcome.ok()) r.figures = {loop_without_answer(in, display)};
  if (rows.empty()) return r;
  if (!in.position.empty() && rows.size() > 1) r.tables.push_back(positions_table(rows));
  add_words(in, found, display, r);
  if (!outcome.ok()) return r;
  add_checks(in, found, display, r);
  if (in.safety_factor && in.wire_strength && std::isnan(out.F_return)) {
    r.unmade.emplace_back("the ropes can't be sized for the load at midspan: the metallic areas have no answer");
  }
  add_comparisons(in, out, r);
  if (std::isfinite(out.T_lA)) r.figures = {loop_drawing(in, out, display), force_polygon(in, out)};
  r.figures.emplace_back(tension_plot(in, found.ropes, rows, engine));
  if (in.carriage == Carriage::single && std::isfinite(out.T_lA))
    r.figures.emplace_back(error_plot(in, found.ropes, out));
  return r;
}

}  // namespace taut::closed_loop
