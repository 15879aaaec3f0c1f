#include "taut/analysis/installation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"

namespace taut::analysis {
namespace {

bool touches(const model::Reeving& rope, const std::vector<bool>& bodies) {
  return std::any_of(rope.nodes.begin(), rope.nodes.end(),
                     [&](const model::Node& n) { return n.at.body != model::ground && bodies[at(n.at.body)]; });
}

bool holds(const model::Reeving& rope, int body) {
  return std::any_of(rope.nodes.begin(), rope.nodes.end(), [&](const model::Node& n) { return n.at.body == body; });
}

/// Which bodies and ropes go, until nothing more does. `gone` bodies are given.
void spread(const model::Model& model, int kept, std::vector<bool>& gone, std::vector<bool>& ropes_gone) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t r = 0; r < model.reevings.size(); ++r) {
      if (static_cast<int>(r) == kept || ropes_gone[r] || !touches(model.reevings[r], gone)) continue;
      changed = ropes_gone[r] = true;
    }
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      if (gone[b] || model.bodies[b].free.empty() || model.bodies[b].beam >= 0) continue;  // its beam holds a section
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
double on_contacts(const model::Model& model, const EquilibriumResult& r, int reeving) {
  double length = 0;
  for (const ContactResult& c : r.contacts) {
    if (c.reeving == reeving) length += model.reevings[at(reeving)].nodes[at(c.node)].radius * c.wrap;
  }
  return length;
}

}  // namespace

EmptyLine empty_line(const model::Model& model, int reeving) {
  expects(reeving >= 0 && at(reeving) < model.reevings.size(), "a rope of the model");
  EmptyLine line;
  std::vector<bool> gone(model.bodies.size(), false), ropes_gone(model.reevings.size(), false);
  for (const model::Carriage& car : model.carriages) {
    if (car.reeving == reeving) gone[at(car.body)] = true;
  }
  spread(model, reeving, gone, ropes_gone);
  line.model = model;
  line.model.carriages.clear();
  model::Reeving& own = line.model.reevings[at(reeving)];
  std::erase_if(own.nodes, [&](const model::Node& n) {
    return n.kind != model::NodeKind::anchor && n.at.body != model::ground && gone[at(n.at.body)];
  });
  const bool loses_drive = own.closed && (own.nodes.empty() || own.nodes.front().kind != model::NodeKind::drive);
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
  std::erase_if(line.model.loads,
                [&](const model::Load& load) { return load.at.body != model::ground && gone[at(load.at.body)]; });
  std::vector<model::Reeving> kept;
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

RopeLengths lengths_of(const model::Model& model, const EquilibriumResult& r, int reeving) {
  RopeLengths all;
  all.unstretched = r.ropes[at(reeving)].unstretched;
  all.cut = all.unstretched * (1 + model.reevings[at(reeving)].thermal_strain);
  for (const SpanResult& s : r.spans) {
    if (s.reeving == reeving) all.free += s.stretched;
  }
  all.on_sheaves = on_contacts(model, r, reeving);
  all.stretched = all.free + all.on_sheaves;
  return all;
}

Installation installation(const EmptyLine& line, const Condition& given, const std::optional<model::State>& near) {
  Installation i;
  i.outcome = line.outcome;
  if (!i.outcome.ok()) return i;
  Condition condition = given;
  condition.reeving = line.reeving;
  EquilibriumOptions options;
  options.band = false;
  i.at = equilibrium_under(line.model, condition, options, near);
  const EquilibriumResult& r = i.at.result;
  i.outcome = r.outcome;
  if (!i.outcome.ok()) return i;
  const SpanResult* last = nullptr;
  for (const SpanResult& s : r.spans) {
    if (s.reeving != line.reeving) continue;
    if (last == nullptr) {
      i.T_start = s.T_from;
      i.H = s.H;
    }
    i.sag.push_back(sag_at_middle(s));
    last = &s;
  }
  i.T_end = last->T_to;
  const RopeLengths lengths = lengths_of(i.at.model, r, line.reeving);
  i.unstretched = lengths.unstretched;
  i.cut = lengths.cut;
  i.stretched = lengths.stretched;
  return i;
}

}  // namespace taut::analysis
