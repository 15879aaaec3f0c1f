#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/study/transient.hpp"
#include "taut/units/display.hpp"

namespace taut::results {

/// The series `time` (t and every observed quantity), the tables `events`, `envelope`, `energy`, `dynamic` (peak over
/// static by rope), the values NAME_min, NAME_max, NAME_end and ROPE.dynamic_factor, what the numbers rest on, and
/// warnings. All names end as the run does. `judged`: whether it has checks and its warnings can be unsafe.
void add_transient_tables(const study::TransientRun& run, const Display& display, bool judged, Result& r);

/// A column of what is observed.
QuantityWords observed_words(const std::string& name, const Unit& unit);

/// The columns of the series `time` as described, and those of the table `energy`.
std::vector<QuantityWords> time_words();
std::vector<QuantityWords> energy_words();

/// Frames' times.
std::vector<double> times_of(const study::TransientRun& run);

}  // namespace taut::results
