#include "taut/results/rope_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/machine/links/rope_of.hpp"
#include "taut/results/described.hpp"

namespace taut::results {
namespace {

/// Ropes of one diameter differ by less in what they bear and weigh: grades of 1570 to 2160 MPa by 1.4, cores by 1.1.
constexpr double most_apart = 1.5;
constexpr double wire_modulus = 206e9;  ///< Pa: as stiff as its wires is no rope
constexpr double most_strain = 0.02;    ///< steel ropes break at 2 to 3 %, and yield before

bool is_used(const machine::Machine& machine, const std::string& rope) {
  const auto runs = [&](const auto& one) { return one.rope == rope; };
  return std::any_of(machine.reevings.begin(), machine.reevings.end(), runs) ||
         std::any_of(machine.guys.begin(), machine.guys.end(), runs);
}

/// What a rope is of the catalogue, by its deck or by the choice of a design.
struct OfCatalogue {
  catalogue::RopeRow row;
  std::string id;    ///< as the deck has it
  std::string mend;  ///< what to do about a value that no such rope has
};

std::optional<OfCatalogue> of_catalogue(const machine::description::Rope& rope, const ChosenRopes& chosen) {
  if (const auto own = chosen.find(rope.name); own != chosen.end()) {
    return OfCatalogue{.row = own->second, .id = own->second.id, .mend = "look at the unit"};
  }
  if (!rope.rope) return std::nullopt;
  const auto row = catalogue::find_rope(*rope.rope);
  if (!row) return std::nullopt;
  return OfCatalogue{.row = *row, .id = *rope.rope, .mend = "look at the unit, or leave 'rope' out"};
}

/// One value of the deck against that of the row.
struct Overridden {
  const char* key;
  double given, row;  ///< SI; 0: not known
  double unit;        ///< of the printed numbers, as a number in SI: 1e3 for kN
  const char* symbol;
  bool safe_below = false;
  std::string words(double value) const { return fmt::format("{:.4g} {}", value / unit, symbol); }
};

void warn_of_value(const std::string& rope, const OfCatalogue& known, const Overridden& one, Result& r) {
  if (!(one.given > 0) || !(one.row > 0)) return;
  const bool above = one.given > most_apart * one.row, below = one.given * most_apart < one.row;
  if (!above && !below) return;
  std::string words = fmt::format("rope '{}' has the {} {}; its row of the catalogue, '{}', has {}: {}", rope, one.key,
                                  one.words(one.given), known.id, one.words(one.row), known.mend);
  if (above || !one.safe_below) return warn_unsafe(r, std::move(words));
  r.warnings.push_back(std::move(words));
}

/// A new rope is softer than the bedded-in one of the tables; none is stiffer than its wires.
void warn_of_stiffness(const machine::description::Rope& rope, const OfCatalogue& known, Result& r) {
  const auto s = catalogue::stiffness_of(known.row);
  const auto first = catalogue::find_rule("modulus.first_loading");
  if (!s || !first || !first->low || !rope.stiffness || std::isinf(*rope.stiffness)) return;
  const double least = *first->low * s->low * s->area, most = wire_modulus * s->area;
  if (*rope.stiffness >= least && *rope.stiffness <= most) return;
  warn_unsafe(r,
              fmt::format("rope '{}' has the stiffness {:.4g} MN; a rope of its row of the catalogue, '{}', has {:.4g} "
                          "MN when new to {:.4g} MN, that of its wires: {}",
                          rope.name, *rope.stiffness / 1e6, known.id, least / 1e6, most / 1e6, known.mend));
}

const machine::description::Rope* described_rope(const machine::Machine& machine, const std::string& name) {
  const auto found =
      std::find_if(machine.ropes.begin(), machine.ropes.end(), [&](const auto& one) { return one.name == name; });
  return found == machine.ropes.end() ? nullptr : &*found;
}

/// The rope of a reeving or guy of the model.
const machine::description::Rope* rope_of(const machine::Machine& machine, const std::string& reeving) {
  for (const auto& one : machine.reevings) {
    if (machine::description::name_of(one) == reeving) return described_rope(machine, one.rope);
  }
  for (const auto& one : machine.guys) {
    if (one.name == reeving) return described_rope(machine, one.rope);
  }
  return nullptr;
}

}  // namespace

std::optional<catalogue::RopeStiffness> assumed_stiffness(const machine::Machine& machine, const std::string& rope) {
  const auto* own = described_rope(machine, rope);
  return own == nullptr ? std::nullopt : machine::catalogue_stiffness(*own);
}

void add_rope_stiffness(const machine::Machine& machine, Result& r) {
  for (const auto& rope : machine.ropes) {
    const auto s = machine::catalogue_stiffness(rope);
    if (!is_used(machine, rope.name) || !s) continue;
    r.values.push_back(
        make_value(named(value_kinds(), "ROPE.stiffness"), rope.name, "", s->EA, catalogue::to_text(*s)));
    if (s->trust != catalogue::Trust::unverified) continue;
    r.warnings.push_back(
        fmt::format("stiffness of rope '{}': {}; give the maker's 'stiffness' where sag or tension decide", rope.name,
                    catalogue::to_text(*s)));
  }
}

void warn_of_rope_values(const machine::Machine& machine, const ChosenRopes& chosen, Result& r) {
  for (const auto& rope : machine.ropes) {
    const auto known = of_catalogue(rope, chosen);
    if (!known || !is_used(machine, rope.name)) continue;
    const catalogue::RopeRow* row = &known->row;
    for (const Overridden& one :
         {Overridden{
              .key = "mass", .given = rope.mass.value_or(0), .row = row->mass_per_length, .unit = 1, .symbol = "kg/m"},
          Overridden{.key = "diameter",
          .given = rope.diameter.value_or(0),
          .row = row->diameter,
          .unit = 1e-3,
          .symbol = "mm"},
          Overridden{.key = "breaking force",
          .given = rope.breaking_force.value_or(0),
          .row = row->breaking_force,
          .unit = 1e3,
          .symbol = "kN",
          .safe_below = true}}) {
      warn_of_value(rope.name, *known, one, r);
    }
    warn_of_stiffness(rope, *known, r);
  }
}

void warn_of_strain(const machine::Machine& machine, const ChosenRopes& chosen, const machine::Model& model,
                    Result& r) {
  for (const machine::Reeving& one : model.reevings) {
    const Value* T = r.find_value(one.name + ".T_max");
    const auto* rope = rope_of(machine, one.name);
    if (T == nullptr || rope == nullptr || !(T->value > most_strain * one.stiffness)) continue;
    std::string words = fmt::format(
        "rope '{}': its largest tension, {:.4g} kN, strains it by {:.3g} % at a stiffness of {:.4g} MN: no steel rope "
        "bears that; look at the unit of its 'stiffness'",
        one.name, T->value / 1e3, 100 * T->value / one.stiffness, one.stiffness / 1e6);
    of_catalogue(*rope, chosen) ? warn_unsafe(r, std::move(words)) : r.warnings.push_back(std::move(words));
  }
}

}  // namespace taut::results
