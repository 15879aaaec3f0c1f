#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "test/support/machine_decks.hpp"

/// The pull that hauls a carriage along a skyline that nobody hauls, by hand, whichever way paths are written.
namespace carriage_sense_test {

using namespace taut_test;
using taut::Result;
using taut::Status;

constexpr double span = 100, length = 104, weight = 10e3, mu = 0.05;  // m, m, N

/// A weightless skyline that does not stretch; the mainline lies along its branch of the horizontal way `ahead`. The
/// branch behind has the larger tension T_b = T_a exp(mu (alpha + beta)); the one ahead and the mainline bear the rest.
double pull_by_hand(double ahead, bool in) {
  const double behind = span - ahead;
  double low = 0, high = length;  // depth of the carriage, by halving
  for (int i = 0; i < 200; ++i) {
    const double z = (low + high) / 2;
    (std::hypot(behind, z) + std::hypot(ahead, z) < length ? low : high) = z;
  }
  const double alpha = std::atan2(low, behind), beta = std::atan2(low, ahead);
  const double T_b = weight / (std::sin(alpha) + std::cos(alpha) * std::tan(beta));
  const double both = T_b * std::cos(alpha) / std::cos(beta);
  return both - T_b * std::exp((in ? -mu : mu) * (alpha + beta));
}

struct Line {
  bool winch_at_B = true, skyline_turned = false, mainline_turned = false;
};

std::string deck(const Line& line, const std::string& analysis) {
  const auto path = [](bool turned, const char* from, const std::string& middle, const char* to) {
    return fmt::format("[{{anchor: {}}}, {}{{anchor: {}}}]", turned ? to : from, middle, turned ? from : to);
  };
  const char* winch = line.winch_at_B ? "B" : "A";
  return fmt::format(R"(taut: 1
machine:
  gravity: 10 m/s^2
  points: {{A: [0 m, 0 m, 0 m], B: [100 m, 0 m, 0 m]}}
  ropes: {{sky: {{mass: 0 kg/m, stiffness: .inf}}, main: {{mass: 0 kg/m, stiffness: .inf}}}}
  carriages: {{car: {{mass: 1000 kg, rides: sky, hold: rolling, mainline: main, friction: 0.05}}}}
  reevings:
    - {{rope: sky, path: {}, length: 104 m}}
    - {{rope: main, path: {}, length: 70 m}}
analyses:
  - {}
)",
                     path(line.skyline_turned, "A", "{through: car}, ", "B"),
                     path(line.mainline_turned, winch, "", "car"), analysis);
}

double largest(const Result& r, const std::string& table, const std::string& rope) {
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const taut::Table& t = table_of(r, table);
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    if (text_cell(t, i, "rope") == rope) return cell(t, i, "T_from");
  }
  return std::nan("");
}

TEST(CarriageSense, ThePullIsThatByHandWhicheverWayPathsAreWritten) {
  EXPECT_NEAR(pull_by_hand(30, true), 1669, 1);
  EXPECT_NEAR(pull_by_hand(30, false), 696, 1);
  for (const bool winch_at_B : {true, false}) {
    for (const bool skyline_turned : {true, false}) {
      for (const bool mainline_turned : {true, false}) {
        for (const bool in : {true, false}) {
          const Line line{
              .winch_at_B = winch_at_B, .skyline_turned = skyline_turned, .mainline_turned = mainline_turned};
          const Result r = run_text(deck(line, fmt::format("equilibrium: {{motion: {}, carriage: car, x: {} m}}",
                                                           in ? "in" : "out", winch_at_B ? 70 : 30)));
          EXPECT_NEAR(largest(r, "spans", "main"), pull_by_hand(30, in), 1e-6 * weight)
              << winch_at_B << skyline_turned << mainline_turned << in;
        }
      }
    }
  }
}

TEST(CarriageSense, AllAnalysesHaveTheSameSense) {
  const std::string way = "carriage: car, from: 60 m, to: 80 m, steps: 2";
  const double hand = pull_by_hand(30, true);
  const Result path = run_text(deck({}, "load_path: {" + way + ", motion: in}"));
  const Result all = run_text(deck({}, "envelope: {carriage: car, from: 70 m, to: 71 m, steps: 1, motions: [in]}"));
  const Result cycle = run_text(deck({}, "cycle: {" + way + ", phases: [{name: home, motion: in}]}"));
  ASSERT_EQ(path.status, Status::ok) << path.message;
  EXPECT_NEAR(cell(table_of(path, "load_path"), 1, "main.T_B"), hand, 1e-6 * weight);
  const taut::Table& e = table_of(all, "envelope");
  for (std::size_t i = 0; i < e.rows.size(); ++i) {
    if (text_cell(e, i, "name") == "main" && text_cell(e, i, "quantity") == "tension") {
      EXPECT_NEAR(cell(e, i, "min"), hand, 1e-6 * weight);
      EXPECT_NEAR(cell(e, i, "max"), pull_by_hand(29, true), 1e-6 * weight);
    }
  }
  ASSERT_EQ(cycle.status, Status::ok) << cycle.message;
  EXPECT_GT(value_of(cycle, "cycle_energy"), 0);
  // the payload of a winch of 3 kN: the pull is proportional to the weight
  const Result payload = run_text(deck(
      {}, "payload: {carriage: car, from: 70 m, to: 71 m, steps: 1, motion: in, limits: {main: {tension: 3 kN}}}"));
  ASSERT_EQ(payload.status, Status::ok) << payload.message << to_text(payload.errors);
  EXPECT_NEAR(cell(table_of(payload, "payload"), 0, "payload"), 1000 * (3000 / hand - 1), 1e-3);
}

}  // namespace carriage_sense_test
