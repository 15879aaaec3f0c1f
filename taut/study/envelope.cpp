#include "taut/study/envelope.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/solve/quantities.hpp"
#include "taut/study/deck/bounds.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/deck/temperature.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/study/line/rope_clearance.hpp"

namespace taut::study {
namespace {

constexpr double equal = 1e-7;  ///< two extremes, of their size (at least 1 N, m or rad)

class Envelope {
 public:
  void add(const std::string& name, const char* what, const Unit& unit, double value, const EnvelopeState& where) {
    if (std::isnan(value)) return;
    const std::string key = name + " " + what;
    const auto [known, is_new] = index_.try_emplace(key, all.size());
    if (is_new) {
      all.emplace_back();
      all.back().name = name;
      all.back().what = what;
      all.back().unit = unit;
    }
    EnvelopeExtreme& e = all[known->second];
    // of equals the first one: what is left of their equations does not choose the place
    const double same = equal * std::max(1.0, std::abs(value));
    if (value < e.least - same) {
      e.least = value;
      e.at_least = where;
    }
    if (value > e.most + same) {
      e.most = value;
      e.at_most = where;
    }
  }

  std::vector<EnvelopeExtreme> all;  ///< in the order in which they came up

 private:
  std::unordered_map<std::string, std::size_t> index_;
};

void add_force(Envelope& envelope, const std::string& name, const Vector3& force, const EnvelopeState& where) {
  envelope.add(name, "resultant", si::N, force.norm(), where);
  envelope.add(name, "Fx", si::N, force.x(), where);
  envelope.add(name, "Fy", si::N, force.y(), where);
  envelope.add(name, "Fz", si::N, force.z(), where);
}

void add_ropes(Envelope& envelope, const machine::Model& m, const solve::EquilibriumResult& e,
               const EnvelopeState& where) {
  for (const auto& s : e.branches) {
    const machine::Reeving& rope = m.reevings[s.reeving];
    // the lowest point of a branch that has one has the least tension, H
    const double lowest = s.V_from < 0 && s.V_to > 0 ? s.H : s.T_from;
    envelope.add(rope.name, "tension", si::N, std::min({s.T_from_min, s.T_to_min, lowest}), where);
    envelope.add(rope.name, "tension", si::N, std::max(s.T_from_max, s.T_to_max), where);
  }
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    envelope.add(m.reevings[r].name, "unstretched length", si::m, e.ropes[r].unstretched, where);
  }
}

/// What each rope does to what holds its ends, all copies.
void add_anchors(Envelope& envelope, const machine::Model& m, const solve::EquilibriumResult& e,
                 const EnvelopeState& where) {
  const auto add = [&](const solve::BranchResult& s, int n, const Vector3& force) {
    const machine::Reeving& rope = m.reevings[s.reeving];
    const machine::Node& node = rope.nodes[n];
    if (node.kind != machine::NodeKind::anchor) return;
    add_force(envelope, fmt::format("{} on {}", rope.name, node.name), rope.copies * force, where);
  };
  for (const auto& s : e.branches) {
    add(s, s.from, solve::pull_on_start(s));
    add(s, s.to, solve::pull_on_end(s));
  }
}

void add_contacts(Envelope& envelope, const machine::Model& m, const solve::EquilibriumResult& e,
                  const EnvelopeState& where) {
  std::unordered_map<std::string, int> turns;  // a tackle's block has several
  for (const auto& c : e.contacts) {
    const machine::Reeving& rope = m.reevings[c.reeving];
    std::string name = fmt::format("{} on {}", rope.name, rope.nodes[c.node].name);
    if (const int turn = ++turns[name]; turn > 1) name += fmt::format("[{}]", turn);
    envelope.add(name, "T_in", si::N, c.T_in, where);
    envelope.add(name, "T_out", si::N, c.T_out, where);
    envelope.add(name, "wrap", si::rad, c.wrap, where);
    add_force(envelope, name, rope.copies * c.force, where);
  }
}

void add_bodies(Envelope& envelope, const machine::Model& m, const solve::EquilibriumResult& e,
                const EnvelopeState& where) {
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].beam) continue;  // a section of a beam
    const std::string& name = m.bodies[b].name;
    if (m.bodies[b].free.size() < 3) {
      const Vector3& hold = e.reactions[b];
      const std::string words = fmt::format("what holds {}", name);
      add_force(envelope, words, hold, where);
    }
    if (m.bodies[b].free.empty()) continue;
    envelope.add(name, "x", si::m, e.state.bodies[b].position.x(), where);
    envelope.add(name, "z", si::m, e.state.bodies[b].position.z(), where);
  }
}

