#include "taut/rope/tangent.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "taut/base/expects.hpp"

namespace taut::rope::tangent_test {

constexpr double pi = std::numbers::pi;
const Vector3 y = Vector3::UnitY();

TEST(Tangent, LevelOverTwoSheaves) {
  // axis y, right-handed: from z towards x, so that the rope passes over the top in the direction of x
  const auto line = tangent_line(sheave({0, 0, 0}, y, 1, 1), sheave({10, 0, 0}, y, 1, 1));
  ASSERT_TRUE(line);
  EXPECT_LT((line->from - Vector3(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((line->to - Vector3(10, 0, 1)).norm(), 1e-15);
  const auto below = tangent_line(sheave({0, 0, 0}, y, 1, -1), sheave({10, 0, 0}, y, 1, -1));
  EXPECT_LT((below->from - Vector3(0, 0, -1)).norm(), 1e-15);
  const auto crossed = tangent_line(sheave({0, 0, 0}, y, 1, 1), sheave({10, 0, 0}, y, 1, -1));
  EXPECT_NEAR(crossed->length, std::sqrt(100 - 4), 1e-14);
  EXPECT_GT(crossed->from.z(), 0);
  EXPECT_LT(crossed->to.z(), 0);
  const auto unequal = tangent_line(sheave({0, 0, 0}, y, 3, 1), sheave({10, 0, 0}, y, 1, 1));
  EXPECT_NEAR(unequal->length, std::sqrt(100 - 4), 1e-14);
}

TEST(Tangent, PointSheavePoint) {
  // down on both sides of a sheave: half a turn
  const Round top = sheave({0, 0, 0}, y, 0.25, 1);
  const auto up_line = tangent_line(point({-0.25, 0, -8}), top);
  const auto down_line = tangent_line(top, point({0.25, 0, -5}));
  EXPECT_NEAR(up_line->length, 8, 1e-14);
  EXPECT_NEAR(down_line->length, 5, 1e-14);
  EXPECT_NEAR(wrap_angle(1, up_line->angle_to, down_line->angle_from), pi, 1e-14);
  EXPECT_NEAR(wrap_angle(1, up_line->angle_to, down_line->angle_from, 3), 7 * pi, 1e-14);
  EXPECT_EQ(tangent_line(point({0.1, 0, 0.1}), top).error(), NoLine::inside);
  EXPECT_EQ(tangent_line(point({1, 2, 3}), point({1, 2, 3})).error(), NoLine::inside);
  EXPECT_EQ(tangent_line(sheave({0, 0, 0}, y, 1, 1), sheave({1, 0, 0}, y, 1, -1)).error(), NoLine::inside);
}

TEST(Tangent, FollowsAWrapBeyondATurn) {
  double wrap = 0.3;
  for (int i = 1; i <= 100; ++i) {
    const double leaves = std::remainder(0.3 + 0.1 * i, 2 * pi);
    wrap = wrap_angle_near(1, 0, leaves, wrap);
    EXPECT_NEAR(wrap, 0.3 + 0.1 * i, 1e-12);
  }
  EXPECT_NEAR(wrap_angle_near(1, 0.1, 0.0, 0.05), -0.1, 1e-15);  // the rope has left the sheave
  EXPECT_NEAR(wrap_angle(-1, 0.1, 0.0), 0.1, 1e-15);
  EXPECT_EQ(wrap_angle(1, 1e-20, 0.0), 0);
}

struct Pair {
  Round from, to;
};

/// Kinds: 0 skew sheaves, 1 parallel ones, not in one plane, 2 point to sheave, 3 sheave to point, 4 sheaves nearly
/// parallel.
Pair random_pair(unsigned seed, unsigned kind) {
  std::mt19937_64 source(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(source); };
  const auto vector = [&] { return Vector3(in(-1, 1), in(-1, 1), in(-1, 1)); };
  const auto side = [&] { return in(0, 1) < 0.5 ? 1 : -1; };
  // a line that is not far from both sheaves' planes, as ropes run
  const Vector3 d = vector().normalized() * in(3, 30);
  const auto axis = [&](double lean) {
    Vector3 a = d.normalized().cross(vector()).normalized();
    return Vector3(a + lean * vector());
  };
  Round from = sheave(vector(), axis(0.2), in(0.1, 1), side());
  Round to = sheave(from.centre + d, axis(0.2), in(0.1, 1), side());
  if (kind == 1) to = sheave(to.centre, in(0, 1) < 0.5 ? from.axis : Vector3(-from.axis), to.radius, to.side);
  if (kind == 2) from = point(from.centre);
  if (kind == 3) to = point(to.centre);
  if (kind == 4) to = sheave(to.centre, from.axis + 1e-6 * vector(), to.radius, to.side);
  return {.from = from, .to = to};
}

void expect_tangent(const Round& round, const Vector3& contact, const TangentLine& line, double fleet) {
  if (round.radius == 0) {
    EXPECT_EQ((contact - round.centre).norm(), 0);
    return;
  }
  const Vector3 r = (contact - round.centre) / round.radius;
  // rounding of coordinates of 30 m, over a radius of 0.1 m
  EXPECT_NEAR(r.norm(), 1, 1e-13);
  EXPECT_NEAR(r.dot(round.axis), 0, 1e-13);
  EXPECT_NEAR(r.dot(line.direction), 0, 1e-12);
  EXPECT_GT(round.side * round.axis.cross(r).dot(line.direction), 0);
  EXPECT_NEAR(std::sin(fleet), line.direction.dot(round.axis), 1e-14);
}

TEST(Tangent, TouchesBothRoundsOnTheirSides) {
  for (unsigned seed = 0; seed < 5000; ++seed) {
    const auto [from, to] = random_pair(seed, seed % 5);
    const auto line = tangent_line(from, to);
    ASSERT_TRUE(line) << seed;
    expect_tangent(from, line->from, *line, line->fleet_from);
    expect_tangent(to, line->to, *line, line->fleet_to);
    EXPECT_LE(line->iterations, 8) << seed;
    EXPECT_LT((place_at(from, line->angle_from) - line->from).norm(), 1e-13);
  }
}

TEST(Tangent, ReversedIsTheSameLine) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const auto [from, to] = random_pair(seed, seed % 5);
    const auto line = tangent_line(from, to), back = tangent_line(reversed(to), reversed(from));
    ASSERT_TRUE(line && back);
    EXPECT_LT((line->from - back->to).norm(), 1e-12) << seed;
    EXPECT_LT((line->to - back->from).norm(), 1e-12) << seed;
    EXPECT_NEAR(line->fleet_from, -back->fleet_to, 1e-12) << seed;
  }
}

TEST(Tangent, TurnsAndMirrorsWithItsRounds) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const auto [from, to] = random_pair(seed, seed % 5);
    const Matrix3 turn = Eigen::AngleAxisd(0.1 * seed, Vector3(1, 2, 3).normalized()).toRotationMatrix();
    const auto moved = [&](const Round& r) {
      return sheave(turn * r.centre, turn * r.axis, r.radius, r.side, turn * r.zero);
    };
    const auto line = tangent_line(from, to), turned = tangent_line(moved(from), moved(to));
    EXPECT_LT((turn * line->from - turned->from).norm(), 1e-11) << seed;
    EXPECT_LT((turn * line->to - turned->to).norm(), 1e-11) << seed;
    // a mirror turns the sense about an axis round
    const Matrix3 mirror = Vector3(1, -1, 1).asDiagonal();
    const auto image = [&](const Round& r) { return sheave(mirror * r.centre, mirror * r.axis, r.radius, -r.side); };
    const auto mirrored = tangent_line(image(from), image(to));
    EXPECT_LT((mirror * line->from - mirrored->from).norm(), 1e-11) << seed;
  }
}

