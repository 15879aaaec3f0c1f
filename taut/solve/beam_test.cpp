#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "taut/machine/compile/beam_build.hpp"
#include "taut/mechanics/beam_piece.hpp"
#include "taut/solve/equilibrium.hpp"
#include "test/support/machines.hpp"

namespace beam_test {

namespace solve = taut::solve;

using namespace taut_test;

namespace structure = taut::structure;
using structure::BeamOrder;
using taut::Matrix3;

machine::StraightBeam mast(double height, const structure::BeamSection& section) {
  machine::StraightBeam b;
  b.name = "mast";
  b.to.at = {0, 0, height};
  b.section = section;
  return b;
}

/// A cantilever 8 m high with a force at its top.
machine::Model cantilever(BeamOrder order, const Vector3& force, double EA_factor = 1) {
  machine::Model m;
  machine::StraightBeam b = mast(8, structure::tube_section(0.508, 0.016));
  b.section.EA *= EA_factor;
  b.order = order;
  machine::add_beam(m, b);
  m.loads.push_back({{.body = static_cast<int>(m.bodies.size()) - 1, .at = Vector3::Zero()}, force});
  return m;
}

TEST(Beam, CantileverOfSecondOrderIsTheBeamColumn) {
  const double EI = structure::tube_section(0.508, 0.016).EI_x, h = 8;
  for (const double N : {50e3, 1e6, 4e6, 0.95 * std::pow(std::numbers::pi / 2 / h, 2) * EI}) {
    const double H = 10, k = std::sqrt(N / EI);
    const auto r = solve::equilibrium(cantilever(BeamOrder::second, {H, 0, -N}, 1e8));
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    const double M = H * std::tan(k * h) / k;
    EXPECT_NEAR(r.state.beams[0][0].moment.norm(), M, 1e-6 * M) << N;
    EXPECT_NEAR(r.state.bodies.back().position.x(), (M - H * h) / N, 1e-6 * M / N) << N;
    EXPECT_LT(r.closure.balance, 1e-9 * N);
  }
}

TEST(Beam, CantileverOfFirstOrderDoesNotKnowItsAxialForce) {
  const double EI = structure::tube_section(0.508, 0.016).EI_x, h = 8;
  for (const double N : {0.0, 4e6}) {
    const auto r = solve::equilibrium(cantilever(BeamOrder::first, {1e3, 0, -N}));
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_NEAR(r.state.beams[0][0].moment.norm(), 1e3 * h, 1e-7 * 1e3 * h);
    EXPECT_NEAR(r.state.bodies.back().position.x(), 1e3 * h * h * h / (3 * EI), 1e-9);
  }
}

double euler(const structure::BeamSection& b, double length) { return std::pow(std::numbers::pi / length, 2) * b.EI_x; }

TEST(Beam, CriticalFactorIsEulers) {
  const structure::BeamSection tube = structure::tube_section(0.508, 0.016);
  for (const BeamOrder order : {BeamOrder::first, BeamOrder::second}) {
    for (const double share : {0.1, 0.5, 0.98}) {
      const double N = share * euler(tube, 16);
      const auto r = solve::equilibrium(cantilever(order, {10, 0, -N}, 1e4));
      ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
      EXPECT_NEAR(r.beams[0].critical_factor, 1 / share, 1e-4 / share);
      EXPECT_NEAR(r.beams[0].compression, N, 1e-3 * N);
    }
    const auto pulled = solve::equilibrium(cantilever(order, {10, 0, 1e6}));
    ASSERT_TRUE(pulled.outcome.ok());
    EXPECT_TRUE(std::isinf(pulled.beams[0].critical_factor));
    const auto r = solve::equilibrium(cantilever(order, {0, 0, -1.05 * euler(tube, 16)}));
    EXPECT_EQ(r.outcome.status, taut::Status::infeasible);
    EXPECT_NE(r.outcome.message.find("buckles"), std::string::npos) << r.outcome.message;
  }
}

TEST(Beam, HingedMastHeldAtItsTopBucklesAtEulersLoad) {
  machine::Model m;
  machine::StraightBeam b = mast(8, structure::tube_section(0.1, 0.005));
  b.base = machine::BeamHold::hinged;
  machine::add_beam(m, b);
  for (int i = 0; i < 3; ++i) {  // level, stiff: they hold the top and do not press it down
    const double angle = 2 * std::numbers::pi / 3 * i;
    m.reevings.push_back(reeve("g", {anchor("a", {20 * std::cos(angle), 20 * std::sin(angle), 8}), anchor_on("top", 0)},
                               20 * (1 - 1e-6), 0, 1e10));
  }
  for (const double share : {0.5, 0.97}) {
    m.loads = {{.at = {.body = 0, .at = Vector3::Zero()}, .force = {0, 0, -share * euler(b.section, 8)}}};
    const auto r = solve::equilibrium(m);
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_NEAR(r.beams[0].critical_factor, 1 / share, 1e-3 / share);
  }
  m.loads[0].force *= 1.03 / 0.97;
  EXPECT_EQ(solve::equilibrium(m).outcome.status, taut::Status::infeasible);
}

TEST(Beam, UpsideDownOnAHingeItFalls) {
  machine::Model m;
  machine::StraightBeam b = mast(8, structure::tube_section(0.1, 0.005));
  b.section.weight = 100;
  b.base = machine::BeamHold::hinged;
  machine::add_beam(m, b);
  const auto r = solve::equilibrium(m);
  EXPECT_EQ(r.outcome.status, taut::Status::infeasible);
  EXPECT_NE(r.outcome.message.find("mast"), std::string::npos) << r.outcome.message;
  m.loads.push_back({{.body = 0, .at = Vector3::Zero()}, {300, 0, 0}});  // pushed, it comes to rest hanging
  const auto pushed = solve::equilibrium(m);
  EXPECT_EQ(pushed.outcome.status, taut::Status::infeasible);
  EXPECT_NE(pushed.outcome.message.find("'mast'"), std::string::npos) << pushed.outcome.message;
  b.to.at = {0, 0, -8};  // built hanging, it stays
  machine::Model hanging;
  machine::add_beam(hanging, b);
  EXPECT_TRUE(solve::equilibrium(hanging).outcome.ok());
}

TEST(Beam, TransverseForceBendsItToTheElastica) {
  // L sqrt(P/EI) = integral of d theta/sqrt(2 (sin theta_L - sin theta)) over the inclinations, theta_L - theta = t^2
  const double last = 0.45, end = std::sqrt(last);
  const auto rate = [&](double t) {
    return t == 0 ? 2 / std::sqrt(2 * std::cos(last))
                  : 2 * t / std::sqrt(2 * (std::sin(last) - std::sin(last - t * t)));
  };
  double sum = 0;
  constexpr int parts = 2000;
  for (int i = 0; i <= parts; ++i) sum += rate(end * i / parts) * (i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2);
  const double root = sum * end / parts / 3;
  const structure::BeamSection tube = structure::tube_section(0.508, 0.016);
  const auto r = solve::equilibrium(cantilever(BeamOrder::second, {root * root * tube.EI_x / 64, 0, 0}, 1e8));
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const Matrix3& top = r.state.bodies.back().orientation;
  EXPECT_NEAR(std::atan2(top(0, 2), top(2, 2)), last, 1e-7);
  EXPECT_NEAR(r.beams[0].bend, last, 1e-7);
}

/// A mast with a lug, four guys and a sheave's worth of load, its plan turned by an angle or mirrored.
machine::Model slewed(double angle, bool mirrored, double stiffer = 1) {
  Matrix3 turn = Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
  if (mirrored) turn.col(1) *= -1;
  machine::Model m;
  machine::StraightBeam b = mast(12, structure::tube_section(0.2191, 0.008));
  b.section.EI_y *= 0.5;
  b.section.W_y *= 0.6;
  b.section.outline = structure::Outline::box;
  b.section.EI_x *= stiffer, b.section.EI_y *= stiffer, b.section.GJ *= stiffer, b.section.EA *= stiffer;
  b.section.weight = 500;
  b.base = machine::BeamHold::hinged;
  b.strong = turn * Vector3(1, 0.4, 0);
  b.bow = stiffer == 1 ? 1.0 / 300 : 0;
  b.sense = turn * Vector3(1, 1, 0);
  b.stations = {0.9};
  machine::add_beam(m, b);
  const auto guy = [&](const char* name, const Vector3& stump, int body, const Vector3& lug, double length) {
    m.reevings.push_back(reeve(name, {anchor(name, turn * stump), anchor_on(name, body, turn * lug)}, length, 9, 15e6));
  };
  guy("g1", {-12, 6, 1}, 1, {0, 0, 0}, 17.3);
  guy("g2", {-12, -6, -1}, 1, {0, 0, 0}, 18.7);
  guy("g3", {4, 12, 0}, 0, {0.1, 0.2, 0}, 16.5);
  guy("g4", {4, -12, 0}, 0, {0.1, -0.2, 0}, 16.5);
  m.loads = {{.at = {.body = 1, .at = Vector3::Zero()}, .force = turn * Vector3(40e3, 8e3, -60e3)},
             {.at = {.body = 0, .at = turn * Vector3(0.3, 0, 0)}, .force = turn * Vector3(5e3, 0, -20e3)}};
  return m;
}

TEST(Beam, TurnedAndMirroredGivesTheSame) {
  const auto r = solve::equilibrium(slewed(0, false));
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  for (const auto& [angle, mirrored] : {std::pair{1.1, false}, {4.0, false}, {0.0, true}, {2.3, true}}) {
    const auto t = solve::equilibrium(slewed(angle, mirrored));
    ASSERT_TRUE(t.outcome.ok()) << t.outcome.message;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(t.branches[i].T_to, r.branches[i].T_to, 1e-9 * r.branches[0].T_to);
    for (std::size_t i = 0; i < r.beams[0].points.size(); ++i) {
      const solve::BeamPoint &p = r.beams[0].points[i], &q = t.beams[0].points[i];
      EXPECT_NEAR(q.M, p.M, 1e-8 * r.beams[0].points[r.beams[0].most_bent].M);
      EXPECT_NEAR(q.N, p.N, 1e-9 * r.beams[0].compression);
      EXPECT_NEAR(q.stress, p.stress, 1e-8 * p.stress);
      EXPECT_NEAR(q.w, p.w, 1e-10);
    }
    EXPECT_NEAR(t.beams[0].critical_factor, r.beams[0].critical_factor, 1e-4 * r.beams[0].critical_factor);
  }
}

TEST(Beam, VeryStiffItIsARigidBody) {
  machine::Model rigid = slewed(0, false, 1e9);
  rigid.beams.clear();
  rigid.bodies = {body("mast", {0, 0, 0}, 500 * 12 / rigid.gravity, "XYZ")};
  rigid.bodies[0].centre = {0, 0, 6};
  for (auto& rope : rigid.reevings) {
    auto& place = rope.nodes[1].at;
    place = {.body = 0, .at = place.at + Vector3(0, 0, place.body == 0 ? 10.8 : 12)};
  }
  for (auto& load : rigid.loads) load.at = {.body = 0, .at = load.at.at + Vector3(0, 0, load.at.body == 0 ? 10.8 : 12)};
  // with the lugs on the axis nothing turns it
  const auto centred = [](machine::Model m) {
    for (auto& rope : m.reevings) rope.nodes[1].at.at.x() = rope.nodes[1].at.at.y() = 0;
    for (auto& load : m.loads) load.at.at.x() = load.at.at.y() = 0;
    return solve::equilibrium(m);
  };
  rigid.bodies[0].free.pop_back();
  const auto a = centred(slewed(0, false, 1e9)), b = centred(rigid);
  ASSERT_TRUE(a.outcome.ok() && b.outcome.ok()) << a.outcome.message << b.outcome.message;
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a.branches[i].T_to, b.branches[i].T_to, 1e-6 * b.branches[0].T_to);
}

