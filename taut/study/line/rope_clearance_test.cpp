#include "taut/study/line/rope_clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/rope/span.hpp"
#include "test/support/machines.hpp"

/// A rope hung as the catenary z = a cosh((x - 50)/a) + const over ground of one kind and another.
namespace taut_test::rope_clearance_test {
namespace {

constexpr double a = 200, span = 100, support = 20;  // m: H/w, between supports of one height

double rope_height(double x) { return support - a * (std::cosh(span / 2 / a) - std::cosh((x - span / 2) / a)); }

struct Line {
  machine::Model machine;
  taut::solve::BranchResult rope;
};

Line line_over(std::vector<machine::GroundPoint> ground) {
  Line line;
  line.machine.terrain = std::move(ground);
  line.machine.reevings.push_back(reeve("sky", {anchor("left", {0, 0, support}), anchor("right", {span, 0, support})},
                                        2 * a * std::sinh(span / 2 / a), 10, 1e13));
  const auto found = taut::solve::equilibrium(line.machine);
  EXPECT_TRUE(found.outcome.ok()) << found.outcome.message;
  line.rope = found.branches.at(0);
  return line;
}

using Pieces = taut::Array<taut::study::RopePiece>;

/// Straight from place to place.
Pieces through(const std::vector<Vector3>& places) {
  Pieces pieces;
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    pieces.push_back({.start = places[i], .end = places[i + 1], .shape = {}, .sag = 0});
  return pieces;
}

// A polyline of the same rope, against the exact search over its catenary: from above by the sag of its pieces alone.
TEST(RopeClearance, OfAPolylineIsThatOfTheRopeUpToTheSagOfItsPieces) {
  for (const auto& ground : {std::vector<machine::GroundPoint>{{.x = -10, .z = 0}, {.x = 110, .z = 0}},
                             {{.x = 0, .z = -5}, {.x = 100, .z = 5}},
                             {{.x = 0, .z = -9}, {.x = 30, .z = 12}, {.x = 31, .z = -9}, {.x = 100, .z = 3}}}) {
    const Line line = line_over(ground);
    const double exact = taut::study::rope_clearance(line.machine, line.rope).height;
    for (const int pieces : {16, 160}) {
      std::vector<Vector3> places;
      for (int i = 0; i <= pieces; ++i) {
        const double x = span * i / pieces;
        places.emplace_back(x, 0, rope_height(x));
      }
      const double found = taut::study::rope_clearance(line.machine, through(places), 0, 0, 1).height;
      const double sag = support - rope_height(span / 2);
      EXPECT_GE(found, exact - 1e-6);
      EXPECT_LE(found, exact + 1.1 * sag / (pieces * pieces) + 1e-6);
    }
  }
  const std::vector<Vector3> rising = {{0, 0, 15}, {50, 0, 18}, {100, 0, 14}};
  // on a support an end counts
  const auto with_support = [&](std::size_t end) {
    Line line = line_over({{.x = -10, .z = 15}, {.x = 110, .z = 15}});
    if (end < 2) {
      line.machine.reevings[0].nodes[end].kind = machine::NodeKind::contact;
      line.machine.reevings[0].nodes[end].law = {.friction = 0.1, .efficiency = 0};
    }
    return taut::study::rope_clearance(line.machine, through(rising), 0, 0, 1).height;
  };
  // 6 m before the right end, which is 1 m deep, the rope is 0.52 m deep still
  EXPECT_NEAR(with_support(0), -0.52, 1e-12);
  EXPECT_DOUBLE_EQ(with_support(1), -1);
  EXPECT_NEAR(with_support(2), -0.52, 1e-12);
}

TEST(RopeClearance, IsWhereTheRopeIsParallelToTheGroundOrOverAHilltop) {
  const auto least = [](std::vector<machine::GroundPoint> ground) {
    const Line line = line_over(std::move(ground));
    return taut::study::rope_clearance(line.machine, line.rope);
  };
  const auto flat = least({{.x = -10, .z = 0}, {.x = 110, .z = 0}});
  EXPECT_NEAR(flat.height, rope_height(50), 1e-6);
  EXPECT_NEAR(flat.place.x(), 50, 1e-4);
  const auto slope = least({{.x = 0, .z = -5}, {.x = 100, .z = 5}});
  const double x = 50 + a * std::asinh(0.1);  // where the catenary rises by 0.1
  EXPECT_NEAR(slope.place.x(), x, 1e-4);
  EXPECT_NEAR(slope.height, rope_height(x) - (0.1 * x - 5), 1e-6);
  const auto hill = least({{.x = 0, .z = 0}, {.x = 80, .z = 13}, {.x = 100, .z = 0}});
  EXPECT_NEAR(hill.place.x(), 80, 1e-6);
  EXPECT_NEAR(hill.height, rope_height(80) - 13, 1e-6);
  EXPECT_LT(least({{0, 0}, {50, 15}, {100, 0}}).height, 0);
}

// The same ground with many rows of the survey, whose rounding makes hilltops of them, and with a dip or a bump of 1
// mm.
TEST(RopeClearance, MoreRowsOfTheSameGroundChangeNothing) {
  for (const double rise : {0.0, 0.1, -0.07}) {
    const auto ground = [&](double x) { return support - 0.5 + rise * (x - 50) - 50 * std::abs(rise); };
    const auto least = [&](double step, double bump) {
      std::vector<machine::GroundPoint> rows;
      for (double x = 0; x <= 100.001; x += step) rows.push_back({.x = x, .z = ground(x)});
      if (bump != 0) rows[2].z += bump;
      const Line line = line_over(std::move(rows));
      return taut::study::rope_clearance(line.machine, line.rope).height;
    };
    const double two = least(100, 0);
    for (const double step : {5.0, 2.0, 1.0, 0.7}) EXPECT_NEAR(least(step, 0), two, 1e-9) << rise << " " << step;
    for (const double bump : {1e-3, -1e-3}) EXPECT_NEAR(least(1, bump), two, 2e-3) << rise << " " << bump;
  }
}

/// A rope may well begin at the ground where it is fixed; an end that moves with a body may not come down to it.
/// Ground that rises so steeply that it passes the rope at its end alone: an anchor 2 m in the ground is buried, one at
/// 4 m is a mistake.
TEST(RopeClearance, AFixedEndCountsWhereItIsDeeperThanAnAnchorIsBuried) {
  const auto least = [](double depth) {
    const Line line = line_over({{.x = -10, .z = 0}, {.x = 95, .z = 0}, {.x = 100, .z = support + depth}});
    const double exact = taut::study::rope_clearance(line.machine, line.rope).height;
    std::vector<Vector3> places;
    for (int i = 0; i <= 100; ++i) places.emplace_back(i, 0, rope_height(i));
    const double polyline = taut::study::rope_clearance(line.machine, through(places), 0, 0, 1).height;
    EXPECT_TRUE(exact > 0 || std::abs(polyline - exact) < 1e-6) << depth;
    return exact;
  };
  EXPECT_GT(least(-1), 0);
  EXPECT_GT(least(2), 0);
  EXPECT_NEAR(least(4), -4, 1e-6);
  EXPECT_NEAR(least(1000), -1000, 1e-6);
}

/// Ground that ends at 60 m, 10 m behind the lowest place of the rope, at this height there.
TEST(RopeClearance, WhereTheTerrainEndsTheRopeMayBeLowest) {
  std::vector<Vector3> places;
  for (int i = 0; i <= 100; ++i) places.emplace_back(i, 0, rope_height(i));
  const auto both = [&](const Line& line) {
    const auto exact = taut::study::rope_clearance(line.machine, line.rope);
    const double polyline = taut::study::rope_clearance(line.machine, through(places), 0, 0, 1).height;
    EXPECT_TRUE((std::isnan(exact.height) && std::isnan(polyline)) || std::abs(exact.height - polyline) < 1e-6)
        << exact.height << " " << polyline;
    return exact;
  };
  const auto ends_at = [](double x, double z) { return line_over({{.x = -10, .z = 0}, {.x = x, .z = z}}); };
  const auto deep = both(ends_at(60, 16));
  EXPECT_NEAR(deep.height, rope_height(60) - 16, 1e-6);
  EXPECT_NEAR(deep.place.x(), 60, 1e-9);
  // the same seen from the other end
  std::reverse(places.begin(), places.end());
  Line turned = line_over({{.x = 40, .z = 16}, {.x = 110, .z = 0}});
  EXPECT_NEAR(both(turned).height, rope_height(40) - 16, 1e-6);
  std::reverse(places.begin(), places.end());
  // the rope is 40 m from its end there, and below the line down to it
  EXPECT_NEAR(both(ends_at(60, 11)).height, rope_height(60) - 11, 1e-6);
  Line moves = ends_at(60, 11);
  moves.machine.bodies.push_back(body("car", {span, 0, support}, 10, "z"));
  moves.machine.reevings[0].nodes[1] = anchor_on("car", 0);
  EXPECT_NEAR(both(moves).height, rope_height(60) - 11, 1e-6);
  // 2 m before the anchor it may be buried
  const auto near_anchor = [&](double depth) {
    return line_over({{.x = -10, .z = 0}, {.x = 90, .z = 0}, {.x = 98, .z = rope_height(98) + depth}});
  };
  EXPECT_GT(both(near_anchor(-0.5)).height, 0);
  EXPECT_NEAR(both(near_anchor(4)).height, -4, 1e-6);
}

TEST(RopeClearance, CountsEndsThatMove) {
  Line line = line_over({{.x = 0, .z = support}, {.x = 10, .z = 0}, {.x = 100, .z = 0}});
  EXPECT_NEAR(taut::study::rope_clearance(line.machine, line.rope).height, rope_height(50), 1e-6);
  line.machine.bodies.push_back(body("car", {0, 0, support}, 10, "z"));
  line.machine.reevings[0].nodes[0] = anchor_on("car", 0);
  EXPECT_NEAR(taut::study::rope_clearance(line.machine, line.rope).height, 0, 1e-9);
  line.machine.terrain = {{.x = -20, .z = 0}, {.x = -10, .z = 0}};
  EXPECT_TRUE(std::isnan(taut::study::rope_clearance(line.machine, line.rope).height));
}

}  // namespace
// An anchor 2.9 m deep at a slope of 4 %: 60 m of rope would run in the ground. Its rope has to be out of it at 6 m.
TEST(RopeClearance, ARopeLeavesTheGroundSoonBehindABuriedAnchor) {
  const auto least = [](double slope) {
    // the ground passes 2.5 m above the right end, and is below the rope at the other one
    const Line line = line_over(
        {{.x = -10, .z = 0}, {.x = 95, .z = support + 2.5 - 5 * slope}, {.x = 110, .z = support + 2.5 + 10 * slope}});
    return taut::study::rope_clearance(line.machine, line.rope).height;
  };
  EXPECT_GT(least(1), 0) << "2.5 m higher, and 6 m lower after 6 m";
  EXPECT_LT(least(0.2), -1);
}

/// A rope from the ground at the origin to a point 80 m higher in 200 m, pulled at its start; the ground rises by 0.3.
Line from_the_ground(double tension, bool turned) {
  const double w = 1.6 * 9.80665;
  const auto rise = [&](double angle) {
    const double c = tension * std::cos(angle) / w, u = std::asinh(std::tan(angle));
    return c * (std::cosh(2 * span / c + u) - std::cosh(u));
  };
  double low = -0.5, high = 1;
  for (int i = 0; i < 100; ++i) (rise((low + high) / 2) < 80 ? low : high) = (low + high) / 2;
  const double c = tension * std::cos(low) / w, u = std::asinh(std::tan(low));
  const double length = c * (std::sinh(2 * span / c + u) - std::sinh(u));
  Line line;
  const Vector3 foot(0, 0, 0), top(turned ? -2 * span : 2 * span, 0, 80);
  line.machine.terrain = {{.x = -10, .z = 0}, {.x = 0, .z = 0}, {.x = 100, .z = 30}, {.x = 210, .z = 30}};
  if (turned) line.machine.terrain = {{.x = -210, .z = 30}, {.x = -100, .z = 30}, {.x = 0, .z = 0}, {.x = 10, .z = 0}};
  std::vector<machine::Node> nodes = {anchor("foot", foot), anchor("top", top)};
  if (turned) std::swap(nodes[0], nodes[1]);
  line.machine.reevings.push_back(reeve("r", nodes, length, w, 1e13));
  const auto found = taut::solve::equilibrium(line.machine);
  EXPECT_TRUE(found.outcome.ok()) << found.outcome.message;
  line.rope = found.branches.at(0);
  return line;
}

// At 18 kN the rope rises from its anchor, and has 0.25 m at 20 m and 1.9 m at 60 m from it: that was no clearance at
// all, and 5 m of another place passed.
TEST(RopeClearance, ARopeThatComesAlongTheGroundToItsEndCounts) {
  double before = -1;
  for (double kN = 15; kN <= 60; kN += 0.25) {
    const Line line = from_the_ground(kN * 1e3, false), turned = from_the_ground(kN * 1e3, true);
    const auto own = taut::study::rope_clearance(line.machine, line.rope);
    ASSERT_FALSE(std::isnan(own.height));
    EXPECT_NEAR(taut::study::rope_clearance(turned.machine, turned.rope).height, own.height, 1e-6);
    EXPECT_GT(own.height, before) << kN;
    EXPECT_TRUE(kN == 15 || own.height < before + 0.1) << "no jump at " << kN << " kN";
    before = own.height;
    std::vector<Vector3> places;
    for (int i = 0; i <= 2000; ++i) {
      const double h = 0.1 * i;
      places.emplace_back(h, 0, 0.4 * h - taut::rope::sag_at(line.rope.shape, h));
    }
    EXPECT_NEAR(taut::study::rope_clearance(line.machine, through(places), 0, 0, 1).height, own.height, 1e-3);
  }
  const Line line = from_the_ground(18e3, false);
  const auto found = taut::study::rope_clearance(line.machine, line.rope);
  EXPECT_LT(found.height, 0.1);
  ASSERT_TRUE(found.to_end);
  EXPECT_NEAR(*found.to_end, found.place.x(), 1e-9);
  EXPECT_NEAR(found.height, (*found.to_end - 6) / 2, 1e-9) << "on the line down";
}

// A stiff rope at 45 degrees comes down to its anchor at once.
TEST(RopeClearance, ARopeThatComesDownSteeplyIsOnItsWayToTheGround) {
  Line line = from_the_ground(400e3, false);
  line.machine.terrain = {{.x = -10, .z = 2.5}, {.x = 210, .z = -52.5}};
  EXPECT_TRUE(std::isnan(taut::study::rope_clearance(line.machine, line.rope).height));
  line.machine.terrain[0].z = 0;
  line.machine.terrain[1].z = 0;
  const auto gentle = taut::study::rope_clearance(line.machine, line.rope);
  EXPECT_NEAR(gentle.height, 0.38 * *gentle.to_end, 0.1 * gentle.height) << "rises by 0.4 less its sag";
}

/// The rope of a branch cut into n pieces at equal unstretched lengths, each the catenary between its ends.
Pieces cut(const taut::solve::BranchResult& rope, int n) {
  Pieces pieces;
  const double L = rope.shape.rope.length;
  for (int i = 0; i < n; ++i) {
    const Vector3 start = taut::rope::point_at(rope.shape, L * i / n);
    const Vector3 end = taut::rope::point_at(rope.shape, L * (i + 1) / n);
    taut::rope::CatenaryRope own = rope.shape.rope;
    own.length = L / n;
    const auto span = taut::rope::solve_span(own, end - start);
    EXPECT_TRUE(span) << i;
    pieces.push_back({.start = rope.start + start, .end = rope.start + end, .shape = *span, .sag = 0});
  }
  return pieces;
}

// A rope is the same in one piece and in many, over flat ground, slopes, hills and hollows, and with the ends of it at
// the ground: pieces know the curve between their ends. 6 straight ones gave up to 0.17 m of 6.3 m sag too much.
TEST(RopeClearance, OfARopeInPiecesIsThatOfTheWholeRope) {
  std::vector<Line> lines;
  for (const auto& ground : {std::vector<machine::GroundPoint>{{.x = -10, .z = 0}, {.x = 110, .z = 0}},
                             {{.x = 0, .z = -5}, {.x = 100, .z = 5}},
                             {{.x = 0, .z = 0}, {.x = 73, .z = 13}, {.x = 100, .z = 0}},
                             {{.x = 0, .z = -9}, {.x = 30, .z = 12}, {.x = 31, .z = -9}, {.x = 100, .z = 3}},
                             {{.x = -10, .z = 0}, {.x = 60, .z = 16}},
                             {{.x = -10, .z = 0}, {.x = 95, .z = 0}, {.x = 100, .z = support + 4}}})
    lines.push_back(line_over(ground));
  for (const double kN : {15, 18, 22, 30}) lines.push_back(from_the_ground(kN * 1e3, false));
  for (const double kN : {15, 18, 22, 30}) lines.push_back(from_the_ground(kN * 1e3, true));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto whole = taut::study::rope_clearance(lines[i].machine, lines[i].rope);
    ASSERT_FALSE(std::isnan(whole.height)) << i;
    for (const int n : {1, 2, 6, 7}) {
      const auto found = taut::study::rope_clearance(lines[i].machine, cut(lines[i].rope, n), 0, 0, 1);
      EXPECT_NEAR(found.height, whole.height, 1e-7) << "line " << i << " in " << n;
      EXPECT_LT((found.place - whole.place).norm(), 1e-3) << "line " << i << " in " << n;
    }
  }
}

