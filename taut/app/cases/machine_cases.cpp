#include "taut/app/cases/machine_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <string_view>

#include "taut/app/cases/case_values.hpp"
#include "taut/app/cases/said_by_cases.hpp"
#include "taut/app/design/design_machine.hpp"
#include "taut/base/suggest.hpp"
#include "taut/checks/rope/rope_strength.hpp"
#include "taut/design/design.hpp"
#include "taut/study/analyses.hpp"
#include "taut/study/deck/parameter.hpp"
#include "taut/study/deck/temperature.hpp"

namespace taut::app {
namespace {

/// An analysis of the deck as an output names it.
struct NamedAnalysis {
  std::string label;   ///< "equilibrium", "load_path_sag"
  std::string ending;  ///< "", "_sag", "_2"
  std::size_t index = 0;
  bool judged = true;
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
      named.push_back({.label = kind + ending, .ending = ending, .index = i, .judged = request->judge});
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
  bool judges = true;               ///< whether the verdict has to see its states
  std::string about = {};           ///< the analysis whose states its flaws are about, as of a CaseFlaw
  bool tells = true;                ///< whether it tells the flaws of a case: no part does that runs more than it
  SaidOfDeck of_deck = {};          ///< by this part
};

struct MachineModel {
  MachineOfCase base;
  std::vector<CaseInput> inputs;
  DeckParameters<MachineOfCase> parameters;
  std::vector<DeckPart> parts;
  std::size_t outputs = 0;
  std::map<std::string, double> strengths;  ///< as in CaseModel
  bool keeps = false;  ///< what is put up keeps its lengths in a case with other loads or temperatures
  bool plain = false;  ///< each input is one number of the machine that depends on no other: decks can be used again
};

/// The decks of the parts of one case, and where its inputs stand in each of them.
struct Desk {
  std::vector<MachineDeck> decks;
  std::vector<std::vector<study::Parameter>> numbers;  ///< by part, by input
};

/// Desks that no case uses now.
class Desks {
 public:
  std::unique_ptr<Desk> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return nullptr;
    auto desk = std::move(free_.back());
    free_.pop_back();
    return desk;
  }
  void give_back(std::unique_ptr<Desk> desk) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(desk));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Desk>> free_;
};

/// The deck with nothing in it but what that part needs. Numbers of analyses and checks are put in before. What the
/// deck takes out of the verdict stays out of it.
void prune(const DeckPart& part, MachineDeck& deck) {
  if (part.kind != DeckPart::Kind::analysis) return;
  if (deck.checks) {
    checks::ChecksRequest kept;
    kept.exempt = std::move(deck.checks->exempt);
    deck.checks = std::move(kept);
  }
  deck.asked = {};
  if (!deck.analyses.empty()) deck.analyses = {std::move(deck.analyses[part.analysis.index])};
}

bool wants_factor(const DeckPart& part, const std::string& rope) {
  const std::string name = rope + ".safety_factor";
  return std::any_of(part.wanted.begin(), part.wanted.end(),
                     [&](const WantedValue& one) { return one.name == name || one.name == name + ".utilisation"; });
}

/// A rope's factor by the share of its strength that is left, where it is known.
void weaken(const std::string& name, double share, Result& r) {
  for (Value& value : r.values) {
    if (value.name == name + ".safety_factor") value.value *= share;
  }
}

/// The heat of which a deck's checks tell weakens a rope in each analysis, as in a run of the deck; so does that of the
/// analysis alone, `part`. Why a factor that is wanted has no number: the rope is too hot for all tables.
std::string weaken_by_heat(const MachineDeck& deck, const MachineDeck& part, const DeckPart& asked_of, Result& r) {
  std::string why;
  const std::optional<double> hottest = study::hottest_of(part.machine, part.analyses);
  const std::size_t ropes = deck.machine.reevings.size() + deck.machine.guys.size();
  for (std::size_t i = 0; i < ropes; ++i) {
    const auto entry = checks::entry_of(deck, i);
    if (!entry || !(hottest || deck.checks->ropes[*entry].temperature)) continue;
    const checks::StrengthInUse in_use = checks::strength_in_use(deck, i, hottest);
    const std::string name = checks::reeving_name_of(deck.machine, i);
    weaken(name, in_use.share, r);
    if (!in_use.unknown.empty() && wants_factor(asked_of, name)) why = fmt::format("{}: {}", name, in_use.unknown);
  }
  return why;
}

