#include "taut/checks/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/calc/none.hpp"
#include "taut/calc/shown.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/catalogue/rope_values.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/checks/described.hpp"
#include "taut/checks/parts.hpp"
#include "taut/checks/rope/rope_uses.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/drives.hpp"
#include "taut/study/line/rope_clearance.hpp"
#include "taut/study/load_path.hpp"

namespace taut::checks {
namespace {

/// Words for a rope that is shorter than the distance of its ends, with both lengths; else empty.
std::string too_short(const machine::Model& m, const solve::EquilibriumResult& e, std::size_t reeving,
                      const Display& display) {
  if (m.reevings[reeving].closed) return {};
  const auto own = [&](const auto& s) { return as_size(s.reeving) == reeving; };
  const auto first = std::find_if(e.branches.begin(), e.branches.end(), own);
  const auto last = std::find_if(e.branches.rbegin(), e.branches.rend(), own);
  if (first == e.branches.end()) return {};
  const double apart = (last->end - first->start).norm();
  const double length = e.ropes[reeving].unstretched;
  if (length >= apart) return {};
  const auto [is, needs] = brief_apart(length, apart, si::m, display);
  return fmt::format("; the rope is {} long and its ends are {} apart", is, needs);
}

/// Words for a carriage that has left the span in which its rope's path has it; empty when it is there.
std::string beside_its_span(const machine::Model& m, const machine::State& state, const machine::Carriage& car,
                            const Display& display) {
  const auto& nodes = m.reevings[car.reeving].nodes;
  const auto n = static_cast<std::size_t>(car.node);
  const std::size_t after = n + static_cast<std::size_t>(car.rollers);
  if (n == 0 || after >= nodes.size()) return {};
  const Vector3 before = machine::in_ground(state, nodes[n - 1].at);
  Vector3 way = machine::in_ground(state, nodes[after].at) - before;
  way.z() = 0;
  const Vector3& place = state.bodies[car.body].position;
  const double passed = (place - before).dot(way);
  if (way.norm() == 0 || (passed >= 0 && passed <= way.squaredNorm())) return {};
  return fmt::format("carriage {} stands at x = {}, not between '{}' and '{}', where its rope's path has it", car.name,
                     display.brief(place.x(), si::m), nodes[n - 1].name, nodes[after].name);
}

/// Angle by which a body is turned from where the deck has it, rad.
double turned_by(const machine::Model& m, const solve::EquilibriumResult& e, std::size_t body) {
  const double trace = (e.state.bodies[body].orientation * m.bodies[body].orientation.transpose()).trace();
  return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0));
}

}  // namespace

void WorstOf::take(double x, const std::string& words, bool least) {
  if (std::isnan(x) || (!std::isnan(value) && (least ? x >= value : x <= value))) return;
  value = x;
  when = words;
}

void RopeLengthsSeen::take(const machine::Model& model, const solve::EquilibriumResult& state, int reeving) {
  free.take(state.ropes[reeving].unstretched);
  whole.take(solve::whole_length(model, state, reeving).value_or(none));
}

Judge::Judge(const CheckedDeck& deck, const machine::Model& model)
    : deck_(std::make_shared<const CheckedDeck>(deck)),
      model_(&model),
      beams_(model.beams.size()),
      footings_(footings_of(deck.machine, model)) {}

void Judge::warn(const Once& once, const std::string& text, bool unsafe, double size) {
  const auto [at, is_new] = known_.try_emplace(std::pair(once.part, once.what), warned_.size());
  if (!is_new && !(size > warned_[at->second].size)) return;
  Warned warned{.text = text, .unsafe = unsafe, .size = size, .part = once.part};
  if (is_new) {
    warned_.push_back(std::move(warned));
  } else {
    warned_[at->second] = std::move(warned);
  }
}

