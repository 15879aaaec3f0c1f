#include "taut/study/installation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"

namespace taut::study {
namespace {

bool touches(const machine::Reeving& rope, const Array<bool>& bodies) {
  return std::any_of(rope.nodes.begin(), rope.nodes.end(),
                     [&](const machine::Node& n) { return n.at.body != machine::ground && bodies[n.at.body]; });
}

bool holds(const machine::Reeving& rope, int body) {
  return std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& n) { return n.at.body == body; });
}

bool is_in(const Array<int>& all, std::size_t index) {
  return std::find(all.begin(), all.end(), static_cast<int>(index)) != all.end();
}

/// Which bodies and ropes go, until nothing more does. `gone` bodies and ropes are given; those in `with` stay.
void spread(const machine::Model& model, int kept, const PutUpWith& with, Array<bool>& gone, Array<bool>& ropes_gone) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t r = 0; r < model.reevings.size(); ++r) {
      if (static_cast<int>(r) == kept || ropes_gone[r] || !touches(model.reevings[r], gone)) continue;
      changed = ropes_gone[r] = true;
    }
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      if (gone[b] || model.bodies[b].free.empty() || is_in(with.bodies, b)) continue;
      if (model.bodies[b].beam >= 0) continue;  // its beam holds a section
      bool had = false, has = false;
      for (std::size_t r = 0; r < model.reevings.size(); ++r) {
        if (!holds(model.reevings[r], static_cast<int>(b))) continue;
        had = true;
        has = has || !ropes_gone[r];
      }
      if (had && !has) changed = gone[b] = true;
    }
  }
}

/// The stretched length of what lies on the contacts of a rope: R theta.
double on_contacts(const machine::Model& model, const solve::EquilibriumResult& r, int reeving) {
  double length = 0;
  for (const solve::ContactResult& c : r.contacts) {
    if (c.reeving == reeving) length += model.reevings[reeving].nodes[c.node].radius * c.wrap;
  }
  return length;
}

/// Leaves the carriages that are still there, with their ropes and nodes by the numbers that these will have.
template <class Taken>
void keep_carriages(machine::Model& model, int reeving, const Array<bool>& gone, const Array<bool>& ropes_gone,
                    const Taken& taken) {
  const auto rope = [&](int r) {
    if (r < 0 || ropes_gone[r]) return -1;
    return static_cast<int>(std::count(ropes_gone.begin(), ropes_gone.begin() + r, false));
  };
  const auto node = [&](int r, int k) {
    if (r != reeving) return k;
    const auto& nodes = model.reevings[r].nodes;
    return k - static_cast<int>(std::count_if(nodes.begin(), nodes.begin() + k, taken));
  };
  std::erase_if(model.carriages, [&](const machine::Carriage& car) { return gone[car.body] || rope(car.reeving) < 0; });
  for (machine::Carriage& car : model.carriages) {
    car.node = node(car.reeving, car.node);
    if (car.grip_reeving >= 0) car.grip_node = node(car.grip_reeving, car.grip_node);
    for (int* r : {&car.reeving, &car.mainline, &car.grip_reeving, &car.haulback}) *r = rope(*r);
    if (car.grip_reeving < 0) car.grip_node = -1;
  }
}

}  // namespace

EmptyLine empty_line(const machine::Model& model, int reeving, const PutUpWith& with) {
  expects(reeving >= 0 && as_size(reeving) < model.reevings.size(), "a rope of the model");
  EmptyLine line;
  Array<bool> gone(model.bodies.size(), false), ropes_gone(model.reevings.size(), false);
  for (const machine::Carriage& car : model.carriages) {
    if (car.reeving == reeving && !is_in(with.bodies, as_size(car.body))) gone[car.body] = true;
  }
  for (const int rope : with.absent) ropes_gone[rope] = true;
  spread(model, reeving, with, gone, ropes_gone);
  line.model = model;
  machine::Reeving& own = line.model.reevings[reeving];
  const auto taken = [&](const machine::Node& n) {
    return n.kind != machine::NodeKind::anchor && n.at.body != machine::ground && gone[n.at.body];
  };
  keep_carriages(line.model, reeving, gone, ropes_gone, taken);
  std::erase_if(own.nodes, taken);
  const bool loses_drive = own.closed && (own.nodes.empty() || own.nodes.front().kind != machine::NodeKind::drive);
  if (touches(own, gone) || own.nodes.size() < 2 || loses_drive) {
    line.outcome = infeasible(fmt::format("'{}' ends on what rides on it: it is never empty", own.name));
    return line;
  }
  for (std::size_t b = 0; b < gone.size(); ++b) {
    if (!gone[b]) continue;
    line.removed.push_back(model.bodies[b].name);
    line.model.bodies[b].free.clear();
    line.model.bodies[b].mass = 0;
  }
  line.model.loads.clear();
  for (std::size_t i = 0; i < model.loads.size(); ++i) {
    const int body = model.loads[i].at.body;
    const bool left =
        body != machine::ground && (gone[body] || (is_in(with.bodies, as_size(body)) && !is_in(with.loads, i)));
    if (!left) line.model.loads.push_back(model.loads[i]);
  }
  Array<machine::Reeving> kept;
  for (std::size_t r = 0; r < ropes_gone.size(); ++r) {
    if (static_cast<int>(r) == reeving) line.reeving = static_cast<int>(kept.size());
    if (ropes_gone[r]) {
      line.removed.push_back(model.reevings[r].name);
    } else {
      kept.push_back(line.model.reevings[r]);
    }
  }
  line.model.reevings = std::move(kept);
  return line;
}

RopeLengths lengths_of(const machine::Model& model, const solve::EquilibriumResult& r, int reeving) {
  RopeLengths all;
  all.unstretched = r.ropes[reeving].unstretched;
  all.cut = all.unstretched * (1 + model.reevings[reeving].thermal_strain);
  for (const solve::SpanResult& s : r.spans) {
    if (s.reeving == reeving) all.free += s.stretched;
  }
  all.on_sheaves = on_contacts(model, r, reeving);
  all.stretched = all.free + all.on_sheaves;
  return all;
}

Installation installation(const EmptyLine& line, const solve::Condition& given,
                          const std::optional<machine::State>& near) {
  Installation i;
  i.outcome = line.outcome;
  if (!i.outcome.ok()) return i;
  solve::Condition condition = given;
  condition.reeving = line.reeving;
  solve::EquilibriumOptions options;
  options.band = false;
  i.at = solve::equilibrium_under(line.model, condition, options, near);
  const solve::EquilibriumResult& r = i.at.result;
  i.outcome = r.outcome;
  if (!i.outcome.ok()) return i;
  const solve::SpanResult* last = nullptr;
  for (const solve::SpanResult& s : r.spans) {
    if (s.reeving != line.reeving) continue;
    if (last == nullptr) {
      i.T_start = s.T_from;
      i.H = s.H;
    }
    i.sag.push_back(solve::sag_at_middle(s));
    last = &s;
  }
  i.T_end = last->T_to;
  const RopeLengths lengths = lengths_of(i.at.model, r, line.reeving);
  i.unstretched = lengths.unstretched;
  i.cut = lengths.cut;
  i.stretched = lengths.stretched;
  return i;
}

}  // namespace taut::study
