#include "taut/study/least_tension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/machine/compile.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/band.hpp"
#include "taut/solve/condition.hpp"
#include "taut/solve/running.hpp"
#include "taut/study/deck/bounds.hpp"
#include "taut/study/put_up.hpp"

namespace taut::study {
namespace {

constexpr int most_rounds = 60;
constexpr double close_tension = 1e-7;   ///< of the least tension asked for
constexpr double nudge = 1e-6;           ///< of a rope's length, for differences
constexpr double longest_change = 0.02;  ///< of a rope's length, in one round
constexpr int most_halves = 12;

/// A case at rest without loss, or with the losses of one combination of the ropes' directions: friction may hold the
/// machine in any state between them.
struct StateOfCase {
  int of = 0;                   ///< the case
  Array<Array<int>> flow = {};  ///< [reeving][node]; empty: without loss
};

/// All cases with the lengths as they are.
struct CaseSet {
  Array<StateOfCase> states;
  Array<machine::Model> models;             ///< by state
  Array<solve::EquilibriumResult> results;  ///< by state
};

solve::EquilibriumOptions options_of(const StateOfCase& state) {
  solve::EquilibriumOptions options;
  options.flow = state.flow;
  options.band = false;
  options.held = !state.flow.empty();  // its friction holds it at rest
  return options;
}

/// `cases`: those at rest first.
CaseSet all_states(const Array<machine::Model>& cases) {
  CaseSet set;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    set.states.push_back({.of = static_cast<int>(c)});
    set.models.push_back(cases[c]);
  }
  for (std::size_t c = 0; c < cases.size(); ++c) {
    if (!solve::differs_in_motion(cases[c])) continue;
    for (Array<Array<int>>& flow : solve::flows_at_rest(cases[c])) {
      set.states.push_back({.of = static_cast<int>(c), .flow = std::move(flow)});
      set.models.push_back(solve::with_loads_held(cases[c]));
    }
  }
  set.results.resize(set.states.size());
  return set;
}

/// Solves the states; the number of the first that fails.
std::optional<int> solve_cases(CaseSet& set) {
  for (std::size_t c = 0; c < set.models.size(); ++c) {
    const solve::EquilibriumOptions options = options_of(set.states[c]);
    std::optional<machine::State> near;
    if (set.results[c].outcome.ok() && !set.results[c].branches.empty()) near = set.results[c].state;
    set.results[c] = solve::equilibrium(set.models[c], options, near);
    if (!set.results[c].outcome.ok() && near) set.results[c] = solve::equilibrium(set.models[c], options);
    if (!set.results[c].outcome.ok()) return static_cast<int>(c);
  }
  return std::nullopt;
}

void set_length(CaseSet& set, int reeving, double length) {
  for (machine::Model& model : set.models) {
    model.reevings[reeving].given = machine::Given::length;
    model.reevings[reeving].value = length;
  }
}

/// Of each chosen rope: its governing state and tension there.
Array<std::pair<int, double>> governing_cases(const CaseSet& set, const Array<int>& chosen) {
  Array<std::pair<int, double>> all;
  for (const int rope : chosen) {
    std::pair<int, double> worst{0, std::numeric_limits<double>::infinity()};
    for (std::size_t c = 0; c < set.results.size(); ++c) {
      const double T = least_tension_of(set.results[c], rope);
      if (T < worst.second) worst = {static_cast<int>(c), T};
    }
    all.push_back(worst);
  }
  return all;
}

/// Solves A x = b by elimination with row pivots; false: no answer.
bool solve_small(Array<Array<double>> A, Array<double> b, Array<double>& x) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t r = k + 1; r < n; ++r) {
      if (std::abs(A[r][k]) > std::abs(A[pivot][k])) pivot = r;
    }
    if (!(std::abs(A[pivot][k]) > 0)) return false;
    std::swap(A[k], A[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t r = k + 1; r < n; ++r) {
      const double f = A[r][k] / A[k][k];
      for (std::size_t c = k; c < n; ++c) A[r][c] -= f * A[k][c];
      b[r] -= f * b[k];
    }
  }
  x.assign(n, 0.0);
  for (std::size_t k = n; k-- > 0;) {
    double sum = b[k];
    for (std::size_t c = k + 1; c < n; ++c) sum -= A[k][c] * x[c];
    x[k] = sum / A[k][k];
  }
  return std::all_of(x.begin(), x.end(), [](double one) { return std::isfinite(one); });
}