/// What a part of a case has found.
struct PartRun {
  Result r;
  /// Factors that are wanted, over a tension at rest which the motion goes far beyond.
  std::vector<CaseFlaw> open = {};
};

/// `beyond`: ropes that a motion loads far more than at rest, each with why, and with what helps. A check that is made
/// has its own number.
std::vector<CaseFlaw> open_factors(const DeckPart& part, const std::map<std::string, std::string>& beyond,
                                   const Result& r) {
  std::vector<CaseFlaw> open;
  for (const auto& [rope, why] : beyond) {
    const std::string name = rope + ".safety_factor";
    const bool made = std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.name == name; });
    if (!wants_factor(part, rope) || made) continue;
    // an analysis alone does not see the others
    const bool alone = part.kind == DeckPart::Kind::analysis;
    open.push_back(
        {.kind = CaseFlaw::Kind::unmade,
         .check = name,
         .words = fmt::format("{} is for the tension at rest: {}{}, or limit the T_max of {}, which has the peak", name,
                              why, alone ? fmt::format(" and limit checks.{}", name) : std::string{}, rope),
         .sense = Sense::at_least,
         .analysis = part.analysis.label});
  }
  return open;
}

/// A factor of `checks` is that of the check. Where it could not be made there is none.
void without_open(std::vector<CaseFlaw> open, Result& r) {
  if (open.empty() || r.status != Status::ok) return;
  r.status = Status::infeasible;
  r.message = std::move(open.front().words);
}

/// `deck`: pruned of `whole`.
PartRun run_part(const MachineOfCase& whole, const DeckPart& part, const MachineDeck& deck, OneOfMany many) {
  std::map<std::string, std::string> beyond;
  many.beyond_rest = &beyond;
  if (part.kind == DeckPart::Kind::checks) {
    PartRun found{.r = run_machine(deck, RunDepth::checks, {}, many)};
    without_open(open_factors(part, beyond, found.r), found.r);
    return found;
  }
  if (part.kind == DeckPart::Kind::analysis) {
    PartRun found{.r = run_machine(deck, RunDepth::values, {}, many)};
    std::string unknown = weaken_by_heat(whole.deck, deck, part, found.r);
    if (!unknown.empty() && found.r.status == Status::ok) {
      found.r.status = Status::infeasible;
      found.r.message = std::move(unknown);
    }
    found.open = open_factors(part, beyond, found.r);
    return found;
  }
  const auto run = [](const MachineDeck& one, RunDepth depth, const std::function<bool(const Progress&)>& ask,
                      States& states) { return run_near(one, std::min(depth, RunDepth::checks), ask, states); };
  const auto no_picture = [](const MachineDeck&, Result&) {};
  return {.r = design::run_design(machine_task(std::make_shared<const MachineDeck>(deck), whole.space,
                                               {.run = run, .picture = no_picture}, {}))};
}

FoundParameter parameter_of(MachineDeck& deck, const std::string& path) {
  return study::parameter_at(MachineDeck::describe(), &deck, path);
}
FoundParameter parameter_in(MachineOfCase& one, const std::string& path) { return parameter_of(one.deck, path); }

MachineDeck pruned(const DeckPart& part, MachineDeck deck) {
  prune(part, deck);
  return deck;
}

/// Whether a number can be put in without a look at what else was. The angle of a vector keeps its length, so that it
/// depends on the components; numbers of analyses and checks stand where decks are pruned.
bool is_plain(const CaseInput& input, MachineDeck& deck) {
  if (!input.path.starts_with("machine.")) return false;
  const FoundParameter found = parameter_of(deck, input.path);
  return found && found->unit.is_angle == found->field->unit.is_angle;
}

bool is_of_checks(const CaseInput& input) { return input.place.starts_with("checks."); }

/// What a design chooses from is found when its deck is read: its numbers would change nothing.
void complain_of_design(const std::vector<CaseInput>& inputs, const CaseQuestion& question, NoCases& wrong) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!inputs[i].place.starts_with("design.")) continue;
    wrong.complaints.push_back({question.inputs[i].place,
                                fmt::format("'{}' says what a design chooses from, which does not vary: let one of the "
                                            "'parameters' vary that stands there",
                                            inputs[i].path)});
  }
}

/// An input that every analysis sets anew would change nothing.
void complain_of_set_anew(const MachineDeck& deck, const std::vector<CaseInput>& inputs, const CaseQuestion& question,
                          NoCases& wrong) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!study::is_set_anew(deck.machine, deck.analyses, inputs[i].place)) continue;
    wrong.complaints.push_back({question.inputs[i].place,
                                fmt::format("every analysis sets '{}' anew: it would change nothing", inputs[i].path)});
  }
}

