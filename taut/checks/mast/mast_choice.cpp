#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/calc/none.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/checks/described.hpp"
#include "taut/checks/mast/mast_checks.hpp"

namespace taut::checks {
namespace {

using catalogue::SectionShape;

constexpr std::size_t said_of_each_shape = 3;

std::vector<SectionShape> shapes_of(const SectionChoice& choice) {
  if (choice.shape) return {*choice.shape};
  return {SectionShape::chs, SectionShape::shs, SectionShape::rhs};
}

const char* mast_governing(const structure::MastUse& u) {
  const double most = u.utilisation();
  if (!u.refused.empty()) return "class 4";
  if (u.stress_use.value == most) return "allowable stress";
  if (u.section.value == most) return "section";
  if (u.member.value == most) return "member";
  if (u.flexural.value == most) return "buckling";
  return u.torsion.value == most ? "torsion" : "shear";
}

/// A section that passes, of a mast of that height.
struct SizedRow {
  const std::string& mast;
  const structure::SizedMast& one;
  double height;  ///< m
};

const Quantities<SizedRow>& sized_quantities() {
  using Row = SizedRow;
  static const Quantities<Row> all = {
      {"mast", "", si::one, "the mast", [](const Row& r) { return r.mast; }},
      {"section", "", si::one, "section of the catalogue that passes", [](const Row& r) { return r.one.section.name; }},
      {"mass_per_length", "m", si::kg_per_m, "its mass per metre",
       [](const Row& r) { return r.one.section.mass_per_length; }},
      {"mass", "", si::kg, "mass of the mast in it",
       [](const Row& r) { return r.one.section.mass_per_length * r.height; }},
      {"utilisation", "", si::one, "largest utilisation by the routes asked for",
       [](const Row& r) { return r.one.use.refused.empty() ? r.one.use.utilisation() : none; }},
      {"governs", "", si::one, "the check of that utilisation",
       [](const Row& r) { return std::string(mast_governing(r.one.use)); }},
      {"trust", "", si::one, "trust in the section's row of the catalogue",
       [](const Row& r) { return std::string(to_text(r.one.section.trust)); }}};
  return all;
}

double height_of(const MastReport& report) {
  double h = 0;
  for (const auto& c : report.loaded.cases) {
    for (const auto& s : c.stations) h = std::max(h, s.height);
  }
  return h > 0 ? h : std::nan("");
}

}  // namespace

TableWords mast_choice_words() {
  return {.name = "mast_sections",
          .rows = "the lightest sections of each shape that pass (`choose`)",
          .columns = words_of(sized_quantities())};
}

void add_mast_choice(const MastCheckRequest& request, const MastReport& report, Result& r) {
  if (!request.choose) return;
  if (!report.in_section) {
    r.warnings.push_back(fmt::format("{}: 'choose' is for a mast of one section and leaves this one out", report.name));
    return;
  }
  const double height = height_of(report);
  std::optional<structure::SizedMast> best;
  for (const SectionShape shape : shapes_of(*request.choose)) {
    catalogue::SectionFilter filter = filter_of(*request.choose);
    filter.shape = shape;
    const auto found = structure::size_mast(catalogue::sections_by_mass(filter), report.in_section, said_of_each_shape);
    for (const auto& one : found.passing) {
      add_line(r, "mast_sections", "Lightest sections of the catalogue that pass by every route asked for",
               sized_quantities(), SizedRow{.mast = report.name, .one = one, .height = height});
    }
    if (!found.passing.empty() && (!best || found.passing[0].section.mass_per_length < best->section.mass_per_length)) {
      best = found.passing[0];
    }
    if (found.passing.empty() && found.nearest) {
      r.warnings.push_back(
          fmt::format("{}: no {} of the catalogue that 'choose' lets through passes; nearest is {} ({})", report.name,
                      to_text(shape), found.nearest->section.name, mast_governing(found.nearest->use)));
    }
  }
  if (!best) return;
  r.values.push_back(
      make_value(named(value_kinds(), "MAST.chosen_mass"), report.name, "", best->section.mass_per_length,
                 fmt::format("mass of {}, the lightest that passes, of {}", best->section.name, report.name)));
  r.assumptions.push_back(fmt::format(
      "{}: {} ({}) is the lightest section of the catalogue that passes; chosen under the forces found here: "
      "run the deck with it.",
      report.name, best->section.name, report.display.brief(best->section.mass_per_length, si::kg_per_m)));
}

}  // namespace taut::checks
