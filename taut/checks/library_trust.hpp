#pragma once
#include <fmt/format.h>

#include <string>

#include "taut/catalogue/trust.hpp"

namespace taut::checks {

/// The trust of a limit from a row of a catalogue, as a check has it: "verified", or "UNVERIFIED: " and why.
inline std::string library_trust(catalogue::Trust trust, const std::string& text) {
  if (trust != catalogue::Trust::unverified) return std::string(catalogue::to_text(trust));
  return fmt::format("UNVERIFIED: {}", text.empty() ? "its row of the catalogue says so" : text);
}

}  // namespace taut::checks
