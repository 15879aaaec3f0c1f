#include "taut/solve/rest/hauled.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "taut/machine/senses.hpp"

namespace taut::solve {
namespace {

constexpr double taken_part = 1.0 / 16384;  ///< of a rope's length: straight, and above what the tolerance leaves
constexpr double more_pull = 1.0 / 256;     ///< of a given tension: the rope stretches by about as much
constexpr double no_run = 1.0 / 1024;       ///< of the rope taken in: the rope gives a little and runs nowhere

/// An end of a rope at which it is taken in; or a prescribed carriage that moves.
struct Hauler {
  int reeving = -1;  ///< -1: the carriage
  bool at_end = false;
  int sense = 1;  ///< 1: takes in, -1: pays out
};

bool is_rope(const std::optional<int>& reeving, int r) { return reeving && *reeving == r; }

/// Whether a carriage says how a rope runs: it rolls on it, is held by it or draws it off its winch.
bool carriage_says(const machine::Model& model, const machine::Senses& in, int r) {
  return in.follows[r] || std::any_of(model.carriages.begin(), model.carriages.end(), [&](const auto& car) {
           return car.reeving == r || is_rope(car.mainline, r) || is_rope(car.haulback, r) ||
                  (car.grip && car.grip->reeving == r);
         });
}

/// Whether a carriage that is hauled rolls on a rope: its winch, if it has one, holds it.
bool bears_hauled(const machine::Model& model, int r) {
  return std::any_of(model.carriages.begin(), model.carriages.end(),
                     [&](const auto& car) { return car.reeving == r && (car.mainline || car.haulback || car.grip); });
}

std::vector<Hauler> haulers_of(const machine::Model& model, const machine::Senses& in,
                               const EquilibriumOptions& options) {
  std::vector<Hauler> all;
  if (const int moves = options.prescribed ? in.moves[options.prescribed->carriage] : 0) {
    all.push_back({.sense = moves});
    return all;
  }
  for (int r = 0; r < static_cast<int>(model.reevings.size()); ++r) {
    if (in.follows[r] || bears_hauled(model, r)) continue;
    const bool both = machine::is_taken_in(model, r, false) && machine::is_taken_in(model, r, true);
    const machine::Reeving& rope = model.reevings[r];
    for (const bool at_end : {false, true}) {
      if (!machine::is_taken_in(model, r, at_end)) continue;
      const bool told_in = rope.haul == (at_end ? 1 : -1);
      if (rope.haul_is_told && both && !told_in) continue;
      all.push_back({.reeving = r, .at_end = at_end, .sense = rope.haul_is_told && !told_in ? -1 : 1});
    }
  }
  return all;
}

/// The node beside which a rope does not run while it is taken in at an end, or elsewhere; none: both its ends may.
std::optional<int> node_at_rest(const machine::Reeving& rope, const std::optional<bool>& taken_at_end) {
  for (std::size_t n = 0; n < rope.nodes.size(); ++n) {
    if (rope.nodes[n].kind == machine::NodeKind::clamp) return static_cast<int>(n);
  }
  const int last = static_cast<int>(rope.nodes.size()) - 1;
  if (rope.closed || rope.also) return std::nullopt;
  switch (rope.given) {
    case machine::Given::length:
      return taken_at_end && !*taken_at_end ? last : 0;
    case machine::Given::tension_at_start:
      return last;
    case machine::Given::tension_at_end:
      return 0;
    default:
      return std::nullopt;
  }
}

/// Contacts, and loads by the motion, of a rope of which neither the deck nor a carriage says which way it runs: 1.
Array<int> open_nodes(const machine::Reeving& rope) {
  Array<int> open(rope.nodes.size(), 0);
  for (std::size_t n = 0; n < open.size(); ++n) {
    const machine::Node& node = rope.nodes[n];
    const bool loaded = node.kind == machine::NodeKind::load && node.load.by_motion;
    open[n] = machine::loses(node) || loaded ? 1 : 0;
  }
  return open;
}

/// An answer beside another one, and the rope that has been taken in between them, or the way of the carriage, m.
struct TakenIn {
  EquilibriumResult then;
  double way = 0;
};

/// The answer with a little taken in; none where it is not found, or not with the same supports.
std::optional<TakenIn> with_taken_in(const machine::Model& machine, const Hauler& hauler, EquilibriumOptions options,
                                     const EquilibriumResult& now) {
  machine::Model model = machine;
  TakenIn found;
  if (hauler.reeving < 0) {
    for (const RopeResult& rope : now.ropes) found.way = std::max(found.way, taken_part * rope.unstretched);
    options.prescribed->x += hauler.sense * found.way;
  } else {
    machine::Reeving& rope = model.reevings[hauler.reeving];
    const bool by_tension =
        rope.given == machine::Given::tension_at_start || rope.given == machine::Given::tension_at_end;
    if (!by_tension && rope.given != machine::Given::length) return std::nullopt;
    found.way = by_tension ? 0 : taken_part * now.ropes[hauler.reeving].unstretched;
    rope.value = by_tension ? rope.value * (1 + hauler.sense * more_pull) : rope.value - hauler.sense * found.way;
  }
  found.then = equilibrium(model, options, now.state);
  const bool same = found.then.outcome.ok() && found.then.branches.size() == now.branches.size() &&
                    found.then.contacts.size() == now.contacts.size();
  if (!same) return std::nullopt;
  if (found.way == 0) {
    found.way = std::abs(found.then.ropes[hauler.reeving].unstretched - now.ropes[hauler.reeving].unstretched);
  }
  return found;
}

/// Contacts over which a rope runs one way, the other way, or both as it seems.
class Ways {
 public:
  Ways(const machine::Model& model, const machine::Senses& in, const EquilibriumOptions& options)
      : model_(model), haulers_(haulers_of(model, in, options)) {
    const bool by_carriage = haulers_.size() == 1 && haulers_.front().reeving < 0;
    for (int r = 0; r < static_cast<int>(model.reevings.size()); ++r) {
      const machine::Reeving& rope = model.reevings[r];
      for (Array<Array<int>>* const all : {&open_, &along_, &against_}) all->emplace_back(rope.nodes.size(), 0);
      const bool by_its_winch = haulers_.size() == 1 && haulers_.front().reeving == r;
      if (rope.closed || rope.haul_is_told || by_its_winch || carriage_says(model, in, r)) continue;
      open_[r] = open_nodes(rope);
      any_ = any_ || std::find(open_[r].begin(), open_[r].end(), 1) != open_[r].end();
      // a carriage that moves does not turn a winch: its own sense is one of those that have to agree
      if (!by_carriage || !(machine::is_taken_in(model, r, false) || machine::is_taken_in(model, r, true))) continue;
      for (std::size_t n = 0; n < rope.nodes.size(); ++n) add(r, static_cast<int>(n), in.flow[r][n]);
    }
  }

