#include "taut/checks/checked_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "taut/checks/rope/rope_strength.hpp"
#include "taut/math/index.hpp"

namespace taut::checks {
namespace {

constexpr double unseen_share = 0.02;  ///< by which a peak may be larger than what the checks have seen of it

/// A bound of a state: what rests there friction may hold anywhere between it and the other bound.
std::string held_words(const std::string& words) { return words + ", held by friction"; }

}  // namespace

namespace {

/// Not one with a limit of its peak alone.
bool is_limited_at_rest(const RopeCheckRequest& one) {
  return one.safety_factor || !one.field.empty() || one.group || one.en13001 || one.rated_pull;
}

}  // namespace

CheckedParts::CheckedParts(const CheckedDeck& given, const machine::Model& model)
    : deck(std::make_shared<const CheckedDeck>(given)),
      judge(given, model),
      ropes(given, model),
      drives(given.display),
      payloads(given.display) {
  for (const machine::Reeving& one : model.reevings) reevings.push_back(one.name);
  carriages = carriage_states(given, model);
  for (CarriageStates& one : carriages) one.display = given.display;
  if (!given.checks) return;
  for (std::size_t k = 0; k < given.checks->ropes.size(); ++k) {
    if (!is_limited_at_rest(given.checks->ropes[k])) continue;
    for (const std::size_t i : reevings_of_entry(given, k)) drives.ask_at_rest(model.reevings[i].name);
  }
  for (const YarderCheckRequest& one : given.checks->yarders) {
    for (const YarderLineRequest& line : lines_of(one)) drives.ask_at_rest(line.reeving);
  }
  for (const LineCheckRequest& one : given.checks->lines) {
    if (one.limiter) drives.ask_at_rest(one.name);
  }
  guys = guy_states(given.checks->guys, given, model);
  anchors = anchor_states(given.checks->anchors, given.machine, model);
  lines = line_states(given.checks->lines, model);
  masts = mast_states(given.checks->masts, given, model);
  supports = support_states(given.checks->supports);
  yarders = yarder_states(given.checks->yarders, model);
  for (GuyStates& one : guys) one.display = given.display;
  for (AnchorStates& one : anchors) one.tree.display = given.display;
  for (LineStates& one : lines) one.display = given.display;
  for (SupportStates& one : supports) one.display = given.display;
  for (YarderLineStates& one : yarders) one.display = given.display;
}

bool CheckedParts::any_shown() const {
  return !anchors.empty() || !lines.empty() || !masts.empty() || !supports.empty() || !yarders.empty() ||
         !carriages.empty();
}

bool CheckedParts::judges_sums(const machine::Model& model) const {
  if (any_shown()) return true;
  // the brake of a drum holds all its ropes
  std::vector<int> ends(model.drums.size(), 0);
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.drum) ++ends[as_size(*node.drum)];
    }
  }
  for (std::size_t d = 0; d < ends.size(); ++d) {
    if (model.drums[d].brake && ends[d] > 1) return true;
  }
  return false;
}

void CheckedParts::show(const CheckState& seen) {
  if (seen.rest != nullptr) {
    for (GuyStates& one : guys) checks::take(seen, one);
  }
  for (AnchorStates& one : anchors) checks::take(seen, one);
  for (LineStates& one : lines) checks::take(seen, one);
  for (MastStates& one : masts) checks::take(seen, *deck, one);
  for (SupportStates& one : supports) checks::take(seen, one);
  for (YarderLineStates& one : yarders) checks::take(seen, one);
  for (CarriageStates& one : carriages) checks::take(seen, one);
}

void CheckedParts::take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words,
                        const std::string& analysis) {
  if (!judged) return;
  seen = true;
  take_friction(state, words, analysis);
  judge.take(model, state, words);
  ropes.take(model, state, words);
  drives.take(model, state, words);
  if (deck->checks) drives.take_grips(model);
  payloads.take(model, state, words);
  const bool shown = !guys.empty() || any_shown();
  if (shown) show(state_of(model, state, words, analysis));
  const bool runs = std::any_of(state.flow.begin(), state.flow.end(), [](const Array<int>& rope) {
    return std::any_of(rope.begin(), rope.end(), [](int f) { return f != 0; });
  });
  for (const solve::EquilibriumResult& bound : state.bounds) {
    const std::string held = held_words(words);
    judge.take(model, bound, held);
    if (runs) drives.take_bound(model, bound, held);
    if (shown) show(state_of(model, bound, held, analysis));
  }
}

