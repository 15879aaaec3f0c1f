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
  s.check("stress at the clamp", sigma, si::Pa,
          {Sense::at_most, allow * 1.05, "N/A + M/W <= 1.05 [sigma], (12)", "verified"});
  s.check("drum D/d", s.named("q", si::one, 18), si::one,
          {Sense::at_least, Num(20), "smallest ratio of drum to rope diameter, ISO 16625 table 2",
           "UNVERIFIED: read from a secondary source"});
  s.check("rope safety", s.named("S", si::one, 4.6), si::one,
          {Sense::at_least, Num(3.5), "OR-OSHA rope factor", "user"});
  s.warn("block_friction is outside 0.10..0.16 <script>alert('x')</script>");
  s.warn("The printed D_tube is 0.6 % too small: the paper rounds 32/pi to 10. Build by the exact coefficients.");
  s.move_to(r);
}

inline taut::Drawing made_mast(double r, double gamma) {
  using namespace taut;
  Drawing d{
      "mast", "Mast with the resultants of its blocks", "Branches leave under alpha; the drums stand at the foot.", {}};
  d.shapes.emplace_back(Polyline{{{-5, 0}, {14, 0}}, Role::ground});
  d.shapes.emplace_back(Polyline{{{-0.16, 0}, {0.16, 0}, {0.16, 8}, {-0.16, 8}}, Role::structure, true, true});
  d.shapes.emplace_back(Circle{{0, 8}, 0.35, Role::body, 0, 0, true});
  d.shapes.emplace_back(Polyline{{{0.1, 8.33}, {13, 8.33 - 12.9 * std::tan(0.2094)}}, Role::rope});
  d.shapes.emplace_back(Polyline{{{-0.35, 8}, {-0.35, 0.6}}, Role::rope});
  d.shapes.emplace_back(Polyline{{{0.1, 7.6}, {13, 7.6 - 12.9 * std::tan(0.25)}}, Role::second_rope});
  d.shapes.emplace_back(Circle{{-0.8, 0.6}, 0.45, Role::body, 0, 0, true});
  d.shapes.emplace_back(ForceArrow{{0, 8}, r * std::cos(gamma), -r * std::sin(gamma), "R_sky"});
  d.shapes.emplace_back(
      ForceArrow{{0, 8}, 0.4 * r * std::cos(gamma), -0.4 * r * std::sin(gamma), "R_main", Role::second_force});
  d.shapes.emplace_back(
      ForceArrow{{13, 8.33 - 12.9 * std::tan(0.2094)}, 1e5 * std::cos(0.2094), -1e5 * std::sin(0.2094), "T_sky"});
  d.shapes.emplace_back(ForceArrow{{0, 0}, 0, 162e3, "N", Role::force, true});
  d.shapes.emplace_back(DimensionLine{{-0.16, 0}, {-0.16, 8}, 2.2, "h = 8 m"});
  d.shapes.emplace_back(AngleMark{{0.1, 8.33}, 3, 0, -0.2094, "alpha"});
  d.shapes.emplace_back(Polyline{{{0.1, 8.33}, {4, 8.33}}, Role::axis});
  d.shapes.emplace_back(Label{{-0.8, 0.6}, "drum"});
  d.shapes.emplace_back(Label{{0, 8}, "blocks"});
  return d;
}

inline taut::Plot made_plot() {
  using namespace taut;
  Plot p{"positions",
         "Mast size against carriage position",
         "The worst position governs.",
         {"carriage position x", si::m},
         {"side of the section", si::m.in("mm")},
         {},
         {}};
  Curve solid{"solid square b", {}, {}};
  Curve tube{"tube D_tube", {}, {}, true};
  for (int i = 0; i <= 40; ++i) {
    const double x = 5.0 * i;
    solid.x.push_back(x);
    tube.x.push_back(x);
    solid.y.push_back(0.31 + 0.02 * std::sin(x / 60));
    tube.y.push_back(i > 15 && i < 19 ? NAN : 0.5 + 0.05 * std::sin(x / 60));
  }
  p.curves = {solid, tube};
  p.marks = {{95, 0.33, "governs", false}, {0, 0.4, "largest tube in stock", true}};
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
  r.values = {{"R_sky", 138864.558, si::N, "R_sky", "resultant on the skyline block", "(4)"},
              {"gamma_sky", 0.990985, si::rad, "gamma_sky", "resultant below the horizontal", "(8)"},
              {"M", 852064.180, si::N_m, "M", "bending moment at the clamp", "fig. 7"},
              {"b_square", 0.3183905, si::m.in("mm"), "b", "side of the solid square", "(16)"},
              {"k", 1.234e-9, si::m_per_N, "k_1", "compliance of the guyed head", ""}};
  r.comparisons = {{"tube diameter", "D_tube", si::m.in("mm"), 0.5412163, 0.5445087,
                    std::numeric_limits<double>::quiet_NaN(), "corrected: 32/pi instead of 10", true},
                   {"hollow square", "B_hollow", si::m.in("mm"), 0.3257, 0.3256166,
                    std::numeric_limits<double>::quiet_NaN(), "either", false}};
  Table positions{"positions",
                  "Worst carriage position",
                  {{"x", si::m}, {"alpha", si::rad}, {"N", si::N}, {"b_square", si::m.in("mm")}, {"note", si::one}},
                  {}};
  for (int i = 0; i < 70; ++i) {
    positions.rows.push_back({3.0 * i, 0.2 + 0.001 * i, 160e3 + 17 * i, i == 3 ? NAN : 0.318 + 1e-5 * i,
                              std::string(i == 7 ? "governs" : "")});
  }
  r.tables = {positions, comparison_table(r.comparisons)};
  r.figures = {made_mast(138864.558, 0.990985), made_plot()};
  Drawing polygon{"forces", "Force polygon at the skyline block", "", {}, si::N};
  polygon.shapes = {ForceArrow{{0, 0}, 97814, -20791, "T_sky"}, ForceArrow{{97814, -20791}, 0, -77777, "F_span_sky"},
                    ForceArrow{{0, 0}, 97814, -98568, "R_sky", Role::second_force}};
  r.figures.emplace_back(polygon);
  r.assumptions = {"The mast is clamped at its foot; guylines are left out.",
                   "Friction acts so that the drum side is the larger."};
  r.deck_name = "mast.yaml";
  r.deck_hash = "sha256:0123456789abcdef";
  r.display = {{"force", "kN"}};
  return r;
}

}  // namespace taut_test
