#include "taut/solve/condition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"
#include "taut/math/roots.hpp"

namespace taut::solve {
namespace {

using Kind = Condition::Kind;

double end_tension(const EquilibriumResult& r, int reeving, bool at_end) {
  double T = 0;
  for (const BranchResult& s : r.branches) {
    if (s.reeving != reeving) continue;
    if (!at_end) return s.T_from;
    T = s.T_to;
  }
  return T;
}

/// Whether the rope's own length or tension is what is given: no search.
bool direct(Kind kind) {
  return kind == Kind::tension_at_start || kind == Kind::tension_at_end || kind == Kind::length;
}

constexpr double first_step = 1e-3;         ///< of the length, of the tension's logarithm
constexpr double search_tolerance = 1e-12;  ///< a taut span's sag goes with many times its length's error
constexpr double least_step = 1e-7;
constexpr double beyond = 1.1;     ///< of the way to where a search expects its answer
constexpr double most_growth = 8;  ///< of its step
constexpr double met = 1e-11;      ///< of the value sought: what the tolerance of the search leaves open
constexpr int most_search_steps = 60;

/// The condition as a number that is to vanish, against a change u of what is given: length L (1 + u), tension T e^u.
class ConditionSearch {
 public:
  ConditionSearch(const machine::Model& model, const Condition& condition, EquilibriumOptions options,
                  const std::optional<machine::State>& start)
      : condition_(condition),
        options_(std::move(options)),
        near_(start),
        first_(model.reevings[condition.reeving].value) {
    best.model = model;
  }

  /// NaN where there is no equilibrium; 0 where it is met to rounding.
  double operator()(double u) {
    const auto known = std::find_if(tried_.begin(), tried_.end(), [&](const auto& one) { return one.first == u; });
    if (known != tried_.end()) return known->second;
    return tried_.emplace_back(u, search(u)).second;
  }

  /// Why there is no equilibrium where there was none last; ok where there always was one. Which beam buckles, and by
  /// how much, is found here only.
  Outcome failure() const {
    if (failed_.ok() || best.model.beams.empty()) return failed_;
    EquilibriumOptions telling = options_;
    telling.beam_factors = true;
    const Outcome told = equilibrium(varied(failed_at_), telling, near_).outcome;
    return told.ok() ? failed_ : told;
  }

  /// u of the rope's length in a state; 0 where its tension is given.
  double change_to(const machine::State& state) const {
    const machine::Reeving& rope = best.model.reevings[condition_.reeving];
    if (rope.given != machine::Given::length) return 0;
    const auto free_rope = [&](const machine::State& s) {
      double sum = 0;
      for (const machine::BranchState& branch : s.branches[condition_.reeving]) sum += branch.length;
      return sum;
    };
    // rope on arcs is in neither sum
    const double u = (free_rope(state) - free_rope(machine::initial_state(best.model))) / first_;
    return u > -1 ? u : 0;
  }

  Conditioned best;
  double best_misfit = std::numeric_limits<double>::infinity();

 private:
  machine::Model varied(double u) const {
    machine::Model model = best.model;
    machine::Reeving& rope = model.reevings[condition_.reeving];
    rope.value = rope.given == machine::Given::length ? first_ * (1 + u) : first_ * std::exp(u);
    return model;
  }

  double search(double u) {
    machine::Model model = varied(u);
    EquilibriumResult r = equilibrium(model, options_, near_);
    if (!r.outcome.ok()) {
      failed_ = r.outcome;
      failed_at_ = u;
      return std::nan("");
    }
    near_ = r.state;
    const double open = misfit(model, r);
    if (!(std::abs(open) > best_misfit)) {
      best_misfit = std::abs(open);
      best = {.model = std::move(model), .result = std::move(r)};
    }
    return std::abs(open) <= met * std::abs(condition_.value) ? 0 : open;
  }

