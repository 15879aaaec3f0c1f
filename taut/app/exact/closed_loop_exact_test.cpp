// Decks of the closed loop whose exact catenaries end: ropes are judged by an equilibrium that is there, or not at all.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "taut/calc/verdict.hpp"
#include "test/support/machine_decks.hpp"

namespace taut::app::closed_loop_exact_test {

using taut_test::run_text;
using taut_test::value_of;
using testing::HasSubstr;

/// 30 m before the tail support, on a steep slope and far below it: the tensions climb with the sag until they have no
/// equilibrium from about 44.7 m on, where 3 km of rope would lie in the loop.
Result near_the_tail(const std::string& position, const std::string& sag, double factor = 3.5) {
  return run_text(fmt::format(R"(taut: 1
method: closed_loop
input:
  span: 600 m
  slope: 30 deg
  position: {}
  sag: {}
  gathering_force: 1 kN
  gathering_angle: 30 deg
  carriage_weight: 2 kN
  tail_efficiency: 1.0
  return_rope: 6x36-IWRC 12 mm 1960 MPa
  traction_rope: 6x36-IWRC 18 mm 1960 MPa
  safety_factor: {}
)",
                              position, sag, factor));
}

VerdictKind kind_of(const Result& r) { return verdict_of(r)->kind; }

TEST(ClosedLoopExact, BeyondTheLastEquilibriumALoopIsNotJudged) {
  const Result last = near_the_tail("570 m", "44.6 m", 8);
  EXPECT_EQ(kind_of(last), VerdictKind::fails) << "exact: 16 kN on a rope of 100 kN";
  EXPECT_GT(value_of(last, "T_max"), 16e3);
  for (const char* sag : {"44.8 m", "60 m"}) {
    const Result beyond = near_the_tail("570 m", sag, 8);  // by the closed form 7 kN and 6 kN
    EXPECT_EQ(beyond.status, Status::not_converged);
    EXPECT_EQ(kind_of(beyond), VerdictKind::no_answer);
    EXPECT_THAT(beyond.message, HasSubstr("find no equilibrium at x = 570 m"));
  }
}

TEST(ClosedLoopExact, OneOfSeveralPositionsWithoutAnEquilibriumIsNotJudged) {
  const Result all = near_the_tail("[100 m, 300 m, 500 m]", "60 m");
  EXPECT_NE(kind_of(all), VerdictKind::not_judged);
  const Result r = near_the_tail("[100 m, 300 m, 500 m, 570 m]", "60 m");
  EXPECT_EQ(r.status, Status::ok);
  EXPECT_EQ(kind_of(r), VerdictKind::not_judged);
  ASSERT_EQ(r.missing.size(), 1U);
  EXPECT_EQ(r.missing[0].first, "x = 570 m");
  EXPECT_THAT(std::get<std::string>(r.find_table("positions")->rows[3].back()), HasSubstr("find no equilibrium"));
}

// The closed form may stand in for exact values nowhere. Where it is near, they are always there.
TEST(ClosedLoopExact, TheExactCatenariesAnswerWhereTheClosedFormIsNear) {
  for (const char* sag : {"5 m", "15 m", "30 m"}) {
    const Result r = near_the_tail("[60 m, 150 m, 300 m, 450 m, 540 m]", sag);
    EXPECT_EQ(r.status, Status::ok) << r.message;
    EXPECT_TRUE(r.missing.empty()) << sag;
  }
}

}  // namespace taut::app::closed_loop_exact_test