class Combination {
 public:
  Combination(const machine::Model& model, EnvelopeRun& run, Watch& watch, const EnvelopeStates& seen)
      : model_(model), run_(run), watch_(watch), seen_(seen) {}

  void solve(const RopeMotion& motion, const EnvelopeState& where) {
    machine::Model model = model_;
    if (!std::isnan(where.temperature)) set_temperature(model, *run_.machine, where.temperature);
    if (!std::isnan(where.load)) put_load(model, where.load);
    if (!run_.carriage) {
      if (!watch_.go_on(motion.words)) return;
      model = machine::with_guides_at_start(std::move(model));
      const auto result = solve::equilibrium(model, options_for(motion, model));
      take(model, result, where, fmt::format("envelope, {}", motion.words));
      return;
    }
    RopeSenses senses(run_.winches);
    for (const WayPart& part : parts_of(model, run_.way)) {
      if (watch_.ended()) return;
      if (part.support != nullptr) {
        run_.on_support = true;
        continue;
      }
      LoadPathOptions options = path_over(run_.way, part);
      options.equilibrium = options_for(motion, part.model);
      options.go_on = [&](double x) { return watch_.go_on_at(x); };
      auto path = load_path(part.model, options);
      if (part.last == part.first && path.points.size() > 1) path.points.resize(1);
      senses.take(part.model, path.points);
      for (const auto& point : path.points) {
        EnvelopeState there = where;
        there.x = point.x;
        const std::string words = fmt::format("envelope, {}, x = {}", motion.words, run_.display.brief(point.x, si::m));
        take(part.model, point.at, there, words);
        if (point.at.outcome.ok()) {
          keep("carriage in the ground", -point.clearance, whole_words(words, there), part.model, point.at);
          envelope_.add(model_.carriages[*run_.carriage].name, "clearance", si::m, point.clearance, there);
        }
      }
    }
    const auto contrary = contrary_senses(senses.all());
    if (contrary && warned_.insert(where.motion).second) {
      run_.contrary.push_back(fmt::format("envelope, {}: {}", motion.words, *contrary));
    }
  }

  /// The extremes, and the states that are worst in something.
  void finish() {
    run_.extremes = std::move(envelope_.all);
    std::set<std::string> kept;
    for (auto& [what, one] : worst_) {
      if (kept.insert(one.state.words).second) run_.worst.push_back(std::move(one.state));
    }
  }

 private:
  void put_load(machine::Model& model, double mass) const {
    if (run_.load_point) {
      model.loads.push_back({.at = *run_.load_point, .force = -mass * model.gravity * Vector3::UnitZ(), .mass = mass});
    } else {
      model.bodies[*run_.load_body].mass += mass;
    }
  }

  solve::EquilibriumOptions options_for(const RopeMotion& motion, const machine::Model& model) const {
    solve::EquilibriumOptions options = motion.options(model);
    options.held = run_.held;
    return options;
  }

  void take(const machine::Model& m, const solve::EquilibriumResult& e, const EnvelopeState& where,
            const std::string& words) {
    run_.missing.take(e.outcome, whole_words(words, where));
    if (!e.outcome.ok()) return;
    ++run_.states;
    add(m, e, where);
    for (const solve::EquilibriumResult& bound : e.bounds) add(m, bound, where);
    const std::string all = whole_words(words, where);
    seen_(m, e, all);
    for (std::size_t i = 0; i < e.ropes.size(); ++i) {
      keep(fmt::format("rope {}", i), e.ropes[i].T_max, all, m, e);
    }
    for (std::size_t i = 0; i < e.beams.size(); ++i) {
      const solve::BeamResult& b = e.beams[i];
      const double stress = b.points[b.most_stressed].stress;
      keep(fmt::format("stress of beam {}", i), std::isnan(stress) ? b.points[b.most_bent].M : stress, all, m, e);
      keep(fmt::format("buckling of beam {}", i), 1 / b.least_factor(), all, m, e);
    }
    if (!m.terrain.empty()) keep("rope in the ground", -rope_clearance(m, e).height, all, m, e);
  }

