// Random carriages on random lines: several rollers, heights, haul ropes, mainlines with haulbacks. A result closes, is
// the same when mirrored or turned in plan, and what has none says why.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/solve/equilibrium.hpp"
#include "test/support/dice.hpp"
#include "test/support/machines.hpp"
#include "test/support/refused.hpp"

namespace random_carriages_test {

using namespace taut_test;
using namespace taut::solve;

struct Line {
  machine::Model model;
  EquilibriumOptions options;
  double length = 0;
  int kind = 0;
};

/// A haul rope below the supports `p`, from a drive at the first to a sheave at the last and back, gripped in the span
/// `loaded`.
void add_haul_rope(machine::Model& m, const std::vector<Vector3>& p, std::size_t loaded, double excess) {
  const Vector3 below(0, 0, -2);
  machine::Node drive = over("drive", p.front() + below);
  drive.kind = machine::NodeKind::drive;
  std::vector<machine::Node> nodes{drive};
  double length = 0;
  for (std::size_t i = 1; i < p.size(); ++i) {
    length += 2 * (p[i] - p[i - 1]).norm();
    if (i - 1 == loaded) {
      nodes.push_back(anchor_on("car", 0));
      nodes.back().kind = machine::NodeKind::clamp;
      nodes.back().length_before = (p[i] - p[0]).norm();
      m.carriages[0].grip = machine::Grip{.reeving = 1, .node = static_cast<int>(nodes.size()) - 1};
    }
    nodes.push_back(over(i + 1 < p.size() ? "guide" : "wheel", p[i] + below));
  }
  m.reevings.push_back(reeve("haul", nodes, length * excess, 5, 5e6));
  m.reevings.back().closed = true;
  m.reevings.back().haul = 1;
}

Line random_line(unsigned seed) {
  Dice dice{std::mt19937(seed)};
  Line line;
  line.kind = dice.below(3);
  const int spans = 1 + dice.below(3);
  const auto loaded = static_cast<std::size_t>(dice.below(spans));
  std::vector<Vector3> p{{0, 0, 0}};
  double sky = 0;
  for (int i = 0; i < spans; ++i) {
    const double dx = dice.in(40, 150);
    p.emplace_back(p.back() + Vector3(dx, 0, dx * dice.in(-0.5, 0.5)));
    sky += (p[p.size() - 1] - p[p.size() - 2]).norm();
  }
  line.length = sky;
  machine::Model& m = line.model;
  const int count = 1 + dice.below(2);
  const double height = dice.below(2) == 0 && count == 1 ? 0 : dice.in(0.1, 0.8), base = dice.in(0.3, 2);
  machine::Body car =
      body("car", (p[loaded] + p[loaded + 1]) / 2 - Vector3(0, 0, 3), std::pow(10, dice.in(2, 3.7)), "xyz");
  if (count > 1 || height > 0) car.free.push_back({Vector3::Zero(), Vector3::UnitY()});
  machine::turn_along(car, p[loaded + 1] - p[loaded], count);
  m.bodies.push_back(car);
  m.carriages.push_back({"car", 0, 0, static_cast<int>(loaded) + 1, {}, count});
  std::vector<machine::Node> nodes{anchor("a", p[0])};
  const double mu = dice.in(0, 0.2);
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    for (int k = 0; i == loaded && k < count; ++k) {
      nodes.push_back(over("car", {count > 1 ? base * (k - 0.5) : 0, 0, height}, 0));
      nodes.back().support = -Vector3::UnitZ();
    }
    nodes.push_back(i + 2 < p.size() ? saddle("support", p[i + 1], mu) : anchor("b", p[i + 1]));
  }
  m.reevings.push_back(reeve("skyline", nodes, sky * dice.in(1.0, 1.1), std::pow(10, dice.in(0.5, 1.6)), 2e7));
  line.options.prescribed =
      machine::Prescribed{.carriage = 0, .x = p[loaded].x() + dice.in(0.1, 0.9) * (p[loaded + 1].x() - p[loaded].x())};
  if (line.kind == 1) add_haul_rope(m, p, loaded, dice.in(1.001, 1.03));
  if (line.kind == 2) {
    m.reevings.push_back(reeve("mainline", {anchor("w", p.back()), anchor_on("car", 0)}, sky / 2, 6, 6e6));
    m.reevings.push_back(reeve("haulback", {anchor("t", p.front()), anchor_on("car", 0)}, sky / 2, 4, 4e6));
    m.reevings[2].given = machine::Given::tension_at_start;
    m.reevings[2].value = dice.in(2e3, 3e4);
    m.carriages[0].mainline = 1;
    m.carriages[0].haulback = 2;
  }
  line.options.motion = std::vector{Motion::at_rest, Motion::in, Motion::out}[static_cast<std::size_t>(dice.below(3))];
  line.options.band = false;
  return line;
}