/// Whether a machine has what is put up once and then keeps its length or place.
bool is_put_up(const machine::Machine& machine) {
  const auto& ropes = machine.reevings;
  const auto& guys = machine.guys;
  const auto& screws = machine.take_up;
  return std::any_of(ropes.begin(), ropes.end(), [](const auto& r) { return r.install || r.tension_equals; }) ||
         std::any_of(guys.begin(), guys.end(), [](const auto& g) { return g.install.has_value(); }) ||
         std::any_of(screws.begin(), screws.end(),
                     [](const auto& s) { return s.keeps == machine::description::ScrewKeeps::place; });
}

/// The machine on which lines and guys of a case are put up: with the case's build, and with the loads, the temperature
/// and the other ropes of the deck (study::puts_up_anew). Screws take its temperature alone.
machine::Machine built_for(const machine::Machine& deck, machine::Machine own) {
  own.temperature = deck.temperature;
  own.loads = deck.loads;
  own.rope_loads = deck.rope_loads;
  for (std::size_t i = 0; i < own.reevings.size() && i < deck.reevings.size(); ++i) {
    const auto install = own.reevings[i].install;
    own.reevings[i] = deck.reevings[i];
    own.reevings[i].install = install;
  }
  return own;
}

/// A design puts up in its own load cases.
void put_up_before(const MachineModel& model, const DeckPart& part, MachineDeck& deck) {
  if (!model.keeps || part.kind == DeckPart::Kind::design) return;
  deck.put_up_on = std::make_shared<const machine::Machine>(built_for(model.base.deck.machine, deck.machine));
}

std::unique_ptr<Desk> new_desk(const MachineModel& model) {
  auto desk = std::make_unique<Desk>();
  desk->decks.reserve(model.parts.size());
  for (const DeckPart& part : model.parts) {
    MachineDeck& deck = desk->decks.emplace_back(pruned(part, model.base.deck));
    auto& numbers = desk->numbers.emplace_back();
    for (const CaseInput& input : model.inputs) numbers.push_back(*parameter_of(deck, input.path));
  }
  return desk;
}

/// Puts the numbers into a deck; what says why not where one is outside its range.
Outcome put_all(std::span<const double> values, std::vector<study::Parameter>& numbers) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    Outcome outcome = study::put(numbers[i], values[i]);
    if (!outcome.ok()) return outcome;
  }
  return {};
}

/// A run of the deck with other numbers.
OneOfMany one_of_many(const DeckPart& part) {
  OneOfMany many{.near = &part.states, .judges = part.judges};
  if (part.kind == DeckPart::Kind::analysis) {
    many.wants = [&part](std::string_view name) {
      return std::any_of(part.wanted.begin(), part.wanted.end(),
                         [&](const WantedValue& one) { return one.name.starts_with(name); });
    };
  }
  return many;
}

/// Whether one of its values is among these.
bool needs(const DeckPart& part, const std::set<std::string>& judged) {
  return std::any_of(part.wanted.begin(), part.wanted.end(), [&](const WantedValue& one) {
    return std::any_of(judged.begin(), judged.end(), [&](const std::string& name) {
      return one.name == name || one.name + one.ending == name || one.name.starts_with(name + ".");
    });
  });
}

/// The answer of the parts of a deck in turn. `deck_of`: the pruned deck of a part, with the numbers in it; not ok: why
/// there is none. `whole`: the deck with the numbers of its checks, those of its machine may be others.
template <class DeckOf>
CaseAnswer answer_by(const MachineModel& model, const MachineOfCase& whole, const DeckOf& deck_of) {
  CaseAnswer answer{.outputs = std::vector<double>(model.outputs, std::nan("")), .outcome = {}};
  std::vector<double> found = answer.outputs;
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const DeckPart& part = model.parts[i];
    const tl::expected<const MachineDeck*, Outcome> deck = deck_of(i);
    if (deck) {
      const auto [r, open] = run_part(whole, part, **deck, one_of_many(part));
      answer.outcome = take_values(r, part.wanted, found);
      std::vector<CaseFlaw> flaws;
      if (part.tells) {
        flaws = flaws_of(r, model.base.deck.display);
        add_other(
            r, part.of_deck, [&](const auto& name) { return check_of_strength(model.base.deck, name); }, flaws);
      }
      for (CaseFlaw& one : flaws) one.analysis = part.about;
      std::move(flaws.begin(), flaws.end(), std::back_inserter(answer.flaws));
      answer.flaws.insert(answer.flaws.end(), open.begin(), open.end());
      add_weaker(r, model.strengths, answer.weaker);
    } else {
      answer.outcome = deck.error();
    }
    if (answer.outcome.ok()) continue;
    answer.flaws.clear();  // a case without an answer is beyond every limit
    answer.weaker.clear();
    return answer;
  }
  answer.outputs = std::move(found);
  return answer;
}

