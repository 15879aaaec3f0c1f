#include "taut/study/payload.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"
#include "taut/calc/none.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/math/index.hpp"
#include "taut/math/roots.hpp"
#include "taut/study/deck/bounds.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/study/line/carriage_way.hpp"
#include "taut/study/line/terrain_tops.hpp"

namespace taut::study {
namespace {

constexpr double first_part = 1.0 / 64;  ///< of the most that is looked for: tried first where nothing is expected
constexpr double more = 1.3;             ///< than expected: likely too much

/// The payload that is looked for: what holds, what does not, and the limit that stops it.
class PayloadSearch {
 public:
  PayloadSearch(const machine::Model& model, int body, const PayloadLimits& limits,
                const solve::EquilibriumOptions& options, const std::optional<machine::State>& start)
      : model_(model), loaded_(model), body_(body), limits_(limits), options_(options), near_(start) {}

  /// The margin of the nearest limit with this payload, and what it is.
  double margin(double mass) {
    loaded_.bodies[body_].mass = model_.bodies[body_].mass + mass;
    solve::EquilibriumResult r = solve::equilibrium(loaded_, options_, near_);
    // friction may act in any of its directions: one without equilibrium is too much, whichever of them is the answer
    if (r.outcome.ok() && !r.unheld.empty()) r.outcome = infeasible(r.unheld);
    LimitState nearest;
    for (const LimitState& one : limits_at(loaded_, body_, limits_, r)) {
      if (one.margin < nearest.margin) nearest = one;
    }
    if (mass == 0 && r.outcome.ok()) unloaded = r.state;
    if (nearest.margin == 0) {
      reached_at = mass;
      reached = nearest;
    }
    if (nearest.margin >= 0 && (!holds || mass >= *holds)) {
      // From states that hold only: under too much a rope of given tension runs out, and what is found from there may
      // hang far below the line even without payload.
      near_ = r.state;
      holds = mass;
      held = nearest;
      result = std::move(r);
    } else if (nearest.margin < 0 && mass <= stops) {
      stops = mass;
      stopped = nearest;
      if (mass == 0) result = std::move(r);
    }
    return nearest.margin;
  }

  std::optional<double> holds;
  double stops = std::numeric_limits<double>::infinity();
  LimitState held, stopped;
  std::optional<double> reached_at;  ///< a payload with which a limit was exactly reached
  LimitState reached;
  solve::EquilibriumResult result;
  std::optional<machine::State> unloaded;

 private:
  const machine::Model& model_;
  machine::Model loaded_;
  int body_;
  const PayloadLimits& limits_;
  const solve::EquilibriumOptions& options_;
  std::optional<machine::State> near_;
};

/// The limit that is reached first: the one that is exactly reached (where the search ends at once, and the least
/// payload known to be too much may be far above, where another limit is nearest; solved once more from there the
/// margin may be a rounding apart), else the one that is exceeded next.
const LimitState& first_reached(const PayloadSearch& search) {
  return search.reached_at && search.reached_at == search.holds ? search.reached : search.stopped;
}

/// A limit that stops the payload, at the payload that still holds.
LimitState governing_of(const LimitState& stopped, const Array<LimitState>& held) {
  const auto same = std::find_if(held.begin(), held.end(), [&](const LimitState& one) {
    return one.kind == stopped.kind && one.reeving == stopped.reeving && one.node == stopped.node;
  });
  return stopped.fails || same == held.end() ? stopped : *same;
}

/// Resolves the limits of one name.
class NamedLimit {
 public:
  NamedLimit(const RopeLimitRequest& request, std::string path, Names& p, PayloadRun& run)
      : request_(request), path_(std::move(path)), p_(p), run_(run) {}

  void resolve() {
    const auto& reevings = p_.model.reevings;
    const auto rope =
        std::find_if(reevings.begin(), reevings.end(), [&](const auto& one) { return one.name == request_.name; });
    const auto& drums = p_.machine.drums;
    const bool drum =
        std::any_of(drums.begin(), drums.end(), [&](const auto& one) { return one.name == request_.name; });
    if (rope != reevings.end()) {
      of_rope(static_cast<int>(rope - reevings.begin()));
    } else if (drum) {
      of_drum();
    } else {
      std::vector<std::string> names;
      names.reserve(reevings.size() + drums.size());
      for (const auto& one : reevings) names.push_back(one.name);
      for (const auto& one : drums) names.push_back(one.name);
      complain("",
               fmt::format("there is no rope and no drum '{}'{}", request_.name, did_you_mean(request_.name, names)));
    }
  }