void Judge::take_beams(const solve::EquilibriumResult& e, const std::string& words) {
  for (std::size_t i = 0; i < std::min(e.beams.size(), beams_.size()); ++i) {
    const solve::BeamResult& b = e.beams[i];
    BeamWorst& worst = beams_[i];
    const double factor = b.least_factor();
    const bool buckles = std::isfinite(factor);
    worst.M.take(b.points[b.most_bent].M, words);
    worst.N.take(std::abs(b.points[b.most_pressed].N), words);
    worst.stress.take(b.points[b.most_stressed].stress, words);
    worst.stress_in_corner.take(b.stress_in_corner, words);
    worst.torsion_left_out.take(b.torsion_left_out > 0 ? b.torsion_left_out : none, words);
    worst.top_displacement.take(b.top_displacement, words);
    worst.N_cr.take(buckles && b.compression > 0 ? factor * b.compression : none, words, true);
    worst.alpha_cr.take(buckles ? factor : none, words, true);
    worst.swings.take(std::isfinite(b.swing_factor) ? b.swing_factor : none, words, true);
  }
}

void Judge::take_contacts(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  if (!e.indifferent.empty()) {
    warn(
        {.what = "indifferent"},
        fmt::format("{}: in balance all along a way; of its places the one found is not that nearest to where the deck "
                    "has it: {}; describe it where it is to stand, or hold it there",
                    words, e.indifferent),
        true);
  }
  for (const solve::ContactResult& c : e.contacts) {
    const machine::Node& node = m.reevings[c.reeving].nodes[c.node];
    if (c.state == solve::ContactState::lifted) {
      warn({.part = part_at(m, node), .what = "lifted " + node.name},
           fmt::format("{}: the rope has lifted off '{}'", words, node.name), !node.may_lift);
    }
    if (c.state == solve::ContactState::pulled) warn_of_pulled(m, node, c.force, words);
  }
}

void Judge::warn_of_pulled(const machine::Model& m, const machine::Node& node, const Vector3& force,
                           const std::string& words) {
  std::string text;
  if (node.support == Vector3::Zero()) {  // held down, or an axis that stands upright
    text = fmt::format(
        "{}: the rope presses away from '{}' on the side that it is given with {}; give the other 'side', or none",
        words, node.name, deck_->display.brief(force.norm(), si::N));
  } else if (machine::rides(m, node)) {
    text = fmt::format(
        "{}: the rope presses '{}' downwards with {}: it would lift off its rope. Load the carriage more, hang the "
        "load lower or between the rollers, or slacken the rope",
        words, node.name, deck_->display.brief(force.norm(), si::N));
  } else {
    text = fmt::format(
        "{}: the rope pulls '{}' upwards with {}; it would lift off. Set the support higher, slacken the rope, or "
        "say 'uplift: hold' where a guard holds it",
        words, node.name, deck_->display.brief(force.z(), si::N));
  }
  warn({.part = part_at(m, node), .what = "pulled " + node.name}, text, true, force.norm());
}

/// A motion holds a rope on its rounds, also where their `uplift` does not. Where one is held down, or may pass on
/// either side, there is nothing to tell.
void Judge::take_uplift(const machine::Model& m, const solve::TransientFrame& moment, const std::string& words) {
  constexpr double rounding = 1e-9;
  for (const auto& c : moment.contacts) {
    const machine::Reeving& rope = m.reevings[c.reeving];
    const machine::Node& node = rope.nodes[c.node];
    if (node.kind != machine::NodeKind::contact || broken_.contains(rope.name)) continue;
    if (!(std::max(c.T_in, c.T_out) > 0)) continue;
    if (node.support == Vector3::Zero() && (node.side_open || machine::is_saddle(node))) continue;
    const bool pulled =
        node.radius > 0 ? c.wrap < -rounding : c.force.dot(node.support) > rounding * std::max(c.T_in, c.T_out);
    if (pulled) warn_of_pulled(m, node, c.force, words);
  }
}

bool Judge::may_slack(const std::string& reeving) const {
  return std::any_of(deck_->machine.reevings.begin(), deck_->machine.reevings.end(),
                     [&](const auto& one) { return one.may_slack && name_of(one) == reeving; });
}

