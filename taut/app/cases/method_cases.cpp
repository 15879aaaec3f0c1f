#include "taut/app/cases/method_cases.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "taut/app/cases/case_values.hpp"

namespace taut::app {
namespace {

struct MethodModel {
  MethodDeck deck;
  std::vector<CaseInput> inputs;
  DeckParameters<MethodDeck> parameters;
  std::vector<WantedValue> wanted;
  std::map<std::string, double> strengths;  ///< as in CaseModel
  SaidOfDeck of_deck;
};

FoundParameter parameter_of(MethodDeck& deck, const std::string& path) { return deck.parameter(path); }

CaseAnswer answer_of(const MethodModel& model, std::span<const double> values) {
  CaseAnswer answer{.outputs = std::vector<double>(model.wanted.size(), std::nan("")), .outcome = {}};
  auto deck = deck_with(model.deck, model.inputs, model.parameters, parameter_of, values);
  if (!deck) {
    answer.outcome = deck.error();
    return answer;
  }
  const std::vector<Complaint> complaints = deck->method->complaints(deck->input);
  if (!complaints.empty()) {
    answer.outcome = infeasible(complaints.front().message);
    return answer;
  }
  std::vector<double> found = answer.outputs;
  const Result r = deck->calculate();
  answer.outcome = take_values(r, model.wanted, found);
  if (!answer.outcome.ok()) return answer;
  answer.outputs = std::move(found);
  answer.flaws = flaws_of(r, deck->display);
  add_other(
      r, model.of_deck, [](const std::string& part) { return part + breaking_check; }, answer.flaws);
  add_weaker(r, model.strengths, answer.weaker);
  return answer;
}

}  // namespace

MadeCases method_cases(const MethodDeck& deck, const CaseQuestion& question,
                       const DeckParameters<MethodDeck>& parameters) {
  auto model = std::make_shared<MethodModel>();
  model->deck = deck;
  CaseModel made;
  NoCases wrong;
  for (const CaseName& one : question.inputs) {
    if (is_parameter(one.name)) {
      add_input(parameters.describe(one.name), one, made, wrong);
    } else {
      add_input(parameter_of(model->deck, one.name), one, made, wrong);
    }
  }
  model->inputs = made.inputs;
  model->parameters = parameters;
  for (const CaseName& one : question.outputs) {
    const std::string name = one.name.starts_with("checks.") ? one.name.substr(7) : one.name;
    model->wanted.push_back({.output = model->wanted.size(), .name = name, .ending = {}, .place = one.place});
  }
  for (const CaseName& one : question.outputs) made.outputs.push_back({.name = one.name, .unit = {}, .label = {}});
  Unasked unasked;
  if (wrong.complaints.empty() && !question.outputs.empty()) {
    const Result r = model->deck.calculate();
    add_outputs(r, model->wanted, made, wrong);
    made.strengths = unasked.strengths = model->strengths = strengths_of(r);
    model->of_deck = said_of_deck(r);
    for (const std::string& part : r.unjudged) unasked.parts.push_back({.name = part});
  }
  if (!wrong.complaints.empty() || !wrong.outcome.ok()) return tl::unexpected(std::move(wrong));
  made.unasked = [unasked = std::move(unasked)] { return unasked; };
  made.answer = [model = std::shared_ptr<const MethodModel>(model)](std::span<const double> values) {
    return answer_of(*model, values);
  };
  return made;
}

}  // namespace taut::app