TEST(Beam, TripodOfStrutsCarriesByItsLines) {
  machine::Model m;
  m.bodies.push_back(body("head", {0, 0, 6}, 0, "xyz"));
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * std::numbers::pi / 3 * i + 0.3;
    machine::StraightBeam b = mast(1, structure::tube_section(0.1, 0.005));
    b.name = "leg" + std::to_string(i);
    b.from.at = {3 * std::cos(angle), 3 * std::sin(angle), 0};
    b.to = {.body = 0, .at = Vector3::Zero()};
    b.base = machine::BeamHold::hinged;
    b.top = machine::BeamTop::hinged;
    b.section.EA *= 1e6;
    machine::add_beam(m, b);
  }
  m.loads.push_back({{.body = 0, .at = Vector3::Zero()}, {0, 0, -90e3}});
  const auto r = solve::equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  const double N = 90e3 / 3 * std::sqrt(45.0) / 6;
  for (const auto& leg : r.beams) {
    EXPECT_NEAR(leg.compression, N, 1e-6 * N);
    EXPECT_NEAR(leg.points[leg.most_bent].M, 0, 1e-6 * N);
    EXPECT_NEAR(leg.critical_factor, euler(structure::tube_section(0.1, 0.005), std::sqrt(45.0)) / N,
                1e-3 * leg.critical_factor);
  }
}

