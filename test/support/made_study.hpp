#pragma once
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "taut/app/cases/case_values.hpp"
#include "taut/app/cases/study/study.hpp"
#include "taut/app/cases/study/study_result.hpp"

/// Studies without a deck behind them: their outputs are functions whose statistics are known in closed form.
namespace taut_test {

using Outputs = std::function<std::vector<double>(const taut::chance::Point&)>;

/// A study of a function without a sample yet. Inputs are called `machine.x1.value` and so on, outputs `y1` and so on,
/// all plain numbers; a case whose first output is NaN has no answer.
inline taut::app::Study made_study(const std::vector<taut::chance::Distribution>& laws, std::size_t outputs,
                                   Outputs f) {
  taut::app::Study study;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    study.model.inputs.push_back(
        {.path = fmt::format("machine.x{}.value", i + 1), .unit = taut::si::one, .range = {}, .base = 0});
  }
  for (std::size_t k = 0; k < outputs; ++k) {
    study.model.outputs.push_back({.name = fmt::format("y{}", k + 1), .unit = taut::si::one, .label = {}});
  }
  study.inputs.of = laws;
  study.model.answer = [f = std::move(f)](std::span<const double> values) {
    taut::app::CaseAnswer answer{.outputs = f({values.begin(), values.end()}), .outcome = {}};
    if (std::isnan(answer.outputs.front())) answer.outcome = taut::infeasible("the function has no value there");
    return answer;
  };
  return study;
}

/// The sample, and behind it the cases of the indices and of the tornado where these are asked for.
inline taut::app::Study sampled(taut::app::Study study, taut::chance::PointKind kind, std::uint64_t samples) {
  const std::size_t inputs = study.inputs.of.size();
  study.points.emplace(kind, inputs, samples, 1);
  study.sample = {.first = 0, .count = study.points->size()};
  study.saltelli.first = study.sample.end();
  if (study.asks("indices")) {
    study.indices.emplace(kind, inputs, samples, 1);
    study.saltelli.count = study.indices->size();
  }
  study.bars.first = study.saltelli.end();
  if (study.asks("tornado")) study.tornado = taut::chance::tornado_points(study.inputs);
  study.bars.count = study.tornado.size();
  return study;
}

/// A grid over inputs that are lists.
inline taut::app::Study gridded(taut::app::Study study) {
  study.request.points = taut::app::StudyPoints::grid;
  study.sample.count = 1;
  for (const auto& one : study.inputs.of) study.sample.count *= std::get<taut::chance::Listed>(one.law).values.size();
  study.saltelli.first = study.bars.first = study.sample.end();
  return study;
}

/// All cases of a study, calculated one after the other.
inline taut::app::StudyData data_of(const taut::app::Study& study) {
  taut::app::StudyData data;
  data.outputs.resize(study.model.outputs.size());
  for (std::uint64_t i = 0; i < study.size(); ++i) {
    const taut::app::CaseAnswer answer = study.model.answer(study.values_at(i));
    for (std::size_t k = 0; k < data.outputs.size(); ++k) data.outputs[k].push_back(answer.outputs[k]);
    if (!answer.outcome.ok()) data.failed.push_back({i, answer.outcome.message});
    for (const taut::app::CaseFlaw& flaw : answer.flaws) data.flawed.push_back({i, flaw});
    taut::app::keep_least(answer.weaker, data.weaker);
  }
  return data;
}

}  // namespace taut_test
