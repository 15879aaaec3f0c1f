#include "taut/results/rope_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "taut/catalogue/rope_values.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/machine/links/rope_of.hpp"
#include "taut/results/described.hpp"

namespace taut::results {
namespace {

bool is_used(const machine::Machine& machine, const std::string& rope) {
  const auto runs = [&](const auto& one) { return one.rope == rope; };
  return std::any_of(machine.reevings.begin(), machine.reevings.end(), runs) ||
         std::any_of(machine.guys.begin(), machine.guys.end(), runs);
}

/// What a rope is of the catalogue, by its deck or by the choice of a design.
std::optional<catalogue::NamedRope> of_catalogue(const machine::description::Rope& rope, const ChosenRopes& chosen) {
  if (const auto own = chosen.find(rope.name); own != chosen.end()) {
    return catalogue::NamedRope{
        .name = rope.name, .row = own->second, .id = own->second.id, .mend = "look at the unit"};
  }
  if (!rope.rope) return std::nullopt;
  const auto row = catalogue::find_rope_in_words(*rope.rope);
  if (!row) return std::nullopt;
  return catalogue::NamedRope{
      .name = rope.name, .row = *row, .id = *rope.rope, .mend = "look at the unit, or leave 'rope' out"};
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
    const catalogue::OwnValues own{.mass = rope.mass.value_or(0),
                                   .diameter = rope.diameter.value_or(0),
                                   .breaking_force = rope.breaking_force.value_or(0),
                                   .stiffness = rope.stiffness.value_or(0)};
    for (catalogue::ValueDoubt& one : catalogue::doubts_of(*known, own)) {
      one.unsafe ? warn_unsafe(r, std::move(one.words)) : r.warnings.push_back(std::move(one.words));
    }
  }
}

void warn_of_strain(const machine::Machine& machine, const ChosenRopes& chosen, const machine::Model& model,
                    const Display& display, Result& r) {
  for (const machine::Reeving& one : model.reevings) {
    const Value* T = r.find_value(one.name + ".T_max");
    const auto* rope = rope_of(machine, one.name);
    if (T == nullptr || rope == nullptr) continue;
    std::optional<std::string> words = catalogue::doubt_of_strain(one.name, T->value, one.stiffness, display);
    if (!words) continue;
    const AboutPart about(r, {.kind = PartKind::rope, .name = one.name});
    of_catalogue(*rope, chosen) ? warn_unsafe(r, *std::move(words)) : r.warnings.push_back(*std::move(words));
  }
}

}  // namespace taut::results