  double misfit(const machine::Model& model, const EquilibriumResult& r) const {
    switch (condition_.kind) {
      case Kind::sag_at_carriage:
        return sag_of_carriage(model, r, options_.prescribed->carriage) - condition_.value;
      case Kind::sag_of_span: {
        int n = 0;
        for (const BranchResult& s : r.branches) {
          if (s.reeving == condition_.reeving && n++ == condition_.span) return sag_at_middle(s) - condition_.value;
        }
        return std::nan("");
      }
      case Kind::tension_of:
        return end_tension(r, condition_.of.front(), condition_.at_end) - condition_.value;
      case Kind::length_of: {
        double length = -condition_.value;
        for (const int rope : condition_.of) length += r.ropes[rope].unstretched;
        return length;
      }
      default:
        break;
    }
    // along the track; its horizontal part keeps its sign
    return r.hold.norm() * (r.hold.dot(options_.prescribed->along) < 0 ? -1 : 1);
  }

  Condition condition_;
  EquilibriumOptions options_;
  std::optional<machine::State> near_;
  double first_;
  Outcome failed_;                          ///< where there was no equilibrium last
  double failed_at_ = 0;                    ///< u there
  Array<std::pair<double, double>> tried_;  ///< u and what was open there
};

/// A change u, and what is open there.
struct Tried {
  double u = 0;
  double open = 0;
};

/// From a place on, one way, until the sign changes: steps a little beyond where the last two places meet zero, or that
/// double where they do not. Where there is no equilibrium steps are quarters of the way there, so that the last one
/// that holds is found too.
std::optional<std::pair<double, double>> bracket(ConditionSearch& search, const Tried& from, double way) {
  double known = from.u, at_known = from.open, step = first_step, none = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_search_steps && step > least_step; ++i) {
    const double next = known + way * step;
    const double open = next > -1 ? search(next) : std::nan("");
    if (std::isnan(open)) {
      none = std::abs(next - from.u);
      step /= 4;
      continue;
    }
    if ((open < 0) != (from.open < 0)) return std::minmax(known, next);
    const double to_zero = open / (at_known - open) * step;
    const double longer =
        to_zero > 0 ? std::clamp(beyond * to_zero, std::max(step / 4, 2 * least_step), most_growth * step) : 2 * step;
    known = next;
    at_known = open;
    step = std::min(longer, (none - std::abs(known - from.u)) / 2);
    if (std::abs(known) > 20) break;
  }
  return std::nullopt;
}

/// At the length that the rope has in a state near by, else as it is given.
Tried beginning(ConditionSearch& search, const std::optional<machine::State>& near) {
  const double u = near ? search.change_to(*near) : 0;
  const double open = search(u);
  return u != 0 && std::isnan(open) ? Tried{.u = 0, .open = search(0)} : Tried{.u = u, .open = open};
}

/// First the way in which the condition should be met, then the other one; but not away from an equilibrium that came
/// nearer to it, behind which there is none.
std::optional<std::pair<double, double>> bracket_both(ConditionSearch& search, const Tried& from, double way,
                                                      Kind kind) {
  if (from.open == 0) return std::pair(from.u, from.u);
  if (auto found = bracket(search, from, way)) return found;
  const bool nearer = search.best_misfit < std::abs(from.open);
  return nearer && kind != Kind::free_running ? std::nullopt : bracket(search, from, -way);
}

std::string_view words(Kind kind) {
  switch (kind) {
    case Kind::free_running:
      return "where the carriage stands by itself";
    case Kind::tension_of:
      return "with this winch pull";
    case Kind::length_of:
      return "with this length of the loop";
    default:
      return "with this sag";
  }
}

}  // namespace

double sag_at_middle(const BranchResult& branch) {
  const double half = std::hypot(branch.shape.chord.x(), branch.shape.chord.y()) / 2;
  if (branch.slack || branch.shape.rope.weight <= 0 || half == 0) return 0;  // on a plumb line there is no sag
  return rope::sag_at(branch.shape, half);
}

