#include "taut/study/analyses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "taut/study/deck/parameter.hpp"
#include "taut/units/parse.hpp"

namespace taut::study {
namespace {

/// A carriage that is clamped or fixed needs to know where.
void check_clamps(const std::vector<EquilibriumRun>& equilibria, Names& names) {
  for (std::size_t i = 0; i < names.machine.carriages.size(); ++i) {
    const auto& given = names.machine.carriages[i];
    const bool clamped = given.hold == machine::description::Hold::clamped;
    if ((!clamped && !given.fixed_to) || given.length_before) continue;
    const bool placed = std::all_of(equilibria.begin(), equilibria.end(), [&](const EquilibriumRun& one) {
      return one.prescribed && one.prescribed->carriage == static_cast<int>(i);
    });
    if (placed) continue;
    names.complaints.push_back(
        {fmt::format("machine.carriages.{}", given.name),
         fmt::format("is {} somewhere: give 'length_before', or 'carriage' and 'x' in the equilibrium",
                     clamped ? "clamped" : "fixed to '" + *given.fixed_to + "'")});
  }
}

/// Of two states in one file the second would be left.
void check_saves(const std::vector<AnalysisRequest>& all, std::vector<Complaint>& complaints) {
  std::map<std::string, std::size_t> saved;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].transient || !all[i].transient->save) continue;
    const auto [first, is_new] = saved.try_emplace(*all[i].transient->save, i);
    if (is_new) continue;
    complaints.push_back({fmt::format("analyses[{}].transient.save", i),
                          fmt::format("analyses[{}] saves its state in '{}' too", first->second, first->first)});
  }
}

/// Pulls in turn, or lengths for a least tension.
Question pretension_of(const PretensionRequest& request, const std::string& path, Names& names) {
  if (!request.least) return resolve(request, path, names);
  const std::string ending = ending_of(names, "pretension", request.name, path);
  LeastTensionRun run = resolve(*request.least, path + ".least", names);
  run.ending = ending;
  run.words = request.name ? fmt::format("pretension, {}", *request.name) : "pretension";
  return run;
}

/// The place of a number of the machine for all spellings of its path; empty where there is none.
std::string place_of(const machine::Machine& machine, const std::string& path) {
  machine::Machine own = machine;
  const auto parameter = find_parameter(machine::Machine::describe(), &own, path);
  return parameter ? below_machine(parameter->place) : std::string{};
}

bool sets_anew(const machine::Machine& machine, const AnalysisRequest& one, const std::string& place) {
  if (one.sweep) return place_of(machine, one.sweep->parameter) == place;
  if (one.envelope) return place == "temperature" && !one.envelope->temperatures.empty();
  if (one.installation) return place == "temperature" && !one.installation->temperatures.empty();
  const auto& given = one.equilibrium ? one.equilibrium->given : one.load_path ? one.load_path->given : std::nullopt;
  if (!given) return false;
  const auto& of = given->of;
  const auto is_given = [&](const std::string& rope) {
    return rope == given->reeving || std::find(of.begin(), of.end(), rope) != of.end();
  };
  for (std::size_t i = 0; i < machine.reevings.size(); ++i) {
    if (!is_given(name_of(machine.reevings[i]))) continue;
    for (const char* field : {"length", "tension_at_start", "tension_at_end"}) {
      if (place == fmt::format("reevings[{}].{}", i, field)) return true;
    }
  }
  return false;
}

/// One deck's analyses, in its order.
class AnalysesResolver {
 public:
  AnalysesResolver(Names& names, bool must_judge) : names_(names), must_judge_(must_judge) {}

  void resolve(const AnalysisRequest& one, const DeckPlace& path) {
    if (one.equilibrium) {
      const DeckPlace here(path, "equilibrium");
      all.equilibria.push_back(study::resolve(*one.equilibrium, here, names_));
      check_judged(one.equilibrium->judge, here);
    }
    if (one.load_path) {
      const DeckPlace here(path, "load_path");
      all.paths.push_back(study::resolve(*one.load_path, here.text(), names_));
      check_judged(one.load_path->judge, here);
    }
    add(one.payload, "payload", path);
    add(one.installation, "installation", path);
    add(one.cycle, "cycle", path);
    add(one.envelope, "envelope", path);
    add(one.sweep, "sweep", path);
    add(one.transient, "transient", path);
    add(one.pretension, "pretension", path);
    add(one.modes, "modes", path);
  }

  AskedAll all;

 private:
  void check_judged(bool judge, const DeckPlace& path) {
    if (judge || !must_judge_) return;
    names_.complaints.push_back(
        {DeckPlace(path, "judge").text(), "a design is judged in every state: leave 'judge: false' away"});
  }

