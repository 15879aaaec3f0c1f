#include "taut/catalogue/trust.hpp"

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

}  // namespace taut::catalogue