  void add(const machine::Model& m, const solve::EquilibriumResult& e, const EnvelopeState& where) {
    add_ropes(envelope_, m, e, where);
    add_contacts(envelope_, m, e, where);
    add_anchors(envelope_, m, e, where);
    add_bodies(envelope_, m, e, where);
  }

  std::string whole_words(std::string words, const EnvelopeState& where) const {
    if (!std::isnan(where.load)) words += ", " + run_.display.quantity(where.load, si::kg);
    if (!std::isnan(where.temperature)) words += ", " + celsius(where.temperature);
    return words;
  }

  /// Keeps the state if it is the worst in something so far.
  void keep(const std::string& what, double size, const std::string& words, const machine::Model& m,
            const solve::EquilibriumResult& e) {
    if (std::isnan(size)) return;
    const auto [known, is_new] = worst_.try_emplace(what);
    if (!is_new && size <= known->second.size + equal * std::abs(known->second.size)) return;
    known->second = {.size = size, .state = {.words = words, .model = m, .result = e}};
  }

  const machine::Model& model_;
  EnvelopeRun& run_;
  Watch& watch_;
  const EnvelopeStates& seen_;
  Envelope envelope_;
  struct Kept {
    double size = 0;
    WorstState state;
  };
  std::map<std::string, Kept> worst_;
  std::set<std::string> warned_;  ///< motions
};

/// The loads are put on a body, at its centre of mass, or at a point of one.
void put_loads_at(const std::string& name, const std::string& path, Names& p, EnvelopeRun& run) {
  std::vector<std::string> names;
  for (std::size_t b = 0; b < p.model.bodies.size(); ++b) {
    if (p.model.bodies[b].name == name) run.load_body = static_cast<int>(b);
    names.push_back(p.model.bodies[b].name);
  }
  for (const machine::NamedPlace& one : p.model.places) {
    if (one.place.body == machine::ground) continue;
    names.push_back(one.name);
    if (run.load_body || one.name != name) continue;
    run.load_body = one.place.body;
    run.load_point = one.place;
  }
  if (!run.load_body) {
    p.complaints.push_back({path, fmt::format("there is no body or carriage '{}', and no point of one{}", name,
                                              did_you_mean(name, names))});
  } else if (machine::stands_fast(p.model.bodies[*run.load_body])) {
    p.complaints.push_back(
        {path, fmt::format("'{}' cannot move: no rope feels a load on it; say what is 'free' of it", name)});
  }
}

void resolve_loads(const EnvelopeRequest& request, const std::string& path, Names& p, EnvelopeRun& run) {
  run.loads = request.loads;
  if (request.load_at && request.loads.empty()) {
    p.complaints.push_back({path + ".load_at", "there are no 'loads' to put there"});
  }
  if (request.load_at) {
    put_loads_at(*request.load_at, path + ".load_at", p, run);
  } else if (run.carriage) {
    run.load_body = p.model.carriages[*run.carriage].body;
  } else if (!request.loads.empty()) {
    p.complaints.push_back({path + ".loads", "say where: 'load_at' a body, or a 'carriage'"});
  }
}

std::vector<double> or_none(const std::vector<double>& all) { return all.empty() ? std::vector<double>{none} : all; }

}  // namespace

const Description& EnvelopeRequest::describe() {
  static const Description d =
      Describe<EnvelopeRequest>()
          .field(&EnvelopeRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&EnvelopeRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&EnvelopeRequest::carriage, "carriage",
                 "the carriage that is moved; without it the machine as described")
          .field(&EnvelopeRequest::from, "from", "x", si::m, "first place of the carriage")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .field(&EnvelopeRequest::to, "to", "x", si::m, "last place")
          .at_least(-farthest_along)
          .at_most(farthest_along)
          .field(&EnvelopeRequest::steps, "steps", "n", si::one, "equal steps between them")
          .at_least(1)
          .at_most(10000)
          .field(&EnvelopeRequest::along, "along", "", si::one, "as for a load path")
          .field(&EnvelopeRequest::held, "held", "as for an equilibrium, at every position")
          .field(&EnvelopeRequest::load_at, "load_at",
                 "the body or carriage with the loads, at its centre of mass, or a point of one; default: the carriage")
          .field(&EnvelopeRequest::loads, "loads", "m", si::kg, "loads, each in addition to those of the machine")
          .at_least(0)
          .at_most(heaviest)
          .field(&EnvelopeRequest::motions, "motions", "motions; default: at_rest")
          .of({"at_rest", "hoist", "lower", "in", "out"})
          .field(&EnvelopeRequest::temperatures, "temperatures", "", si::K.in("degC"),
                 "temperatures; default: that of the machine")
          .above(0)
          .at_most(2000);
  return d;
}