  template <class Request>
  void add(const std::optional<Request>& request, const char* kind, const DeckPlace& path) {
    if (!request) return;
    const std::string here = DeckPlace(path, kind).text();
    all.more.push_back({question_of(*request, here), request->name.value_or(kind), request->judge,
                        request->name ? fmt::format("{} {}", kind, *request->name) : kind});
    check_judged(request->judge, here);
  }
  template <class Request>
  Question question_of(const Request& request, const std::string& path) {
    return study::resolve(request, path, names_);
  }
  Question question_of(const PretensionRequest& request, const std::string& path) {
    return pretension_of(request, path, names_);
  }

  Names& names_;
  bool must_judge_;
};

}  // namespace

const Description& AnalysisRequest::describe() {
  static const Description d =
      Describe<AnalysisRequest>()
          .record(&AnalysisRequest::equilibrium, "equilibrium", "the machine in equilibrium")
          .record(&AnalysisRequest::load_path, "load_path", "a carriage moved along its line")
          .record(&AnalysisRequest::payload, "payload", "the largest load within all limits")
          .record(&AnalysisRequest::installation, "installation",
                  "an empty rope put up: tensions, sags and lengths by temperature")
          .record(&AnalysisRequest::cycle, "cycle", "pulls and energies of a working cycle")
          .record(&AnalysisRequest::envelope, "envelope", "worst cases for sizing")
          .record(&AnalysisRequest::sweep, "sweep", "the equilibrium over a number of the deck")
          .record(&AnalysisRequest::transient, "transient", "a motion of the machine")
          .record(&AnalysisRequest::modes, "modes", "small vibrations: frequencies, damping, shapes")
          .record(&AnalysisRequest::pretension, "pretension", "ropes tightened one after the other, as they are put up")
          .exactly_one({"equilibrium", "load_path", "payload", "installation", "cycle", "envelope", "sweep",
                        "transient", "modes", "pretension"});
  return d;
}

namespace {

/// The temperatures of the machine in the states that an analysis shows to the verdict, K.
std::vector<double> temperatures_of(const AnalysisRequest& one) {
  std::vector<double> all;
  if (one.envelope && one.envelope->judge) all = one.envelope->temperatures;
  if (one.installation && one.installation->judge) {
    all = one.installation->temperatures;
    for (const auto& end : {one.installation->from, one.installation->to}) {
      if (end) all.push_back(*end);
    }
  }
  if (one.sweep && one.sweep->judge && one.sweep->heats()) {
    for (const std::string& end : {one.sweep->from, one.sweep->to}) {
      if (const auto t = parse_quantity(end, si::K)) all.push_back(*t);
    }
  }
  return all;
}

}  // namespace

std::optional<double> hottest_of(const machine::Machine& machine, const std::vector<AnalysisRequest>& analyses) {
  std::optional<double> hottest = machine.temperature;
  for (const AnalysisRequest& one : analyses) {
    for (const double t : temperatures_of(one)) hottest = std::max(t, hottest.value_or(t));
  }
  return hottest;
}

std::optional<double> coldest_of(const machine::Machine& machine, const std::vector<AnalysisRequest>& analyses) {
  std::optional<double> coldest = machine.temperature;
  for (const AnalysisRequest& one : analyses) {
    for (const double t : temperatures_of(one)) coldest = std::min(t, coldest.value_or(t));
  }
  return coldest;
}

AskedAll resolve(const std::vector<AnalysisRequest>& analyses, bool must_judge, const machine::Machine& machine,
                 const machine::Model& model, std::vector<Complaint>& complaints) {
  static const std::vector<AnalysisRequest> at_rest = [] {
    std::vector<AnalysisRequest> one(1);
    one.front().equilibrium.emplace();
    return one;
  }();
  const std::vector<AnalysisRequest>& all = analyses.empty() ? at_rest : analyses;
  Names names{.machine = machine, .model = model, .complaints = complaints};
  names.has_envelope =
      std::any_of(all.begin(), all.end(), [](const AnalysisRequest& one) { return one.envelope.has_value(); });
  AnalysesResolver resolver(names, must_judge);
  const DeckPlace list("analyses");
  for (std::size_t i = 0; i < all.size(); ++i) resolver.resolve(all[i], {list, i});
  check_saves(all, complaints);
  check_clamps(resolver.all.equilibria, names);
  return std::move(resolver.all);
}

bool is_set_anew(const machine::Machine& machine, const std::vector<AnalysisRequest>& analyses,
                 const std::string& place) {
  const std::string below = below_machine(place);
  return !analyses.empty() && std::all_of(analyses.begin(), analyses.end(),
                                          [&](const AnalysisRequest& one) { return sets_anew(machine, one, below); });
}

}  // namespace taut::study
