#pragma once
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"
#include "taut/catalogue/rope.hpp"
#include "taut/catalogue/section.hpp"
#include "taut/design/design_deck.hpp"
#include "taut/units/display.hpp"

/// The block `design:` of machines and methods: what both need to be searched is a DesignTask; design_space.hpp makes
/// its candidates, design_machine.hpp and design_method.hpp the rest of it, design_search.hpp searches it.
namespace taut::design {

/// A rope that is free, with its candidates in the order of what is sought.
struct RopeCandidates {
  std::string name;  ///< of the machine's or the method's rope
  std::vector<catalogue::RopeRow> rows;
  std::vector<double> moduli;  ///< by row, Pa, on the metallic area
  std::vector<double> costs;   ///< of a metre, ascending; of `smallest` the diameter
};

/// A beam or mast whose section is free, in the order of what is sought.
struct SectionCandidates {
  std::string name;
  std::vector<catalogue::SectionRow> rows;
  std::vector<double> costs;  ///< of a metre, ascending; of `smallest` the height
};

/// A number that is free, and where its grid is tried.
struct UnknownValues {
  std::string name;
  std::string parameter;                ///< its path
  std::vector<std::string> along_with;  ///< paths of others that move by as much
  Unit unit;
  double low = 0, high = 0;    ///< SI
  std::vector<double> values;  ///< of the grid, SI; with a start also that
  double price = 0;
};

/// One load case: paths with the values that they have in it, SI.
struct DesignCase {
  std::string name;
  std::vector<std::pair<std::string, double>> settings;
};

/// What a design searches through.
struct DesignSpace {
  std::vector<RopeCandidates> ropes;
  std::vector<SectionCandidates> sections;  ///< their choices behind those of the ropes
  std::vector<UnknownValues> unknowns;
  std::vector<DesignCase> cases;
};

/// One design: an index into each list of candidates, ropes before sections, and a value of each unknown.
struct DesignPlace {
  std::vector<std::size_t> choice;
  std::vector<double> values;
};

/// How much of a calculation is wanted: `quick` may leave the rest out once a check has failed.
enum class Depth { quick, checks, report };

/// How the load cases of a design have fared, of those that were looked at.
struct AnswersOfCases {
  std::vector<std::string> with;                             ///< that have an answer
  std::vector<std::pair<std::string, std::string>> without;  ///< that have none, and why
  bool others_pass = false;                                  ///< all were looked at, and those with an answer pass
};

/// What a design gives. tension: the largest of what least_tension looks at, N; NaN where there is none.
struct DesignRun {
  Result result;
  double tension = 0;
  AnswersOfCases cases = {};
};

/// Lengths of what is paid by length, for values of the unknowns, and what else there is to pay.
struct DesignLengths {
  std::vector<double> ropes, sections;  ///< m
  double rest = 0;                      ///< of what is sought, in its unit: kg of `lightest`
  bool operator==(const DesignLengths&) const = default;
};

/// A design to be searched. All functions may be called as often as wished, with any place of the space.
struct DesignTask {
  DesignRequest request;
  DesignSpace space;
  std::map<std::string, std::size_t> list_of;  ///< by the part of a check the list whose choice it judges
  std::function<DesignLengths(const std::vector<double>& values)> lengths;
  /// `ask`: as in a Job, heard by long calculations.
  std::function<DesignRun(const DesignPlace&, Depth, const std::function<bool(const Progress&)>& ask)> run;
  std::function<bool(const Progress&)> progress;
  std::string method_title;
  std::vector<Given> given;  ///< the deck's own
  /// The inputs of a design without any load case; may be empty.
  std::function<std::vector<Given>(const DesignPlace&)> given_with;
  Display display;  ///< units for the sentences of the result
  /// Adds the picture of a design without an answer; may be empty.
  // NOLINTNEXTLINE(readability-redundant-member-init): keeps it optional in a list of initial values
  std::function<void(const DesignPlace&, Result&)> picture = {};
};

/// The first of all candidates, every unknown at the beginning of its grid.
DesignPlace first_place(const DesignSpace& space);

/// The least choice that passes all checks, as a whole result (design_tables.hpp): at every place of the grid of
/// unknowns the choice of least cost, of these the least; among equal ones that with the most reserve; then the
/// unknowns moved on within their ranges (design_search.hpp). Each choice is solved with its own weight and stiffness;
/// nothing is assumed of how they act. Infeasible: none passes.
Result run_design(const DesignTask& task);

}  // namespace taut::design
