#pragma once
#include <string>

#include "taut/app/cases/study/study.hpp"

/// Inputs, limits and numbers of a study for the user's eyes, in the deck's units.
namespace taut::app {

/// "normal, mean 20 MN, sd 1.2 MN, cut to 15 MN ... 25 MN".
std::string law_in_words(const Study& study, std::size_t input);

/// "loads[0].mass 1.62 t, skyline.stiffness 19.8 MN": each input by the end of its path.
std::string values_in_words(const Study& study, const chance::Point& values);

/// The end of a path that still tells the inputs apart, two steps or more: "skyline.stiffness".
std::string short_name(const Study& study, std::size_t input);

/// "equilibrium.skyline.safety_factor below 3": what must not happen.
std::string beyond_in_words(const Study& study, const StudyLimit& limit);

/// "_2" of several things of one kind, empty of a single one; k from 0.
std::string name_ending(std::size_t k, std::size_t all);

/// Three digits: "0.0944", "1.23e-05", "0".
std::string probability_in_words(double p);

}  // namespace taut::app
