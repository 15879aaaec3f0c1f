#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "taut/calc/none.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/checks/rope/rope_sense.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/results/missing.hpp"
#include "taut/study/carriage_way.hpp"
#include "taut/study/watch.hpp"

namespace taut::results {
namespace {

struct Phase {
  study::PhaseRequest request;
  study::Way way;
  double speed = none;  ///< m/s
};

struct CycleRun {
  std::string ending;
  int carriage = 0;
  bool held = false;
  std::vector<Phase> phases;
  std::vector<checks::Winch> winches;
};

/// One winch at one position.
struct Pull {
  double tension = 0;  ///< of a drive: by how much the rope is tighter behind it than before it, N
  double paid = 0;     ///< rope that is out, as it passes the winch: stretched; of a drive what has passed it, m
};

struct CyclePosition {
  double x = 0, z = none;
  double way = 0;  ///< of the carriage since the phase began, m
  std::vector<Pull> pulls;
  bool known = false;
};

/// What a winch does in a phase.
struct Work {
  double pull_max = 0, pull_mean = 0;  ///< N
  double at = none;                    ///< x of the carriage at the largest pull
  double taken = 0;                    ///< rope taken in (out: negative), m
  double energy = 0;                   ///< done by the winch, J; negative: braked
  double power_max = none;             ///< W
};

/// Rope without tension, at its temperature, between a drive and the clamped carriage on it; 0 where nothing is clamped
/// to it.
double passed(const solve::EquilibriumResult& e, const machine::Model& m, int reeving) {
  double length = 0;
  for (const auto& s : e.spans) {
    if (s.reeving != reeving) continue;
    const machine::Reeving& rope = m.reevings[reeving];
    length += s.unstretched * (1 + rope.thermal_strain);
    if (rope.nodes[s.to].kind == machine::NodeKind::clamp) return length;
  }
  return 0;
}

Pull pull_of(const machine::Model& m, const solve::EquilibriumResult& e, const checks::Winch& w) {
  const machine::Reeving& rope = m.reevings[w.reeving];
  if (w.drive) {
    const auto drive = std::find_if(e.contacts.begin(), e.contacts.end(),
                                    [&](const auto& c) { return c.reeving == w.reeving && c.node == 0; });
    const double mean = (drive->T_in + drive->T_out) / 2;
    return {drive->T_in - drive->T_out, passed(e, m, w.reeving) * (1 + mean / rope.stiffness)};
  }
  const auto own = [&](const auto& s) { return s.reeving == w.reeving; };
  const double T = w.at_end ? std::find_if(e.spans.rbegin(), e.spans.rend(), own)->T_to
                            : std::find_if(e.spans.begin(), e.spans.end(), own)->T_from;
  return {T, e.ropes[w.reeving].unstretched * (1 + rope.thermal_strain)};
}

/// A part of the way with the carriage in one span, solved; without points where it is on a support.
struct Stretch {
  double x = 0;  ///< where it begins, m
  bool on_support = false;
  machine::Model model;
  std::vector<study::LoadPathPoint> points;
};

/// The way of the carriage, part by part.
std::vector<Stretch> stretches_of(const MachineRun& machine, const CycleRun& run, const Phase& phase,
                                  const std::vector<study::MotionRequest>& motion, study::Watch& watch) {
  machine::Model loaded = machine.model;
  loaded.bodies[loaded.carriages[run.carriage].body].mass += phase.request.load;
  std::vector<Stretch> all;
  for (const study::WayPart& part : study::parts_of(loaded, phase.way)) {
    if (watch.ended()) break;
    Stretch& one = all.emplace_back(Stretch{phase.way.x(part.first), part.support != nullptr, part.model, {}});
    if (part.support != nullptr) continue;
    std::vector<Complaint> reported_before;
    study::LoadPathOptions options = study::path_over(phase.way, part);
    options.equilibrium = study::options_of(motion, part.model, {}, reported_before);
    options.equilibrium.band = false;
    options.equilibrium.held = run.held;
    options.go_on = [&watch](double x) { return watch.go_on_at(x); };
    one.points = study::load_path(part.model, options).points;
    if (part.last == part.first && one.points.size() > 1) one.points.resize(1);
  }
  return all;
}

/// The motion of a phase with the senses of contacts on ropes that no winch drives: a word such as `in` is about the
/// hauled ropes, and a skyline runs over its carriage and its supports as the carriage goes. Against the sense declared
/// all the way: the other one; to and fro, or after a first correction: none. Empty where nothing is to be changed.
std::vector<study::MotionRequest> with_own_senses(const machine::Model& m,
                                                  const std::vector<study::MotionRequest>& motion,
                                                  const std::vector<checks::RopeSense>& senses, bool again) {
  if (motion.empty() || motion.front().name.empty() == again) return {};
  std::vector<study::MotionRequest> all = motion;
  if (!again) {
    if (motion.size() != 1) return {};
    all.clear();
    for (const machine::Reeving& rope : m.reevings) all.push_back({rope.name, motion.front().sense});
  }
  const std::size_t declared = all.size();
  for (const checks::RopeSense& s : senses) {
    if (s.driven || s.given == 0) continue;
    const bool none = again || s.taken > 0;
    all.push_back({s.contact, none ? "0" : s.declared > 0 ? "-1" : "1"});
  }
  return all.size() == declared ? std::vector<study::MotionRequest>{} : all;
}

std::vector<checks::RopeSense> senses_of(const CycleRun& run, const std::vector<Stretch>& stretches) {
  checks::RopeSenses found(run.winches);
  for (const Stretch& one : stretches) found.take(one.model, one.points);
  return found.all();
}

/// Whether a rope that no winch drives loses tension somewhere: what its senses are, shows only as the carriage goes.
bool has_senses_of_its_own(const machine::Model& m, const std::vector<checks::Winch>& winches) {
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    const auto reeving = static_cast<int>(r);
    if (std::any_of(winches.begin(), winches.end(), [&](const checks::Winch& w) { return w.reeving == reeving; }))
      continue;
    const std::vector<machine::Node>& nodes = m.reevings[r].nodes;
    if (std::any_of(nodes.begin(), nodes.end(), [](const machine::Node& n) {
          return n.kind == machine::NodeKind::contact && n.law.friction > 0 && n.law.efficiency < 1;
        })) {
      return true;
    }
  }
  return false;
}

constexpr int most_times = 3;  ///< that a phase is solved: as declared, and twice with senses found

/// A phase as it is solved, with the senses of its ropes. Empty where it was to end before they were known.
std::vector<Stretch> solved(const MachineRun& machine, const CycleRun& run, const Phase& phase, study::Watch& watch,
                            std::vector<checks::RopeSense>& senses) {
  const bool own_senses = has_senses_of_its_own(machine.model, run.winches);
  std::vector<study::MotionRequest> motion = phase.request.motion;
  for (int time = 1;; ++time) {
    std::vector<Stretch> all = stretches_of(machine, run, phase, motion, watch);
    senses = senses_of(run, all);
    if (!own_senses || time == most_times) return all;
    if (watch.ended()) {
      senses.clear();
      return {};
    }
    std::vector<study::MotionRequest> own = with_own_senses(machine.model, motion, senses, time > 1);
    if (own.empty()) return all;
    motion = std::move(own);
  }
}

/// The positions of a phase; one on a support is passed over.
std::vector<CyclePosition> positions_of(const MachineRun& machine, const CycleRun& run, const Phase& phase,
                                        const std::vector<Stretch>& stretches, Missing& missing) {
  std::vector<CyclePosition> all;
  for (const Stretch& part : stretches) {
    if (part.on_support) all.emplace_back().x = part.x;
    for (const auto& point : part.points) {
      CyclePosition& p = all.emplace_back();
      p.x = point.x;
      p.known = point.at.outcome.ok();
      missing.take(point.at.outcome, point.x);
      if (!p.known) continue;
      p.z = point.z;
      machine.checked->take(part.model, point.at, fmt::format("cycle, {}, x = {:.6g} m", phase.request.name, point.x),
                            checks::analysis_name(run.ending, "cycle"));
      for (const checks::Winch& w : run.winches) p.pulls.push_back(pull_of(part.model, point.at, w));
    }
  }
  const CyclePosition* before = nullptr;
  double way = 0;
  for (CyclePosition& p : all) {
    if (!p.known) continue;
    if (before != nullptr) way += std::hypot(p.x - before->x, p.z - before->z);
    p.way = way;
    before = &p;
  }
  return all;
}

/// Trapezoids from position to position: dW = T (1 + T/EA) dL for a drum, T dL for a drive. `turn`: the last position
/// of the phase before, where this one begins with the same load. Between them the winches change the pulls until
/// friction acts the other way, the carriage at rest; without that work the winches of a closed cycle do not end with
/// the rope that they began with, and friction may seem to give energy.
Work work_of(const machine::Model& m, const CycleRun& run, std::size_t winch, const CyclePosition* turn,
             const std::vector<CyclePosition>& all, double speed) {
  const checks::Winch& w = run.winches[winch];
  const double EA = m.reevings[w.reeving].stiffness;
  const auto stretch = [&](double T) { return w.drive ? 1.0 : 1 + T / EA; };
  Work work;
  const CyclePosition* before = turn;
  double mean = 0;
  for (const CyclePosition& p : all) {
    if (!p.known) continue;
    const double T = p.pulls[winch].tension;
    if (std::isnan(work.at) || std::abs(T) > std::abs(work.pull_max)) {
      work.pull_max = T;
      work.at = p.x;
    }
    if (before != nullptr) {
      const double T0 = before->pulls[winch].tension;
      const double paid = p.pulls[winch].paid - before->pulls[winch].paid;
      const double way = before == turn ? 0 : p.way - before->way;
      const double energy = -(T0 * stretch(T0) + T * stretch(T)) / 2 * paid;
      work.taken -= (stretch(T0) + stretch(T)) / 2 * paid;
      work.energy += energy;
      mean += (T0 + T) / 2 * way;
      if (way > 0 && !std::isnan(speed)) {
        const double power = energy / way * speed;
        if (std::isnan(work.power_max) || std::abs(power) > std::abs(work.power_max)) work.power_max = power;
      }
    }
    before = &p;
  }
  const double way = before != nullptr && before != turn ? before->way : 0;
  work.pull_mean = way > 0 ? mean / way : work.pull_max;
  return work;
}

struct PhaseAnswer {
  std::vector<CyclePosition> positions;
  std::vector<Work> works;
  std::vector<checks::RopeSense> senses;
  double way = 0;
  double time = none;
};

/// The last position of the phase before (of the last phase before the first), where a phase begins there with the same
/// load; null elsewhere.
const CyclePosition* turn_before(const CycleRun& run, const std::vector<PhaseAnswer>& answers, std::size_t phase) {
  const std::size_t before = (phase + run.phases.size() - 1) % run.phases.size();
  if (before >= answers.size()) return nullptr;
  const std::vector<CyclePosition>&ends = answers[before].positions, &begins = answers[phase].positions;
  const bool same = !ends.empty() && !begins.empty() && ends.back().known && begins.front().known &&
                    ends.back().x == begins.front().x &&
                    run.phases[before].request.load == run.phases[phase].request.load;
  return same ? &ends.back() : nullptr;
}

Table positions_table(const CycleRun& run, const std::vector<PhaseAnswer>& answers) {
  Table t{"cycle" + run.ending,
          "Pulls over the cycle",
          {{"phase", si::one}, {"x", si::m}, {"z", si::m}, {"way", si::m}},
          {}};
  for (const checks::Winch& w : run.winches) t.columns.push_back({w.name + ".pull", si::N});
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (const CyclePosition& p : answers[i].positions) {
      std::vector<Cell> row = {run.phases[i].request.name, p.x, p.z, p.known ? p.way : none};
      for (const Pull& pull : p.pulls) row.emplace_back(pull.tension);
      row.resize(t.columns.size(), none);
      t.rows.push_back(std::move(row));
    }
  }
  return t;
}