TEST(Beam, BowedStrutIsTheTextbooks) {
  // hinged at both ends on the ground's points, pressed by an elongation of none: a slide on its axis presses it
  machine::Model m;
  const double N = 60e3, L = 6, share = 1.0 / 300;
  m.bodies.push_back(body("slide", {0, 0, L}, 0, "z"));
  machine::StraightBeam b = mast(1, structure::tube_section(0.1, 0.005));
  b.to = {.body = 0, .at = Vector3::Zero()};
  b.base = machine::BeamHold::hinged;
  b.top = machine::BeamTop::hinged;
  b.bow = share;
  b.sense = {0.6, 0.8, 0};
  b.section.EA *= 1e6;
  machine::add_beam(m, b);
  m.loads.push_back({{.body = 0, .at = Vector3::Zero()}, {0, 0, -N}});
  const auto r = solve::equilibrium(m);
  ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
  // e/(1 - N/N_cr), Ayrton and Perry; flat: 1e-4 of the slope squared
  const double most = N * share * L / (1 - N / euler(b.section, L));
  EXPECT_NEAR(r.beams[0].points[r.beams[0].most_bent].M, most, 2e-3 * most);
  EXPECT_NEAR(r.beams[0].points[r.beams[0].most_bent].s, L / 2, L / 15);
}

}  // namespace beam_test
