#pragma once
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace taut::app {

/// Filters of `taut list` as the user wrote them; a quantity is text with its unit ("150 kN"). Empty ones don't count.
struct ListFilter {
  std::string construction;         ///< ropes: "6x36"
  std::string core;                 ///< ropes: "FC", "IWRC", "WSC"
  std::string grade;                ///< ropes: "1960 MPa"
  std::string min_breaking_force;   ///< ropes
  std::string min_diameter;         ///< ropes
  std::string max_diameter;         ///< ropes
  std::string min_area;             ///< ropes and sections
  std::string shape;                ///< sections: "CHS", "SHS", "RHS"
  std::string forming;              ///< sections: "hot", "cold", "seamless", "welded"
  std::string max_height;           ///< sections: the larger outer side
  std::string min_section_modulus;  ///< sections: elastic, about the strong axis
  std::string standard;             ///< beginning of its name: "EN", "GOST 2688"
  std::string name;                 ///< steels, rules, carriages, yarders, units: part of the name
  bool verified_only = false;       ///< rows marked verified
};

/// What list_text lists.
std::vector<std::string> list_names();

/// An aligned text table of what matches, one line each with its trust, smallest or lightest first, and a last line
/// that counts. `what`: one of list_names. The error says which filter can't be
/// read or is not for that list, or what the lists are.
tl::expected<std::string, std::string> list_text(const std::string& what, const ListFilter& filter);

/// Rows of text as columns two spaces apart; the first row is the head. Numbers (by their look) stand right.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace taut::app