/// The line moved by `turn` (a rotation about z, or a mirror image in a plane through z), axes of pitch included.
Line moved(Line line, const taut::Matrix3& turn) {
  for (machine::Body& b : line.model.bodies) {
    b.position = turn * b.position;
    b.orientation = turn * b.orientation;
    if (turn.determinant() < 0) b.orientation.col(1) *= -1;  // stays right-handed
    for (machine::Freedom& way : b.free) way = {.along = turn * way.along, .about = turn * way.about};
  }
  for (machine::Reeving& r : line.model.reevings) {
    for (machine::Node& n : r.nodes) {
      if (n.at.body == machine::ground) n.at.at = turn * n.at.at;
    }
  }
  line.options.prescribed->along = turn * line.options.prescribed->along;
  return line;
}

RC_GTEST_PROP(RandomCarriages, AResultCloses, (unsigned seed)) {
  const Line line = random_line(seed);
  const EquilibriumResult r = equilibrium(line.model, line.options);
  if (!r.outcome.ok()) return refused(r);
  double largest = 0;
  for (const RopeResult& rope : r.ropes) largest = std::max(largest, rope.T_max);
  RC_ASSERT(r.closure.rope <= 1e-9 * line.length);
  RC_ASSERT(r.closure.force <= 1e-8 * largest);
  RC_ASSERT(r.closure.balance <= 1e-7 * largest);
  for (std::size_t k = 0; k < line.model.reevings.size(); ++k) {
    const machine::Reeving& rope = line.model.reevings[k];
    const bool free = line.kind == 2 && k == 1;
    if (rope.given == machine::Given::length && !free)
      RC_ASSERT(std::abs(r.ropes[k].unstretched - rope.value) <= 1e-9 * rope.value);
  }
  RC_ASSERT(std::abs(r.state.bodies[0].position.x() - line.options.prescribed->x) <= 1e-9 * line.length);
}

TEST(RandomCarriages, AreFoundAndTheSameMirroredAndTurned) {
  int found = 0, same = 0;
  constexpr int lines = 300;
  for (unsigned seed = 0; seed < lines; ++seed) {
    const Line line = random_line(seed);
    const EquilibriumResult r = equilibrium(line.model, line.options);
    if (!r.outcome.ok()) continue;
    ++found;
    const taut::Matrix3 turn = Eigen::AngleAxisd(0.1 + seed, Vector3::UnitZ()).toRotationMatrix();
    const taut::Matrix3 mirror = Vector3(-1, 1, 1).asDiagonal();
    bool equal = true;
    for (const taut::Matrix3& by : {turn, mirror}) {
      const Line other = moved(line, by);
      const EquilibriumResult o = equilibrium(other.model, other.options);
      equal = equal && o.outcome.ok();
      for (std::size_t k = 0; equal && k < r.ropes.size(); ++k)
        equal = std::abs(o.ropes[k].T_max / r.ropes[k].T_max - 1) < 1e-8;
      equal = equal && (o.state.bodies[0].position - by * r.state.bodies[0].position).norm() < 1e-8 * line.length;
    }
    same += equal ? 1 : 0;
  }
  // what is not found: mainlines that would have to push, carriages that their ropes turn over; some have two answers
  EXPECT_GE(found, lines * 9 / 10);
  EXPECT_GE(same, found * 97 / 100);
}

}  // namespace random_carriages_test
