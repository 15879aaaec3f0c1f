#include "taut/solve/motion/step/quasi_static.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "test/support/boom_machine.hpp"
#include "test/support/transient_runs.hpp"

/// Motions without inertia, starts in sliding friction: against closed forms.
namespace taut_test::transient_quasi_static_test {

namespace machine = taut::machine;

namespace {

using taut::solve::Slid;
using taut::solve::Start;
using taut::solve::transient;
using taut::solve::TransientOptions;
using taut::solve::TransientResult;

constexpr double degree = std::numbers::pi / 180, g = 10;

TransientResult run(const machine::Model& m, const TransientOptions& o) {
  TransientResult r = run_to_end(m, o);
  const auto& energy = r.frames.back().energy;  // what a step leaves is of the third order of its ways
  EXPECT_LE(std::abs(energy.residual), 5e-4 * energy.turnover);
  if (o.quasi_static) {
    EXPECT_EQ(energy.kinetic, 0);
  }
  return r;
}

machine::Signal through(const std::vector<double>& t, const std::vector<double>& value, const taut::Unit& unit) {
  machine::Signal s;
  s.unit = unit;
  s.law = machine::Curve{t, value, {}};
  return s;
}

bool has(const TransientResult& r, const std::string& what, const std::string& where) {
  return std::any_of(r.events.begin(), r.events.end(),
                     [&](const auto& e) { return e.what == what && e.where == where; });
}

/// A block of 500 kg on a floor of 10 m, drawn to the right by a rope of 100 kN/m whose end a tensioner takes in at 1
/// cm/s and, from `turns` on, lets out again.
machine::Model drawn_block(double f0, double f_inf, double turns) {
  machine::Model m;
  m.gravity = g;
  m.bodies.push_back(body("block", origin, 500, "xz"));
  machine::FaceContact& sole = add_floor(m, 0, 5, 1e9, f_inf);
  sole.damping = sole.tangential_damping = 1e5;
  sole.static_friction = f0;
  sole.stribeck_speed = 1e-4;
  m.reevings.push_back(reeve("rope", {anchor_on("block", 0), anchor("end", {20, 0, 0})}, 20, 0, 2e6));
  m.reevings[0].damping_time = 0.02;
  machine::Tensioner end;
  end.at_start = false;
  end.change = through({0, turns, turns + 20}, {0, -0.01 * turns, -0.01 * turns + 0.2}, taut::si::m);
  m.tensioners.push_back(end);
  return m;
}

double tension(const TransientResult& r, double t, std::size_t branch = 0) {
  const auto frame = std::min_element(r.frames.begin(), r.frames.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.t - t) < std::abs(b.t - t);
  });
  return frame->branches[branch].T_from;
}

TEST(QuasiStatic, ABlockIsDrawnByItsFriction) {
  const double W = 500 * g;
  const TransientResult r = run(drawn_block(0.3, 0.2, 5), slowly(10, 200));
  // it sticks: the rope stretches by 1 cm/s and what it is wound off is the shorter for it
  for (const double t : {0.5, 1.0, 1.4}) {
    const double strain = 20 / (20 - 0.01 * t) - 1;
    EXPECT_NEAR(tension(r, t), 2e6 * strain, 0.01 * 2e6 * strain);
  }
  EXPECT_NEAR(tension(r, 3), 0.2 * W, 1e-3);  // steady: at a hundred times the Stribeck speed
  EXPECT_NEAR(tension(r, 5), 0.2 * W, 1e-3);
  EXPECT_LT(tension(r, 5.5), 0.2 * W);  // let out, and the block stays
  EXPECT_NEAR(tension(r, 9), 0, 1e-6);
  EXPECT_NEAR(r.frames.back().bodies[0].position.x(), r.frames[100].bodies[0].position.x(), 2e-5);
  double largest = 0;
  for (const auto& frame : r.frames) largest = std::max(largest, frame.branches[0].T_from);
  EXPECT_LT(largest, 0.3 * W + 1e-3);
  EXPECT_GT(largest, 0.3 * W - 1e5 * 0.01 * 0.05 - 1e-3);  // but for the rope of one step
  EXPECT_NEAR(r.frames[90].bodies[0].velocity.x(), 0.01 * (1 + 0.2 * W / 2e6), 1e-9);
  EXPECT_TRUE(has(r, "slip", "sole"));
}

