#include "taut/solve/motion/parts/line.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/build.hpp"
#include "test/support/machines.hpp"
#include "test/support/transient_runs.hpp"

/// One free line: its law and what of its weight its ends bear, by hand; how it follows its bodies, by differences.
namespace taut::solve::dynamics::transient_line_test {

using namespace taut_test;

TEST(TransientLine, ItsTensionIsBoundedByTwiceItsStretch) {
  Line line;
  line.stiffness = 1e6;
  line.damping = 0.01;
  const auto T = [&](double e, double rate) {
    LineValues now;
    now.e = e;
    now.e_rate = rate;
    pull(line, now);
    for (const bool by_rate : {false, true}) {  // its derivatives
      LineValues more = now, less = now;
      (by_rate ? more.e_rate : more.e) += 1e-9;
      (by_rate ? less.e_rate : less.e) -= 1e-9;
      pull(line, more);
      pull(line, less);
      EXPECT_NEAR((more.T - less.T) / 2e-9, by_rate ? now.T_rate : now.T_e, 1) << e << " " << rate;
    }
    return now.T;
  };
  EXPECT_EQ(T(-1e-3, 5), 0);  // slack: no damper holds it
  EXPECT_NEAR(T(1e-3, 0), 1e3, 1e-9);
  EXPECT_NEAR(T(1e-3, 0.05), 1.5e3, 1e-9);
  EXPECT_NEAR(T(1e-3, -0.05), 0.5e3, 1e-9);
  EXPECT_NEAR(T(1e-3, 0.5), 2e3, 1e-9);  // no more than twice
  EXPECT_EQ(T(1e-3, -0.5), 0);           // and it can't push
}

/// Both ends are the tighter the tighter the line is: what one of them is given, gives the line one tension. Beyond its
/// weight an end bears half of it, below that 0.9 of the tension, of a slack line nothing.
TEST(TransientLine, BothEndsGrowWithItsTension) {
  for (const double half : {400.0, -400.0}) {
    EXPECT_EQ(hung_at_ends(half, 0), 0);
    EXPECT_EQ(hung_at_ends(half, -100), 0);  // a damper that pushes within an iteration bears none
    EXPECT_NEAR(hung_at_ends(half, 100), std::copysign(90, half), 1e-12);
    EXPECT_EQ(hung_at_ends(half, 400 / 0.9 + 1), half);
    double upper = 0, lower = 0;
    for (double T = 1; T < 2000; T += 7) {
      const double more = T + hung_at_ends(half, T), less = T - hung_at_ends(half, T);
      EXPECT_GT(more, upper);
      EXPECT_GT(less, lower);
      EXPECT_GE(std::min(more, less), 0);
      upper = more;
      lower = less;
    }
  }
}

/// Newton's way to a tension T at which the end that bears more has a given one: with 400 N of half a weight the
/// tangent from 600 N leads below 0 for less than 400 N; the chord leads to the answer from anywhere, without a tension
/// below 0.
TEST(TransientLine, TheChordFindsATensionThatTheTangentMisses) {
  constexpr double half = 400;
  const auto at_end = [&](double T) { return T + hung_at_ends(half, T); };
  const auto step = [&](double T, double given, bool steady) {
    const HungByTension share = hung_by_tension(half, T, steady);
    EXPECT_EQ(hung_by_tension(-half, T, steady)[0].has_value(), share[1].has_value());  // the other way round
    return T - (at_end(T) - given) / (1 + hung_slope(share[1], 0, 1));
  };
  EXPECT_LT(step(600, 20, false), 0);
  for (const double given : {0.01, 20.0, 700.0, 844.0, 2000.0}) {
    double T = 600;
    for (int i = 0; i < 60; ++i) {
      T = step(T, given, true);
      ASSERT_GT(T, 0) << given;
    }
    EXPECT_NEAR(at_end(T), given, 1e-9 * given);
  }
  for (const bool steady : {false, true}) {  // where it bears as much as its tension allows, both ends do
    const HungByTension share = hung_by_tension(half, 100, steady);
    EXPECT_EQ(hung_slope(share[0], 1e9, 2), 1.8);
    EXPECT_EQ(hung_slope(share[1], 1e9, 2), 1.8);
    EXPECT_EQ(hung_slope(hung_by_tension(half, 0, steady)[0], 1e9, 2), 1.8);
  }
  EXPECT_EQ(hung_slope(hung_by_tension(half, 600, true)[0], 7, 2), 7);  // the end that bears less
}

/// A rope of 800 N hangs upright from a drum that pulls with what it is given, on an eye in the ground; or from an eye
/// down to that drum.
TEST(TransientLine, ADrumsPullGivesAHeavyRopeOneTension) {
  for (const bool below : {false, true}) {
    for (const double given : {20.0, 300.0, 700.0, 1000.0, 5000.0}) {
      machine::Model m;
      const machine::Node winch = add_drum(m, "winch", {0, 0, below ? -20.0 : 0.0}, 0.3, below ? -1 : 1);
      m.drums[0].drive.kind = machine::DriveKind::pull;
      m.drums[0].drive.signal.law = given;
      m.reevings.push_back(reeve("rope", {winch, anchor("eye", {0.3, 0, below ? 0.0 : -20.0})}, 20, 40, 1e7));
      const TransientResult r = run_to_end(m, lasting(0.01, 1e-8));
      const TransientFrame::Branch& rope = r.frames.back().branches[0];
      const double half = 40 * rope.unstretched / 2;
      EXPECT_NEAR(half, 400, 1);
      // T + half or T - half at the drum, with at most 0.9 T for half: whichever is larger or less
      const double T = below ? std::min(given + half, given / 0.1) : std::max(given - half, given / 1.9);
      EXPECT_NEAR(rope.T_from, given, 1e-6 * given) << below;
      EXPECT_NEAR(rope.T_to, 2 * T - given, 1e-6 * given) << below;
    }
  }
}

/// A line between bodies that turn: rounds with parallel axes, askew ones, points.
struct Turning {
  machine::Model m;
  Built built;

