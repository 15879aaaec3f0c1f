#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "taut/analysis/beam_piece.hpp"
#include "taut/analysis/equilibrium.hpp"
#include "taut/analysis/guyed_mast.hpp"
#include "taut/analysis/machines_test.hpp"
#include "taut/model/beam_build.hpp"

namespace beam_test {

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

double euler(const structure::BeamSection& b, double length) { return std::pow(std::numbers::pi / length, 2) * b.EI_x; }

TEST(Beam, CriticalFactorIsEulers) {
  const structure::BeamSection tube = structure::tube_section(0.508, 0.016);
  for (const BeamOrder order : {BeamOrder::first, BeamOrder::second}) {
    for (const double share : {0.1, 0.5, 0.98}) {
      const double N = share * euler(tube, 16);
      const auto r = analysis::equilibrium(cantilever(order, {10, 0, -N}, 1e4));
      ASSERT_TRUE(r.outcome.ok()) << r.outcome.message;
      EXPECT_NEAR(r.beams[0].critical_factor, 1 / share, 1e-4 / share);
      EXPECT_NEAR(r.beams[0].compression, N, 1e-3 * N);
    }
    const auto pulled = analysis::equilibrium(cantilever(order, {10, 0, 1e6}));
    ASSERT_TRUE(pulled.outcome.ok());
    EXPECT_TRUE(std::isinf(pulled.beams[0].critical_factor));
    const auto r = analysis::equilibrium(cantilever(order, {0, 0, -1.05 * euler(tube, 16)}));
    EXPECT_EQ(r.outcome.status, taut::Status::infeasible);
    EXPECT_NE(r.outcome.message.find("buckles"), std::string::npos) << r.outcome.message;
  }
}

}  // namespace beam_test
