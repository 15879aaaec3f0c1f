#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/study/put_up.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {
struct CheckedParts;
}

namespace taut::results {

/// Of ropes that were put up (`install:`): their table `put_up`, and of each NAME.base_tension and NAME.cut_length.
void add_put_up(const machine::Model& model, const std::vector<study::PutUpLine>& lines, Result& r);

/// Shows their states to the checks.
void show_put_up(const machine::Model& model, const std::vector<study::PutUpLine>& lines,
                 checks::CheckedParts& checked);

/// Shows the unloaded machine, let go on its guys, to the checks: their tensions there are pretensions too.
void show_stand_on_guys(const machine::Machine& machine, const study::PutUpMoment& stand,
                        checks::CheckedParts& checked);

/// A machine without an answer on its guys alone is not judged in that state. Where other ropes than guys (`first_guy`:
/// the first of these) hold its beams, that is an unsafe warning.
void note_fallen(const machine::Model& model, std::size_t first_guy, const study::PutUpMoment& stand, Result& r);

/// Names the guys that have another tension there than they are put up with: they are not in balance.
std::optional<std::string> unbalanced_guys(const machine::Machine& machine, const study::PutUpMoment& stand,
                                           const Display& display);

/// What a deck's `install:` and given tensions mean, for the assumptions.
std::vector<std::string> tension_assumptions(const machine::Machine& machine, const Display& display);

/// Of ropes on which carriages ride and whose tension is held where nothing of the deck can hold it: neither a drum
/// nor a take-up nor a body that may move is at that end.
std::vector<std::string> held_tension_warnings(const machine::Machine& machine, const machine::Model& model,
                                               const Display& display);

}  // namespace taut::results
