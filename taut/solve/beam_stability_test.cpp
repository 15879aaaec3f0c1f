#include "taut/solve/beam_stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "taut/machine/compile/beam_build.hpp"
#include "taut/solve/equilibrium.hpp"
#include "test/support/configured.hpp"
#include "test/support/machines.hpp"

/// Critical factors of hand-set states, without any equilibrium solved: the textbook's struts, and a stiff mast on a
/// hinge that ropes hold like springs.
namespace taut::solve::beam_stability_test {

using machine::BeamHold;
using machine::BeamTop;
using namespace taut_test;

/// The machine as it is described, each beam with the same compression along it.
std::optional<BeamStability> pressed(const machine::Model& m, const Vector3& force, bool factors = true) {
  const machine::State state = machine::initial_state(m);
  const mechanics::Layout layout = mechanics::layout(m, state, std::nullopt, no_flow(m));
  mechanics::Configuration c = mechanics::configuration_of(layout, state);
  for (machine::PieceState& piece : c.pieces) piece.force = force;
  return beam_stability({.model = m, .layout = layout}, c, factors);
}

/// A strut along `axis` whose far end slides along it. `wider`: its stiffness across x.
machine::Model strut(BeamHold base, BeamTop top, const Vector3& axis, double length, double wider = 1.5) {
  machine::Model m;
  machine::Body slide = body("slide", length * axis, 0, "");
  slide.free.push_back({axis, Vector3::Zero()});
  m.bodies.push_back(slide);
  machine::StraightBeam b;
  b.name = "strut";
  b.to = {.body = 0, .at = Vector3::Zero()};
  b.section = structure::tube_section(0.2, 0.008);
  b.section.EI_y *= wider;  // it buckles towards x
  b.section.EA *= 1e5;      // and keeps its length
  b.base = base;
  b.top = top;
  machine::add_beam(m, b);
  return m;
}

// A round strut buckles in two directions alike, or nearly so; which of them it is must not show.
TEST(BeamStability, ARoundStrutHasTheSameFactorWhicheverWayItStands) {
  for (const double wider : {1.0, 1 + 1e-9, 1 + 1e-6, 1 + 1e-4}) {
    double first = 0;
    for (const Vector3& axis : {Vector3(0, 0, 1), Vector3(0.48, 0.6, 0.64), Vector3(-0.6, 0, 0.8), Vector3(0, 1, 0)}) {
      machine::Model m = strut(BeamHold::hinged, BeamTop::hinged, axis, 7, wider);
      for (machine::BeamPiece& piece : m.beams.at(0).pieces) piece.rod.section.EA /= 1e5;  // or its rounding shows
      const auto found = pressed(m, -3e4 * axis);
      ASSERT_TRUE(found.has_value());
      ASSERT_TRUE(found->stable);
      const double factor = found->factors.at(0);
      if (first == 0) first = factor;
      EXPECT_NEAR(factor, first, 1e-8 * first) << wider;
    }
  }
}

TEST(BeamStability, StrutsBuckleAtTheTextbooksLoads) {
  constexpr double pi = std::numbers::pi, clamped_hinged = 4.493409457909064;  // tan x = x
  const double length = 7, EI = structure::tube_section(0.2, 0.008).EI_x;
  const struct {
    BeamHold base;
    BeamTop top;
    double kl;
  } cases[] = {{.base = BeamHold::hinged, .top = BeamTop::hinged, .kl = pi},
               {.base = BeamHold::clamped, .top = BeamTop::hinged, .kl = clamped_hinged},
               {.base = BeamHold::hinged, .top = BeamTop::clamped, .kl = clamped_hinged},
               {.base = BeamHold::clamped, .top = BeamTop::clamped, .kl = 2 * pi}};
  for (const Vector3& axis : {Vector3(0, 0, 1), Vector3(0.48, 0.6, 0.64)}) {
    for (const auto& [base, top, kl] : cases) {
      const double critical = kl * kl * EI / (length * length);
      const machine::Model m = strut(base, top, axis, length);
      for (const double share : {0.2, 0.99, 1.01, 3.0}) {
        const auto found = pressed(m, -share * critical * axis);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->stable, share < 1) << kl << " " << share;
        EXPECT_NEAR(found->factors.at(0) * share, 1, 2e-4) << kl << " " << share;
      }
      const auto pulled = pressed(m, critical * axis);
      ASSERT_TRUE(pulled);
      EXPECT_TRUE(pulled->stable && std::isinf(pulled->factors.at(0)));
      const auto asked = pressed(m, -0.5 * critical * axis, false);
      ASSERT_TRUE(asked);
      EXPECT_TRUE(asked->stable && asked->factors.empty());
    }
  }
}