std::vector<Judge::Once> Judge::slack_branches(const machine::Model& m, const solve::TransientFrame& moment) const {
  std::vector<Once> all;
  for (const solve::TransientFrame::Branch& s : moment.branches) {
    if (!has_no_shape(m, moment, s) || may_slack(m.reevings[s.reeving].name)) continue;
    all.push_back({.part = {.kind = PartKind::rope, .name = m.reevings[s.reeving].name},
                   .what = span_words(m, s.reeving, s.from, s.to)});
  }
  return all;
}

void Judge::take_slack(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  for (const solve::BranchResult& s : e.branches) {
    if (!s.slack) continue;
    const std::string name = span_words(m, s.reeving, s.from, s.to);
    const std::string& rope = m.reevings[s.reeving].name;
    warn({.part = {.kind = PartKind::rope, .name = rope}, .what = name}, fmt::format("{}: {} is slack", words, name),
         !may_slack(rope));
  }
}

void Judge::take_places(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    // A tower whose guys do not hold it lies down, which is an equilibrium too.
    if (m.bodies[b].beam) continue;
    const double angle = turned_by(m, e, b);
    if (angle <= fallen_angle) continue;
    warn({.part = part_of_body(m, static_cast<int>(b)), .what = "fallen"},
         fmt::format("{}: '{}' comes to rest turned by {} from where the deck has it: it falls over, or begins far "
                     "from its place; hold it by more ropes, or put it where it is meant to stand",
                     words, m.bodies[b].name, deck_->display.brief(angle, si::rad)),
         true, angle);
  }
  take_spans(m, e.state, {}, words);
}

void Judge::take_spans(const machine::Model& m, const machine::State& state, const std::set<std::string>& broken,
                       const std::string& words) {
  for (const machine::Carriage& car : m.carriages) {
    if (broken.contains(m.reevings[car.reeving].name)) continue;
    const std::string where = beside_its_span(m, state, car, deck_->display);
    if (!where.empty())
      warn({.part = {.kind = PartKind::carriage, .name = car.name}, .what = "beside"},
           fmt::format("{}: {}", words, where), true);
  }
}

void Judge::take_empty(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  take_ropes(m, e, words);
  take_heights(m, e, words);
  take_beams(e, words);
  take_footings(m, e, words);
  take_contacts(m, e, words);
  take_slack(m, e, words);
}

void Judge::take_put_up(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  take_ropes(m, e, words);
  take_beams(e, words);
  take_footings(m, e, words);
}

void Judge::take_ropes(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    RopeWorst& worst = take_tension(m.reevings[i], e.ropes[i].T_max, words);
    if (worst.where_of_share == words) worst.where_of_share += too_short(m, e, i, deck_->display);
  }
}

Judge::RopeWorst& Judge::take_tension(const machine::Reeving& rope, double T, const std::string& words) {
  RopeWorst& worst = ropes_[rope.name];
  if (!worst.seen || T > worst.T) {
    worst.T = T;
    worst.where = words;
  }
  worst.seen = true;
  worst.carries |= T > 0;
  take_share(rope, T, words);
  return worst;
}

void Judge::take_share(const machine::Reeving& rope, double T, const std::string& words) {
  RopeWorst& worst = ropes_[rope.name];
  if (rope.breaking_force <= 0) return;
  if (worst.breaking_force > 0 && T * worst.breaking_force <= worst.T_of_share * rope.breaking_force) return;
  worst.breaking_force = rope.breaking_force;
  worst.T_of_share = T;
  worst.where_of_share = words;
}

void Judge::take_rest(const machine::Model& m, const solve::TransientResult& still, const std::string& words) {
  for (std::size_t i = 0; i < m.reevings.size(); ++i) take_tension(m.reevings[i], still.ropes[i].T.max, words);
}

void Judge::take(const machine::Model& m, const solve::EquilibriumResult& e, const std::string& words) {
  take_ropes(m, e, words);
  for (int i = 0; i < static_cast<int>(m.reevings.size()); ++i) ropes_[m.reevings[i].name].lengths.take(m, e, i);
  take_heights(m, e, words);
  take_beams(e, words);
  take_footings(m, e, words);
  take_contacts(m, e, words);
  take_slack(m, e, words);
  take_places(m, e, words);
  off_groove_.take(m, e, words);
  two_blocked_.take(m, e.state, {}, words);
}

