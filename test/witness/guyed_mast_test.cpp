#include "test/witness/guyed_mast.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "taut/machine/compile/beam_build.hpp"
#include "taut/math/degree.hpp"
#include "taut/solve/equilibrium.hpp"
#include "test/witness/mast_of_bars.hpp"

namespace taut_test::guyed_mast_test {

using namespace witness;
using taut::degree;
using taut::Status;
using taut::solve::BeamResult;
using taut::solve::equilibrium;
using taut::solve::EquilibriumResult;
namespace machine = taut::machine;

Guy guy_at(double angle, double height, double distance, GuyInstallation install, double anchor_height = 0) {
  return {.name = "g",
          .height = height,
          .anchor = {distance * std::cos(angle), distance * std::sin(angle), anchor_height},
          .stiffness = 15e6,
          .weight = 9.0,
          .install = install,
          .breaking_force = 180e3};
}

/// A tower yarder's mast with four guys away from the span, and the ropes of two blocks; lateral haulback force.
GuyedMast yarder() {
  GuyedMast m;
  m.height = 12;
  m.section = structure::tube_section(0.3239, 0.010);
  for (const double angle : {110.0, 160.0, 205.0, 250.0}) {
    m.guys.push_back(
        guy_at(angle * degree, 12, 14, GuyTension{.tension = 15e3, .at = GuyEnd::top}, angle > 180 ? -1.5 : 0.8));
  }
  m.loads = {{.height = 12, .force = {70e3, 0, -110e3}}, {.height = 10.8, .force = {25e3, 6e3, -45e3}}};
  return m;
}

GuyedMastResult solved(const GuyedMast& m) {
  GuyedMastResult r;
  const Outcome o = solve(m, r);
  EXPECT_TRUE(o.ok()) << o.message;
  return r;
}

void expect_balance(const GuyedMastResult& r, double force, double height) {
  EXPECT_LT(r.force_balance, 1e-8 * force);
  EXPECT_LT(r.moment_balance, 1e-8 * force * height);
  EXPECT_LT(r.closure, 1e-9 * height);
}

TEST(GuyedMast, AgreesWithTheHandModel) {
  GuyedMast hinged = yarder();
  hinged.base = MastBase::hinged;
  GuyedMast slim = yarder();
  slim.section = structure::tube_section(0.1937, 0.008);
  slim.guys[1].height = 6;
  slim.guys[2].install = GuyTension{.tension = 4e3, .at = GuyEnd::anchor};
  for (const GuyedMast& m : {yarder(), hinged, slim}) {
    const GuyedMastResult r = solved(m);
    expect_balance(r, 200e3, 12);
    const witness::Answer w = witness::solve(m, 80, 20);
    ASSERT_TRUE(w.settled);
    EXPECT_LT((r.top - w.top).norm(), 1e-3 * r.top.norm()) << r.top.transpose() << " : " << w.top.transpose();
    double largest = 0;
    for (const GuyState& g : r.guys) largest = std::max(largest, g.tension_top);
    for (std::size_t i = 0; i < r.guys.size(); ++i) {
      EXPECT_NEAR(r.guys[i].tension_top, w.tension_top[i], 1e-3 * largest) << "guy " << i;
    }
    if (m.base == MastBase::clamped) {
      EXPECT_NEAR(r.base_moment.norm(), w.foot_moment, 1e-3 * bending(r.points[r.most_bent]));
    }
  }
}

GuyedMast cantilever(double H, double N) {
  GuyedMast m;
  m.height = 8;
  m.section = structure::tube_section(0.508, 0.016);
  m.loads = {{.height = 8, .force = {H, 0, -N}}};
  return m;
}

TEST(GuyedMast, CantileverIsTheBeamColumn) {
  // EA so large that the mast does not shorten, H so small that it stays upright: the classical equation.
  for (const double N : {50e3, 1e6, 4e6}) {
    GuyedMast m = cantilever(10, N);
    m.section.EA = 1e14;
    const GuyedMastResult r = solved(m);
    const double k = std::sqrt(N / m.section.EI_x), h = m.height;
    EXPECT_NEAR(r.base_moment.norm(), 10 * std::tan(k * h) / k, 1e-6 * 10 * std::tan(k * h) / k);
    EXPECT_NEAR(r.top.x(), 10 / N * (std::tan(k * h) / k - h), 1e-6 * r.top.x());
    expect_balance(r, N, h);
  }
}

TEST(GuyedMast, CantileverBucklesAtEulersLoad) {
  const GuyedMast any = cantilever(1, 0);
  const double euler = std::pow(std::numbers::pi / 16, 2) * any.section.EI_x;
  GuyedMastResult r;
  for (const double H : {0.0, 1.0, 1000.0}) {
    EXPECT_TRUE(solve(cantilever(H, 0.98 * euler), r).ok()) << H;
  }
  for (const double share : {1.05, 2.0, 10.0, 25.0}) {
    const Outcome o = solve(cantilever(0, share * euler), r);
    EXPECT_EQ(o.status, Status::infeasible) << share;
    EXPECT_NE(o.message.find("buckles"), std::string::npos) << o.message;
  }
  EXPECT_EQ(solve(cantilever(1e4, 1.5 * euler), r).status, Status::infeasible);
}

TEST(GuyedMast, HingedMastHeldAtItsTopBucklesAtEulersLoad) {
  GuyedMast m = cantilever(0, 0);
  m.base = MastBase::hinged;
  m.section = structure::tube_section(0.1, 0.005);
  for (int i = 0; i < 3; ++i) {  // horizontal, stiff: they hold the top and do not press it down
    Guy g = guy_at(120 * degree * i, 8, 20, GuyLength{20 * (1 - 1e-6)}, 8);
    g.stiffness = 1e10, g.weight = 0;
    m.guys.push_back(g);
  }
  const double euler = std::pow(std::numbers::pi / 8, 2) * m.section.EI_x;
  GuyedMastResult r;
  m.loads = {{.height = 8, .force = {0, 0, -0.97 * euler}}};
  EXPECT_TRUE(solve(m, r).ok());
  m.loads = {{.height = 8, .force = {0, 0, -1.03 * euler}}};
  EXPECT_EQ(solve(m, r).status, Status::infeasible);
}

TEST(GuyedMast, HingedWithoutGuysFalls) {
  GuyedMast m = cantilever(1e3, 10e3);
  m.base = MastBase::hinged;
  GuyedMastResult r;
  EXPECT_EQ(solve(m, r).status, Status::infeasible);
}

TEST(GuyedMast, PlanTurnedByAnyAngleGivesTheSame) {
  const GuyedMast m = yarder();
  const GuyedMastResult r = solved(m);
  for (const double angle : {0.3, 1.9, 4.0}) {
    const Matrix3 turn = Eigen::AngleAxisd(angle, taut::up()).toRotationMatrix();
    GuyedMast t = m;
    for (Guy& g : t.guys) g.anchor = turn * g.anchor;
    for (MastLoad& l : t.loads) l.force = turn * l.force;
    const GuyedMastResult s = solved(t);
    EXPECT_LT((turn * r.top - s.top).norm(), 1e-8 * r.top.norm());
    EXPECT_LT((turn * r.base_moment - s.base_moment).norm(), 1e-8 * bending(r.points[r.most_bent]));
    for (std::size_t i = 0; i < r.guys.size(); ++i) {
      EXPECT_NEAR(r.guys[i].tension_top, s.guys[i].tension_top, 1e-7 * r.guys[i].tension_top + 1e-6);
    }
    EXPECT_NEAR(r.points[r.worst].stress, s.points[s.worst].stress, 1e-8 * r.points[r.worst].stress);
  }
}

TEST(GuyedMast, EqualGuysAroundAnUnloadedMastStayAsInstalled) {
  GuyedMast m = yarder();
  m.guys.clear();
  m.loads.clear();
  for (int i = 0; i < 4; ++i)
    m.guys.push_back(guy_at(90 * degree * i, 12, 14, GuyTension{.tension = 20e3, .at = GuyEnd::anchor}));
  m.section.EA = 1e15;  // else it shortens under them, and they lose a little
  const GuyedMastResult r = solved(m);
  EXPECT_LT(std::hypot(r.top.x(), r.top.y()), 1e-9);
  for (const GuyState& g : r.guys) {
    EXPECT_NEAR(g.tension_anchor, 20e3, 1e-2);
    EXPECT_NEAR(g.tension_top, 20e3 + 9 * 12, 1) << "w times the height more at the top, per stretched metre";
    EXPECT_NEAR(g.safety, 180e3 / g.tension_top, 1e-9);
  }
}

TEST(GuyedMast, GuyOnTheLeeSideGoesSlack) {
  GuyedMast m = yarder();
  m.guys.push_back(guy_at(0, 12, 14, GuyTension{.tension = 3e3, .at = GuyEnd::top}));
  const GuyedMastResult r = solved(m);
  EXPECT_TRUE(r.guys.back().slack);
  EXPECT_LT(r.guys.back().tension_top, 1e3);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_FALSE(r.guys[i].slack);
  m.guys.back().weight = 0;
  m.guys.back().install = GuyTension{.tension = 3e3, .at = GuyEnd::top};
  const GuyedMastResult s = solved(m);
  EXPECT_TRUE(s.guys.back().slack);
  EXPECT_EQ(s.guys.back().tension_top, 0);
  m.guys.pop_back();
  EXPECT_LT((solved(m).top - s.top).norm(), 1e-9) << "as if it were not there";
}

TEST(GuyedMast, InstalledTensionIsMetAndItsLengthGivesTheSame) {
  for (const GuyEnd end : {GuyEnd::top, GuyEnd::anchor}) {
    for (const double T : {1.5e3, 20e3, 150e3}) {
      const Guy g = guy_at(1, 12, 14, GuyTension{.tension = T, .at = end}, -3);
      const auto L = installed_length(g);
      ASSERT_TRUE(L);
      const auto span =
          rope::solve_span({.length = *L, .weight = g.weight, .stiffness = g.stiffness}, Vector3(0, 0, 12) - g.anchor);
      ASSERT_TRUE(span);
      EXPECT_NEAR(end == GuyEnd::top ? tension_at_end(*span) : tension_at_start(*span), T, 1e-6 * T);
    }
  }
  GuyedMast m = yarder();
  const GuyedMastResult r = solved(m);
  for (std::size_t i = 0; i < 4; ++i) m.guys[i].install = GuyLength{r.guys[i].length};
  EXPECT_LT((solved(m).top - r.top).norm(), 1e-9);
}

TEST(GuyedMast, TensionBelowTheGuysOwnWeightIsRefused) {
  GuyedMast m = yarder();
  m.guys[2].weight = 60;
  m.guys[2].install = GuyTension{.tension = 300, .at = GuyEnd::top};
  GuyedMastResult r;
  const Outcome o = solve(m, r);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("own weight"), std::string::npos);
}

