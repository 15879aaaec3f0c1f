#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

enum class SectionShape { chs, shs, rhs };           ///< circular, square, rectangular hollow section
enum class Forming { hot, cold, seamless, welded };  ///< hot-finished, cold-formed; GOST: seamless, welded

std::string_view to_text(SectionShape shape);                    ///< "CHS", "SHS", "RHS"
std::string_view to_text(Forming forming);                       ///< "hot", "cold", "seamless", "welded"
std::optional<SectionShape> parse_shape(std::string_view text);  ///< any case
std::optional<Forming> parse_forming(std::string_view text);     ///< any case

/// One hollow section, nominal dimensions, SI units. y is the strong axis, z the weak one; for CHS and SHS both are
/// equal.
struct SectionRow {
  std::string name;      ///< "CHS 508x16", "RHS-C 200x100x8" (C: cold-formed), "CHS 219x8 GOST 8732"
  std::string standard;  ///< "EN 10210-2"
  SectionShape shape = SectionShape::chs;
  Forming forming = Forming::hot;
  double height = 0.0;                ///< H, outer, m; diameter of a CHS
  double width = 0.0;                 ///< B <= H, outer, m; diameter of a CHS
  double thickness = 0.0;             ///< t, m
  double outer_radius = 0.0;          ///< of the corner, m; half the diameter of a CHS
  double inner_radius = 0.0;          ///< of the corner, m
  double area = 0.0;                  ///< m2
  double I_y = 0.0, I_z = 0.0;        ///< second moment of area, m4
  double W_el_y = 0.0, W_el_z = 0.0;  ///< elastic modulus, m3
  double W_pl_y = 0.0, W_pl_z = 0.0;  ///< plastic modulus, m3
  double i_y = 0.0, i_z = 0.0;        ///< radius of gyration, m
  double I_t = 0.0;                   ///< torsion constant, m4
  double mass_per_length = 0.0;       ///< kg/m
  Trust trust = Trust::unverified;
  std::string trust_text;
};

/// Reads a table of sections. Columns: name, standard, shape, forming, H_mm, B_mm, t_mm, r_o_mm, r_i_mm, A_mm2, Iy_mm4,
/// Wely_mm3, Wply_mm3, iy_mm, Iz_mm4, Welz_mm3, Wplz_mm3, iz_mm, It_mm4, mass_kg_per_m, trust, and optionally
/// trust_text.
///
/// Returns the rows, or all mistakes. Besides the checks of CsvReader it refuses B > H, 2 t > B, an area above H B, and
/// an elastic modulus above the plastic one.
tl::expected<std::vector<SectionRow>, Diagnostics> read_sections(std::string_view csv, std::string file);

/// The built-in sections (data/sections/sections.csv), in the file's order.
const std::vector<SectionRow>& sections();

}  // namespace taut::catalogue
