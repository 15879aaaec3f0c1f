#pragma once
#include <optional>
#include <string_view>

namespace taut::catalogue {

/// How far a number of a catalogue may be trusted, best first. What each mark means stands in data/SOURCES.md.
enum class Trust {
  verified,   ///< read in a public source
  derived,    ///< computed from verified factors or from geometry
  unverified  ///< remembered or inferred: must be marked wherever it decides
};

/// "verified", "derived" or "unverified".
std::string_view to_text(Trust trust);

/// The mark of that exact name, or nothing.
std::optional<Trust> parse_trust(std::string_view text);

/// Whether `trust` is as good as `least` or better.
constexpr bool at_least(Trust trust, Trust least) { return trust <= least; }

/// The weaker of two marks: what a result that rests on both may claim.
constexpr Trust weaker(Trust a, Trust b) { return a < b ? b : a; }

}  // namespace taut::catalogue