 private:
  void complain(const std::string& key, std::string message) {
    p_.complaints.push_back({key.empty() ? path_ : path_ + "." + key, std::move(message)});
  }

  void of_rope(int reeving) {
    const machine::Reeving& rope = p_.model.reevings[reeving];
    if (request_.pull) complain("pull", "is a limit of a drum; a rope has 'tension'");
    if (!request_.tension && !request_.safety_factor && !request_.rule && !request_.clearance) {
      complain("", "says no limit: give tension, safety_factor, rule or clearance");
    }
    if ((request_.safety_factor || request_.rule) && rope.breaking_force <= 0) {
      complain(request_.safety_factor ? "safety_factor" : "rule",
               fmt::format("the breaking force of '{}' is not known: give its rope a 'breaking_force'", rope.name));
      return;
    }
    double most = request_.tension.value_or(std::numeric_limits<double>::infinity());
    run_.tensions[reeving] = most;
    if (request_.safety_factor) {
      most = std::min(most, rope.breaking_force / *request_.safety_factor);
      run_.factors.push_back({.reeving = reeving, .factor = *request_.safety_factor});
    }
    if (request_.rule) most = by_rule(reeving, most);
    run_.limits.tension[reeving] = most;
    if (request_.clearance) run_.limits.rope_clearance[reeving] = *request_.clearance;
  }

  /// The limit, the rule's own where there is no other.
  double by_rule(int reeving, double most) {
    const auto row = catalogue::find_rule(*request_.rule);
    if (!row) {
      complain("rule", catalogue::to_text(row.error()));
      return most;
    }
    const auto factor = catalogue::value_of(*row);
    if (!row->id.starts_with("safety.") || row->unit != "1") {
      complain("rule", fmt::format("'{}' is not a safety factor; 'taut list rules --name safety' shows them", row->id));
    } else if (!factor) {
      complain("rule", fmt::format("{}; give a 'safety_factor' within it", factor.error().message));
    } else {
      const auto& table = catalogue::rules();
      const auto same = std::find_if(table.begin(), table.end(), [&](const auto& one) { return one.id == row->id; });
      run_.factors.push_back({reeving, *factor, &*same});
      if (std::isinf(most)) return p_.model.reevings[reeving].breaking_force / *factor;
    }
    return most;
  }

  void of_drum() {
    if (!request_.pull) complain("", "says no limit: a drum has 'pull'");
    for (const auto& [given, key] : {std::pair{request_.tension.has_value(), "tension"},
                                     {request_.safety_factor.has_value(), "safety_factor"},
                                     {request_.rule.has_value(), "rule"},
                                     {request_.clearance.has_value(), "clearance"}}) {
      if (given) complain(key, "is a limit of a rope; a drum has 'pull'");
    }
    bool winds = false;
    for (std::size_t r = 0; r < p_.model.reevings.size(); ++r) {
      const auto& nodes = p_.model.reevings[r].nodes;
      for (const bool at_end : {false, true}) {
        const machine::Node& node = at_end ? nodes.back() : nodes.front();
        if (node.kind != machine::NodeKind::anchor || node.name != request_.name) continue;
        winds = true;
        run_.limits.ends.push_back({static_cast<int>(r), at_end, request_.pull.value_or(1)});
      }
    }
    if (!winds) complain("", fmt::format("no rope is wound on '{}'", request_.name));
  }

