#pragma once
#include <string>
#include <vector>

#include "taut/app/machine_deck.hpp"
#include "taut/results/machine_run.hpp"

namespace taut::app {

/// What a machine may have by its deck's rules, but hardly ever means, as warnings: a sheave, support, drum, point,
/// rope, body or signal that nothing uses; a rope with ends that is shorter than the straight way along its path, where
/// that way does not change; a rope whose places all have z = 0 while their y differ; saddles without a friction;
/// events and observed quantities without a motion; reference temperatures without a temperature.
std::vector<std::string> absurd_machine(const MachineDeck& deck, const machine::Model& model);

/// Dragged bunches that travel across the line of the carriage at which they hang, or away from its mainline: the force
/// of the ground, which has their direction, may be too small for the ropes. Unsafe warnings.
std::vector<std::string> dragged_astray(const machine::Machine& given, const machine::Model& model);

/// A rope that sags by more than half its span in one of the states found: the worst one.
std::vector<std::string> absurd_answers(const std::vector<results::Answer>& answers, const Display& display);

}  // namespace taut::app