TEST(Tangent, AZeroSheaveIsAPoint) {
  const Round top = sheave({0, 0, 0}, {0.1, 1, 0.2}, 0.5, -1);
  const auto a = tangent_line(top, point({4, 1, 2})), b = tangent_line(top, sheave({4, 1, 2}, {1, 0, 0}, 0, 1));
  const auto c = tangent_line(top, sheave({4, 1, 2}, {1, 0, 0}, 1e-9, 1));
  EXPECT_LT((a->from - b->from).norm(), 1e-15);
  EXPECT_LT((a->from - c->from).norm(), 1e-8);
}

Round moved(const Round& r, const Vector3& shift, const Vector3& rotation) {
  const double angle = rotation.norm();
  const Matrix3 turn =
      angle > 0 ? Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix() : Matrix3(Matrix3::Identity());
  return r.radius == 0 ? point(r.centre + shift)
                       : Round{.centre = r.centre + shift,
                               .axis = turn * r.axis,
                               .zero = turn * r.zero,
                               .radius = r.radius,
                               .side = r.side};
}

TEST(Tangent, RatesAreDerivatives) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    const auto [from, to] = random_pair(seed, seed % 5);
    const auto line = *tangent_line(from, to);
    const LineRates rates = line_rates(from, to, line);
    const double h = 1e-5;
    for (int i = 0; i < 12; ++i) {
      const Vector3 step = h * Vector3::Unit(i % 3), none = Vector3::Zero();
      const auto at = [&](double sign) {
        const Vector3 s = sign * step;
        const Round a = moved(from, i < 3 ? s : none, i >= 3 && i < 6 ? s : none);
        const Round b = moved(to, i >= 6 && i < 9 ? s : none, i >= 9 ? s : none);
        return *tangent_line(a, b, std::pair(line.angle_from, line.angle_to));
      };
      const TangentLine p = at(1), m = at(-1);
      EXPECT_NEAR(rates.length(i), (p.length - m.length) / (2 * h), 1e-7) << seed << ' ' << i;
      EXPECT_NEAR(rates.angle_from(i), std::remainder(p.angle_from - m.angle_from, 2 * pi) / (2 * h), 1e-7) << seed;
      EXPECT_NEAR(rates.angle_to(i), std::remainder(p.angle_to - m.angle_to, 2 * pi) / (2 * h), 1e-7) << seed;
      EXPECT_LT((rates.from.col(i) - (p.from - m.from) / (2 * h)).norm(), 1e-7) << seed << ' ' << i;
      EXPECT_LT((rates.to.col(i) - (p.to - m.to) / (2 * h)).norm(), 1e-7) << seed << ' ' << i;
    }
  }
}

