#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "taut/machine/compile/beam_build.hpp"
#include "taut/machine/state.hpp"
#include "taut/mechanics/system.hpp"
#include "test/support/machines.hpp"

namespace jacobian_test {

using namespace taut_test;
namespace analysis = taut::analysis;

/// Spans close by one step at a time: asked until they do.
void settle(const analysis::System& system, analysis::Configuration& c, analysis::Evaluation& e) {
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(analysis::evaluate(system, c, e));
}

/// Worst difference between the derivatives and central differences, by the largest number of the row.
double worst_derivative(const model::Model& m, std::optional<analysis::Prescribed> prescribed, double step) {
  model::State state = model::initial_state(m);
  std::vector<std::vector<int>> flow;
  flow.reserve(m.reevings.size());
  for (const auto& r : m.reevings) flow.emplace_back(r.nodes.size(), 1);
  const analysis::Layout layout = analysis::layout(m, state, prescribed, flow);
  const analysis::System system{m, layout, prescribed ? prescribed->x : 0};
  analysis::Configuration c;
  c.bodies = state.bodies;
  for (const auto& k : layout.links) {
    c.links.push_back(state.branches[static_cast<std::size_t>(k.reeving)][static_cast<std::size_t>(k.from)]);
  }
  c.hold = 700;
  c.open_loads.assign(layout.ropes.size(), 300);
  for (const auto& p : layout.pieces) {
    model::PieceState piece = state.beams[static_cast<std::size_t>(p.beam)][static_cast<std::size_t>(p.piece)];
    piece.force = {3, -2, -40};
    piece.moment = {5, 8, 1};
    piece.torque = 2;
    if (p.hinged) piece.axes = Eigen::AngleAxisd(0.1, Vector3(0.5, -0.3, 0.2).normalized()) * piece.axes;
    c.pieces.push_back(piece);
  }
  analysis::Evaluation e;
  settle(system, c, e);
  Eigen::MatrixXd J;
  std::vector<analysis::BranchColumns> columns;
  analysis::jacobian(system, c, e, J, columns);
  double worst = 0;
  for (Eigen::Index j = 0; j < layout.size; ++j) {
    analysis::Configuration ahead, back;
    analysis::Evaluation e_ahead, e_back;
    const analysis::Change unit = analysis::change_of(system, c, e, columns, Eigen::VectorXd::Unit(layout.size, j));
    analysis::move(system, c, unit, step, ahead);
    analysis::move(system, c, unit, -step, back);
    settle(system, ahead, e_ahead);
    settle(system, back, e_back);
    const Eigen::VectorXd slope = (e_ahead.residual - e_back.residual) / (2 * step);
    for (Eigen::Index i = 0; i < layout.size; ++i) {
      worst = std::max(worst, std::abs(slope[i] - J(i, j)) / J.row(i).cwiseAbs().maxCoeff());
    }
  }
  return worst;
}

TEST(Jacobian, MatchesDifferencesOnEveryKindOfMachine) {
  EXPECT_LT(worst_derivative(three_spans(316, 0.1), {}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(with_carriage(true), {}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(with_carriage(true), analysis::Prescribed{0, 150}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(with_carriage(false), analysis::Prescribed{0, 150}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(tackle(6, 0.97, 3000), {}, 1e-5), 1e-7);
  EXPECT_LT(worst_derivative(tackle(5, 0.97, 3000, 10), {}, 1e-5), 1e-7);
}

TEST(Jacobian, MatchesDifferencesWithTurningBodiesAndSkewSheaves) {
  // The wrap's dependence on the tilt of a turning axis is left out of the arc: a skew axis costs a little.
  model::Model m = boom();
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-3);
  m.reevings[1].nodes[1].axis = Vector3::UnitY();
  EXPECT_LT(worst_derivative(m, {}, 3e-8), 1e-6);
}

TEST(Jacobian, MatchesDifferencesForGivenTensionsWarmRopesAndCopies) {
  model::Model m = with_carriage(true);
  m.reevings[0].given = model::Given::tension_at_end;
  m.reevings[0].value = 60e3;
  m.reevings[0].copies = 2;
  m.reevings[0].thermal_strain = 3e-4;
  m.reevings[1].given = model::Given::tension_at_start;
  m.reevings[1].value = 9e3;
  EXPECT_LT(worst_derivative(m, {}, 1e-5), 1e-7);
}

TEST(Jacobian, MatchesDifferencesForCarriagesThatPitch) {
  analysis::Prescribed aside{0, 62, Vector3(0.8, 0.6, 0).normalized()};
  EXPECT_LT(worst_derivative(rollers(1, 0, 0.4, 900), analysis::Prescribed{0, 60}, 1e-5), 1e-6);
  EXPECT_LT(worst_derivative(rollers(3, 1.2, 0.4, 900), aside, 1e-7), 1e-6);
  aside.z = 25;
  EXPECT_LT(worst_derivative(rollers(2, 1.2, 0, 900), aside, 1e-7), 1e-6);
}

TEST(Jacobian, MatchesDifferencesForClampsAndClosedRopes) {
  model::Model m = with_carriage(false);
  m.reevings[0].nodes[2].kind = model::NodeKind::clamp;
  m.reevings[0].nodes[2].length_before = 155;
  EXPECT_LT(worst_derivative(m, {}, 1e-5), 1e-7);
  model::Model loop;
  loop.bodies.push_back(body("take-up", {6, 0, 0.1}, 500, "x"));
  model::Node drive = sheave("drive", {0, 0, 0}, 0.4, 1);
  drive.kind = model::NodeKind::drive;
  loop.reevings.push_back(reeve(
      "saw", {drive, sheave("top", {3, 0, 2}, 0.3, 1, 0.98), sheave("idler", origin, 0.3, 1, 0.97, 0)}, 15, 4, 2e6));
  loop.reevings[0].closed = true;
  EXPECT_LT(worst_derivative(loop, {}, 1e-6), 1e-6);
}

/// A beam from a body that slides and turns, or the ground, to a free top or another body, with a guy at a lug.
model::Model with_beam(model::BeamHold base, model::BeamTop top, taut::structure::BeamOrder order, bool on_body) {
  model::Model m;
  m.bodies.push_back(body("slide", {0.3, 0, 0}, 200, "xXYZ"));
  m.bodies.push_back(body("head", {1, 0.5, 9}, 100, "xyzXYZ"));
  model::StraightBeam b;
  b.name = "mast";
  if (on_body) b.from = {0, {0.2, 0.1, 0.3}};
  b.to = top == model::BeamTop::free ? model::Place{model::ground, {1, 0.5, 9}} : model::Place{1, {0.1, 0, -0.2}};
  b.section = taut::structure::tube_section(0.2, 0.01, {210e6, 80e6});  // small forces: no rounding in the differences
  b.section.EI_y *= 0.7;
  b.section.weight = 4;
  b.strong = {1, 1, 0};
  b.order = order;
  b.base = base;
  b.top = top;
  b.bow = 1.0 / 300;
  b.sense = {0.3, -1, 0};
  b.stations = {0.6};
  model::add_beam(m, b);
  m.loads.push_back({{2, {0.1, 0.2, -0.1}}, {5, 1, -9}});
  m.reevings.push_back(reeve("guy", {anchor("stump", {-6, 2, 0}), anchor_on("lug", 2, {-0.2, 0.1, 0.3})}, 8.3, 9, 5e6));
  m.reevings.push_back(reeve("top", {anchor("tree", {9, -2, 1}), anchor_on("head", 1)}, 12, 9, 5e6));
  return m;
}

TEST(Jacobian, MatchesDifferencesForBeams) {
  using model::BeamHold;
  using model::BeamTop;
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
  model::Model m;
  m.bodies.push_back(body("take-up", {6, 0, 0.1}, 500, "x"));
  m.bodies.push_back(body("load", {4.06, 0, 1.69}, 0, "xyz"));
  m.bodies.push_back(body("spread", {4.96, 0.02, 1.11}, 0, "xyz"));
  model::Node drive = sheave("drive", {0, 0, 0}, 0.4, 1);
  drive.kind = model::NodeKind::drive;
  drive.tension_drop = 800;
  model::Node load = anchor_on("load", 1), spread = anchor_on("spread", 2);
  load.kind = spread.kind = model::NodeKind::load;
  load.load = {0.3, 600, 0, 0, -1, true, false};
  spread.load = {0.6, 0, 50, 0.4, 1, false, false};
  m.reevings.push_back(
      reeve("saw", {drive, sheave("top", {3, 0, 2}, 0.3, 1, 0.98), load, spread, sheave("idler", origin, 0.3, 1, 1, 0)},
            15, 4, 2e6));
  m.reevings[0].closed = true;
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
  m.reevings[0].nodes[2].load.open = true;
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
  auto& nodes = m.reevings[0].nodes;
  nodes.erase(nodes.begin() + 2, nodes.begin() + 4);
  m.reevings[0].given = model::Given::torque;
  m.bodies.resize(1);
  m.bodies[0].free.clear();
  m.reevings[0].weight = 0;  // as described it lies straight, without tension
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
}

TEST(Jacobian, MatchesDifferencesForDrivenRopesWithEnds) {
  model::Model m;
  m.bodies.push_back(body("cabin", {-0.5, 0, -20}, 900, "z"));
  m.bodies.push_back(body("weight", {0.5, 0, -30}, 700, "z"));
  model::Node drive = sheave("drive", {0, 0, 0}, 0.5, 1);
  drive.kind = model::NodeKind::drive;
  drive.tension_drop = 1500;
  m.reevings.push_back(reeve("hoist", {anchor_on("cabin", 0), drive, anchor_on("weight", 1)}, 51.6, 10, 5e6));
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
  m.reevings[0].nodes[1].tension_drop.reset();
  m.reevings[0].given = model::Given::tension_at_start;
  m.reevings[0].value = 9000;
  m.reevings[0].also = std::pair(model::Given::length, 51.6);
  EXPECT_LT(worst_derivative(m, {}, 1e-6), 1e-6);
}

}  // namespace jacobian_test
