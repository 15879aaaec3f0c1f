#pragma once
#include <functional>
#include <string>
#include <tl/expected.hpp>

namespace taut::io {

/// Why a file can't be read. `missing`: there is none of that name.
struct Unreadable {
  std::string message;
  bool missing = false;
};

/// Gives the text of a file that a deck names, by its path: the folder of the deck's name and what the deck says.
using FileReader = std::function<tl::expected<std::string, Unreadable>(const std::string& path)>;

}  // namespace taut::io
