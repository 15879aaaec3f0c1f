#include "taut/app/exact/mast_machine.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "taut/math/degree.hpp"
#include "test/witness/guyed_mast.hpp"

namespace taut::app::mast_machine_test {

namespace witness = taut_test::witness;
using namespace mast_section;

Guy guy_at(double angle, double tension, GuyEnd end) {
  Guy g;
  g.stiffness = 15e6;
  g.weight = 9;
  g.breaking_force = 180e3;
  g.plan_angle = angle;
  g.anchor_distance = 14;
  g.anchor_height = angle > 3 ? -1.5 : 0.8;
  g.install = GuyInstall{.tension = tension, .at = end};
  return g;
}

/// A tower yarder's mast with guys at two heights and a force across the span.
Input yarder(Base base) {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 12;
  in.mainline_block_height = 10.8;
  in.branch_angle = 12 * degree;
  in.allowable_stress = 235e6;
  in.base = base;
  in.lateral_force = 6e3;
  for (const double angle : {110.0, 160.0, 205.0, 250.0})
    in.guys.push_back(guy_at(angle * degree, 15e3 + 10 * angle, angle < 180 ? GuyEnd::top : GuyEnd::anchor));
  in.guys.push_back(guy_at(40 * degree, 4e3, GuyEnd::top));
  in.guys[1].attachment_height = 7;
  return in;
}

/// The same mast as the witness wants it, its guys by the tensions of the deck.
witness::GuyedMast same(const Input& in, const ClampForces& forces, const structure::BeamSection& section) {
  witness::GuyedMast m;
  m.height = in.skyline_block_height;
  m.section = section;
  m.base = in.base == Base::hinged ? witness::MastBase::hinged : witness::MastBase::clamped;
  for (const Guy& g : in.guys) {
    const auto end = g.install->at == GuyEnd::top ? witness::GuyEnd::top : witness::GuyEnd::anchor;
    m.guys.push_back({.name = "g",
                      .height = g.attachment_height.value_or(m.height),
                      .anchor = {g.anchor_distance * std::cos(g.plan_angle), g.anchor_distance * std::sin(g.plan_angle),
                                 g.anchor_height},
                      .stiffness = *g.stiffness,
                      .weight = *g.weight,
                      .install = witness::GuyTension{.tension = g.install->tension, .at = end},
                      .breaking_force = g.breaking_force});
  }
  const auto load = [&](double height, const BlockForce& f) {
    m.loads.push_back({.height = height, .force = {f.across, 0, -f.down}});
  };
  load(in.skyline_block_height, forces.skyline);
  load(*in.mainline_block_height, forces.mainline);
  m.loads.push_back({.height = in.skyline_block_height, .force = {0, *in.lateral_force, 0}});
  return m;
}

TEST(MastMachine, ShootingFindsTheSame) {
  for (const Base base : {Base::clamped, Base::hinged}) {
    const Input in = yarder(base);
    const structure::BeamSection section = structure::tube_section(0.2732, 0.01);
    const ClampForces forces = clamp_forces(in, sweep(in)).front();
    const MastGuys guys = put_up_guys(in);
    ASSERT_TRUE(guys.outcome.ok()) << guys.outcome.message;
    const machine::Model model = mast_machine(in, guys.all, forces, section);
    const solve::EquilibriumResult found = solve::equilibrium(model);
    ASSERT_TRUE(found.outcome.ok()) << found.outcome.message;
    witness::GuyedMastResult w;
    const Outcome outcome = witness::solve(same(in, forces, section), w);
    ASSERT_TRUE(outcome.ok()) << outcome.message;
    const solve::BeamResult& mast = found.beams[0];
    const double bent = witness::bending(w.points[w.most_bent]), force = w.base_force.norm();
    EXPECT_LT((mast.points.back().deflection - w.top).norm(), 1e-6 * w.top.norm());
    EXPECT_LT((mast.base_force - w.base_force).norm(), 1e-7 * force);
    EXPECT_LT((mast.base_moment - w.base_moment).norm(), 1e-6 * bent);
    EXPECT_NEAR(mast.points[mast.most_bent].M, bent, 1e-3 * bent);
    EXPECT_NEAR(mast.points[mast.most_stressed].stress, w.points[w.worst].stress, 1e-3 * w.points[w.worst].stress);
    EXPECT_LT(moment_balance(model, found), 1e-8 * force * 12);
    for (std::size_t i = 0; i < in.guys.size(); ++i) {
      EXPECT_NEAR(guys.all[i].length, w.guys[i].length, 1e-9 * w.guys[i].length);
      EXPECT_NEAR(guys.all[i].installed, w.guys[i].tension_installed, 1e-6 * w.guys[i].tension_installed);
      EXPECT_NEAR(found.branches[i].T_to, w.guys[i].tension_top, 1e-6 * force);
      EXPECT_EQ(hangs(found.branches[i]), w.guys[i].slack);
    }
  }
}

TEST(MastMachine, AGuyOfGivenLengthHasTheTensionOfThatLength) {
  Input in = yarder(Base::clamped);
  const MastGuys by_tension = put_up_guys(in);
  for (std::size_t i = 0; i < in.guys.size(); ++i) {
    in.guys[i].install.reset();
    in.guys[i].length = by_tension.all[i].length;
  }
  const MastGuys by_length = put_up_guys(in);
  ASSERT_TRUE(by_length.outcome.ok()) << by_length.outcome.message;
  for (std::size_t i = 0; i < in.guys.size(); ++i)
    EXPECT_NEAR(by_length.all[i].installed, by_tension.all[i].installed, 1e-6 * by_tension.all[i].installed);
}

TEST(MastMachine, ATensionBelowTheGuysOwnWeightIsRefusedByItsNumber) {
  Input in = yarder(Base::clamped);
  in.guys[2].install->tension = 20;
  const MastGuys guys = put_up_guys(in);
  EXPECT_EQ(guys.outcome.status, Status::infeasible);
  EXPECT_NE(guys.outcome.message.find("guy 3: no length gives 20 N"), std::string::npos) << guys.outcome.message;
}

TEST(MastMachine, AWeightlessGuyMayHang) {
  Input in = yarder(Base::clamped);
  in.guys[4].weight = 0;
  in.guys[4].install.reset();
  in.guys[4].length = 25;
  const MastGuys guys = put_up_guys(in);
  ASSERT_TRUE(guys.outcome.ok()) << guys.outcome.message;
  EXPECT_EQ(guys.all[4].installed, 0);
  const auto found = solve::equilibrium(
      mast_machine(in, guys.all, clamp_forces(in, sweep(in)).front(), structure::tube_section(0.3239, 0.01)));
  ASSERT_TRUE(found.outcome.ok()) << found.outcome.message;
  EXPECT_TRUE(hangs(found.branches[4]));
}

TEST(MastMachine, LoadsAHairsbreadthApartAct) {
  Input in = yarder(Base::clamped);
  in.mainline_block_height = in.skyline_block_height - 1e-4;
  const MastGuys guys = put_up_guys(in);
  const ClampForces forces = clamp_forces(in, sweep(in)).front();
  const auto found = solve::equilibrium(mast_machine(in, guys.all, forces, structure::tube_section(0.3239, 0.01)));
  ASSERT_TRUE(found.outcome.ok()) << found.outcome.message;
  in.mainline_block_height = in.skyline_block_height;
  const auto one = solve::equilibrium(mast_machine(in, guys.all, forces, structure::tube_section(0.3239, 0.01)));
  ASSERT_TRUE(one.outcome.ok()) << one.outcome.message;
  EXPECT_NEAR(found.beams[0].base_moment.norm(), one.beams[0].base_moment.norm(),
              1e-3 * one.beams[0].base_moment.norm());
}

TEST(MastMachine, TheShareHeldIsThatOfTheBeamColumn) {
  Input in = yarder(Base::clamped);
  in.guys.clear();
  in.lateral_force.reset();
  in.mainline_block_height.reset();
  const structure::BeamSection section = structure::tube_section(0.1, 0.005);
  ClampForces forces;
  forces.skyline = {.across = 1, .down = 40e3};
  const machine::Model model = mast_machine(in, {}, forces, section);
  const Outcome told = with_share_held(model, solve::equilibrium(model).outcome);
  EXPECT_EQ(told.status, Status::infeasible);
  const double euler = std::pow(M_PI / 2 / 12, 2) * section.EI_x, share = 100 * euler / 40e3;
  const std::size_t at = told.message.find("above ");
  ASSERT_NE(at, std::string::npos) << told.message;
  EXPECT_NEAR(std::stod(told.message.substr(at + 6)), share, 0.02 * share) << told.message;
  EXPECT_NE(told.message.find("buckles"), std::string::npos);
}

/// A hinged mast of 10 m with a guy behind and two in front, 60 deg from the load; the ropes paid out slacken these.
machine::Model symmetric_yarder(double lateral, const structure::BeamSection& section) {
  Input in;
  in.skyline_force = 100e3;
  in.mainline_force = 40e3;
  in.skyline_block_height = 10;
  in.branch_angle = 60 * degree;
  in.allowable_stress = 160e6;
  in.base = Base::hinged;
  if (lateral != 0) in.lateral_force = lateral;
  for (const double angle : {180.0, 60.0, -60.0}) {
    Guy g = guy_at(angle * degree, 30e3, GuyEnd::top);
    g.stiffness = 40e6;
    g.weight = 0.01;
    g.anchor_distance = 10;
    g.anchor_height = 0;
    in.guys.push_back(g);
  }
  // paid out: full force on the span side, 0.73 of it (friction 0.12, wrap 150 deg) on the drum side
  ClampForces forces;
  forces.skyline = {.across = 100e3 * std::cos(60 * degree), .down = 100e3 * (std::sin(60 * degree) + 0.73)};
  forces.mainline = {.across = 40e3 * std::cos(60 * degree), .down = 40e3 * (std::sin(60 * degree) + 0.73)};
  forces.lateral = lateral;
  return mast_machine(in, put_up_guys(in).all, forces, section);
}

// A mast of 711 x 40 mm does not buckle under 160 kN. Its front guys go slack, and upright it stands only as on a
// needle.
TEST(MastMachine, BetweenSlackGuysAMastHasNoAnswerAndTheReasonNamesThem) {
  const machine::Model model = symmetric_yarder(0, structure::tube_section(0.711, 0.04));
  const Outcome upright = solve::equilibrium(model).outcome;
  EXPECT_EQ(upright.status, Status::infeasible);
  const std::string why = with_share_held(model, upright).message;
  EXPECT_NE(why.find("falls aside where guys go slack"), std::string::npos) << why;
}

}  // namespace taut::app::mast_machine_test
