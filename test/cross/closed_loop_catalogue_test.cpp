#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/catalogue/modulus.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "test/cases/closed_loop_example.hpp"
#include "test/support/machine_decks.hpp"

// The closed loop with ropes of the catalogue, whose rows have more than a weight.

namespace taut::closed_loop::cross::closed_loop_catalogue_test {

using namespace taut_test;

/// The example at a given length of the loop, with a clearance.
Input at_length() {
  Input in = example();
  in.sag.reset();
  in.mode = Mode::loop_length;
  in.loop_length = 402;
  in.clearance = 12;
  return in;
}

double sag_of(const Result& r) {
  const Value* v = r.find_value("f");
  EXPECT_NE(v, nullptr) << r.message;
  return v == nullptr ? 0 : v->value;
}

double EA_of(const std::string& rope) { return catalogue::stiffness_of(*catalogue::find_rope(rope))->EA; }

// At a given length the stretch decides: 10.0 m without it, 12.8 m with the stiffness that the catalogue has.
TEST(ClosedLoopCatalogue, RopesOfTheCatalogueStretchAtAGivenLength) {
  constexpr const char* thin = "EN 12385-4|6x36-IWRC|18|1960";
  constexpr const char* thick = "EN 12385-4|6x36-IWRC|22|1960";
  Input in = at_length();
  const Result plain = taut::app::run_closed_loop(in);
  EXPECT_NEAR(sag_of(plain), 10, 0.05);
  EXPECT_EQ(plain.unmade.size(), 2U) << "both ropes are given by their weight";
  in.clearance = 9;
  EXPECT_TRUE(taut::app::run_closed_loop(in).unmade.empty()) << "it fails without their stretch already";
  in.clearance = 12;
  in.return_weight.reset();
  in.traction_weight.reset();
  in.return_rope = thin;
  in.traction_rope = thick;
  in.safety_factor = 2.2;
  const Result own = taut::app::run_closed_loop(in);
  EXPECT_NEAR(sag_of(own), 12.77, 0.005);
  EXPECT_TRUE(own.unmade.empty());
  EXPECT_EQ(verdict_of(own)->kind, VerdictKind::fails) << verdict_of(own)->reason;
  in.return_stiffness = EA_of(thin);
  in.traction_stiffness = EA_of(thick);
  EXPECT_EQ(sag_of(taut::app::run_closed_loop(in)), sag_of(own));
  in.return_stiffness *= 1e3;  // the deck's own counts
  EXPECT_LT(sag_of(taut::app::run_closed_loop(in)), sag_of(own) - 0.5);
}

// Ropes that are chosen are proved with their own stiffness.
TEST(ClosedLoopCatalogue, ChosenRopesStretchAtAGivenLength) {
  Input in = at_length();
  in.clearance.reset();
  in.return_weight.reset();
  in.traction_weight.reset();
  in.choose_ropes = RopeFilter{.construction = "6x36", .core = "IWRC", .grade = 1960e6};
  in.safety_factor = 3;
  const Result chosen = taut::app::run_closed_loop(in);
  ASSERT_EQ(chosen.status, Status::ok) << chosen.message;
  const Table& ropes = *chosen.find_table("ropes");
  in.choose_ropes.reset();
  in.return_rope = std::get<std::string>(ropes.rows[0][1]);
  in.traction_rope = std::get<std::string>(ropes.rows[1][1]);
  in.return_stiffness = EA_of(*in.return_rope);
  in.traction_stiffness = EA_of(*in.traction_rope);
  EXPECT_NEAR(sag_of(taut::app::run_closed_loop(in)), sag_of(chosen), 1e-9);
}

// A breaking force that nobody has compared with its source is no limit where the deck refuses such limits.
TEST(ClosedLoopCatalogue, AnUnverifiedBreakingForceIsRefused) {
  const auto run_with = [](const std::string& ropes, const std::string& checks) {
    return run_text(fmt::format(
        "taut: 1\nmethod: closed_loop\ninput: {{span: 200 m, sag: 10 m, gathering_force: 3000 kgf, gathering_angle: 30 "
        "deg, tail_efficiency: 0.9, safety_factor: 3, {}}}\n{}",
        ropes, checks));
  };
  const std::string row = "\"GOST 7668-80|6x36(1+7+7/7+14)-FC|29|1770\"";
  for (const std::string& ropes :
       {"return_rope: " + row + ", traction_rope: " + row, std::string("choose_ropes: {core: FC, grade: 1670 MPa}")}) {
    const Result refused = run_with(ropes, "checks: {refuse_unverified: true}\n");
    ASSERT_EQ(refused.status, Status::ok) << refused.message << to_text(refused.errors);
    EXPECT_EQ(verdict_of(refused)->kind, VerdictKind::not_judged) << verdict_of(refused)->reason;
    EXPECT_EQ(verdict_of(refused)->verdict_class, "unverified");
    EXPECT_EQ(verdict_of(run_with(ropes, ""))->kind, VerdictKind::passes_with_warnings);
  }
}

}  // namespace taut::closed_loop::cross::closed_loop_catalogue_test
