#include "taut/results/rope_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/machine/links/rope_of.hpp"
#include "taut/results/described.hpp"

namespace taut::results {

std::optional<catalogue::RopeStiffness> assumed_stiffness(const machine::Machine& machine, const std::string& rope) {
  const auto own =
      std::find_if(machine.ropes.begin(), machine.ropes.end(), [&](const auto& one) { return one.name == rope; });
  return own == machine.ropes.end() ? std::nullopt : machine::catalogue_stiffness(*own);
}

void add_rope_stiffness(const machine::Machine& machine, Result& r) {
  for (const auto& rope : machine.ropes) {
    const auto runs = [&](const auto& one) { return one.rope == rope.name; };
    const bool used = std::any_of(machine.reevings.begin(), machine.reevings.end(), runs) ||
                      std::any_of(machine.guys.begin(), machine.guys.end(), runs);
    const auto s = machine::catalogue_stiffness(rope);
    if (!used || !s) continue;
    r.values.push_back(
        make_value(named(value_kinds(), "ROPE.stiffness"), rope.name, "", s->EA, catalogue::to_text(*s)));
    if (s->trust != catalogue::Trust::unverified) continue;
    r.warnings.push_back(
        fmt::format("stiffness of rope '{}': {}; give the maker's 'stiffness' where sag or tension decide", rope.name,
                    catalogue::to_text(*s)));
  }
}

}  // namespace taut::results