/// A weight on a rope over a sheave with losses, from a drum.
machine::Model hoist(double eta, const machine::Signal& speed) {
  machine::Model m;
  m.gravity = g;
  m.bodies.push_back(body("load", {2, 0, -10}, 300, "z"));
  const machine::Node drum = add_drum(m, "drum", {-8, 0, 0}, 0.15);
  m.drums[0].drive = {machine::DriveKind::speed, speed};
  m.reevings.push_back(
      reeve("rope", {drum, sheave("top", {1.8, 0, 0}, 0.2, 1, eta), anchor_on("load", 0)}, 3000, 0, 2e6));
  m.reevings[0].given = machine::Given::tension_at_end;
  m.reevings[0].damping_time = 0.01;
  return m;
}

TEST(QuasiStatic, HoistingAndLoweringDifferByTheLossesTwice) {
  const double W = 3000, eta = 0.95;
  const machine::Model m = hoist(eta, through({0, 0.001, 5, 5.001, 20}, {0, 0.1, 0.1, -0.1, -0.1}, taut::si::m_per_s));
  const TransientResult r = run(m, slowly(10, 100));
  EXPECT_NEAR(tension(r, 0), W, 1e-6 * W);
  EXPECT_NEAR(tension(r, 1), W / eta, 1e-8 * W);
  EXPECT_NEAR(tension(r, 5), W / eta, 1e-8 * W);
  EXPECT_NEAR(tension(r, 6), W * eta, 1e-8 * W);
  EXPECT_NEAR(tension(r, 10), W * eta, 1e-8 * W);
  EXPECT_NEAR(r.frames[40].drums[0].speed, 0.1, 1e-6);
  // the weight rises by what the drum takes in, stretched as it lies there
  const double up = r.frames[50].bodies[0].position.z() - r.frames[10].bodies[0].position.z();
  EXPECT_NEAR(up, 0.4, 2e-3);
}

/// In steps of 2 s: of a speed that jumps at their start, of one that swings within them, of one that bends there.
TEST(QuasiStatic, ADrumTakesInTheIntegralOfItsSpeed) {
  machine::Signal jumps, swings;
  jumps.law = machine::Moves{.from = 0, .moves = {{.at = 2, .to = 0.1, .over = 0}, {.at = 6, .to = -0.05, .over = 0}}};
  swings.law = machine::Sine{.mean = 0.02, .amplitude = 0.1, .omega = 2, .phase = 0.3};
  for (const machine::Signal& speed : {jumps, swings, smooth_move(0, 0.1, 1, 6)}) {
    const TransientResult r = run_to_end(hoist(1, speed), slowly(10, 5));
    for (const auto& frame : r.frames) {
      const double in = frame.on_drums[0].content - r.frames.front().on_drums[0].content;
      EXPECT_NEAR(in * (1 + 3000 / 2e6), machine::integral(speed, 0, frame.t), 1e-9) << frame.t;
    }
  }
}

TEST(QuasiStatic, AStartInSlidingFrictionIsTheEndOfASlowMotion) {
  const double W = 3000, eta = 0.95;
  const TransientResult settled = run(hoist(eta, through({0, 1}, {0, 0}, taut::si::m_per_s)), slowly(1, 4));
  for (const double sense : {1.0, -1.0}) {
    TransientOptions o = slowly(1, 4, Start::sliding);
    o.slid = {Slid{true, 0, 0.1 * sense}};
    const TransientResult slow = run(hoist(eta, through({0, 1}, {0, 0}, taut::si::m_per_s)), o);
    EXPECT_NEAR(tension(slow, 0), sense > 0 ? W / eta : W * eta, 1e-8 * W);
    EXPECT_NEAR(slow.frames.front().bodies[0].position.z(), settled.frames.front().bodies[0].position.z(), 1e-3);
    EXPECT_NEAR(tension(slow, 1), tension(slow, 0), 1e-8 * W);
    // and stays when masses count, held by the same friction
    o.quasi_static = false;
    o.tolerance = 1e-6;
    const TransientResult real = run(hoist(eta, through({0, 1}, {0, 0}, taut::si::m_per_s)), o);
    EXPECT_NEAR(tension(real, 1), tension(slow, 0), 1e-3 * W);
  }
}

