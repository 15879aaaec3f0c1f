#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/calc/field.hpp"
#include "taut/calc/figure.hpp"
#include "taut/calc/formula.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/units/unit.hpp"

namespace taut {

class LongRows;

/// One line of a calculation note.
struct Step {
  enum class Kind { heading, given, equation, root, note };
  Kind kind = Kind::equation;
  std::string eq;      ///< number in the source, "4", "18*" for a correction; empty when the source gives none
  std::string symbol;  ///< left side
  Formula formula;     ///< right side; of a root: the expression that is zero there
  double value = 0;    ///< SI
  Unit unit;
  std::string source;  ///< "Shoshin et al. 2022, (4)"
  std::string words;   ///< text of a heading or note; of a given quantity its meaning
};

enum class Sense { at_most, at_least };

/// An unverified number that has a part in a check.
struct Doubt {
  std::string trust;   ///< "UNVERIFIED: ..."
  std::string source;  ///< which number it is, and its source in words
};

/// What a part of a machine is. Its name alone does not say it: a rope often has that of its drum.
enum class PartKind { unknown, rope, beam, mast, drum, sheave, carriage, point, body, contact, cylinder, yarder };

struct Part {
  PartKind kind = PartKind::unknown;
  std::string name = {};  ///< empty: the whole machine, or not known

