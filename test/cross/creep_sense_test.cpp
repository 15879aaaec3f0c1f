#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "test/support/machine_decks.hpp"

/// A skyline that nobody hauls over two jacks with friction: the band of a motion against single answers whose senses
/// are given by signs, whichever way the path is written.
namespace creep_sense_test {

using namespace taut_test;
using taut::Result;
using taut::Status;

std::string deck(bool turned, double friction, const std::string& analysis) {
  const std::string path = turned ? "[{anchor: B}, {over: jack2}, {through: car}, {over: jack1}, {anchor: A}]"
                                  : "[{anchor: A}, {over: jack1}, {through: car}, {over: jack2}, {anchor: B}]";
  return fmt::format(R"(taut: 1
machine:
  points: {{A: [0 m, 0 m, 0 m], B: [300 m, 0 m, 60 m], block: [300 m, 0 m, 58 m]}}
  ropes:
    sky: {{mass: 2 kg/m, stiffness: 20 MN, breaking_force: 400 kN}}
    main: {{mass: 0.5 kg/m, stiffness: 7 MN, breaking_force: 100 kN}}
  supports:
    jack1: {{at: [100 m, 0 m, 25 m], diameter: 0 mm, friction: {0}, uplift: hold}}
    jack2: {{at: [200 m, 0 m, 46 m], diameter: 0 mm, friction: {0}, uplift: hold}}
  carriages: {{car: {{mass: 2 t, rides: sky, hold: rolling, mainline: main, friction: 0.02}}}}
  reevings:
    - {{rope: sky, path: {1}, length: 308.5 m}}
    - {{rope: main, path: [{{anchor: block}}, {{anchor: car}}], length: 150 m}}
analyses:
  - {2}
)",
                     friction, path, analysis);
}

Result solved(const std::string& text) {
  Result r = run_text(text);
  EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  return r;
}

struct Band {
  double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();
};
using Bands = std::map<std::string, Band>;  // by the lower end of the span along the line and that end

/// Widens the bands of the skyline's ends of spans; `band`: by the columns of the band.
void take(const Result& r, bool band, Bands& all) {
  const taut::Table& t = table_of(r, "spans");
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    if (text_cell(t, i, "rope") != "sky") continue;
    const std::string from = text_cell(t, i, "from"), to = text_cell(t, i, "to");
    for (const auto& [end, column] : {std::pair{from + " of " + std::min(from, to) + std::max(from, to), "T_from"},
                                      {to + " of " + std::min(from, to) + std::max(from, to), "T_to"}}) {
      Band& one = all[end];
      const std::string name = column;
      one.least = std::min(one.least, cell(t, i, band ? name + "_min" : name));
      one.most = std::max(one.most, cell(t, i, band ? name + "_max" : name));
    }
  }
}

// The mainline hauls to B: the skyline passes the carriage towards A. Each jack by itself has either sense.
TEST(CreepSense, TheBandOfAMotionIsThatOfAllSigns) {
  Bands by_signs;
  for (const int jack1 : {1, -1}) {
    for (const int jack2 : {1, -1}) {
      take(
          solved(deck(false, 0.15,
                      fmt::format("equilibrium: {{carriage: car, x: 150 m, motion: {{car: -1, jack1: {}, jack2: {}}}}}",
                                  jack1, jack2))),
          false, by_signs);
    }
  }
  ASSERT_EQ(by_signs.size(), 8U);
  for (const bool turned : {false, true}) {
    Bands band;
    take(solved(deck(turned, 0.15, "equilibrium: {carriage: car, x: 150 m, motion: in}")), true, band);
    ASSERT_EQ(band.size(), by_signs.size());
    double widest = 0;
    for (const auto& [end, one] : by_signs) {
      EXPECT_NEAR(band[end].least / one.least, 1, 1e-8) << end << turned;
      EXPECT_NEAR(band[end].most / one.most, 1, 1e-8) << end << turned;
      widest = std::max(widest, one.most / one.least);
    }
    EXPECT_GT(widest, 1.05) << "it matters";
  }
}

TEST(CreepSense, APayloadIsThatOfTheWorstSigns) {
  const auto payload = [](bool turned, const std::string& motion) {
    const Result r = solved(deck(turned, 0.15,
                                 "payload: {carriage: car, from: 140 m, to: 150 m, steps: 1, motion: " + motion +
                                     ", limits: {sky: {safety_factor: 3}}}"));
    return cell(table_of(r, "payload"), 1, "payload");
  };
  double worst = std::numeric_limits<double>::infinity(), best = 0;
  for (const int jack1 : {1, -1}) {
    for (const int jack2 : {1, -1}) {
      const double one = payload(false, fmt::format("{{car: -1, jack1: {}, jack2: {}}}", jack1, jack2));
      worst = std::min(worst, one);
      best = std::max(best, one);
    }
  }
  EXPECT_GT(best, 1.02 * worst);
  EXPECT_NEAR(payload(false, "in") / worst, 1, 1e-7);
  EXPECT_NEAR(payload(true, "in") / worst, 1, 1e-7);
}

// A cycle leaves out the work of creep: its pulls are those of jacks without friction.
TEST(CreepSense, ACycleHasNoLossWhereItsSkylineCreeps) {
  const auto energy = [](bool turned, double friction) {
    return value_of(solved(deck(turned, friction,
                                "cycle: {carriage: car, from: 120 m, to: 180 m, steps: 6, phases: [{name: home, "
                                "motion: in}]}")),
                    "cycle_energy");
  };
  const double smooth = energy(false, 0);
  EXPECT_NEAR(energy(false, 0.15) / smooth, 1, 1e-9);
  EXPECT_NEAR(energy(true, 0.15) / smooth, 1, 1e-9);
}

}  // namespace creep_sense_test