  explicit Turning(LineKind kind) {
    const char* const free = kind == LineKind::planar ? "xyzY" : "xyzXYZ";
    m.bodies = {body("a", {0.2, 0.1, 0}, 50, free), body("b", {6, 0.4, 2}, 60, free)};
    machine::Node from = anchor_on("from", 0, {0.1, 0.2, -0.1}), to = anchor_on("to", 1, {-0.2, 0.1, 0.3});
    for (machine::Body& one : m.bodies) one.inertia = Vector3::Ones();
    if (kind != LineKind::points) {
      from.radius = 0.4;
      to.radius = 0.25;
      to.side = -1;
    }
    if (kind == LineKind::skew) to.axis = Vector3(0.3, 1, -0.2).normalized();
    m.reevings.push_back(reeve("rope", {from, to}, 7, 0, 1e6));
    built = build(m, assembled(m), {});
    EXPECT_EQ(built.mechanism.lines[0].kind, kind);
  }

  /// The line after a small move of a freedom of a body.
  LineValues moved(std::size_t of, std::size_t freedom, double by) const {
    std::vector<Motion3> bodies = built.values.bodies;
    const Body& shape = built.mechanism.bodies[of];
    Motion3& one = bodies[of];
    one.x += by * shape.along[freedom];
    one.turned = by * shape.about[freedom];
    one.R = Eigen::AngleAxisd(by, shape.about[freedom]).toRotationMatrix() * one.R;
    if (shape.about[freedom] == Vector3::Zero()) one.R = built.values.bodies[of].R;
    LineValues now = built.values.lines[0];
    EXPECT_TRUE(place_line(built.mechanism.lines[0], bodies, built.values.lines[0], now));
    for (std::size_t end = 0; end < 2; ++end) now.touch[end] -= bodies[end].x;
    return now;
  }
};

TEST(TransientLine, ItFollowsItsBodiesAsDifferencesDo) {
  for (const LineKind kind : {LineKind::points, LineKind::planar, LineKind::skew}) {
    const Turning of(kind);
    const Mechanism& m = of.built.mechanism;
    const LineValues& now = of.built.values.lines[0];
    std::array<LineColumn, 14> columns, velocities;
    line_columns(m.lines[0], m.bodies, of.built.values.bodies, now, columns);
    line_velocities(m.lines[0], m.bodies, of.built.values.bodies, now, velocities);
    std::size_t k = 0;
    for (std::size_t b = 0; b < 2; ++b) {
      for (std::size_t f = 0; f < as_size(m.bodies[b].count); ++f, ++k) {
        const double h = 1e-6;
        const LineValues ahead = of.moved(b, f, h), back = of.moved(b, f, -h);
        const LineColumn& c = columns[k];
        EXPECT_NEAR(c.l, (ahead.l - back.l) / (2 * h), 1e-8) << k;
        EXPECT_LT((c.t - (ahead.t - back.t) / (2 * h)).norm(), 1e-8) << k;
        for (std::size_t end = 0; end < 2; ++end) {
          EXPECT_LT((c.touch[end] - (ahead.touch[end] - back.touch[end]) / (2 * h)).norm(), 1e-7) << k << end;
          if (kind == LineKind::points) continue;
          EXPECT_NEAR(c.angle[end], (ahead.angle[end] - back.angle[end]) / (2 * h), 1e-7) << k << end;
        }
        const Vector3 arm = now.touch[b] - of.built.values.bodies[b].x;
        const Vector3 velocity = m.bodies[b].along[f] + m.bodies[b].about[f].cross(arm);
        EXPECT_LT((c.velocity - velocity).norm(), 1e-12);
        EXPECT_EQ(velocities[k].velocity, c.velocity);
      }
    }
  }
}

/// Where crossed rounds come nearer than their radii there is no line; nor between two points at one place.
TEST(TransientLine, RopeOnItsRoundsIsWhatTheFreeRopeLeaves) {
  LineValues line;
  line.l = 10;
  line.e = 0.01;
  for (const double arc : {0.6, -0.4}) {  // below 0: it passes that round without touching it
    line.arc = {arc, 0.2};
    line.L = (line.l + arc + 0.2) / 1.01;
    EXPECT_NEAR(lies_on_round(line, 0), arc / 1.01, 1e-12);
    EXPECT_NEAR(lies_on_round(line, 0) + lies_on_round(line, 1) + free_rope(line), line.L, 1e-12);
    EXPECT_NEAR(free_rope(line), line.l / 1.01, 1e-12);
  }
  line.gone = 0;
  line.arc = {0.6, 0.2};
  line.L = 0.4;  // a dead end, all of it on the rounds
  EXPECT_NEAR(lies_on_round(line, 0), 0.3, 1e-12);
  EXPECT_NEAR(lies_on_round(line, 1), 0.1, 1e-12);
  EXPECT_EQ(free_rope(line), 0);
}

TEST(TransientLine, WithoutRoomThereIsNone) {
  const Turning of(LineKind::planar);
  std::vector<Motion3> bodies = of.built.values.bodies;
  const Line& line = of.built.mechanism.lines[0];
  LineValues now;
  for (const double apart : {0.651, 0.649}) {  // the sum of their radii is 0.65 m
    const Vector3 from = bodies[0].x + bodies[0].R * line.place[0], to = bodies[1].R * line.place[1];
    bodies[1].x = from - to + apart * Vector3(0.6, 0, 0.8);
    EXPECT_EQ(place_line(line, bodies, of.built.values.lines[0], now), apart > 0.65);
  }
  Line points;
  points.place = {Vector3(1, 2, 3), Vector3(1, 2, 3)};
  EXPECT_FALSE(place_line(points, {}, LineValues(), now));
  points.place[1].z() += 1e-6;
  EXPECT_TRUE(place_line(points, {}, LineValues(), now));
}

}  // namespace taut::solve::dynamics::transient_line_test