EnvelopeRun resolve(const EnvelopeRequest& request, const std::string& path, Names& names) {
  EnvelopeRun run;
  run.ending = ending_of(names, "envelope", request.name, path);
  run.machine = &names.machine;
  run.held = request.held;
  if (request.carriage) run.carriage = carriage_of(names, *request.carriage, path + ".carriage");
  if (request.carriage) check_hold(names.model, run.carriage, names.complaints);
  if (request.carriage) run.winches = winches_of(names.model, names.machine, run.carriage);
  const bool all = request.carriage && request.from && request.to;
  const bool nothing = !request.carriage && !request.from && !request.to;
  if (!all && !nothing) {
    names.complaints.push_back({path, "'carriage', 'from' and 'to' belong together"});
  } else if (all && *request.from == *request.to) {
    names.complaints.push_back({path + ".to", "is the same place as 'from'"});
  }
  run.way = {.carriage = run.carriage.value_or(0),
             .from = request.from.value_or(0),
             .to = request.to.value_or(0),
             .steps = request.steps,
             .along = direction_of(request.along, path + ".along", names.complaints)};
  resolve_loads(request, path, names, run);
  run.motions = request.motions.empty() ? std::vector<std::string>{"at_rest"} : request.motions;
  for (const std::string& motion : run.motions) {
    run.rope_motions.push_back(
        rope_motion({{.name = {}, .sense = motion}}, names.model, path + ".motions", names.complaints));
  }
  run.temperatures = request.temperatures;
  if (!run.temperatures.empty()) require_references(names.machine, path + ".temperatures", names.complaints);
  return run;
}

int states_of(const EnvelopeRun& run) {
  const std::size_t combinations = or_none(run.temperatures).size() * or_none(run.loads).size() * run.motions.size();
  return static_cast<int>(combinations) * (run.carriage ? run.way.steps + 1 : 1);
}

void solve(const machine::Model& model, EnvelopeRun& run, Watch& watch, const EnvelopeStates& seen) {
  Combination one(model, run, watch, seen);
  for (const double temperature : or_none(run.temperatures)) {
    for (const double load : or_none(run.loads)) {
      for (std::size_t i = 0; i < run.motions.size(); ++i) {
        one.solve(run.rope_motions[i], {.x = none, .load = load, .motion = run.motions[i], .temperature = temperature});
      }
    }
  }
  one.finish();
}

Quantities<EnvelopeExtreme> envelope_quantities(const Unit& unit) {
  using Row = EnvelopeExtreme;
  Quantities<Row> all = {{"name", "", si::one, "what it belongs to", &Row::name},
                         {"quantity", "", si::one, "what it is; forces of all copies", &Row::what}};
  const auto add = [&](const std::string& end, double Row::*value, EnvelopeState Row::*state, const char* words) {
    all.emplace_back(end, "", unit, words, value);
    all.emplace_back(end + "_x", "x", si::m, "place of the carriage there", [=](const Row& r) { return (r.*state).x; });
    all.emplace_back(end + "_load", "m", si::kg, "load there", [=](const Row& r) { return (r.*state).load; });
    all.emplace_back(end + "_motion", "", si::one, "motion there", [=](const Row& r) { return (r.*state).motion; });
    all.emplace_back(end + "_temperature", "", si::K.in("degC"), "temperature there",
                     [=](const Row& r) { return (r.*state).temperature; });
  };
  add("min", &Row::least, &Row::at_least, "least value over all states");
  add("max", &Row::most, &Row::at_most, "largest value over all states");
  return all;
}

}  // namespace taut::study