  bool operator==(const Part&) const = default;
  bool operator<(const Part& other) const { return std::tie(name, kind) < std::tie(other.name, other.kind); }
};

/// A value compared with a limit. utilisation: value/limit (at_most) or limit/value (at_least), <= 1 exactly when the
/// check passes; NaN where that is no measure (make_check).
struct Check {
  std::string name;
  double value = 0;
  double limit = 0;
  Unit unit;
  Sense sense = Sense::at_most;
  double utilisation = 0;
  bool passes = false;
  std::string rule;   ///< the rule and its source in words
  std::string trust;  ///< trust in the limit: "verified", "derived", "UNVERIFIED: ...", "user"
  std::string part;   ///< part of the machine, "skyline", by which the report groups; empty: the whole machine
  PartKind kind = PartKind::unknown;  ///< what that part is
  /// False for breaking force, yield and ground: such a check can fail, but it does not count as the limit of a part.
  bool limits = true;
  /// The ropes and beams whose strength it limits: they are judged by it. Empty: a limit of something else, a
  /// clearance, an angle, a life. A mast's name is not enough: it may be a rope's, and the mast may be several beams or
  /// none.
  std::vector<std::string> covers = {};
  std::string where = {};  ///< the state with the largest utilisation, "load path, in, x = 12 m"; empty: see `rule`
  bool refused = false;    ///< its limit is unverified, and the deck refuses such limits
  /// All unverified numbers that have a part in it. Empty, and `trust` is unverified: the limit alone, as in `rule`.
  std::vector<Doubt> doubts = {};
};
inline Part part_of(const Check& check) { return {.kind = check.kind, .name = check.part}; }
/// Whether a check is the limit that a rope or a beam needs to be judged.
inline bool judges(const Check& check, const std::string& part) {
  return check.limits && std::find(check.covers.begin(), check.covers.end(), part) != check.covers.end();
}
/// The checks grouped by part, the largest utilisation first within each group, the groups in the order of their worst
/// check. Where no check names a part the order is unchanged.
std::vector<Check> grouped(std::vector<Check> checks);
/// What a value is held against, by which rule and how far that may be trusted: see Check.
struct Bound {
  Sense sense = Sense::at_most;
  double limit = 0;  ///< SI
  std::string rule;
  std::string trust;
  std::vector<Doubt> doubts = {};
};
/// A check with utilisation and passes computed. A value within 1e-9 of its limit lies on it, and passes. A NaN value
/// never passes. Temperatures count from 0 degC. Where limit
/// or value are no measure of each other (a limit of 0, a value below 0), the utilisation is NaN.
Check make_check(std::string name, double value, const Unit& unit, Bound bound);

/// A result value, SI.
struct Value {
  std::string name;
  double value = 0;
  Unit unit;
  std::string symbol;
  std::string label;
  std::string source;
  bool detail = false;  ///< shown in the appendix of a report only: the analysis is not about it
  std::string heading =
      {};  ///< name of the analysis under which a report shows it, "equilibrium, inhaul"; may be empty
};

struct Column {
  std::string name;
  Unit unit;
  bool detail = false;  ///< shown in the appendix of a report only
};
/// A number (SI; NaN: no value in this row) or a text.
using Cell = std::variant<double, std::string>;
struct Table {
  std::string name;
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
  std::shared_ptr<const LongRows> long_rows = nullptr;  ///< rows of a long series; `rows` is then empty
  bool detail = false;                                  ///< shown in the appendix of a report only
  std::string heading = {};                             ///< as in Value
};

/// A line of a machine in space, over time. Its number of points may differ from frame to frame.
struct SceneLine {
  std::string name;  ///< "skyline"
  Role role = Role::rope;
  std::vector<std::vector<std::array<double, 3>>> points;  ///< [frame][point], m
  std::vector<std::vector<double>> tension;                ///< [frame][point], N; empty: not known
};
struct ScenePoint {
  std::string name;
  double radius = 0;                            ///< of a sheave or drum, m; 0: a point
  std::vector<std::array<double, 3>> at;        ///< [frame], m
  std::vector<std::array<double, 3>> velocity;  ///< [frame], m/s; empty: at rest
};
/// A machine in space at one or several times, for a 3D viewer.
struct Scene {
  std::string name;       ///< a file name without ending
  std::vector<double> t;  ///< s; of a machine at rest a single 0
  std::vector<SceneLine> lines;
  std::vector<ScenePoint> points;
};

/// A file of the result, written unchanged.
struct Attachment {
  std::string name;  ///< "state.json"
  std::string text;
};

/// One input as it was used: numbers in SI, or a text.
struct Given {
  std::string key;
  std::string symbol;
  std::string words;
  Unit unit;
  std::vector<double> numbers;
  std::string text;
  bool is_default = false;
  bool chosen = false;  ///< not given by the deck: found by its `design:`
};

/// A quantity as the source prints it, as corrected, and from the exact solution where there is one. NaN: no value.
struct Comparison {
  std::string quantity;
  std::string symbol;
  Unit unit;
  double printed = 0;
  double corrected = 0;
  double exact = 0;
  std::string build_by;  ///< which value to use and why: "corrected: ..."
  bool printed_unsafe = false;
  bool corrected_decides = true;  ///< false: the choice or the answer follows the printed value
};

/// The states of one analysis that have no answer.
struct MissingStates {
  std::string analysis;  ///< "load path"
  int missing = 0;
  int places = 0;        ///< number of states asked for, including the missing ones
  std::string first;     ///< the first missing state, "x = 12 m"
  std::string reason;    ///< why the first one has no answer
  std::string all = {};  ///< all of them, "x = 12 m to x = 14 m (2 states); x = 20 m"; empty: not told
};

/// What the head of a report says of the order: `project:` of a deck. Every text may be empty; empty ones are not
/// printed, but for the line of the signature.
struct Project {
  std::string project;     ///< "Hinterwald, block 12"
  std::string number;      ///< of the order
  std::string author;      ///< who calculated
  std::string checked_by;  ///< who signs
  std::string date;        ///< as it is to be printed
  std::string revision;    ///< "A"

