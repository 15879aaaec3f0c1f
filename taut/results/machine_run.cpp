#include "taut/results/machine_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/calc/shown.hpp"
#include "taut/checks/checked_parts.hpp"

namespace taut::results {
namespace {

/// "equilibrium, at rest", "equilibrium inhaul, in".
std::string heading(const char* kind, const std::string& ending, const std::string& words) {
  const std::string name = ending.empty() ? std::string() : ending.substr(1);
  const bool tells = !name.empty() && name != words;
  return fmt::format("{}{}{}, {}", kind, tells ? " " : "", tells ? name : "", words);
}

/// "at rest", "inhaul, in": a state by the name of its analysis, where it has one.
std::string state_words(const char* kind, const std::string& ending, const std::string& words) {
  return ending.empty() ? words : fmt::format("{}, {}", checks::analysis_words(ending, kind), words);
}

/// "load path, haulback -1, x = 100 m", "sag, haulback -1, x = 100 m": a place of a load path by the name of the path.
std::string place_words(const study::LoadPathRun& one, const study::LoadPathPoint& point, const Display& display) {
  return fmt::format("{}, {}, x = {}", checks::analysis_words(one.ending, "load path"), one.words,
                     display.brief(point.x, si::m));
}

}  // namespace

std::vector<Answer> answers_of(const MachineRun& run) {
  std::vector<Answer> all;
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (one.result.outcome.ok()) all.push_back({&one.model, &one.result, nullptr, state_words(one), one.judged});
  }
  for (const study::LoadPathRun& one : run.paths) {
    for (const study::LoadPathPart& part : one.parts) {
      for (const auto& point : part.result.points) {
        if (!point.at.outcome.ok()) continue;
        all.push_back({&part.model, &point.at, &point, place_words(one, point, run.display), one.judged});
      }
    }
  }
  for (const bool explores : {false, true}) {
    for (const OtherAnswer& one : run.others) {
      if (one.explores == explores && (!explores || all.empty())) {
        all.push_back({&one.model, &one.result, nullptr, one.words, one.judged});
      }
    }
  }
  return all;
}

std::vector<Answer> pictured_of(const MachineRun& run) {
  std::vector<Answer> all = answers_of(run);
  for (const OtherAnswer& one : run.others) {
    const bool there = std::any_of(all.begin(), all.end(), [&](const Answer& a) { return a.result == &one.result; });
    if (!there && one.judged) all.push_back({&one.model, &one.result, nullptr, one.words, true});
  }
  return all;
}

Strain strain_of(const machine::Model& model, const solve::EquilibriumResult& state) {
  Strain most{0, 0};
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const double T = state.ropes[i].T_max, strength = model.reevings[i].breaking_force;
    most.second = std::max(most.second, T);
    if (strength > 0) most.first = std::max(most.first, T / strength);
  }
  return most;
}

std::string strained_more(const MachineRun& run, const Strain& strain, const Result& r) {
  if (!run.judges) return {};
  const auto& ropes = run.model.reevings;
  const bool by_share =
      std::any_of(ropes.begin(), ropes.end(), [](const auto& rope) { return rope.breaking_force > 0; });
  double most = by_share ? strain.first : strain.second;
  std::string words;
  for (const machine::Reeving& rope : ropes) {
    const Value* T = r.find_value(rope.name + ".T_max");
    if (T == nullptr || (by_share && !(rope.breaking_force > 0))) continue;
    const double own = by_share ? T->value / rope.breaking_force : T->value;
    if (!shown_below(most, own)) continue;  // places of a payload share its limit but for rounding
    most = own;
    words = fmt::format("{}, {}", T->label, run.display.brief(T->value, si::N));
  }
  return words;
}

std::string heading_of(const MachineRun& run, const study::EquilibriumRun& one) {
  return run.several ? heading("equilibrium", one.ending, one.words) : std::string();
}

std::string heading_of(const MachineRun& run, const study::LoadPathRun& one) {
  return run.several ? heading("load path", one.ending, one.words) : std::string();
}

std::string state_words(const study::EquilibriumRun& one) {
  return state_words(one.kind.c_str(), one.ending, one.words);
}

std::string path_words(const study::LoadPathRun& one) { return state_words("load path", one.ending, one.words); }

void show_answers(const MachineRun& run, checks::CheckedParts& checked) {
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (!one.result.outcome.ok() || !one.judged) continue;
    const std::string name = checks::analysis_name(one.ending, one.kind.c_str());
    checked.take(one.model, one.result, state_words(one), name);
  }
  for (const study::LoadPathRun& one : run.paths) {
    if (!one.judged) continue;
    for (const study::LoadPathPart& part : one.parts) {
      for (const auto& point : part.result.points) {
        if (!point.at.outcome.ok()) continue;
        checked.take(part.model, point.at, place_words(one, point, run.display),
                     checks::analysis_name(one.ending, "load_path"));
      }
    }
  }
}

}  // namespace taut::results