/// How each chosen rope's tension in its governing state follows the length of each, N/m. A slack one counts as if its
/// own length alone tightened it.
Array<Array<double>> tension_slopes(const CaseSet& set, const Array<int>& chosen,
                                    const Array<std::pair<int, double>>& worst) {
  const std::size_t n = chosen.size();
  Array<Array<double>> slopes(n, Array<double>(n, 0.0));
  for (std::size_t j = 0; j < n; ++j) {
    const double length = set.models.front().reevings[chosen[j]].value, step = nudge * length;
    Array<std::optional<solve::EquilibriumResult>> nudged(set.models.size());
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t c = as_size(worst[i].first);
      if (worst[i].second <= 0) continue;
      if (!nudged[c]) {
        machine::Model model = set.models[c];
        model.reevings[chosen[j]].value = length - step;
        nudged[c] = solve::equilibrium(model, options_of(set.states[c]), set.results[c].state);
      }
      if (nudged[c]->outcome.ok()) slopes[i][j] = (worst[i].second - least_tension_of(*nudged[c], chosen[i])) / step;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (slopes[i][i] < 0) continue;
    const machine::Reeving& rope = set.models.front().reevings[chosen[i]];
    std::fill(slopes[i].begin(), slopes[i].end(), 0.0);
    slopes[i][i] = -(std::isfinite(rope.stiffness) ? rope.stiffness : rope.weight * rope.value / nudge) / rope.value;
  }
  return slopes;
}

double largest_miss(const Array<std::pair<int, double>>& worst, double least) {
  double miss = 0;
  for (const auto& one : worst) miss = std::max(miss, std::abs(one.second - least));
  return miss;
}

/// The next lengths: Newton's, a part of that where it leads nowhere. False: no part does.
bool go_nearer(CaseSet& set, const Array<int>& chosen, double least, double miss) {
  const auto worst = governing_cases(set, chosen);
  Array<double> asked, change;
  for (const auto& one : worst) asked.push_back(least - one.second);
  if (!solve_small(tension_slopes(set, chosen, worst), asked, change)) return false;
  double share = 1;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    const double most = longest_change * set.models.front().reevings[chosen[k]].value;
    if (std::abs(change[k]) > most) share = std::min(share, most / std::abs(change[k]));
  }
  const CaseSet before = set;
  for (int i = 0; i < most_halves; ++i, share /= 2) {
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const double length = before.models.front().reevings[chosen[k]].value;
      set_length(set, chosen[k], length + share * change[k]);
    }
    if (!solve_cases(set) && largest_miss(governing_cases(set, chosen), least) < miss) return true;
    set.results = before.results;
  }
  set = before;
  return false;
}

/// The machine with the loads of a case besides its own; complaints at the case.
std::optional<machine::Model> model_of_case(const machine::Machine& machine, const LoadCaseRequest& request,
                                            const std::string& path, std::vector<Complaint>& complaints) {
  machine::Machine loaded = machine;
  loaded.loads.insert(loaded.loads.end(), request.loads.begin(), request.loads.end());
  auto model = machine::compile(loaded, machine::ModelFor::rest);
  if (model) {
    for (std::size_t i = 0; i < request.loads.size(); ++i) {
      const int body = model->loads[machine.loads.size() + i].at.body;
      if (body == machine::ground || !machine::stands_fast(model->bodies[body])) continue;
      complaints.push_back({fmt::format("{}.loads[{}].at", path, i),
                            fmt::format("'{}' cannot move: no rope feels a load on it; say what is 'free' of it",
                                        model->bodies[body].name)});
    }
    return std::move(*model);
  }
  for (Complaint& c : model.error()) {
    for (std::size_t i = 0; i < request.loads.size(); ++i) {
      const std::string its = fmt::format("loads[{}]", machine.loads.size() + i);
      if (!c.path.starts_with(its)) continue;
      complaints.push_back({fmt::format("{}.loads[{}]{}", path, i, c.path.substr(its.size())), c.message});
    }
  }
  return std::nullopt;
}

