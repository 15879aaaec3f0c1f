#pragma once
#include <optional>
#include <string>

#include "taut/calc/quantity.hpp"
#include "taut/solve/modes.hpp"
#include "taut/study/transient.hpp"

namespace taut::study {

/// Small vibrations of the machine about where its motion would begin.
struct ModesRequest {
  std::optional<std::string> name;  ///< ending of its tables' names
  int count = 10;
  TransientRequest::Start start = TransientRequest::Start::settled;
  double damping_ratio = 0;
  bool rope_mass = true;
  TransientRequest::Branches branches = TransientRequest::Branches::straight;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

/// What a deck asks, and the answer.
struct ModesRun {
  std::string ending;
  std::string words = "modes";  ///< "modes, loaded"
  solve::ModesOptions options;
  machine::Model model;
  solve::ModesResult result;
};

/// The request, checked against the machine; complaints below `path`.
ModesRun resolve(const ModesRequest& request, const std::string& path, Names& names);

/// Fills `run.model` and `run.result`.
void solve(const machine::Model& model, ModesRun& run);

/// One mode of a set: sheaves with a loss stuck, or released.
struct ModeRow {
  const ModesRun& run;
  const solve::ModeSet& set;
  std::size_t mode = 0;  ///< from 0
};
/// What a body does in a mode.
struct ModeShapeRow {
  ModeRow of;
  int body = 0;
};
const Quantities<ModeRow>& mode_quantities();
const Quantities<ModeShapeRow>& mode_shape_quantities();

/// "no loss" where no sheave has one, else "stuck" or "released".
std::string sheaves_words(const ModesRun& run, const solve::ModeSet& set);

}  // namespace taut::study