CaseAnswer answer_at(const MachineModel& model, Desk& desk, std::span<const double> values) {
  return answer_by(model, model.base, [&](std::size_t i) -> tl::expected<const MachineDeck*, Outcome> {
    Outcome outcome = put_all(values, desk.numbers[i]);
    if (!outcome.ok()) return tl::unexpected(std::move(outcome));
    put_up_before(model, model.parts[i], desk.decks[i]);
    return &desk.decks[i];
  });
}

/// The deck with these numbers, and with checks that have them.
tl::expected<MachineOfCase, Outcome> deck_at(const MachineModel& model, std::span<const double> values) {
  auto one = deck_with(model.base, model.inputs, model.parameters, parameter_in, values);
  const bool renews = std::any_of(model.inputs.begin(), model.inputs.end(), is_of_checks);
  if (!one || !renews) return one;
  if (Outcome outcome = renew_checks(one->space, one->deck); !outcome.ok()) return tl::unexpected(std::move(outcome));
  return one;
}

CaseAnswer answer_anew(const MachineModel& model, std::span<const double> values) {
  const auto one = deck_at(model, values);
  MachineDeck alone;
  return answer_by(model, one ? *one : model.base, [&](std::size_t i) -> tl::expected<const MachineDeck*, Outcome> {
    if (!one) return tl::unexpected(one.error());
    alone = pruned(model.parts[i], one->deck);
    put_up_before(model, model.parts[i], alone);
    return &alone;
  });
}

/// The analyses that a part runs and the verdict sees.
std::vector<std::string> analyses_run(const DeckPart& part, const MachineDeck& deck) {
  if (part.kind == DeckPart::Kind::analysis) return {part.analysis.label};
  std::vector<std::string> labels;
  if (part.kind == DeckPart::Kind::design) return labels;
  for (const NamedAnalysis& one : named_analyses(deck.analyses)) {
    if (one.judged) labels.push_back(one.label);
  }
  return labels;
}

/// The analysis whose states the checks of a deck are about: the only one that is judged; empty: several.
std::string only_judged(const MachineDeck& deck) {
  const std::vector<std::string> judged = analyses_run({.kind = DeckPart::Kind::checks, .wanted = {}}, deck);
  return judged.size() == 1 ? judged.front() : std::string{};
}

/// The analysis whose states a part sees.
std::string analysis_seen(const DeckPart& part, const MachineDeck& deck) {
  if (part.kind == DeckPart::Kind::design) return "design";
  return part.kind == DeckPart::Kind::analysis ? part.analysis.label : only_judged(deck);
}

/// Sorts the outputs by what has to be run for them.
void sort_outputs(const std::vector<CaseName>& outputs, MachineModel& model, NoCases& wrong) {
  const MachineDeck& deck = model.base.deck;
  // of a design only its outcome: without a choice the machine has no state
  const auto analyses = deck.design ? std::vector<NamedAnalysis>{} : named_analyses(deck.analyses);
  std::vector<std::string> known;
  known.reserve(analyses.size() + 2);
  for (const NamedAnalysis& one : analyses) known.push_back(one.label);
  if (deck.checks && !deck.design) known.emplace_back("checks");
  if (deck.design) known.emplace_back("design");
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
                           .place = outputs[i].place,
                           .checks_first = into.kind != DeckPart::Kind::analysis});
  }
}

/// Analyses that count in a run of the deck and not in its cases.
std::vector<std::string> analyses_not_run(const MachineModel& model) {
  std::vector<std::string> all;
  const auto runs = [&](const NamedAnalysis& one) {
    return std::any_of(model.parts.begin(), model.parts.end(), [&](const DeckPart& part) {
      return part.kind != DeckPart::Kind::analysis || part.analysis.label == one.label;
    });
  };
  for (const NamedAnalysis& one : named_analyses(model.base.deck.analyses)) {
    if (one.judged && !runs(one)) all.push_back(one.label);
  }
  return all;
}