  const RopeLimitRequest& request_;
  std::string path_;
  Names& p_;
  PayloadRun& run_;
};

void resolve_limits(const LimitsRequest& request, std::optional<int> carriage, const std::string& path, Names& p,
                    PayloadRun& run) {
  PayloadLimits& l = run.limits;
  l.tension.assign(p.model.reevings.size(), std::numeric_limits<double>::infinity());
  run.tensions = l.tension;
  l.rope_clearance.assign(p.model.reevings.size(), -std::numeric_limits<double>::infinity());
  if (request.clearance) l.clearance = *request.clearance;
  if (request.break_angle) l.break_angle = *request.break_angle;
  if (request.least_break_angle) l.least_break_angle = *request.least_break_angle;
  l.lift_off = request.lift_off;
  if (carriage) l.rated_payload = p.model.carriages[*carriage].rated_payload;
  l.rope_between = {.along = run.way.along, .from = run.way.from, .to = run.way.to};
  if (request.rope_clearance && carriage) {
    l.rope_clearance[p.model.carriages[*carriage].reeving] = *request.rope_clearance;
  }
  for (const RopeLimitRequest& one : request.named) {
    NamedLimit(one, fmt::format("{}.{}", path, one.name), p, run).resolve();
  }
  const auto needs_ground = [&](bool asked, const std::string& key) {
    if (asked && p.model.terrain.empty()) {
      p.complaints.push_back({path + "." + key, "there is no 'terrain' to be clear of"});
    }
  };
  needs_ground(request.clearance.has_value(), "clearance");
  needs_ground(request.rope_clearance.has_value(), "rope_clearance");
  for (const RopeLimitRequest& one : request.named) needs_ground(one.clearance.has_value(), one.name + ".clearance");
  const bool any = !request.named.empty() || request.clearance || request.rope_clearance || request.break_angle ||
                   request.least_break_angle || request.lift_off || l.rated_payload;
  if (!any) p.complaints.push_back({path, "say at least one limit, such as 'skyline: {safety_factor: 3}'"});
}

/// A limit that is negative or no number is never reached, so that nothing would limit the payload.
void expect_limits(const machine::Model& model, const PayloadLimits& limits) {
  const std::size_t ropes = model.reevings.size();
  expects(limits.tension.empty() || limits.tension.size() == ropes, "a limit for every rope");
  for (const double tension : limits.tension) expects(tension > 0, "a limit of a tension is above 0");
  for (const EndLimit& end : limits.ends) {
    expects(end.reeving >= 0 && as_size(end.reeving) < ropes, "a pull is that of a rope of the model");
    expects(end.pull > 0, "a limit of a pull is above 0");
  }
  expects(limits.rope_clearance.empty() || limits.rope_clearance.size() == ropes, "a clearance for every rope");
  for (const double clearance : limits.rope_clearance) expects(!std::isnan(clearance), "a clearance is a number");
  for (const double one : {limits.clearance, limits.break_angle, limits.least_break_angle})
    expects(!std::isnan(one), "a limit is a number");
  expects(!limits.rated_payload || *limits.rated_payload >= 0, "a rated payload is not negative");
  expects(limits.most > 0 && std::isfinite(limits.most), "a largest payload to look for");
}

}  // namespace

Payload payload(const machine::Model& model, int body, const PayloadLimits& limits,
                const solve::EquilibriumOptions& options, const std::optional<machine::State>& start, double expected) {
  expect_limits(model, limits);
  expects(body >= 0 && as_size(body) < model.bodies.size(), "a body of the model");
  expects(expected >= 0 && std::isfinite(expected), "an expected payload is one");
  Payload answer;
  PayloadSearch search(model, body, limits, options, start);
  const double margin = search.margin(0);
  answer.unloaded = search.unloaded;
  if (margin < 0) {
    answer.limit = search.stopped;
    answer.at = std::move(search.result);
    answer.governing = limit_words(model, body, search.stopped);
    answer.reeving = search.stopped.kind == LimitKind::tension ? search.stopped.reeving : std::nullopt;
    answer.outcome = search.stopped.fails
                         ? answer.at.outcome
                         : infeasible(fmt::format("without any payload it is too much already: {}; raise the line, "
                                                  "give it more rope or a stronger one",
                                                  answer.governing));
    return answer;
  }
  // upwards until something stops it
  double tried = std::min(limits.most, expected > 0 ? more * expected : first_part * limits.most);
  while (search.margin(tried) >= 0 && tried < limits.most) tried = std::min(limits.most, 2 * tried);
  if (std::isinf(search.stops)) {
    answer.mass = limits.most;
    answer.governing = fmt::format("no limit below {:.6g} kg", limits.most);
    answer.limit = search.held;
    answer.at = std::move(search.result);
    return answer;
  }
  static_cast<void>(find_root([&](double mass) { return search.margin(mass); }, *search.holds, search.stops));
  answer.mass = *search.holds;
  answer.at = std::move(search.result);
  const LimitState& reached = first_reached(search);
  answer.limit = governing_of(reached, limits_at(model, body, limits, answer.at, answer.mass));
  answer.governing = limit_words(model, body, reached);
  answer.reeving = reached.kind == LimitKind::tension ? reached.reeving : std::nullopt;
  return answer;
}

const Description& RopeLimitRequest::describe() {
  static const Description d =
      Describe<RopeLimitRequest>()
          .field(&RopeLimitRequest::tension, "tension", "T", si::N, "of a rope: its largest tension, anywhere in it")
          .above(0)
          .at_most(strongest)
          .field(&RopeLimitRequest::safety_factor, "safety_factor", "S", si::one,
                 "of a rope: breaking force over its largest tension, at least")
          .above(0)
          .at_most(1000)
          .field(&RopeLimitRequest::rule, "rule",
                 "of a rope: id of a safety factor in the catalogue ('taut list rules'); it is checked, and it is the "
                 "limit if no other is given")
          .field(&RopeLimitRequest::clearance, "clearance", "c", si::m,
                 "of a rope: its least height above the ground between 'from' and 'to'")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&RopeLimitRequest::pull, "pull", "F", si::N, "of a drum: its largest pull")
          .above(0)
          .at_most(strongest);
  return d;
}

