#include "taut/catalogue/trust.hpp"

#include <fmt/format.h>

namespace taut::catalogue {

std::string_view to_text(Trust trust) {
  switch (trust) {
    case Trust::verified:
      return "verified";
    case Trust::derived:
      return "derived";
    case Trust::unverified:
      break;
  }
  return "unverified";
}

std::optional<Trust> parse_trust(std::string_view text) {
  for (const Trust trust : {Trust::verified, Trust::derived, Trust::unverified}) {
    if (text == to_text(trust)) return trust;
  }
  return std::nullopt;
}

std::string trust_words(Trust trust, const std::string& why) {
  if (trust != Trust::unverified) return std::string(to_text(trust));
  return fmt::format("UNVERIFIED: {}", why.empty() ? "its row of the catalogue says so" : why);
}

}  // namespace taut::catalogue
