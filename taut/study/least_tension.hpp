#pragma once
#include <functional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/study/deck/names.hpp"

namespace taut::study {

/// Loads that act together after the ropes are up.
struct LoadCaseRequest {
  std::string name;
  std::vector<machine::description::Load> loads;  ///< beside those of the machine
  static const Description& describe();
};

/// Ropes just so tight that none of them gets slacker than that in any case.
struct LeastTensionRequest {
  std::vector<std::string> ropes;
  double tension = 0;  ///< N
  std::vector<LoadCaseRequest> cases;
  static const Description& describe();
};

/// A rope whose length was found.
struct LeastTension {
  int reeving = 0;
  double unstretched = 0;  ///< at the reference temperature, m
  double taken_out = 0;    ///< of the length that it had, m
  double T_least = 0;      ///< least tension anywhere in it over all cases, N
  int governing = 0;       ///< the case where that is
  Array<double> T_min;     ///< by case: its least tension, N
};

/// `outcome` not ok: the message says which rope or case; nothing else is a result.
struct LeastTensionResult {
  Outcome outcome;
  bool interrupted = false;
  Array<LeastTension> ropes;           ///< as chosen
  Array<solve::EquilibriumResult> at;  ///< by case
  Array<machine::Model> models;        ///< by case, with the lengths found
  int iterations = 0;
};

/// Lengths of the chosen ropes for which each of them has the tension `least` (N, > 0) where it is slackest in the case
/// that slackens it most, whichever way friction acts: pretensioned as little as keeps them taut. `cases`: one machine
/// under several loads, with the same reevings, the first one as it is put up. Newton on all lengths together, each
/// rope by its governing case; derivatives of tensions by lengths are differences of equilibria. Infeasible where no
/// lengths do.
LeastTensionResult least_tension(const Array<machine::Model>& cases, const Array<int>& chosen, double least,
                                 const std::function<bool()>& go_on = {});

/// Least tension anywhere in a rope, N.
double least_tension_of(const solve::EquilibriumResult& result, int reeving);

/// What a deck asks, and the answer.
struct LeastTensionRun {
  std::string ending;
  std::string words;
  Array<int> chosen;
  double tension = 0;            ///< N
  Array<std::string> cases;      ///< their names; the first: as put up
  Array<machine::Model> models;  ///< by case
  std::size_t guys_from = 0;     ///< reevings from there on are guys
  LeastTensionResult answer;
};

/// The request, a part of another one, with its names resolved; complaints below `path`.
LeastTensionRun resolve(const LeastTensionRequest& request, const std::string& path, Names& names);

/// Fills `run.answer`. `model`: with guys and lines put up, which keep their lengths where they are not chosen.
void solve(const machine::Model& model, LeastTensionRun& run, const std::function<bool()>& go_on);

/// A rope whose length was found; least tensions by case besides.
struct LeastTensionRow {
  const LeastTensionRun& run;
  const LeastTension& rope;
};
const Quantities<LeastTensionRow>& least_tension_quantities();

}  // namespace taut::study
