#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/catalogue/lookup.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

/// What a yield stress is for.
enum class SteelBasis {
  design,  ///< nominal value of EN 1993-1-1 table 3.1: constant up to 40 mm
  product  ///< minimum of the product standard, in steps of thickness
};

std::string_view to_text(SteelBasis basis);  ///< "design", "product"

/// Strengths of one range of thickness: over < t <= to. SI units.
struct SteelRange {
  double over = 0.0;      ///< m
  double to = 0.0;        ///< m
  double yield = 0.0;     ///< Pa
  double ultimate = 0.0;  ///< Pa
};

/// One steel grade of one standard on one basis.
struct SteelRow {
  std::string name;               ///< "S355", "S355H", "09G2S"
  std::vector<std::string> also;  ///< other names: "S355NL" of "S355N", "09Г2С"
  std::string standard;           ///< "EN 10025-2"
  SteelBasis basis = SteelBasis::design;
  std::vector<SteelRange> ranges;   ///< thinnest first, without gaps; at least one
  Trust trust = Trust::unverified;  ///< of the weakest range
  std::string trust_text;
};

/// "EN 10210-1 S355H": the standard and the name; with " product" for that basis. find_steel knows it.
std::string full_name(const SteelRow& steel);

/// Reads a table of steels, one line per range of thickness. Columns: name, also (names between semicolons; may be
/// empty), standard, basis (design or product), t_over_mm, t_to_mm, fy_MPa, fu_MPa, trust, and, if wanted, trust_text.
/// The lines of one steel stand together, thinnest first, each range beginning where the last one ends.
tl::expected<std::vector<SteelRow>, Diagnostics> read_steels(std::string_view csv, std::string file);

/// The built-in steels (data/steels.csv), in the file's order.
const std::vector<SteelRow>& steels();

/// The steel of that name. Case and spaces do not count; a standard before or after the name ("EN 10210-1 S355H") or a
/// basis after it ("S355 product") narrows the choice. Without a basis, design values go before those of the product
/// standard. On failure the candidates are full names.
Found<SteelRow> find_steel(std::string_view name, const std::vector<SteelRow>& table = steels());

/// Yield stress of the thinnest range, Pa: for a first estimate, while the wall is not known yet.
double yield(const SteelRow& steel);

/// Yield stress at a thickness (m), Pa; an error when the table does not reach to it.
Found<double> yield(const SteelRow& steel, double thickness);

/// The same by the steel's name.
Found<double> yield(std::string_view name, double thickness);

}  // namespace taut::catalogue