  static const Description& describe();
};

/// What a sentence of `unmade`, or an unsafe warning, is about.
struct About {
  Part part = {};
  /// It says that no state loads this, "rope w, loaded": what nothing loads needs no check. Empty: no such sentence.
  std::string no_load = {};
};

/// One line of the main answer: what to build, or what the machine carries.
struct Answer {
  std::string label;  ///< "Build", "Carries"
  std::string text;   ///< in the display units: "skyline EN 12385-4|6x36-IWRC|20|1960, 382 m"
};

/// Everything that a report needs. All numbers SI.
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
  std::vector<Table> series;  ///< long tables that are only written to files, such as time.csv; the first column is the
                              ///< independent variable. Those of detail are in series.h5 alone
  std::vector<Scene> scenes;
  std::vector<Attachment> attachments;
  std::vector<std::string> assumptions;
  std::vector<std::string> warnings;
  std::vector<std::string> unsafe;     ///< the subset of `warnings` that makes an answer unsafe, see warn_unsafe
  std::vector<MissingStates> missing;  ///< by analysis
  std::vector<std::string> unmade;     ///< checks that the deck asks for and that yield no number, one sentence each
  std::vector<std::string> unjudged;   ///< parts that need a limit and have none
  std::map<std::string, About> about;  ///< of sentences in `unmade`, `unjudged`, `unsafe`, as far as it is known
  std::set<std::string> loaded;        ///< what states load, see About::no_load; also those of other values of a sweep
  std::vector<std::string> exempt;     ///< parts that the deck takes out of the verdict
  std::vector<std::string> left_out;   ///< analyses that the deck takes out of the verdict: `judge: false`
  std::vector<std::string> beside;     ///< parts that the verdict does not cover: anchors, sheaves, carriages
  std::string preface;                 ///< put before the sentence of the verdict: "The deck breaks the skyline at 2 s"
  /// Ropes, sections and values that the calculation itself has chosen, by their part; a study of many cases tells
  /// where they choose otherwise.
  std::map<std::string, std::string> choices;
  std::vector<Answer> answers;  ///< the main answer, line by line: page 1 of the report and the head of the terminal
  std::string key_figure;       ///< name of the figure of page 1; empty: the first
  std::string headline;         ///< the main answer where it is not a utilisation: "Carries 2.96 t, least at ..."
  Diagnostics errors;
  /// Ended from outside; the result is what was computed before, and `message` says up to where.
  bool interrupted = false;
  Project project;
  std::string deck_name;
  std::string deck_hash;
  std::vector<std::string> overrides;          ///< "input.span=200 m": values set over the deck
  std::map<std::string, std::string> display;  ///< kind of quantity -> unit, as the deck asks

  const Value* find_value(const std::string& name) const;
  const Table* find_table(const std::string& name) const;
};

/// The table without its columns of detail.
Table without_detail(const Table& t);

/// Exit code of the program, by the verdict (verdict.hpp): 0 computed; 2 bad deck; 3 no answer; 4 fails or not judged
/// (class `unasked` only with `strict`); 130 interrupted.
int exit_code(const Result& r, bool strict = false);

/// Adds an unsafe warning: the verdict can then be no better than "passes, with warnings". Keep the sentence within 160
/// characters.
void warn_unsafe(Result& r, std::string sentence);

/// Leaves a check unmade, and warns of it.
void leave_unmade(Result& r, std::string sentence, About about);

/// While it lives, checks and what is left unmade, without a limit, or warned of as unsafe are about one part, unless
/// they are said to be about another.
class AboutPart {
 public:
  AboutPart(Result& r, Part part);
  ~AboutPart();
  AboutPart(const AboutPart&) = delete;
  AboutPart& operator=(const AboutPart&) = delete;

 private:
  Result& r_;
  Part part_;
  std::size_t checks_, unmade_, unjudged_, unsafe_;
};

/// Drops what says that no state loads a thing which `loaded` has, and of several such sentences of one thing all but
/// the first.
void drop_loaded(Result& r);

/// Takes parts out: their checks go, and what is left unmade or without a limit of them; what is unsafe of them stays
/// as a plain warning.
void take_out(const std::vector<Part>& parts, Result& r);

/// The numbers of an output struct that were computed (not NaN), in the order of its description.
std::vector<Value> values_of(const Description& d, const void* output);

/// The inputs as used, with dotted keys for nested ones ("span.length", "cases[1].falls"). Optional inputs that are not
/// set are left out.
std::vector<Given> given_of(const Description& d, const void* input);

}  // namespace taut