double sag_of_carriage(const machine::Model& model, const EquilibriumResult& r, int carriage) {
  const machine::Carriage& car = model.carriages.at(as_size(carriage));
  const BranchResult *before = nullptr, *after = nullptr;
  // a carriage of several rollers has spans of its own between them
  const auto& nodes = model.reevings[car.reeving].nodes;
  const auto rides = [&](int node) { return nodes[node].at.body == car.body; };
  for (const BranchResult& s : r.branches) {
    if (s.reeving != car.reeving || rides(s.from) == rides(s.to)) continue;
    if (rides(s.to) && s.to <= car.node) before = &s;
    if (rides(s.from) && s.from >= car.node && after == nullptr) after = &s;
  }
  expects(before != nullptr && after != nullptr, "a carriage rides on its rope");
  const Vector3& place = r.state.bodies[car.body].position;
  const Vector3 chord = after->end - before->start;
  const double way = chord.x() * chord.x() + chord.y() * chord.y();
  const Vector3 from = place - before->start;
  const double part = way > 0 ? (from.x() * chord.x() + from.y() * chord.y()) / way : 0;
  return before->start.z() + part * chord.z() - place.z();
}

Conditioned equilibrium_under(const machine::Model& model, const Condition& condition,
                              const EquilibriumOptions& options, const std::optional<machine::State>& start) {
  expects(condition.reeving >= 0 && as_size(condition.reeving) < model.reevings.size(), "a rope of the model");
  const bool by_carriage = condition.kind == Kind::sag_at_carriage || condition.kind == Kind::free_running;
  expects(!by_carriage || options.prescribed, "a condition at a carriage needs its place");
  expects(!start || machine::is_of(model, *start), "a start is a state of this model");
  if (direct(condition.kind)) {
    Conditioned done{.model = model, .result = {}};
    machine::Reeving& rope = done.model.reevings[condition.reeving];
    rope.given = condition.kind == Kind::length             ? machine::Given::length
                 : condition.kind == Kind::tension_at_start ? machine::Given::tension_at_start
                                                            : machine::Given::tension_at_end;
    rope.value = condition.value;
    done.result = equilibrium(done.model, options, start);
    return done;
  }
  EquilibriumOptions plain = options;
  plain.band = plain.beam_factors = false;
  plain.held = true;
  plain.tolerance = std::min(options.tolerance, search_tolerance);
  ConditionSearch search(model, condition, plain, start);
  const std::string& name = model.reevings[condition.reeving].name;
  const Tried first = beginning(search, start);
  if (std::isnan(first.open)) {
    search.best.result.outcome = search.failure();
    return search.best;
  }
  const bool by_length = model.reevings[condition.reeving].given == machine::Given::length;
  // more sag, or rope in a loop: more length, less tension
  const bool more = (first.open < 0) != (condition.kind == Kind::tension_of);
  const double way = more == by_length ? 1 : -1;
  const auto between = bracket_both(search, first, way, condition.kind);
  if (!between) {
    const Outcome failed = search.failure();
    search.best.result.outcome = infeasible(
        fmt::format("no {} of '{}' found {}{}{}", by_length ? "length" : "tension", name, words(condition.kind),
                    failed.ok() ? "" : ": beyond some there is no equilibrium: ", failed.message));
    return search.best;
  }
  static_cast<void>(find_root([&](double u) { return search(u); }, between->first, between->second));
  EquilibriumOptions found = options;
  found.held = true;
  const bool beams = options.beam_factors && !model.beams.empty();
  if (options.band || beams) search.best.result = equilibrium(search.best.model, found, search.best.result.state);
  // where it stands by itself is what was looked for
  if (!options.held && condition.kind != Kind::free_running && search.best.result.outcome.ok()) {
    search.best.result.outcome = stands_by_itself(search.best.model, options, search.best.result);
  }
  return search.best;
}

machine::Model installed(const machine::Model& model, const EquilibriumResult& result) {
  expects(result.outcome.ok() && result.ropes.size() == model.reevings.size(), "a result of this machine");
  machine::Model frozen = machine::with_sides(model, result.state);
  for (std::size_t r = 0; r < frozen.reevings.size(); ++r) {
    frozen.reevings[r].given = machine::Given::length;
    frozen.reevings[r].value = result.ropes[r].unstretched;
  }
  return frozen;
}

}  // namespace taut::solve