// In a plane: l' = t.(v2 - v1) + (s2 R2 - s1 R1) psi', psi the polar angle of the line.
TEST(Tangent, FreeLengthHasItsPlanarRate) {
  for (const int side : {1, -1}) {
    const Round from = sheave({0, 0, 0}, y, 0.7, 1), to = sheave({6, 0, 2}, y, 0.4, side);
    const auto line = *tangent_line(from, to);
    const LineRates rates = line_rates(from, to, line);
    const Vector3 v(0.3, 0, -1.1);
    const double psi_rate = rates.angle_to.segment<3>(6).dot(v);  // in a plane the contact turns with the line
    const double expected = line.direction.dot(v) + (side * 0.4 - 0.7) * psi_rate;
    EXPECT_NEAR(rates.length.segment<3>(6).dot(v), expected, 1e-14);
    EXPECT_NEAR(rates.length.segment<3>(6).dot(v), Vector3(6, 0, 2).dot(v) / line.length, 1e-14);
  }
}

TEST(Tangent, RefusesWhatIsNoSheave) {
  EXPECT_THROW(sheave({0, 0, 0}, {0, 0, 0}, 1, 1), ContractViolation);
  EXPECT_THROW(sheave({0, 0, 0}, y, -1, 1), ContractViolation);
  EXPECT_THROW(sheave({0, 0, 0}, y, 1, 0), ContractViolation);
  EXPECT_THROW(sheave({0, 0, 0}, y, 1, 1, y), ContractViolation);
  EXPECT_FALSE(to_text(NoLine::inside).empty());
}

}  // namespace taut::rope::tangent_test
