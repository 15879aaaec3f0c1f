#include "taut/methods/mast_section/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "taut/base/stretches.hpp"
#include "taut/calc/shown.hpp"
#include "taut/math/degree.hpp"
#include "taut/methods/mast_section/figures.hpp"
#include "taut/methods/mast_section/tables.hpp"
#include "taut/units/display.hpp"

namespace taut::mast_section {
namespace {

/// Second order: the stress grows faster than the forces, so that a reserve n in the stress is a smaller one in them.
const char* second_order_rule(const Input& in) {
  return in.safety ? "N/A + M/W <= [sigma] at every height, with the moments of the mast's own deflection, each rope "
                     "hauled in, paid out and at rest; stress under the safety times the forces, over the safety"
                   : "N/A + M/W <= [sigma] at every height, with the moments of the mast's own deflection, each rope "
                     "hauled in, paid out and at rest";
}

/// `allowable`: [sigma] at the section's wall, with the rule that the stress is held against it by.
Check stress_check(std::string name, double stress, Bound allowable, std::string where) {
  Check c = make_check(std::move(name), stress, si::Pa, std::move(allowable));
  c.part = "mast";
  c.covers = {c.part};
  c.where = std::move(where);
  return c;
}

bool has_rest(const ClampForces& f) {
  return f.skyline_is == RopeState::at_rest || f.mainline_is == RopeState::at_rest;
}

/// Load cases whose stress of first order is checked together.
struct Directions {
  const char* words;
  bool (*has)(const ClampForces& f);
};
constexpr std::array directions{
    Directions{.words = "ropes hauled in", .has = [](const ClampForces& f) { return are(f, RopeState::hauled_in); }},
    Directions{.words = "ropes paid out", .has = [](const ClampForces& f) { return are(f, RopeState::paid_out); }},
    Directions{.words = "one rope hauled in, the other paid out",
               .has = [](const ClampForces& f) { return f.skyline_is != f.mainline_is && !has_rest(f); }},
    Directions{.words = "a rope at rest", .has = has_rest}};

/// (12)-(14) for one section under the worst of some forces, as steps and as a check.
void check_first_order(const Input& in, const Assessment& a, const std::vector<ClampForces>& all,
                       const Directions& direction, Sheet<Num>& s, Result& r) {
  std::vector<ClampForces> forces;
  std::copy_if(all.begin(), all.end(), std::back_inserter(forces), direction.has);
  const auto worst = assess(limit_of(in), a.section, forces);
  s.section(fmt::format("Strength of {}, {}", a.section.name, direction.words));
  const bool mixed = worst->worst.skyline_is != worst->worst.mainline_is;
  const std::string where = mixed ? case_words(in, worst->worst) : position_words(in, worst->worst);
  if (in.span && in.span->carriage_position.size() > 1) {
    s.note("its worst carriage position: " + where);
  } else if (mixed) {
    s.note("the worst of them: " + where);
  }
  const Num N = s.named("N", si::N, std::abs(worst->worst.N)), M = s.named("M", si::N_m, std::abs(worst->worst.M));
  const Num A = s.named("A", si::m2, a.section.area), W = s.named("W", si::m3, a.section.W_el_y);
  s.eq("14", "sigma", si::Pa, N / A + M / W);
  s.move_to(r);
  r.checks.push_back(stress_check(fmt::format("strength of {}, {}", a.section.name, direction.words), worst->stress,
                                  {.sense = Sense::at_most,
                                   .limit = worst->allowable,
                                   .rule = "N/A + M/W <= [sigma], Shoshin et al. 2022, (12)-(14)",
                                   .trust = trust_of(limit_of(in))},
                                  where));
}

/// The checks of the section given or chosen; where second order decides alone they are its own, outside the method.
void check_section(const Input& in, const Assessment& a, const std::vector<ClampForces>& forces, Sheet<Num>& s,
                   Result& r, Output& out) {
  if (!a.only_second_order) {
    for (const Directions& one : directions) check_first_order(in, a, forces, one, s, r);
    if (a.second_order) {
      const char* rule = std::isnan(*a.second_order) ? "the mast finds no equilibrium with the moments of its own "
                                                       "deflection: it buckles"
                                                     : second_order_rule(in);
      r.checks.push_back(
          stress_check(fmt::format("strength of {}, second order", a.section.name), *a.second_order,
                       {.sense = Sense::at_most, .limit = a.allowable, .rule = rule, .trust = trust_of(limit_of(in))},
                       case_words(in, a.second_order_worst)));
    }
  }
  out.section_stress = a.stress;
  out.section_allowable = a.allowable;
  out.section_mass = a.section.mass_per_length;
  const auto steel = limit_of(in).steel;
  if (steel && !is_made_of(a.section, *steel)) {
    r.warnings.push_back(fmt::format("{} of {} is not made of {} steel: name a steel of the section's standard",
                                     a.section.name, a.section.standard, steel->standard));
  }
  if (a.section.trust == catalogue::Trust::unverified) {
    r.warnings.push_back(fmt::format("{} is an unverified row of the catalogue ({}): compare it with the maker's table",
                                     a.section.name, a.section.trust_text));
  }
}

/// "160.2 MPa", or that it buckles.
std::string stress_words(const Assessment& a, const Display& display) {
  const auto stress = [&](double x) { return display.brief(x, si::Pa); };
  std::string text = a.only_second_order ? std::string() : stress(a.stress);
  const bool first_fails = !a.only_second_order && a.stress > a.allowable;
  if (a.second_order && !first_fails) {
    if (!text.empty()) text += ", by second order ";
    text += std::isnan(*a.second_order) ? "no equilibrium" : stress(*a.second_order);
  }
  text += " against " + stress(a.allowable);
  if (a.buckling < a.least_buckling) {
    text += fmt::format(", and buckles at {:.3g} times its axial force against {:.3g}", a.buckling, a.least_buckling);
  }
  return a.wall_yields ? text : text + ", and its wall may buckle before it yields";
}

std::string none_passes(const Input& in, catalogue::SectionShape shape, const std::vector<ClampForces>& forces,
                        const SecondOrder& second, const Display& display) {
  const auto best = strongest(in, shape, forces, second);
  const std::string kind(to_text(shape));
  if (!best)
    return fmt::format(
        "no {} of the catalogue may be chosen: none has the forming, standard, trust, slenderness "
        "and steel that are asked for",
        kind);
  return fmt::format("no {} of the catalogue carries the mast: the nearest, {}, has {}", kind, best->section.name,
                     stress_words(*best, display));
}

/// Fills the table `sections`; gives the section to be checked: the one given, or else the lightest that passes, or
/// else the one that comes nearest to passing, which fails its check. Nothing: none may be chosen.
std::optional<Assessment> find_sections(const Input& in, const std::vector<ClampForces>& forces,
                                        const SecondOrder& second, const Display& display, Result& r) {
  std::vector<SectionLine> lines;
  const auto add = [&](const Assessment& a, std::string use) {
    lines.push_back({.of = a, .height = height_of(in), .use = std::move(use)});
  };
  std::optional<Assessment> chosen = section_in_use(in, forces, second);
  if (chosen && in.section) add(*chosen, "given");
  if (in.section && second.decides_alone) {  // others would have to be solved one by one
    r.tables.push_back(sections_table(lines));
    return chosen;
  }
  for (const catalogue::SectionShape shape : shapes_of(in)) {
    if (const auto a = lightest(in, shape, forces, second)) {
      add(*a, fmt::format("lightest {} that passes", to_text(shape)));
    } else {
      r.warnings.push_back(none_passes(in, shape, forces, second, display));
    }
  }
  if (chosen && !in.section && !chosen->passes()) {
    add(*chosen, "nearest, does not pass");
    r.warnings.push_back(fmt::format(
        "no section that may be chosen carries the mast; {} comes nearest and is shown: allow more kinds of "
        "section, a larger slenderness or a stronger steel, or lower the blocks or the rope forces",
        chosen->section.name));
  }
  if (!lines.empty()) r.tables.push_back(sections_table(lines));
  if (chosen && !in.section) r.choices["section"] = chosen->section.name;
  return chosen;
}

/// D_tube for other forces at the clamp, for the comparisons.
double tube_under(double N, double M, const Output& out, const Input& in) {
  const double c2 = square(in.tube_ratio), c4 = square(c2), pi = std::numbers::pi;
  const double p = 4 * N / (pi * (1 - c2) * out.sigma_allow), q = 32 * M / (pi * (1 - c4) * out.sigma_allow);
  return find_root([&](double D) { return cube(D) - p * D - q; }, 0.0, std::sqrt(std::abs(p)) + std::cbrt(q))
      .value_or(not_computed);
}

/// Whether a brake gives way before a rope has its full force.
bool brake_slips(const Input& in) {
  return in.paid_out_force && *in.paid_out_force < std::max(in.skyline_force, in.mainline_force);
}

const char* payout_words(const Input& in) {
  return brake_slips(in) ? "the larger: ropes are paid out until their brakes slip"
                         : "the larger: ropes are paid out under their full force";
}

void add_comparisons(const Input& in, const Output& out, Result& r) {
  const Unit mm = si::m.in("mm");
  const double R = out.R_sky + out.R_main;
  const double M_9 = out.M * std::cos(out.gamma_sky_printed) / std::cos(out.gamma_sky);
  const double D_9 = tube_under(R * std::sin(out.gamma_sky_printed), M_9, out, in);
  r.comparisons.push_back({"direction of the resultant, (9)", "gamma_sky", si::rad, out.gamma_sky_printed,
                           out.gamma_sky, not_computed, "corrected: the vector sum of the branches",
                           shown_below(D_9, out.D_tube)});
  const double geometric = std::numbers::pi / 2 + out.alpha;
  Input other = in;
  other.span.reset();
  other.branch_angle = std::clamp(out.alpha, least_branch_angle, largest_branch_angle);
  other.wrap = in.wrap == Wrap::paper ? Wrap::geometric : Wrap::paper;
  Output there;
  solve(other, there);
  const bool paper = in.wrap == Wrap::paper;
  const double D_paper = paper ? out.D_tube : there.D_tube, D_geometric = paper ? there.D_tube : out.D_tube;
  r.comparisons.push_back({"wrap angle on the block", "epsilon", si::rad, 120 * degree, geometric, not_computed,
                           "corrected: 90 deg + alpha", shown_below(D_paper, D_geometric)});
  r.comparisons.push_back({"tube by the wrap angle", "D_tube", mm, D_paper, D_geometric, not_computed,
                           "corrected: the wrap of the branch angle at hand", shown_below(D_paper, D_geometric)});
  r.comparisons.push_back({"hollow square, table", "B_hollow", mm, out.B_hollow_printed, out.B_hollow, not_computed,
                           "corrected: 4/3 and 6.40; B is the outer side",
                           shown_below(out.B_hollow_printed, out.B_hollow)});
  r.comparisons.push_back({"tube, table", "D_tube", mm, out.D_tube_printed, out.D_tube, not_computed,
                           "corrected: 4/pi and 32/pi in place of 1.27 and 10",
                           shown_below(out.D_tube_printed, out.D_tube)});
  r.comparisons.push_back({"moment, ropes hauled in and paid out, (2), (3)", "M", si::N_m, out.M, out.M_payout,
                           not_computed, payout_words(in), shown_below(out.M, out.M_payout)});
  r.comparisons.push_back({"tube, ropes hauled in and paid out", "D_tube", mm, out.D_tube, out.D_tube_payout,
                           not_computed, payout_words(in), shown_below(out.D_tube, out.D_tube_payout)});
}

/// `alone`: the mast with its guys is solved besides, and that decides.
void add_warnings(const Input& in, const Output& out, bool alone, const Display& display, Result& r) {
  auto& w = r.warnings;
  const Unit mm = si::m.in("mm");
  const auto length = [&](double x) { return display.brief(x, mm); };
  if (!alone) {
    w.emplace_back(
        "guylines and buckling are not in this method: their forces add to N, and a slender mast fails by buckling "
        "first; check both, and local buckling of thin walls, before building");
  }
  w.push_back(
      fmt::format("the tube by the printed coefficients 1.27 and 10 ({}) is {:.1f} % too small for ropes hauled in, "
                  "which need D_tube {}: build by D_tube_worst {}",
                  length(out.D_tube_printed), (1 - out.D_tube_printed / out.D_tube) * 100, length(out.D_tube),
                  length(out.D_tube_worst)));
  if (shown_below(out.D_tube, out.D_tube_payout)) {
    const auto [M_payout, M] = brief_apart(out.M_payout, out.M, si::N_m, display);
    const auto [D_payout, D] = brief_apart(out.D_tube_payout, out.D_tube, mm, display);
    w.push_back(fmt::format(
        "a rope paid out under {} bends the mast more: M {} instead of {}, tube {} instead of {}; the section is "
        "chosen and checked for both{}",
        brake_slips(in) ? "the force at which its brake slips" : "its full force", M_payout, M, D_payout, D,
        brake_slips(in)     ? ""
        : in.paid_out_force ? "; no brake slips, as paid_out_force is no less than the ropes' forces"
                            : "; paid_out_force states a brake that slips before"));
  }
  if (in.wrap == Wrap::paper && out.alpha < 30 * degree) {
    w.push_back(fmt::format(
        "the paper's wrap of {} belongs to alpha = {}; at {} it understates the forces: take wrap: geometric",
        display.brief(120 * degree, si::rad), display.brief(30 * degree, si::rad), display.brief(out.alpha, si::rad)));
  }
  if (in.block_friction < 0.10 || in.block_friction > 0.16) {
    w.push_back(fmt::format("block friction {:.3g} lies outside the paper's 0.10 to 0.16", in.block_friction));
  }
  if (!in.steel) return;
  const auto at_wall = allowable_stress(limit_of(in), out.t_tube);
  if (!at_wall) {
    w.push_back(fmt::format("the wall of the ideal tube, {}, is thicker than the table of {} reaches",
                            length(out.t_tube), *in.steel));
  } else if (*at_wall < out.sigma_allow) {
    w.push_back(fmt::format(
        "[sigma] = {} is that of the thinnest range of {}; at the ideal tube's wall of {} it is {}: go by the "
        "catalogue sections, which are taken at their own wall",
        display.brief(out.sigma_allow, si::Pa), *in.steel, length(out.t_tube), display.brief(*at_wall, si::Pa)));
  }
}

void add_assumptions(const Input& in, Result& r) {
  r.assumptions = {
      "The mast is clamped at its foot; guylines neither hold nor load it.",
      "Drum sides run straight down. The rated force is there hauled in, on the span side paid out, on both at rest.",
      "Both ropes leave the mast in one vertical plane and under the same angle.",
      "N > 0 presses the mast down, Q > 0 pulls its head towards the span, M > 0 bends it that way.",
      "Own weight, wind, dynamics and fatigue are left out; what [sigma] holds in reserve has to cover them.",
      "A section's stress is elastic, about the strong axis of a rectangular one."};
  if (in.span) {
    r.assumptions.emplace_back(
        "alpha points from the block to the carriage, (10); the horizontal tension is the same at every position.");
  }
}

void add_figures(const Input& in, const Output& out, const std::vector<Position>& positions,
                 const std::optional<Assessment>& section, Result& r) {
  r.figures = {mast_drawing(in, out), force_polygon(in, out)};
  if (positions.size() > 1) {
    r.figures.emplace_back(position_size_plot(positions, out));
    r.figures.emplace_back(position_force_plot(positions, out));
    r.figures.emplace_back(position_moment_plot(positions, out));
  } else {
    r.figures.emplace_back(angle_plot(in, out));
  }
  r.figures.emplace_back(moment_plot(in, out));
  r.figures.emplace_back(stress_plot(in, out, section));
}

/// Every carriage position, and the note of those that govern.
Outcome solve_positions(const Input& in, Sheet<Num>& s, Solved& found, Output& out) {
  if (position_count(in) == 1) {
    Outcome outcome = compute_at(in, 0, s, out);
    found.positions = {{.index = 0, .out = out, .outcome = outcome}};
    found.governing = governing_of(found.positions);
    return outcome;
  }
  found.positions = sweep(in);
  found.governing = governing_of(found.positions);
  return compute_governing(in, found.governing, s, out);
}

}  // namespace

Result run(const Input& in) {
  Solved found;
  return run(in, SecondOrder{}, found);
}

Result run(const Input& in, const SecondOrder& second, Solved& found, const Display& display) {
  const Method& m = about();
  Result r = result_of(m, Input::describe(), &in);
  Output out;
  Sheet<Num> s(m.short_source, Input::describe(), &in);
  s.show_in(display);
  const Outcome outcome = solve_positions(in, s, found, out);
  const std::vector<Position>& positions = found.positions;
  s.move_to(r);
  r.status = outcome.status;
  r.message = outcome.message;
  add_assumptions(in, r);
  if (in.span) r.tables.push_back(positions_table(positions, out));
  if (outcome.ok()) {
    const auto lost = std::count_if(positions.begin(), positions.end(), [](const auto& p) { return !p.outcome.ok(); });
    if (lost > 0) {
      r.warnings.push_back(fmt::format("{} of {} carriage positions lie outside the method: see the table of positions",
                                       lost, positions.size()));
      const auto first =
          std::find_if(positions.begin(), positions.end(), [](const auto& p) { return !p.outcome.ok(); });
      const auto place = [&](const Position& p) { return "x = " + display.brief(p.out.x, si::m); };
      Stretches all;
      for (const Position& p : positions) all.take(p.outcome.ok() ? "" : p.outcome.message, place(p), {});
      r.missing.push_back({.analysis = "carriage positions",
                           .missing = static_cast<int>(lost),
                           .places = static_cast<int>(positions.size()),
                           .first = place(*first),
                           .reason = first->outcome.message,
                           .all = all.few_places()});
    }
    found.forces = clamp_forces(in, positions);
    add_warnings(in, out, second.decides_alone, display, r);
    r.tables.push_back(load_cases_table(in, found.forces));
    const auto& section = found.section = find_sections(in, found.forces, second, display, r);
    if (section) check_section(in, *section, found.forces, s, r, out);
    if (!section) r.unjudged.emplace_back("mast");
    add_comparisons(in, out, r);
    add_figures(in, out, positions, section, r);
  } else {
    r.figures = {mast_without_answer(in, positions.front().out)};
  }
  r.values = values_of(Output::describe(), &out);
  return r;
}

}  // namespace taut::mast_section
