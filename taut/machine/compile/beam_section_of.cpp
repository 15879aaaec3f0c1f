#include <fmt/format.h>

#include <optional>

#include "taut/base/array.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/machine/links/beam_links.hpp"

namespace taut::machine {

using structure::Outline;

namespace {

constexpr double steel_density = 7850;  // kg/m3, EN 1991-1-1
constexpr double G_by_E = 1 / 2.6;      // nu = 0.3

/// Figures that a section of the catalogue has already.
void refuse_figures(const description::Beam& given, const std::string& path, std::vector<Complaint>& complaints) {
  const auto refuse = [&](const auto& value, const char* key) {
    if (!value) return;
    complaints.push_back(
        {fmt::format("{}.{}", path, key), "belongs to a section by figures; this one has a 'section'"});
  };
  refuse(given.round, "round");
  refuse(given.I, "I");
  refuse(given.I_weak, "I_weak");
  refuse(given.J, "J");
  refuse(given.W_t, "W_t");
  refuse(given.W, "W");
  refuse(given.W_weak, "W_weak");
}

/// Figures that a round section has by its others.
void refuse_of_round(const description::Beam& given, const std::string& path, std::vector<Complaint>& complaints) {
  const auto refuse = [&](const std::optional<double>& value, const char* key, const char* words) {
    if (value) complaints.push_back({fmt::format("{}.{}", path, key), words});
  };
  refuse(given.I_weak, "I_weak", "a round section has one 'I': leave it out, or leave 'round' out");
  refuse(given.W_weak, "W_weak", "a round section has one 'W': leave it out, or leave 'round' out");
  refuse(given.J, "J", "of a round section it is 2 I: leave it out, or leave 'round' out");
  refuse(given.W_t, "W_t", "of a round section it is 2 W: leave it out, or leave 'round' out");
}

void check_steel(const description::Beam& given, const std::optional<double>& wall, const std::string& path,
                 std::vector<Complaint>& complaints) {
  if (!given.steel) return;
  const auto steel = catalogue::find_steel(*given.steel);
  if (!steel) {
    complaints.push_back({path + ".steel", to_text(steel.error())});
    return;
  }
  if (!wall) return;
  const auto yield = catalogue::yield(*steel, *wall);
  if (!yield) complaints.push_back({path + ".steel", to_text(yield.error())});
}

}  // namespace

structure::BeamSection section_of(const description::Beam& given, double gravity, std::vector<Complaint>& complaints) {
  const std::string path = fmt::format("beams.{}", given.name);
  structure::BeamSection b;
  if (given.section) {
    refuse_figures(given, path, complaints);
    const auto row = catalogue::find_section(*given.section);
    if (!row) {
      complaints.push_back({path + ".section", to_text(row.error())});
      check_steel(given, {}, path, complaints);
      return structure::tube_section(1, 0.1);  // never used: the deck has a mistake
    }
    b = structure::beam_section(*row, {.E = given.E, .G = given.E * G_by_E});
    b.weight = given.mass.value_or(row->mass_per_length) * gravity;
    check_steel(given, row->thickness, path, complaints);
    return b;
  }
  if (!given.I) complaints.push_back({path, "a section by figures needs 'I' beside 'A'"});
  if (given.round) refuse_of_round(given, path, complaints);
  if (given.steel && !given.W) complaints.push_back({path + ".steel", "the stress needs 'W', the section modulus"});
  check_steel(given, {}, path, complaints);
  const double I = given.I.value_or(1), weak = given.I_weak.value_or(I);
  b.area = given.A.value_or(1);
  b.EA = given.E * b.area;
  b.EI_x = given.E * I;
  b.EI_y = given.E * weak;
  b.GJ = given.E * G_by_E * given.J.value_or(I + weak);
  b.W_x = given.W.value_or(0);
  b.W_y = given.W_weak.value_or(b.W_x);
  b.weight = given.mass.value_or(b.area * steel_density) * gravity;
  const bool stands = given.strong || given.I_weak || given.W_weak;
  b.outline = given.round ? Outline::tube : stands ? Outline::box : Outline::unsaid;
  b.W_t = given.round ? 2 * b.W_x : given.W_t.value_or(0);
  if (given.round) b.shear_x = b.shear_y = structure::round_shear(b.area);
  return b;
}

}  // namespace taut::machine
