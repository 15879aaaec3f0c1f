#include "taut/catalogue/section.hpp"

#include <fmt/format.h>

#include <array>

#include "taut/base/expects.hpp"
#include "taut/catalogue/csv.hpp"
#include "taut/catalogue/embedded/sections_csv.hpp"
#include "taut/catalogue/lookup.hpp"

namespace taut::catalogue {
namespace {

constexpr double table_rounding = 1.001;
constexpr std::array shapes{SectionShape::chs, SectionShape::shs, SectionShape::rhs};
constexpr std::array formings{Forming::hot, Forming::cold, Forming::seamless, Forming::welded};

template <class Kind, std::size_t n>
std::optional<Kind> parse_kind(const std::array<Kind, n>& kinds, std::string_view text) {
  for (const Kind kind : kinds) {
    if (normalised(to_text(kind)) == normalised(text)) return kind;
  }
  return std::nullopt;
}

void check_plausible(CsvReader& csv, const SectionRow& row) {
  if (row.width > row.height) csv.fail("B_mm", "B is above H: the larger side is H");
  if (2.0 * row.thickness > row.width) csv.fail("t_mm", "two walls are thicker than B");
  if (row.area > row.height * row.width) csv.fail("A_mm2", "the area is above H x B");
  if (row.W_el_y > table_rounding * row.W_pl_y) csv.fail("Wely_mm3", "the elastic modulus is above the plastic one");
  if (row.W_el_z > table_rounding * row.W_pl_z) csv.fail("Welz_mm3", "the elastic modulus is above the plastic one");
}

SectionRow read_row(CsvReader& csv) {
  SectionRow row;
  row.name = csv.unique("name");
  row.standard = csv.required_text("standard");
  const auto shape = parse_shape(csv.text("shape"));
  if (!shape) csv.fail("shape", fmt::format("shape {} is not CHS, SHS or RHS", in_quotes(csv.text("shape"))));
  row.shape = shape.value_or(SectionShape::chs);
  const auto forming = parse_forming(csv.text("forming"));
  if (!forming) {
    csv.fail("forming", fmt::format("forming {} is not hot, cold, seamless or welded", in_quotes(csv.text("forming"))));
  }
  row.forming = forming.value_or(Forming::hot);
  row.height = csv.positive("H_mm");
  row.width = csv.positive("B_mm");
  row.thickness = csv.positive("t_mm");
  row.outer_radius = csv.not_negative("r_o_mm");
  row.inner_radius = csv.not_negative("r_i_mm");
  row.area = csv.positive("A_mm2");
  row.I_y = csv.positive("Iy_mm4");
  row.W_el_y = csv.positive("Wely_mm3");
  row.W_pl_y = csv.positive("Wply_mm3");
  row.i_y = csv.positive("iy_mm");
  row.I_z = csv.positive("Iz_mm4");
  row.W_el_z = csv.positive("Welz_mm3");
  row.W_pl_z = csv.positive("Wplz_mm3");
  row.i_z = csv.positive("iz_mm");
  row.I_t = csv.positive("It_mm4");
  row.mass_per_length = csv.positive("mass_kg_per_m");
  row.trust = csv.trust("trust");
  row.trust_text = csv.text("trust_text");
  return row;
}

}  // namespace

std::string_view to_text(SectionShape shape) {
  switch (shape) {
    case SectionShape::chs:
      return "CHS";
    case SectionShape::shs:
      return "SHS";
    case SectionShape::rhs:
      break;
  }
  return "RHS";
}

std::string_view to_text(Forming forming) {
  switch (forming) {
    case Forming::hot:
      return "hot";
    case Forming::cold:
      return "cold";
    case Forming::seamless:
      return "seamless";
    case Forming::welded:
      break;
  }
  return "welded";
}

std::optional<SectionShape> parse_shape(std::string_view text) { return parse_kind(shapes, text); }
std::optional<Forming> parse_forming(std::string_view text) { return parse_kind(formings, text); }

tl::expected<std::vector<SectionRow>, Diagnostics> read_sections(std::string_view csv_text, std::string file) {
  CsvReader csv(csv_text, std::move(file), {{.name = "name"},     {.name = "standard"},
                                            {.name = "shape"},    {.name = "forming"},
                                            {.name = "H_mm"},     {.name = "B_mm"},
                                            {.name = "t_mm"},     {.name = "r_o_mm"},
                                            {.name = "r_i_mm"},   {.name = "A_mm2"},
                                            {.name = "Iy_mm4"},   {.name = "Wely_mm3"},
                                            {.name = "Wply_mm3"}, {.name = "iy_mm"},
                                            {.name = "Iz_mm4"},   {.name = "Welz_mm3"},
                                            {.name = "Wplz_mm3"}, {.name = "iz_mm"},
                                            {.name = "It_mm4"},   {.name = "mass_kg_per_m"},
                                            {.name = "trust"},    {.name = "trust_text", .required = false}});
  std::vector<SectionRow> rows;
  std::size_t mistakes = 0;
  while (csv.next()) {
    SectionRow row = read_row(csv);
    if (csv.mistakes() == mistakes) check_plausible(csv, row);
    mistakes = csv.mistakes();
    rows.push_back(std::move(row));
  }
  if (csv.failed()) return tl::unexpected(csv.take_diagnostics());
  return rows;
}

const std::vector<SectionRow>& sections() {
  static const std::vector<SectionRow> rows = [] {
    auto read = read_sections(embedded::sections_csv, "data/sections/sections.csv");
    expects(read.has_value(), read ? "" : to_text(read.error()));
    return std::move(*read);
  }();
  return rows;
}

}  // namespace taut::catalogue
