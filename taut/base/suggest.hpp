#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// Number of single-character edits (insert, delete, replace, swap of neighbours) that turn `a` into `b`.
/// Restricted Damerau-Levenshtein distance, O(|a| |b|).
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, or an empty text when none is near enough to be what was meant
/// (more than a third of the longer word differs). Case does not count. Ties go to the earlier candidate.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `; did you mean 'x'?` or an empty text.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace taut
