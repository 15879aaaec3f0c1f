#include "taut/mechanics/rope_load.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

// Forces along the free rope against closed forms and against the rope's differential equation, integrated along it.
namespace rope_load_test {

using namespace taut;
using namespace taut_test;

/// A load on the first rope, before the node `before`.
void add_load(machine::Model& m, int before, const machine::RopeLoad& load) {
  const auto b = static_cast<int>(m.bodies.size());
  const auto& nodes = m.reevings[0].nodes;
  const Vector3 &from = nodes.front().at.at, &to = nodes.back().at.at;
  m.bodies.push_back(body("load", from + load.share * (to - from), 0, "xyz"));
  machine::Node node = anchor_on("load", b);
  node.kind = machine::NodeKind::load;
  node.load = load;
  m.reevings[0].nodes.insert(m.reevings[0].nodes.begin() + before, node);
}

machine::RopeLoad point_load(double share, double force, int sense) {
  machine::RopeLoad load;
  load.share = share;
  load.force = force;
  load.sense = sense;
  return load;
}

void add_rate(machine::Model& m, double from, double to, double rate, int elements, int sense) {
  for (int i = 0; i < elements; ++i) {
    machine::RopeLoad load = point_load(from + (to - from) * (i + 0.5) / elements, 0, sense);
    load.rate = rate;
    load.part = (to - from) / elements;
    add_load(m, 1 + i, load);
  }
}

machine::Model span(double weight, double length) {
  machine::Model m;
  m.reevings.push_back(reeve("saw", {anchor("a", {0, 0, 3}), anchor("b", {60, 8, -4})}, length, weight, 2e6));
  return m;
}

double chord() { return Vector3(60, 8, -7).norm(); }

/// Along a rope by unstretched metres s: q from one place to another, the force F at a place.
struct AlongRope {
  double q = 0, from = 0, to = 0;
  double F = 0, place = 0;
};

/// The end of a rope that starts with the pull `T` and feels w downwards and `load` along itself. Runge-Kutta of fourth
/// order, steps that end at the point load.
Vector3 end_by_integration(Vector3 T, double w, double EA, double L, const AlongRope& load) {
  const auto& [q, from, to, F, place] = load;
  const auto rope_rate = [&](double s, const Vector3& t, Vector3& dT) -> Vector3 {
    const Vector3 d = t.normalized();
    dT = w * Vector3::UnitZ() - (s > from && s < to ? q : 0) * d;
    return (1 + t.norm() / EA) * d;
  };
  Vector3 x = Vector3::Zero();
  std::vector<double> stops = {0, from, to, place, L};
  std::sort(stops.begin(), stops.end());
  for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
    const int steps = 2000;
    const double h = (stops[k + 1] - stops[k]) / steps;
    if (h <= 0) continue;
    if (stops[k] == place && F != 0) T -= F * T.normalized();
    const double inside = (stops[k] + stops[k + 1]) / 2;
    for (int i = 0; i < steps; ++i) {
      Vector3 a, b, c, e;
      const Vector3 xa = rope_rate(inside, T, a);
      const Vector3 xb = rope_rate(inside, T + h / 2 * a, b);
      const Vector3 xc = rope_rate(inside, T + h / 2 * b, c);
      const Vector3 xe = rope_rate(inside, T + h * c, e);
      T += h / 6 * (a + 2 * b + 2 * c + e);
      x += h / 6 * (xa + 2 * xb + 2 * xc + xe);
    }
  }
  return x;
}

Vector3 start_pull(const solve::EquilibriumResult& r) {
  const auto& s = r.branches.front();
  Vector3 along = s.end - s.start;
  along.z() = 0;
  return s.H * along.normalized() + s.V_from * up();
}

TEST(RopeLoad, WithoutWeightTheTensionsShareTheForceByTheLengths) {
  for (const double share : {0.1, 0.5, 0.8}) {
    for (const int sense : {1, -1}) {
      machine::Model m = span(0, 60);
      add_load(m, 1, point_load(share, 4000, sense));
      const auto r = solve::equilibrium(m);
      ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
      const double T_1 = 2e6 * (chord() / 60 - 1) + sense * 4000 * (1 - share);
      EXPECT_NEAR(r.branches[0].T_to, T_1, 1e-9 * T_1);
      EXPECT_NEAR(r.branches[1].T_from, T_1 - sense * 4000, 1e-9 * T_1);
      EXPECT_NEAR(r.rope_loads.at(0).along_path, sense * 4000, 1e-9);
      EXPECT_LT(r.closure.balance, 1e-6);
    }
  }
}

TEST(RopeLoad, HeavyRopeAgreesWithItsDifferentialEquation) {
  for (const double length : {60.5, 61.5, 80.0}) {
    for (const int sense : {1, -1}) {
      machine::Model m = span(30, length);
      add_load(m, 1, point_load(0.3, 700, sense));
      const auto r = solve::equilibrium(m);
      ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
      EXPECT_NEAR(r.branches[0].unstretched, 0.3 * length, 1e-8);
      EXPECT_NEAR(r.branches[0].T_to - r.branches[1].T_from, sense * 700, 1e-6);
      const Vector3 end = end_by_integration(start_pull(r), 30, 2e6, length,
                                             {.q = 0, .from = 0, .to = 0, .F = sense * 700.0, .place = 0.3 * length});
      EXPECT_LT((end - Vector3(60, 8, -7)).norm(), 1e-6 * length) << length << ' ' << sense;
    }
  }
}

