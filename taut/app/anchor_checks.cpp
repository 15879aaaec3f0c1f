#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "taut/app/guy_checks.hpp"
#include "taut/base/suggest.hpp"

namespace taut::app {
namespace {

/// The ends of ropes at a place: calls `take(reeving, node, span, at_start)`.
template <class Take>
void each_end_at(const model::Model& m, const analysis::EquilibriumResult& e, const std::string& name, Take&& take) {
  for (const analysis::SpanResult& span : e.spans) {
    const model::Reeving& rope = m.reevings[static_cast<std::size_t>(span.reeving)];
    if (rope.closed) continue;
    const auto end_of = [&](int node) -> const model::Node& { return rope.nodes[static_cast<std::size_t>(node)]; };
    if (span.from == 0 && end_of(0).name == name) take(rope, span, true);
    const int last = static_cast<int>(rope.nodes.size()) - 1;
    if (span.to == last && end_of(last).name == name) take(rope, span, false);
  }
}

/// Force of one rope's end (all copies) on what holds it.
Vector3 end_pull(const model::Reeving& rope, const analysis::SpanResult& span, bool at_start) {
  const Vector3 chord = span.end - span.start;
  Vector3 along(chord.x(), chord.y(), 0);
  if (along.norm() > 0) along.normalize();
  const Vector3 force =
      at_start ? Vector3(span.H * along + span.V_from * up()) : Vector3(-span.H * along - span.V_to * up());
  return rope.copies * force;
}

std::vector<std::string> anchors_of(const model::Model& model) {
  std::vector<std::string> known;
  for (const model::Reeving& rope : model.reevings) {
    if (rope.closed) continue;
    for (const std::string& name : {rope.nodes.front().name, rope.nodes.back().name}) {
      if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
    }
  }
  return known;
}

constexpr const char* fastening =
    "Lines on stumps and trees: 2.5 wraps, 8 spikes or 6 staples on the first and the last wrap, 2 clips up to 25 mm "
    "and 3 "
    "above (WAC 296-54-569); a skyline does not count as a guyline.";

double elevation(const Vector3& F) { return std::atan2(F.z(), std::hypot(F.x(), F.y())); }

/// The worst over all states.
struct AnchorStates {
  double force = 0, uplift = -HUGE_VAL, angle = -HUGE_VAL;
  Vector3 at_force = Vector3::Zero();
  std::string where, where_uplift, where_angle, ropes;
  double strongest_rope = 0;
  bool strength_unknown = false;
};
AnchorStates anchor_states(const MachineRun& run, const std::string& name) {
  AnchorStates all;
  for (const Answer& a : answers_of(run)) {
    Vector3 F = Vector3::Zero();
    each_end_at(*a.model, *a.result, name,
                [&](const model::Reeving& rope, const analysis::SpanResult& span, bool at_start) {
                  F += end_pull(rope, span, at_start);
                  all.strongest_rope = std::max(all.strongest_rope, rope.breaking_force * rope.copies);
                  all.strength_unknown |= rope.breaking_force == 0;
                });
    if (F.norm() > all.force) {
      all.force = F.norm();
      all.at_force = F;
      all.where = a.words;
    }
    if (F.z() > all.uplift) {
      all.uplift = F.z();
      all.where_uplift = a.words;
    }
    if (F.norm() > 0 && elevation(F) > all.angle) {
      all.angle = elevation(F);
      all.where_angle = a.words;
    }
  }
  return all;
}

void add_anchor_row(const std::string& name, const AnchorStates& s, Result& r) {
  auto table = std::find_if(r.tables.begin(), r.tables.end(), [](const Table& t) { return t.name == "anchor_forces"; });
  if (table == r.tables.end()) {
    r.tables.push_back({"anchor_forces",
                        "Largest pull of all ropes together on what holds them (angle: above the horizontal)",
                        {{"name", si::one},
                         {"force", si::N},
                         {"horizontal", si::N},
                         {"upwards", si::N},
                         {"angle", si::rad},
                         {"where", si::one}},
                        {}});
    table = std::prev(r.tables.end());
  }
  table->rows.push_back(
      {name, s.force, std::hypot(s.at_force.x(), s.at_force.y()), s.at_force.z(), elevation(s.at_force), s.where});
}

}  // namespace

void complain_of_anchors(const std::vector<AnchorCheckRequest>& anchors, const model::Model& model,
                         std::vector<Complaint>& complaints) {
  const std::vector<std::string> known = anchors_of(model);
  for (const AnchorCheckRequest& one : anchors) {
    const std::string path = fmt::format("checks.anchors.{}", one.name);
    if (std::find(known.begin(), known.end(), one.name) == known.end()) {
      complaints.push_back({path, fmt::format("no rope ends at '{}'{}", one.name, did_you_mean(one.name, known))});
    }
    if (one.as_strong_as_rope && !one.strength) complaints.push_back({path, "'as_strong_as_rope' needs 'strength'"});
    if (one.safety_factor != 1 && !one.strength) complaints.push_back({path, "'safety_factor' needs 'strength'"});
  }
}

void add_anchor_checks(const std::vector<AnchorCheckRequest>& anchors, const MachineRun& run, Result& r) {
  for (const AnchorCheckRequest& one : anchors) {
    const AnchorStates s = anchor_states(run, one.name);
    if (s.force == 0) continue;
    if (&one == &anchors.front()) r.assumptions.emplace_back(fastening);
    add_anchor_row(one.name, s, r);
    const double force = s.force * one.dynamic_factor;
    if (one.strength) {
      add_part_check(one.name, "anchor_strength", *one.strength / force, Sense::at_least, one.safety_factor, si::one,
                     fmt::format("strength {:.4g} kN over the largest pull {:.4g} kN ({})", *one.strength / 1e3,
                                 force / 1e3, s.where),
                     "user", r);
    }
    if (one.as_strong_as_rope) {
      if (s.strength_unknown) {
        r.warnings.push_back(fmt::format(
            "{}: the breaking force of a rope fixed to it is not known, 'as_strong_as_rope' looks at the others",
            one.name));
      }
      add_part_check(one.name, "anchor_as_rope", *one.strength, Sense::at_least, s.strongest_rope, si::N,
                     "strength of the anchor not below the breaking force of the strongest rope fixed to it", "derived",
                     r);
    }
    if (one.uplift) {
      add_part_check(one.name, "anchor_uplift", s.uplift * one.dynamic_factor, Sense::at_most, *one.uplift, si::N,
                     fmt::format("pull upwards ({})", s.where_uplift), "user", r);
    }
    if (one.angle) {
      add_part_check(one.name, "anchor_angle", s.angle, Sense::at_most, *one.angle, si::rad,
                     fmt::format("angle of the pull above the horizontal ({})", s.where_angle), "user", r);
    }
  }
}

}  // namespace taut::app
