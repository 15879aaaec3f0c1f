#include "taut/checks/yarder/carriage_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "taut/study/limits.hpp"

namespace taut::checks {
namespace {

constexpr double same_diameter = 1e-9;

/// Whether its rope fits the carriage.
void check_rope_of_carriage(const CarriageStates& s, Result& r) {
  const machine::description::Carriage& car = *s.given;
  if (car.rope_diameters.empty()) return;
  if (!(s.rope_diameter > 0)) {
    r.unmade.push_back(fmt::format("{}: whether it fits its rope is not checked: the diameter of '{}' is not known",
                                   car.name, car.rides));
    r.warnings.push_back(r.unmade.back());
    return;
  }
  const auto diameter = [&](double d) { return s.display.brief(d, si::m.in("mm")); };
  const auto add = [&](const char* name, Sense sense, double limit) {
    add_part_check(car.name, name, s.rope_diameter, si::m.in("mm"),
                   {.sense = sense,
                    .limit = limit,
                    .rule = fmt::format("diameter of '{}', on which the carriage rides; {} to {}", car.rides,
                                        diameter(car.rope_diameters.front()), diameter(car.rope_diameters.back())),
                    .trust = car.rating_trust},
                   r);
  };
  // "18 mm" of the deck and of a table differ in the last digit
  add("least_rope", Sense::at_least, car.rope_diameters.front() * (1 - same_diameter));
  add("most_rope", Sense::at_most, car.rope_diameters.back() * (1 + same_diameter));
}

/// What a body weighs with the loads on it at a moment, N.
double weight_of(const machine::Model& model, int body, double t) {
  double weight = model.bodies[body].mass * model.gravity;
  for (const machine::Load& load : model.loads) {
    if (load.at.body != body) continue;
    const double share = load.over_time ? machine::at(*load.over_time, t).value / load.force.norm() : 1;
    weight -= share * load.force.z();
  }
  return weight;
}

/// Whether a rope has a node on a body.
bool meets(const machine::Reeving& rope, int body) {
  return std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const auto& node) { return node.at.body == body; });
}

/// Whether all that a rope holds hangs, too: it goes on to no ground and no drum, and to no body that is moved or
/// fixed.
bool hangs(const machine::Model& model, const machine::Reeving& rope) {
  return std::all_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& node) {
    const int body = node.at.body;
    return body != machine::ground && !node.drum && model.bodies[body].driven.empty() &&
           !model.bodies[body].free.empty();
  });
}

/// How a rope pulls a body down, N.
double pull_down(const CheckState& state, int reeving, int body) {
  const machine::Reeving& rope = state.model->reevings[reeving];
  double up = 0;
  for (const CheckBranch& branch : state.branches) {
    if (branch.reeving != reeving) continue;
    if (rope.nodes[branch.from].at.body == body) up += rope.copies * branch.on_start.z();
    if (rope.nodes[branch.to].at.body == body) up += rope.copies * branch.on_end.z();
  }
  return -up;
}

/// What a body that hangs on a carriage weighs with all that hangs on it by ropes, N, and with the pull of ropes that
/// go on to something else.
double hung_weight(const CheckState& state, const machine::Carriage& car, int body) {
  const machine::Model& model = *state.model;
  std::vector<int> all = {body};
  double weight = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    weight += weight_of(model, all[i], state.t.value_or(0));
    for (int r = 0; r < static_cast<int>(model.reevings.size()); ++r) {
      const machine::Reeving& rope = model.reevings[r];
      if (!meets(rope, all[i]) || meets(rope, car.body)) continue;
      if (!hangs(model, rope)) {
        weight += pull_down(state, r, all[i]);
        continue;
      }
      for (const machine::Node& node : rope.nodes) {
        if (std::find(all.begin(), all.end(), node.at.body) == all.end()) all.push_back(node.at.body);
      }
    }
  }
  return weight;
}

/// What other ropes load on a carriage, kg: what hangs on them, and those that pull it down to what stands. A rating is
/// one of loads at rest: in a motion, where what hangs may bounce, it counts with no more than its weight.
double hung_load(const CheckState& state, const machine::Carriage& car) {
  const machine::Model& model = *state.model;
  if (!(model.gravity > 0)) return 0;
  std::map<int, double> pulls;  // by the body that hangs
  double all = 0;
  for (const CheckBranch& branch : state.branches) {
    const auto hangs = study::hung_on(model, car, branch.reeving, branch.from, branch.to);
    const bool down = study::holds_down(model, car, branch.reeving, branch.from, branch.to);
    if (!hangs && !down) continue;
    const machine::Reeving& rope = model.reevings[branch.reeving];
    const bool starts_there = rope.nodes[branch.from].at.body == car.body;
    const double pull = -rope.copies * (starts_there ? branch.on_start : branch.on_end).z();
    if (hangs) {
      pulls[*hangs] += pull;
    } else {
      all += std::max(0.0, pull);
    }
  }
  for (const auto& [body, pull] : pulls) {
    all += state.rest == nullptr ? std::min(pull, hung_weight(state, car, body)) : pull;
  }
  return all / model.gravity;
}

}  // namespace

std::vector<CarriageStates> carriage_states(const CheckedDeck& deck, const machine::Model& model) {
  std::vector<CarriageStates> all;
  for (const auto& car : deck.machine.carriages) {
    if (!car.rated_payload && car.rope_diameters.empty()) continue;
    CarriageStates& s = all.emplace_back();
    s.given = &car;
    const auto rope = std::find_if(model.reevings.begin(), model.reevings.end(),
                                   [&](const auto& one) { return one.name == car.rides; });
    if (rope != model.reevings.end()) s.rope_diameter = rope->diameter;
  }
  return all;
}

void take(const CheckState& state, CarriageStates& carriage) {
  const auto& carriages = state.model->carriages;
  const auto car = std::find_if(carriages.begin(), carriages.end(),
                                [&](const auto& one) { return one.name == carriage.given->name; });
  if (car == carriages.end()) return;
  carriage.load.largest(study::load_on(*state.model, *car, state.t) + hung_load(state, *car), state.words);
}

void add_carriage_checks(const std::vector<CarriageStates>& carriages, Result& r) {
  for (const CarriageStates& s : carriages) {
    const machine::description::Carriage& car = *s.given;
    const AboutPart about(r, {.kind = PartKind::carriage, .name = car.name});
    check_rope_of_carriage(s, r);
    if (!car.rated_payload || std::isnan(s.load.value)) continue;
    add_part_check(car.name, "payload", s.load.value, si::kg,
                   {.sense = Sense::at_most,
                    .limit = *car.rated_payload,
                    .rule = fmt::format("load on the carriage ({}) against its rated payload{}", s.load.where,
                                        car.library ? fmt::format(", '{}'", *car.library) : ""),
                    .trust = car.rating_trust},
                   r);
  }
}

}  // namespace taut::checks