namespace {

/// The rope that goes slack, or what a rope lifts off.
Part part_of_event(const machine::Model& m, const solve::TransientEvent& event) {
  if (event.reeving) return {.kind = PartKind::rope, .name = m.reevings[*event.reeving].name};
  for (const machine::Reeving& rope : m.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.kind == machine::NodeKind::contact && node.name == event.where) return part_at(m, node);
    }
  }
  return {.kind = PartKind::sheave, .name = event.where};
}

}  // namespace

void Judge::take(const machine::Model& m, const solve::TransientResult& motion, const std::string& words) {
  double broken = std::numeric_limits<double>::infinity();
  for (const solve::TransientEvent& event : motion.events) {
    if (event.what != "break") continue;
    broken = std::min(broken, event.t);
    auto& together = breaks_[event.t];
    if (std::find(together.begin(), together.end(), event.where) == together.end()) together.push_back(event.where);
  }
  take_peaks(m, motion, words);
  take_stop(motion, words);
  take_feet(m, words);
  if (!in_pieces_) warn_of_hanging(words);
  for (const solve::TransientEvent& event : motion.events) {
    if (event.what != "unstable") continue;
    warn({.what = words + " unstable"},
         fmt::format("{}: at t = {:.4g} s the machine rests in an equilibrium that it does not stay in: at the least "
                     "push {}; the motion, which nothing pushes there, does not show it",
                     words, event.t, event.where),
         true);
  }
  // Before the machine has broken nothing is thrown about: a rope that goes slack, or leaves its support, is news.
  for (const solve::TransientEvent& event : motion.events) {
    const bool slack = event.what == "slack";
    if ((!slack && event.what != "lift_off") || event.t >= broken) continue;
    if (slack && event.reeving && may_slack(m.reevings[*event.reeving].name)) continue;
    warn({.part = part_of_event(m, event), .what = event.what + " " + event.where},
         fmt::format("{}: {} {} at t = {:.4g} s", words, event.where, slack ? "goes slack" : "lifts off", event.t),
         true);
  }
}

void Judge::warn_of_hanging(const std::string& words) {
  for (const Once& one : hangs_) {
    warn({.part = one.part, .what = "slack " + one.what}, fmt::format("{}: {} is slack all the time", words, one.what),
         true);
  }
  hangs_.clear();
}

void Judge::begin_pieces() { in_pieces_ = 0; }

void Judge::end_pieces(const std::string& words) {
  in_pieces_.reset();
  warn_of_hanging(words);
}

/// "The deck breaks l and r at 2 s, m at 3 s"; empty where it breaks nothing.
std::string Judge::break_words() const {
  std::vector<std::string> all;
  all.reserve(breaks_.size());
  for (const auto& [t, ropes] : breaks_) all.push_back(fmt::format("{} at {:.4g} s", fmt::join(ropes, " and "), t));
  return all.empty() ? std::string() : fmt::format("The deck breaks {}", fmt::join(all, ", "));
}

/// A motion that stops where it begins shows nothing.
void Judge::take_stop(const solve::TransientResult& motion, const std::string& words) {
  if (motion.frames.empty()) return;
  const double begins = motion.frames.front().t;
  for (const solve::TransientEvent& event : motion.events) {
    if (event.what != "stop" || event.t > begins) continue;
    warn({.what = words + " stopped"},
         fmt::format("{}: the event '{}' ends it at t = {:.4g} s, where it begins: it shows nothing", words,
                     event.where, begins),
         true);
  }
}

void Judge::take_peaks(const machine::Model& m, const solve::TransientResult& motion, const std::string& words) {
  for (std::size_t i = 0; i < motion.ropes.size(); ++i) {
    const solve::Extreme& T = motion.ropes[i].T;
    RopeWorst& worst = ropes_[m.reevings[i].name];
    worst.carries |= T.max > 0;
    if (!(T.max > worst.peak)) continue;
    worst.peak = T.max;
    worst.where_of_peak = fmt::format("{}, t = {:.4g} s", words, T.t_max);
  }
}

