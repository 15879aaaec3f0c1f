#pragma once
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Shows `see` all signals of a model.
template <class See>
void for_each_signal(const Model& model, const See& see) {
  for (const Signal& signal : model.signals) see(signal);
  for (const Drum& drum : model.drums) see(drum.drive.signal);
  for (const Motor& motor : model.motors) see(motor.drive.signal);
  for (const Actuator& actuator : model.actuators) see(actuator.signal);
  for (const Tensioner& tensioner : model.tensioners) see(tensioner.change);
  for (const Load& load : model.loads) {
    if (load.over_time) see(*load.over_time);
  }
  for (const Body& body : model.bodies) {
    for (const DrivenWay& way : body.driven) see(way.signal);
  }
  for (const Reeving& rope : model.reevings) {
    for (const Node& node : rope.nodes) {
      if (node.load.signal) see(*node.load.signal);
    }
  }
  for (const Event& event : model.events) {
    if (event.kind == EventKind::drive) see(event.drive.signal);
  }
}

/// What still happens at a time, s, after which nobody looks.
struct GoesOn {
  bool ramps = false;   ///< a signal has not reached its last value
  bool swings = false;  ///< a sine or a formula goes on
};
GoesOn goes_on(const Model& model, double t);

}  // namespace taut::machine
