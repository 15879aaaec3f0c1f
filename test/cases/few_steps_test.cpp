#include <fmt/format.h>
#include <gtest/gtest.h>

#include "test/support/machine_decks.hpp"

/// A place has the same answer in a path of few steps and of many.
namespace few_steps_test {

using namespace taut_test;
using taut::Result;
using taut::Status;

std::string deck(const std::string& analysis) {
  return R"(taut: 1
machine:
  points: {head: [0 m, 0 m, 18 m], tail: [250 m, 0 m, 120 m]}
  ropes: {skyline: {rope: "EN 12385-4|6x36-IWRC|20|1960", stiffness: 20 MN}}
  carriages: {car: {mass: 220 kg, rides: skyline, hold: clamped}}
  reevings: [{rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 272 m}]
  loads: [{at: car, mass: 1 t}]
analyses: [)" +
         analysis + "]\n";
}

TEST(FewSteps, OfALoadPathAndAPayloadFindEveryPlace) {
  const auto last = [](const std::string& analysis, const char* name, const char* column) {
    const Result r = run_text(deck(analysis));
    EXPECT_EQ(r.status, Status::ok) << analysis << r.message << to_text(r.errors);
    const taut::Table& t = table_of(r, name);
    return t.rows.empty() ? 0 : cell(t, t.rows.size() - 1, column);
  };
  const double alone = last("equilibrium: {carriage: car, x: 245 m}", "spans", "T_to");
  EXPECT_GT(alone, 1e3);
  const auto way = [](const char* what, int steps, const char* limits) {
    return fmt::format("{}: {{carriage: car, from: 5 m, to: 245 m, steps: {}{}}}", what, steps, limits);
  };
  const char* limits = ", limits: {skyline: {safety_factor: 3}}";
  const double payload = last(way("payload", 24, limits), "payload", "payload");
  for (const int steps : {1, 2, 3, 4, 6, 8}) {
    EXPECT_NEAR(last(way("load_path", steps, ""), "load_path", "skyline.T_tail") / alone, 1, 1e-7) << steps;
    EXPECT_NEAR(last(way("payload", steps, limits), "payload", "payload") / payload, 1, 1e-6) << steps;
  }
}

}  // namespace few_steps_test
