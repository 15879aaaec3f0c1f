#pragma once
#include <string>

#include "taut/mechanics/system.hpp"

namespace taut::solve {

/// Where a carriage is put at a place of its line: a carriage of the machine (the second section of a pair, say) that
/// lies past the next stop of a rope it rides on or is fixed to, seen along the line, in words with both names; empty
/// without one. The equations know no such thing: their rope runs on to the carriage and comes back to the stop. A stop
/// is whatever a rope runs to but a carriage; it is passed where the carriage and what comes before it in the path lie
/// on its two sides.
std::string past_stop(const mechanics::System& system, const mechanics::Configuration& c);

/// Where there is no such answer: a carriage clamped farther along the rope from the one that is put at a place than it
/// is from there to the next stop, in words with the names; empty without one. Its section of the rope, drawn taut,
/// would reach past the stop.
std::string section_past_stop(const mechanics::System& system);

}  // namespace taut::solve
