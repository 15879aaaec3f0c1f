#pragma once
#include <cmath>
#include <numbers>

#include "test/support/dice.hpp"
#include "test/support/machines.hpp"

namespace taut_test {

/// Adds a hinged pole between three to six guys of given length, with a load on its top, by chance. Its height, m.
inline double add_guyed_pole(Dice& dice, machine::Model& model) {
  const double h = dice.in(5, 40), weight = dice.below(3) == 0 ? 0 : dice.ten_to(0, 1.5);
  model.bodies.push_back(body("pole", origin, dice.ten_to(2, 4), "XY"));
  model.bodies[0].centre = {0, 0, h / 2};
  const int guys = 3 + dice.below(4);
  for (int i = 0; i < guys; ++i) {
    const double angle = 2 * std::numbers::pi * i / guys + dice.in(-0.3, 0.3), R = h * dice.in(0.5, 1.5);
    const Vector3 at(R * std::cos(angle), R * std::sin(angle), dice.in(-0.2, 0.2) * h);
    model.reevings.push_back(reeve("guy", {anchor_on("top", 0, {0, 0, h}), anchor("a", at)},
                                   (at - Vector3(0, 0, h)).norm() * dice.in(0.99, 0.999), weight,
                                   dice.ten_to(5.5, 7.5)));
  }
  model.loads.push_back({{.body = 0, .at = {0, 0, h}}, {dice.in(-2e3, 2e3), dice.in(-2e3, 2e3), -dice.ten_to(3, 4)}});
  return h;
}

}  // namespace taut_test
