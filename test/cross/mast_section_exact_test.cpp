#include "taut/app/exact/mast_section_exact.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "taut/app/exact/mast_machine.hpp"
#include "taut/app/job.hpp"
#include "taut/calc/answers.hpp"
#include "taut/units/display.hpp"
#include "test/paths.hpp"

// The method and the engine on the same mast: equal where the method's assumptions hold, apart where they do not.
namespace taut::app::mast_section_exact_test {

using namespace mast_section;

constexpr double degree = std::numbers::pi / 180;

Input mast() {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 8;
  in.mainline_block_height = 6.5;
  in.allowable_stress = 235e6;
  in.branch_angle = 12 * degree;
  in.section = "CHS 508x16";
  return in;
}

Result completed(const Input& in) { return run_mast_section(in); }

double number(const Result& r, const std::string& name) {
  const Value* v = r.find_value(name);
  return v == nullptr ? not_computed : v->value;
}

Guy guy_at(double angle) {
  Guy g;
  g.stiffness = 20e6;
  g.weight = 20;
  g.breaking_force = 300e3;
  g.plan_angle = angle;
  g.anchor_distance = 12;
  g.install = GuyInstall{.tension = 20e3, .at = GuyEnd::top};
  return g;
}

TEST(MastSectionExact, StiffCantileverIsTheMethodsOne) {
  const Input in = mast();
  Output out;
  ASSERT_TRUE(mast_section::solve(in, out).ok());
  structure::BeamSection rigid = structure::tube_section(0.508, 0.016);
  for (double* k : {&rigid.EA, &rigid.EI_x, &rigid.EI_y, &rigid.GJ}) *k *= 1e5;
  const auto found = taut::solve::equilibrium(mast_machine(in, {}, clamp_forces(in, sweep(in)).front(), rigid));
  ASSERT_TRUE(found.outcome.ok()) << found.outcome.message;
  const taut::solve::BeamResult& m = found.beams[0];
  EXPECT_NEAR(m.base_moment.norm(), out.M, 1e-6 * out.M);
  EXPECT_NEAR(m.base_force.z(), out.N, 1e-9 * out.N);
  EXPECT_NEAR(-m.base_force.x(), out.Q, 1e-9 * out.Q);
  EXPECT_GT(m.points.back().place.x(), 0) << "the mast leans towards the span";
}

TEST(MastSectionExact, CantileverMomentGrowsByTheClosedForm) {
  Input in = mast();
  in.mainline_block_height.reset();
  const Result r = completed(in);
  ASSERT_EQ(r.status, Status::ok);
  const double N = number(r, "N"), Q = number(r, "Q"), M = number(r, "M");
  const double EI = 210e9 * std::numbers::pi / 64 * (std::pow(0.508, 4) - std::pow(0.476, 4)), k = std::sqrt(N / EI);
  EXPECT_NEAR(number(r, "M_exact"), Q * std::tan(8 * k) / k, 1e-3 * M) << "rotations make the rest";
  EXPECT_GT(number(r, "M_exact"), 1.005 * M);
  EXPECT_NEAR(number(r, "N_exact"), N, 1e-9 * N);
  EXPECT_NEAR(number(r, "Q_exact"), Q, 1e-9 * Q);
  EXPECT_TRUE(std::isnan(number(r, "guy_tension_max_exact")));
}

TEST(MastSectionExact, ComparisonsHaveAnExactColumn) {
  const Result r = completed(mast());
  int exact = 0;
  for (const Comparison& c : r.comparisons) {
    if (!std::isnan(c.exact)) ++exact;
  }
  EXPECT_EQ(exact, 4);
}

TEST(MastSectionExact, GuysTakeTheMomentAndPressTheMast) {
  Input in = mast();
  for (const double angle : {120.0, 160.0, 200.0, 240.0}) in.guys.push_back(guy_at(angle * degree));
  const Result r = completed(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_LT(number(r, "M_exact"), 0.5 * number(r, "M"));
  EXPECT_GT(number(r, "N_exact"), 1.3 * number(r, "N"));
  EXPECT_NEAR(number(r, "top_y_exact"), 0, 1e-9) << "symmetric about the span";
  const Table* guys = r.find_table("guys");
  ASSERT_NE(guys, nullptr);
  ASSERT_EQ(guys->rows.size(), 4u);
  EXPECT_NEAR(std::get<double>(guys->rows[0][3]), std::get<double>(guys->rows[3][3]), 1);
  EXPECT_LT(number(r, "moment_balance_exact"), 1e-6 * number(r, "M"));
  bool cantilever = false, exact = false;
  for (const Check& c : r.checks)
    cantilever |= c.name.starts_with("strength") && !c.name.ends_with("exact"), exact |= c.name.ends_with("exact");
  EXPECT_FALSE(cantilever);
  EXPECT_TRUE(exact);
}

TEST(MastSectionExact, LateralForceLeansTheMastToItsSideMirroredTheOther) {
  Input in = mast();
  for (const double angle : {100.0, 150.0, 220.0, 275.0}) in.guys.push_back(guy_at(angle * degree));
  in.lateral_force = 15e3;
  const Result r = completed(in);
  Input mirrored = in;
  mirrored.lateral_force = -15e3;
  for (Guy& g : mirrored.guys) g.plan_angle = -g.plan_angle;
  const Result s = completed(mirrored);
  EXPECT_GT(number(r, "top_y_exact"), 0);
  EXPECT_NEAR(number(s, "top_y_exact"), -number(r, "top_y_exact"), 1e-9);
  EXPECT_NEAR(number(s, "top_x_exact"), number(r, "top_x_exact"), 1e-9);
  EXPECT_NEAR(number(s, "sigma_exact"), number(r, "sigma_exact"), 1);
}

std::string foot_of(const Input& in, const Result& r) {
  for (const Answer& a : answers(in, r, Display())) {
    if (a.label == "Foot") return a.text;
  }
  return {};
}

// What page 1 says of the foot is of the mast with its guys, at the worst carriage position: not of the method's
// cantilever, whose moment is many times that, and whose axial force lacks that of the guys.
TEST(MastSectionExact, TheFootOfAGuyedMastIsThatOfTheEngine) {
  Input in = mast();
  in.branch_angle.reset();
  in.span = Span{};
  in.span->length = 350;
  in.span->carriage_position = {20, 100, 330};
  in.span->rope_weight = 18;
  in.span->load = 25e3;
  in.span->horizontal_tension = 120e3;
  for (const double angle : {115.0, 160.0, 200.0, 245.0}) in.guys.push_back(guy_at(angle * degree));
  const Result r = completed(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  const Table* positions = r.find_table("positions_exact");
  ASSERT_NE(positions, nullptr);
  for (std::size_t k = 0; k < positions->rows.size(); ++k) {
    EXPECT_GE(number(r, "N_worst_exact"), number_in(*positions, k, "N_exact"));
    EXPECT_LE(number(r, "N_least_exact"), number_in(*positions, k, "N_exact"));
    EXPECT_GE(number(r, "Q_worst_exact"), number_in(*positions, k, "Q_exact"));
    EXPECT_GE(number(r, "M_worst_exact"), number_in(*positions, k, "M_exact"));
  }
  EXPECT_GT(number(r, "N_worst_exact"), number(r, "N_exact")) << "another position presses the foot more";
  EXPECT_LT(number(r, "M_worst_exact"), number(r, "M") / 2) << "the guys hold the head";
  const Display display;
  EXPECT_EQ(foot_of(in, r), fmt::format("moment up to {}; axial force up to {}, shear up to {}; exact, worst of all "
                                        "load cases",
                                        display.brief(number(r, "M_worst_exact"), si::N_m),
                                        display.brief(number(r, "N_worst_exact"), si::N),
                                        display.brief(number(r, "Q_worst_exact"), si::N)));
  in.base = Base::hinged;
  const Result hinged = completed(in);
  EXPECT_LT(number(hinged, "M_worst_exact"), 1e-3);
  EXPECT_TRUE(foot_of(in, hinged).starts_with("hinged, no moment")) << foot_of(in, hinged);
  EXPECT_TRUE(foot_of(in, mast_section::run(in)).empty()) << "the method alone does not know it";
  in = mast();
  EXPECT_TRUE(foot_of(in, mast_section::run(in)).starts_with("moment ")) << "of its own cantilever it does";
}

TEST(MastSectionExact, WeakBoxBendsAboutItsOwnAxes) {
  Input in = mast();
  in.skyline_force = 10e3, in.mainline_force = 2e3;
  in.section = "RHS 300x200x10";
  in.lateral_force = 2e3;
  const Result r = completed(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  in.section = "SHS 300x10";
  const Result square = completed(in);
  EXPECT_GT(number(r, "top_y_exact"), 1.5 * number(square, "top_y_exact"));
}

TEST(MastSectionExact, SlenderMastIsRefusedWithAReason) {
  Input in = mast();
  in.section = "CHS 60.3x3.2";
  in.lateral_force = 100;
  const Result r = completed(in);
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_NE(r.message.find("buckles"), std::string::npos) << r.message;
  EXPECT_EQ(exit_code(r), 3);
  in.lateral_force.reset();
  const Result plain = completed(in);
  EXPECT_EQ(plain.status, Status::ok) << "the method itself knows nothing of it, but its check by second order fails";
  EXPECT_NE(plain.warnings.back().find("buckles"), std::string::npos);
  ASSERT_EQ(plain.checks.size(), 5u);
  EXPECT_FALSE(plain.checks[4].passes);
  EXPECT_NE(plain.checks[4].rule.find("buckles"), std::string::npos);
  EXPECT_EQ(exit_code(plain), 4);
}

/// The mast of the README: the lightest section by first order and hauling in is overloaded when the ropes are paid
/// out, and the next one by second order.
TEST(MastSectionExact, TheChoiceCarriesBothDirectionsAndSecondOrder) {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 8;
  in.branch_angle = 12 * degree;
  in.wrap = Wrap::paper;
  in.allowable_stress = 160e6;
  const Result r = completed(in);
  EXPECT_EQ(exit_code(r), 0) << r.message;
  ASSERT_EQ(r.checks.size(), 5u);
  for (const Check& c : r.checks) EXPECT_TRUE(c.passes) << c.name << ": " << c.value;
  const std::vector<ClampForces> forces = clamp_forces(in, sweep(in));
  const auto chosen = section_in_use(in, forces, second_order_of(in));
  ASSERT_TRUE(chosen);
  EXPECT_GE(chosen->section.W_el_y, 6847e-6);
  // by stress alone a lighter one would do
  const auto light = section_in_use(in, forces);
  EXPECT_LE(light->section.mass_per_length, chosen->section.mass_per_length);
  // an independent look at the chosen one: the cantilever's closed form of second order with the ropes paid out
  const double N = number(r, "N_payout"), M = number(r, "M_payout"), Q = M / 8;
  const double k = std::sqrt(N / (210e9 * chosen->section.I_y)), grown = Q * std::tan(8 * k) / k;
  const double stress = N / chosen->section.area + grown / chosen->section.W_el_y;
  EXPECT_GT(stress, 0.97 * *chosen->second_order);
  EXPECT_LT(stress, 1.001 * *chosen->second_order);
  // each lighter one of the same shape fails somewhere
  for (const catalogue::SectionRow& row : candidates(in, chosen->section.shape)) {
    if (row.mass_per_length >= chosen->section.mass_per_length) continue;
    auto a = assess(limit_of(in), row, forces);
    if (a->passes()) a = assess(limit_of(in), row, forces, second_order_of(in));
    EXPECT_FALSE(a->passes()) << row.name;
  }
}

TEST(MastSectionExact, EveryMistakeOfTheGuysIsTold) {
  Input in = mast();
  in.base = Base::hinged;
  EXPECT_EQ(complaints(in).size(), 1u);
  in.guys = {guy_at(1), guy_at(2), guy_at(3), guy_at(4)};
  EXPECT_TRUE(complaints(in).empty());
  in.guys[0].weight.reset();
  in.guys[1].rope = "nosuch";
  in.guys[2].attachment_height = 9;
  in.guys[3].length = 14;
  const auto all = complaints(in);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].path, "guys[0]");
  EXPECT_EQ(all[1].path, "guys[1].rope");
  EXPECT_EQ(all[2].path, "guys[2].attachment_height");
  EXPECT_EQ(all[3].path, "guys[3]");
}

TEST(MoreExamples, AllRunAndTheirExactChecksPass) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(taut_test::source_dir() / "examples/more")) {
    if (entry.path().extension() != ".yaml") continue;
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    const Result r = run(Job{.text = text.str(), .name = entry.path().string(), .set = {}});
    EXPECT_EQ(r.status, Status::ok) << entry.path() << r.message;
    int exact = 0;
    for (const Check& c : r.checks) {
      if (!c.name.ends_with("exact")) continue;
      EXPECT_TRUE(c.passes) << entry.path() << c.name;
      ++exact;
    }
    EXPECT_GT(exact, 0) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0);
}

