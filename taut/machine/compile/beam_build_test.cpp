#include "taut/machine/compile/beam_build.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

/// A beam cut into pieces: carried without any force from its start it has to pass through all its bodies and end where
/// it is meant to, bowed by as much as is asked.
namespace taut::machine::beam_build_test {

StraightBeam strut(const Vector3& from, const Vector3& to) {
  StraightBeam b;
  b.name = "strut";
  b.from.at = from;
  b.to.at = to;
  b.section = structure::tube_section(0.4, 0.02);
  b.stations = {0.3, 0.75};
  return b;
}

/// The sections of a beam as built, at all its steps.
std::vector<structure::RodState> built(const Model& m) {
  structure::RodState s;
  s.place = m.beams[0].pieces[0].start.at;
  s.axes = m.beams[0].pieces[0].start_axes;
  std::vector<structure::RodState> all = {s};
  for (const BeamPiece& piece : m.beams[0].pieces) {
    structure::RodPiece bare = piece.rod;
    bare.section.weight = 0;
    along(bare, all.back(), &all);
  }
  return all;
}

TEST(BeamBuild, WithoutForcesItPassesThroughItsBodies) {
  Model m;
  const Vector3 from(1, -2, 0.5), to(4, 3, 9);
  StraightBeam b = strut(from, to);
  b.bow = 1.0 / 200;
  b.sense = {1, 0, 0};
  add_beam(m, b);
  ASSERT_EQ(m.beams[0].pieces.size(), 3U);
  ASSERT_EQ(m.bodies.size(), 3U);
  EXPECT_EQ(m.bodies[2].name, "strut.top");
  const std::vector<structure::RodState> all = built(m);
  EXPECT_LT((all.back().place - to).norm(), 1e-6);
  EXPECT_LT((m.bodies[2].position - to).norm(), 1e-6);
  std::size_t step = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const BeamPiece& piece = m.beams[0].pieces[k];
    EXPECT_EQ(piece.rod.steps % piece.section_every, 0);
    step += static_cast<std::size_t>(piece.rod.steps);
    EXPECT_LT((all[step].place - m.bodies[k].position).norm(), 1e-6);
    EXPECT_LT((all[step].axes - piece.end_axes).norm(), 1e-6);
  }
}

/// The largest distance of the axis from its chord, in the middle, towards what of the sense is across it; the axis is
/// longer than the chord by (pi e/l)^2/4.
TEST(BeamBuild, ItIsBowedByAsMuchAsIsAsked) {
  for (const double share : {1.0 / 500, 1.0 / 100}) {
    Model m;
    StraightBeam b = strut(Vector3::Zero(), {3, 0, 4});
    b.bow = share;
    b.sense = {1, 1, 0};
    add_beam(m, b);
    const Vector3 chord(0.6, 0, 0.8), across = b.sense - chord * chord.dot(b.sense);
    double most = 0, at = 0;
    for (const structure::RodState& s : built(m)) {
      const Vector3 off = s.place - chord * chord.dot(s.place);
      EXPECT_NEAR(off.dot(across.normalized()), off.norm(), 1e-6);
      if (off.norm() > most) most = off.norm(), at = s.place.dot(chord);
    }
    EXPECT_NEAR(most, 5 * share, 1e-3 * 5 * share);
    EXPECT_NEAR(at, 2.5, 0.06);
    EXPECT_NEAR(m.beams[0].length / 5 - 1, std::pow(std::acos(-1.0) * share, 2) / 4, 1e-6);
  }
}

/// The strong axis is what of the hint is across the beam; of one along it another is found. Right-handed in any case.
TEST(BeamBuild, AxesStandSquare) {
  for (const Vector3& to : {Vector3(0, 0, 5), Vector3(5, 0, 0), Vector3(1, 2, -3)}) {
    for (const Vector3& strong : {Vector3(1, 0, 0), Vector3(0, 1, 1)}) {
      Model m;
      StraightBeam b = strut(Vector3::Zero(), to);
      b.strong = strong;
      add_beam(m, b);
      const Matrix3& axes = m.beams[0].pieces[0].start_axes;
      EXPECT_LT((axes.transpose() * axes - Matrix3::Identity()).norm(), 1e-12);
      EXPECT_NEAR(axes.determinant(), 1, 1e-12);
      EXPECT_LT((axes.col(2) - to.normalized()).norm(), 1e-12);
      const Vector3 across = strong - axes.col(2) * axes.col(2).dot(strong);
      if (across.norm() > 1e-6) {
        EXPECT_NEAR(axes.col(0).dot(across.normalized()), 1, 1e-12);
      }
    }
  }
}

/// On a body that stands inclined: places and axes are those of its frame.
TEST(BeamBuild, OnABodyItsFrameCounts) {
  const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3 shift(3, -1, 2);
  Model plain, turned;
  for (Model* m : {&plain, &turned}) {
    Body foot;
    foot.name = "foot";
    if (m == &turned) foot.position = shift, foot.orientation = turn;
    m->bodies.push_back(foot);
    StraightBeam b = strut({0.2, 0, 0}, Vector3(0.2, 0, 6));
    b.from.body = 0;
    if (m == &turned) {
      b.to.at = shift + turn * b.to.at;
      b.strong = turn * b.strong;
    }
    add_beam(*m, b);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT((turned.bodies[k + 1].position - shift - turn * plain.bodies[k + 1].position).norm(), 1e-9);
    EXPECT_EQ(turned.beams[0].pieces[k].reference, 0);
  }
  EXPECT_LT((turned.beams[0].pieces[0].start_axes - plain.beams[0].pieces[0].start_axes).norm(), 1e-12);
}

/// Cut where something stands, and oftener the more slender: forces up to the strength may not decay by more than
/// exp(5) along a piece.
TEST(BeamBuild, ItIsCutWhereItIsSlender) {
  StraightBeam b = strut(Vector3::Zero(), Vector3(0, 0, 8));
  EXPECT_EQ(cuts_of(b, 8), (std::vector<double>{0.3, 0.75}));
  b.section = structure::tube_section(0.06, 0.004);
  const std::vector<double> cuts = cuts_of(b, 8);
  EXPECT_GT(cuts.size(), 2U);
  double last = 0;
  for (std::size_t i = 0; i <= cuts.size(); ++i) {
    const double next = i < cuts.size() ? cuts[i] : 1;
    const double N = b.section.area * 400e6, l = (next - last) * 8;
    EXPECT_GT(next, last);
    EXPECT_LE(l * std::sqrt(N / b.section.EI_x), 5 + 1e-9);
    last = next;
  }
  b.stations = {0.0001, 0.3, 0.3001, 0.9999};  // at its ends, and twice nearly the same
  b.section = structure::tube_section(0.4, 0.02);
  EXPECT_EQ(cuts_of(b, 8), (std::vector<double>{0.3}));
}

}  // namespace taut::machine::beam_build_test
