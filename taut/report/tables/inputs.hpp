#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/report/text/quantity.hpp"

namespace taut::report {

/// Where an input stands in its deck: "machine.points.stump.at" is `at` of `stump` in the list `machine.points`,
/// "cases[1].falls" is `falls` of number 2 in `cases`. Nothing in `list`: it belongs to no list.
struct InputPlace {
  std::string list;
  std::string record;
  std::string field;
};
InputPlace place_of(std::string_view key);

/// The places of all inputs, in their order. A name may have dots of its own ("s1.rear"): where nothing stands directly
/// below a name, the next word of the key belongs to it.
std::vector<InputPlace> places_of(const std::vector<Given>& given);

struct InputColumn {
  std::string name;   ///< the deck's key, "diameter"; the components of a place are x, y, z
  std::string words;  ///< its meaning; may be empty
  std::string unit;   ///< for print; may be empty
  bool numbers = false;
};
struct InputCell {
  std::string text;  ///< in display units, without the unit of its column
  bool chosen = false;
};
/// The parts of one kind: a row for each, a column for what most of them give. What only few of them give, and what has
/// keys of its own, stands in the last column in the deck's spelling: "friction: 0.1, install: {tension: 25 kN}".
struct InputTable {
  std::string list;   ///< "machine.points"
  std::string title;  ///< "Points"
  std::vector<InputColumn> columns;
  std::vector<std::vector<InputCell>> rows;
};

/// A table for each kind of part, in the deck's order, of what is given; a part without such is named all the same.
std::vector<InputTable> input_tables(const std::vector<Given>& given, const Display& display);

/// The inputs that belong to no list, as given or, with `defaults`, by default.
std::vector<const Given*> single_inputs(const std::vector<Given>& given, bool defaults);

/// A default and the parts that it applies to.
struct InputDefault {
  const Given* given = nullptr;  ///< of the first part
  std::string key;               ///< "machine.sheaves.*.drag"
  std::string parts;             ///< "guide, block"; empty for one that belongs to no list
};
std::vector<InputDefault> input_defaults(const std::vector<Given>& given, const Display& display);

/// Most numbers of one input that are shown.
inline constexpr std::size_t most_numbers_of_input = 40;

/// The value of an input with its unit: "400 mm", "[0, 0, 4] m"; of a longer list than `most_numbers_of_input` their
/// count, the first and the last one, and a fingerprint of them all.
std::string input_text(const Given& g, const Display& display);

}  // namespace taut::report
