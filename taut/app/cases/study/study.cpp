#include "taut/app/cases/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/app/cases/read_cases.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/source.hpp"

namespace taut::app {
namespace {

CaseQuestion question_of(const StudyRequest& request) {
  CaseQuestion q;
  for (const VaryRequest& one : request.vary) q.inputs.push_back({one.name, "study.vary." + one.name});
  for (std::size_t i = 0; i < request.of.size(); ++i) {
    q.outputs.push_back({request.of[i], fmt::format("study.of[{}]", i)});
  }
  return q;
}

/// Numbers of the cases: first the sample, then what the indices and the tornado need.
void lay_out(Study& s) {
  const StudyRequest& request = s.request;
  const auto seed = static_cast<std::uint64_t>(request.seed);
  const auto samples = static_cast<std::uint64_t>(request.samples);
  const auto kind = request.points == StudyPoints::random  ? chance::PointKind::random
                    : request.points == StudyPoints::latin ? chance::PointKind::latin
                                                           : chance::PointKind::sobol;
  if (request.points == StudyPoints::grid) {
    s.sample.count = 1;
    for (const auto& one : s.inputs.of) s.sample.count *= std::get<chance::Listed>(one.law).values.size();
  } else {
    s.points.emplace(kind, s.inputs.of.size(), samples, seed);
    s.sample.count = s.points->size();
  }
  s.saltelli.first = s.sample.end();
  if (s.asks("indices")) {
    s.indices.emplace(kind, s.inputs.of.size(), samples, seed);
    s.saltelli.count = s.indices->size();
  }
  s.bars.first = s.saltelli.end();
  if (s.asks("tornado")) s.tornado = chance::tornado_points(s.inputs);
  s.bars.count = s.tornado.size();
}

/// What a grid can't have.
void check_grid(const Study& s, std::vector<Complaint>& complaints) {
  double cases = 1;
  for (std::size_t i = 0; i < s.inputs.of.size(); ++i) {
    const auto* list = std::get_if<chance::Listed>(&s.inputs.of[i].law);
    if (list != nullptr) {
      cases *= static_cast<double>(list->values.size());
    } else {
      complaints.push_back({"study.vary." + s.request.vary[i].name,
                            "a grid is made of lists and steps ('list', or 'from', 'to' and 'steps'); it has a law"});
    }
  }
  for (const VaryRequest& one : s.request.vary) {
    if (one.weights.empty()) continue;
    complaints.push_back({"study.vary." + one.name + ".weights",
                          "a grid takes every value of a list once and has no probability: leave 'weights' away"});
  }
  for (const StudyLimit& limit : s.limits) {
    if (!limit.allowed) continue;
    complaints.push_back({"study.limit." + s.model.outputs[limit.output].name,
                          "a grid has no probability: leave 'allowed' away, and every case has to keep the limit"});
  }
  constexpr double most_cases = 1e8;
  if (cases > most_cases) {
    complaints.push_back(
        {"study.points", fmt::format("the grid has {:.3g} cases; {:.0e} is the most", cases, most_cases)});
  }
}

/// What contradicts itself in the block.
void check_together(const Study& s, std::vector<Complaint>& complaints) {
  const bool grid = s.request.points == StudyPoints::grid;
  if (grid) check_grid(s, complaints);
  for (const char* answer : {"indices", "tornado", "form", "sorm", "importance"}) {
    if (!s.asks(answer)) continue;
    if (grid) complaints.push_back({"study.answer", fmt::format("'{}' asks for chance; a grid has none", answer)});
    const std::string refused = std::string(answer) == "indices" ? chance::indices_refused(s.inputs) : std::string{};
    if (!refused.empty()) complaints.push_back({"study.answer", refused});
    const bool by_limit = std::string(answer) != "indices" && std::string(answer) != "tornado";
    if (by_limit && s.request.limit.empty()) {
      complaints.push_back({"study.answer", fmt::format("'{}' is about a limit: give one in 'limit'", answer)});
    }
  }
}

Complaint nothing_varies() {
  return {.path = "study.vary", .message = "names no number: without one that varies all cases are the same"};
}

}  // namespace

chance::Point Study::values_at(std::uint64_t index) const {
  if (index >= bars.first) return tornado[index - bars.first];
  if (index >= saltelli.first) return chance::values_at(inputs, indices->at(index - saltelli.first));
  if (points) return chance::values_at(inputs, points->at(index));
  // a grid: the last input changes from case to case
  chance::Point values(inputs.of.size());
  for (std::size_t i = values.size(); i-- > 0;) {
    const auto& list = std::get<chance::Listed>(inputs.of[i].law).values;
    values[i] = list[index % list.size()];
    index /= list.size();
  }
  return values;
}

bool Study::asks(const std::string& answer) const {
  return std::find(request.answer.begin(), request.answer.end(), answer) != request.answer.end();
}

tl::expected<Study, Result> read_study(const Job& job) {
  auto read = read_cases(job);
  if (!read) return tl::unexpected(std::move(read.error()));
  if (!read->study) {
    Diagnostics none;
    io::add(none, read->deck.input.spot,
            "the deck has no 'study': a map that says what varies ('vary') and what is asked for ('of')");
    return tl::unexpected(bad_deck(std::move(none)));
  }
  Study s;
  s.request = std::move(*read->study);
  if (s.request.vary.empty()) return tl::unexpected(refusal({.complaints = {nothing_varies()}}, read->blocks()));
  auto model = read->cases(question_of(s.request));
  if (!model) return tl::unexpected(refusal(model.error(), read->blocks()));
  s.model = std::move(*model);
  NoCases wrong;
  s.inputs = study_inputs(s.request, s.model.inputs, wrong.complaints);
  s.limits = study_limits(s.request, s.model.outputs, wrong.complaints);
  if (wrong.complaints.empty()) check_together(s, wrong.complaints);
  if (!wrong.complaints.empty()) return tl::unexpected(refusal(wrong, read->blocks()));
  lay_out(s);
  s.title = read->deck.title;
  s.method = read->deck.is_machine ? "machine" : read->deck.method;
  s.project = read->deck.project;
  s.display = read->deck.display;
  s.deck_name = job.name;
  s.overrides = job.set;
  s.hash = read->hash;
  return s;
}

Diagnostics check_study(const ReadCases& read) {
  Diagnostics mistakes;
  if (!read.study) return mistakes;
  Study s;
  s.request = *read.study;
  NoCases wrong;
  if (s.request.vary.empty()) wrong.complaints.push_back(nothing_varies());
  auto model = read.cases({.inputs = question_of(s.request).inputs, .outputs = {}});
  if (model) {
    s.model = std::move(*model);
    s.inputs = study_inputs(s.request, s.model.inputs, wrong.complaints);
    if (wrong.complaints.empty()) check_together(s, wrong.complaints);
  } else {
    wrong.complaints = std::move(model.error().complaints);
  }
  io::place(read.blocks(), wrong.complaints, mistakes);
  return mistakes;
}

}  // namespace taut::app
