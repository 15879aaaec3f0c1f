#pragma once
#include <optional>
#include <string>
#include <string_view>

/// Who may ask `taut serve`. Every page of the web that is open in a browser can send requests to a server on the same
/// machine, and so can every other user of the machine: only who has read the token is answered.
namespace taut::web {

/// A new secret: 32 bytes of the system's random source in hexadecimal digits.
std::string new_token();

/// Compares in a time that does not tell how far two texts agree.
bool same_secret(std::string_view a, std::string_view b);

/// What a request says of its origin.
struct Caller {
  std::string host;    ///< header Host
  std::string origin;  ///< header Origin; empty: there is none
  std::string token;
};

/// What a server at a port of the loopback device asks of a caller.
struct Access {
  int port = 0;
  std::string token;
};

/// Why a caller is refused; empty: it is not.
///   The host must be 127.0.0.1 or localhost with our port: else the name of another site stands for this machine, and
///   the browser takes us for that site. An origin, which browsers send, must be our own. The token must be right.
std::optional<std::string> refused(const Caller& caller, const Access& access);

/// Headers of every response: nothing is loaded from elsewhere, no site frames the page, no address with its token goes
/// anywhere. `nonce`: that of the styles of the page, letters, digits, '-' and '_'; others are dropped.
std::string policy(std::string_view nonce);

}  // namespace taut::web
