#pragma once
#include <string>

namespace taut::app {

/// A key as a deck writes it.
struct ExampleLine {
  std::string text;  ///< "length: 382 m"
  std::string deck;  ///< "three_span_skyline.yaml"; empty where the line was made from the description
};

struct Term;

/// A line with this key: of the first example deck built into the program that has it, else made from its choices,
/// unit, range and default. Without a text for a key that only holds other keys and that no example has.
ExampleLine example_line(const Term& key);

}  // namespace taut::app
