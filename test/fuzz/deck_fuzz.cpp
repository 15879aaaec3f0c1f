// Any text as a deck: it is read, or reported what is wrong, and never throws, leaks or takes long.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "taut/io/deck/deck.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/sample_test.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // no file is opened: an include would make the outcome depend on the disk
  if (text.find("include") != std::string_view::npos) return 0;
  // what follows the last NUL is an override
  const std::size_t split = text.rfind('\0');
  std::vector<std::string> set;
  if (split != std::string_view::npos) set.emplace_back(text.substr(split + 1));
  taut::Diagnostics mistakes;
  const auto deck = taut::io::read_deck(text.substr(0, split), "deck.yaml", set, {"sample"}, mistakes);
  if (!deck) {
    if (mistakes.empty()) std::abort();
    return 0;
  }
  taut::io::Sample sample;
  const bool good = taut::io::read(deck->input, taut::io::Sample::describe(), &sample, "sample", mistakes);
  if (!good && mistakes.empty()) std::abort();
  taut::io::place(deck->input, {{.path = "cases[1].falls", .message = "x"}, {.path = "rope.diameter", .message = "y"}},
                  mistakes);
  for (const taut::Diagnostic& d : mistakes) {
    if (d.place.line < 1 || d.place.column < 1 || d.message.empty()) std::abort();
  }
  if (!mistakes.empty() && taut::to_text(mistakes).empty()) std::abort();
  return 0;
}
