#include <gtest/gtest.h>

#include <string>
#include <tl/expected.hpp>

#include "taut/app/job.hpp"

namespace taut::transient_analysis_test {

/// An empty file is no state to go on from: the motion must not begin anew in its place.
TEST(TransientAnalysis, AnEmptyFileIsNoSavedState) {
  const Result r =
      app::run({.text = R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 20 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 200 kN}}
  bodies: {load: {mass: 1 t, at: [0 m, 0 m, 0 m], free: [z]}}
  reevings: [{rope: r, path: [{anchor: top}, {anchor: load}], length: 20 m}]
analyses: [{transient: {duration: 0.1 s, restart: empty.state}}]
)",
                .name = "deck.yaml",
                .read = [](const std::string&) -> tl::expected<std::string, io::Unreadable> { return std::string{}; }});
  EXPECT_EQ(r.status, Status::infeasible) << to_text(r.errors);
  EXPECT_NE(r.message.find("'empty.state': it is no saved state of a transient"), std::string::npos) << r.message;
}

}  // namespace taut::transient_analysis_test