/// Guys and lines have been put up, parallel ropes drawn to equal tensions; they keep those lengths where they are not
/// chosen.
void keep_lengths(const LeastTensionRun& run, const machine::Model& installed, machine::Model& model) {
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const bool described = !model.reevings[i].put_up && model.reevings[i].given != machine::Given::equal;
    if (i < run.guys_from && described) continue;
    model.reevings[i].given = installed.reevings[i].given;
    model.reevings[i].value = installed.reevings[i].value;
    model.reevings[i].is_to_install = installed.reevings[i].is_to_install;
  }
}

}  // namespace

double least_tension_of(const solve::EquilibriumResult& result, int reeving) {
  double least = std::numeric_limits<double>::infinity();
  for (const solve::BranchResult& branch : result.branches) {
    if (branch.reeving != reeving) continue;
    // where the rope sags below both ends its tension is least there: the horizontal part
    const bool sags = branch.V_from < 0 && branch.V_to > 0;
    least = std::min({least, branch.T_from, branch.T_to, sags ? branch.H : least});
  }
  return std::isfinite(least) ? std::max(0.0, least) : 0;
}

LeastTensionResult least_tension(const Array<machine::Model>& cases, const Array<int>& chosen, double least,
                                 const std::function<bool()>& go_on) {
  expects(!cases.empty() && !chosen.empty() && least > 0, "ropes that are to be taut under some loads");
  LeastTensionResult r;
  CaseSet set = all_states(cases);
  // lengths first: those that the first case gives
  const solve::EquilibriumResult first = solve::equilibrium(cases.front(), options_of(set.states.front()));
  r.outcome = first.outcome;
  if (!r.outcome.ok()) return r;
  const machine::Model frozen = solve::installed(cases.front(), first);
  Array<double> begun;
  for (const int rope : chosen) {
    begun.push_back(frozen.reevings[rope].value);
    set_length(set, rope, begun.back());
  }
  if (const auto failed = solve_cases(set)) {
    r.outcome = set.results[*failed].outcome;
    return r;
  }
  double miss = largest_miss(governing_cases(set, chosen), least);
  while (miss > close_tension * least) {
    if (go_on && !go_on()) {
      r.interrupted = true;
      return r;
    }
    if (r.iterations++ >= most_rounds || !go_nearer(set, chosen, least, miss)) {
      const auto worst = governing_cases(set, chosen);
      std::size_t k = 0;
      for (std::size_t i = 0; i < worst.size(); ++i) {
        if (std::abs(worst[i].second - least) > std::abs(worst[k].second - least)) k = i;
      }
      r.outcome =
          infeasible(fmt::format("no lengths were found for which all ropes just keep {:.4g} N: '{}' has {:.4g} N",
                                 least, frozen.reevings[chosen[k]].name, worst[k].second));
      return r;
    }
    miss = largest_miss(governing_cases(set, chosen), least);
  }
  const auto worst = governing_cases(set, chosen);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    LeastTension one;
    one.reeving = chosen[k];
    one.unstretched = set.models.front().reevings[chosen[k]].value;
    one.taken_out = begun[k] - one.unstretched;
    one.T_least = worst[k].second;
    one.governing = set.states[as_size(worst[k].first)].of;
    one.T_min.assign(cases.size(), std::numeric_limits<double>::infinity());
    for (std::size_t s = 0; s < set.results.size(); ++s) {
      double& T_min = one.T_min[as_size(set.states[s].of)];
      T_min = std::min(T_min, least_tension_of(set.results[s], chosen[k]));
    }
    r.ropes.push_back(std::move(one));
  }
  for (std::size_t c = 0; c < cases.size(); ++c) {
    r.at.push_back(solve::equilibrium(set.models[c], {}, set.results[c].state));
  }
  r.models.assign(set.models.begin(), set.models.begin() + static_cast<std::ptrdiff_t>(cases.size()));
  return r;
}