/// The closed form of an inextensible rope under its weight and a rate along itself would do as well; the equation is
/// integrated, so that the stretch is there.
double miss_of_rate(int elements) {
  machine::Model m = span(30, 62);
  add_rate(m, 0.2, 0.7, 40, elements, -1);
  const auto r = solve::equilibrium(m);
  EXPECT_TRUE(r.outcome.ok()) << r.outcome.message;
  EXPECT_NEAR(
      r.branches.back().T_from - r.branches.front().T_to - 30 * (r.branches.back().start - r.branches.front().end).z(),
      40 * 0.5 * 62, 0.02 * 40 * 31);
  const Vector3 end = end_by_integration(start_pull(r), 30, 2e6, 62, {.q = -40, .from = 0.2 * 62, .to = 0.7 * 62});
  return (end - Vector3(60, 8, -7)).norm();
}

TEST(RopeLoad, RateConvergesToTheDifferentialEquation) {
  const double coarse = miss_of_rate(8), fine = miss_of_rate(32);
  EXPECT_LT(coarse, 0.02);
  EXPECT_NEAR(coarse / fine, 16, 2) << "second order in the number of elements";
}

TEST(RopeLoad, RateOnAShortPartIsAPointLoad) {
  machine::Model point = span(30, 61);
  add_load(point, 1, point_load(0.4, 900, 1));
  const auto a = solve::equilibrium(point);
  const auto difference = [&](double half) {
    machine::Model rate = span(30, 61);
    add_rate(rate, 0.4 - half, 0.4 + half, 900 / (2 * half * 61), 8, 1);
    const auto b = solve::equilibrium(rate);
    EXPECT_TRUE(b.outcome.ok()) << b.outcome.message;
    return std::abs(a.branches.front().T_from - b.branches.front().T_from);
  };
  const double wide = difference(0.1), narrow = difference(0.01), narrower = difference(0.005);
  EXPECT_LT(wide, 1e-2 * a.branches.front().T_from);
  EXPECT_LT(narrow, 1e-4 * a.branches.front().T_from);
  EXPECT_NEAR(narrow / narrower, 2, 0.1) << "with the part's length: tension is convex there";
}

TEST(RopeLoad, EndsSwappedIsTheSameRope) {
  machine::Model there = span(30, 61);
  add_load(there, 1, point_load(0.3, 900, 1));
  machine::Model back = span(30, 61);
  std::swap(back.reevings[0].nodes[0], back.reevings[0].nodes[1]);
  add_load(back, 1, point_load(0.7, 900, -1));
  const auto a = solve::equilibrium(there), b = solve::equilibrium(back);
  ASSERT_TRUE(a.outcome.ok() && b.outcome.ok()) << a.outcome.message << b.outcome.message;
  EXPECT_NEAR(a.branches[0].T_from, b.branches[1].T_to, 1e-9 * a.branches[0].T_from);
  EXPECT_LT((a.rope_loads[0].at - b.rope_loads[0].at).norm(), 1e-8);
  EXPECT_LT((a.rope_loads[0].force - b.rope_loads[0].force).norm(), 1e-6);
}

TEST(RopeLoad, GoesByTheMotionOrByThePath) {
  machine::Model m = span(30, 61);
  machine::RopeLoad load = point_load(0.5, 500, -1);
  load.by_motion = true;
  add_load(m, 1, load);
  m.reevings[0].haul = 1;
  const auto force = [&](solve::Motion motion) {
    solve::EquilibriumOptions options;
    options.motion = motion;
    return solve::equilibrium(m, options).rope_loads.at(0).along_path;
  };
  EXPECT_NEAR(force(solve::Motion::in), -500, 1e-9);
  EXPECT_NEAR(force(solve::Motion::out), 500, 1e-9);
  EXPECT_NEAR(force(solve::Motion::at_rest), -500, 1e-9) << "as if hauling in";
  m.reevings[0].haul = -1;
  EXPECT_NEAR(force(solve::Motion::in), 500, 1e-9);
}

TEST(RopeLoad, CopiesCarryOneForceEach) {
  machine::Model m = span(30, 61);
  add_load(m, 1, point_load(0.3, 900, 1));
  const auto one = solve::equilibrium(m);
  m.reevings[0].copies = 3;
  const auto three = solve::equilibrium(m);
  ASSERT_TRUE(one.outcome.ok() && three.outcome.ok());
  EXPECT_NEAR(one.branches[0].T_from, three.branches[0].T_from, 1e-9 * one.branches[0].T_from);
  EXPECT_LT(three.closure.balance, 1e-6);
}

}  // namespace rope_load_test
