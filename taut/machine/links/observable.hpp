#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// The first column of every series, whose name nothing else in it may have.
inline constexpr const char* time_name = "t";
inline constexpr const char* time_name_taken = "'t' is the time in the series of every motion: choose another name";

/// What a path of a deck asks for: "car.z", "skyline.T_max", "ext[2].T", "winch.torque", "energy.kinetic", the name of
/// a signal. `model`: its bodies, reevings, drums, contacts, actuators, signals and places are there. Complains at
/// `path` with what there is instead.
std::optional<Observable> observable(const std::string& text, const Model& model, const std::string& path,
                                     std::vector<Complaint>& complaints);

/// "car.z > 12 m", either way round of < and >.
std::optional<Condition> condition(const std::string& text, const Model& model, const std::string& path,
                                   std::vector<Complaint>& complaints);

/// What is worth writing down when the deck names nothing: tensions at both ends and the largest of each rope, place of
/// each free body along its ways, speed of each drum and motor, normal and friction force of each contact, force of
/// each actuator.
Array<Observable> usual_observables(const Model& model);

/// All that a path may name, for the reference: words in capitals stand for names of the deck, N for a number.
std::vector<QuantityWords> observable_words();

}  // namespace taut::machine
