#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "taut/analysis/beam_piece.hpp"
#include "taut/analysis/equilibrium.hpp"
#include "taut/analysis/guyed_mast.hpp"
#include "taut/analysis/machines_test.hpp"
#include "taut/model/beam_build.hpp"

namespace {

using namespace taut_test;
namespace analysis = taut::analysis;
namespace structure = taut::structure;
using structure::BeamOrder;
using taut::Matrix3;

model::StraightBeam mast(double height, const structure::BeamSection& section) {
  model::StraightBeam b;
  b.name = "mast";
  b.to.at = {0, 0, height};
  b.section = section;
  return b;
}

/// A cantilever 8 m high with a force at its top.
model::Model cantilever(BeamOrder order, const Vector3& force, double EA_factor = 1) {
  model::Model m;
  model::StraightBeam b = mast(8, structure::tube_section(0.508, 0.016));
  b.section.EA *= EA_factor;
  b.order = order;
  model::add_beam(m, b);
  m.loads.push_back({{static_cast<int>(m.bodies.size()) - 1, Vector3::Zero()}, force});
  return m;
}

TEST(Beam, CantileverOfSecondOrderIsTheBeamColumn) {
  const double EI = structure::tube_section(0.508, 0.016).EI_x, h = 8;
  for (const double N : {50e3, 1e6, 4e6, 0.95 * std::pow(std::numbers::pi / 2 / h, 2) * EI}) {
    const double H = 10, k = std::sqrt(N / EI);
    const auto r = analysis::equilibrium(cantilever(BeamOrder::second, {H, 0, -N}, 1e8));
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
    const auto r = analysis::equilibrium(cantilever(BeamOrder::first, {1e3, 0, -N}));
    ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
    EXPECT_NEAR(r.state.beams[0][0].moment.norm(), 1e3 * h, 1e-7 * 1e3 * h);
    EXPECT_NEAR(r.state.bodies.back().position.x(), 1e3 * h * h * h / (3 * EI), 1e-9);
  }
}

}  // namespace
