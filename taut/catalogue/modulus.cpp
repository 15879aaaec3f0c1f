#include "taut/catalogue/modulus.hpp"

#include <fmt/format.h>

#include "taut/catalogue/construction.hpp"

namespace taut::catalogue {
namespace {

std::string rule_id(const RopeRow& rope) {
  if (rope.construction == "compacted") {
    return rope.standard == "SEILAPLAN" ? "modulus.skyline_planning" : "modulus.compacted";
  }
  const auto construction = parse_construction(rope.construction);
  if (!construction) return {};
  if (construction->strands >= 10) return "modulus.rotation_resistant";
  const bool fibre = rope.core == "FC", steel = rope.core == "IWRC" || rope.core == "WSC";
  const bool known = construction->strands == 6 || construction->strands == 8;
  if (!known || fibre == steel) return {};
  return fmt::format("modulus.{}_strand_{}", construction->strands, fibre ? "fc" : "iwrc");
}

}  // namespace

std::optional<RuleRow> modulus_rule(const RopeRow& rope) {
  const std::string id = rule_id(rope);
  if (id.empty()) return std::nullopt;
  const auto row = find_rule(id);
  if (!row || !row->low || !row->high) return std::nullopt;
  return *row;
}

std::optional<RopeStiffness> stiffness_of(const RopeRow& rope) {
  const auto rule = modulus_rule(rope);
  if (!rule || !(rope.area > 0)) return std::nullopt;
  RopeStiffness s;
  s.area = rope.area;
  s.low = *rule->low;
  s.high = *rule->high;
  s.modulus = (s.low + s.high) / 2;
  s.EA = s.area * s.modulus;
  s.rule = rule->id;
  s.rope = rope.core.empty() ? rope.construction : fmt::format("{}-{}", rope.construction, rope.core);
  s.trust = weaker(rope.area_trust, rule->trust);
  return s;
}

std::string to_text(const RopeStiffness& s) {
  const std::string trust = s.trust == Trust::unverified ? "UNVERIFIED" : std::string(to_text(s.trust));
  const std::string range = s.low < s.high ? fmt::format(", {:.4g} to {:.4g} GPa", s.low / 1e9, s.high / 1e9) : "";
  return fmt::format("EA = {:.4g} MN from area {:.4g} mm^2 x modulus {:.4g} GPa ({}: {}{}, {})", s.EA / 1e6,
                     s.area * 1e6, s.modulus / 1e9, s.rope, s.rule, range, trust);
}

}  // namespace taut::catalogue
