// A skyline over two supports, uphill: tensions with the carriage at rest, and the payload along the middle span.
#include <iostream>

#include "taut/taut.hpp"

using namespace taut::machine;

int main() {
  Builder line;
  line.point("stump", {0, 0, 4}).point("tower", {360, 0, 124}).point("block", {360, 0, 122});
  line.rope("skyline", "EN 12385-4|6x36-IWRC|20|1960")
      .rope("mainline", RopeFigures{.mass = 0.54, .stiffness = 7e6, .breaking_force = 110e3, .diameter = {}});
  line.saddle("jack1", {110, 0, 33}, 0.1, 0.4).saddle("jack2", {240, 0, 78}, 0.1, 0.4);
  line.carriage("car", 350, "skyline", "mainline");
  line.reeve("skyline", {anchor("stump"), over("jack1"), through("car"), over("jack2"), anchor("tower")}, length(382));
  line.reeve("mainline", {anchor("block"), anchor("car")}, length(192));
  const auto model = line.model();
  if (!model) {
    for (const taut::Complaint& c : model.error()) std::cerr << c.path << ": " << c.message << "\n";
    return 1;
  }

  const auto rest = taut::solve::equilibrium(*model);
  if (!rest.outcome.ok()) return std::cerr << rest.outcome.message << "\n", 1;
  const auto skyline = static_cast<std::size_t>(reeving_named(*model, "skyline").value());
  std::cout << "empty: skyline " << rest.ropes[skyline].T_max / 1e3 << " kN, safety factor "
            << rest.ropes[skyline].safety_factor << "\n";

  taut::study::PayloadLimits limits;
  limits.tension.assign(model->reevings.size(), std::numeric_limits<double>::infinity());
  limits.tension[skyline] = model->reevings[skyline].breaking_force / 3;
  taut::study::LoadPathOptions way;
  way.carriage = carriage_named(*model, "car").value();
  way.from = 140;
  way.to = 230;
  way.steps = 9;
  bool all = true;
  for (const taut::study::PayloadPoint& place : taut::study::payload_path(*model, limits, way)) {
    all = all && place.payload.outcome.ok() && place.payload.mass > 0;
    std::cout << "x = " << place.x << " m: " << place.payload.mass << " kg, " << place.payload.governing << "\n";
  }
  return all ? 0 : 1;
}
