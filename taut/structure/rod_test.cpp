#include "taut/structure/rod.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "test/witness/rod_shooting.hpp"

namespace taut::structure::rod_test {

Matrix3 turned(const Vector3& by) {
  return by.norm() == 0 ? Matrix3(Matrix3::Identity())
                        : Eigen::AngleAxisd(by.norm(), by.normalized()).toRotationMatrix();
}

RodPiece piece(BeamOrder order) {
  RodPiece p;
  p.section = tube_section(0.3, 0.01);
  p.section.EI_y *= 0.6;
  p.section.weight = 700;
  p.bow = {.angle = 0.02, .length = 12, .towards = Eigen::Vector2d(0.6, -0.8)};
  p.order = order;
  p.from = 2, p.to = 9;
  p.steps = 40;
  return p;
}

// Without forces it is the same shape, larger.
TEST(Rod, WarmedItIsLongerInProportion) {
  for (const BeamOrder order : {BeamOrder::first, BeamOrder::second}) {
    RodPiece p = piece(order);
    p.section.weight = 0;
    RodState start;
    start.axes = turned({0.3, -0.2, 0.5});
    const Vector3 cold = along(p, start).place;
    p.thermal_strain = 1e-3;
    EXPECT_LT((along(p, start).place - 1.001 * cold).norm(), 1e-12);
  }
}

RodState start_of(BeamOrder order) {
  RodState s;
  s.place = {1, 2, 3};
  s.axes = turned({0.3, -0.2, 0.5});
  if (order == BeamOrder::first) s.turn = {0.01, -0.02, 0.005};
  s.force = {20e3, -8e3, -150e3};
  s.moment = {30e3, 50e3, 7e3};
  return s;
}

TEST(Rod, RatesAreTheDifferences) {
  for (const BeamOrder order : {BeamOrder::first, BeamOrder::second}) {
    RodPiece p = piece(order);
    p.thermal_strain = 0.02;
    const RodState start = start_of(order);
    RodRates rates;
    const RodState end = along(p, start, rates);
    EXPECT_LT((end.place - along(p, start).place).norm(), 1e-14);
    for (int column = 0; column < 12; ++column) {
      const double h = column < 6 ? 1e-5 : 10.0;
      const Vector3 e = Vector3::Unit(column % 3);
      std::array<RodState, 2> ends;
      for (int k = 0; k < 2; ++k) {
        RodState s = start;
        const double by = k == 0 ? -h : h;
        if (column < 3 || (column < 6 && order == BeamOrder::second)) s.axes = turned(by * e) * s.axes;
        if (column >= 3 && column < 6 && order == BeamOrder::first) s.turn += by * e;
        if (column >= 6 && column < 9) s.force += by * e;
        if (column >= 9) s.moment += by * e;
        ends[static_cast<std::size_t>(k)] = along(p, s);
      }
      Eigen::Matrix<double, 12, 1> difference;
      const Vector3 turn = order == BeamOrder::first ? Vector3(ends[1].turn - ends[0].turn)
                                                     : sine_vector(ends[1].axes * ends[0].axes.transpose());
      difference << ends[1].place - ends[0].place, turn, ends[1].force - ends[0].force, ends[1].moment - ends[0].moment;
      difference /= 2 * h;
      const Eigen::Matrix<double, 12, 1> reported = rates.col(column);
      for (int block = 0; block < 4; ++block) {
        const double scale =
            1e-12 + rates.middleRows<3>(Eigen::Index{3} * block).cwiseAbs().maxCoeff() * (column < 6 ? 1 : 1e-4);
        EXPECT_LT((reported - difference).segment<3>(Eigen::Index{3} * block).norm(), 3e-7 * scale)
            << "column " << column << " block " << block << "\n"
            << reported.transpose() << "\n"
            << difference.transpose();
      }
    }
  }
}

TEST(Rod, SectionForcesBelongToTheirDirections) {
  RodState s;
  s.force = {1, 2, -3};
  s.moment = {4, 5, 6};
  const SectionForces f = section_forces(s);
  EXPECT_EQ(f.axial, -3);
  EXPECT_EQ(f.shear_x, 1);
  EXPECT_EQ(f.shear_y, 2);
  EXPECT_EQ(f.bends_to_x, 5);   // about +y: z leans towards +x
  EXPECT_EQ(f.bends_to_y, -4);  // about +x: z leans towards -y
  EXPECT_EQ(f.torsion, 6);
}

TEST(Rod, SecondOrderIsTheShootingRod) {
  RodPiece p = piece(BeamOrder::second);
  p.bow.angle = 0;
  const RodState start = start_of(BeamOrder::second);
  const auto end = taut_test::witness::carry(
      p.section, {.place = start.place, .axes = start.axes, .force = start.force, .moment = start.moment}, 7, p.steps);
  const RodState same = along(p, start);
  EXPECT_LT((same.place - end.place).norm(), 1e-12);
  EXPECT_LT((same.axes - end.axes).norm(), 1e-12);
  EXPECT_LT((same.moment - end.moment).norm(), 1e-6);
}

TEST(Rod, FirstOrderIsTheTextbooksCantilever) {
  RodPiece p;
  p.section = tube_section(0.3, 0.01);
  p.order = BeamOrder::first;
  p.to = 9;
  RodState start;
  start.force = {2e3, 0, -400e3};
  start.moment = {0, 2e3 * 9, 0};  // H over the length, whatever the axial force
  const RodState end = along(p, start);
  EXPECT_NEAR(end.moment.norm(), 0, 1e-9);
  const double w = 2e3 * 9 * 9 * 9 / (3 * p.section.EI_x);
  EXPECT_NEAR(end.place.x(), w, 1e-9 * w);
  EXPECT_NEAR(end.place.z(), 9 * (1 - 400e3 / p.section.EA), 1e-12);
  EXPECT_NEAR(end.turn.y(), 1.5 * w / 9, 1e-9);
}

TEST(Rod, UnloadedBowIsAHalfWaveOnItsChord) {
  for (const BeamOrder order : {BeamOrder::first, BeamOrder::second}) {
    RodPiece p = piece(order);
    p.section.weight = 0;
    p.steps = 80;
    const double share = 1.0 / 300;
    p.bow.angle = std::numbers::pi * share;
    p.from = 0, p.to = p.bow.length;
    RodState start;
    start.axes = p.bow.axes(Matrix3::Identity(), 0);
    std::vector<RodState> all;
    const RodState end = along(p, start, &all);
    EXPECT_NEAR(end.place.head<2>().norm(), 0, 1e-9);
    EXPECT_NEAR(end.place.z(), p.bow.length * ::j0(p.bow.angle), 1e-9);
    const Vector3& middle = all[all.size() / 2 - 1].place;
    const double e = share * p.bow.length;
    EXPECT_NEAR(middle.x(), 0.6 * e, 1e-4 * e);
    EXPECT_NEAR(middle.y(), -0.8 * e, 1e-4 * e);
    EXPECT_NEAR((end.axes - p.bow.axes(Matrix3::Identity(), p.to)).norm(), 0, 1e-9);
  }
}

TEST(Rod, SineOfARotationAndItsDerivatives) {
  const Vector3 about(0.3, -0.5, 0.2);
  const Matrix3 Q = turned(about);
  EXPECT_LT((sine_vector(Q) - about.normalized() * std::sin(about.norm())).norm(), 1e-15);
  constexpr double h = 1e-6;
  for (int i = 0; i < 3; ++i) {
    const Matrix3 plus = turned(h * Vector3::Unit(i)), minus = turned(-h * Vector3::Unit(i));
    EXPECT_LT(((sine_vector(plus * Q) - sine_vector(minus * Q)) / (2 * h) - sine_by_left(Q).col(i)).norm(), 1e-9);
    EXPECT_LT(((sine_vector(Q * plus) - sine_vector(Q * minus)) / (2 * h) - sine_by_right(Q).col(i)).norm(), 1e-9);
  }
}

}  // namespace taut::structure::rod_test
