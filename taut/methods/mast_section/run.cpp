#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/math/degree.hpp"
#include "taut/methods/mast_section/figures.hpp"
#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/methods/mast_section/position.hpp"
#include "taut/methods/mast_section/sizing.hpp"

namespace taut::mast_section {
namespace {

Table positions_table(const std::vector<Position>& positions, const Output& governing) {
  Table t{"positions", "Carriage positions", {}, {}};
  const Unit mm = si::m.in("mm");
  t.columns = {{"x", si::m},           {"f_x", si::m},        {"alpha", si::rad},   {"wrap", si::rad},
               {"R_sky", si::N},       {"R_main", si::N},     {"N", si::N},         {"M", si::N_m},
               {"Q", si::N},           {"b_square", mm},      {"B_hollow", mm},     {"D_tube", mm},
               {"D_tube_printed", mm}, {"D_tube_payout", mm}, {"governs", si::one}, {"reason", si::one}};
  for (const Position& p : positions) {
    const Output& o = p.out;
    const bool governs = p.outcome.ok() && o.x == governing.x;
    t.rows.push_back({o.x, o.f_x, o.alpha, o.wrap, o.R_sky, o.R_main, o.N, o.M, o.Q, o.b_square, o.B_hollow, o.D_tube,
                      o.D_tube_printed, o.D_tube_payout, std::string(governs ? "governs" : ""), p.outcome.message});
  }
  return t;
}

std::vector<Cell> section_row(const Input& in, const Assessment& a, std::string use) {
  const double height = std::max(in.skyline_block_height, in.mainline_block_height.value_or(0));
  const catalogue::SectionRow& s = a.section;
  return {std::string(to_text(s.shape)),
          s.name,
          s.standard,
          std::string(to_text(s.forming)),
          s.height,
          s.width,
          s.thickness,
          s.height / s.thickness,
          s.area,
          s.W_el_y,
          s.mass_per_length,
          s.mass_per_length * height,
          a.stress,
          a.allowable,
          a.utilisation(),
          std::string(to_text(s.trust)),
          std::move(use)};
}

Table sections_table() {
  const Unit mm = si::m.in("mm");
  return {"sections",
          "Catalogue sections, RHS about the strong axis",
          {{"shape", si::one},
           {"name", si::one},
           {"standard", si::one},
           {"forming", si::one},
           {"height", mm},
           {"width", mm},
           {"wall", mm},
           {"height/wall", si::one},
           {"area", si::m2},
           {"W", si::m3},
           {"mass", si::kg_per_m},
           {"mass of the mast", si::kg},
           {"stress", si::Pa},
           {"allowable", si::Pa},
           {"utilisation", si::one},
           {"trust", si::one},
           {"use", si::one}},
          {}};
}

/// (12)-(14) for one section, as steps and as a check.
void check_section(const Input& in, const Assessment& a, Sheet<Num>& s, Result& r, Output& out) {
  s.section(fmt::format("Strength of {}", a.section.name));
  if (in.span && in.span->carriage_position.size() > 1) {
    s.note(fmt::format("its worst carriage position is x = {:.4g} m", in.span->carriage_position.at(a.worst.index)));
  }
  const Num N = s.named("N", si::N, a.worst.N), M = s.named("M", si::N_m, a.worst.M);
  const Num A = s.named("A", si::m2, a.section.area), W = s.named("W", si::m3, a.section.W_el_y);
  s.eq("14", "sigma", si::Pa, N / A + M / W);
  s.move_to(r);
  r.checks.push_back(make_check(fmt::format("strength of {}", a.section.name), a.stress, Sense::at_most, a.allowable,
                                si::Pa, "N/A + M/W <= [sigma], Shoshin et al. 2022, (12)-(14)",
                                trust_of(limit_of(in))));
  out.section_stress = a.stress;
  out.section_allowable = a.allowable;
  out.section_mass = a.section.mass_per_length;
  if (a.section.trust == catalogue::Trust::unverified) {
    r.warnings.push_back(fmt::format("{} is an unverified row of the catalogue ({}): compare it with the maker's table",
                                     a.section.name, a.section.trust_text));
  }
}

std::string none_passes(const Input& in, catalogue::SectionShape shape, const std::vector<ClampForces>& forces) {
  const auto best = strongest(in, shape, forces);
  const std::string kind(to_text(shape));
  if (!best) return fmt::format("no {} of the catalogue may be chosen", kind);
  return fmt::format(
      "no {} of the catalogue carries the mast: the strongest, {}, reaches {:.1f} MPa against {:.1f} MPa", kind,
      best->section.name, best->stress / 1e6, best->allowable / 1e6);
}

/// Fills the table `sections`; gives the section to be checked, or the outcome when a section was asked for and none
/// passes.
std::optional<Assessment> find_sections(const Input& in, const std::vector<ClampForces>& forces, Result& r) {
  Table t = sections_table();
  std::optional<Assessment> chosen;
  if (in.section) {
    chosen = assess(limit_of(in), *catalogue::find_section(*in.section), forces);
    if (chosen) t.rows.push_back(section_row(in, *chosen, "given"));
  }
  std::vector<std::string> missing;
  std::optional<Assessment> lightest_of_all;
  for (const catalogue::SectionShape shape : shapes_of(in)) {
    auto a = lightest(in, shape, forces);
    if (!a) {
      missing.push_back(none_passes(in, shape, forces));
      continue;
    }
    t.rows.push_back(section_row(in, *a, fmt::format("lightest {} that passes", to_text(shape))));
    if (!lightest_of_all || a->section.mass_per_length < lightest_of_all->section.mass_per_length) lightest_of_all = a;
  }
  if (!in.section) chosen = lightest_of_all;
  if (in.choose_section && !chosen) {
    r.status = Status::infeasible;
    r.message = fmt::format(
        "{}; allow more kinds of section, a larger slenderness or a stronger steel, or lower the blocks or the rope "
        "forces",
        fmt::join(missing, "; "));
  }
  r.warnings.insert(r.warnings.end(), missing.begin(), missing.end());
  if (!t.rows.empty()) r.tables.push_back(std::move(t));
  return chosen;
}

/// D_tube for other forces at the clamp, for the comparisons.
double tube_under(double N, double M, const Output& out, const Input& in) {
  const double c2 = square(in.tube_ratio), c4 = square(c2), pi = std::numbers::pi;
  const double p = 4 * N / (pi * (1 - c2) * out.sigma_allow), q = 32 * M / (pi * (1 - c4) * out.sigma_allow);
  return find_root([&](double D) { return cube(D) - p * D - q; }, 0.0, std::sqrt(std::abs(p)) + std::cbrt(q))
      .value_or(not_computed);
}

void add_comparisons(const Input& in, const Output& out, Result& r) {
  const Unit mm = si::m.in("mm");
  const double R = out.R_sky + out.R_main;
  const double M_9 = out.M * std::cos(out.gamma_sky_printed) / std::cos(out.gamma_sky);
  const double D_9 = tube_under(R * std::sin(out.gamma_sky_printed), M_9, out, in);
  r.comparisons.push_back({"direction of the resultant, (9)", "gamma_sky", si::rad, out.gamma_sky_printed,
                           out.gamma_sky, not_computed, "corrected: the vector sum of the branches", D_9 < out.D_tube});
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
                           "corrected: 90 deg + alpha", D_paper < D_geometric});
  r.comparisons.push_back({"tube by the wrap angle", "D_tube", mm, D_paper, D_geometric, not_computed,
                           "corrected: the wrap of the branch angle at hand", D_paper < D_geometric});
  r.comparisons.push_back({"hollow square, table", "B_hollow", mm, out.B_hollow_printed, out.B_hollow, not_computed,
                           "corrected: 4/3 and 6.40; B is the outer side", out.B_hollow_printed < out.B_hollow});
  r.comparisons.push_back({"tube, table", "D_tube", mm, out.D_tube_printed, out.D_tube, not_computed,
                           "corrected: 4/pi and 32/pi in place of 1.27 and 10", out.D_tube_printed < out.D_tube});
  r.comparisons.push_back({"moment, ropes hauled in and paid out, (2), (3)", "M", si::N_m, out.M, out.M_payout,
                           not_computed, "the larger, when ropes are paid out under full load", out.M < out.M_payout});
  r.comparisons.push_back({"tube, ropes hauled in and paid out", "D_tube", mm, out.D_tube, out.D_tube_payout,
                           not_computed, "the larger, when ropes are paid out under full load",
                           out.D_tube < out.D_tube_payout});
}