Table works_table(const CycleRun& run, const std::vector<PhaseAnswer>& answers) {
  Table t{
      "cycle_work" + run.ending,
      "What each winch does in each phase; rope and energy are negative where it lets the rope out against its pull",
      {{"phase", si::one},
       {"winch", si::one},
       {"pull_max", si::N},
       {"x", si::m},
       {"pull_mean", si::N},
       {"rope_taken_in", si::m},
       {"energy", si::J},
       {"power_max", si::W},
       {"duration", si::s}},
      {}};
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (std::size_t w = 0; w < answers[i].works.size(); ++w) {
      const Work& work = answers[i].works[w];
      t.rows.push_back({run.phases[i].request.name, run.winches[w].name, work.pull_max, work.at, work.pull_mean,
                        work.taken, work.energy, work.power_max, answers[i].time});
    }
  }
  return t;
}

void add_values(const CycleRun& run, const std::vector<PhaseAnswer>& answers, Result& r) {
  const auto add = [&](const std::string& name, double v, const Unit& unit, const std::string& words) {
    r.values.push_back({name + run.ending, v, unit, name, words, {}});
  };
  double energy = 0, time = 0;
  for (std::size_t w = 0; w < run.winches.size(); ++w) {
    double most = 0, own = 0, power = none;
    for (const PhaseAnswer& answer : answers) {
      const Work& work = answer.works[w];
      if (std::abs(work.pull_max) > std::abs(most)) most = work.pull_max;
      own += work.energy;
      if (!std::isnan(work.power_max) && (std::isnan(power) || work.power_max > power)) power = work.power_max;
    }
    const std::string& name = run.winches[w].name;
    add(name + ".pull_max", most, si::N, fmt::format("largest pull of {} over the cycle", name));
    add(name + ".energy", own, si::J, fmt::format("energy that {} gives in the cycle", name));
    if (!std::isnan(power)) add(name + ".power_max", power, si::W, fmt::format("largest power of {}", name));
    energy += own;
  }
  for (const PhaseAnswer& answer : answers) time += answer.time;
  add("cycle_energy", energy, si::J, "energy of all winches in the cycle, what brakes take off it taken off");
  if (!std::isnan(time)) add("cycle_time", time, si::s, "time of all phases at their speeds");
}

