#pragma once
#include <string>

#include "taut/calc/result.hpp"
#include "taut/catalogue/rope.hpp"

/// The limit of every rope: it does not break.
namespace taut::catalogue {

/// A rope's largest tension (N) against its breaking force, by name, rule and trust of `strength`. It may fail without
/// being asked; it is no limit by which the rope `part` passes.
Check breaking_check(std::string name, std::string part, double tension, Bound strength);

/// The same of a rope of the catalogue that a published method calls `part`: "return rope does not break".
Check breaking_check(const std::string& part, const RopeRow& rope, double tension);

}  // namespace taut::catalogue