/// Four level ropes hold the top of a hinged mast that does not bend: leaning by d it is pulled back by
/// (2 EA/L_0 + 2 T/L) d, and falls at N = (2 EA/L_0 + 2 T/L) h.
TEST(BeamStability, AStiffMastOnAHingeFallsWhereItsRopesGiveWay) {
  const double h = 11, L = 20, EA = 4e5;
  for (const double T : {5e3, 60e3}) {
    machine::Model m;
    machine::StraightBeam b;
    b.name = "mast";
    b.to.at = {0, 0, h};
    b.section = structure::tube_section(0.5, 0.02);
    for (double* stiffness : {&b.section.EI_x, &b.section.EI_y, &b.section.EA, &b.section.GJ}) *stiffness *= 1e5;
    b.base = BeamHold::hinged;
    machine::add_beam(m, b);
    const double unstretched = L / (1 + T / EA);
    for (const auto& [x, y] : {std::pair{L, 0.0}, {-L, 0.0}, {0.0, L}, {0.0, -L}}) {
      m.reevings.push_back(reeve("guy", {anchor("a", {x, y, h}), anchor_on("top", 0)}, unstretched, 0, EA));
    }
    const double critical = (2 * EA / unstretched + 2 * T / L) * h;
    for (const double share : {0.3, 0.995, 1.005}) {
      const auto found = pressed(m, {0, 0, -share * critical});
      ASSERT_TRUE(found);
      EXPECT_EQ(found->stable, share < 1) << T << " " << share;
      EXPECT_NEAR(found->factors.at(0) * share, 1, 1e-4) << T << " " << share;
    }
  }
}

/// A rope of tension T to a place that holds a beam's end.
machine::Reeving stay(const Vector3& hold, int body, const Vector3& end, double T) {
  const double EA = 1e7;
  return reeve("stay", {anchor("hold", hold), anchor_on("end", body)}, (hold - end).norm() / (1 + T / EA), 0, EA);
}

/// A boom on a hinge whose stay is held above a place before its foot: sideways the stay pulls the tip back by T/l, the
/// boom pushes it out by N/h. With T as it is the tip swings away at (T/l)/(N/h); with T in proportion it never does,
/// and the boom buckles as Euler's strut. Behind the foot it does not stand at all.
TEST(BeamStability, ABoomSwingsAwayWhereItsStayKeepsItsTension) {
  const double h = 8, EI = structure::tube_section(0.2, 0.008).EI_x, T = 5e3;
  for (const double before : {0.5, -0.5}) {
    const Vector3 hold(before, 0, 6), tip(h, 0, 0);
    const double l = (tip - hold).norm(), N = T * (h - before) / l;
    machine::Model m;
    m.bodies.push_back(body("tip", tip, 100, "xyz"));
    machine::StraightBeam b;
    b.name = "boom";
    b.to = {.body = 0, .at = Vector3::Zero()};
    b.section = structure::tube_section(0.2, 0.008);
    b.base = BeamHold::hinged;
    b.top = BeamTop::hinged;
    machine::add_beam(m, b);
    m.reevings.push_back(stay(hold, 0, tip, T));
    const auto found = pressed(m, {-N, 0, 0});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->stable, before > 0);
    EXPECT_NEAR(found->swings, h / (h - before), 1e-4);
    if (before < 0) continue;
    EXPECT_NEAR(found->factors.at(0) * N / (std::pow(std::numbers::pi / h, 2) * EI), 1, 1e-3);
  }
}

