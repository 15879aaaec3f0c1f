#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/suggest.hpp"
#include "taut/calc/shown.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/rope/rope_rules.hpp"
#include "taut/checks/rope/rope_strength.hpp"
#include "taut/math/index.hpp"
#include "taut/study/line/bend_onto.hpp"
#include "taut/study/line/rope_clearance.hpp"
#include "taut/study/load_path.hpp"

namespace taut::checks {
namespace {

const machine::Reeving* line_named(const machine::Model& model, const std::string& name) {
  const auto found =
      std::find_if(model.reevings.begin(), model.reevings.end(), [&](const auto& one) { return one.name == name; });
  return found == model.reevings.end() ? nullptr : &*found;
}

/// Supports of a line: contacts that no carriage is.
std::vector<std::string> supports_of(const machine::Model& model, const machine::Reeving& rope) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i + 1 < rope.nodes.size(); ++i) {
    const machine::Node& node = rope.nodes[i];
    if (node.kind == machine::NodeKind::contact && !machine::rides(model, node)) names.push_back(node.name);
  }
  return names;
}

/// Angle of a pull below or above the horizontal, rad.
double steepness(const Vector3& pull) { return std::atan2(std::abs(pull.z()), std::hypot(pull.x(), pull.y())); }

double plan_angle(const Vector3& a, const Vector3& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y()));
}

/// The branches on both sides of a support: the one to the rope's end, and the one on the line's side. Where both go to
/// an end, the steeper one counts as the anchor's.
struct Tail {
  const CheckBranch* to_anchor = nullptr;
  const CheckBranch* of_line = nullptr;
  bool at_end = true;  ///< of the path
};
std::optional<Tail> tail_at(const CheckState& state, int reeving, const std::string& support) {
  const auto& nodes = state.model->reevings[reeving].nodes;
  const auto is_support = [&](int node) { return nodes[node].name == support; };
  const int last = static_cast<int>(nodes.size()) - 1;
  Tail tail;
  double steepest = -1;
  for (const CheckBranch& b : state.branches) {
    if (b.reeving != reeving) continue;
    const bool at_end = is_support(b.from) && b.to == last;
    if (!at_end && !(is_support(b.to) && b.from == 0)) continue;
    const double steep = steepness(at_end ? b.on_start : b.on_end);
    if (steep <= steepest) continue;
    steepest = steep;
    tail.to_anchor = &b;
    tail.at_end = at_end;
  }
  if (tail.to_anchor == nullptr) return std::nullopt;
  for (const CheckBranch& b : state.branches) {
    if (b.reeving != reeving || &b == tail.to_anchor) continue;
    if (is_support(tail.at_end ? b.to : b.from)) tail.of_line = &b;
  }
  return tail;
}

void take_tail(const CheckState& state, LineStates& line) {
  const auto tail = tail_at(state, line.reeving, *line.request->tail_tree);
  if (!tail) return;
  const CheckBranch& b = *tail->to_anchor;
  const Vector3& pull = tail->at_end ? b.on_start : b.on_end;  // on the tree
  line.tail_angle.largest(steepness(pull), state.words);
  if (tail->of_line != nullptr) {
    line.off_line.largest(plan_angle(b.end - b.start, tail->of_line->end - tail->of_line->start), state.words);
  }
}

/// Whether the rope pulls its support upwards. Where a strap holds it (`uplift: hold`), its bend has no sign of its
/// own: it is led under the round there. A sheave to a given side of the path stands above its rope on purpose.
bool pulls_up(const CheckContact& c, const machine::Node& node) {
  const bool upright = std::abs(node.axis.z()) > M_SQRT1_2;
  const bool given_side = node.radius > 0 && !node.side_open && !machine::is_saddle(node);
  const bool aside = node.support == Vector3::Zero() && given_side;
  return c.lifts || (!upright && !aside && c.force.z() > 0);
}

/// A rope before and behind a support: its directions along the path.
struct Passing {
  Vector3 in = Vector3::Zero(), out = Vector3::Zero();
  bool bears = false;  ///< on both sides
};

