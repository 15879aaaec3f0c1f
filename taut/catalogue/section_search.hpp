#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/catalogue/lookup.hpp"
#include "taut/catalogue/section.hpp"

namespace taut::catalogue {

/// Which sections are wanted. What is left empty does not count. SI units.
struct SectionFilter {
  std::optional<SectionShape> shape;
  std::optional<Forming> forming;
  std::string standard;              ///< the beginning of its name: "EN", "EN 10210", "GOST"; case, spaces don't count
  std::optional<double> min_area;    ///< m2
  std::optional<double> min_I_y;     ///< m4
  std::optional<double> min_W_el_y;  ///< m3
  std::optional<double> min_W_pl_y;  ///< m3
  std::optional<double> min_thickness;  ///< m
  std::optional<double> min_height;     ///< of the larger outer side, m
  std::optional<double> max_height;     ///< of the same, m
  Trust min_trust = Trust::unverified;
};

bool matches(const SectionRow& row, const SectionFilter& filter);

/// The sections of `table` that match, in the table's order.
std::vector<SectionRow> select_sections(const SectionFilter& filter, const std::vector<SectionRow>& table = sections());

/// The sections that match, lightest first: candidates for "the smallest that passes", where the check is the caller's.
/// Equal ones follow in the order of height, trust (better first), name: the order of `table` does not count.
std::vector<SectionRow> sections_by_mass(const SectionFilter& filter,
                                         const std::vector<SectionRow>& table = sections());

/// The section that `name` means: "CHS 508x16", "chs508×16", "508x16", "RHS-C 100x200x8", "SHS 100x5" (a square needs
/// its side once only), "CHS 219x8 GOST 8732". Case, spaces and the order of H and B do not count; shape, C and
/// standard may be left out where one section is left. A name that a row bears in full (CHS 508x16: the hot-finished
/// one) goes before everything else. On failure: names that come near.
Found<SectionRow> find_section(std::string_view name, const std::vector<SectionRow>& table = sections());

}  // namespace taut::catalogue
