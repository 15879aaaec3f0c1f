#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>

#include "taut/base/suggest.hpp"
#include "taut/calc/none.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/checks/rope/rope_sense.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/results/missing.hpp"
#include "taut/study/carriage_way.hpp"
#include "taut/study/rope_clearance.hpp"
#include "taut/study/temperature.hpp"
#include "taut/study/watch.hpp"

namespace taut::results {
namespace {

constexpr double equal = 1e-7;  ///< two extremes, of their size (at least 1 N, m or rad)

/// One combination of load, motion and temperature, and a place.
struct Where {
  double x = none;
  double load = none;
  std::string motion;
  double temperature = none;
};

struct EnvelopeRun {
  std::string ending;
  int carriage = -1;
  study::Way way;
  int load_body = -1;
  bool held = false;
  std::vector<double> loads;
  std::vector<std::string> motions;
  std::vector<double> temperatures;
  const machine::Machine* machine = nullptr;
  std::vector<checks::Winch> winches;
};

/// A quantity at its least and at its most.
struct Extreme {
  std::string name, what;
  Unit unit;
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  Where at_least, at_most;
};

class Envelope {
 public:
  void add(const std::string& name, const char* what, const Unit& unit, double value, const Where& where) {
    if (std::isnan(value)) return;
    const std::string key = name + " " + what;
    const auto [known, is_new] = index_.try_emplace(key, all.size());
    if (is_new) {
      all.emplace_back();
      all.back().name = name;
      all.back().what = what;
      all.back().unit = unit;
    }
    Extreme& e = all[known->second];
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

  std::vector<Extreme> all;  ///< in the order in which they came up

 private:
  std::unordered_map<std::string, std::size_t> index_;
};

void add_force(Envelope& envelope, const std::string& name, const Vector3& force, const Where& where) {
  envelope.add(name, "resultant", si::N, force.norm(), where);
  envelope.add(name, "Fx", si::N, force.x(), where);
  envelope.add(name, "Fy", si::N, force.y(), where);
  envelope.add(name, "Fz", si::N, force.z(), where);
}

void add_ropes(Envelope& envelope, const machine::Model& m, const solve::EquilibriumResult& e, const Where& where) {
  for (const auto& s : e.spans) {
    const machine::Reeving& rope = m.reevings[s.reeving];
    envelope.add(rope.name, "tension", si::N, std::min(s.T_from, s.T_to), where);
    envelope.add(rope.name, "tension", si::N, std::max(s.T_from, s.T_to), where);
  }
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    envelope.add(m.reevings[r].name, "unstretched length", si::m, e.ropes[r].unstretched, where);
  }
}

/// What each rope does to what holds its ends, all copies.
void add_anchors(Envelope& envelope, const machine::Model& m, const solve::EquilibriumResult& e, const Where& where) {
  const auto add = [&](const solve::SpanResult& s, int n, const Vector3& force) {
    const machine::Reeving& rope = m.reevings[s.reeving];
    const machine::Node& node = rope.nodes[n];
    if (node.kind != machine::NodeKind::anchor) return;
    add_force(envelope, fmt::format("{} on {}", rope.name, node.name), rope.copies * force, where);
  };
  for (const auto& s : e.spans) {
    add(s, s.from, pull_on_start(s));
    add(s, s.to, pull_on_end(s));
  }
}

void add_contacts(Envelope& envelope, const machine::Model& m, const solve::EquilibriumResult& e, const Where& where) {
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

void add_bodies(Envelope& envelope, const machine::Model& m, const solve::EquilibriumResult& e, const Where& where) {
  for (std::size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].beam >= 0) continue;  // a section of a beam
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

/// All that is asked of one combination.
class Combination {
 public:
  Combination(MachineRun& machine, const EnvelopeRun& run, Envelope& envelope, study::Watch& watch, Result& r)
      : machine_(machine), run_(run), envelope_(envelope), watch_(watch), r_(r) {}

  void solve(const Where& where) {
    machine::Model model = machine_.model;
    if (!std::isnan(where.temperature)) study::set_temperature(model, *run_.machine, where.temperature);
    if (!std::isnan(where.load)) model.bodies[run_.load_body].mass += where.load;
    const std::vector<study::MotionRequest> motion = {{{}, where.motion}};
    if (run_.carriage < 0) {
      if (!watch_.go_on(words_of(motion))) return;
      const auto result = solve::equilibrium(model, options_for(motion, model));
      take(model, result, where, fmt::format("envelope, {}", words_of(motion)));
      return;
    }
    checks::RopeSenses senses(run_.winches);
    for (const study::WayPart& part : study::parts_of(model, run_.way)) {
      if (watch_.ended()) return;
      if (part.support != nullptr) {
        on_support_ = true;
        continue;
      }
      study::LoadPathOptions options = study::path_over(run_.way, part);
      options.equilibrium = options_for(motion, part.model);
      options.go_on = [&](double x) { return watch_.go_on_at(x); };
      auto path = study::load_path(part.model, options);
      if (part.last == part.first && path.points.size() > 1) path.points.resize(1);
      senses.take(part.model, path.points);
      for (const auto& point : path.points) {
        Where there = where;
        there.x = point.x;
        const std::string words = fmt::format("envelope, {}, x = {:.6g} m", words_of(motion), point.x);
        take(part.model, point.at, there, words);
        if (point.at.outcome.ok()) {
          keep("carriage in the ground", -point.clearance, whole_words(words, there), part.model, point.at);
          envelope_.add(machine_.model.carriages[run_.carriage].name, "clearance", si::m, point.clearance, there);
        }
      }
    }
    const auto contrary = checks::contrary_senses(senses.all());
    if (contrary && warned_.insert(where.motion).second) {
      warn_unsafe(r_, fmt::format("envelope, {}: {}", words_of(motion), *contrary));
    }
  }

  /// The states that are worst in something: what the rest of the result tells of the largest and least is of them.
  void keep_worst() {
    std::set<std::string> kept;
    for (auto& [what, one] : worst_) {
      if (kept.insert(one.answer.words).second) machine_.others.push_back(std::move(one.answer));
    }
  }

  bool on_support() const { return on_support_; }
  const Missing& missing() const { return missing_; }
  int states() const { return states_; }

 private:
  solve::EquilibriumOptions options_for(const std::vector<study::MotionRequest>& motion,
                                        const machine::Model& model) const {
    std::vector<Complaint> reported_before;
    solve::EquilibriumOptions options = study::options_of(motion, model, {}, reported_before);
    options.band = false;
    options.held = run_.held;
    return options;
  }

  void take(const machine::Model& m, const solve::EquilibriumResult& e, const Where& where, const std::string& words) {
    missing_.take(e.outcome, whole_words(words, where));
    if (!e.outcome.ok()) return;
    ++states_;
    add_ropes(envelope_, m, e, where);
    add_contacts(envelope_, m, e, where);
    add_anchors(envelope_, m, e, where);
    add_bodies(envelope_, m, e, where);
    const std::string all = whole_words(words, where);
    machine_.checked->take(m, e, all, checks::analysis_name(run_.ending, "envelope"));
    for (std::size_t i = 0; i < e.ropes.size(); ++i) {
      keep(fmt::format("rope {}", i), e.ropes[i].T_max, all, m, e);
    }
    for (std::size_t i = 0; i < e.beams.size(); ++i) {
      const solve::BeamResult& b = e.beams[i];
      const double stress = b.points[b.most_stressed].stress;
      keep(fmt::format("stress of beam {}", i), std::isnan(stress) ? b.points[b.most_bent].M : stress, all, m, e);
      keep(fmt::format("buckling of beam {}", i), 1 / b.critical_factor, all, m, e);
    }
    if (!m.terrain.empty()) keep("rope in the ground", -study::rope_clearance(m, e).height, all, m, e);
  }

  static std::string whole_words(std::string words, const Where& where) {
    if (!std::isnan(where.load)) words += fmt::format(", {:.6g} kg", where.load);
    if (!std::isnan(where.temperature)) words += ", " + study::celsius(where.temperature);
    return words;
  }

  /// Keeps the state if it is the worst in something so far.
  void keep(const std::string& what, double size, const std::string& words, const machine::Model& m,
            const solve::EquilibriumResult& e) {
    if (std::isnan(size)) return;
    const auto [known, is_new] = worst_.try_emplace(what);
    if (!is_new && size <= known->second.size + equal * std::abs(known->second.size)) return;
    known->second = {size, {words, m, e}};
  }

  MachineRun& machine_;
  const EnvelopeRun& run_;
  Envelope& envelope_;
  study::Watch& watch_;
  Result& r_;
  struct Kept {
    double size = 0;
    OtherAnswer answer;
  };
  std::map<std::string, Kept> worst_;
  std::set<std::string> warned_;  ///< motions
  int states_ = 0;
  bool on_support_ = false;
  Missing missing_;
};

Table table_of(const EnvelopeRun& run, const Envelope& envelope, const std::string& kind, const Unit& unit) {
  Table t{fmt::format("envelope{}{}", kind, run.ending), "Least and largest over all states, and where", {}, {}};
  t.columns = {{"name", si::one}, {"quantity", si::one}};
  for (const char* end : {"min", "max"}) {
    t.columns.push_back({end, unit});
    t.columns.push_back({fmt::format("{}_x", end), si::m});
    t.columns.push_back({fmt::format("{}_load", end), si::kg});
    t.columns.push_back({fmt::format("{}_motion", end), si::one});
    t.columns.push_back({fmt::format("{}_temperature", end), si::K.in("degC")});
  }
  for (const Extreme& e : envelope.all) {
    if (e.unit.symbol != unit.symbol) continue;
    t.rows.push_back({e.name, e.what, e.least, e.at_least.x, e.at_least.load, e.at_least.motion, e.at_least.temperature,
                      e.most, e.at_most.x, e.at_most.load, e.at_most.motion, e.at_most.temperature});
  }
  return t;
}

void solve(MachineRun& machine, const EnvelopeRun& run, Result& r) {
  Envelope envelope;
  const auto or_none = [](const std::vector<double>& all) { return all.empty() ? std::vector<double>{none} : all; };
  const std::size_t combinations = or_none(run.temperatures).size() * or_none(run.loads).size() * run.motions.size();
  const int states = run.carriage < 0 ? 1 : run.way.steps + 1;
  study::Watch watch(machine.progress, "envelope" + run.ending, static_cast<int>(combinations) * states);
  Combination one(machine, run, envelope, watch, r);
  for (const double temperature : or_none(run.temperatures)) {
    for (const double load : or_none(run.loads)) {
      for (const std::string& motion : run.motions) one.solve({none, load, motion, temperature});
    }
  }
  watch.note(r);
  one.missing().note(r, "envelope" + run.ending, machine.checked->judged);
  if (one.on_support()) r.warnings.emplace_back("envelope: positions on a support are left out");
  if (envelope.all.empty()) return;
  r.tables.push_back(table_of(run, envelope, "", si::N));
  r.tables.push_back(table_of(run, envelope, "_lengths", si::m));
  r.tables.push_back(table_of(run, envelope, "_angles", si::rad));
  if (r.tables.back().rows.empty()) r.tables.pop_back();
  r.values.push_back({"envelope_states" + run.ending,
                      static_cast<double>(one.states()),
                      si::one,
                      "n",
                      "states of the envelope that were solved",
                      {}});
  for (const Extreme& e : envelope.all) {
    if (e.what != "tension") continue;
    const auto add = [&](const char* end, double value, const char* words) {
      const std::string name = fmt::format("{}.T_{}_envelope{}", e.name, end, run.ending);
      r.values.push_back(
          {name, value, si::N, name, fmt::format("{} tension of {} over the envelope", words, e.name), {}});
    };
    add("min", e.least, "least");
    add("max", e.most, "largest");
  }
  one.keep_worst();
}

void resolve_loads(const study::EnvelopeRequest& request, const std::string& path, Preparation& p, EnvelopeRun& run) {
  run.loads = request.loads;
  if (request.load_at && request.loads.empty()) {
    p.complaints.push_back({path + ".load_at", "there are no 'loads' to put there"});
  }
  if (request.load_at) {
    std::vector<std::string> names;
    for (std::size_t b = 0; b < p.model.bodies.size(); ++b) {
      if (p.model.bodies[b].name == *request.load_at) run.load_body = static_cast<int>(b);
      names.push_back(p.model.bodies[b].name);
    }
    if (run.load_body < 0) {
      p.complaints.push_back({path + ".load_at", fmt::format("there is no body or carriage '{}'{}", *request.load_at,
                                                             did_you_mean(*request.load_at, names))});
    }
  } else if (run.carriage >= 0) {
    run.load_body = p.model.carriages[run.carriage].body;
  } else if (!request.loads.empty()) {
    p.complaints.push_back({path + ".loads", "say where: 'load_at' a body, or a 'carriage'"});
  }
}

}  // namespace

Analysis prepare_envelope(const study::EnvelopeRequest& request, const std::string& path, Preparation& p) {
  const auto run = std::make_shared<EnvelopeRun>();
  run->ending = ending_of(p, "envelope", request.name, path);
  run->machine = &p.machine;
  run->held = request.held;
  if (request.carriage) run->carriage = carriage_of(p, *request.carriage, path + ".carriage");
  if (request.carriage) study::check_hold(p.model, run->carriage, p.complaints);
  if (request.carriage) run->winches = checks::winches_of(p.model, p.machine, run->carriage);
  const bool all = request.carriage && request.from && request.to;
  const bool nothing = !request.carriage && !request.from && !request.to;
  if (!all && !nothing) {
    p.complaints.push_back({path, "'carriage', 'from' and 'to' belong together"});
  } else if (all && *request.from == *request.to) {
    p.complaints.push_back({path + ".to", "is the same place as 'from'"});
  }
  run->way = {run->carriage, request.from.value_or(0), request.to.value_or(0), request.steps,
              study::direction_of(request.along, path + ".along", p.complaints)};
  resolve_loads(request, path, p, *run);
  run->motions = request.motions.empty() ? std::vector<std::string>{"at_rest"} : request.motions;
  run->temperatures = request.temperatures;
  if (!run->temperatures.empty()) study::require_references(p.machine, path + ".temperatures", p.complaints);
  return [run](MachineRun& machine, Result& r) { solve(machine, *run, r); };
}

}  // namespace taut::results
