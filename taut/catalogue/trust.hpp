#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace taut::catalogue {

/// Trust in a number of a catalogue, best first. data/SOURCES.md defines the marks.
enum class Trust {
  verified,   ///< read in a public source
  derived,    ///< computed from verified factors or from geometry
  unverified  ///< recalled or inferred; the report marks it wherever it decides
};

/// "verified", "derived" or "unverified".
std::string_view to_text(Trust trust);

/// The mark of exactly that name; empty for any other text.
std::optional<Trust> parse_trust(std::string_view text);

/// The trust in a number from a row of a catalogue, as a check has it: "verified", "derived", or "UNVERIFIED: " and
/// why.
std::string trust_words(Trust trust, const std::string& why);

template <class Row>
std::string trust_words(const Row& row) {
  return trust_words(row.trust, row.trust_text);
}

/// Whether `trust` is as good as `least` or better.
constexpr bool at_least(Trust trust, Trust least) { return trust <= least; }

/// The lower of two marks: the trust in a result that depends on both.
constexpr Trust weaker(Trust a, Trust b) { return a < b ? b : a; }

}  // namespace taut::catalogue