TEST(GuyedMast, GuysThatPressTooHardBuckleTheMastBeforeItIsLoaded) {
  GuyedMast m = yarder();
  m.section = structure::tube_section(0.06, 0.003);
  m.guys.clear();
  for (int i = 0; i < 4; ++i) {
    m.guys.push_back(guy_at(90 * degree * i, 12, 14, GuyTension{.tension = 150e3, .at = GuyEnd::top}));
    m.guys.back().stiffness = 1e6;  // soft: the mast's bow does not take the tension away
  }
  GuyedMastResult r;
  const Outcome o = solve(m, r);
  EXPECT_EQ(o.status, Status::infeasible);
  EXPECT_NE(o.message.find("alone"), std::string::npos) << o.message;
}

TEST(GuyedMast, TighterGuysHoldTheTopBetter) {
  double before = 1e9;
  for (const double T : {5e3, 20e3, 40e3}) {
    GuyedMast m = yarder();
    m.guys.push_back(guy_at(0, 12, 14, GuyTension{.tension = T, .at = GuyEnd::top}));
    for (Guy& g : m.guys) g.install = GuyTension{.tension = T, .at = GuyEnd::top};
    const double top = solved(m).top.head<2>().norm();
    EXPECT_LT(top, before);
    before = top;
  }
}

