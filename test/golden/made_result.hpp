#pragma once
// A result made up for the report's tests: every part of a Result is used once, with numbers that are worked out here
// and nowhere claimed to be a published calculation.

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "taut/calc/comparison.hpp"
#include "taut/calc/num.hpp"
#include "taut/calc/result.hpp"
#include "taut/calc/sheet.hpp"

namespace taut_test {

struct MadeInput {
  double skyline_force = 100e3;
  double mainline_force = 40e3;
  double block_height = 8;
  double block_friction = 0.12;
  double branch_angle = 12 * std::numbers::pi / 180;
  double allowable_stress = 160e6;
  std::string wrap = "paper";
  std::vector<double> positions{20, 60, 100};

  static const taut::Description& describe() {
    using namespace taut;
    static const Description d =
        Describe<MadeInput>()
            .field(&MadeInput::skyline_force, "skyline_force", "T_sky", si::N, "largest force in the skyline")
            .required()
            .field(&MadeInput::mainline_force, "mainline_force", "T_main", si::N, "largest force in the mainline")
            .required()
            .field(&MadeInput::block_height, "skyline_block_height", "h", si::m, "height of the blocks above the clamp")
            .required()
            .field(&MadeInput::block_friction, "block_friction", "f", si::one, "friction of the rope blocks")
            .field(&MadeInput::branch_angle, "branch_angle", "alpha", si::rad, "branch below the horizontal")
            .field(&MadeInput::allowable_stress, "allowable_stress", "[sigma]", si::Pa, "allowable stress of the mast")
            .field(&MadeInput::wrap, "wrap", "wrap angle on the blocks")
            .field(&MadeInput::positions, "span.carriage_position", "x", si::m, "carriage positions");
    return d;
  }
};

inline void add_steps(taut::Result& r, const MadeInput& in) {
  using namespace taut;
  Sheet<Num> s("Shoshin et al. 2022", MadeInput::describe(), &in);
  s.section("Forces on the blocks");
  const Num t_sky = s.given(in.skyline_force);
  const Num t_main = s.given(in.mainline_force);
  const Num f = s.given(in.block_friction);
  const Num alpha = s.given(in.branch_angle);
  const Num eps = s.eq("", "epsilon", si::rad, Num(2 * std::numbers::pi / 3), "the paper's constant wrap, p. 4");
  const Num beta = s.eq("7", "beta", si::rad, Num(std::numbers::pi) / 2 + alpha);
  const auto block = [&](const char* no, const char* symbol, const Num& t) {
    return s.eq(no, symbol, si::N, t * sqrt(exp(-2 * f * eps) + 1 - 2 * cos(beta) * exp(-(f * eps))));
  };
  const Num r_sky = block("4", "R_sky", t_sky);
  const Num r_main = block("5", "R_main", t_main);
  s.note("The printed (9) subtracts alpha; the vector sum adds it, so gamma_sky below follows the vector sum.");
  const Num gamma = s.eq("8*", "gamma_sky", si::rad, alpha + asin(t_sky * sin(beta) / r_sky));
  s.section("Internal forces at the clamp");
  const Num h = s.given(in.block_height);
  const Num n = s.eq("fig. 7", "N", si::N, r_sky * sin(gamma) + r_main * sin(gamma));
  const Num m = s.eq("fig. 7", "M", si::N_m, (r_sky + r_main) * h * cos(gamma));
  s.section("Section");
  const Num allow = s.given(in.allowable_stress);
  const auto b = s.root(
      "16", "b", si::m.in("mm"), [&](const Num& x) { return allow * pow(x, 3) - n * x - 6 * m; }, 0.0, 3.0);
  const Num w = s.eq("", "W", si::m3, pow(*b, 3) / 6, "bending of a square");
  const Num sigma = s.eq("12", "sigma_max", si::Pa, n / pow(*b, 2) + m / w);
  s.check(
      "stress at the clamp", sigma, si::Pa,
      {.sense = Sense::at_most, .limit = allow * 1.05, .rule = "N/A + M/W <= 1.05 [sigma], (12)", .trust = "verified"});
  s.check("drum D/d", s.named("q", si::one, 18), si::one,
          {.sense = Sense::at_least,
           .limit = Num(20),
           .rule = "smallest ratio of drum to rope diameter, ISO 16625 table 2",
           .trust = "UNVERIFIED: read from a secondary source"});
  s.check("rope safety", s.named("S", si::one, 4.6), si::one,
          {.sense = Sense::at_least, .limit = Num(3.5), .rule = "OR-OSHA rope factor", .trust = "user"});
  s.warn("block_friction is outside 0.10..0.16 <script>alert('x')</script>");
  s.warn("The printed D_tube is 0.6 % too small: the paper rounds 32/pi to 10. Build by the exact coefficients.");
  s.move_to(r);
}

inline taut::Drawing made_mast(double r, double gamma) {
  using namespace taut;
  Drawing d{.name = "mast",
            .title = "Mast with the resultants of its blocks",
            .caption = "Branches leave under alpha; the drums stand at the foot.",
            .shapes = {}};
  d.shapes.emplace_back(Polyline{.points = {{.x = -5, .y = 0}, {.x = 14, .y = 0}}, .role = Role::ground});
  d.shapes.emplace_back(
      Polyline{.points = {{.x = -0.16, .y = 0}, {.x = 0.16, .y = 0}, {.x = 0.16, .y = 8}, {.x = -0.16, .y = 8}},
               .role = Role::structure,
               .closed = true,
               .filled = true});
  d.shapes.emplace_back(
      Circle{.center = {.x = 0, .y = 8}, .radius = 0.35, .role = Role::body, .from = 0, .to = 0, .filled = true});
  d.shapes.emplace_back(
      Polyline{.points = {{.x = 0.1, .y = 8.33}, {.x = 13, .y = 8.33 - 12.9 * std::tan(0.2094)}}, .role = Role::rope});
  d.shapes.emplace_back(Polyline{.points = {{.x = -0.35, .y = 8}, {.x = -0.35, .y = 0.6}}, .role = Role::rope});
  d.shapes.emplace_back(Polyline{.points = {{.x = 0.1, .y = 7.6}, {.x = 13, .y = 7.6 - 12.9 * std::tan(0.25)}},
                                 .role = Role::second_rope});
  d.shapes.emplace_back(
      Circle{.center = {.x = -0.8, .y = 0.6}, .radius = 0.45, .role = Role::body, .from = 0, .to = 0, .filled = true});
  d.shapes.emplace_back(
      ForceArrow{.at = {.x = 0, .y = 8}, .fx = r * std::cos(gamma), .fy = -r * std::sin(gamma), .label = "R_sky"});
  d.shapes.emplace_back(ForceArrow{.at = {.x = 0, .y = 8},
                                   .fx = 0.4 * r * std::cos(gamma),
                                   .fy = -0.4 * r * std::sin(gamma),
                                   .label = "R_main",
                                   .role = Role::second_force});
  d.shapes.emplace_back(ForceArrow{.at = {.x = 13, .y = 8.33 - 12.9 * std::tan(0.2094)},
                                   .fx = 1e5 * std::cos(0.2094),
                                   .fy = -1e5 * std::sin(0.2094),
                                   .label = "T_sky"});
  d.shapes.emplace_back(
      ForceArrow{.at = {.x = 0, .y = 0}, .fx = 0, .fy = 162e3, .label = "N", .role = Role::force, .towards = true});
  d.shapes.emplace_back(
      DimensionLine{.from = {.x = -0.16, .y = 0}, .to = {.x = -0.16, .y = 8}, .offset = 2.2, .text = "h = 8 m"});
  d.shapes.emplace_back(
      AngleMark{.center = {.x = 0.1, .y = 8.33}, .radius = 3, .from = 0, .to = -0.2094, .text = "alpha"});
  d.shapes.emplace_back(Polyline{.points = {{.x = 0.1, .y = 8.33}, {.x = 4, .y = 8.33}}, .role = Role::axis});
  d.shapes.emplace_back(Label{.at = {.x = -0.8, .y = 0.6}, .text = "drum"});
  d.shapes.emplace_back(Label{.at = {.x = 0, .y = 8}, .text = "blocks"});
  return d;
}

inline taut::Plot made_plot() {
  using namespace taut;
  Plot p{.name = "positions",
         .title = "Mast size against carriage position",
         .caption = "The worst position governs.",
         .x = {.label = "carriage position x", .unit = si::m},
         .y = {.label = "side of the section", .unit = si::m.in("mm")},
         .curves = {},
         .marks = {}};
  Curve solid{.label = "solid square b", .x = {}, .y = {}};
  Curve tube{.label = "tube D_tube", .x = {}, .y = {}, .dashed = true};
  for (int i = 0; i <= 40; ++i) {
    const double x = 5.0 * i;
    solid.x.push_back(x);
    tube.x.push_back(x);
    solid.y.push_back(0.31 + 0.02 * std::sin(x / 60));
    tube.y.push_back(i > 15 && i < 19 ? NAN : 0.5 + 0.05 * std::sin(x / 60));
  }
  p.curves = {solid, tube};
  p.marks = {{.x = 95, .y = 0.33, .label = "governs", .whole_line = false},
             {.x = 0, .y = 0.4, .label = "largest tube in stock", .whole_line = true}};
  return p;
}

/// Everything a report can show, failing one check.
inline taut::Result made_result() {
  using namespace taut;
  const MadeInput in;
  Result r;
  r.title = "Mast of a tractor yarder \"K-1\" & <friends>";
  r.method = "mast_section";
  r.method_title = "Mast section of a tractor-mounted cable yarder";
  r.source = "Shoshin, Dorozhko, Shtollmann, Yarmolik (2022), Section of the mast of a cable yarder";
  r.given = given_of(MadeInput::describe(), &in);
  add_steps(r, in);
  r.values = {{.name = "R_sky",
               .value = 138864.558,
               .unit = si::N,
               .symbol = "R_sky",
               .label = "resultant on the skyline block",
               .source = "(4)"},
              {.name = "gamma_sky",
               .value = 0.990985,
               .unit = si::rad,
               .symbol = "gamma_sky",
               .label = "resultant below the horizontal",
               .source = "(8)"},
              {.name = "M",
               .value = 852064.180,
               .unit = si::N_m,
               .symbol = "M",
               .label = "bending moment at the clamp",
               .source = "fig. 7"},
              {.name = "b_square",
               .value = 0.3183905,
               .unit = si::m.in("mm"),
               .symbol = "b",
               .label = "side of the solid square",
               .source = "(16)"},
              {.name = "k",
               .value = 1.234e-9,
               .unit = si::m_per_N,
               .symbol = "k_1",
               .label = "compliance of the guyed head",
               .source = ""}};
  r.comparisons = {{.quantity = "tube diameter",
                    .symbol = "D_tube",
                    .unit = si::m.in("mm"),
                    .printed = 0.5412163,
                    .corrected = 0.5445087,
                    .exact = std::numeric_limits<double>::quiet_NaN(),
                    .build_by = "corrected: 32/pi instead of 10",
                    .printed_unsafe = true},
                   {.quantity = "hollow square",
                    .symbol = "B_hollow",
                    .unit = si::m.in("mm"),
                    .printed = 0.3257,
                    .corrected = 0.3256166,
                    .exact = std::numeric_limits<double>::quiet_NaN(),
                    .build_by = "either",
                    .printed_unsafe = false}};
  Table positions{.name = "positions",
                  .title = "Worst carriage position",
                  .columns = {{.name = "x", .unit = si::m},
                              {.name = "alpha", .unit = si::rad},
                              {.name = "N", .unit = si::N},
                              {.name = "b_square", .unit = si::m.in("mm")},
                              {.name = "note", .unit = si::one}},
                  .rows = {}};
  for (int i = 0; i < 70; ++i) {
    positions.rows.push_back({3.0 * i, 0.2 + 0.001 * i, 160e3 + 17 * i, i == 3 ? NAN : 0.318 + 1e-5 * i,
                              std::string(i == 7 ? "governs" : "")});
  }
  r.tables = {positions, comparison_table(r.comparisons)};
  r.figures = {made_mast(138864.558, 0.990985), made_plot()};
  Drawing polygon{
      .name = "forces", .title = "Force polygon at the skyline block", .caption = "", .shapes = {}, .unit = si::N};
  polygon.shapes = {
      ForceArrow{.at = {.x = 0, .y = 0}, .fx = 97814, .fy = -20791, .label = "T_sky"},
      ForceArrow{.at = {.x = 97814, .y = -20791}, .fx = 0, .fy = -77777, .label = "F_span_sky"},
      ForceArrow{.at = {.x = 0, .y = 0}, .fx = 97814, .fy = -98568, .label = "R_sky", .role = Role::second_force}};
  r.figures.emplace_back(polygon);
  r.assumptions = {"The mast is clamped at its foot; guylines are left out.",
                   "Friction acts so that the drum side is the larger."};
  r.deck_name = "mast.yaml";
  r.deck_hash = "sha256:0123456789abcdef";
  r.display = {{"force", "kN"}};
  return r;
}

}  // namespace taut_test