/// A weight over a sheave by half a turn, drawn and let out by a tensioner: with a light sheave and with one that has a
/// bearing and inertia the tight side is 1/eta of the other.
TEST(QuasiStatic, HalfATurnRoundASheaveLosesItsEfficiency) {
  const double W = 3000, eta = 0.94;
  for (const double inertia : {0.0, 0.5}) {
    machine::Model m;
    m.gravity = g;
    m.bodies.push_back(body("load", {2, 0, -10}, W / g, "z"));
    machine::Node top = sheave("top", {1.8, 0, 0}, 0.2, 1, eta);
    top.inertia = inertia;
    m.reevings.push_back(reeve("rope", {anchor("pull", {1.6, 0, -10}), top, anchor_on("load", 0)}, W, 0, 2e6));
    m.reevings[0].given = machine::Given::tension_at_end;
    machine::Tensioner end;
    end.change = through({0, 5, 10}, {0, -0.5, 0}, taut::si::m);
    m.tensioners.push_back(end);
    const TransientResult r = run(m, slowly(10, 100));
    EXPECT_NEAR(r.frames[50].contacts[0].wrap, std::numbers::pi, 1e-9);
    EXPECT_NEAR(tension(r, 5), W / eta, 1e-8 * W) << inertia;
    EXPECT_NEAR(tension(r, 10), W * eta, 1e-8 * W) << inertia;
  }
}

/// Over a saddle that does not turn the rope slips both ways by its wrap, drawn from the side too.
TEST(QuasiStatic, ASaddleHoldsByItsWrap) {
  const double W = 3000, mu = 0.2;
  for (const double aside : {0.0, 3.0}) {
    machine::Model m;
    m.gravity = g;
    m.bodies.push_back(body("load", {0, 0, -10}, W / g, "z"));
    machine::Node stone = saddle("stone", origin, mu);
    stone.support = Vector3::Zero();
    m.reevings.push_back(reeve("rope", {anchor("pull", {-10, aside, 0}), stone, anchor_on("load", 0)}, W, 0, 2e6));
    m.reevings[0].given = machine::Given::tension_at_end;
    machine::Tensioner end;
    end.change = through({0, 5, 10}, {0, -0.5, 0}, taut::si::m);
    m.tensioners.push_back(end);
    const TransientResult r = run(m, slowly(10, 100));
    const double ratio = std::exp(mu * std::numbers::pi / 2);
    EXPECT_NEAR(tension(r, 5), W * ratio, 1e-8 * W);
    EXPECT_NEAR(tension(r, 10), W / ratio, 1e-8 * W);
  }
}

/// A log line over a saddle whose axis is not across it: out of the plane of the round it presses too.
TEST(QuasiStatic, ASaddleHoldsByTheBendOutOfItsPlane) {
  const double W = 3000, mu = 0.2;
  machine::Model m;
  m.gravity = g;
  m.bodies.push_back(body("load", {20, 9, -1}, W / g, "x"));
  machine::Node stone = saddle("stone", origin, mu);
  stone.radius = 0.2;
  stone.axis = Vector3::UnitY();
  m.reevings.push_back(reeve("rope", {anchor("pull", {-10, 6, -2}), stone, anchor_on("load", 0)}, W, 0, 2e6));
  m.loads.push_back({{0, Vector3::Zero()}, {W, 0, 0}, 0});
  m.reevings[0].given = machine::Given::tension_at_start;
  machine::Tensioner end;
  end.change = through({0, 5, 10}, {0, -0.5, 0}, taut::si::m);
  m.tensioners.push_back(end);
  const TransientResult r = run(m, slowly(10, 100));
  for (const std::size_t at : {50U, 100U}) {
    const auto& frame = r.frames[at];
    const taut::Vector3 in = frame.branches[0].arrives, out = frame.branches[1].leaves;
    const double ratio = frame.contacts[0].T_out / frame.contacts[0].T_in, theta = std::acos(in.dot(out));
    EXPECT_GT(theta, 0.9);
    EXPECT_LT(frame.contacts[0].wrap, 0.5);
    EXPECT_NEAR(std::log(ratio), (at == 50 ? -1 : 1) * mu * theta, 1e-6);
  }
}

/// Heavy sheaves with bearings under a tackle: what slides at its very limit there is no hindrance where the winch
/// stops and goes on.
TEST(QuasiStatic, ATackleWithHeavySheavesStopsAndGoesOn) {
  machine::Model m = tackle(4, 0.96, 1000);
  m.gravity = g;
  for (machine::Node& node : m.reevings[0].nodes) {
    if (node.kind == machine::NodeKind::contact) node.inertia = 0.3;
  }
  machine::Tensioner winch;
  winch.change = through({0, 2, 3, 5, 6, 9}, {0, -0.4, -0.4, -0.8, -0.8, -0.2}, taut::si::m);
  m.tensioners.push_back(winch);
  const TransientResult r = run(m, slowly(9, 90));
  EXPECT_GT(tension(r, 5), 1.02 * tension(r, 0));
  EXPECT_NEAR(tension(r, 3), tension(r, 2), 1e-9 * tension(r, 2));
  EXPECT_LT(tension(r, 9), 0.98 * tension(r, 0));
}

