#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "taut/machine/compile/beam_build.hpp"
#include "taut/machine/state.hpp"
#include "taut/mechanics/system.hpp"
#include "test/support/machines.hpp"

namespace jacobian_test {

namespace mechanics = taut::mechanics;

using namespace taut_test;

/// Spans close by one step at a time: asked until they do.
void settle(const mechanics::System& system, mechanics::Configuration& c, mechanics::Evaluation& e) {
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(mechanics::evaluate(system, c, e));
}

/// Worst difference between the derivatives and central differences, by the largest number of the row.
double worst_derivative(const machine::Model& m, std::optional<machine::Prescribed> prescribed, double step) {
  machine::State state = machine::initial_state(m);
  taut::Array<taut::Array<int>> flow;
  flow.reserve(m.reevings.size());
  for (const auto& r : m.reevings) flow.emplace_back(r.nodes.size(), 1);
  const mechanics::Layout layout = mechanics::layout(m, state, prescribed, flow);
  const mechanics::System system{.model = m, .layout = layout, .coordinate = prescribed ? prescribed->x : 0};
  mechanics::Configuration c;
  c.bodies = state.bodies;
  for (const auto& k : layout.branches) {
    c.branches.push_back(state.branches[static_cast<std::size_t>(k.reeving)][static_cast<std::size_t>(k.from)]);
  }
  c.hold = 700;
  c.open_loads.assign(layout.ropes.size(), 300);
  for (const auto& p : layout.pieces) {
    machine::PieceState piece = state.beams[static_cast<std::size_t>(p.beam)][static_cast<std::size_t>(p.piece)];
    piece.force = {3, -2, -40};
    piece.moment = {5, 8, 1};
    piece.torque = 2;
    if (p.hinged) piece.axes = Eigen::AngleAxisd(0.1, Vector3(0.5, -0.3, 0.2).normalized()) * piece.axes;
    c.pieces.push_back(piece);
  }
  mechanics::Evaluation e;
  settle(system, c, e);
  taut::Entries added;
  taut::Array<mechanics::BranchColumns> columns;
  mechanics::jacobian(system, c, e, added, columns);
  const Eigen::MatrixXd J = added.dense();
  double worst = 0;
  for (Eigen::Index j = 0; j < layout.size; ++j) {
    const mechanics::Change unit = mechanics::change_of(system, c, e, columns, Eigen::VectorXd::Unit(layout.size, j));
    const auto difference = [&](double h) {
      mechanics::Configuration ahead, back;
      mechanics::Evaluation e_ahead, e_back;
      mechanics::move(system, c, unit, h, ahead);
      mechanics::move(system, c, unit, -h, back);
      settle(system, ahead, e_ahead);
      settle(system, back, e_back);
      return Eigen::VectorXd((e_ahead.residual - e_back.residual) / (2 * h));
    };
    // Richardson: without the part that is quadratic in the step
    const Eigen::VectorXd slope = (4 * difference(step) - difference(2 * step)) / 3;
    for (Eigen::Index i = 0; i < layout.size; ++i) {
      worst = std::max(worst, std::abs(slope[i] - J(i, j)) / J.row(i).cwiseAbs().maxCoeff());
    }
  }
  return worst;
}

TEST(Jacobian, MatchesDifferencesOnEveryKindOfMachine) {
  EXPECT_LT(worst_derivative(three_spans(316, 0.1), {}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(with_carriage(true), {}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(with_carriage(true), machine::Prescribed{0, 150}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(with_carriage(false), machine::Prescribed{0, 150}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(tackle(6, 0.97, 3000), {}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(tackle(5, 0.97, 3000, 10), {}, 1e-5), 1e-7);
}

TEST(Jacobian, MatchesDifferencesWithTurningBodiesAndSkewSheaves) {
  // The wrap's dependence on the tilt of a turning axis is left out of the arc: a skew axis costs a little.
  machine::Model m = boom();
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-3);
  m.reevings[1].nodes[1].axis = Vector3::UnitY();
  EXPECT_LT(worst_derivative(m, {}, 3e-7), 3e-7);
}

TEST(Jacobian, MatchesDifferencesForGivenTensionsWarmRopesAndCopies) {
  machine::Model m = with_carriage(true);
  m.reevings[0].given = machine::Given::tension_at_end;
  m.reevings[0].value = 60e3;
  m.reevings[0].copies = 2;
  m.reevings[0].thermal_strain = 3e-4;
  m.reevings[1].given = machine::Given::tension_at_start;
  m.reevings[1].value = 9e3;
  EXPECT_LT(worst_derivative(m, {}, 1e-5), 1e-7);
}

TEST(Jacobian, MatchesDifferencesForEqualTensions) {
  machine::Model m = three_spans(316, 0.1);
  m.bodies.push_back(body("load", {3, 0, -2}, 80, "xz"));
  m.reevings.push_back(reeve("a", {anchor("a", {0, 0, 6}), anchor_on("load", 0)}, 8.6, 4, 1e5));
  m.reevings.push_back(reeve("b", {anchor("b", {9, 0, 7}), anchor_on("load", 0)}, 10.9, 5, 2e5));
  m.reevings.back().given = machine::Given::equal;
  m.reevings.back().equal_to = static_cast<int>(m.reevings.size()) - 2;
  EXPECT_LT(worst_derivative(m, {}, 1e-5), 1e-7);
}

TEST(Jacobian, MatchesDifferencesForCarriagesThatPitch) {
  machine::Prescribed aside{.carriage = 0, .x = 62, .along = Vector3(0.8, 0.6, 0).normalized()};
  EXPECT_LT(worst_derivative(rollers(1, 0, 0.4, 900), machine::Prescribed{0, 60}, 1e-5), 1e-6);
  EXPECT_LT(worst_derivative(rollers(3, 1.2, 0.4, 900), aside, 1e-7), 1e-6);
  aside.z = 25;
  EXPECT_LT(worst_derivative(rollers(2, 1.2, 0, 900), aside, 1e-7), 1e-6);
}

TEST(Jacobian, MatchesDifferencesForClampsAndClosedRopes) {
  machine::Model m = with_carriage(false);
  m.reevings[0].nodes[2].kind = machine::NodeKind::clamp;
  m.reevings[0].nodes[2].length_before = 155;
  EXPECT_LT(worst_derivative(m, {}, 1e-5), 1e-7);
  machine::Model loop;
  loop.bodies.push_back(body("take-up", {6, 0, 0.1}, 500, "x"));
  machine::Node drive = sheave("drive", {0, 0, 0}, 0.4, 1);
  drive.kind = machine::NodeKind::drive;
  loop.reevings.push_back(reeve(
      "saw", {drive, sheave("top", {3, 0, 2}, 0.3, 1, 0.98), sheave("idler", origin, 0.3, 1, 0.97, 0)}, 15, 4, 2e6));
  loop.reevings[0].closed = true;
  EXPECT_LT(worst_derivative(loop, {}, 1e-6), 1e-6);
}

/// A beam from a body that slides and turns, or the ground, to a free top or another body, with a guy at a lug.
machine::Model with_beam(machine::BeamHold base, machine::BeamTop top, taut::structure::BeamOrder order, bool on_body) {
  machine::Model m;
  m.bodies.push_back(body("slide", {0.3, 0, 0}, 200, "xXYZ"));
  m.bodies.push_back(body("head", {1, 0.5, 9}, 100, "xyzXYZ"));
  machine::StraightBeam b;
  b.name = "mast";
  if (on_body) b.from = {.body = 0, .at = {0.2, 0.1, 0.3}};
  b.to = top == machine::BeamTop::free ? machine::Place{.body = machine::ground, .at = {1, 0.5, 9}}
                                       : machine::Place{.body = 1, .at = {0.1, 0, -0.2}};
  b.section = taut::structure::tube_section(0.2, 0.01,
                                            {.E = 210e6, .G = 80e6});  // small forces: no rounding in the differences
  b.section.EI_y *= 0.7;
  b.section.weight = 4;
  b.strong = {1, 1, 0};
  b.order = order;
  b.base = base;
  b.top = top;
  b.bow = 1.0 / 300;
  b.sense = {0.3, -1, 0};
  b.stations = {0.6};
  machine::add_beam(m, b);
  m.loads.push_back({{.body = 2, .at = {0.1, 0.2, -0.1}}, {5, 1, -9}});
  m.reevings.push_back(reeve("guy", {anchor("stump", {-6, 2, 0}), anchor_on("lug", 2, {-0.2, 0.1, 0.3})}, 8.3, 9, 5e6));
  m.reevings.push_back(reeve("top", {anchor("tree", {9, -2, 1}), anchor_on("head", 1)}, 12, 9, 5e6));
  return m;
}

TEST(Jacobian, MatchesDifferencesForBeams) {
  using machine::BeamHold;
  using machine::BeamTop;
  for (const auto order : {taut::structure::BeamOrder::first, taut::structure::BeamOrder::second}) {
    for (const BeamHold base : {BeamHold::clamped, BeamHold::hinged}) {
      for (const BeamTop top : {BeamTop::free, BeamTop::clamped, BeamTop::hinged}) {
        for (const bool on_body : {false, true}) {
          EXPECT_LT(worst_derivative(with_beam(base, top, order, on_body), {}, 1e-5), 1e-7)
              << static_cast<int>(order) << static_cast<int>(base) << static_cast<int>(top) << on_body;
        }
      }
    }
  }
}

TEST(Jacobian, MatchesDifferencesForRopeLoadsAndTorques) {
  machine::Model m;
  m.bodies.push_back(body("take-up", {6, 0, 0.1}, 500, "x"));
  m.bodies.push_back(body("load", {4.06, 0, 1.69}, 0, "xyz"));
  m.bodies.push_back(body("spread", {4.96, 0.02, 1.11}, 0, "xyz"));
  machine::Node drive = sheave("drive", {0, 0, 0}, 0.4, 1);
  drive.kind = machine::NodeKind::drive;
  drive.tension_drop = 800;
  machine::Node load = anchor_on("load", 1), spread = anchor_on("spread", 2);
  load.kind = spread.kind = machine::NodeKind::load;
  load.load = {.share = 0.3, .force = 600, .rate = 0, .part = 0, .sense = -1, .by_motion = true, .open = false};
  spread.load = {.share = 0.6, .force = 0, .rate = 50, .part = 0.4, .sense = 1, .by_motion = false, .open = false};
  m.reevings.push_back(
      reeve("saw", {drive, sheave("top", {3, 0, 2}, 0.3, 1, 0.98), load, spread, sheave("idler", origin, 0.3, 1, 1, 0)},
            15, 4, 2e6));
  m.reevings[0].closed = true;
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
  m.reevings[0].nodes[2].load.open = true;
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
  auto& nodes = m.reevings[0].nodes;
  nodes.erase(nodes.begin() + 2, nodes.begin() + 4);
  m.reevings[0].given = machine::Given::torque;
  m.bodies.resize(1);
  m.bodies[0].free.clear();
  m.reevings[0].weight = 0;  // as described it lies straight, without tension
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
}

TEST(Jacobian, MatchesDifferencesForDrivenRopesWithEnds) {
  machine::Model m;
  m.bodies.push_back(body("cabin", {-0.5, 0, -20}, 900, "z"));
  m.bodies.push_back(body("weight", {0.5, 0, -30}, 700, "z"));
  machine::Node drive = sheave("drive", {0, 0, 0}, 0.5, 1);
  drive.kind = machine::NodeKind::drive;
  drive.tension_drop = 1500;
  m.reevings.push_back(reeve("hoist", {anchor_on("cabin", 0), drive, anchor_on("weight", 1)}, 51.6, 10, 5e6));
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
  m.reevings[0].nodes[1].tension_drop.reset();
  m.reevings[0].given = machine::Given::tension_at_start;
  m.reevings[0].value = 9000;
  m.reevings[0].also = std::pair(machine::Given::length, 51.6);
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
}

}  // namespace jacobian_test
