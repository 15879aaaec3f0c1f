#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/none.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/study/deck/given.hpp"

namespace taut::study {

struct Names;

struct InstallationGivenRequest {
  std::optional<double> tension;      ///< N
  RopeEnd at = RopeEnd::start;        ///< of a tension
  std::optional<double> length;       ///< m
  std::optional<double> sag;          ///< m
  std::optional<int> span;            ///< of a sag, from 1
  std::optional<double> temperature;  ///< K: where it holds; the length is kept from there
  static const Description& describe();
};

/// An empty rope as it is put up, as a deck asks for it.
struct InstallationRequest {
  std::optional<std::string> name;
  std::string reeving;
  std::vector<double> temperatures;  ///< K
  std::optional<double> from, to;    ///< K
  std::optional<int> steps;
  std::optional<InstallationGivenRequest> given;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

/// A machine in which one rope is empty, as during rigging.
struct EmptyLine {
  Outcome outcome;  ///< infeasible: the rope ends on a part that was removed
  machine::Model model;
  int reeving = 0;                   ///< index of the rope in this model
  std::vector<std::string> removed;  ///< names of the bodies, carriages and ropes removed
};

/// Exceptions while a rope is put up, by index in the model.
struct PutUpWith {
  Array<int> bodies;  ///< carriages and bodies that stay on the rope
  Array<int> loads;   ///< loads on these bodies that stay; loads on other parts stay in any case
  Array<int> absent;  ///< other ropes that do not exist yet
};

/// Removes the carriages that ride on the rope, the ropes that end on them or run through them (a mainline is not
/// rigged yet), bodies that then hang on nothing, and carriages on other ropes that roll there without any rope that
/// pulls them. Everything else (masts, guys, other ropes) stays.
EmptyLine empty_line(const machine::Model& model, int reeving, const PutUpWith& with = {});

/// Results of an empty rope as it is put up.
struct Installation {
  Outcome outcome;
  double T_start = 0, T_end = 0;  ///< N
  double H = 0;                   ///< of the first branch, N
  Array<double> sag;              ///< [branch]: below its chord at half its horizontal length, m
  double unstretched = 0;         ///< at the reference temperature, including arcs on sheaves, m
  double cut = 0;        ///< unstretched at the temperature of the installation: the length to measure on the ground, m
  double stretched = 0;  ///< under its tensions, at that temperature, m
  solve::Conditioned at;
};

/// The state of the empty line under a condition. `near`: the state at a similar temperature, as a first guess.
Installation installation(const EmptyLine& line, const solve::Condition& given,
                          const std::optional<machine::State>& near = std::nullopt);

/// Lengths of one rope in a state, m.
struct RopeLengths {
  double unstretched = 0;  ///< at the reference temperature, whole rope
  double cut = 0;          ///< the same at the temperature of the rope
  double stretched = 0;    ///< under load at its temperature, whole rope
  double free = 0;         ///< part of `stretched` between sheaves
  double on_sheaves = 0;   ///< part of `stretched` on sheaves, saddles and drives
};
RopeLengths lengths_of(const machine::Model& model, const solve::EquilibriumResult& result, int reeving);

/// The rope at one temperature, K; NaN: the machine's, whatever that is.
struct InstallationAt {
  double temperature = none;
  Installation at;
};

/// What a deck asks, and the answer by temperature.
struct InstallationRun {
  std::string ending;
  std::string words;  ///< name of the rope
  int reeving = 0;
  std::vector<double> temperatures;  ///< K; empty: the machine's, whatever it is
  std::optional<InstallationGivenRequest> given;
  const machine::Machine* machine = nullptr;
  std::vector<InstallationAt> rows;
};

/// The request with its names resolved; complaints below `path`.
InstallationRun resolve(const InstallationRequest& request, const std::string& path, Names& names);

/// Fills `run.rows`; one alone where the rope can't be put up at all.
void solve(const machine::Model& model, InstallationRun& run);

/// What a rope has at each temperature; sags of its spans besides.
const Quantities<InstallationAt>& installation_quantities();
/// Lengths of one rope.
const Quantities<RopeLengths>& length_quantities();

}  // namespace taut::study
