#pragma once
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/base/long_rows.hpp"
#include "taut/calc/field.hpp"
#include "taut/calc/figure.hpp"
#include "taut/calc/formula.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/units/unit.hpp"

namespace taut {

/// One line of a calculation note.
struct Step {
  enum class Kind { heading, given, equation, root, note };
  Kind kind = Kind::equation;
  std::string eq;      ///< number in the source, "4", "18*" for a correction; empty when the source gives none
  std::string symbol;  ///< left side
  Formula formula;     ///< right side; for a root the expression that is zero
  double value = 0;    ///< SI
  Unit unit;
  std::string source;  ///< "Shoshin et al. 2022, (4)"
  std::string words;   ///< heading or note text; what a given quantity is
};

enum class Sense { at_most, at_least };

/// A value against a limit. utilisation <= 1 exactly when it passes (value/limit or limit/value).
struct Check {
  std::string name;
  double value = 0;
  double limit = 0;
  Unit unit;
  Sense sense = Sense::at_most;
  double utilisation = 0;
  bool passes = false;
  std::string rule;    ///< the rule and its source in words
  std::string trust;   ///< "verified", "derived", "UNVERIFIED: ...", "user": of the limit
  std::string part;    ///< of the machine, "skyline": the report groups by it; empty: the machine as a whole
  bool limits = true;  ///< false: breaking, yield, ground. Such a check can only fail; a part needs a limit beside it
  std::string where = {};  ///< the state in which it is worst, "load path, in, x = 12 m"; empty: the rule says it
  bool refused = false;    ///< its limit is unverified, and the deck refuses such limits
};
/// Groups of checks by part, and in each the worst first; the groups by their worst check. Without any part: as it was.
std::vector<Check> grouped(std::vector<Check> checks);
/// What a value is held against, by which rule and how far that may be trusted: see Check.
struct Bound {
  Sense sense = Sense::at_most;
  double limit = 0;  ///< SI
  std::string rule;
  std::string trust;
};
/// Fills utilisation and passes. NaN never passes.
Check make_check(std::string name, double value, const Unit& unit, Bound bound);

/// A result value, SI.
struct Value {
  std::string name;
  double value = 0;
  Unit unit;
  std::string symbol;
  std::string label;
  std::string source;
};

struct Column {
  std::string name;
  Unit unit;
};
/// A number (SI; NaN: no value here) or a text.
using Cell = std::variant<double, std::string>;
struct Table {
  std::string name;
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
  std::shared_ptr<const LongRows> long_rows = nullptr;  ///< of a long series, in place of `rows`
};

/// A line or a cloud of points of a machine in space, followed through time. Its number of points may change.
struct SceneLine {
  std::string name;  ///< "skyline"
  Role role = Role::rope;
  std::vector<std::vector<std::array<double, 3>>> points;  ///< [frame][point], m
  std::vector<std::vector<double>> tension;                ///< [frame][point], N; empty: none
};
struct ScenePoint {
  std::string name;
  double radius = 0;                            ///< of a round, m; 0: a point
  std::vector<std::array<double, 3>> at;        ///< [frame], m
  std::vector<std::array<double, 3>> velocity;  ///< [frame], m/s; empty: it rests
};
/// A machine in space at one time or several: what a viewer of three dimensions shows.
struct Scene {
  std::string name;       ///< a file name without ending
  std::vector<double> t;  ///< s; a machine at rest: one 0
  std::vector<SceneLine> lines;
  std::vector<ScenePoint> points;
};

/// A file that belongs to the result and is written as it is.
struct Attachment {
  std::string name;  ///< "state.json"
  std::string text;
};

/// One input as it was used: number(s) in SI or a text.
struct Given {
  std::string key;
  std::string symbol;
  std::string words;
  Unit unit;
  std::vector<double> numbers;
  std::string text;
  bool is_default = false;
};

/// A quantity as the source prints it, as it should be, and (where the engine solves the same machine) exact; NaN: not
/// there.
struct Comparison {
  std::string quantity;
  std::string symbol;
  Unit unit;
  double printed = 0;
  double corrected = 0;
  double exact = 0;
  std::string build_by;  ///< "corrected: ..." which to use and why
  bool printed_unsafe = false;
  bool corrected_decides = true;  ///< false: what is chosen or answered follows the printed value
};

/// States of an analysis that have no answer.
struct MissingStates {
  std::string analysis;  ///< "load path"
  int missing = 0;
  int places = 0;      ///< asked for, the missing ones among them
  std::string first;   ///< "x = 12 m"
  std::string reason;  ///< of the first one
};

/// Everything a report needs, and nothing else does: SI throughout.
struct Result {
  std::string title;
  std::string method;
  std::string method_title;
  std::string source;  ///< citation of the method
  Status status = Status::ok;
  std::string message;
  std::vector<Given> given;
  std::vector<Value> values;
  std::vector<Table> tables;
  std::vector<Check> checks;
  std::vector<Step> steps;
  std::vector<Comparison> comparisons;
  std::vector<Figure> figures;
  std::vector<Table> series;  ///< long tables for files, such as time.csv; the first column is what they run over
  std::vector<Scene> scenes;
  std::vector<Attachment> attachments;
  std::vector<std::string> assumptions;
  std::vector<std::string> warnings;
  std::vector<std::string> unsafe;     ///< those of the warnings that make an answer unsafe: see warn_unsafe
  std::vector<MissingStates> missing;  ///< by analysis
  std::vector<std::string> unmade;     ///< checks that were asked for and have no number, one sentence each
  std::vector<std::string> unjudged;   ///< parts in the verdict's scope without a limit
  std::vector<std::string> exempt;     ///< parts that the deck takes out of the verdict
  std::vector<std::string> left_out;   ///< analyses that the deck takes out of the verdict: `judge: false`
  std::vector<std::string> beside;     ///< parts that the verdict does not speak of: anchors, sheaves, carriages
  std::string preface;                 ///< before the verdict's sentence: "The deck breaks the skyline at 2 s"
  std::string headline;                ///< the key answer where it is no utilisation: "Carries 2.96 t, least at ..."
  Diagnostics errors;
  bool interrupted = false;  ///< from outside; what is there was computed before, and `message` says up to when
  std::string deck_name;
  std::string deck_hash;
  std::vector<std::string> overrides;          ///< "input.span=200 m": what was set over the deck
  std::map<std::string, std::string> display;  ///< kind of quantity -> unit, as the deck asks

  const Value* find_value(const std::string& name) const;
  const Table* find_table(const std::string& name) const;
};

/// 0 computed; 2 bad deck; 3 no answer; 4 fails or not judged (of class `unasked` only with `strict`); 130 interrupted.
/// It follows the verdict (verdict.hpp).
int exit_code(const Result& r, bool strict = false);

/// A warning of class unsafe, of 160 characters at most where it can be: the answer no longer passes without warnings.
void warn_unsafe(Result& r, std::string sentence);

/// The numbers of an output struct that were computed (not NaN), in the order of its description.
std::vector<Value> values_of(const Description& d, const void* output);

/// The inputs as used, nested ones with dotted keys ("span.length", "cases[1].falls"); unset optional ones left out.
std::vector<Given> given_of(const Description& d, const void* input);

/// The comparisons as a table `comparison` (SI, unit as text), empty when there are none.
Table comparison_table(const std::vector<Comparison>& all);

}  // namespace taut