void add_plot(const CycleRun& run, const std::vector<PhaseAnswer>& answers, Result& r) {
  Plot p;
  p.name = "cycle_pulls" + run.ending;
  p.title = "Pulls over the cycle";
  p.x = {"x of the carriage", si::m};
  p.y = {"pull", si::N};
  for (std::size_t w = 0; w < run.winches.size(); ++w) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      Curve c;
      c.label = fmt::format("{}, {}", run.winches[w].name, run.phases[i].request.name);
      for (const CyclePosition& position : answers[i].positions) {
        c.x.push_back(position.x);
        c.y.push_back(position.known ? position.pulls[w].tension : none);
      }
      p.curves.push_back(std::move(c));
    }
  }
  r.figures.emplace_back(std::move(p));
}

/// Friction takes energy. Where a rope runs against the motion declared it gives some: a share of the winches' energy
/// that can be seen is refused. Whether there is such a phase.
bool refuse_given_energy(const CycleRun& run, const std::vector<PhaseAnswer>& answers, Result& r) {
  constexpr double seen = 5e-5;  // of the largest energy of a winch in any phase
  double largest = 0;
  for (const PhaseAnswer& answer : answers) {
    for (const Work& work : answer.works) {
      if (!std::isnan(work.energy)) largest = std::max(largest, std::abs(work.energy));
    }
  }
  bool some = false;
  for (std::size_t i = 0; i < answers.size() && largest > 0; ++i) {
    const double given = checks::energy_given(answers[i].senses);
    if (given <= seen * largest) continue;
    some = true;
    std::string where, senses;
    for (const checks::RopeSense& s : checks::giving(answers[i].senses)) {
      where += fmt::format("{}{} over {}", where.empty() ? "" : ", ", s.rope, s.contact);
      senses += fmt::format("{}{}: {}", senses.empty() ? "" : ", ", s.contact, s.taken > 0 ? 0 : -s.declared);
    }
    note_failure(r,
                 infeasible(fmt::format("a rope runs against the declared motion, so that friction gives {:.3g} kJ "
                                        "({}): declare the senses of these contacts, as in 'motion: {{{}}}' (0: "
                                        "without loss)",
                                        given / 1e3, where, senses)),
                 fmt::format("cycle{}, {}", run.ending, run.phases[i].request.name));
  }
  return some;
}