// z = 20 - 4 f s (1 - s) over ground of the slope m: lowest over it where 4 f (1 - 2 s)/100 = -m, and by hand
// 20 - f (1 - (25 m/f)^2) - 100 m s.
TEST(RopeClearance, OfAParabolaIsByItsVertex) {
  const double f = 6;
  for (const double m : {0.0, 0.1, -0.05}) {
    const Line line = line_over({{.x = 0, .z = 0}, {.x = 100, .z = 100 * m}});
    const Pieces one = {{.start = {0, 0, support}, .end = {span, 0, support}, .shape = {}, .sag = f}};
    // two parabolas of a quarter of its sag each are the same one
    const Pieces two = {{.start = {0, 0, support}, .end = {span / 2, 0, support - f}, .shape = {}, .sag = f / 4},
                        {.start = {span / 2, 0, support - f}, .end = {span, 0, support}, .shape = {}, .sag = f / 4}};
    const double s = (1 + 25 * m / f) / 2;
    const double least = support - 4 * f * s * (1 - s) - 100 * m * s;
    for (const Pieces& pieces : {one, two}) {
      const auto found = taut::study::rope_clearance(line.machine, pieces, 0, 0, 1);
      EXPECT_NEAR(found.height, least, 1e-9) << m;
      EXPECT_NEAR(found.place.x(), 100 * s, 1e-6) << m;
    }
  }
}

// A rope of 10 m hangs in a loop from two places one above the other, 2 m apart: by hand 4 m below the lower one.
TEST(RopeClearance, AnUprightLoopIsLowestBelowItsEnds) {
  const double L = 10, z = 12;
  const auto loop = taut::rope::solve_span({.length = L, .weight = 10, .stiffness = 1e13}, {0, 0, 2});
  ASSERT_TRUE(loop);
  Line line = line_over({{.x = -10, .z = 0}, {.x = 110, .z = 0}});
  line.rope = {};
  line.rope.to = 1;
  line.rope.start = Vector3(50, 0, z);
  line.rope.end = Vector3(50, 0, z + 2);
  line.rope.shape = *loop;
  EXPECT_NEAR(taut::study::rope_clearance(line.machine, line.rope).height, z - 4, 1e-6);
  const Pieces two = {{.start = line.rope.start, .end = line.rope.end, .shape = *loop, .sag = 0},
                      {.start = line.rope.end, .end = {60, 0, 30}, .shape = {}, .sag = 0}};
  EXPECT_NEAR(taut::study::rope_clearance(line.machine, two, 0, 0, 1).height, z - 4, 1e-6);
}

}  // namespace taut_test::rope_clearance_test