Passing passing(const CheckState& state, const CheckContact& c) {
  Passing p;
  const CheckBranch *before = nullptr, *behind = nullptr;
  for (const CheckBranch& b : state.branches) {
    if (b.reeving != c.reeving) continue;
    if (b.to == c.node) before = &b;  // of a rope in pieces the last one
    if (b.from == c.node && behind == nullptr) behind = &b;
  }
  if (before == nullptr || behind == nullptr) return p;
  const auto along = [](const Vector3& pull, const CheckBranch& b) {
    return pull == Vector3::Zero() ? Vector3(b.end - b.start) : pull;
  };
  p.in = along(-before->on_end, *before);
  p.out = along(behind->on_start, *behind);
  p.bears = before->on_end != Vector3::Zero() && behind->on_start != Vector3::Zero();
  return p;
}

/// The angle between the rope's directions before and behind a support, rad: out of the plane of a round too, where the
/// wrap about its axis sees only a part. 0 where a side bears nothing.
double bend_in_space(const Passing& p) { return p.bears ? std::atan2(p.in.cross(p.out).norm(), p.in.dot(p.out)) : 0; }

void take_bends(const CheckState& state, LineStates& line) {
  const auto& nodes = state.model->reevings[line.reeving].nodes;
  const auto rides = [&](const machine::Node& node) { return machine::rides(*state.model, node); };
  line.seen_empty = line.seen_empty || (!state.moves && std::none_of(nodes.begin(), nodes.end(), rides));
  for (const CheckContact& c : state.contacts) {
    if (c.reeving != line.reeving) continue;
    for (LineStates::Bend& bend : line.bends) {
      if (nodes[c.node].name != bend.support) continue;
      const Passing rope = passing(state, c);
      bend.most.largest(c.lifts ? c.wrap : std::max(c.wrap, bend_in_space(rope)), state.words);
      // how little the empty line bends is a rule for lines at rest; in motion it may, but must not lift off
      const bool up = pulls_up(c, nodes[c.node]);
      const double onto = study::bend_onto(nodes[c.node], c.wrap, rope.in, rope.out);
      if (!state.moves || up) bend.least.least(up ? -std::abs(onto) : onto, state.words);
    }
  }
}

void take_gap(const study::TerrainGap& gap, LineStates& line) {
  if (gap.missing() > line.gap.missing()) line.gap = gap;
}

/// "load path, at rest, x = 40 m, at x = 12 m, 9 m from its fixed end".
std::string place_words(const machine::Model& model, const std::string& words, const study::RopeClearance& found,
                        const Display& display) {
  const std::string place =
      fmt::format("{}, at {}", words, ground_words(model, terrain_x(model, found.place), display));
  return found.to_end ? fmt::format("{}, {} from its fixed end", place, display.brief(*found.to_end, si::m)) : place;
}

void take_clearance(const machine::Model& model, const FreeRope& rope, const std::string& words, LineStates& line) {
  const auto by_x = [&](const Vector3& a, const Vector3& b) { return terrain_x(model, a) < terrain_x(model, b); };
  const Array<Vector3> places = rope.places();
  const auto [low, high] = std::minmax_element(places.begin(), places.end(), by_x);
  take_gap(study::terrain_gap(model, terrain_x(model, *low), terrain_x(model, *high)), line);
  const study::RopeClearance found = clearance_of(model, rope);
  if (std::isnan(found.height)) return;
  line.clearance.least(found.height, place_words(model, words, found, line.display));
  if (rope.deeper.empty()) return;
  const study::RopeClearance least = least_clearance_of(model, rope);
  if (!std::isnan(least.height)) line.deepest.least(least.height, place_words(model, words, least, line.display));
}

/// The rope at the rounds between its ends: those that do not move may stand on the ground, but the line then is there.
void take_rounds(const CheckState& state, LineStates& line) {
  if (state.model->terrain.empty()) return;
  const std::size_t last = state.model->reevings[line.reeving].nodes.size() - 1;
  const auto take_place = [&](const Vector3& place) {
    const double x = terrain_x(*state.model, place), height = place.z() - study::ground_height(state.model->terrain, x);
    if (std::isnan(height)) return;
    line.clearance.least(height, fmt::format("{}, at {}", state.words, ground_words(*state.model, x, line.display)));
  };
  const auto& all = state.branches;
  const auto same = [](const CheckBranch& a, const CheckBranch& b) {  // pieces of a rope in segments
    return a.reeving == b.reeving && a.from == b.from && a.to == b.to;
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].reeving != line.reeving) continue;
    if (all[i].from > 0 && (i == 0 || !same(all[i - 1], all[i]))) take_place(all[i].start);
    if (as_size(all[i].to) < last && (i + 1 == all.size() || !same(all[i], all[i + 1]))) take_place(all[i].end);
  }
}

