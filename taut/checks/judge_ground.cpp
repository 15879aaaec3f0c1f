#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "taut/calc/none.hpp"
#include "taut/calc/shown.hpp"
#include "taut/checks/described.hpp"
#include "taut/checks/judge.hpp"
#include "taut/checks/parts.hpp"
#include "taut/study/line/rope_clearance.hpp"
#include "taut/study/load_path.hpp"

/// What a judge says of carriages and ropes over the ground, and of what the ground holds.
namespace taut::checks {
namespace {

/// Whether the deck asks for the clearance of a rope: then its check tells where it is not known.
bool asks_clearance(const std::optional<ChecksRequest>& checks, const std::string& rope) {
  return checks && std::any_of(checks->lines.begin(), checks->lines.end(), [&](const LineCheckRequest& one) {
           return one.name == rope && (one.clearance || one.least_clearance);
         });
}

/// Whether a payload that counts has to keep a carriage on this rope, or the rope itself, clear of the ground.
bool limits_clearance(const std::vector<study::AnalysisRequest>& analyses, const machine::Model& model,
                      const std::string& rope) {
  return std::any_of(analyses.begin(), analyses.end(), [&](const study::AnalysisRequest& one) {
    if (!one.payload || !one.payload->judge) return false;
    const study::LimitsRequest& limits = one.payload->limits;
    const bool own = std::any_of(limits.named.begin(), limits.named.end(),
                                 [&](const auto& named) { return named.name == rope && named.clearance; });
    const bool rides = std::any_of(model.carriages.begin(), model.carriages.end(), [&](const machine::Carriage& car) {
      return car.name == one.payload->carriage && model.reevings[car.reeving].name == rope;
    });
    return own || (rides && (limits.clearance || limits.rope_clearance));
  });
}

bool carries(const machine::Model& m, int reeving) {
  return std::any_of(m.carriages.begin(), m.carriages.end(), [&](const auto& car) { return car.reeving == reeving; });
}

/// From the line of the terrain, in plan, m.
double distance_off(const machine::Model& m, const Vector3& place) {
  return std::abs(m.terrain_along.cross(place - m.terrain_from).z());
}

}  // namespace

bool Judge::needs_corridor(const machine::Model& m, int reeving) const {
  return carries(m, reeving) || asks_clearance(deck_->checks, m.reevings[reeving].name);
}

/// Whether the place at which a part of a rope is lowest, by the ground of the line, is over that ground. A rope with a
/// carriage, or of which a clearance is asked, counts as such, and is named where it is not; of the others the ground
/// is not known off the line. `places`: of that part.
bool Judge::is_over_line(const machine::Model& m, int reeving, const Array<Vector3>& places, const Vector3& lowest) {
  if (needs_corridor(m, reeving)) return true;
  const double corridor = deck_->machine.terrain->corridor;
  const auto off = [&](const Vector3& place) { return distance_off(m, place) > corridor; };
  if (std::any_of(places.begin(), places.end(), off)) off_ground_.insert(m.reevings[reeving].name);
  return !off(lowest);
}

void Judge::take_off_line(const machine::Model& m, int reeving, const Vector3& place, const std::string& where) {
  const double off = distance_off(m, place);
  OffLine& worst = off_line_[m.reevings[reeving].name];
  if (off > worst.distance) worst = {.distance = off, .x = terrain_x(m, place), .where = where};
}

void Judge::take_height(const std::string& part, const std::string& words, double height, double x,
                        const std::string& where, std::map<std::string, Height>& all) {
  if (std::isnan(height)) return;
  Height& worst = all[part];
  if (height < worst.value) worst = {.value = height, .x = x, .part = words, .where = where};
}

void Judge::take_carriage(const machine::Model& m, const machine::Carriage& car, const Vector3& place,
                          const std::string& where) {
  const double x = terrain_x(m, place), ground = study::ground_height(m.terrain, x);
  take_off_line(m, car.reeving, place, where);
  take_height(car.name, "carriage " + car.name, place.z() - ground, x, where, carriages_);
  if (!std::isnan(ground)) return;
  study::TerrainGap& beyond = beyond_[car.name];
  beyond.before = std::max(beyond.before, m.terrain.front().x - x);
  beyond.after = std::max(beyond.after, x - m.terrain.back().x);
}

void Judge::take_gap(const std::string& rope, const study::TerrainGap& gap) {
  study::TerrainGap& worst = gaps_[rope];
  if (gap.missing() > worst.missing()) worst = gap;
}

void Judge::take_heights(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  if (m.terrain.empty()) return;
  for (const machine::Carriage& car : m.carriages) {
    take_carriage(m, car, e.state.bodies[car.body].position, words);
  }
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    take_gap(m.reevings[i].name, study::terrain_gap(m, e.branches, static_cast<int>(i)));
  }
  for (const solve::BranchResult& branch : e.branches) {
    if (needs_corridor(m, branch.reeving)) {
      for (const Vector3& end : {branch.start, branch.end}) take_off_line(m, branch.reeving, end, words);
    }
    const study::RopeClearance own = study::rope_clearance(m, branch);
    const std::string& rope = m.reevings[branch.reeving].name;
    if (branch.slack) slack_over_ground_.insert(rope);
    if (!is_over_line(m, branch.reeving, {branch.start, branch.end}, own.place)) continue;
    take_height(rope, span_words(m, branch.reeving, branch.from, branch.to), own.height, terrain_x(m, own.place), words,
                rope_heights_);
  }
  warn_of_buried(m, words);
  warn_of_sunk(m, e.state, words);
}