void add_warnings(const Input& in, const Output& out, Result& r) {
  auto& w = r.warnings;
  w.emplace_back(
      "guylines and buckling are not in this method: their forces add to N, and a slender mast fails by buckling "
      "first; check both, and local buckling of thin walls, before building");
  w.push_back(
      fmt::format("the tube by the printed coefficients 1.27 and 10 ({:.1f} mm) is {:.1f} % too small: build by D_tube "
                  "{:.1f} mm",
                  out.D_tube_printed * 1e3, (1 - out.D_tube_printed / out.D_tube) * 100, out.D_tube * 1e3));
  if (out.D_tube_payout > out.D_tube) {
    w.push_back(fmt::format(
        "a rope paid out under its full force bends the mast more: M {:.1f} kN m instead of {:.1f} kN m, tube "
        "{:.1f} mm instead of {:.1f} mm; build by the larger unless the brake slips before that",
        out.M_payout / 1e3, out.M / 1e3, out.D_tube_payout * 1e3, out.D_tube * 1e3));
  }
  if (in.wrap == Wrap::paper && out.alpha < 30 * degree) {
    w.push_back(fmt::format(
        "the paper's wrap of 120 deg belongs to alpha = 30 deg; at {:.1f} deg it understates the forces: take "
        "wrap: geometric",
        out.alpha / degree));
  }
  if (in.block_friction < 0.10 || in.block_friction > 0.16) {
    w.push_back(fmt::format("block friction {:.3g} lies outside the paper's 0.10 to 0.16", in.block_friction));
  }
  if (!in.steel) return;
  const auto at_wall = allowable_stress(limit_of(in), out.t_tube);
  if (!at_wall) {
    w.push_back(fmt::format("the wall of the ideal tube, {:.1f} mm, is thicker than the table of {} reaches",
                            out.t_tube * 1e3, *in.steel));
  } else if (*at_wall < out.sigma_allow) {
    w.push_back(fmt::format(
        "[sigma] = {:.1f} MPa is that of the thinnest range of {}; at the ideal tube's wall of {:.1f} mm it is "
        "{:.1f} MPa: go by the catalogue sections, which are taken at their own wall",
        out.sigma_allow / 1e6, *in.steel, out.t_tube * 1e3, *at_wall / 1e6));
  }
}

