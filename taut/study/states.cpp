#include "taut/study/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/machine/compile/carriage_span.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/study/deck/bounds.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/study/line/terrain_tops.hpp"

namespace taut::study {

const Description& EquilibriumRequest::describe() {
  static const Description d =
      Describe<EquilibriumRequest>()
          .field(&EquilibriumRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&EquilibriumRequest::judge, "judge", "false: its states do not count for the verdict")
          .named_records(&EquilibriumRequest::motion, "motion",
                         "hoist, lower, in, out, at_rest, or a sign for each contact by name: 1 along the path, -1 "
                         "against it, 0 at rest")
          .shorthand("sense")
          .one_for_all()
          .field(&EquilibriumRequest::carriage, "carriage", "the carriage that is placed at x")
          .field(&EquilibriumRequest::x, "x", "x", si::m, "place of the carriage; the quantity that holds it follows")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .field(&EquilibriumRequest::z, "z", "z", si::m,
                 "height of the carriage; the given length or tension of the rope on which it rides follows")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&EquilibriumRequest::along, "along", "", si::one,
                 "horizontal direction [x, y] along which its x is measured, from the origin")
          .field(&EquilibriumRequest::held, "held",
                 "true: something besides the ropes holds the carriage at x; false: where it needs a force along its "
                 "track there is no answer")
          .record(&EquilibriumRequest::given, "given", "a required result, in place of the given quantity of one rope");
  return d;
}

EquilibriumRun resolve(const EquilibriumRequest& request, const DeckPlace& path, Names& names) {
  EquilibriumRun run;
  run.judged = request.judge;
  run.ending = ending_of(names, "equilibrium", request.name, path);
  run.motion = rope_motion(request.motion, names.model, {path, "motion"}, names.complaints);
  run.words = run.motion.words;
  run.held = request.held;
  run.prescribed = prescribed_of(request.carriage, request.x, request.along, path, names);
  if (request.z && !request.x) names.complaints.push_back({path.text(), "'z' needs 'carriage' and 'x'"});
  if (run.prescribed) run.prescribed->z = request.z;
  if (request.z && request.given) {
    names.complaints.push_back(
        {DeckPlace(path, "given").text(), "'z' is in place of what the rope has given already; give one of the two"});
  }
  const auto placed = run.prescribed ? std::optional(run.prescribed->carriage) : std::nullopt;
  if (request.given) run.given = condition_of(*request.given, placed, DeckPlace(path, "given").text(), names);
  return run;
}

namespace {

constexpr double same_direction = 1e-9;  ///< sine of the angle below which two ways of a body are one

int guides_of(const machine::Model& model) {
  std::size_t all = 0;
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Guides& guides : rope.guides) all += guides.all.size();
  }
  return static_cast<int>(all);
}

/// Whether a state has as many parts as the machine: bodies, ropes, their branches, beams.
bool is_state_of(const machine::Model& model, const machine::State& state) {
  const auto branches_fit = [](const machine::Reeving& rope, const Array<machine::BranchState>& branches) {
    return branches.size() + 1 == rope.nodes.size();
  };
  return state.bodies.size() == model.bodies.size() && state.beams.size() == model.beams.size() &&
         std::equal(model.reevings.begin(), model.reevings.end(), state.branches.begin(), state.branches.end(),
                    branches_fit);
}

/// A state of a machine near this one as a first guess for this one: what is not free stands where this machine has it.
machine::State moved_to(const machine::Model& model, machine::State near) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const machine::Body& body = model.bodies[b];
    Array<Vector3> ways;  // unit vectors, square to each other
    bool turns = false;
    for (const machine::Freedom& freedom : body.free) {
      turns = turns || freedom.about.norm() > 0;
      Vector3 way = freedom.along;
      for (const Vector3& other : ways) way -= other.dot(way) * other;
      if (way.norm() > same_direction) ways.push_back(way.normalized());
    }
    const Vector3 from = near.bodies[b].position - body.position;
    near.bodies[b].position = body.position;
    for (const Vector3& way : ways) near.bodies[b].position += way.dot(from) * way;
    if (!turns) near.bodies[b].orientation = body.orientation;
  }
  return near;
}

/// Fills `run.result` for `run.model`.
void solve_once(EquilibriumRun& run) {
  solve::EquilibriumOptions options = run.motion.options(run.model);
  options.prescribed = run.prescribed;
  options.held = run.held;
  const auto from = [&](const std::optional<machine::State>& first) {
    if (run.given) return solve::equilibrium_under(run.model, *run.given, options, first);
    return solve::Conditioned{.model = run.model, .result = solve::equilibrium(run.model, options, first)};
  };
  const bool near = run.near && is_state_of(run.model, *run.near);
  solve::Conditioned found = from(near ? std::optional(moved_to(run.model, *run.near)) : std::nullopt);
  if (near && !found.result.outcome.ok()) found = from(std::nullopt);
  run.model = std::move(found.model);
  run.result = std::move(found.result);
}

}  // namespace

void solve(const machine::Model& model, EquilibriumRun& run) {
  if (run.prescribed) {
    run.model = machine::with_carriage_at(model, run.prescribed->carriage, run.prescribed->x, run.prescribed->along);
    solve_once(run);
    return;
  }
  run.model = machine::with_guides_at_start(model);
  solve_once(run);
  // a carriage that comes to rest on the other side of its guides: once more with those that hold there
  for (int changes = guides_of(model); changes > 0 && !run.result.state.bodies.empty(); --changes) {
    machine::Model there = machine::with_guides_at(run.model, run.result.state);
    if (machine::same_guides(there, run.model)) return;
    run.model = std::move(there);
    solve_once(run);
  }
}