/// Supports, sheaves and drums that stand in the ground; an anchor may be buried.
void Judge::warn_of_buried(const machine::Model& m, const std::string& words) {
  for (const machine::Reeving& rope : m.reevings) {
    for (const machine::Node& node : rope.nodes) {
      const bool anchor = node.kind == machine::NodeKind::anchor && !node.drum;
      if (anchor || node.at.body != machine::ground) continue;
      const double height = node.at.at.z() - study::ground_height(m.terrain, terrain_x(m, node.at.at));
      if (!(height < -rough)) continue;
      warn({.part = part_at(m, node), .what = "buried " + node.name},
           fmt::format("{}: '{}' is {} below the ground", words, node.name, deck_->display.brief(-height, si::m)), true,
           -height);
    }
  }
}

/// Bodies that move, by what is known of them: their origin, their centre of mass and where ropes hold them. Carriages
/// have a check of their own; a beam is only where it is.
void Judge::warn_of_sunk(const machine::Model& m, const machine::State& state, const std::string& words) {
  struct Lowest {
    double height = -rough;
    std::string what;
  };
  std::map<int, Lowest> all;
  const auto take = [&](int b, const Vector3& at, const std::string& what) {
    const machine::Body& body = m.bodies[b];
    const bool carriage = std::any_of(m.carriages.begin(), m.carriages.end(),
                                      [&](const machine::Carriage& car) { return car.body == b; });
    if (carriage || body.free.empty() || body.beam || body.of_rope) return;
    const Vector3 place = state.bodies[b].position + state.bodies[b].orientation * at;
    if (distance_off(m, place) > deck_->machine.terrain->corridor) return;
    const double height = place.z() - study::ground_height(m.terrain, terrain_x(m, place));
    if (height < all[b].height) all[b] = {.height = height, .what = what};
  };
  for (int b = 0; b < static_cast<int>(m.bodies.size()); ++b) {
    take(b, Vector3::Zero(), "the origin");
    take(b, m.bodies[b].centre, "the centre of mass");
  }
  for (const machine::Reeving& rope : m.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.at.body != machine::ground) take(node.at.body, node.at.at, "'" + node.name + "'");
    }
  }
  for (const auto& [b, lowest] : all) {
    if (!(lowest.height < -rough)) continue;
    const std::string& name = m.bodies[b].name;
    warn({.part = part_of_body(m, b), .what = "sunk"},
         fmt::format("{}: {} of '{}' is {} below the ground", words, lowest.what, name,
                     deck_->display.brief(-lowest.height, si::m)),
         true, -lowest.height);
  }
}

/// Whether a check asks for what an anchor holds upwards.
bool Judge::holds_uplift(const std::string& anchor) const {
  if (!deck_->checks) return false;
  const auto& asked = deck_->checks->anchors;
  return std::any_of(asked.begin(), asked.end(),
                     [&](const auto& one) { return one.name == anchor && (one.uplift || one.strength); });
}

/// The engine holds a foot both ways, the ground only what presses on it.
void Judge::take_footings(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  const double rounding = force_rounding(m, e);
  for (const Footing& one : footings_) {
    const double uplift = force_on(one, m, e).z();
    if (!(uplift > rounding) || holds_uplift(one.name)) continue;
    const std::string what = one.of.empty() ? fmt::format("the joint of '{}'", one.name)
                                            : fmt::format("the foot of {} at '{}'", fmt::join(one.of, ", "), one.name);
    warn({.part = part_of_anchor(deck_->machine, one.name), .what = "pulled up"},
         fmt::format("{}: {} is pulled up with {}: it must be anchored to hold it; 'uplift' or 'strength' of "
                     "'checks: anchors: {}' says what it holds",
                     words, what, deck_->display.brief(uplift, si::N), one.name),
         true, uplift);
  }
}

