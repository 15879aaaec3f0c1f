#include "taut/catalogue/rope_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "taut/catalogue/modulus.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {
namespace {

/// Ropes of one diameter differ by less in what they bear and weigh: grades of 1570 to 2160 MPa by 1.4, cores by 1.1.
constexpr double most_apart = 1.5;
constexpr double wire_modulus = 206e9;  ///< Pa: as stiff as its wires is no rope
constexpr double most_strain = 0.02;    ///< steel ropes break at 2 to 3 %, and yield before

/// One value of the deck against that of the row.
struct Overridden {
  const char* key;
  double given, row;  ///< SI; 0: not known
  double unit;        ///< of the printed numbers, as a number in SI: 1e3 for kN
  const char* symbol;
  bool safe_below = false;
  std::string words(double value) const { return fmt::format("{:.4g} {}", value / unit, symbol); }
};

void doubt_value(const NamedRope& rope, const Overridden& one, std::vector<ValueDoubt>& all) {
  if (!(one.given > 0) || !(one.row > 0)) return;
  const bool above = one.given > most_apart * one.row, below = one.given * most_apart < one.row;
  if (!above && !below) return;
  all.push_back({.words = fmt::format("rope '{}' has the {} {}; its row of the catalogue, '{}', has {}: {}", rope.name,
                                      one.key, one.words(one.given), rope.id, one.words(one.row), rope.mend),
                 .unsafe = above || !one.safe_below});
}

/// A new rope is softer than the bedded-in one of the tables; none is stiffer than its wires.
void doubt_stiffness(const NamedRope& rope, double stiffness, std::vector<ValueDoubt>& all) {
  const auto s = stiffness_of(rope.row);
  const auto first = find_rule("modulus.first_loading");
  if (!s || !first || !first->low || !(stiffness > 0) || std::isinf(stiffness)) return;
  const double least = *first->low * s->low * s->area, most = wire_modulus * s->area;
  if (stiffness >= least && stiffness <= most) return;
  all.push_back({.words = fmt::format(
                     "rope '{}' has the stiffness {:.4g} MN; a rope of its row of the catalogue, '{}', has {:.4g} "
                     "MN when new to {:.4g} MN, that of its wires: {}",
                     rope.name, stiffness / 1e6, rope.id, least / 1e6, most / 1e6, rope.mend)});
}

}  // namespace

std::vector<ValueDoubt> doubts_of(const NamedRope& rope, const OwnValues& own) {
  std::vector<ValueDoubt> all;
  const RopeRow& row = rope.row;
  doubt_value(rope, {.key = "mass", .given = own.mass, .row = row.mass_per_length, .unit = 1, .symbol = "kg/m"}, all);
  doubt_value(rope, {.key = "diameter", .given = own.diameter, .row = row.diameter, .unit = 1e-3, .symbol = "mm"}, all);
  doubt_value(rope,
              {.key = "breaking force",
               .given = own.breaking_force,
               .row = row.breaking_force,
               .unit = 1e3,
               .symbol = "kN",
               .safe_below = true},
              all);
  doubt_stiffness(rope, own.stiffness, all);
  return all;
}

std::optional<std::string> doubt_of_strain(const std::string& rope, double tension, double stiffness,
                                           const Display& display, const std::string& key) {
  if (!(tension > most_strain * stiffness)) return std::nullopt;
  return fmt::format(
      "rope '{}': its largest tension, {}, strains it by {:.3g} % at a stiffness of {}: no steel rope bears that; look "
      "at the unit of its '{}'",
      rope, display.brief(tension, si::N), 100 * tension / stiffness, display.brief(stiffness, si::N.in("MN")), key);
}

Check breaking_check(std::string name, std::string part, double tension, Bound strength) {
  Check c = make_check(std::move(name), tension, si::N, std::move(strength));
  c.part = std::move(part);
  c.limits = false;
  return c;
}

Check breaking_check(const std::string& part, const RopeRow& rope, double tension) {
  return breaking_check(fmt::format("{} does not break", part), part, tension,
                        {.sense = Sense::at_most,
                         .limit = rope.breaking_force,
                         .rule = fmt::format("largest tension below the minimum breaking force of {}; the safety that "
                                             "is wanted on top is the designer's",
                                             rope.id),
                         .trust = trust_words(rope)});
}

}  // namespace taut::catalogue