void take_clearance(const CheckState& state, LineStates& line) {
  take_rounds(state, line);
  for (const FreeRope& rope : state.ropes) {
    if (rope.reeving == line.reeving) take_clearance(*state.model, rope, state.words, line);
  }
  const bool slack = std::find(state.slack.begin(), state.slack.end(), line.reeving) != state.slack.end();
  if (slack && line.slack.empty()) line.slack = state.words;
  if (state.rest == nullptr) return;
  take_gap(study::terrain_gap(*state.model, state.rest->branches, line.reeving), line);
  for (const solve::BranchResult& branch : state.rest->branches) {
    if (branch.reeving != line.reeving) continue;
    if (branch.slack && line.slack.empty()) line.slack = state.words;
    const study::RopeClearance found = study::rope_clearance(*state.model, branch);
    if (std::isnan(found.height)) continue;
    line.clearance.least(found.height, place_words(*state.model, state.words, found, line.display));
  }
}

void check_clearance(const LineStates& line, Result& r) {
  const LineCheckRequest& request = *line.request;
  if (!request.clearance && !request.least_clearance) return;
  RuleLimit limit = rule_limit("layout.ground_clearance", true);
  if (request.least_clearance) limit = {.value = *request.least_clearance, .words = "the deck's own", .trust = "user"};
  const std::string slack = line.slack.empty() ? std::string() : slack_words(request.name, line.slack);
  if (!slack.empty()) {
    r.unmade.push_back(slack);
    r.warnings.push_back(slack);
  }
  if (line.gap.missing() > 0) {
    r.unmade.push_back(gap_words(request.name, line.gap, line.display));
    r.warnings.push_back(r.unmade.back());
  }
  if (std::isnan(line.clearance.value)) {
    if (!slack.empty()) return;
    leave_unmade(r,
                 fmt::format("{}: its clearance is not checked: in no state of the deck is a lowest place of it over "
                             "the terrain",
                             request.name),
                 {.part = {.kind = PartKind::rope, .name = request.name}});
    return;
  }
  const double own = line.clearance.value, deepest = line.deepest.value;
  if (own >= limit.value && deepest < limit.value) {
    const auto [by_tension, least] = brief_apart(deepest, limit.value, si::m, line.display);
    leave_unmade(
        r,
        fmt::format("{}: its clearance is not judged: it is {} by its length, and {} in its tension ({}), less "
                    "than {}; a motion with straight branches does not say which: {}",
                    request.name, line.display.brief(own, si::m), by_tension, line.deepest.where, least, lets_hang),
        {.part = {.kind = PartKind::rope, .name = request.name}});
    return;
  }
  const LineExtreme& shown = deepest < own && deepest >= limit.value ? line.deepest : line.clearance;
  add_part_check(request.name, "clearance", shown.value, si::m,
                 {.sense = Sense::at_least,
                  .limit = limit.value,
                  .rule = fmt::format("of the rope over the ground ({}); {}", shown.where, limit.words),
                  .trust = limit.trust},
                 r);
}

void check_tail(const LineStates& line, Result& r) {
  const LineCheckRequest& request = *line.request;
  const bool seen = !std::isnan(line.tail_angle.value) && !std::isnan(line.off_line.value);
  if (request.tail_tree && !seen) {
    leave_unmade(r,
                 fmt::format("{}: the angles of its tail tree are not checked: in no state is '{}' between the "
                             "anchor and the line",
                             request.name, *request.tail_tree),
                 {.part = {.kind = PartKind::rope, .name = request.name}});
  }
  const auto add = [&](const char* name, const LineExtreme& x, const std::optional<double>& own, const char* rule,
                       const char* words) {
    if (std::isnan(x.value)) return;
    RuleLimit limit = rule_limit(rule, false);
    if (own) limit = {.value = *own, .words = "the deck's own", .trust = "user"};
    add_part_check(request.name, name, x.value, si::rad,
                   {.sense = Sense::at_most,
                    .limit = limit.value,
                    .rule = fmt::format("{} ({}); {}", words, x.where, limit.words),
                    .trust = limit.trust},
                   r);
  };
  add("tail_angle", line.tail_angle, request.tail_angle, "layout.tail_tree_angle",
      "from the horizontal, between the tail tree and the anchor");
  add("anchor_off_line", line.off_line, request.off_line, "layout.anchor_off_line",
      "anchor against the line, seen from above");
}

