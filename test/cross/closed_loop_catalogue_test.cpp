#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

// The closed loop with ropes of the catalogue, whose rows have more than a weight.

namespace taut::closed_loop::cross::closed_loop_catalogue_test {

using namespace taut_test;

// A breaking force that nobody has compared with its source is no limit where the deck refuses such limits.
TEST(ClosedLoopCatalogue, AnUnverifiedBreakingForceIsRefused) {
  const auto run_with = [](const std::string& ropes, const std::string& checks) {
    return run_text(
        "taut: 1\nmethod: closed_loop\ninput: {span: 200 m, sag: 10 m, gathering_force: 3000 kgf, gathering_angle: 30 "
        "deg, tail_efficiency: 0.9, safety_factor: 3, " +
        ropes + "}\n" + checks);
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
