#include <algorithm>

#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/build.hpp"

namespace taut::solve::dynamics {
namespace {

void add_mass(Body& body, double mass, const Vector3& place) {
  const double total = body.mass + mass;
  const Vector3 centre = (body.mass * body.centre + mass * place) / total;
  const auto shift = [&](double by, const Vector3& from) {
    const Vector3 d = from - centre;
    body.inertia += by * (d.squaredNorm() * Matrix3::Identity() - d * d.transpose());
  };
  shift(body.mass, body.centre);
  shift(mass, place);
  body.mass = total;
  body.centre = centre;
}

}  // namespace

void lump_masses(Mechanism& m, const DynamicState& state) {
  const machine::Model& model = *m.model;
  for (Body& body : m.bodies) {
    body.mass = body.own_mass;
    body.centre = body.own_centre;
    body.inertia.setZero();
    if (body.model >= 0) body.inertia = model.bodies[body.model].inertia.asDiagonal();
  }
  for (const machine::Load& load : model.loads) {
    if (load.at.body >= 0 && load.mass > 0) add_mass(m.bodies[load.at.body], load.mass, load.at.at);
  }
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    Line& line = m.lines[i];
    const double mass = line.copies * line.mass * lumped_length(m, state, static_cast<int>(i));
    for (const std::size_t end : {0U, 1U}) {
      if (line.body[end] < 0 || mass == 0) continue;
      Body& body = m.bodies[line.body[end]];
      const double share = end == 0 ? 1 - line.middle : line.middle;
      add_mass(body, mass * share, line.place[end]);
      if (body.count > 0) line.carried[end] = mass / line.copies * std::min(share, 0.5);
    }
  }
  for (Body& body : m.bodies) {
    if (body.model >= 0) body.mass += model.bodies[body.model].counterweight;
  }
}

}  // namespace taut::solve::dynamics