void check_bends(const LineStates& line, Result& r) {
  const LineCheckRequest& request = *line.request;
  if (!line.bends.empty() && !line.seen_empty) {
    leave_unmade(r,
                 fmt::format("{}: its least bends are not checked: the empty line, which bends least, is not "
                             "among the states: give its 'install', or add an 'installation'",
                             request.name),
                 {.part = {.kind = PartKind::rope, .name = request.name}});
  }
  for (const LineStates::Bend& bend : line.bends) {
    const auto& ends = request.end_masts;
    const bool end = std::find(ends.begin(), ends.end(), bend.support) != ends.end();
    if (!std::isnan(bend.most.value)) {
      const RuleLimit high =
          rule_limit(end ? "layout.break_angle_loaded_end" : "layout.break_angle_loaded_support", false);
      add_part_check(request.name, bend.support + ".break_angle", bend.most.value, si::rad,
                     {.sense = Sense::at_most,
                      .limit = high.value,
                      .rule = fmt::format("largest bend over '{}' ({}); {}", bend.support, bend.most.where, high.words),
                      .trust = high.trust},
                     r);
    }
    if (!std::isnan(bend.least.value)) {
      const RuleLimit low =
          rule_limit(request.hold_down ? "layout.break_angle_hold_down" : "layout.break_angle_empty", true);
      add_part_check(request.name, bend.support + ".least_break_angle", bend.least.value, si::rad,
                     {.sense = Sense::at_least,
                      .limit = low.value,
                      .rule = fmt::format("least bend over '{}', with the empty line among the states ({}); {}",
                                          bend.support, bend.least.where, low.words),
                      .trust = low.trust},
                     r);
    }
  }
}

/// A limiter or fuse lets go above its tension: no state may need more.
void check_limiter(const LineCheckRequest& request, Result& r) {
  const Value* T = r.find_value(request.name + ".T_max");
  if (T == nullptr) {
    leave_unmade(r, fmt::format("{}.limiter_tension is not checked: no state gives the line a tension", request.name),
                 {.part = {.kind = PartKind::rope, .name = request.name}});
    return;
  }
  add_part_check(request.name, "limiter_tension", T->value, si::N,
                 {.sense = Sense::at_most,
                  .limit = *request.limiter,
                  .rule = "largest tension against the limiter or fuse of the line, which lets go above it",
                  .trust = "user"},
                 r);
}

/// A cold rope is the strongest, and the spar has to bear it.
void check_rating(const LineStates& line, const CheckedDeck& deck, const machine::Model& model, Result& r) {
  const LineCheckRequest& request = *line.request;
  const double own = line_named(model, request.name)->breaking_force;
  const double strength = own > 0 ? own : request.breaking_force.value_or(0);
  const char* trust = "verified";
  if (request.limiter) {
    add_part_check(
        request.name, "limiter", *request.limiter, si::N,
        {.sense = Sense::at_most,
         .limit = *request.spar_rating,
         .rule = fmt::format("tension limiter or line fuse against the rating on the spar's plate; the rope itself "
                             "breaks at {} (WAC 296-54-553)",
                             line.display.brief(strength, si::N)),
         .trust = trust},
        r);
    check_limiter(request, r);
    return;
  }
  std::vector<Doubt> doubts;
  add_doubt_of_rope(deck, as_size(line.reeving), doubts);
  add_part_check(
      request.name, "spar_rating", strength, si::N,
      with_doubts({.sense = Sense::at_most,
                   .limit = *request.spar_rating,
                   .rule = "breaking force of the rope against the rating on the spar's plate, else a tension limiter "
                           "or line fuse (WAC 296-54-553)",
                   .trust = trust},
                  {}, doubts),
      r);
}

