#include "taut/app/exact/rope_doubts.hpp"

#include <utility>

#include "taut/catalogue/rope_words.hpp"

namespace taut::app {

void warn_of_rope(const MethodRope& rope, const Display& display, Result& r) {
  const auto tell = [&r](std::string words, bool unsafe) {
    unsafe ? warn_unsafe(r, std::move(words)) : r.warnings.push_back(std::move(words));
  };
  const auto row = catalogue::find_rope_in_words(rope.rope.value_or(""));
  if (row) {
    const catalogue::NamedRope known{
        .name = rope.name, .row = *row, .id = *rope.rope, .mend = "look at the unit, or leave the rope's name out"};
    for (catalogue::ValueDoubt& one : catalogue::doubts_of(known, rope.own)) tell(std::move(one.words), one.unsafe);
  }
  if (!(rope.own.stiffness > 0)) return;
  auto strain = catalogue::doubt_of_strain(rope.name, rope.tension, rope.own.stiffness, display, rope.stiffness_key);
  if (strain) tell(*std::move(strain), row.has_value() || rope.metal);
}

}  // namespace taut::app