void solve(MachineRun& machine, const CycleRun& run, Result& r) {
  std::vector<PhaseAnswer> answers;
  bool complete = true, gives = false;  // friction, energy
  int states = 0;
  const int times = has_senses_of_its_own(machine.model, run.winches) ? most_times : 1;
  for (const Phase& phase : run.phases) states += times * (phase.way.steps + 1);
  study::Watch watch(machine.progress, "cycle" + run.ending, states);
  for (const Phase& phase : run.phases) {
    if (watch.ended()) break;
    Missing missing;
    PhaseAnswer& answer = answers.emplace_back();
    const std::vector<Stretch> stretches = solved(machine, run, phase, watch, answer.senses);
    answer.positions = positions_of(machine, run, phase, stretches, missing);
    const std::string words = fmt::format("cycle{}, {}", run.ending, phase.request.name);
    missing.note(r, words, machine.checked->judged);
    complete = complete && !missing.any();
    if (const auto wrong = checks::wrong_senses(answer.senses)) {
      note_failure(r, infeasible(*wrong), words);
      gives = true;
    }
    for (const CyclePosition& p : answer.positions) answer.way = std::max(answer.way, p.way);
    if (!std::isnan(phase.speed)) answer.time = answer.way / phase.speed;
  }
  const std::size_t whole = answers.size() - (watch.ended() ? 1 : 0);
  for (std::size_t i = 0; i < whole; ++i) {
    const CyclePosition* turn = turn_before(run, answers, i);
    for (std::size_t w = 0; w < run.winches.size(); ++w) {
      answers[i].works.push_back(work_of(machine.model, run, w, turn, answers[i].positions, run.phases[i].speed));
    }
  }
  watch.note(r);
  gives = refuse_given_energy(run, answers, r) || gives;
  if (complete && !gives) r.tables.push_back(works_table(run, answers));  // else no machine does this work
  r.tables.push_back(positions_table(run, answers));
  if (r.status != Status::ok || !complete) return;  // no sums over what is not there
  add_values(run, answers, r);
  add_plot(run, answers, r);
}

}  // namespace

