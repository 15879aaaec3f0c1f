#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/calc/result.hpp"
#include "taut/units/unit.hpp"

namespace taut::app {

/// A name of a study and where the deck has it: "study.of[0]".
struct CaseName {
  std::string name;
  std::string place;
};

/// What a study changes in a deck, and what it asks of it.
struct CaseQuestion {
  std::vector<CaseName> inputs;   ///< numbers by their whole path: "machine.loads[0].mass", "input.span"
  std::vector<CaseName> outputs;  ///< values by their analysis and name: "equilibrium.skyline.safety_factor"
};

/// One number that changes.
struct CaseInput {
  std::string path;
  Unit unit;
  Range range;             ///< that the deck's field allows, SI
  double base = 0;         ///< of the deck, SI; NaN where it gives none
  std::string place = {};  ///< as of study::Parameter: the same for all spellings of the path
};

/// One value that is asked for.
struct CaseOutput {
  std::string name;
  Unit unit;
  std::string label;
  double base = 0;  ///< of the deck as it is, SI
};

/// What a run of one case says against it, whatever its outputs are.
struct CaseFlaw {
  enum class Kind {
    unsafe,
    unmade,
    fails,
    unlimited,  ///< a part needs a limit of its strength, which neither the case nor the deck as it is asks for
    chooses     ///< the case has chosen another rope, section or value than the deck as it is
  };
  Kind kind = Kind::unsafe;
  /// Of `fails` and `unlimited`: the name of the check, "skyline.T_max". Of `unmade`: the only value that can't be
  /// judged, empty where the whole case can't be.
  std::string check = {};
  std::string words = {};        ///< why, one sentence
  bool fact = false;             ///< of `fails`: no limit of the deck can allow it: breaking force, yield, ground
  Sense sense = Sense::at_most;  ///< of `fails`: on which side of its limit the check holds its value
  /// The analysis whose states it is about, as outputs name it: "equilibrium_2"; empty: all that the verdict sees, or
  /// of a method.
  std::string analysis = {};
};

/// One case. Not ok: it has no answer, and the outputs are NaN.
struct CaseAnswer {
  std::vector<double> outputs;
  Outcome outcome;
  std::vector<CaseFlaw> flaws = {};  ///< each check that fails, the first thing unmade, the first that is unsafe
  std::map<std::string, double> weaker = {};  ///< strengths below those of CaseModel
};

/// A part that needs a limit of its strength and that no check of the deck as it is limits.
struct UnaskedPart {
  std::string name;
  std::string why = {};  ///< where a run of the deck has such a check: why the cases have not
  bool is_beam = false;  ///< its strength is that of a stress, not of a tension
};

/// What a run of the whole deck as it is tells and its cases do not.
struct Unasked {
  std::vector<UnaskedPart> parts = {};
  std::vector<Check> unmade = {};                ///< checks of the deck that no case makes
  std::string analysis = {};                     ///< whose states they are about; empty: of several
  std::vector<CaseFlaw> fails = {};              ///< those of them that the deck as it is fails
  std::map<std::string, double> strengths = {};  ///< as in CaseModel
};

/// A deck as a function of numbers. It was read and compiled once; what it needs besides the outputs is left out: other
/// analyses, the checks of `checks:`, tables, figures, formulas. The analyses that it needs are judged.
struct CaseModel {
  std::vector<CaseInput> inputs;
  std::vector<CaseOutput> outputs;
  /// What the deck takes out of the verdict of each case: parts by `exempt`, analyses by `judge: false`.
  std::vector<std::string> exempt = {}, left_out = {};
  /// Analyses that count in a run of the deck and that no output needs, as outputs would name them.
  std::vector<std::string> not_run = {};
  /// Breaking forces and yields of the parts of the deck as it is, SI.
  std::map<std::string, double> strengths = {};
  /// The analyses that load and judge each part in a case, as outputs name them.
  std::map<std::string, std::vector<std::string>> loaded_in = {};
  /// Found by a run of the whole deck; none: there is nothing of that kind.
  std::function<Unasked()> unasked = {};
  /// One number (SI) for each input. A pure function: the same numbers give the same bits, whatever was asked before
  /// and from whichever thread. Every case begins from the equilibrium of the deck as it is, and where it does not come
  /// from there to an answer, as the machine of its numbers alone would.
  std::function<CaseAnswer(std::span<const double> values)> answer;
};

/// Why a deck can't be asked that: mistakes at their places, or the deck itself has no answer.
struct NoCases {
  std::vector<Complaint> complaints = {};
  Outcome outcome = {};
};

using MadeCases = tl::expected<CaseModel, NoCases>;

}  // namespace taut::app