void Judge::begin_motion(const machine::Model& m, const solve::TransientFrame& first) {
  events_seen_ = 0;
  broken_.clear();
  stood_.clear();
  lifted_.clear();
  picked_up_.clear();
  footprints_.clear();
  // a motion that goes on from a saved state does not see where its feet stood before: they count as all down
  for (std::size_t i = 0; first.t > 0 && i < first.faces.size(); ++i) stood_.insert(i);
  if (in_pieces_ && (*in_pieces_)++ > 0) return;  // it goes on with what is slack so far
  hangs_ = slack_branches(m, first);
}

void Judge::keep_slack(const std::vector<Once>& branches) {
  std::erase_if(hangs_,
                [&](const Once& one) { return std::find(branches.begin(), branches.end(), one) == branches.end(); });
}

namespace {

bool is_slack(const solve::TransientFrame::Branch& branch) {
  return branch.whole && std::max(branch.T_from, branch.T_to) <= 0;
}

}  // namespace

void Judge::take_moment(const machine::Model& m, const solve::TransientResult& so_far,
                        const solve::TransientFrame& moment, const std::vector<FreeRope>& free,
                        const std::string& words) {
  const bool begins = moment.t <= so_far.frames.front().t;
  if (begins) begin_motion(m, moment);
  if (!hangs_.empty()) keep_slack(slack_branches(m, moment));
  for (; events_seen_ < so_far.events.size(); ++events_seen_) {
    const solve::TransientEvent& event = so_far.events[events_seen_];
    if (event.what == "break") broken_.insert(m.reevings[*event.reeving].name);
  }
  const std::string when = fmt::format("{}, t = {:.4g} s", words, moment.t);
  const machine::State places = places_of(moment);
  off_groove_.take(m, moment, broken_, when);
  two_blocked_.take(m, places, broken_, when);
  take_uplift(m, moment, when);
  take_stand(m, moment, when);
  take_spans(m, places, broken_, when);
  if (m.terrain.empty()) return;
  for (const machine::Carriage& car : m.carriages) {
    if (broken_.contains(m.reevings[car.reeving].name)) continue;
    take_carriage(m, car, moment.bodies[car.body].position, when);
  }
  if (begins) warn_of_buried(m, words);
  // what a break throws about falls without end, as nothing of the machine is the ground
  if (broken_.empty()) warn_of_sunk(m, places, when);
  for (const solve::TransientFrame::Branch& branch : moment.branches) {
    const std::string& rope = m.reevings[branch.reeving].name;
    if (is_slack(branch) && !broken_.contains(rope)) slack_over_ground_.insert(rope);
  }
  for (const FreeRope& one : free) {
    if (!broken_.contains(m.reevings[one.reeving].name)) take_free(m, one, when);
  }
}

/// How high a free rope of a motion hangs.
void Judge::take_free(const machine::Model& m, const FreeRope& one, const std::string& when) {
  const machine::Reeving& rope = m.reevings[one.reeving];
  const auto by_x = [&](const Vector3& a, const Vector3& b) { return terrain_x(m, a) < terrain_x(m, b); };
  const Array<Vector3> ends = one.places();
  const auto [low, high] = std::minmax_element(ends.begin(), ends.end(), by_x);
  take_gap(rope.name, study::terrain_gap(m, terrain_x(m, *low), terrain_x(m, *high)));
  if (needs_corridor(m, one.reeving)) {
    for (const Vector3& place : ends) take_off_line(m, one.reeving, place, when);
  }
  const study::RopeClearance own = clearance_of(m, one);
  if (!is_over_line(m, one.reeving, ends, own.place)) return;
  take_height(rope.name, span_words(m, one.reeving, one.from, one.to), own.height, terrain_x(m, own.place), when,
              rope_heights_);
  if (own.height >= 0 && least_clearance_of(m, one).height < -rough) slack_over_ground_.insert(rope.name);
}

