#include "taut/app/cases/machine_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "taut/app/cases/case_values.hpp"
#include "taut/app/design/design_machine.hpp"
#include "taut/base/suggest.hpp"
#include "taut/design/design.hpp"
#include "taut/study/deck/parameter.hpp"

namespace taut::app {
namespace {

/// An analysis of the deck as an output names it.
struct NamedAnalysis {
  std::string label;   ///< "equilibrium", "load_path_sag"
  std::string ending;  ///< "", "_sag", "_2"
  std::size_t index = 0;
};

std::vector<NamedAnalysis> named_analyses(const std::vector<study::AnalysisRequest>& all) {
  std::vector<NamedAnalysis> named;
  std::map<std::string, int> seen;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto add = [&](const char* kind, const auto& request) {
      if (!request) return;
      const int before = seen[kind]++;
      const std::string ending = request->name ? "_" + *request->name
                                 : before == 0 ? std::string{}
                                               : fmt::format("_{}", before + 1);
      named.push_back({.label = kind + ending, .ending = ending, .index = i});
    };
    add("equilibrium", all[i].equilibrium);
    add("load_path", all[i].load_path);
    add("payload", all[i].payload);
    add("installation", all[i].installation);
    add("cycle", all[i].cycle);
    add("envelope", all[i].envelope);
    add("sweep", all[i].sweep);
    add("transient", all[i].transient);
    add("modes", all[i].modes);
    add("pretension", all[i].pretension);
  }
  if (all.empty()) named.push_back({.label = "equilibrium", .ending = {}, .index = 0});
  return named;
}

/// What is run of the deck for some of the outputs.
struct DeckPart {
  enum class Kind { analysis, checks, design };
  Kind kind = Kind::analysis;
  NamedAnalysis analysis = {};      ///< the only one that is left
  std::vector<WantedValue> wanted;  ///< by output
  States states = {};               ///< of the deck as it is
};

struct MachineModel {
  MachineDeck deck;
  design::DesignSpace space;
  std::vector<CaseInput> inputs;
  DeckParameters<MachineDeck> parameters;
  std::vector<DeckPart> parts;
  std::size_t outputs = 0;
};

/// The deck with nothing in it but what that part needs. Numbers are put in before, by the paths of the whole deck.
void prune(const DeckPart& part, MachineDeck& deck) {
  if (part.kind != DeckPart::Kind::analysis) return;
  deck.checks.reset();
  deck.asked = {};
  if (!deck.analyses.empty()) deck.analyses = {std::move(deck.analyses[part.analysis.index])};
}

/// `whole`: with all values, to know which there are.
Result run_part(const MachineModel& model, const DeckPart& part, MachineDeck deck, States* states, bool whole) {
  prune(part, deck);
  if (part.kind != DeckPart::Kind::design) {
    const RunDepth depth = part.kind == DeckPart::Kind::checks ? RunDepth::checks : RunDepth::values;
    OneOfMany many{.states = states};
    if (!whole && part.kind == DeckPart::Kind::analysis) {
      many.wants = [&part](const std::string& name) {
        return std::any_of(part.wanted.begin(), part.wanted.end(),
                           [&](const WantedValue& one) { return one.name.starts_with(name); });
      };
    }
    return run_machine(deck, depth, {}, many);
  }
  const auto run = [](const MachineDeck& one, RunDepth depth, const std::function<bool(const Progress&)>& ask) {
    return run_machine(one, std::min(depth, RunDepth::checks), ask);
  };
  const auto no_picture = [](const MachineDeck&, Result&) {};
  return design::run_design(machine_task(std::make_shared<const MachineDeck>(std::move(deck)), model.space,
                                         {.run = run, .picture = no_picture}, {}));
}

FoundParameter parameter_of(MachineDeck& deck, const std::string& path) {
  return study::parameter_at(MachineDeck::describe(), &deck, path);
}

CaseAnswer answer_of(const MachineModel& model, std::span<const double> values) {
  CaseAnswer answer{.outputs = std::vector<double>(model.outputs, std::nan("")), .outcome = {}};
  auto deck = deck_with(model.deck, model.inputs, model.parameters, parameter_of, values);
  if (!deck) answer.outcome = deck.error();
  std::vector<double> found = answer.outputs;
  for (const DeckPart& part : model.parts) {
    if (!answer.outcome.ok()) return answer;
    States near = part.states;
    const bool last = &part == &model.parts.back();
    const Result r = run_part(model, part, last ? std::move(*deck) : *deck, near.empty() ? nullptr : &near, false);
    answer.outcome = take_values(r, part.wanted, found);
  }
  if (answer.outcome.ok()) answer.outputs = std::move(found);
  return answer;
}

/// Sorts the outputs by what has to be run for them.
void sort_outputs(const std::vector<CaseName>& outputs, MachineModel& model, NoCases& wrong) {
  // of a design only its outcome: without a choice the machine has no state
  const auto analyses = model.deck.design ? std::vector<NamedAnalysis>{} : named_analyses(model.deck.analyses);
  std::vector<std::string> known;
  known.reserve(analyses.size() + 2);
  for (const NamedAnalysis& one : analyses) known.push_back(one.label);
  if (model.deck.checks && !model.deck.design) known.emplace_back("checks");
  if (model.deck.design) known.emplace_back("design");
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const std::string& name = outputs[i].name;
    const std::string first = name.substr(0, name.find('.'));
    const bool there = std::find(known.begin(), known.end(), first) != known.end();
    if (!there || first.size() + 1 >= name.size()) {
      wrong.complaints.push_back(
          {outputs[i].place,
           fmt::format("'{}' begins with none of the deck's analyses{}; write ANALYSIS.VALUE with one "
                       "of {}",
                       name, did_you_mean(first, known), fmt::join(known, ", "))});
      continue;
    }
    DeckPart part;
    if (first == "checks") part.kind = DeckPart::Kind::checks;
    if (first == "design") part.kind = DeckPart::Kind::design;
    const auto analysis =
        std::find_if(analyses.begin(), analyses.end(), [&](const auto& a) { return a.label == first; });
    if (analysis != analyses.end()) part.analysis = *analysis;
    const auto same = std::find_if(model.parts.begin(), model.parts.end(), [&](const DeckPart& other) {
      return other.kind == part.kind && other.analysis.label == part.analysis.label;
    });
    DeckPart& into = same != model.parts.end() ? *same : model.parts.emplace_back(std::move(part));
    into.wanted.push_back({.output = i,
                           .name = name.substr(first.size() + 1),
                           .ending = into.analysis.ending,
                           .place = outputs[i].place});
  }
}

}  // namespace

MadeCases machine_cases(const ReadMachine& read, const CaseQuestion& question,
                        const DeckParameters<MachineDeck>& parameters) {
  auto model = std::make_shared<MachineModel>();
  model->deck = *read.deck;
  model->space = read.space;
  model->outputs = question.outputs.size();
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
  sort_outputs(question.outputs, *model, wrong);
  if (!wrong.complaints.empty()) return tl::unexpected(std::move(wrong));
  for (const CaseName& one : question.outputs) made.outputs.push_back({.name = one.name, .unit = {}, .label = {}});
  for (DeckPart& part : model->parts) {
    const Result r = run_part(*model, part, model->deck, &part.states, true);
    add_outputs(r, part.wanted, made, wrong);
    if (!wrong.complaints.empty() || !wrong.outcome.ok()) return tl::unexpected(std::move(wrong));
  }
  made.answer = [model = std::shared_ptr<const MachineModel>(model)](std::span<const double> values) {
    return answer_of(*model, values);
  };
  return made;
}

}  // namespace taut::app
