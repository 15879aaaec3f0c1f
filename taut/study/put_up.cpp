#include "taut/study/put_up.hpp"

#include <fmt/format.h>

#include "taut/base/array.hpp"

namespace taut::study {
namespace {

PutUpWith with_of(const machine::Model& model, std::size_t reeving) {
  const machine::PutUp& asked = *model.reevings[reeving].put_up;
  PutUpWith with{asked.bodies, asked.loads, {}};
  for (std::size_t later = reeving + 1; later < model.reevings.size(); ++later) {
    if (model.reevings[later].put_up) with.absent.push_back(static_cast<int>(later));
  }
  return with;
}

}  // namespace

Array<PutUpLine> put_up(machine::Model& model) {
  Array<PutUpLine> all;
  for (std::size_t r = 0; r < model.reevings.size(); ++r) {
    machine::Reeving& rope = model.reevings[r];
    if (!rope.put_up) continue;
    PutUpLine& one = all.emplace_back();
    one.reeving = static_cast<int>(r);
    one.tension = rope.put_up->tension;
    one.at_end = rope.put_up->at_end;
    one.line = empty_line(model, one.reeving, with_of(model, r));
    const auto kind = one.at_end ? solve::Condition::Kind::tension_at_end : solve::Condition::Kind::tension_at_start;
    one.at = installation(one.line, {kind, 0, one.tension, 0});
    if (!one.at.outcome.ok()) {
      one.at.outcome.message = fmt::format("'{}' can't be put up with {:.4g} kN at its {}: {}", rope.name,
                                           one.tension / 1000, one.at_end ? "end" : "start", one.at.outcome.message);
      return all;
    }
    rope.given = machine::Given::length;
    rope.value = one.at.unstretched;
  }
  return all;
}

}  // namespace taut::study