void add_assumptions(const Input& in, Result& r) {
  r.assumptions = {
      "The mast is clamped at its foot; guylines neither hold nor load it.",
      "The drum side of each rope runs straight down and carries the rated force; the ropes are hauled in.",
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

}  // namespace

Result run(const Input& in) {
  const Method& m = about();
  Result r = result_of(m, Input::describe(), &in);
  Output out;
  Sheet<Num> s(m.short_source, Input::describe(), &in);
  const Outcome outcome = compute(in, s, out);
  s.move_to(r);
  r.status = outcome.status;
  r.message = outcome.message;
  add_assumptions(in, r);
  std::vector<Position> positions;
  if (in.span) {
    positions = sweep(in);
    r.tables.push_back(positions_table(positions, out));
  }
  if (outcome.ok()) {
    std::vector<ClampForces> forces;
    for (const Position& p : positions) {
      if (p.outcome.ok()) forces.push_back({p.out.N, p.out.M, p.index});
    }
    if (!positions.empty() && forces.size() < positions.size()) {
      r.warnings.push_back(fmt::format("{} of {} carriage positions lie outside the method: see the table of positions",
                                       positions.size() - forces.size(), positions.size()));
    }
    if (forces.empty()) forces.push_back({out.N, out.M, 0});
    add_warnings(in, out, r);
    const auto section = find_sections(in, forces, r);
    if (section) check_section(in, *section, s, r, out);
    add_comparisons(in, out, r);
    add_figures(in, out, positions, section, r);
  }
  r.values = values_of(Output::describe(), &out);
  return r;
}

}  // namespace taut::mast_section
