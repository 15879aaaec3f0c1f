#include "taut/catalogue/breaking.hpp"

#include <fmt/format.h>

#include <utility>

#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

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