  bool any() const { return any_; }

  /// By the answers beside the one without loss.
  void seek(const EquilibriumOptions& options, const std::optional<machine::State>& start) {
    EquilibriumOptions still = options;
    still.motion = Motion::at_rest;
    still.creep.clear();
    still.creep_without_loss = still.band = still.beam_factors = false;
    still.held = true;
    const EquilibriumResult now = equilibrium(model_, still, start);
    known_ = now.outcome.ok() && !haulers_.empty();
    for (const Hauler& hauler : haulers_) {
      if (known_) known_ = take(hauler, still, now);
    }
  }

  /// The sense while the machine hauls in; 0: nothing says it.
  int sense(int r, int n) const { return known_ ? (along_[r][n] - against_[r][n]) : 0; }
  bool is_open(int r, int n) const { return open_[r][n] != 0; }

 private:
  void add(int r, int n, double way) {
    if (way > 0) along_[r][n] = 1;
    if (way < 0) against_[r][n] = 1;
  }

  bool take(const Hauler& hauler, const EquilibriumOptions& still, const EquilibriumResult& now) {
    const std::optional<TakenIn> found = with_taken_in(model_, hauler, still, now);
    if (!found) return false;
    for (int r = 0; r < static_cast<int>(model_.reevings.size()); ++r) {
      const machine::Reeving& rope = model_.reevings[r];
      const std::optional<int> rests =
          node_at_rest(rope, hauler.reeving == r ? std::optional(hauler.at_end) : std::nullopt);
      for (int n = 0; n < static_cast<int>(rope.nodes.size()); ++n) {
        if (!is_open(r, n)) continue;
        if (!rests) return false;
        const double runs = passed(model_, now, found->then, r, n, *rests);
        if (std::abs(runs) > no_run * found->way) add(r, n, runs);
      }
    }
    return true;
  }

  const machine::Model& model_;
  std::vector<Hauler> haulers_;
  Array<Array<int>> open_, along_, against_;
  bool any_ = false, known_ = false;
};

}  // namespace

void set_by_winches(const machine::Model& model, const EquilibriumOptions& options,
                    const std::optional<machine::State>& start, RopesRun& run) {
  Ways ways(model, machine::hauling_in(model, options.prescribed), options);
  if (!ways.any()) return;
  ways.seek(options, start);
  for (std::size_t r = 0; r < run.flow.size(); ++r) {
    for (std::size_t n = 0; n < run.flow[r].size(); ++n) {
      const auto reeving = static_cast<int>(r), node = static_cast<int>(n);
      if (!ways.is_open(reeving, node)) continue;
      const int sense = sign_of(options.motion) * ways.sense(reeving, node);
      if (sense != 0) {
        run.flow[r][n] = sense;
      } else {
        run.creep[r][n] = run.flow[r][n];
      }
    }
  }
}

}  // namespace taut::solve