void CheckedParts::take_friction(const solve::EquilibriumResult& state, const std::string& words,
                                 const std::string& analysis) {
  unheld.take(state.unheld, words, analysis);
  unbounded.take(state.unbounded.empty() ? "" : "friction may hold more than what is judged: " + state.unbounded, words,
                 analysis);
}

void CheckedParts::take_values(const machine::Model& model, const solve::EquilibriumResult& state,
                               const std::string& words) {
  if (!judged) return;
  judge.take(model, state, words);
  for (const solve::EquilibriumResult& bound : state.bounds) judge.take(model, bound, held_words(words));
  seen_apart = true;
}

void CheckedParts::take_empty(const machine::Model& model, const solve::EquilibriumResult& state,
                              const std::string& line, const std::string& words, const std::string& analysis,
                              bool put_up) {
  if (!judged) return;
  // the line is put up in whatever is asked of the deck
  (put_up ? this->put_up : seen) = true;
  ropes.take_empty(model, state, words);
  payloads.take_ropes(model, state, words);
  take_friction(state, words, analysis);
  const auto take_one = [&](const solve::EquilibriumResult& one, const std::string& which) {
    put_up ? judge.take_put_up(model, one, which) : judge.take_empty(model, one, which);
    show_empty(state_of(model, one, which, analysis), line, put_up);
  };
  take_one(state, words);
  for (const solve::EquilibriumResult& bound : state.bounds) take_one(bound, held_words(words));
}

void CheckedParts::show_empty(const CheckState& seen, const std::string& line, bool put_up) {
  const auto show_as = [&](auto& one) {  // by its place among the ropes of that model
    const auto& ropes = seen.model->reevings;
    const int own = one.reeving;
    const auto rope = std::find_if(ropes.begin(), ropes.end(),
                                   [&](const machine::Reeving& each) { return each.name == reevings[as_size(own)]; });
    if (rope == ropes.end()) return;
    one.reeving = static_cast<int>(rope - ropes.begin());
    checks::take(seen, one);
    one.reeving = own;
  };
  for (AnchorStates& one : anchors) checks::take(seen, one);
  for (SupportStates& one : supports) checks::take(seen, one);
  for (YarderLineStates& one : yarders) take_empty_line(seen, line, put_up, one);
  for (LineStates& one : lines) {
    if (one.request->name == line) show_as(one);
  }
  for (GuyStates& one : guys) show_as(one);
  for (MastStates& one : masts) checks::take(seen, *deck, one);
}

void CheckedParts::take_put_up(const machine::Model& model, const solve::EquilibriumResult& state,
                               const std::string& words) {
  if (!judged) return;
  put_up = true;
  ropes.take_empty(model, state, words);
  payloads.take_ropes(model, state, words);
  judge.take_put_up(model, state, words);
  const CheckState seen = state_of(model, state, words, std::string(put_up_analysis));
  for (AnchorStates& one : anchors) checks::take(seen, one);
  for (SupportStates& one : supports) checks::take(seen, one);
  for (GuyStates& one : guys) checks::take_put_up(seen, reevings[as_size(one.reeving)], one);
  for (MastStates& one : masts) checks::take(seen, *deck, one);
}

void CheckedParts::take_pretension(const Array<double>& T_start, const Array<double>& T_end, const std::string& words) {
  if (!judged) return;
  for (GuyStates& one : guys) {
    const auto guy = std::find_if(deck->machine.guys.begin(), deck->machine.guys.end(),
                                  [&](const auto& g) { return g.name == reevings[as_size(one.reeving)]; });
    if (guy == deck->machine.guys.end()) continue;
    const bool at_anchor = guy->install && guy->install->at == machine::description::InstallAt::anchor;
    one.pulled.emplace_back((at_anchor ? T_end : T_start)[as_size(one.reeving)], words);
  }
}

