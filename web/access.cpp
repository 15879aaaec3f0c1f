#include "web/access.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <random>

namespace taut::web {

std::string new_token() {
  std::random_device source;  // the system's, not a generator with a seed
  std::string token;
  for (int i = 0; i < 8; ++i) token += fmt::format("{:08x}", source() & 0xFFFFFFFFU);
  return token;
}

bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  volatile unsigned differ = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    differ = differ | (static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  }
  return differ == 0;
}

std::optional<std::string> refused(const Caller& caller, const Access& access) {
  const bool by_number = caller.host == fmt::format("127.0.0.1:{}", access.port);
  const bool by_name = caller.host == fmt::format("localhost:{}", access.port);
  if (!by_number && !by_name) return "the name of another host";
  if (!caller.origin.empty() && caller.origin != "http://" + caller.host) return "a page of another origin";
  if (access.token.empty() || !same_secret(caller.token, access.token)) {
    return "the token is missing or wrong: open the address that taut serve has printed";
  }
  return std::nullopt;
}

std::string policy(std::string_view nonce) {
  std::string plain(nonce);
  std::erase_if(plain, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_'; });
  const std::string style = plain.empty() ? "'self'" : fmt::format("'self' 'nonce-{}'", plain);
  return fmt::format(
      "default-src 'none'; script-src 'self'; style-src {}; img-src data: blob:; font-src data:; connect-src 'self'; "
      "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
      style);
}

}  // namespace taut::web
