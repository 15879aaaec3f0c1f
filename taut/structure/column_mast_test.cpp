#include "taut/structure/column_mast.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "taut/catalogue/section_search.hpp"
#include "taut/structure/mast_sizing.hpp"

namespace taut::structure::column_mast_test {

ColumnMast cantilever(const char* name, double height, double down, double across) {
  ColumnMast m;
  m.pieces = {{.length = height,
               .section = *catalogue::find_section(name),
               .top = {},
               .yield = 355e6,
               .allowable_stress = 160e6}};
  m.combinations = {
      {.words = "work",
       .loads = {{.height = height, .down = down, .across_y = across, .across_z = 0, .moment_y = 0, .moment_z = 0}},
       .factors = {1.0}}};
  return m;
}

// Spec case A. Without imperfections: H tan(kL)/k = 871.3685 kN m at the clamp.
TEST(ColumnMast, CaseAWithoutImperfections) {
  ColumnMast given = cantilever("CHS 508x16", 8, 162638.979, 106508.0225);
  given.sway = given.bow = 0;
  const auto r = column_mast(given);
  EXPECT_EQ(r.refused, "");
  EXPECT_NEAR(r.critical_factor, 6064756 / 162638.979, 1e-3);
  const MastUse u = mast_use(r.mast, r.cases);
  EXPECT_NEAR(u.member.value, 0.608284, 1e-5);
  EXPECT_NEAR(u.flexural.value, 0.0350853, 1e-6);
  EXPECT_NEAR(u.section.value, 871368.54 / 1373846, 1e-5);
  EXPECT_NEAR(u.stress.value, 295492555, 1500);
  EXPECT_NEAR(u.stress_use.value, 295492555.0 / 160e6, 1e-5);
  EXPECT_EQ(r.cases[u.section.at.load_case].stations[u.section.at.station].height, 0);
}

// phi = 2/sqrt(8)/200: (H + N phi) tan(kL)/k; no bow, as lambda of the pinned column 0.6016 < 0.5 sqrt(A f_y/N) = 3.67.
TEST(ColumnMast, CaseALeaning) {
  const auto r = column_mast(cantilever("CHS 508x16", 8, 162638.979, 106508.0225));
  EXPECT_NEAR(r.sway, 0.00353553, 1e-8);
  EXPECT_EQ(r.bow, 0);
  const double M = 871368.54 * (1 + 162638.979 * 0.0035355339 / 106508.0225);
  EXPECT_NEAR(mast_use(r.mast, r.cases).section.value, M / 1373846, 1e-5);
}

TEST(ColumnMast, FactorsEnterBeforeTheBendingDoes) {
  ColumnMast given = cantilever("CHS 508x16", 8, 162638.979, 106508.0225);
  given.sway = given.bow = 0;
  given.combinations[0].factors = {1.4};
  const auto r = column_mast(given);
  const double k = std::sqrt(1.4 * 162638.979 / (210e9 * 7.490904e-4));
  const double M = 1.4 * 106508.0225 * std::tan(8 * k) / k;
  EXPECT_NEAR(r.cases[0].stations[0].design.M_y, M, 1);
  EXPECT_NEAR(r.cases[0].stations[0].service.M_y, 852064.18, 0.01);
  EXPECT_NEAR(mast_use(r.mast, r.cases).stress.value, 295492555, 1500);  // the paper's: no factors
}

// What turns the mast at 4 m turns all below, with its factor, and nothing above.
TEST(ColumnMast, TorsionGoesDownToTheFoot) {
  ColumnMast given = cantilever("CHS 508x16", 8, 162638.979, 106508.0225);
  given.sway = given.bow = 0;
  given.combinations[0].loads[0].torsion = -20e3;
  given.combinations[0].loads.push_back({.height = 4, .torsion = 90e3});
  given.combinations[0].factors = {1.4, 1.5};
  const auto r = column_mast(given);
  const double above = -1.4 * 20e3, below = above + 1.5 * 90e3;
  for (const MastStation& s : r.cases[0].stations) {
    const double at = s.part == 0 ? below : above;
    EXPECT_DOUBLE_EQ(s.design.torsion, at) << s.height;
    EXPECT_DOUBLE_EQ(s.member.torsion, at) << s.height;
    EXPECT_DOUBLE_EQ(s.service.torsion, s.part == 0 ? 70e3 : -20e3) << s.height;
  }
  const catalogue::SectionRow& tube = given.pieces[0].section;
  const double T_Rd =
      2 * std::acos(-1.0) / 4 * std::pow(tube.height - tube.thickness, 2) * tube.thickness * 355e6 / std::sqrt(3.0);
  EXPECT_NEAR(mast_use(r.mast, r.cases).torsion.value, below / T_Rd, 1e-9);
}

// Held at its top, bowed, with a load halfway up a third: the worst section is between the places where something is.
TEST(ColumnMast, WorstSectionBetweenItsPlaces) {
  ColumnMast given = cantilever("SHS 250x10", 12, 900e3, 0);
  given.top_stiffness = std::numeric_limits<double>::infinity();
  given.bow = 1.0 / 300;
  given.combinations[0].loads.push_back({4, 50e3, 15e3, 0, 0, 0});
  given.combinations[0].factors.push_back(1.35);
  const auto r = column_mast(given);
  ColumnMast finer = given;
  for (double h = 0.25; h < 12; h += 0.25) {  // nothing there, but a place to look at
    finer.combinations[0].loads.push_back({h, 0, 0, 0, 0, 0});
    finer.combinations[0].factors.push_back(1);
  }
  const auto f = column_mast(finer);
  EXPECT_NEAR(mast_use(r.mast, r.cases).section.value / mast_use(f.mast, f.cases).section.value, 1, 1e-5);
}

// A piece in two of the same section is one member, wherever it is cut and wherever loads act on it.
RC_GTEST_PROP(ColumnMast, CutIntoPiecesOfOneSection, ()) {
  const auto share = [](const char* what) { return *rc::gen::inRange(1, 100).as(what) / 100.0; };
  ColumnMast one = cantilever("RHS 300x200x10", 9, 200e3 * share("down"), 8e3 * share("across"));
  one.clamped_base = share("base") < 0.6;
  one.top_stiffness = one.clamped_base && share("free") < 0.4 ? 0 : 3e5 + 3e6 * share("spring");
  one.combinations[0].loads.push_back({9 * share("height"), 50e3, -5e3 * share("side"), 2e3, 0, 0});
  one.combinations[0].factors.push_back(1.35);
  ColumnMast two = one;
  two.pieces.push_back(two.pieces[0]);
  two.pieces[0].length = 9 * share("cut");
  two.pieces[1].length = 9 - two.pieces[0].length;
  const auto a = column_mast(one), b = column_mast(two);
  RC_PRE(a.refused.empty() && b.refused.empty());
  const MastUse u = mast_use(a.mast, a.cases), v = mast_use(b.mast, b.cases);
  RC_ASSERT(std::abs(v.member.value / u.member.value - 1) < 1e-3);
  RC_ASSERT(std::abs(v.flexural.value / u.flexural.value - 1) < 1e-3);
  RC_ASSERT(std::abs(v.section.value / u.section.value - 1) < 1e-3);
}

// Loads a hair apart are as good as one: short slices must not spoil the critical load.
TEST(ColumnMast, LoadsNearlyAtOnePlace) {
  const auto use = [](const std::vector<MastLoad>& loads) {
    ColumnMast m = cantilever("CHS 323.9x10", 42, 5e3, 10e3);
    m.top_stiffness = std::numeric_limits<double>::infinity();
    m.combinations[0].loads.insert(m.combinations[0].loads.end(), loads.begin(), loads.end());
    m.combinations[0].factors.assign(m.combinations[0].loads.size(), 1.35);
    const auto r = column_mast(m);
    return std::pair{r.critical_factor, mast_use(r.mast, r.cases).member.value};
  };
  const auto one = use({{.height = 41, .down = 4e3, .across_y = 1e3, .across_z = 0, .moment_y = 0, .moment_z = 0}});
  // clamped and held: 2.0457 (pi/L)^2 E I = 292.2 kN over 1.35 x 9 kN, of which 4 kN act 1 m lower
  EXPECT_GT(one.first, 292.2e3 / (1.35 * 9e3));
  EXPECT_LT(one.first, 1.05 * 292.2e3 / (1.35 * 9e3));
  for (const double apart : {1e-7, 1e-4, 3e-3, 0.03, 0.05}) {
    const auto two =
        use({{.height = 41, .down = 2e3, .across_y = 500, .across_z = 0, .moment_y = 0, .moment_z = 0},
             {.height = 41 + apart, .down = 2e3, .across_y = 500, .across_z = 0, .moment_y = 0, .moment_z = 0}});
    EXPECT_NEAR(two.first / one.first, 1, 2e-4 + 0.02 * apart) << apart;
    EXPECT_NEAR(two.second / one.second, 1, 3e-3) << apart;
  }
}

TEST(ColumnMast, MirroredAndTurned) {
  for (const char* name : {"CHS 323.9x10", "RHS 300x200x10"}) {
    const auto use = [](const ColumnMast& m) {
      const auto r = column_mast(m);
      return mast_use(r.mast, r.cases).utilisation();
    };
    ColumnMast one = cantilever(name, 6, 100e3, 20e3);
    one.combinations[0].loads[0].across_z = 5e3;
    ColumnMast other = one;
    other.combinations[0].loads[0].across_y = -20e3;
    EXPECT_NEAR(use(one), use(other), 1e-9) << name;
    if (name[0] != 'C') continue;
    other.combinations[0].loads[0].across_y = 5e3;
    other.combinations[0].loads[0].across_z = 20e3;
    EXPECT_NEAR(use(one), use(other), 1e-9);
  }
}

TEST(ColumnMast, SteppedMastHasItsWorstSectionAboveTheStep) {
  ColumnMast m = cantilever("CHS 508x16", 12, 60e3, 25e3);
  m.pieces = {{.length = 6,
               .section = *catalogue::find_section("CHS 508x16"),
               .top = {},
               .yield = 355e6,
               .allowable_stress = {}},
              {.length = 6,
               .section = *catalogue::find_section("CHS 323.9x6.3"),
               .top = {},
               .yield = 355e6,
               .allowable_stress = {}}};
  const auto r = column_mast(m);
  const MastUse u = mast_use(r.mast, r.cases);
  EXPECT_EQ(u.section.at.part, 1U);
  EXPECT_NEAR(r.cases[u.section.at.load_case].stations[u.section.at.station].height, 6, 1e-9);
  // between two uniform masts
  const auto factor = [&](const char* name) { return column_mast(cantilever(name, 12, 60e3, 25e3)).critical_factor; };
  EXPECT_LT(r.critical_factor, factor("CHS 508x16"));
  EXPECT_GT(r.critical_factor, factor("CHS 323.9x6.3"));
}

TEST(ColumnMast, TaperedMast) {
  ColumnMast m = cantilever("CHS 508x16", 10, 100e3, 40e3);
  m.pieces[0].top = *catalogue::find_section("CHS 273x16");
  const auto r = column_mast(m);
  EXPECT_EQ(r.mast.parts.size(), 8U);
  EXPECT_EQ(r.refused, "");
  const MastUse u = mast_use(r.mast, r.cases);
  const auto thick = column_mast(cantilever("CHS 508x16", 10, 100e3, 40e3));
  const auto thin = column_mast(cantilever("CHS 273x16", 10, 100e3, 40e3));
  EXPECT_GT(u.section.value, mast_use(thick.mast, thick.cases).section.value);
  EXPECT_LT(u.section.value, mast_use(thin.mast, thin.cases).section.value);
}

TEST(ColumnMast, HingedMastNeedsItsGuys) {
  ColumnMast m = cantilever("CHS 323.9x10", 10, 200e3, 10e3);
  m.clamped_base = false;
  EXPECT_NE(column_mast(m).refused.find("falls over"), std::string::npos);
  m.top_stiffness = 1e3;
  EXPECT_NE(column_mast(m).refused.find("buckles"), std::string::npos);
  m.top_stiffness = 1e6;
  const auto r = column_mast(m);
  EXPECT_EQ(r.refused, "");
  EXPECT_GT(r.bow, 0);
  EXPECT_NEAR(r.bow, 10.0 / 300, 1e-4);  // pinned: the buckling length is the height
}

/// 8 m, pressed by 130 kN at its top and pulled by `lift` at 2 m.
ColumnMastResult lifted(double lift, double pressed = 130e3) {
  ColumnMast m = cantilever("CHS 219.1x8", 8, pressed, 2e3);
  m.sway = 0.08;
  m.bow = 0;
  m.combinations[0].loads.push_back(
      {.height = 2, .down = -lift, .across_y = 0, .across_z = 0, .moment_y = 0, .moment_z = 0});
  m.combinations[0].factors.push_back(1);
  return column_mast(m);
}

// With a foot without force the column is a cantilever l = 6 m upon a beam a = 2 m: with z the way from its top,
// E I z'' + N z = H (l - x) and z(l) = 0, the moment at 2 m is N tan(kl)/k (turn + phi + H/N), turn = (M a + H
// a^2/2)/EI.
TEST(ColumnMast, APulledFootLeavesTheMastAboveItLeaning) {
  const double H = 2e3, N = 130e3, a = 2, l = 6, phi = 0.08;
  const double EI = 210e9 * catalogue::find_section("CHS 219.1x8")->I_y, k = std::sqrt(N / EI);
  const double bent = N * std::tan(k * l) / k;
  const double M = bent * (H * a * a / (2 * EI) + phi + H / N) / (1 - bent * a / EI) + H * a;
  const ColumnMastResult r = lifted(130e3);
  EXPECT_EQ(r.sway, phi);
  EXPECT_NEAR(r.cases[0].stations[0].design.M_y, M, 1e-6 * M);
  const auto use = [](double lift) {
    const ColumnMastResult one = lifted(lift);
    return mast_use(one.mast, one.cases).section.value;
  };
  EXPECT_GT(use(131e3), 1);
  EXPECT_NEAR(use(129e3), use(131e3), 0.03);
}

// A box of two different I, hinged and held, pressed by 112.5 kN and bent by P l/4 about its strong axis alone. N_cr,
// chi, n and k of each axis are its own: (6.61) n_y + k_yy m_y, (6.62) n_z + 0.6 k_yy m_y, by hand.
TEST(ColumnMast, ABoxHasACriticalForceAboutEachAxis) {
  const double l = 7, N = 112.5e3, f_y = 355e6;
  ColumnMast m = cantilever("RHS 200x100x8", l, N, 0);
  m.clamped_base = false;
  m.top_stiffness = std::numeric_limits<double>::infinity();
  m.combinations[0].loads.push_back(
      {.height = l / 2, .down = 0, .across_y = 18e3, .across_z = 0, .moment_y = 0, .moment_z = 0});
  m.combinations[0].factors.push_back(1);
  const ColumnMastResult r = column_mast(m);
  const auto& box = m.pieces[0].section;
  const auto euler = [&](double I) { return std::pow(std::acos(-1.0) / l, 2) * 210e9 * I; };
  EXPECT_NEAR(r.critical_factor, euler(box.I_z) / N, 1e-4);
  EXPECT_NEAR(r.bow, l / 300, 1e-5);  // curve a, elastic, over the buckling length of either plane
  const auto slenderness = [&](double I) { return std::sqrt(box.area * f_y / euler(I)); };
  const auto share = [&](double I) {
    const double x = slenderness(I), phi = 0.5 * (1 + 0.21 * (x - 0.2) + x * x);
    return N / (box.area * f_y / (phi + std::sqrt(phi * phi - x * x)));
  };
  const double n_y = share(box.I_y), n_z = share(box.I_z), m_y = 18e3 * l / 4 / (box.W_pl_y * f_y);
  const double k_yy = 0.9 * (1 + std::min(slenderness(box.I_y) - 0.2, 0.8) * n_y);
  const MastUse u = mast_use(r.mast, r.cases);
  EXPECT_NEAR(u.flexural.value, n_z, 1e-4);
  EXPECT_NEAR(u.member.value, std::max(n_y + k_yy * m_y, n_z + 0.6 * k_yy * m_y), 1e-4);
  EXPECT_NEAR(u.member.value, 0.587, 1e-3);
}

// By the rule's bow too: its length is that of what is pressed, as for the mast whose whole height is.
TEST(ColumnMast, TheBowIsOfTheSliceThatIsPressedMost) {
  ColumnMast m = cantilever("CHS 219.1x8", 8, 130e3, 0);
  m.bow = 0.01;
  m.combinations[0].loads.push_back(
      {.height = 2, .down = -200e3, .across_y = 0, .across_z = 0, .moment_y = 0, .moment_z = 0});
  m.combinations[0].factors.push_back(1);
  const ColumnMastResult r = column_mast(m);
  const double EI = 210e9 * m.pieces[0].section.I_y;
  EXPECT_NEAR(r.bow, 0.01 * buckling_length(EI, r.critical_factor, 130e3), 1e-9);
}

// Pulled everywhere: the sway of the deck is how it stands; that of the rule, and a bow, are of what is pressed.
TEST(ColumnMast, OfAPulledMastTheGivenSwayCounts) {
  const ColumnMastResult given = lifted(0, -130e3);
  EXPECT_FALSE(given.pressed);
  EXPECT_EQ(given.sway, 0.08);
  EXPECT_EQ(given.bow, 0);
  const double k = std::sqrt(130e3 / (210e9 * catalogue::find_section("CHS 219.1x8")->I_y));
  const double M = std::tanh(8 * k) / k * (130e3 * 0.08 + 2e3);  // against each other, and the other way
  EXPECT_NEAR(std::abs(given.cases[0].stations[0].design.M_y), M, 1e-6 * M);
  EXPECT_EQ(column_mast(cantilever("CHS 219.1x8", 8, -130e3, 2e3)).sway, 0);
}

TEST(ColumnMast, OwnWeight) {
  ColumnMast m = cantilever("CHS 508x16", 8, 0, 10e3);
  m.own_weight = true;
  m.combinations[0].weight_factor = 1.35;
  const auto r = column_mast(m);
  EXPECT_NEAR(r.cases[0].stations[0].design.N, 1.35 * 8 * 9.80665 * m.pieces[0].section.mass_per_length, 1e-3);
  EXPECT_NEAR(r.cases[0].stations[0].service.N, 8 * 9.80665 * m.pieces[0].section.mass_per_length, 1);
}

TEST(ColumnMast, ClassFourIsRefusedWithWords) {
  const auto r = column_mast(cantilever("CHS 508x8", 8, 1e5, 1e4));
  const MastUse u = mast_use(r.mast, r.cases);
  EXPECT_NE(u.refused.find("class 4"), std::string::npos);
  EXPECT_TRUE(std::isinf(u.utilisation()));
  EXPECT_GT(u.slenderness.value, 1);
}

// The lightest by search is the lightest of all that pass when each is tried by itself.
RC_GTEST_PROP(MastSizing, AgreesWithTryingAll, ()) {
  using catalogue::SectionShape;
  catalogue::SectionFilter filter;
  const int shape = *rc::gen::inRange(0, 3);
  filter.shape = shape == 0 ? SectionShape::chs : shape == 1 ? SectionShape::shs : SectionShape::rhs;
  const double height = *rc::gen::inRange(3, 16), yield = *rc::gen::element(235e6, 355e6, 460e6);
  const double down = *rc::gen::inRange(0, 1500) * 1e3, M = *rc::gen::inRange(1, 1500) * 1e3;
  const double side = *rc::gen::inRange(0, 30) / 100.0;
  const auto mast_of = [&](const catalogue::SectionRow& row) -> std::optional<LoadedMast> {
    LoadedMast m;
    m.mast.parts.resize(1);
    m.mast.parts[0].member.steel = {.section = row, .yield = yield, .E = 210e9, .gamma = {}};
    m.mast.parts[0].member.y = m.mast.parts[0].member.z = {.length = 2 * height, .critical_force = {}, .C_m = 0.9};
    const CrossForces f{
        .N = down, .V_y = side * M / height, .V_z = M / height, .M_y = M, .M_z = side * M, .torsion = 0};
    m.cases = {{.words = "work",
                .stations = {{.height = 0, .part = 0, .service = f, .design = f, .member = f}},
                .critical_force = {}}};
    return m;
  };
  // every fifth section: a catalogue of its own
  std::vector<catalogue::SectionRow> table;
  const auto sorted = catalogue::sections_by_mass(filter);
  for (std::size_t i = *rc::gen::inRange<std::size_t>(0, 5); i < sorted.size(); i += 5) table.push_back(sorted[i]);
  const MastSizing found = size_mast(table, mast_of);
  const catalogue::SectionRow* lightest = nullptr;
  double least = HUGE_VAL;
  for (const auto& row : table) {
    const LoadedMast m = *mast_of(row);
    const MastUse u = mast_use(m.mast, m.cases);
    least = std::min(least, u.utilisation());
    const bool lighter = lightest == nullptr || row.mass_per_length < lightest->mass_per_length;
    if (u.utilisation() <= 1 && lighter) lightest = &row;
  }
  RC_ASSERT(found.passing.empty() == (lightest == nullptr));
  if (lightest != nullptr) {
    RC_ASSERT(found.passing[0].section.name == lightest->name);
    RC_ASSERT(!found.nearest);
  } else {
    RC_ASSERT(found.nearest.has_value());
  }
}

TEST(MastSizing, LightestTubeOfCaseA) {
  const auto mast_of = [](const catalogue::SectionRow& row) -> std::optional<LoadedMast> {
    ColumnMast m = cantilever("CHS 508x16", 8, 162638.979, 106508.0225);
    m.pieces[0].section = row;
    m.pieces[0].allowable_stress.reset();
    ColumnMastResult r = column_mast(m);
    if (!r.refused.empty()) return std::nullopt;
    return LoadedMast{.mast = std::move(r.mast), .cases = std::move(r.cases)};
  };
  catalogue::SectionFilter tubes;
  tubes.shape = catalogue::SectionShape::chs;
  tubes.forming = catalogue::Forming::hot;
  tubes.standard = "EN 10210";
  const MastSizing found = size_mast(catalogue::sections_by_mass(tubes), mast_of, 3);
  ASSERT_EQ(found.passing.size(), 3U);
  for (const SizedMast& one : found.passing) EXPECT_LE(one.use.utilisation(), 1) << one.section.name;
  EXPECT_LT(found.passing[0].section.mass_per_length, 194.14);  // lighter than the tube by the paper's [sigma]
}

}  // namespace taut::structure::column_mast_test