/// A spreader beam on two slings from one hook turns about the upright through it: neutral, whatever it carries.
TEST(BeamStability, ASpreaderBeamBucklesAtEulersLoad) {
  const double half = 2, EI = structure::tube_section(0.1, 0.006).EI_x;
  for (const double T : {5e3, 150e3}) {
    const Vector3 hook(0, 0, 3), left(-half, 0, 0), right(half, 0, 0);
    const double N = T * half / (hook - left).norm();
    machine::Model m;
    m.bodies = {body("left", left, 100, "xyz"), body("right", right, 100, "xyz")};
    machine::StraightBeam b;
    b.name = "bar";
    b.from = {.body = 0, .at = Vector3::Zero()};
    b.to = {.body = 1, .at = Vector3::Zero()};
    b.section = structure::tube_section(0.1, 0.006);
    b.section.EA *= 1e5;  // it keeps its length
    b.base = BeamHold::hinged;
    b.top = BeamTop::hinged;
    machine::add_beam(m, b);
    m.reevings = {stay(hook, 0, left, T), stay(hook, 1, right, T)};
    const auto found = pressed(m, {-N, 0, 0});
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->stable);
    EXPECT_TRUE(std::isinf(found->swings));
    const double critical = std::pow(std::numbers::pi / (2 * half), 2) * EI;
    EXPECT_NEAR(found->factors.at(0) * N / critical, 1, 1e-3);
  }
}

/// A leaning leg on a hinge, with two stays behind it, buckles as Euler's strut however little its ropes stretch.
TEST(BeamStability, RopesThatDoNotStretchHoldALegAsOthersDo) {
  const Vector3 tip(3, 0, 8);
  const double L = tip.norm(), EI = structure::tube_section(0.1683, 0.008).EI_x;
  const double critical = std::pow(std::numbers::pi / L, 2) * EI;
  for (const double weight : {0.0, 0.01, 5.0}) {
    for (const double EA : {1e9, 1e11, 1e13, HUGE_VAL}) {
      machine::Model m;
      m.bodies = {body("tip", tip, 10, "xyz"), body("hook", tip - 5 * up(), 15e3, "xyz")};
      machine::StraightBeam b;
      b.name = "leg";
      b.to = {.body = 0, .at = Vector3::Zero()};
      b.section = structure::tube_section(0.1683, 0.008);
      b.base = BeamHold::hinged;
      b.top = BeamTop::hinged;
      machine::add_beam(m, b);
      for (const double side : {-4.0, 4.0}) {
        const Vector3 hold(-6, side, 0);
        m.reevings.push_back(
            reeve("stay", {anchor("hold", hold), anchor_on("tip", 0)}, (tip - hold).norm() * 1.0001, weight, EA));
      }
      m.reevings.push_back(reeve("drop", {anchor_on("tip", 0), anchor_on("hook", 1)}, 5, weight, EA));
      const EquilibriumResult r = equilibrium(m);
      ASSERT_TRUE(r.outcome.ok()) << EA << " " << weight << ": " << r.outcome.message;
      const BeamResult& leg = r.beams.at(0);
      EXPECT_NEAR(leg.critical_factor * leg.compression / critical, 1, 2e-3) << EA << " " << weight;
    }
  }
}

/// Two masts on hinges side by side, joined by nothing: each has its own factor.
TEST(BeamStability, EachBeamHasItsOwnFactor) {
  machine::Model m = strut(BeamHold::hinged, BeamTop::hinged, up(), 7),
                 other = strut(BeamHold::hinged, BeamTop::hinged, up(), 5);
  m.bodies.push_back(other.bodies[0]);
  other.beams[0].pieces[0].end.body = 1;
  m.beams.push_back(other.beams[0]);
  const double EI = structure::tube_section(0.2, 0.008).EI_x;
  const double first = std::pow(std::numbers::pi / 7, 2) * EI, second = std::pow(std::numbers::pi / 5, 2) * EI;
  const auto found = pressed(m, {0, 0, -0.5 * first});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->factors.at(0), 2, 4e-4);
  EXPECT_NEAR(found->factors.at(1), 2 * second / first, 1e-3);
}

}  // namespace taut::solve::beam_stability_test