const Description& LimitsRequest::describe() {
  static const Description d =
      Describe<LimitsRequest>()
          .field(&LimitsRequest::clearance, "clearance", "c", si::m, "least height of the carriage above the ground")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&LimitsRequest::rope_clearance, "rope_clearance", "c", si::m,
                 "least height above the ground of the rope on which it rides, between 'from' and 'to'")
          .at_least(-farthest)
          .at_most(farthest)
          .field(&LimitsRequest::break_angle, "break_angle", "", si::rad,
                 "largest angle by which a rope bends over a support")
          .above(0)
          .at_most(6.4)
          .field(&LimitsRequest::least_break_angle, "least_break_angle", "", si::rad,
                 "smallest angle by which a rope bends over a support: keeps it in its saddle")
          .at_least(-1.6)
          .at_most(6.4)
          .field(&LimitsRequest::lift_off, "lift_off", "true: no rope may pull a support upwards or leave it")
          .named_records(&LimitsRequest::named, "ropes", "limits of a rope, or of a drum's pull, by its name")
          .rest();
  return d;
}

const Description& PayloadRequest::describe() {
  static const Description d =
      Describe<PayloadRequest>()
          .field(&PayloadRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&PayloadRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&PayloadRequest::carriage, "carriage", "the carriage that carries the payload")
          .required()
          .field(&PayloadRequest::from, "from", "x", si::m, "first place of the carriage")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .required()
          .field(&PayloadRequest::to, "to", "x", si::m, "last place; the same as 'from' for one place")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .required()
          .field(&PayloadRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .field(&PayloadRequest::along, "along", "", si::one, "as for a load path")
          .named_records(&PayloadRequest::motion, "motion", "as for an equilibrium; at rest the band counts")
          .shorthand("sense")
          .one_for_all()
          .field(&PayloadRequest::held, "held", "as for an equilibrium, at every position")
          .record(&PayloadRequest::limits, "limits", "limits, at least one")
          .required()
          .field(&PayloadRequest::most, "most", "m", si::kg, "upper bound of the payload")
          .above(0)
          .at_most(heaviest);
  return d;
}

PayloadRun resolve(const PayloadRequest& request, const std::string& path, Names& names) {
  PayloadRun run;
  run.ending = ending_of(names, "payload", request.name, path);
  run.motion = rope_motion(request.motion, names.model, path + ".motion", names.complaints);
  run.words = run.motion.words;
  run.one_place = request.from == request.to;
  const auto carriage = carriage_of(names, request.carriage, path + ".carriage");
  run.way = way_of(carriage, request.along, path, names);
  run.way.from = request.from;
  run.way.to = request.to;
  run.way.steps = run.one_place ? 1 : request.steps;
  run.limits.most = request.most;
  run.held = request.held;
  resolve_limits(request.limits, carriage, path + ".limits", names, run);
  return run;
}

namespace {

LoadPathOptions options_of(const PayloadRun& run, const WayPart& part) {
  LoadPathOptions options = path_over(run.way, part);
  options.equilibrium = run.motion.options(part.model);
  options.equilibrium.held = run.held;
  return options;
}

PayloadPosition position_of(const machine::Model& model, const PayloadRun& run, PayloadPoint point) {
  const int body = model.carriages[run.way.carriage].body;
  Array<LimitState> states = limits_at(model, body, run.limits, point.payload.at, point.payload.mass);
  return {.model = &model, .point = std::move(point), .states = std::move(states), .support = {}};
}

/// The place between two neighbouring parts that carries least, else is nearest to the ground: where it carries less
/// than the ends of both, or is nearer to the ground.
std::optional<PayloadPosition> least_between(const machine::Model& model, PayloadRun& run, const PayloadPoint& before,
                                             const PayloadPoint& after) {
  std::optional<PayloadPosition> least;
  double mass = std::min(before.payload.mass, after.payload.mass);
  double clearance = std::min(before.clearance, after.clearance);
  const auto place_of = [&](const PayloadPoint& point) {
    return way_place(model, run.way.carriage, point.x, point.payload.at);
  };
  look_over_tops(model, run.way, place_of(before), place_of(after), [&](machine::Model there, double x) {
    const machine::Model& kept = run.over_tops.emplace_back(std::move(there));
    const PayloadPoint point = payload_at(kept, run.limits, options_of(run, {.model = kept}), x);
    const WayPlace place = place_of(point);
    const bool lower = point.payload.mass == mass && place.clearance < clearance;
    if (!point.payload.at.outcome.ok() || point.payload.mass < mass || lower || (!least && place.clearance < clearance))
      least = position_of(kept, run, point);
    mass = std::min(mass, point.payload.mass);
    clearance = std::fmin(clearance, place.clearance);
    return place;
  });
  return least;
}

/// Puts the places over tops between the parts among them.
void add_tops(const machine::Model& model, PayloadRun& run) {
  if (model.terrain.empty()) return;
  const bool forward = run.way.to > run.way.from;
  Array<PayloadPosition> all;
  for (std::size_t i = 0; i < run.positions.size(); ++i) {
    std::size_t next = i + 1;
    while (next < run.positions.size() && !run.positions[next].support.empty()) ++next;
    std::optional<PayloadPosition> top;
    const bool parts_meet = next < run.positions.size() && run.positions[i].model != run.positions[next].model;
    if (parts_meet && run.positions[i].answered() && run.positions[next].answered())
      top = least_between(model, run, run.positions[i].point, run.positions[next].point);
    all.push_back(std::move(run.positions[i]));
    if (!top) continue;
    for (; i + 1 < next && (run.positions[i + 1].point.x < top->point.x) == forward; ++i)
      all.push_back(std::move(run.positions[i + 1]));
    all.push_back(*std::move(top));
  }
  run.positions = std::move(all);
}

}  // namespace

void solve(const machine::Model& model, PayloadRun& run, Watch& watch) {
  run.parts = parts_of(model, run.way);
  for (const WayPart& part : run.parts) {
    if (watch.ended()) break;
    if (part.support != nullptr) {
      PayloadPosition& on = run.positions.emplace_back();
      on.model = &part.model;
      on.support = part.support->name;
      on.point.x = run.way.x(part.first);
      continue;
    }
    LoadPathOptions options = options_of(run, part);
    options.go_on = [&](double x) { return watch.go_on_at(x); };
    auto points = payload_path(part.model, run.limits, options);
    if (part.last == part.first && points.size() > 1) points.resize(1);
    for (PayloadPoint& point : points) run.positions.push_back(position_of(part.model, run, std::move(point)));
  }
  if (run.one_place && run.positions.size() > 1) run.positions.resize(1);
  add_tops(model, run);
}

const Quantities<PayloadPosition>& payload_quantities() {
  using Row = PayloadPosition;
  static const Quantities<Row> all = {
      {"payload", "m", si::kg, "largest mass that may be added to the carriage",
       [](const Row& p) { return p.answered() ? p.point.payload.mass : none; }},
      {"governing", "", si::one, "the limit that is reached first, or why there is no answer", [](const Row& p) {
         if (!p.support.empty()) return fmt::format("on '{}'", p.support);
         return p.answered() ? p.point.payload.governing : p.point.payload.outcome.message;
       }}};
  return all;
}

}  // namespace taut::study