std::string Judge::strength_trust(std::size_t reeving) const {
  const std::string& name = rope_name_of(deck_->machine, reeving);
  if (deck_->chosen.find(name) == deck_->chosen.end()) {
    for (const auto& one : deck_->machine.ropes) {
      if (one.name == name && one.breaking_force) return "user";
    }
  }
  return catalogue::trust_words(row_in(*deck_, name));
}

std::vector<RopeSeen> Judge::ropes() const {
  std::vector<RopeSeen> all;
  for (const machine::Reeving& rope : model_->reevings) {
    const auto found = ropes_.find(rope.name);
    if (found == ropes_.end() || !found->second.seen) continue;
    const RopeWorst& own = found->second;
    all.push_back({.name = rope.name, .T = own.T, .where = own.where, .lengths = own.lengths});
  }
  return all;
}

/// The largest share of the breaking force: at rest, of the state whose rope is the weakest for it, or in a motion.
void Judge::add_strength(std::size_t reeving, const RopeWorst& own, Result& r) const {
  const machine::Reeving& rope = model_->reevings[reeving];
  const bool at_rest = own.breaking_force > 0 && own.T_of_share > 0;
  if (at_rest) {
    const ValueKind& factor = named(value_kinds(), "ROPE.safety_factor");
    r.values.push_back(make_value(factor, rope.name, "", own.breaking_force / own.T_of_share,
                                  fmt::format("{} of {}", factor.about.words, rope.name)));
  }
  const bool moves = rope.breaking_force > 0 && own.peak > 0 &&
                     !(at_rest && own.T_of_share * rope.breaking_force >= own.peak * own.breaking_force);
  if (!at_rest && !moves) return;
  Check c = catalogue::breaking_check(fmt::format("{}.T_max", rope.name), rope.name, moves ? own.peak : own.T_of_share,
                                      {.sense = Sense::at_most,
                                       .limit = moves ? rope.breaking_force : own.breaking_force,
                                       .rule = "minimum breaking force of the rope",
                                       .trust = strength_trust(reeving)});
  if (is_unverified(c.trust)) {
    const std::string row = row_in(*deck_, rope_name_of(deck_->machine, reeving)).id;
    c.doubts = {{.trust = c.trust, .source = "breaking force of the rope " + row}};
  }
  c.kind = PartKind::rope;
  c.where = moves ? own.where_of_peak : own.where_of_share;
  r.checks.push_back(std::move(c));
}

void Judge::add_tensions(Result& r) const {
  double worst = 0;
  std::string where;
  for (std::size_t i = 0; i < model_->reevings.size(); ++i) {
    const std::string& name = model_->reevings[i].name;
    const auto found = ropes_.find(name);
    if (found == ropes_.end()) continue;
    const RopeWorst& own = found->second;
    const bool moves = own.peak > 0 && !(own.seen && own.T >= own.peak);
    if (!own.seen && !moves) continue;
    const double T = moves ? own.peak : own.T;
    const std::string& state = moves ? own.where_of_peak : own.where;
    if (T >= worst) {
      worst = T;
      where = fmt::format("{}, {}", name, state);
    }
    const ValueKind& tension = named(value_kinds(), "ROPE.T_max");
    r.values.push_back(
        make_value(tension, name, "", T, fmt::format("{} of {} ({})", tension.about.words, name, state)));
    add_strength(i, own, r);
  }
  if (where.empty()) return;
  const ValueKind& largest = named(value_kinds(), "T_max");
  r.values.insert(r.values.begin(),
                  make_value(largest, "", "", worst, fmt::format("{} ({})", largest.about.words, where)));
}

void Judge::add_values(Result& r) const {
  add_tensions(r);
  add_heights(r);
  add_gaps(r);
  add_off_line(r);
  for (const Warned& one : warned_) {
    if (one.unsafe) {
      const AboutPart about(r, one.part);
      warn_unsafe(r, one.text);
    } else {
      r.warnings.push_back(one.text);
    }
  }
  off_groove_.add_warnings(r, deck_->display);
  two_blocked_.add_warnings(r, deck_->display);
  r.preface = break_words();
}

}  // namespace taut::checks
