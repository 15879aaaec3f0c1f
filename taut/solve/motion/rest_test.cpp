#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "taut/solve/equilibrium.hpp"
#include "test/paths.hpp"
#include "test/support/dice.hpp"
#include "test/support/guyed_pole.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// Where a motion without losses comes to rest, once drag has taken its energy, is the equilibrium of statics.
namespace taut_test::rest_test {
namespace {

using taut::solve::Branches;
using taut::solve::BranchResult;
using taut::solve::DynamicState;
using taut::solve::equilibrium;
using taut::solve::EquilibriumResult;
using taut::solve::Start;
using taut::solve::transient;
using taut::solve::TransientFrame;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

struct Machine {
  const char* kind = "";
  machine::Model model;
  double size = 1;
};

/// One to six falls from a held drum or an anchor over sheaves with radius to a block.
Machine hoist(Dice& dice) {
  Machine t;
  t.kind = "hoist";
  const int falls = 1 + dice.below(6);
  const double r = dice.in(0.1, 0.4), h = dice.in(8, 30), part = dice.in(0.3, 0.7), mass = dice.ten_to(2.5, 4);
  t.model.bodies.push_back(body("block", {dice.in(-0.3, 0.3), 0, h * (1 - part)}, mass, "xz"));
  const Vector3 winch{-dice.in(4, 12), 0, dice.in(-3, 3)};
  std::vector<machine::Node> nodes;
  if (dice.below(2) == 0) {
    nodes.push_back(add_drum(t.model, "winch", winch, dice.in(0.1, 0.3)));
  } else {
    nodes.push_back(anchor("winch", winch));
  }
  for (int i = 0; i < falls; ++i) {
    const bool head = i % 2 == 0;
    nodes.push_back(head ? sheave("head", {0, 0, h}, r, 1) : sheave("block", origin, r, 1, 1, 0));
  }
  nodes.push_back(falls % 2 == 0 ? anchor("becket", {-r, 0, h}) : anchor_on("becket", 0, {r, 0, 0}));
  const double length = (winch - Vector3(0, 0, h)).norm() + part * h * falls + 3 * falls * r;
  t.model.reevings.push_back(reeve("hoist", nodes, length, dice.below(2) * dice.in(2, 20), dice.ten_to(6, 7.5)));
  t.model.reevings[0].copies = 1 + dice.below(2);
  t.size = h;
  return t;
}

/// One to three weights on three to seven ropes.
Machine net(Dice& dice) {
  Machine t;
  t.kind = "net";
  const int knots = 1 + dice.below(3), ropes = knots + 2 + dice.below(3);
  for (int b = 0; b < knots; ++b) {
    const Vector3 at(dice.in(-20, 20), dice.in(-20, 20), dice.in(0, 20));
    t.model.bodies.push_back(body("knot", at, dice.ten_to(1.5, 3.5), "xyz"));
  }
  for (int r = 0; r < ropes; ++r) {
    const int b = r % knots;
    const Vector3 at(dice.in(-50, 50), dice.in(-50, 50), dice.in(25, 60));
    const double chord = (at - t.model.bodies[b].position).norm();
    t.model.reevings.push_back(reeve("rope", {anchor("a", at), anchor_on("knot", b)}, chord * dice.in(0.9, 1.3),
                                     dice.below(2) * dice.in(2, 20), dice.ten_to(5.5, 7.5)));
  }
  t.size = 60;
  return t;
}

/// A carriage that rolls on a skyline, held by a mainline.
Machine skyline(Dice& dice) {
  Machine t;
  t.kind = "skyline";
  const double span = dice.in(40, 200), rise = dice.in(-0.2, 0.2) * span, part = dice.in(0.25, 0.75);
  const double sag = dice.in(0.03, 0.08) * span, weight = dice.below(2) * dice.in(5, 20);
  const Vector3 head(0, 0, 20), tail(span, 0, 20 + rise), at(part * span, 0, 20 + part * rise - sag);
  t.model.bodies.push_back(body("car", at, dice.ten_to(2.5, 3.7), "xyz"));
  const double length = (at - head).norm() + (tail - at).norm();
  machine::Node roller = over("car", origin, 0);
  roller.support = -Vector3::UnitZ();
  t.model.reevings.push_back(
      reeve("skyline", {anchor("head", head), roller, anchor("tail", tail)}, length, weight, dice.ten_to(6.5, 7.5)));
  t.model.reevings.push_back(reeve("mainline", {anchor("winch", head), anchor_on("car", 0)},
                                   (at - head).norm() * dice.in(0.98, 1.02), weight / 3, dice.ten_to(6, 7)));
  t.size = span;
  return t;
}

Machine pole(Dice& dice) {
  Machine t;
  t.kind = "pole";
  t.size = add_guyed_pole(dice, t.model);
  machine::Body& pole = t.model.bodies[0];
  pole.inertia = Vector3(1, 1, 0) * pole.mass * t.size * t.size / 12;
  return t;
}

Machine random_machine(unsigned seed) {
  Dice dice{std::mt19937(seed)};
  const int kind = dice.below(4);
  Machine t = kind == 0 ? hoist(dice) : kind == 1 ? net(dice) : kind == 2 ? skyline(dice) : pole(dice);
  for (machine::Reeving& rope : t.model.reevings) {
    rope.mass = 0.5 + rope.weight / 9.81;
    rope.damping_time = 2e-3;
  }
  return t;
}

void stop(DynamicState& state) {
  for (auto& one : state.bodies) one.velocity = one.spin = Vector3::Zero();
  for (auto& rope : state.ropes) std::fill(rope.spin.begin(), rope.spin.end(), 0.0);
  state.memory.clear();
}

/// Near its equilibrium: out of place, or thrown where a drum takes rope as the rope turns, so that the length from it
/// depends on where the machine is.
machine::Model begun_near(const Machine& t, const EquilibriumResult& r, Dice& dice) {
  machine::Model begun = t.model;
  for (std::size_t b = 0; b < begun.bodies.size(); ++b) {
    begun.bodies[b].position = r.state.bodies[b].position;
    begun.bodies[b].orientation = r.state.bodies[b].orientation;
    if (!begun.drums.empty()) continue;
    for (const machine::Freedom& way : begun.bodies[b].free)
      begun.bodies[b].position += 0.03 * t.size * dice.in(-1, 1) * way.along;
  }
  return begun;
}

/// The last frame of a motion with drag: all velocities are taken away wherever the kinetic energy has passed a peak.
/// Empty where the motion cannot go on, with the reason in `why`.
std::optional<TransientFrame> rest_of_motion(const Machine& t, const machine::Model& begun, Dice& dice,
                                             std::string& why) {
  // A machine is at rest when its kinetic energy is below this share of the energy turned over.
  constexpr double at_rest = 1e-17;
  TransientOptions options = lasting(0.05 * std::sqrt(t.size / 9.81), 1e-5);
  options.branches = Branches::catenary;
  if (!begun.drums.empty()) options.start = Start::settled;
  double before = 0, turnover = 0;
  for (int i = 0; i < 4000; ++i) {
    const TransientResult r = transient(begun, options);
    if (!r.outcome.ok()) {
      why = r.outcome.message;
      return {};
    }
    options.from = r.state;
    if (i == 0 && options.start == Start::settled) {
      for (std::size_t b = 0; b < begun.bodies.size(); ++b) {
        for (const machine::Freedom& way : begun.bodies[b].free)
          options.from->bodies[b].velocity += 0.05 * std::sqrt(9.81 * t.size) * dice.in(-1, 1) * way.along;
      }
      options.from->memory.clear();
      continue;
    }
    const auto& energy = r.frames.back().energy;
    turnover = std::max(turnover, energy.turnover);
    if (energy.kinetic >= before) {
      before = energy.kinetic;
      continue;
    }
    if (before < at_rest * turnover) return r.frames.back();
    stop(*options.from);
    before = 0;
  }
  why = "still moves";
  return {};
}

/// 100 machines by chance (under the sanitizers ten of them), to 1e-6 of the largest tension. A seed whose machine has
/// no equilibrium, as a pole whose guys are too long for its load, gives way to the next one.
TEST(RestOfMotion, IsTheEquilibrium) {
  const int machines = watched ? 10 : 100;
  int compared = 0;
  std::string without;  // an equilibrium, by seed
  for (unsigned seed = 1; compared < machines; ++seed) {
    const Machine t = random_machine(seed);
    SCOPED_TRACE(std::string(t.kind) + " " + std::to_string(seed));
    const EquilibriumResult r = equilibrium(t.model);
    if (!r.outcome.ok()) {
      without += std::to_string(seed) + " ";
      ASSERT_LT(seed, 2U * static_cast<unsigned>(machines)) << without;
      continue;
    }
    ++compared;
    Dice dice{std::mt19937(seed + 1000)};
    std::string why;
    const auto rest = rest_of_motion(t, begun_near(t, r, dice), dice, why);
    ASSERT_TRUE(rest) << why;
    double largest = 0;
    for (const BranchResult& s : r.branches) largest = std::max({largest, s.T_from, s.T_to});
    ASSERT_EQ(rest->branches.size(), r.branches.size());
    for (std::size_t i = 0; i < r.branches.size(); ++i) {
      EXPECT_NEAR(rest->branches[i].T_from, r.branches[i].T_from, 1e-6 * largest);
      EXPECT_NEAR(rest->branches[i].T_to, r.branches[i].T_to, 1e-6 * largest);
    }
  }
  RecordProperty("without_equilibrium", without);
}

/// A tight line in segments far from the origin: rounding of its places moves its middle by more than of its lengths.
TEST(RestOfMotion, ATightLineInSegmentsSettles) {
  for (const double mass : {250.0, 550.0, 700.0, 950.0}) {
    machine::Model m;
    m.bodies.push_back(body("carriage", {150, 0, 24}, mass, "xz"));
    m.reevings.push_back(reeve("line",
                               {anchor("a", {0, 0, 30}), sheave("car", origin, 0, 1, 1, 0), anchor("b", {300, 0, 30})},
                               299.6, 49, 7e7));
    m.reevings[0].mass = 5;
    m.reevings[0].segments = 20;
    TransientOptions options = lasting(0.05, 1e-4);
    options.start = Start::settled;
    const TransientResult r = transient(m, options);
    ASSERT_TRUE(r.outcome.ok()) << mass << " " << r.outcome.message;
    const EquilibriumResult rest = equilibrium(m);
    ASSERT_TRUE(rest.outcome.ok()) << rest.outcome.message;
    EXPECT_NEAR(r.frames[0].bodies[0].position.z(), rest.state.bodies[0].position.z(), 2e-2) << mass;
  }
}

/// A load on a rope of 3 kg/m from a drum over a sheave, its place guessed, beside a cylinder: statics does not know
/// such a machine, so that it comes to rest from the guess.
machine::Model lowered_beside_a_cylinder(double guess) {
  machine::Model m;
  m.bodies = {body("load", {10.2, 0, guess}, 2000, "xz"), body("ram", {20, 0, 0}, 10, "x")};
  m.reevings.push_back(reeve("rope",
                             {add_drum(m, "winch", {-1, 0, 0.5}, 0.2), sheave("head", {10, 0, 0}, 0.2, 1),  //
                              anchor_on("load", 0)},
                             16, 30, 12e6));
  m.reevings[0].mass = 3;
  m.reevings[0].damping_time = 0.02;
  m.drums[0].drive = {taut::machine::DriveKind::speed, smooth_move(0, -1, 0.5, 0.5)};
  m.actuators.push_back({});
  m.actuators[0].name = "cylinder";
  m.actuators[0].kind = taut::machine::ActuatorKind::law;
  m.actuators[0].from = {15, 0, 0};
  m.actuators[0].to_body = 1;
  m.actuators[0].gain = 1000;
  m.actuators[0].signal = smooth_move(0, 0, 0, 1);
  return m;
}

// What lies on the drum has the strain of the rope at rest, and the masses that the rope shares out are by its lengths
// there, however far off the guess.
TEST(RestOfMotion, TheGuessLeavesNoTrace) {
  std::optional<TransientFrame> near;
  for (const double guess : {-4.7, -4.0, -8.0}) {
    TransientOptions options = lasting(3, 1e-7);
    options.start = Start::settled;
    const TransientResult r = run_to_end(lowered_beside_a_cylinder(guess), options);
    const TransientFrame& last = r.frames.back();
    if (!near) near = last;
    EXPECT_NEAR(last.bodies[0].position.z(), near->bodies[0].position.z(), 1e-5) << guess;
    EXPECT_NEAR(last.branches[1].unstretched, near->branches[1].unstretched, 1e-5) << guess;
    EXPECT_NEAR(last.branches[1].T_to, near->branches[1].T_to, 1e-5 * near->branches[1].T_to) << guess;
    // unstretched as it lay on the drum: 2.25 m in all at 1 m/s, less the strain of the rope at rest
    const double paid = r.frames.back().branches[0].unstretched + r.frames.back().branches[1].unstretched -
                        r.frames.front().branches[0].unstretched - r.frames.front().branches[1].unstretched;
    EXPECT_NEAR(paid, 2.25 / (1 + r.frames.front().branches[0].T_from / 12e6), 1e-4) << guess;
  }
}

}  // namespace
}  // namespace taut_test::rest_test