const Description& LoadCaseRequest::describe() {
  static const Description d = Describe<LoadCaseRequest>()
                                   .field(&LoadCaseRequest::name, "name", "name of the case in tables")
                                   .required()
                                   .record(&LoadCaseRequest::loads, "loads",
                                           "loads in addition to those of the machine, after the ropes are put up");
  return d;
}

const Description& LeastTensionRequest::describe() {
  static const Description d =
      Describe<LeastTensionRequest>()
          .field(&LeastTensionRequest::ropes, "ropes", "reevings or guys whose lengths follow")
          .required()
          .field(&LeastTensionRequest::tension, "tension", "s", si::N,
                 "smallest tension of each rope, over its length, all cases and both directions of "
                 "friction")
          .above(0)
          .at_most(strongest)
          .required()
          .record(&LeastTensionRequest::cases, "cases", "load cases; without any: as put up");
  return d;
}

LeastTensionRun resolve(const LeastTensionRequest& request, const std::string& path, Names& names) {
  LeastTensionRun run;
  run.tension = request.tension;
  run.guys_from = names.machine.reevings.size();
  if (request.ropes.empty()) names.complaints.push_back({path + ".ropes", "names no rope"});
  Array<std::optional<int>> named;
  for (std::size_t i = 0; i < request.ropes.size(); ++i) {
    const std::string its = fmt::format("{}.ropes[{}]", path, i);
    const auto rope = reeving_of(names, request.ropes[i], its);
    if (rope && names.model.reevings[*rope].closed) {
      names.complaints.push_back({its, "an endless rope is tightened by its 'take_up'"});
    }
    if (std::find(named.begin(), named.end(), rope) != named.end()) {
      names.complaints.push_back({its, "is named twice"});
    }
    named.push_back(rope);
    if (rope) run.chosen.push_back(*rope);
  }
  if (!names.model.contacts.empty() || !names.model.actuators.empty()) {
    names.complaints.push_back(
        {path, "is computed at rest, without contacts and actuators: pull the ropes in turn ('pull')"});
  }
  run.cases.emplace_back("as put up");
  run.models.push_back(names.model);
  for (std::size_t c = 0; c < request.cases.size(); ++c) {
    const LoadCaseRequest& one = request.cases[c];
    const std::string its = fmt::format("{}.cases[{}]", path, c);
    if (one.loads.empty()) names.complaints.push_back({its, "has no loads"});
    if (std::find(run.cases.begin(), run.cases.end(), one.name) != run.cases.end()) {
      names.complaints.push_back({its + ".name", "another case has that name"});
    }
    run.cases.push_back(one.name);
    if (auto model = model_of_case(names.machine, one, its, names.complaints)) run.models.push_back(std::move(*model));
  }
  return run;
}

void solve(const machine::Model& model, LeastTensionRun& run, const std::function<bool()>& go_on) {
  Array<machine::Model> cases = run.models;
  cases.front() = model;
  for (machine::Model& one : cases) {
    keep_lengths(run, model, one);
    keep_screws(model, one);
    one = machine::with_guides_at_start(std::move(one));
  }
  run.answer = least_tension(cases, run.chosen, run.tension, go_on);
}

const Quantities<LeastTensionRow>& least_tension_quantities() {
  using Row = LeastTensionRow;
  static const Quantities<Row> all = {
      {"rope", "", si::one, "the rope",
       [](const Row& r) { return r.run.models.front().reevings[r.rope.reeving].name; }},
      {"unstretched", "L", si::m, "unstretched length", [](const Row& r) { return r.rope.unstretched; }},
      {"taken_out", "dL", si::m, "rope taken out", [](const Row& r) { return r.rope.taken_out; }},
      {"T_least", "T_min", si::N, "least tension over all cases", [](const Row& r) { return r.rope.T_least; }},
      {"governed_by", "", si::one, "the case where that is",
       [](const Row& r) { return r.run.cases[r.rope.governing]; }}};
  return all;
}

}  // namespace taut::study