TEST(GuyedMast, ForcesAHairsbreadthApartAreNoTrouble) {
  const GuyedMastResult r = solved(yarder());
  for (const double apart : {1e-3, 1e-6, 1e-12}) {
    GuyedMast m = yarder();
    m.loads[0].height -= apart;
    m.guys[1].height -= 2 * apart;
    m.guys[2].height -= 3 * apart;
    EXPECT_LT((solved(m).top - r.top).norm(), (5 * apart + 1e-9) * 10);
  }
}

RC_GTEST_PROP(GuyedMast, BalancesOrSaysWhyNot, ()) {
  const auto between = [](double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000001) * 1e-6;
  };
  GuyedMast m;
  m.height = between(4, 40);
  const double D = m.height * between(0.01, 0.06);
  m.section = structure::tube_section(D, D * between(0.02, 0.1));
  m.base = *rc::gen::element(MastBase::clamped, MastBase::hinged);
  const int guys = *rc::gen::inRange(0, 7);
  for (int i = 0; i < guys; ++i) {
    const double height = m.height * *rc::gen::element(0.5, 0.9, 1.0), angle = between(0, 6.3), far = between(3, 60);
    GuyInstallation install =
        GuyTension{.tension = between(10, 40e3), .at = *rc::gen::element(GuyEnd::top, GuyEnd::anchor)};
    const Vector3 anchor(far * std::cos(angle), far * std::sin(angle), between(-10, 10));
    if (*rc::gen::arbitrary<bool>()) {
      install = GuyLength{(Vector3(0, 0, height) - anchor).norm() * between(0.998, 1.05)};
    }
    m.guys.push_back({"g", height, anchor, between(1e6, 50e6), *rc::gen::element(0.0, 2.0, 20.0), install, {}});
  }
  const double force = between(0, 300e3);
  m.loads = {{.height = m.height, .force = {force * between(0, 1), force * between(-0.2, 0.2), -force * between(0, 1)}},
             {.height = m.height * between(0.3, 1), .force = {force * between(0, 0.3), 0, -force * between(0, 0.3)}}};
  GuyedMastResult r;
  const Outcome o = solve(m, r);
  RC_CLASSIFY(o.ok());
  if (!o.ok()) {
    RC_ASSERT(o.status == Status::infeasible && !o.message.empty());
    return;
  }
  double all = 1;
  for (const GuyState& g : r.guys) all += g.tension_top;
  RC_ASSERT(r.force_balance < 1e-7 * (all + 2 * force));
  RC_ASSERT(r.moment_balance < 1e-7 * (all + 2 * force) * m.height);
  RC_ASSERT(r.closure < 1e-8 * m.height);
}

