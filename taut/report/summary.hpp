#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"

namespace taut::report {

/// Most rows and warnings of a summary: page 1 of the report and the terminal.
constexpr std::size_t most_summary_rows = 10;
constexpr std::size_t most_summary_warnings = 4;
constexpr int longest_summary_warning = 160;
constexpr std::size_t shown_hash = 16;  ///< digits; the foot of each page and result.json have all of them

/// The worst check of each part, worst first: one that fails before one that is refused before the largest utilisation.
/// Where that one is no limit of its part, as the ratio of a sheave, the worst limit stands there too: the verdict
/// names it. A check that names no part stands for itself.
std::vector<const Check*> worst_by_part(const Result& r);

/// The lines of the answer that a summary shows: utilisations stand in the table of checks.
std::vector<Answer> answers_beside_checks(const Result& r);

/// What a summary says of a check of such a part (lacks_limit): the check has its limit.
inline constexpr const char* no_limit_of_part = "part has no strength limit";

/// Whether the part of a check has no limit that counts: breaking force and yield alone judge nothing.
bool lacks_limit(const Check& c, const Result& r);

/// The name of a check without that of its part before it: "T_max" of "skyline.T_max".
std::string name_below_part(const Check& c);

/// The same as words: "safety factor" of "skyline.safety_factor", "payload T_max" of "skyline.payload_T_max".
std::string words_below_part(const Check& c);

/// All warnings in the order in which a summary shows them: what makes the answer unsafe first.
std::vector<std::string> warnings_by_weight(const Result& r);

/// "Hinterwald · no. 12 · calculated by A. Meier · checked by B. Keller · 2026-11-24 · revision B": what the deck gives
/// of its project; empty when it gives nothing.
std::string project_line(const Project& p);

}  // namespace taut::report
