#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/study/deck/given.hpp"
#include "taut/study/deck/names.hpp"
#include "taut/study/deck/rope_motion.hpp"
#include "taut/study/line/carriage_way.hpp"

namespace taut::study {

class Watch;

/// One equilibrium, as a deck asks for it.
struct EquilibriumRequest {
  std::optional<std::string> name;  ///< of its tables, when a deck has several
  std::vector<MotionRequest> motion;
  std::optional<std::string> carriage;  ///< put at x, instead of what its mainline or clamp says
  std::optional<double> x;
  std::optional<double> z;             ///< its height too, instead of the length of the rope it rides on
  std::vector<double> along = {1, 0};  ///< direction of x
  bool held = false;                   ///< whatever holds the carriage
  std::optional<GivenRequest> given;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

/// One equilibrium: what was asked, and the answer. `model`: with the carriage in the span where it is put.
struct EquilibriumRun {
  std::string kind = "equilibrium";  ///< of the analysis that asks for it
  std::string ending;                ///< of its tables' names: "", "_2", "_lower"
  std::string words;                 ///< "at rest", "hoist"
  RopeMotion motion;
  std::optional<machine::Prescribed> prescribed;
  bool held = false;
  std::optional<solve::Condition> given;
  machine::Model model;
  solve::EquilibriumResult result;
  bool judged = true;
  /// The state of a machine near this one, with the same ropes: the solve begins there. Where that fails, or there is
  /// none, it begins as for a machine alone.
  std::optional<machine::State> near;
};

/// The request with its names resolved; complaints below `path`.
EquilibriumRun resolve(const EquilibriumRequest& request, const DeckPlace& path, Names& names);

/// Fills `run.model` and `run.result`.
void solve(const machine::Model& model, EquilibriumRun& run);

/// A carriage moved along its line, as a deck asks for it.
struct LoadPathRequest {
  std::optional<std::string> name;
  std::string carriage;
  double from = 0;
  double to = 0;
  int steps = 96;
  std::vector<double> along = {1, 0};  ///< direction of from and to
  std::vector<MotionRequest> motion;
  bool held = false;  ///< whatever holds the carriage
  std::optional<GivenRequest> given;
  bool judge = true;       ///< false: its states do not count for the verdict
  bool one_place = false;  ///< no deck says so: a design looks at one of its places alone
  static const Description& describe();
};

/// The positions of a load path within one span.
struct LoadPathPart {
  machine::Model model;
  LoadPath result;
};

/// What a deck asks, and the answer span by span.
struct LoadPathRun {
  std::string ending;
  std::string words;
  RopeMotion motion;
  Way way;
  bool held = false;
  std::optional<solve::Condition> given;
  std::vector<LoadPathPart> parts;  ///< in the order of the positions
  bool judged = true;
};

/// The request with its names resolved; complaints below `path`.
LoadPathRun resolve(const LoadPathRequest& request, const std::string& path, Names& names);

/// Fills `run.parts`; positions on a support stay without an answer. Where the watch ends it, so do they.
void solve(const machine::Model& model, LoadPathRun& run, Watch& watch);

}  // namespace taut::study
