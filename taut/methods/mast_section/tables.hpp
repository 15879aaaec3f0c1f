#pragma once
#include <string>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/methods/mast_section/sizing.hpp"

/// The tables of the result, each of one list of quantities.
namespace taut::mast_section {

/// A section of the catalogue for a mast of that height.
struct SectionLine {
  Assessment of;
  double height = 0;  ///< of the mast, m
  std::string use;    ///< "given", "lightest CHS that passes"
};

/// Height of the mast: of the higher block, m.
double height_of(const Input& in);

/// `governing`: the values of the whole result.
Table positions_table(const std::vector<Position>& positions, const Output& governing);
/// What a section must carry, case by case.
Table load_cases_table(const Input& in, const std::vector<ClampForces>& forces);
Table sections_table(const std::vector<SectionLine>& lines);

/// These tables as described.
std::vector<TableWords> table_words();

}  // namespace taut::mast_section