void CheckedParts::take_moment(const machine::Model& model, const solve::TransientResult& so_far,
                               const solve::TransientFrame& moment, const std::string& words,
                               const std::string& analysis, bool slowly) {
  if (!judged) return;
  const bool begins = moment.t <= so_far.frames.front().t;
  if (!begins && moment.t == shown_at) return;  // an output step may be a moment besides
  shown_at = moment.t;
  seen = true;
  std::vector<FreeRope> free;
  if (!model.terrain.empty()) free = free_ropes(model, so_far, moment);
  judge.take_moment(model, so_far, moment, free, words);
  const bool at_rest = slowly || begins;
  ropes.take_moment(model, moment, so_far.steps, at_rest);
  drives.take_moment(model, moment, so_far.steps, slowly, words);
  if (!any_shown()) return;
  if (begins) T_in_moments.assign(model.reevings.size(), 0);
  for (const solve::TransientFrame::Branch& branch : moment.branches) {
    double& largest = T_in_moments[as_size(branch.reeving)];
    largest = std::max({largest, branch.T_from, branch.T_to});
  }
  CheckState seen = state_of(model, so_far, moment, fmt::format("{}, t = {:.4g} s", words, moment.t), analysis);
  seen.ropes = std::move(free);
  seen.moves = !at_rest;
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    if (judge.broken().contains(model.reevings[i].name)) seen.broken.push_back(static_cast<int>(i));
  }
  show(seen);
}

void CheckedParts::take_rest(const machine::Model& model, const solve::TransientFrame& rest, bool rope_mass,
                             const std::string& words, const std::string& analysis) {
  if (!judged) return;
  solve::TransientResult still;
  still.frames.push_back(rest);
  still.mass_lumped.assign(model.reevings.size(), rope_mass);
  still.ropes.resize(model.reevings.size());
  for (solve::RopeExtreme& rope : still.ropes) rope.T.min = rope.T_loosest = std::numeric_limits<double>::infinity();
  double T_begins = 0;  // of a branch, which may be in segments
  for (std::size_t i = 0; i < rest.branches.size(); ++i) {
    const solve::TransientFrame::Branch& branch = rest.branches[i];
    const auto same = [&](std::size_t k) {
      const solve::TransientFrame::Branch& other = rest.branches[k];
      return other.reeving == branch.reeving && other.from == branch.from && other.to == branch.to;
    };
    solve::RopeExtreme& rope = still.ropes[branch.reeving];
    rope.T_static = rope.T.max = std::max({rope.T.max, branch.T_from, branch.T_to});
    rope.T.min = std::min({rope.T.min, branch.T_from, branch.T_to});
    if (i == 0 || !same(i - 1)) T_begins = branch.T_from;
    if (i + 1 < rest.branches.size() && same(i + 1)) continue;
    rope.T_loosest = std::min(rope.T_loosest, (T_begins + branch.T_to) / 2);
  }
  take_moment(model, still, rest, words, analysis);
  take(model, still, words, {.slowly = true, .complete = true});
  judge.take_rest(model, still, words);
}

void CheckedParts::take(const machine::Model& model, const solve::TransientResult& motion, const std::string& words,
                        const MotionKind& kind) {
  if (!judged) return;
  const bool slowly = kind.slowly;
  judge.take(model, motion, words);
  if (motion.frames.empty()) return;
  drives.take(model, motion, words);
  if (deck->checks) drives.take_grips(model);
  for (const char* const what : {"break", "fall"}) {
    const auto event =
        std::find_if(motion.events.begin(), motion.events.end(), [&](const auto& e) { return e.what == what; });
    if (!slowly || event == motion.events.end()) continue;
    unseen.push_back(fmt::format(
        "{}: {} {}s at t = {:.4g} s in a motion without inertia, which does not show how high tensions rise then: "
        "leave out 'quasi_static'",
        words, event->where, what, event->t));
  }
  payloads.take(model, motion, words, slowly);
  constexpr double just_after = 1 + 1e-9;  // a ramp may end there
  const machine::GoesOn then =
      kind.complete ? machine::GoesOn{} : machine::goes_on(model, just_after * motion.frames.back().t);
  for (std::size_t i = 0; i < motion.ropes.size(); ++i) {
    const solve::RopeExtreme& e = motion.ropes[i];
    ropes.take_motion(static_cast<int>(i), e, slowly, then, words);
    judge.take_share(model.reevings[i], ropes.of(i).tension, ropes.of(i).where);
    if (!any_shown() || e.T.max <= (1 + unseen_share) * T_in_moments[i]) continue;
    unseen.push_back(
        fmt::format("{}: the peak of {}, {} at t = {:.4g} s, lies between output steps, which have at most {}: "
                    "anchors, lines, masts, supports and winches need a shorter output_step",
                    words, model.reevings[i].name, deck->display.brief(e.T.max, si::N), e.T.t_max,
                    deck->display.brief(T_in_moments[i], si::N)));
  }
  if (guys.empty()) return;
  const CheckState begins = state_of(model, motion, motion.frames.front(), {}, {});
  for (GuyStates& one : guys) take_motion(begins, motion, words, slowly, one);
}

}  // namespace taut::checks
