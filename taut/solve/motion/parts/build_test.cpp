#include "taut/solve/motion/parts/build.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "taut/math/index.hpp"
#include "test/support/machines.hpp"

/// The machine as arrays: that no mass is lost and none counted twice, that every unknown has its own column, how lines
/// and rounds are told apart.
namespace taut::solve::dynamics::transient_build_test {

using namespace taut_test;

Built built_of(const machine::Model& m, const TransientOptions& options = {}) {
  Built built = build(m, assembled(m), options);
  EXPECT_TRUE(built.outcome.ok()) << built.outcome.message;
  return built;
}

/// About the origin of the body, kg m2.
Matrix3 about_origin(double mass, const Vector3& at) {
  return mass * (at.squaredNorm() * Matrix3::Identity() - at * at.transpose());
}

/// Mass, first and second moments about the body's origin are sums over what lies on it; its weight stays its own.
TEST(TransientBuild, HalfOfEachRopesMassLiesAtItsEnds) {
  machine::Model m;
  machine::Body lug = body("block", {0, 0, 5}, 200, "xyzXYZ");
  lug.centre = {0.1, 0.2, -0.3};
  lug.inertia = {9, 12, 15};
  m.bodies.push_back(lug);
  const Vector3 at(0.4, -0.2, 0.6), hung(0, 0.1, -0.7);
  m.reevings.push_back(reeve("guy", {anchor("stump", {-9, 0, 0}), anchor_on("lug", 0, at)}, 10.4, 50, 1e6));
  m.reevings[0].copies = 2;
  m.reevings[0].thermal_strain = 4e-3;
  m.loads.push_back({{0, hung}, {0, 0, -600}, 600 / m.gravity});
  const Built built = built_of(m);
  const Body& is = built.mechanism.bodies[0];
  // by the warm length, which the given cold one is more than
  const double rope = 2 * 50 / 1.004 / m.gravity * (10.4 * 1.004) / 2, load = 600 / m.gravity;
  EXPECT_NEAR(is.mass, 200 + rope + load, 1e-9);
  EXPECT_LT((is.mass * is.centre - (200 * lug.centre + rope * at + load * hung)).norm(), 1e-9);
  const Matrix3 all = is.inertia + about_origin(is.mass, is.centre);
  const Matrix3 sum = Matrix3(lug.inertia.asDiagonal()) + about_origin(200, lug.centre) + about_origin(rope, at) +
                      about_origin(load, hung);
  EXPECT_LT((all - sum).norm(), 1e-9 * sum.norm());
  EXPECT_EQ(is.own_mass, 200);
  EXPECT_EQ(is.own_centre, lug.centre);
  TransientOptions light;
  light.rope_mass = false;
  const Built without = built_of(m, light);
  EXPECT_NEAR(without.mechanism.bodies[0].mass, 200 + load, 1e-9);
  EXPECT_EQ(without.mechanism.lines[0].weight, 0);
}

/// Of a rope in segments the joints have all of it but what lies at its ends.
TEST(TransientBuild, AChainHasTheMassOfItsRope) {
  machine::Model m = with_carriage(false);
  m.reevings[0].segments = 5;
  const Built built = built_of(m);
  const Mechanism& is = built.mechanism;
  ASSERT_EQ(is.lines.size(), 20U);
  ASSERT_EQ(is.inside[0].size(), 16U);
  double all = 0, ends = 0;
  for (const Body& one : is.bodies) all += one.mass;
  for (std::size_t i = 0; i < is.lines.size(); ++i) {
    const Line& line = is.lines[i];
    EXPECT_EQ(line.segment, static_cast<int>(i % 5));
    for (const int end : line.body) ends += end < 0 ? 20 / m.gravity * built.values.lines[i].L / 2 : 0;
    if (line.segment > 0) {
      EXPECT_EQ(line.body[0], is.lines[i - 1].body[1]);  // one joint
    }
  }
  EXPECT_NEAR(all + ends, 2000 + 20 / m.gravity * 318, 1e-7);
  ASSERT_EQ(is.contacts.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(is.contacts[k].in, static_cast<int>(5 * k + 4));
    EXPECT_EQ(is.contacts[k].out, static_cast<int>(5 * k + 5));
  }
}

TEST(TransientBuild, EveryUnknownHasItsColumn) {
  machine::Model m = boom();
  m.reevings[1].nodes[1].inertia = 2;
  m.reevings[0].segments = 3;
  const Built built = built_of(m);
  const Mechanism& is = built.mechanism;
  std::vector<int> columns;
  for (const Body& one : is.bodies) {
    for (int f = 0; f < one.count; ++f) columns.push_back(one.first + f);
  }
  for (const Contact& one : is.contacts) columns.push_back(one.column);
  for (const Spin& one : is.spins) columns.push_back(one.column);
  std::sort(columns.begin(), columns.end());
  std::vector<int> all(as_size(is.size));
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(columns, all);
  EXPECT_EQ(is.size, 1 + 3 + 2 * 3 + 1 + 1);  // boom, hook, two joints, a flow, a spin
  for (const Line& line : is.lines) {         // freedoms of its bodies, then the flows at its ends
    std::vector<int> own;
    for (const int end : line.body) {
      for (int f = 0; end >= 0 && f < is.bodies[end].count; ++f) own.push_back(is.bodies[end].first + f);
    }
    for (const int end : line.contact) {
      if (end >= 0) own.push_back(is.contacts[end].column);
    }
    EXPECT_EQ(own, std::vector<int>(line.column.begin(), line.column.begin() + line.columns));
  }
}

LineKind kind_of(const machine::Node& from, const machine::Node& to, const std::string& free = "",
                 const machine::DrivenWay* driven = nullptr) {
  machine::Model m;
  m.bodies.push_back(body("body", {6, 0, 1}, 50, free));
  m.bodies[0].inertia = Vector3::Ones();
  if (driven) m.bodies[0].driven.push_back(*driven);
  m.reevings.push_back(reeve("rope", {from, to}, 1e3, 0, 1e6));
  m.reevings[0].given = machine::Given::tension_at_start;
  return built_of(m).mechanism.lines.at(0).kind;
}

TEST(TransientBuild, LinesAreFlatWhereTheirRoundsStayParallel) {
  machine::Node point = anchor("a", {0, 0, 0}), drum = point, far = anchor_on("b", 0), on = far;
  drum.radius = 0.3;
  on.radius = 0.2;
  EXPECT_EQ(kind_of(point, far), LineKind::points);
  EXPECT_EQ(kind_of(drum, far, "xyzXYZ"), LineKind::planar);  // however a point turns
  EXPECT_EQ(kind_of(point, on, "xyzY"), LineKind::planar);
  EXPECT_EQ(kind_of(point, on, "xyzZ"), LineKind::skew);
  EXPECT_EQ(kind_of(drum, on, "Y"), LineKind::planar);
  EXPECT_EQ(kind_of(drum, on, "X"), LineKind::skew);
  machine::DrivenWay about_y{Vector3::Zero(), Vector3::UnitY(), {}}, about_z{Vector3::Zero(), Vector3::UnitZ(), {}};
  EXPECT_EQ(kind_of(drum, on, "", &about_y), LineKind::planar);
  EXPECT_EQ(kind_of(drum, on, "", &about_z), LineKind::skew);
  on.axis = Vector3(0.1, 1, 0).normalized();
  EXPECT_EQ(kind_of(drum, on), LineKind::skew);
  on.axis = -Vector3::UnitY();
  on.side = -1;
  EXPECT_EQ(kind_of(drum, on), LineKind::planar);  // the other way round, the same round
}

/// Two ropes on one drum turn it together: both take in where it does, whichever of their ends lies there.
TEST(TransientBuild, ADrumHasOneSpinForAllItsRopes) {
  machine::Model m;
  m.bodies = {body("left", {-3, 0, -8}, 100, "z"), body("right", {3, 0, -8}, 100, "z")};
  // its path runs out to the right over the top: where the drum turns left it comes in
  const machine::Node drum = add_drum(m, "winch", origin, 0.25, 1);
  m.drums[0].inertia = 6;
  machine::Node other = drum;
  other.side = -1;  // this one's path ends there, from the right over the top: the same
  m.reevings = {reeve("a", {drum, anchor_on("right", 1)}, 8.6, 0, 1e6),
                reeve("b", {anchor_on("right", 1), other}, 8.6, 0, 1e6)};
  machine::Node wheel = sheave("wheel", {-3, 0, 4}, 0.2, 1);
  wheel.inertia = 0.5;
  machine::Node light = sheave("light", {-5, 0, 4}, 0.2, 1), stone = saddle("stone", {-7, 0, 3}, 0.3);
  stone.inertia = 3;  // it does not turn
  m.reevings.push_back(reeve("c", {anchor("pin", {-12, 0, 0}), stone, light, wheel, anchor_on("left", 0)}, 22, 0, 1e6));
  const Mechanism is = built_of(m).mechanism;
  ASSERT_EQ(is.spins.size(), 2U);
  EXPECT_EQ(is.spins[0].drum, 0);
  EXPECT_EQ(is.spins[0].inertia, 6);
  ASSERT_EQ(is.spins[0].contacts.size(), 2U);
  for (const auto& [contact, sense] : is.spins[0].contacts) {
    const Contact& at_drum = is.contacts[contact];
    EXPECT_EQ(sense, at_drum.reeving == 0 ? -1 : 1);  // against the path where it begins there
    const machine::Node& node = m.reevings[at_drum.reeving].nodes[at_drum.node];
    EXPECT_EQ(is.spins[0].axis, sense * node.side * node.axis);  // both about the same axis in the same sense
  }
  EXPECT_EQ(is.spins[1].drum, -1);
  EXPECT_EQ(is.spins[1].inertia, 0.5);
  ASSERT_EQ(is.contacts.size(), 5U);
  EXPECT_EQ(is.contacts[2].spin, -1);
  EXPECT_EQ(is.contacts[3].spin, -1);
  EXPECT_EQ(is.contacts[4].spin, 1);
}

}  // namespace taut::solve::dynamics::transient_build_test