/// The supports that a request names, against those that its line runs over.
void complain_of_supports(const LineCheckRequest& one, const std::vector<std::string>& supports,
                          const std::string& path, std::vector<Complaint>& complaints) {
  if (one.tail_tree &&
      (supports.empty() || (*one.tail_tree != supports.front() && *one.tail_tree != supports.back()))) {
    complaints.push_back(
        {path + ".tail_tree", fmt::format("'{}' is not the first or last support of '{}'{}", *one.tail_tree, one.name,
                                          did_you_mean(*one.tail_tree, supports))});
  }
  if (!one.tail_tree && (one.tail_angle || one.off_line)) {
    complaints.push_back({path, "'tail_angle' and 'off_line' need 'tail_tree'"});
  }
  if (!one.break_angles && (one.hold_down || !one.end_masts.empty())) {
    complaints.push_back({path, "'hold_down' and 'end_masts' need 'break_angles: true'"});
  }
  for (std::size_t i = 0; i < one.end_masts.size(); ++i) {
    const std::string& name = one.end_masts[i];
    if (std::find(supports.begin(), supports.end(), name) != supports.end()) continue;
    complaints.push_back(
        {fmt::format("{}.end_masts[{}]", path, i),
         fmt::format("'{}' does not run over a support '{}'{}", one.name, name, did_you_mean(name, supports))});
  }
}

}  // namespace

void complain_of_lines(const std::vector<LineCheckRequest>& lines, const machine::Model& model,
                       std::vector<Complaint>& complaints) {
  for (const LineCheckRequest& one : lines) {
    const std::string path = fmt::format("checks.lines.{}", one.name);
    const machine::Reeving* rope = line_named(model, one.name);
    if (rope == nullptr) {
      std::vector<std::string> known;
      known.reserve(model.reevings.size());
      for (const machine::Reeving& each : model.reevings) known.push_back(each.name);
      complaints.push_back({path, fmt::format("there is no reeving '{}'{}", one.name, did_you_mean(one.name, known))});
      continue;
    }
    complain_of_supports(one, supports_of(model, *rope), path, complaints);
    if ((one.clearance || one.least_clearance) && model.terrain.empty()) {
      complaints.push_back({path, "a clearance needs the machine's 'terrain'"});
    }
    complain_of_second(one.breaking_force, rope->breaking_force, path + ".breaking_force", complaints);
    if (one.limiter && !one.spar_rating) complaints.push_back({path + ".limiter", "needs 'spar_rating'"});
    if (one.spar_rating && !one.breaking_force && rope->breaking_force == 0) {
      complaints.push_back({path, "the rope's breaking force is not known: give 'breaking_force'"});
    }
  }
}

std::vector<LineStates> line_states(const std::vector<LineCheckRequest>& lines, const machine::Model& model) {
  std::vector<LineStates> all;
  for (const LineCheckRequest& one : lines) {
    const machine::Reeving* rope = line_named(model, one.name);
    LineStates& line = all.emplace_back();
    line.request = &one;
    line.reeving = static_cast<int>(rope - model.reevings.data());
    if (!one.break_angles) continue;
    for (std::string& support : supports_of(model, *rope)) line.bends.push_back({std::move(support), {}, {}});
  }
  return all;
}

void take(const CheckState& state, LineStates& line) {
  if (std::find(state.broken.begin(), state.broken.end(), line.reeving) != state.broken.end()) return;
  if (line.request->tail_tree) take_tail(state, line);
  take_bends(state, line);
  if (line.request->clearance || line.request->least_clearance) take_clearance(state, line);
}

void add_line_checks(const std::vector<LineStates>& lines, const CheckedDeck& deck, const machine::Model& model,
                     Result& r) {
  for (const LineStates& line : lines) {
    const AboutPart about(r, {.kind = PartKind::rope, .name = line.request->name});
    check_tail(line, r);
    check_bends(line, r);
    check_clearance(line, r);
    if (line.request->spar_rating) check_rating(line, deck, model, r);
  }
}

}  // namespace taut::checks