TEST(GuyedMast, OwnWeightIsCarriedByTheFoot) {
  GuyedMast m = yarder();
  m.section.weight = 760;
  const GuyedMastResult with = solved(m);
  EXPECT_LT(with.force_balance, 1e-8 * 200e3);
  EXPECT_LT(with.moment_balance, 1e-4 * 760 * 12 * with.top.norm()) << "the trapezoidal rule's error";
  m.section.weight = 0;
  EXPECT_GT(with.base_force.z(), solved(m).base_force.z() + 0.9 * 760 * 12);
}

/// The same mast as a machine: a beam, and its guys as ropes of the lengths that they were put up with.
machine::Model machine_of(const GuyedMast& m) {
  machine::StraightBeam b;
  b.name = "mast";
  b.to.at = {0, 0, m.height};
  b.section = m.section;
  b.base = m.base == MastBase::hinged ? machine::BeamHold::hinged : machine::BeamHold::clamped;
  for (const Guy& guy : m.guys) b.stations.push_back(guy.height / m.height);
  for (const MastLoad& load : m.loads) b.stations.push_back(load.height / m.height);
  b.stations = machine::cuts_of(b, m.height);
  machine::Model machine;
  machine::add_beam(machine, b);
  const auto section_at = [&](double height) {
    for (std::size_t k = 0; k < machine.bodies.size(); ++k) {
      if (std::abs(machine.bodies[k].position.z() - height) < 1e-5) return static_cast<int>(k);
    }
    return -1;
  };
  for (const MastLoad& load : m.loads)
    machine.loads.push_back({{.body = section_at(load.height), .at = Vector3::Zero()}, load.force});
  for (const Guy& guy : m.guys) {
    machine::Reeving rope;
    rope.name = guy.name;
    rope.nodes.resize(2);
    rope.nodes[0].at.at = guy.anchor;
    rope.nodes[1].at.body = section_at(guy.height);
    rope.value = *installed_length(guy);
    rope.weight = guy.weight;
    rope.stiffness = guy.stiffness;
    machine.reevings.push_back(rope);
  }
  return machine;
}

