#pragma once
#include <functional>
#include <string>
#include <tl/expected.hpp>

namespace taut::web {

struct ServeOptions {
  std::string folder = ".";  ///< whose decks the page opens and saves
  int port = 0;              ///< 0: one that is free
  std::string page;          ///< folder of the page; empty: that of the installation or the source tree
};

/// Why there is no server.
struct ServeError {
  bool of_files = false;  ///< the folder or the page can't be read; else the port is not to be had
  std::string message = {};
};

/// The page of taut in a browser with this program as its engine, at 127.0.0.1 alone. `ready` is told the address, with
/// the token that every request needs; `goes_on` is asked a few times a second and ends it, and all jobs, with false.
tl::expected<void, ServeError> serve(const ServeOptions& options,
                                     const std::function<void(const std::string& address)>& ready,
                                     const std::function<bool()>& goes_on);

}  // namespace taut::web