const Description& LoadPathRequest::describe() {
  static const Description d =
      Describe<LoadPathRequest>()
          .field(&LoadPathRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&LoadPathRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&LoadPathRequest::carriage, "carriage", "the carriage that is moved")
          .required()
          .field(&LoadPathRequest::from, "from", "x", si::m, "first place of the carriage")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .required()
          .field(&LoadPathRequest::to, "to", "x", si::m, "last place")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .required()
          .field(&LoadPathRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .field(&LoadPathRequest::along, "along", "", si::one,
                 "horizontal direction [x, y] along which 'from' and 'to' are measured, from the origin")
          .named_records(&LoadPathRequest::motion, "motion", "as for an equilibrium")
          .shorthand("sense")
          .one_for_all()
          .field(&LoadPathRequest::held, "held", "as for an equilibrium, at every position")
          .record(&LoadPathRequest::given, "given", "as for an equilibrium, at every position");
  return d;
}

LoadPathRun resolve(const LoadPathRequest& request, const std::string& path, Names& names) {
  LoadPathRun run;
  run.judged = request.judge;
  run.ending = ending_of(names, "load_path", request.name, path);
  run.motion = rope_motion(request.motion, names.model, {path, "motion"}, names.complaints);
  run.words = run.motion.words;
  const auto carriage = carriage_of(names, request.carriage, path + ".carriage");
  run.way = way_of(carriage, request.along, path, names);
  run.way.from = request.from;
  run.way.to = request.to;
  run.way.steps = request.steps;
  run.held = request.held;
  if (request.given) run.given = condition_of(*request.given, carriage, path + ".given", names);
  if (request.from == request.to && !request.one_place)
    names.complaints.push_back({path + ".to", "is the same place as 'from'"});
  return run;
}

namespace {

LoadPathOptions options_of(const LoadPathRun& run, const WayPart& place) {
  LoadPathOptions options = path_over(run.way, place);
  options.equilibrium = run.motion.options(place.model);
  options.equilibrium.held = run.held;
  options.condition = run.given;
  return options;
}

/// The place nearest to the ground between two neighbouring parts, where it is nearer than the ends of both.
std::optional<LoadPathPart> least_between(const machine::Model& model, const LoadPathRun& run,
                                          const LoadPathPoint& before, const LoadPathPoint& after) {
  if (!before.at.outcome.ok() || !after.at.outcome.ok()) return std::nullopt;
  std::optional<LoadPathPart> least;
  double clearance = std::min(before.clearance, after.clearance);
  const auto place_of = [&](const LoadPathPoint& point) {
    return way_place(model, run.way.carriage, point.x, point.at);
  };
  look_over_tops(model, run.way, place_of(before), place_of(after), [&](machine::Model there, double x) {
    const LoadPathOptions options = options_of(run, {.model = there});
    LoadPathPoint point = load_path_at(there, options, x);
    const WayPlace place = place_of(point);
    if (place.clearance < clearance || (!point.at.outcome.ok() && !least)) {
      clearance = std::min(clearance, place.clearance);
      least = LoadPathPart{.model = std::move(there), .result = {.outcome = point.at.outcome, .points = {point}}};
    }
    return place;
  });
  return least;
}

/// Puts the places over tops between the parts among them.
void add_tops(const machine::Model& model, LoadPathRun& run) {
  if (model.terrain.empty()) return;
  const bool forward = run.way.to > run.way.from;
  std::vector<LoadPathPart> all;
  for (std::size_t i = 0; i < run.parts.size(); ++i) {
    // a place on a support is a part without an answer
    const auto no_answer = [&](const LoadPathPart& part) {
      return part.result.points.size() == 1 && !part.result.points.front().at.outcome.ok();
    };
    std::size_t next = i + 1;
    while (next < run.parts.size() && no_answer(run.parts[next])) ++next;
    std::optional<LoadPathPart> top;
    if (next < run.parts.size()) {
      top = least_between(model, run, run.parts[i].result.points.back(), run.parts[next].result.points.front());
    }
    all.push_back(std::move(run.parts[i]));
    if (!top) continue;
    const double x = top->result.points.front().x;
    for (; i + 1 < next && (run.parts[i + 1].result.points.front().x < x) == forward; ++i)
      all.push_back(std::move(run.parts[i + 1]));
    all.push_back(*std::move(top));
  }
  run.parts = std::move(all);
}

}  // namespace

void solve(const machine::Model& model, LoadPathRun& run, Watch& watch) {
  for (WayPart& place : parts_of(model, run.way)) {
    if (watch.ended()) return;
    LoadPathPart part;
    if (place.support != nullptr) {
      LoadPathPoint point;
      point.x = run.way.x(place.first);
      point.at.outcome = infeasible(fmt::format("the carriage is on '{}'", place.support->name));
      part.result.points.push_back(std::move(point));
    } else {
      LoadPathOptions options = options_of(run, place);
      options.go_on = [&](double x) { return watch.go_on_at(x); };
      part.result = load_path(place.model, options);
      if (part.result.points.empty()) return;
      if (place.last == place.first) part.result.points.resize(1);
    }
    part.model = std::move(place.model);
    run.parts.push_back(std::move(part));
  }
  add_tops(model, run);
}

}  // namespace taut::study
