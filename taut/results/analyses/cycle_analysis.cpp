#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "taut/calc/answers.hpp"
#include "taut/calc/none.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/described.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/study/line/carriage_way.hpp"

namespace taut::results {
namespace {

/// Of one winch at one place.
const Quantities<study::WinchPull>& pull_of_winch() {
  static const Quantities<study::WinchPull> all = {
      {"pull", "F", si::N, "pull of that winch", &study::WinchPull::tension}};
  return all;
}

Table positions_table(const study::CycleRun& run) {
  Table t{.name = "cycle" + run.ending, .title = "Pulls over the cycle", .columns = {}, .rows = {}, .detail = true};
  add_columns(t.columns, study::cycle_quantities());
  for (const study::Winch& w : run.winches) add_columns(t.columns, pull_of_winch(), w.name + ".");
  for (std::size_t i = 0; i < run.answers.size(); ++i) {
    for (const study::CyclePosition& p : run.answers[i].positions) {
      std::vector<Cell>& row = t.rows.emplace_back();
      add_cells(row, study::cycle_quantities(), study::CycleRow{.phase = run.phases[i], .position = p});
      for (const study::WinchPull& pull : p.pulls) add_cells(row, pull_of_winch(), pull);
      row.resize(t.columns.size(), none);
    }
  }
  return t;
}

Table works_table(const study::CycleRun& run) {
  std::vector<study::WinchRow> rows;
  for (std::size_t i = 0; i < run.answers.size(); ++i) {
    const study::PhaseAnswer& answer = run.answers[i];
    for (std::size_t w = 0; w < answer.works.size(); ++w) {
      rows.push_back({run.phases[i], run.winches[w], answer.works[w], answer.time});
    }
  }
  return make_table(
      "cycle_work" + run.ending,
      "What each winch does in each phase; rope and energy are negative where it lets the rope out against its pull",
      study::winch_quantities(), rows);
}

/// The power of all ropes on one drum together, from one place to the next.
struct NetPower {
  double power = none;  ///< W; negative: braked
  std::string phase;
  double from = none, to = none;  ///< x of the carriage, m
};

/// Of these winches, over the whole cycle.
std::vector<NetPower> net_powers(const study::CycleRun& run, const std::vector<std::size_t>& winches) {
  std::vector<NetPower> all;
  for (std::size_t i = 0; i < run.answers.size(); ++i) {
    const study::PhaseAnswer& answer = run.answers[i];
    double before = none;
    for (std::size_t p = 0; p < answer.positions.size(); ++p) {
      if (!answer.positions[p].known) continue;
      NetPower& here = all.emplace_back(
          NetPower{.power = 0, .phase = run.phases[i].name, .from = before, .to = answer.positions[p].x});
      for (const std::size_t w : winches) here.power += answer.works[w].powers[p];
      before = here.to;
    }
  }
  std::erase_if(all, [](const NetPower& one) { return std::isnan(one.power); });
  return all;
}

/// Each drum on which several ropes wind. What one rope lets out under its pull helps to take the other one in, so the
/// powers of the ropes add up, and the largest ones need not come together. A drum that only brakes has its largest
/// braked power.
void add_shared_drums(const study::CycleRun& run, const Display& display, std::vector<std::string>& parts, Result& r) {
  std::map<std::string, std::vector<std::size_t>> shared;
  for (std::size_t w = 0; w < run.winches.size(); ++w) {
    if (!run.winches[w].shared.empty()) shared[run.winches[w].shared].push_back(w);
  }
  for (const auto& [drum, winches] : shared) {
    const std::vector<NetPower> all = net_powers(run, winches);
    if (all.empty()) continue;
    const auto [least, most] = std::minmax_element(
        all.begin(), all.end(), [](const NetPower& a, const NetPower& b) { return a.power < b.power; });
    const NetPower& net = most->power < 0 ? *least : *most;
    std::string names;
    for (const std::size_t w : winches) names += (names.empty() ? "" : " and ") + run.winches[w].name;
    const std::string when =
        fmt::format("{}, x = {} to {}", net.phase, display.brief(net.from, si::m), display.brief(net.to, si::m));
    r.values.push_back(make_value(named(value_kinds(), "WINCH.power_max"), drum, run.ending, net.power,
                                  fmt::format("largest net power of {}: {} together ({})", drum, names, when)));
    parts.push_back(fmt::format("{} net power up to {} ({})", drum, display.brief(net.power, si::W), when));
  }
}

void add_values(const study::CycleRun& run, const Display& display, Result& r) {
  const auto add = [&](const char* name, const std::string& winch, double v, const std::string& words) {
    r.values.push_back(make_value(named(value_kinds(), name), winch, run.ending, v, words));
  };
  const auto about = [](const char* name) { return named(value_kinds(), name).about.words; };
  double energy = 0, time = 0;
  std::vector<std::string> parts;
  for (std::size_t w = 0; w < run.winches.size(); ++w) {
    double most = 0, own = 0, power = none, braked = none;
    for (const study::PhaseAnswer& answer : run.answers) {
      const study::WinchWork& work = answer.works[w];
      if (std::abs(work.pull_max) > std::abs(most)) most = work.pull_max;
      own += work.energy;
      if (!std::isnan(work.power_given) && (std::isnan(power) || work.power_given > power)) power = work.power_given;
      if (!std::isnan(work.power_max) && (std::isnan(braked) || work.power_max < braked)) braked = work.power_max;
    }
    if (power < 0) power = braked;  // a winch that only brakes
    const std::string& name = run.winches[w].name;
    add("WINCH.pull_max", name, most, fmt::format("largest pull of {} over the cycle", name));
    add("WINCH.energy", name, own, fmt::format("energy that {} gives in the cycle", name));
    if (!std::isnan(power)) add("WINCH.power_max", name, power, fmt::format("largest power of {}", name));
    energy += own;
    const std::string at_power = std::isnan(power) ? "" : ", power up to " + display.brief(power, si::W);
    parts.push_back(fmt::format("{} pull up to {}{}", name, display.brief(most, si::N), at_power));
  }
  add_shared_drums(run, display, parts, r);
  for (const study::PhaseAnswer& answer : run.answers) time += answer.time;
  add("cycle_energy", "", energy, about("cycle_energy"));
  if (!std::isnan(time)) add("cycle_time", "", time, about("cycle_time"));
  parts.push_back(fmt::format("cycle {}{}", display.brief(energy, si::J),
                              std::isnan(time) ? "" : " in " + display.brief(time, si::s)));
  add_answer_line(r, "Winches", parts);
}

void add_plot(const study::CycleRun& run, Result& r) {
  Plot p;
  p.name = "cycle_pulls" + run.ending;
  p.title = "Pulls over the cycle";
  p.x = {.label = "x of the carriage", .unit = si::m};
  p.y = {.label = "pull", .unit = si::N};
  for (std::size_t w = 0; w < run.winches.size(); ++w) {
    for (std::size_t i = 0; i < run.answers.size(); ++i) {
      Curve c;
      c.label = fmt::format("{}, {}", run.winches[w].name, run.phases[i].name);
      for (const study::CyclePosition& position : run.answers[i].positions) {
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
bool refuse_given_energy(const study::CycleRun& run, Result& r) {
  constexpr double seen = 5e-5;  // of the largest energy of a winch in any phase
  double largest = 0;
  for (const study::PhaseAnswer& answer : run.answers) {
    for (const study::WinchWork& work : answer.works) {
      if (!std::isnan(work.energy)) largest = std::max(largest, std::abs(work.energy));
    }
  }
  bool some = false;
  for (std::size_t i = 0; i < run.answers.size() && largest > 0; ++i) {
    const double given = study::energy_given(run.answers[i].senses);
    if (given <= seen * largest) continue;
    some = true;
    std::string where, senses;
    for (const study::RopeSense& s : study::giving(run.answers[i].senses)) {
      where += fmt::format("{}{} over {}", where.empty() ? "" : ", ", s.rope, s.contact);
      senses += fmt::format("{}{}: {}", senses.empty() ? "" : ", ", s.contact, s.taken > 0 ? 0 : -s.declared);
    }
    study::note_failure(
        r,
        infeasible(fmt::format("a rope runs against the declared motion, so that friction gives {} ({}): "
                               "declare the senses of these contacts, as in 'motion: {{{}}}' (0: without loss)",
                               run.display.brief(given, si::J), where, senses)),
        fmt::format("cycle{}, {}", run.ending, run.phases[i].name));
  }
  return some;
}

}  // namespace

std::vector<QuantityWords> cycle_words() {
  std::vector<QuantityWords> all = words_of(study::cycle_quantities());
  for (QuantityWords& one : prefixed("WINCH.", words_of(pull_of_winch()))) all.push_back(std::move(one));
  return all;
}

void add_answer(const study::CycleRun& asked, MachineRun& machine, Result& r) {
  study::CycleRun run = asked;
  run.display = machine.display;
  study::Watch watch(machine.progress, "cycle" + run.ending, states_of(run), machine.display);
  study::solve(machine.model, run, watch,
               [&](const machine::Model& model, const study::LoadPathPoint& point, const study::Phase& phase) {
                 machine.checked->take(
                     model, point.at,
                     fmt::format("cycle, {}, x = {}", phase.name, machine.display.brief(point.x, si::m)),
                     checks::analysis_name(run.ending, "cycle"));
               });
  bool complete = true, gives = false;  // friction, energy
  for (std::size_t i = 0; i < run.answers.size(); ++i) {
    const study::PhaseAnswer& answer = run.answers[i];
    const std::string words = fmt::format("cycle{}, {}", run.ending, run.phases[i].name);
    if (const auto left_out = study::left_out_words(machine.model, run.phases[i].way, machine.display)) {
      r.warnings.push_back(fmt::format("{}: {}", words, *left_out));
    }
    answer.missing.note(r, words, machine.checked->judged);
    complete = complete && !answer.missing.any();
    if (const auto wrong = study::wrong_senses(answer.senses, machine.display)) {
      study::note_failure(r, infeasible(*wrong), words);
      gives = true;
    }
  }
  watch.note(r);
  gives = refuse_given_energy(run, r) || gives;
  if (complete && !gives) r.tables.push_back(works_table(run));  // else no machine does this work
  r.tables.push_back(positions_table(run));
  if (r.status != Status::ok || !complete) return;  // no sums over what is not there
  add_values(run, machine.display, r);
  add_plot(run, r);
}

}  // namespace taut::results
