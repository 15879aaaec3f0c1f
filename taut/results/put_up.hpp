#pragma once
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/study/put_up.hpp"

namespace taut::app {

struct CheckedParts;

/// Puts up the ropes of a machine that have `install:`; `model` keeps their lengths.
Outcome put_up_lines(model::Model& model, std::vector<analysis::PutUpLine>& lines);

/// The state of a line as it is put up: "skyline as put up", or with what hangs on it meanwhile.
std::string put_up_words(const model::Model& model, const analysis::PutUpLine& line);

/// Their table `put_up`, and of each NAME.base_tension and NAME.cut_length.
void add_put_up(const model::Model& model, const std::vector<analysis::PutUpLine>& lines, Result& r);

/// Shows their states to the checks.
void show_put_up(const model::Model& model, const std::vector<analysis::PutUpLine>& lines, CheckedParts& checked);

/// What a deck's `install:` and given tensions mean, for the assumptions.
std::vector<std::string> tension_assumptions(const model::Machine& machine);

/// Of ropes on which carriages ride and whose tension is held where nothing of the deck can hold it: neither a drum
/// nor a take-up nor a body that may move is at that end.
std::vector<std::string> held_tension_warnings(const model::Machine& machine, const model::Model& model);

}  // namespace taut::app
