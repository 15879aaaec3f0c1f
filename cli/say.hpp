#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace taut::cli {

/// Says something on standard error. Where that is closed or full it is not said: no reason to end the program.
template <class... Args>
void say(fmt::format_string<Args...> words, Args&&... args) {
  const std::string text = fmt::format(words, std::forward<Args>(args)...);
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

}  // namespace taut::cli