void add_inputs(const CaseQuestion& question, const DeckParameters<MachineOfCase>& parameters, MachineDeck& deck,
                CaseModel& made, NoCases& wrong) {
  for (const CaseName& one : question.inputs) {
    if (is_parameter(one.name)) {
      add_input(parameters.describe(one.name), one, made, wrong);
    } else {
      add_input(parameter_of(deck, one.name), one, made, wrong);
    }
  }
}

}  // namespace

MadeCases machine_cases(const ReadMachine& read, const CaseQuestion& question,
                        const DeckParameters<MachineOfCase>& parameters) {
  auto model = std::make_shared<MachineModel>();
  model->base = {.deck = *read.deck, .space = read.space};
  // lengths hold at the temperature that the deck has, whatever it is in a case
  const std::optional<double> before = read.deck->machine.temperature;
  study::keep_references(model->base.deck.machine, before);
  model->outputs = question.outputs.size();
  CaseModel made;
  NoCases wrong;
  add_inputs(question, parameters, model->base.deck, made, wrong);
  if (wrong.complaints.empty()) complain_of_design(made.inputs, question, wrong);
  if (wrong.complaints.empty()) complain_of_set_anew(model->base.deck, made.inputs, question, wrong);
  model->inputs = made.inputs;
  model->keeps = is_put_up(model->base.deck.machine) &&
                 std::any_of(model->inputs.begin(), model->inputs.end(), [&](const CaseInput& input) {
                   const FoundParameter found = parameter_of(model->base.deck, input.path);
                   return !found || !study::puts_up_anew(*found);
                 });
  model->parameters = parameters;
  model->parameters.read = [again = parameters.read, before](const std::vector<std::string>& set) {
    auto one = again(set);
    if (one) study::keep_references(one->deck.machine, before);
    return one;
  };
  sort_outputs(question.outputs, *model, wrong);
  if (!wrong.complaints.empty()) return tl::unexpected(std::move(wrong));
  for (const CaseName& one : question.outputs) made.outputs.push_back({.name = one.name, .unit = {}, .label = {}});
  const bool all_analyses = std::any_of(model->parts.begin(), model->parts.end(),
                                        [](const DeckPart& part) { return part.kind == DeckPart::Kind::checks; });
  SaidByCases said;
  for (DeckPart& part : model->parts) {
    std::set<std::string> judged;
    const OneOfMany first{.found = &part.states, .judged = &judged};
    const Result r = run_part(model->base, part, pruned(part, model->base.deck), first).r;
    add_outputs(r, part.wanted, made, wrong);
    if (!wrong.complaints.empty() || !wrong.outcome.ok()) return tl::unexpected(std::move(wrong));
    // the checks are of the deck with all its analyses
    part.tells = part.kind != DeckPart::Kind::analysis || !all_analyses;
    part.about = analysis_seen(part, model->base.deck);
    add_new(r.exempt, made.exempt);
    add_new(r.left_out, made.left_out);
    part.judges = part.tells || needs(part, judged);
    part.of_deck = said_of_deck(r);
    std::map<std::string, double> strengths = strengths_of(r);
    for (const auto& one : strengths) add_new(analyses_run(part, model->base.deck), made.loaded_in[one.first]);
    // a part that needs a limit needs it in each of them, whether its strength is known or not
    for (const std::string& one : r.unjudged) add_new(analyses_run(part, model->base.deck), made.loaded_in[one]);
    made.strengths.merge(strengths);
    if (part.tells) said.hear(r);
  }
  model->strengths = made.strengths;
  made.not_run = analyses_not_run(*model);
  // a design takes no choice that has one
  if (!model->base.deck.design) {
    made.unasked = [model = std::shared_ptr<const MachineModel>(model), said = std::move(said)] {
      return beside_cases(model->base.deck, said, only_judged(model->base.deck));
    };
  }
  model->plain = std::all_of(model->inputs.begin(), model->inputs.end(),
                             [&](const CaseInput& input) { return is_plain(input, model->base.deck); });
  made.answer = [model = std::shared_ptr<const MachineModel>(model),
                 desks = std::make_shared<Desks>()](std::span<const double> values) {
    if (!model->plain) return answer_anew(*model, values);
    auto desk = desks->take();
    if (!desk) desk = new_desk(*model);
    CaseAnswer answer = answer_at(*model, *desk, values);
    desks->give_back(std::move(desk));
    return answer;
  };
  return made;
}

}  // namespace taut::app