/// A tower yarder with four guys at unequal plan angles, pulled out of their middle until one of them is loose.
GuyedMast slewed(MastBase base) {
  GuyedMast m = yarder();
  m.base = base;
  m.guys.clear();
  for (const double angle : {40.0, 115.0, 200.0, 290.0}) {
    m.guys.push_back(
        guy_at(angle * degree, 12, 13, GuyTension{.tension = 6e3, .at = GuyEnd::top}, angle > 180 ? -1.5 : 0.8));
  }
  m.loads = {{.height = 12, .force = {45e3, 22e3, -90e3}}, {.height = 10.8, .force = {15e3, -6e3, -45e3}}};
  return m;
}

TEST(GuyedMast, OfADeckIsTheSame) {
  GuyedMast slim = yarder();
  slim.section = structure::tube_section(0.1937, 0.008);
  slim.guys[1].height = 6;
  GuyedMast heavy = slewed(MastBase::hinged);
  heavy.section.weight = 760;
  for (const GuyedMast& m : {yarder(), slim, slewed(MastBase::clamped), slewed(MastBase::hinged), heavy}) {
    const GuyedMastResult r = solved(m);
    const EquilibriumResult e = equilibrium(machine_of(m));
    ASSERT_TRUE(e.outcome.ok()) << e.outcome.message;
    const BeamResult& beam = e.beams[0];
    EXPECT_LT((beam.points.back().deflection - r.top).norm(), 1e-6 * r.top.norm());
    EXPECT_LT((beam.base_force - r.base_force).norm(), 1e-6 * r.base_force.norm());
    EXPECT_NEAR(beam.points[beam.most_bent].M, bending(r.points[r.most_bent]), 1e-3 * bending(r.points[r.most_bent]));
    EXPECT_LT((beam.base_moment - r.base_moment).norm(), 1e-6 * bending(r.points[r.most_bent]));
    double largest = 0;
    for (const GuyState& g : r.guys) largest = std::max(largest, g.tension_top);
    for (std::size_t i = 0; i < m.guys.size(); ++i)
      EXPECT_NEAR(e.branches[i].T_to, r.guys[i].tension_top, 1e-6 * largest);
    EXPECT_LT(e.closure.balance, 1e-8 * r.base_force.norm());
  }
}

TEST(GuyedMast, OfADeckAgreesWithTheHandModelWhereAGuyGoesSlack) {
  for (const MastBase base : {MastBase::clamped, MastBase::hinged}) {
    const GuyedMast m = slewed(base);
    const EquilibriumResult e = equilibrium(machine_of(m));
    ASSERT_TRUE(e.outcome.ok()) << e.outcome.message;
    const witness::Answer w = witness::solve(m, 80, 20);
    ASSERT_TRUE(w.settled);
    const Vector3 top = e.beams[0].points.back().deflection;
    EXPECT_GT(std::abs(top.y()), 0.1 * top.norm()) << "in space";
    EXPECT_LT((top - w.top).norm(), 1e-3 * top.norm()) << top.transpose() << " : " << w.top.transpose();
    double largest = 0, least = 1e9;
    for (const auto& span : e.branches) largest = std::max(largest, span.T_to), least = std::min(least, span.T_to);
    EXPECT_LT(least, 500) << "one is loose";
    for (std::size_t i = 0; i < m.guys.size(); ++i) EXPECT_NEAR(e.branches[i].T_to, w.tension_top[i], 1e-3 * largest);
    if (base == MastBase::clamped) {
      EXPECT_NEAR(e.beams[0].points.front().M, w.foot_moment, 1e-3 * e.beams[0].points[e.beams[0].most_bent].M);
    }
  }
}

TEST(GuyedMast, OfADeckBucklesWhereItDoes) {
  GuyedMast m = slewed(MastBase::hinged);
  m.section = structure::tube_section(0.1937, 0.008);
  const EquilibriumResult e = equilibrium(machine_of(m));
  ASSERT_TRUE(e.outcome.ok()) << e.outcome.message;
  EXPECT_GT(e.beams[0].critical_factor, 1);
  // with the loads as large as it says, about: its guys press it too, and do not grow in the same way
  GuyedMastResult r;
  for (MastLoad& load : m.loads) load.force *= 1.5 * e.beams[0].critical_factor;
  EXPECT_FALSE(solve(m, r).ok());
  EXPECT_FALSE(equilibrium(machine_of(m)).outcome.ok());
}

}  // namespace taut_test::guyed_mast_test
