#include "taut/methods/mast_section/tables.hpp"

#include <algorithm>

namespace taut::mast_section {
namespace {

/// One carriage position.
struct PositionRow {
  const Position& position;
  bool governs;
};

const Quantities<PositionRow>& position_quantities() {
  using Row = PositionRow;
  const auto of = [](double Output::*part) { return [part](const Row& r) { return r.position.out.*part; }; };
  const Unit mm = si::m.in("mm");
  static const Quantities<Row> all = {
      {"x", "x", si::m, "carriage position, horizontal from the mast", of(&Output::x)},
      {"f_x", "f_x", si::m, "sag of the skyline at the carriage, (11)", of(&Output::f_x)},
      {"alpha", "alpha", si::rad, "angle of the span side of the ropes below the horizontal, (10)", of(&Output::alpha)},
      {"wrap", "epsilon", si::rad, "wrap angle of the rope on its block", of(&Output::wrap)},
      {"R_sky", "R_sky", si::N, "resultant on the skyline block, (4), (5)", of(&Output::R_sky)},
      {"R_main", "R_main", si::N, "resultant on the mainline block, (4), (6)", of(&Output::R_main)},
      {"N", "N", si::N, "axial force at the clamp, compression positive", of(&Output::N)},
      {"M", "M", si::N_m, "bending moment at the clamp, towards the span", of(&Output::M)},
      {"Q", "Q", si::N, "shear at the clamp, towards the span", of(&Output::Q)},
      {"b_square", "b_square", mm, "side of the solid square, (15), (16)", of(&Output::b_square)},
      {"B_hollow", "B_hollow", mm, "outer side of the hollow square, twice the inner one", of(&Output::B_hollow)},
      {"D_tube", "D_tube", mm, "outer diameter of the tube, ropes hauled in only", of(&Output::D_tube)},
      {"D_tube_printed", "D_tube_printed", mm, "the same with the paper's 1.27 and 10, too small",
       of(&Output::D_tube_printed)},
      {"D_tube_payout", "D_tube_payout", mm, "outer diameter of the tube for ropes paid out under load",
       of(&Output::D_tube_payout)},
      {"D_tube_mixed", "D_tube_mixed", mm, "the same with one rope hauled in and the other paid out",
       of(&Output::D_tube_mixed)},
      {"D_tube_rest", "D_tube_rest", mm, "the same with at least one rope at rest", of(&Output::D_tube_rest)},
      {"governs", "", si::one, "governs: the values of the result are those of this position",
       [](const Row& r) { return std::string(r.governs ? "governs" : ""); }},
      {"reason", "", si::one, "why the position lies outside the method; empty: it does not",
       [](const Row& r) { return r.position.outcome.message; }}};
  return all;
}

/// One load case.
struct LoadCase {
  const Input& in;
  const ClampForces& f;
};

const Quantities<LoadCase>& load_case_quantities() {
  using Row = LoadCase;
  const auto of = [](double ClampForces::*part) { return [part](const Row& r) { return r.f.*part; }; };
  static const Quantities<Row> all = {
      {"x", "x", si::m, "carriage position, where the span is given",
       [](const Row& r) {
         return r.in.span && !r.f.put_up ? r.in.span->carriage_position.at(r.f.index) : not_computed;
       }},
      {"directions", "", si::one,
       "whether each rope is hauled in, paid out, at rest or slack; or the guys put up without a load",
       [](const Row& r) { return direction_words(r.f); }},
      {"sky_across", "", si::N, "force on the skyline block, towards the span",
       [](const Row& r) { return r.f.skyline.across; }},
      {"sky_down", "", si::N, "force on the skyline block, downwards", [](const Row& r) { return r.f.skyline.down; }},
      {"main_across", "", si::N, "force on the mainline block, towards the span",
       [](const Row& r) { return r.f.mainline.across; }},
      {"main_down", "", si::N, "force on the mainline block, downwards",
       [](const Row& r) { return r.f.mainline.down; }},
      {"sideways", "", si::N, "force across the span at the skyline block", of(&ClampForces::lateral)},
      {"N", "N", si::N, "axial force at the clamp of the method's mast", of(&ClampForces::N)},
      {"M", "M", si::N_m, "bending moment at the clamp of the method's mast", of(&ClampForces::M)}};
  return all;
}

const Quantities<SectionLine>& section_quantities() {
  using Row = SectionLine;
  using catalogue::SectionRow;
  const auto of = [](double SectionRow::*part) { return [part](const Row& r) { return r.of.section.*part; }; };
  const Unit mm = si::m.in("mm");
  static const Quantities<Row> all = {
      {"shape", "", si::one, "CHS, SHS or RHS: circular, square, rectangular hollow section",
       [](const Row& r) { return std::string(to_text(r.of.section.shape)); }},
      {"name", "", si::one, "name of the section in the catalogue", [](const Row& r) { return r.of.section.name; }},
      {"standard", "", si::one, "its standard", [](const Row& r) { return r.of.section.standard; }},
      {"forming", "", si::one, "hot-finished or cold-formed; GOST: seamless or welded",
       [](const Row& r) { return std::string(to_text(r.of.section.forming)); }},
      {"height", "h", mm, "outer height; of a tube its outer diameter", of(&SectionRow::height)},
      {"width", "b", mm, "outer width", of(&SectionRow::width)},
      {"wall", "t", mm, "wall thickness", of(&SectionRow::thickness)},
      {"height/wall", "h/t", si::one, "slenderness of the wall",
       [](const Row& r) { return r.of.section.height / r.of.section.thickness; }},
      {"area", "A", si::m2, "cross-sectional area", of(&SectionRow::area)},
      {"W", "W", si::m3, "elastic section modulus about the strong axis", of(&SectionRow::W_el_y)},
      {"mass", "m", si::kg_per_m, "mass per metre", of(&SectionRow::mass_per_length)},
      {"mass of the mast", "", si::kg, "mass of a mast as high as the higher block",
       [](const Row& r) { return r.of.section.mass_per_length * r.height; }},
      {"stress", "sigma", si::Pa, "largest stress N/A + M/W, (12)-(14)", [](const Row& r) { return r.of.stress; }},
      {"stress by second order", "", si::Pa, "the same with the moments of the mast's own deflection",
       [](const Row& r) { return r.of.second_order.value_or(not_computed); }},
      {"allowable", "[sigma]", si::Pa, "allowable stress at its wall", [](const Row& r) { return r.of.allowable; }},
      {"utilisation", "", si::one, "the larger stress over the allowable one",
       [](const Row& r) { return r.of.utilisation(); }},
      {"trust", "", si::one, "trust in its row of the catalogue",
       [](const Row& r) { return std::string(to_text(r.of.section.trust)); }},
      {"use", "", si::one, "given, lightest of its shape that passes, or nearest to passing", &Row::use}};
  return all;
}

}  // namespace

double height_of(const Input& in) { return std::max(in.skyline_block_height, in.mainline_block_height.value_or(0)); }

Table positions_table(const std::vector<Position>& positions, const Output& governing) {
  std::vector<PositionRow> rows;
  rows.reserve(positions.size());
  for (const Position& p : positions) {
    rows.push_back({.position = p, .governs = p.outcome.ok() && p.out.x == governing.x});
  }
  return make_table("positions", "Carriage positions", position_quantities(), rows);
}

Table load_cases_table(const Input& in, const std::vector<ClampForces>& forces) {
  std::vector<LoadCase> rows;
  rows.reserve(forces.size());
  for (const ClampForces& f : forces) rows.push_back({.in = in, .f = f});
  Table t = make_table("load_cases", "What the mast must carry", load_case_quantities(), rows);
  t.detail = true;
  return t;
}

Table sections_table(const std::vector<SectionLine>& lines) {
  return make_table("sections", "Catalogue sections, RHS about the strong axis", section_quantities(), lines);
}

std::vector<TableWords> table_words() {
  return {{.name = "positions", .rows = "every carriage position", .columns = words_of(position_quantities())},
          {.name = "load_cases",
           .rows = "each rope hauled in, paid out and at rest, at every carriage position; with wrap: paper by the "
                   "geometric wrap too; with guys each rope alone, the same without the side force, and the mast "
                   "without a load",
           .columns = words_of(load_case_quantities())},
          {.name = "sections",
           .rows = "the section given, or the lightest of each shape that passes",
           .columns = words_of(section_quantities())}};
}

}  // namespace taut::mast_section