/// A block on a board that is tilted: it slides from tan a = f_0 on, down to a stop that it meets after 2 m.
machine::Model tilted_board(double f0, double f_inf) {
  machine::Model m;
  m.gravity = g;
  machine::Body board = body("board", origin, 0, "");
  board.driven.push_back({Vector3::Zero(), Vector3::UnitY(), through({0, 40}, {0, 40 * degree}, taut::si::rad)});
  m.bodies.push_back(board);
  m.bodies.push_back(body("block", origin, 100, "xz"));
  machine::Face face;
  face.name = "board";
  face.body = 0;
  face.from = {-1, 0, 0};
  face.to = {5, 0, 0};
  m.faces.push_back(face);
  machine::Face stop;
  stop.name = "stop";
  stop.body = 0;
  stop.from = {2, 0, -1};
  stop.to = {2, 0, 1};
  stop.normal = {-1, 0, 0};
  m.faces.push_back(stop);
  machine::FaceContact sole;
  sole.name = "sole";
  sole.body = 1;
  sole.stiffness = sole.tangential_stiffness = 1e9;
  sole.static_friction = f0;
  sole.kinetic_friction = f_inf;
  m.contacts.push_back(sole);
  sole.name = "bumper";
  sole.face = 1;
  sole.static_friction = sole.kinetic_friction = 0;
  m.contacts.push_back(sole);
  return m;
}

TEST(QuasiStatic, ABlockFallsFromWhereNothingHoldsItToItsStop) {
  for (const double f_inf : {0.4, 0.3}) {
    const TransientResult r = run(tilted_board(0.4, f_inf), slowly(40, 80));
    const double slips = std::atan(0.4) / degree;
    for (const auto& frame : r.frames) {
      const double way = frame.bodies[1].position.norm();
      if (frame.t < slips) {
        EXPECT_LT(way, 1e-5) << frame.t;
      } else if (frame.t > slips + 1) {
        EXPECT_NEAR(way, 2, 1e-4) << frame.t;
      }
    }
    EXPECT_TRUE(has(r, "fall", "block"));
    EXPECT_TRUE(has(r, "contact", "bumper"));
  }
}

/// The same angle found by the motion itself: an event stops it where the block has gone a millimetre.
TEST(QuasiStatic, TheSlipAngleIsFoundToTheLastDigits) {
  machine::Model m = tilted_board(0.4, 0.35);
  machine::Event stop;
  stop.words = "slides";
  stop.kind = machine::EventKind::stop;
  machine::Observable x;
  x.name = "x";
  x.unit = taut::si::m;
  x.index = 1;
  x.seen_from = 0;
  stop.when = machine::Condition{x, true, 1e-3};
  m.events.push_back(stop);
  const TransientResult r = run(m, slowly(40, 80));
  EXPECT_NEAR(r.t_end, std::atan(0.4) / degree, 1e-6);
}

TEST(QuasiStatic, NothingHoldsABlockOnABoardWithoutEnd) {
  machine::Model m = tilted_board(0.4, 0.3);
  m.contacts.pop_back();
  m.faces[0].to = {20, 0, 0};
  const TransientResult r = transient(m, slowly(40, 80));
  EXPECT_FALSE(r.outcome.ok());
  EXPECT_NEAR(r.t_end, std::atan(0.4) / degree, 0.02);
  EXPECT_EQ(r.outcome.status, taut::Status::infeasible);
  EXPECT_NE(r.outcome.message.find("no equilibrium any more"), std::string::npos) << r.outcome.message;
}