void Judge::add_heights(Result& r) const {
  const auto length = [&](double height) { return deck_->display.brief(height, si::m); };
  const auto place = [&](double x) { return ground_words(*model_, x, deck_->display); };
  const auto add = [&](const std::map<std::string, Height>& all, PartKind kind_of_part, const char* name) {
    const Height* least = nullptr;
    for (const auto& [part, one] : all) {
      if (!std::isfinite(one.value)) continue;
      if (least == nullptr || one.value < least->value) least = &one;
      if (one.value >= 0) continue;
      Check c = make_check(
          part + ".ground", one.value, si::m,
          {.sense = Sense::at_least,
           .limit = 0,
           .rule = fmt::format("{} is {} below the ground at {}", one.part, length(-one.value), place(one.x)),
           .trust = "user"});
      c.utilisation = std::numeric_limits<double>::quiet_NaN();  // a limit of 0 m is no measure
      c.part = part;
      c.kind = kind_of_part;
      c.limits = false;
      c.where = one.where;
      r.checks.push_back(std::move(c));
    }
    if (least == nullptr) return;
    const ValueKind& kind = named(value_kinds(), name);
    r.values.push_back(
        make_value(kind, "", "", least->value,
                   fmt::format("{}: {} at {} ({})", kind.about.words, least->part, place(least->x), least->where)));
  };
  add(carriages_, PartKind::carriage, "clearance_min");
  add(rope_heights_, PartKind::rope, "rope_clearance_min");
}

/// The ground under the line is not that under a rope beside it.
void Judge::add_off_line(Result& r) const {
  const auto& terrain = deck_->machine.terrain;
  if (!terrain) return;
  for (const machine::Reeving& rope : model_->reevings) {
    const auto found = off_line_.find(rope.name);
    if (found == off_line_.end() || !(found->second.distance > terrain->corridor)) continue;
    const OffLine& off = found->second;
    const bool asked =
        asks_clearance(deck_->checks, rope.name) || limits_clearance(deck_->analyses, *model_, rope.name);
    const auto [distance, corridor] = brief_apart(off.distance, terrain->corridor, si::m, deck_->display);
    std::string words = fmt::format(
        "terrain: rope '{}' is {} off the line of the terrain in plan, at {} along it ({}), more than the corridor of "
        "{}; {}: give 'between' two points of the rope, or a survey of the ground under it",
        rope.name, distance, deck_->display.brief(off.x, si::m), off.where, corridor,
        asked ? "its clearance is not judged, as the ground under the line is not the ground under the rope"
              : "the ground under the line is taken for the ground under the rope");
    const AboutPart about(r, {.kind = PartKind::rope, .name = rope.name});
    if (!asked) {
      warn_unsafe(r, std::move(words));
      continue;
    }
    r.warnings.push_back(words);
    r.unmade.push_back(std::move(words));
  }
}

/// A guy goes to the ground beside its mast, and a rope may well lie in it near its anchor.
void Judge::add_gaps(Result& r) const {
  constexpr double to_anchor = 6;  // m
  for (const auto& [car, beyond] : beyond_) {
    std::vector<std::string> where;
    if (beyond.before > 0) where.push_back(deck_->display.brief(beyond.before, si::m) + " before the first place");
    if (beyond.after > 0) where.push_back(deck_->display.brief(beyond.after, si::m) + " behind the last place");
    const AboutPart about(r, {.kind = PartKind::carriage, .name = car});
    warn_unsafe(r, fmt::format("{} stands up to {} of the terrain: its height is not judged there; give the ground "
                               "under all of its way",
                               car, fmt::join(where, " and up to ")));
  }
  for (std::size_t i = 0; i < deck_->machine.reevings.size(); ++i) {
    const std::string& rope = model_->reevings[i].name;
    const auto found = gaps_.find(rope);
    if (found == gaps_.end() || asks_clearance(deck_->checks, rope)) continue;
    const study::TerrainGap& gap = found->second;
    const AboutPart about(r, {.kind = PartKind::rope, .name = rope});
    if (std::max(gap.before, gap.after) > to_anchor) warn_unsafe(r, gap_words(rope, gap, deck_->display));
  }
}

}  // namespace taut::checks
