#include "taut/mechanics/stiff_branch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/machine/state.hpp"
#include "test/support/machines.hpp"

namespace stiff_branch_test {

namespace mechanics = taut::mechanics;

using namespace taut_test;

/// Worst difference between the derivatives and central differences, each unknown by its own size, by the largest
/// number of the row.
double worst_rate(const machine::Model& m) {
  const machine::State state = machine::initial_state(m);
  taut::Array<taut::Array<int>> flow;
  flow.reserve(m.reevings.size());
  for (const auto& r : m.reevings) flow.emplace_back(r.nodes.size(), 1);
  const mechanics::Layout by_length = mechanics::layout(m, state, {}, flow);
  mechanics::Configuration c = configuration_of(by_length, state);
  c.open_loads.assign(by_length.ropes.size(), 0);
  mechanics::Evaluation e;
  const mechanics::System first{.model = m, .layout = by_length};
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(mechanics::evaluate(first, c, e));
  const mechanics::Layout layout = mechanics::with_forces(by_length, m, 0, 1e6);
  EXPECT_GT(layout.size, by_length.size);
  const mechanics::System system{.model = m, .layout = layout};
  c = mechanics::with_forces(system, c, e);
  EXPECT_FALSE(mechanics::evaluate(system, c, e));
  taut::Entries added;
  taut::Array<mechanics::BranchColumns> columns;
  mechanics::jacobian(system, c, e, added, columns);
  const Eigen::MatrixXd J = added.dense();
  Eigen::VectorXd size = Eigen::VectorXd::Ones(layout.size);
  size.tail(layout.size - by_length.size).setConstant(e.largest_force);
  const Eigen::MatrixXd scaled = J * size.asDiagonal();
  double worst = 0;
  const double step = 1e-6;
  for (Eigen::Index j = 0; j < layout.size; ++j) {
    mechanics::Configuration ahead, back;
    mechanics::Evaluation e_ahead, e_back;
    const Eigen::VectorXd unit = size[j] * Eigen::VectorXd::Unit(layout.size, j);
    const mechanics::Change change = mechanics::change_of(system, c, e, columns, unit);
    mechanics::move(system, c, change, step, ahead);
    mechanics::move(system, c, change, -step, back);
    EXPECT_FALSE(mechanics::evaluate(system, ahead, e_ahead));
    EXPECT_FALSE(mechanics::evaluate(system, back, e_back));
    const Eigen::VectorXd slope = (e_ahead.residual - e_back.residual) / (2 * step);
    for (Eigen::Index i = 0; i < layout.size; ++i) {
      worst = std::max(worst, std::abs(slope[i] - scaled(i, j)) / scaled.row(i).cwiseAbs().maxCoeff());
    }
  }
  return worst;
}

TEST(StiffBranch, RatesMatchDifferences) {
  EXPECT_LT(worst_rate(three_spans(316, 0.1)), 1e-6);
  EXPECT_LT(worst_rate(with_carriage(true)), 1e-6);
  EXPECT_LT(worst_rate(tackle(6, 0.97, 3000)), 1e-6);
  EXPECT_LT(worst_rate(tackle(5, 0.97, 3000, 10)), 1e-6);
  machine::Model m = boom();
  m.reevings[1].nodes[1].axis = Vector3::UnitY();
  EXPECT_LT(worst_rate(m), 1e-5);
}

TEST(StiffBranch, EvaluatesToTheSameBalanceAsByLengths) {
  const machine::Model m = with_carriage(true);
  const machine::State state = machine::initial_state(m);
  const taut::Array<taut::Array<int>> flow{{0, 0, 0, 0, 0}, {0, 0}};
  const mechanics::Layout by_length = mechanics::layout(m, state, {}, flow);
  mechanics::Configuration c = configuration_of(by_length, state);
  c.open_loads.assign(by_length.ropes.size(), 0);
  mechanics::Evaluation e, forces;
  const mechanics::System first{.model = m, .layout = by_length};
  for (int i = 0; i < 4; ++i) ASSERT_FALSE(mechanics::evaluate(first, c, e));
  const mechanics::Layout layout = mechanics::with_forces(by_length, m, 0, 1e6);
  const mechanics::System system{.model = m, .layout = layout};
  c = mechanics::with_forces(system, c, e);
  ASSERT_FALSE(mechanics::evaluate(system, c, forces));
  EXPECT_LT((forces.residual.head(by_length.size) - e.residual).cwiseAbs().maxCoeff(), 1e-9 * e.largest_force);
  EXPECT_LT(forces.residual.tail(layout.size - by_length.size).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace stiff_branch_test