const Check* check_named(const Result& r, std::string_view beginning) {
  for (const Check& c : r.checks) {
    if (c.name.starts_with(beginning)) return &c;
  }
  return nullptr;
}

// A guy of unknown strength is not judged, and a known one beside it does not hide it.
TEST(MastSectionExact, AGuyWithoutABreakingForceIsNotJudged) {
  Input in = mast();
  for (const double angle : {120.0, 160.0, 200.0, 240.0}) in.guys.push_back(guy_at(angle * degree));
  Result r = completed(in);
  EXPECT_TRUE(r.unjudged.empty());
  ASSERT_NE(check_named(r, "guylines"), nullptr);
  EXPECT_NE(check_named(r, "guylines")->where.find("guy "), std::string::npos);
  in.guys[1].breaking_force.reset();
  r = completed(in);
  ASSERT_EQ(r.unjudged.size(), 1U);
  EXPECT_TRUE(r.unjudged[0].starts_with("guy 2"));
  EXPECT_NE(check_named(r, "guylines"), nullptr);
  for (Guy& g : in.guys) g.breaking_force.reset();
  r = completed(in);
  EXPECT_EQ(r.unjudged.size(), 4U);
  EXPECT_EQ(check_named(r, "guylines"), nullptr);
}

// The lightest section that carries the mast with its guys, not the cantilever that it would be without them.
TEST(MastSectionExact, AGuyedMastIsChosenWithItsGuys) {
  Input in = mast();
  in.section.reset();
  in.allowable_stress = 120e6;
  in.choose_section = ChooseSection{};
  in.choose_section->shape = SectionKind::chs;
  for (const double angle : {120.0, 180.0, 240.0}) in.guys.push_back(guy_at(angle * degree));
  for (Guy& g : in.guys) g.stiffness = 60e6, g.breaking_force = 2e6;
  const Result r = completed(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  ASSERT_NE(check_named(r, "strength of"), nullptr);
  EXPECT_TRUE(check_named(r, "strength of")->passes);
  for (const std::string& w : r.warnings) EXPECT_EQ(w.find("carries the mast"), std::string::npos) << w;
  const double mass = number(r, "section_mass");
  Input lone = in;
  lone.guys.clear();
  EXPECT_LT(mass, number(completed(lone), "section_mass"));
  // each lighter one fails with the guys
  int lighter = 0;
  for (const catalogue::SectionRow& row : candidates(in, catalogue::SectionShape::chs)) {
    if (row.mass_per_length >= mass || row.mass_per_length < 0.8 * mass) continue;
    Input one = in;
    one.choose_section.reset();
    one.section = row.name;
    const Result tried = completed(one);
    const Check* strength = check_named(tried, "strength of");
    EXPECT_TRUE(strength == nullptr || !strength->passes) << row.name;
    ++lighter;
  }
  EXPECT_GT(lighter, 0);
}

// By second order the stress grows faster than the forces: with the safety n the stress under n times the forces may
// not pass the yield stress. The closed form of the cantilever, M = Q tan(k h)/k.
TEST(MastSectionExact, TheSafetyIsMeantForTheForces) {
  Input in = mast();
  in.mainline_block_height.reset();
  in.allowable_stress.reset();
  in.steel = "EN 10210-1 S355H";
  in.safety = 2;
  in.section = "CHS 323.9x16";
  const Result r = completed(in);
  const Check* second = check_named(r, "strength of CHS 323.9x16, second order");
  ASSERT_NE(second, nullptr);
  const auto row = *catalogue::find_section("CHS 323.9x16");
  const auto stress = [&](double n) {
    const double N = n * number(r, "N_payout"), Q = n * number(r, "M_payout") / 8;
    const double k = std::sqrt(N / (210e9 * row.I_y));
    return (N / row.area + Q * std::tan(8 * k) / k / row.W_el_y) / n;
  };
  EXPECT_NEAR(second->value, stress(2), 0.03 * stress(2));
  EXPECT_GT(second->value, 1.03 * stress(1));
}

// The foot is built for the worst of all load cases, of a mast without guys too.
TEST(MastSectionExact, TheFootHoldsTheWorstOfAllLoadCases) {
  const Input in = mast();
  const Result r = completed(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  EXPECT_GT(number(r, "Q_worst_exact"), 1.01 * number(r, "Q")) << "else nothing is shown";
  const std::string foot = foot_of(in, r);
  for (const char* worst : {"M_worst_exact", "N_worst_exact", "Q_worst_exact"}) {
    EXPECT_NE(foot.find("up to " + Display().brief(number(r, worst), r.find_value(worst)->unit)), std::string::npos)
        << worst << ": " << foot;
  }
  EXPECT_TRUE(r.unsafe.empty());
}

// Ropes that rise by 60 deg, paid out over blocks with much friction: their span side pulls up more than the drum side
// pulls down.
TEST(MastSectionExact, AFootThatIsPulledUpIsUnsafe) {
  Input in = mast();
  in.branch_angle = -60 * degree;
  in.block_friction = 0.5;
  in.section = "CHS 508x16";
  const Result r = completed(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  ASSERT_LT(number(r, "N_least_exact"), 0);
  ASSERT_FALSE(r.unsafe.empty());
  EXPECT_NE(r.unsafe.back().find("pulled up"), std::string::npos) << r.unsafe.back();
}

/// A rope that comes down steeply: it presses the mast by T (1 + sin alpha) at rest and bends it little, in its plane.
Input pressed_mast(double force) {
  Input in;
  in.skyline_force = force;
  in.mainline_force = 0;
  in.skyline_block_height = 14;
  in.branch_angle = 80 * degree;
  in.allowable_stress = 160e6;
  return in;
}

/// Euler's factor of a cantilever about the weaker axis.
double euler_factor(const catalogue::SectionRow& row, double N, double height) {
  return std::pow(std::numbers::pi / (2 * height), 2) * 210e9 * std::min(row.I_y, row.I_z) / N;
}

// Across its plane nothing bends a plain mast, so that no stress tells of its buckling there. By hand, RHS 200x100x6.3
// under 8 kN: N = 8 (1 + sin 80 deg) = 15.88 kN, N_cr = pi^2 210e9 6.13e-6/(4 14^2) = 16.2 kN, and its stress passes.
TEST(MastSectionExact, APlainMastIsChosenThatDoesNotBuckleAcrossItsPlane) {
  Input in = pressed_mast(8e3);
  in.choose_section = ChooseSection{};
  in.choose_section->shape = SectionKind::rhs;
  const Result r = completed(in);
  ASSERT_EQ(exit_code(r), 0) << r.message;
  EXPECT_TRUE(r.unsafe.empty());
  const double N = 8e3 * (1 + std::sin(80 * degree)), mass = number(r, "section_mass");
  EXPECT_NEAR(number(r, "N_worst_exact"), N, 1e-6 * N);
  EXPECT_GE(number(r, "buckling_factor_exact"), 3);
  const std::vector<ClampForces> forces = clamp_forces(in, sweep(in));
  int lighter = 0;
  for (const catalogue::SectionRow& row : candidates(in, catalogue::SectionShape::rhs)) {
    const double alpha = euler_factor(row, N, 14);
    if (row.mass_per_length == mass) {
      EXPECT_NEAR(number(r, "buckling_factor_exact"), alpha, 0.01 * alpha) << row.name;
    }
    if (row.mass_per_length >= mass || !assess(limit_of(in), row, forces)->passes()) continue;
    EXPECT_FALSE(assess(limit_of(in), row, forces, second_order_of(in))->passes()) << row.name;
    if (alpha < 2.97) ++lighter;
  }
  EXPECT_GT(lighter, 0) << "else nothing is shown";
}

// Where none stands, the nearest is shown and fails by its buckling, though every stress passes.
TEST(MastSectionExact, TheNearestToAMastThatMayBuckleFails) {
  Input in = pressed_mast(85e3);
  in.skyline_block_height = 30;
  in.branch_angle = 84 * degree;
  in.allowable_stress = 235e6;
  in.choose_section = ChooseSection{};
  in.choose_section->shape = SectionKind::rhs;
  const Result r = completed(in);
  for (const Check& c : r.checks) EXPECT_EQ(c.passes, c.name != "buckling of the mast as chosen") << c.name;
  const Check* buckling = check_named(r, "buckling of the mast as chosen");
  ASSERT_NE(buckling, nullptr);
  const double N = 85e3 * (1 + std::sin(84 * degree));
  EXPECT_NEAR(buckling->value, euler_factor(*catalogue::find_section("RHS 500x300x20"), N, 30), 0.01 * buckling->value);
  EXPECT_EQ(exit_code(r), 4);
}

// A named one is judged as one with guys or a side force is: against the safety of the deck, and unsafe below 3.
TEST(MastSectionExact, APlainMastThatMayBuckleIsUnsafe) {
  Input in = pressed_mast(15e3);
  in.section = "RHS 300x100x10";
  Result r = completed(in);
  ASSERT_EQ(r.status, Status::ok) << r.message;
  for (const Check& c : r.checks) EXPECT_TRUE(c.passes) << c.name;
  const double N = 15e3 * (1 + std::sin(80 * degree)), alpha = number(r, "buckling_factor_exact");
  EXPECT_NEAR(alpha, euler_factor(*catalogue::find_section("RHS 300x100x10"), N, 14), 0.01 * alpha);
  ASSERT_EQ(r.unsafe.size(), 1U);
  EXPECT_NE(r.unsafe[0].find("the mast buckles at 1.09 times its axial force"), std::string::npos) << r.unsafe[0];
  EXPECT_EQ(check_named(r, "buckling of"), nullptr) << "the deck has no safety";
  in.lateral_force = 1e-3;  // another mast by name, but none by what it carries
  EXPECT_EQ(completed(in).unsafe, r.unsafe);
  in.lateral_force.reset();
  in.allowable_stress.reset();
  in.steel = "EN 10219-1 S355H";
  for (const double safety : {1.05, 1.2}) {
    in.safety = safety;
    r = completed(in);
    const Check* buckling = check_named(r, "buckling of");
    ASSERT_NE(buckling, nullptr);
    EXPECT_EQ(buckling->passes, safety < alpha);
    EXPECT_NEAR(buckling->value, alpha, 0.05 * alpha);
    EXPECT_EQ(r.unsafe.size(), 1U);
  }
  in.section = "CHS 406.4x12.5";
  r = completed(in);
  ASSERT_NE(check_named(r, "buckling of"), nullptr);
  EXPECT_TRUE(check_named(r, "buckling of")->passes);
  EXPECT_TRUE(r.unsafe.empty());
  in.section = "CHS 60.3x3.2";  // Euler's factor is far below 1
  r = completed(in);
  EXPECT_NE(exit_code(r), 0);
  EXPECT_TRUE(std::isnan(number(r, "buckling_factor_exact"))) << "no least factor where a case has no equilibrium";
}

}  // namespace taut::app::mast_section_exact_test