Analysis prepare_cycle(const study::CycleRequest& request, const std::string& path, Preparation& p) {
  const auto run = std::make_shared<CycleRun>();
  run->ending = ending_of(p, "cycle", request.name, path);
  run->carriage = carriage_of(p, request.carriage, path + ".carriage");
  run->held = request.held;
  study::check_hold(p.model, run->carriage, p.complaints);
  const Vector3 along = study::direction_of(request.along, path + ".along", p.complaints);
  double from = request.from, to = request.to;
  for (std::size_t i = 0; i < request.phases.size(); ++i) {
    const std::string at = fmt::format("{}.phases[{}]", path, i);
    const study::PhaseRequest& one = request.phases[i];
    study::options_of(one.motion, p.model, at + ".motion", p.complaints);
    Phase phase{one, {run->carriage, one.from.value_or(from), one.to.value_or(to), request.steps, along}, none};
    if (one.speed || request.speed) phase.speed = one.speed ? *one.speed : *request.speed;
    if (phase.way.from == phase.way.to) p.complaints.push_back({at, "its carriage does not move"});
    // the next one goes back
    from = phase.way.to;
    to = phase.way.from;
    run->phases.push_back(std::move(phase));
  }
  run->winches = checks::winches_of(p.model, p.machine, run->carriage);
  if (run->winches.empty()) {
    p.complaints.push_back({path, "nothing pulls: no rope ends on a drum, has a tension given, or is a mainline"});
  }
  return [run](MachineRun& machine, Result& r) { solve(machine, *run, r); };
}

}  // namespace taut::results