/// Of two ropes that carry a weight side by side one breaks: the other has all of it, at rest.
TEST(QuasiStatic, ABreakEndsAtRest) {
  machine::Model m;
  m.gravity = g;
  m.bodies.push_back(body("load", {0, 0, -10}, 200, "z"));
  for (const char* name : {"one", "two"}) {
    m.reevings.push_back(reeve(name, {anchor(name, origin), anchor_on("load", 0)}, 10 / (1 + 1e3 / 1e6), 0, 1e6));
  }
  machine::Event gone;
  gone.words = "break";
  gone.kind = machine::EventKind::breaks;
  gone.at = 1;
  gone.index = 0;
  gone.part = 0;
  m.events.push_back(gone);
  const TransientResult r = run(m, slowly(2, 20));
  EXPECT_NEAR(tension(r, 0.9, 1), 1000, 1e-6);
  EXPECT_NEAR(tension(r, 2, 1), 2000, 1e-6);
  // of the 2000 N that come lower one half stretches the rope that is left, from the share of both to all
  const double falls = 10 / (1 + 1e3 / 1e6) * 1e3 / 1e6;
  EXPECT_NEAR(r.frames.back().energy.damped, 2000 * falls / 2, 1e-9);
  EXPECT_NEAR(r.frames.back().bodies[0].position.z(), -10 / (1 + 1e3 / 1e6) * (1 + 2e3 / 1e6), 1e-9);
}

/// Sliding is no matter of the step, nor of the way before it.
TEST(QuasiStatic, SteadySlidingOfTheBoomKeepsItsForces) {
  Boom b;
  b.angle = 19 * degree;
  b.start = 1;
  b.travel = 4;
  std::vector<BoomState> at_end;
  for (const double step : {0.1, 0.05, 0.02}) {
    TransientOptions o = slowly(5.0, static_cast<int>(5 / step), Start::sliding);
    o.slid = {Slid{false, 0, step == 0.02 ? 0.2 : 0.1}};
    at_end.push_back(boom_state(b, run(boom_machine(b), o).frames.back()));
  }
  for (const BoomState& one : at_end) {
    EXPECT_NEAR(one.S1, at_end[0].S1, 1e-5 * one.S1);
    EXPECT_NEAR(one.S2, at_end[0].S2, 1e-5 * one.S2);
    EXPECT_NEAR(one.Fh, at_end[0].Fh, 1e-4 * one.Fh);
  }
}

/// A boom is luffed with a hook below its tip's sheave, which has inertia and may slip: so slowly that it is as a light
/// one. The rope neither runs off nor does the sheave, and the ledger closes.
TEST(QuasiStatic, HeavySheavesOnMovingBodiesAreAsLightOnes) {
  const auto luffed = [](double inertia, double efficiency) {
    machine::Model m;
    m.gravity = g;
    m.bodies = {body("boom", {0, 0, 0}, 0, ""), body("hook", {19.2, 0, -2}, 800, "xyz")};
    m.bodies[0].driven.push_back({Vector3::Zero(), Vector3::UnitY(), smooth_move(0, -0.7, 0, 18)});
    machine::Node tip = sheave("tip", {18.8, 0, 6.8}, 0.4, 1, efficiency, 0);
    tip.law.friction = 0.2;
    tip.inertia = inertia;
    m.reevings.push_back(
        reeve("hoist", {anchor_on("boom", 0, {1.5, 0, 1.6}), tip, anchor_on("hook", 1)}, 27.6, 0, 5e8));
    return run(m, slowly(20, 40)).frames.back();
  };
  for (const double efficiency : {1.0, 0.95}) {
    const auto heavy = luffed(0.5, efficiency), light = luffed(0, efficiency);
    EXPECT_EQ(heavy.bodies[1].position, light.bodies[1].position);
    EXPECT_NEAR(heavy.branches[1].T_to, 800 * g, 1e-3);
    EXPECT_LT(std::abs(heavy.contacts[0].angle), 1);
  }
}

// What they take needs a speed.
TEST(QuasiStatic, RefusesBrakesThatSlipAndDrag) {
  TransientOptions slow = lasting(3, 1e-6);
  slow.quasi_static = true;
  EXPECT_NE(transient(braked_load(), slow).outcome.message.find("'brake_torque'"), std::string::npos);
  machine::Model m = braked_load();
  m.events.clear();
  m.drums[0].brake.reset();
  EXPECT_TRUE(transient(m, slow).outcome.ok());
  m.drums[0].drag = 500;
  EXPECT_NE(transient(m, slow).outcome.message.find("the drag of 'winch'"), std::string::npos);
  m.drums[0].drag = 0;
  m.reevings[0].nodes.insert(m.reevings[0].nodes.begin() + 1, sheave("head", {0.5, 0, 3}, 0.2, 1));
  m.reevings[0].nodes[1].inertia = 1;
  m.reevings[0].nodes[1].drag = 10;
  EXPECT_NE(transient(m, slow).outcome.message.find("the drag of 'head'"), std::string::npos);
}

}  // namespace
}  // namespace taut_test::transient_quasi_static_test
