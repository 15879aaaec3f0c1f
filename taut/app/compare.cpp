#include "taut/app/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include "taut/app/fingerprint.hpp"
#include "taut/base/on_limit.hpp"
#include "taut/calc/answers.hpp"
#include "taut/calc/shown.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/io/deck/deck.hpp"
#include "taut/io/deck/include.hpp"
#include "taut/io/deck/override.hpp"
#include "taut/io/deck/parameters.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/display.hpp"
#include "taut/units/parse.hpp"

namespace taut::app {

const Description& ComparedValue::describe() {
  static const Description d =
      Describe<ComparedValue>()
          .field(&ComparedValue::what, "what", "in words")
          .required()
          .field(&ComparedValue::deck, "deck", "the deck, beside this file")
          .required()
          .field(&ComparedValue::value, "value", "name of the result value")
          .required()
          .field(&ComparedValue::published, "published", "as the source prints it, with its unit")
          .field(&ComparedValue::tolerance, "tolerance",
                 "'2 %' of the published value, or a quantity; of a temperature in K")
          .field(&ComparedValue::reference, "reference", "of another calculation with the same data, with its unit")
          .field(&ComparedValue::reference_tolerance, "reference_tolerance",
                 "'2 %' of the reference, or a quantity; of a temperature in K")
          .field(&ComparedValue::set, "set", "values put over the deck's, as with --set")
          .field(&ComparedValue::note, "note", "a remark");
  return d;
}

const Description& ComparedSet::describe() {
  static const Description d = Describe<ComparedSet>()
                                   .field(&ComparedSet::source, "source", "where the values are published")
                                   .required()
                                   .record(&ComparedSet::values, "values", "what is compared")
                                   .required()
                                   .field(&ComparedSet::errata, "errata", "mistakes of the source, in words");
  return d;
}

namespace {

namespace fs = std::filesystem;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Reads the set: everything around `compare` as in a deck.
ComparedSet read_compared(const Job& job, io::Document& document, Result& r) {
  ComparedSet set;
  auto parsed = io::parse(job.text, job.name);
  if (!parsed) {
    r.errors = parsed.error();
    return set;
  }
  document = std::move(*parsed);
  r.errors = document.mistakes;
  if (!io::resolve_includes(document, r.errors)) return set;
  const std::vector<std::string> keys = {"taut", "title", "display", "compare", "parameters"};
  for (const std::string& one : job.set) io::override_value(document, one, keys, r.errors);
  io::resolve_parameters(document, r.errors);
  io::Node inner = document.root;
  const io::Entry* compare = document.root.find_entry("compare");
  for (const io::Entry& e : document.root.entries) {
    const bool known =
        e.key == "taut" || e.key == "title" || e.key == "display" || e.key == "compare" || e.key == "parameters";
    if (!known)
      io::add(r.errors, e.key_spot,
              fmt::format("{} is not a key of a set; it has taut, title, compare", io::in_quotes(e.key)));
    if (e.key == "title" && e.value.kind == io::Node::Kind::scalar) r.title = e.value.text;
  }
  if (compare == nullptr) {
    io::add(r.errors, document.root.spot, "there is nothing to compare: 'compare' has 'source' and 'values'");
    return set;
  }
  r.display = io::read_display(document.root, r.errors).units();
  io::read(compare->value, ComparedSet::describe(), &set, "compare", r.errors);
  return set;
}

/// The results of the decks, each computed once.
class DeckRuns {
 public:
  DeckRuns(const Job& set, std::size_t count) : set_(set), folder_(fs::path(set.name).parent_path()), count_(count) {}

  const Result& of(const ComparedValue& one, const io::Spot& spot, Result& r) {
    const std::string key = fmt::format("{}\n{}", one.deck, fmt::join(one.set, "\n"));
    const auto known = all_.find(key);
    if (known != all_.end()) return known->second;
    Result& made = all_[key];
    const auto job = read_job((folder_ / one.deck).string());
    if (!job) {
      io::add(r.errors, spot, job.error().message);
      return made;
    }
    Job run_job = *job;
    run_job.set = one.set;
    const double before = static_cast<double>(all_.size() - 1) / static_cast<double>(count_);
    if (set_.progress) {
      run_job.progress = [this, before, &one](const Progress& p) {
        return set_.progress(
            {.what = one.deck, .done = before + p.done / static_cast<double>(count_), .words = p.words});
      };
    }
    made = run(run_job);
    for (const Diagnostic& d : made.errors) r.errors.push_back(d);
    r.interrupted = r.interrupted || made.interrupted;
    hashes.push_back(made.deck_hash);
    tell_of(one, made);
    return made;
  }

  std::vector<std::string> hashes;
  std::vector<std::string> flaws;  ///< of the decks by their own checks, a sentence for each deck

 private:
  /// What a deck says against its own result: the check that fails, and what makes its answer unsafe.
  void tell_of(const ComparedValue& one, const Result& made) {
    const std::optional<Verdict> verdict = verdict_of(made);
    std::vector<std::string> against = made.unsafe;
    if (verdict && verdict->kind == VerdictKind::fails) against.insert(against.begin(), verdict->reason);
    if (against.empty()) return;
    const std::string with = one.set.empty() ? std::string{} : fmt::format(" with {}", fmt::join(one.set, ", "));
    flaws.push_back(fmt::format("{}{}, by its own checks: {}", one.deck, with, fmt::join(against, "; ")));
  }

  const Job& set_;
  fs::path folder_;
  std::size_t count_;
  std::map<std::string, Result> all_;
};

enum class Means { value, difference };

/// A quantity of the set, NaN with a mistake at its place.
double set_quantity(const std::optional<std::string>& text, const Unit& unit, const io::Node& at, const char* key,
                    Result& r, Means means = Means::value) {
  if (!text) return no_value;
  const auto x = means == Means::value ? parse_quantity(*text, unit) : parse_difference(*text, unit);
  if (x) return *x;
  const io::Node* node = at.find(key);
  io::add(r.errors, node != nullptr ? node->spot : at.spot, fmt::format("{}: {}", key, x.error().message));
  return no_value;
}

/// "2 %" of a value, or a difference of its kind. A temperature has no share: it would depend on the zero of its scale.
double width_of(const std::optional<std::string>& text, double value, const Unit& unit, const io::Node& at,
                const char* key, Result& r) {
  const bool is_share = text && !text->empty() && text->back() == '%';
  if (is_share && is_temperature(unit)) {
    io::place(at,
              {{.path = key,
                .message = "a share of a temperature would depend on the zero of its scale: give a difference in K, as "
                           "in '1 K'"}},
              r.errors);
    return no_value;
  }
  if (is_share) {
    const auto share = parse_quantity(*text, si::one);
    if (share) return *share * std::abs(value);
  }
  return set_quantity(text, unit, at, key, r, Means::difference);
}

/// The same, which has no sign: below 0 it would let nothing agree.
double tolerance_of(const std::optional<std::string>& text, double value, const Unit& unit, const io::Node& at,
                    const char* key, Result& r) {
  const double width = width_of(text, value, unit, at, key, r);
  if (!(width < 0)) return width;
  const io::Node* node = at.find(key);
  io::add(r.errors, node != nullptr ? node->spot : at.spot,
          fmt::format("{}: {} is below 0: nothing would agree; give how far a value may be off, without a sign", key,
                      *text));
  return no_value;
}

struct ComparedRow {
  std::string what, deck, note, message, deck_verdict;
  Unit unit;
  double value = no_value, published = no_value, tolerance = no_value, reference = no_value,
         reference_tolerance = no_value;

  /// What rounding alone puts between two numbers is no miss, whatever is demanded.
  static bool within(double x, double of, double by) {
    constexpr double rounding = 1e-12;  // of the numbers
    const double own = rounding * std::max(std::abs(x), std::abs(of));
    return std::abs(x - of) <= by + std::max(rounding_on(by), own);
  }
  /// How far one is off; what is within rounding of the tolerance is on it.
  static double off(double x, double of, double by) {
    const double far = std::abs(x - of);
    return within(x, of, by) ? std::min(far, by) : far;
  }
  bool demanded() const { return !std::isnan(tolerance) || !std::isnan(reference_tolerance); }
  bool near_published() const { return std::isnan(tolerance) || within(value, published, tolerance); }
  bool near_reference() const {
    return std::isnan(reference_tolerance) || within(value, reference, reference_tolerance);
  }
};

std::string verdict_of_row(const ComparedRow& row) {
  if (std::isnan(row.value)) return row.message;
  if (!row.demanded()) return "shown only";
  if (row.near_published() && row.near_reference()) return "agrees";
  if (!row.near_published() && !row.near_reference()) return "off both";
  return row.near_reference() ? "off the published value" : "off the reference";
}

std::string shown_value(const Display& display, double x, const Unit& unit) {
  return std::isnan(x) ? "" : display.quantity(x, unit);
}

/// Two digits, and no exponent from a hundred on.
std::string percent_text(double share, bool with_sign) {
  const double x = 100 * share;
  if (std::abs(x) >= 99.5) return with_sign ? fmt::format("{:+.0f} %", x) : fmt::format("{:.0f} %", x);
  return with_sign ? fmt::format("{:+.2g} %", x) : fmt::format("{:.2g} %", x);
}

std::string deviation_text(const Display& display, double x, double of, double by, const Unit& unit) {
  if (std::isnan(x) || std::isnan(of)) return "";
  if (is_temperature(unit)) {
    const Unit kelvins = difference_of(unit);
    const std::string off = display.quantity(x - of, kelvins);
    return std::isnan(by) ? off : fmt::format("{} (may {})", off, display.quantity(by, kelvins));
  }
  if (of == 0) return display.quantity(x - of, unit);
  const std::string share = percent_text((x - of) / std::abs(of), true);
  return std::isnan(by) ? share : fmt::format("{} (may {})", share, percent_text(by / std::abs(of), false));
}

/// A row as it is shown.
struct ShownRow {
  const ComparedRow& row;
  const Display& display;
  std::string value(double x) const { return shown_value(display, x, row.unit); }
  std::string deviation(double of, double by) const { return deviation_text(display, row.value, of, by, row.unit); }
};

const Quantities<ShownRow>& compared_quantities() {
  using Row = ShownRow;
  static const Quantities<Row> all = {
      {"what", "", si::one, "what is compared", [](const Row& r) { return r.row.what; }},
      {"published", "", si::one, "the published value, with its unit",
       [](const Row& r) { return r.value(r.row.published); }},
      {"reference", "", si::one, "the value of another calculation with the same data",
       [](const Row& r) { return r.value(r.row.reference); }},
      {"taut", "", si::one, "the result of the deck", [](const Row& r) { return r.value(r.row.value); }},
      {"to_published", "", si::one, "deviation of the result from the published value, and what it may be",
       [](const Row& r) { return r.deviation(r.row.published, r.row.tolerance); }},
      {"to_reference", "", si::one, "deviation of the result from the reference, and what it may be",
       [](const Row& r) { return r.deviation(r.row.reference, r.row.reference_tolerance); }},
      {"verdict", "", si::one, "agrees, shown only, or what it is off; why there is no result",
       [](const Row& r) { return verdict_of_row(r.row); }},
      {"deck_verdict", "", si::one, "the verdict of the deck by its own checks; the set does not count it",
       [](const Row& r) { return r.row.deck_verdict; }},
      {"note", "", si::one, "the remark of the set", [](const Row& r) { return r.row.note; }}};
  return all;
}

void add_compared_table(const std::vector<ComparedRow>& rows, const Display& display, Result& r) {
  std::vector<ShownRow> shown;
  shown.reserve(rows.size());
  for (const ComparedRow& row : rows) shown.push_back({.row = row, .display = display});
  r.tables.push_back(make_table("compared", "Published, reference, and what taut gives", compared_quantities(), shown));
}

/// "row 1, 0 deg: S1" belongs to "row 1, 0 deg".
std::string case_of_row(const std::string& what) {
  const auto colon = what.rfind(": ");
  return colon == std::string::npos ? std::string{} : what.substr(0, colon);
}

void add_compared_checks(const std::vector<ComparedRow>& rows, Result& r) {
  for (const ComparedRow& row : rows) {
    const auto add = [&](const char* to, double of, double by, const char* rule) {
      if (std::isnan(by)) return;
      r.checks.push_back(make_check(fmt::format("{} {}", row.what, to), ComparedRow::off(row.value, of, by),
                                    difference_of(row.unit),
                                    {.sense = Sense::at_most, .limit = by, .rule = rule, .trust = "user"}));
      r.checks.back().part = case_of_row(row.what);
    };
    add("to the published value", row.published, row.tolerance, "published");
    add("to the reference", row.reference, row.reference_tolerance, "reference");
  }
}

void add_deviation_plot(const std::vector<ComparedRow>& rows, Result& r) {
  Plot p;
  p.name = "deviations";
  p.title = "Deviations";
  p.caption = "By the row of the table; results over the published value and over the reference.";
  p.x = {.label = "row of the table", .unit = si::one};
  p.y = {.label = "result over it", .unit = si::one};
  Curve published{.label = "published", .x = {}, .y = {}, .dashed = false, .points_only = true},
      reference{.label = "reference", .x = {}, .y = {}, .dashed = false, .points_only = true};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto add = [&](Curve& c, double of) {
      if (std::isnan(rows[i].value) || std::isnan(of) || of == 0 || is_temperature(rows[i].unit)) return;
      c.x.push_back(static_cast<double>(i + 1));
      c.y.push_back(rows[i].value / of);
    };
    add(published, rows[i].published);
    add(reference, rows[i].reference);
  }
  for (Curve* c : {&published, &reference}) {
    if (!c->x.empty()) p.curves.push_back(std::move(*c));
  }
  p.marks.push_back({0, 1, "the same", true, false});
  if (!p.curves.empty()) r.figures.emplace_back(std::move(p));
}

/// How far a value is off in the share that it may be off; 0: nothing is demanded of it.
double off_by(double x, double of, double by) {
  if (std::isnan(by)) return 0;
  if (std::isnan(x)) return HUGE_VAL;
  if (by == 0) return ComparedRow::within(x, of, by) ? 0 : HUGE_VAL;
  return std::abs(x - of) / by;
}

/// The same of a row: of its published value and of its reference.
struct OffBy {
  double published = 0, reference = 0;
  double most() const { return std::max(published, reference); }
  bool by_reference() const { return reference > published; }
};

OffBy off_by(const ComparedRow& row) {
  return {.published = off_by(row.value, row.published, row.tolerance),
          .reference = off_by(row.value, row.reference, row.reference_tolerance)};
}

/// How many rows agree, and those that are off most.
void add_compared_answers(const std::vector<ComparedRow>& rows, const Display& display, Result& r) {
  std::vector<const ComparedRow*> demanded;
  for (const ComparedRow& row : rows) {
    if (row.demanded()) demanded.push_back(&row);
  }
  const auto kept = std::count_if(demanded.begin(), demanded.end(), [](const ComparedRow* row) {
    return !std::isnan(row->value) && row->near_published() && row->near_reference();
  });
  add_answer_line(r, "Rows",
                  {fmt::format("{} of {} rows agree within what they may be off", kept, demanded.size()),
                   fmt::format("{} rows in all", rows.size())});
  std::stable_sort(demanded.begin(), demanded.end(),
                   [](const ComparedRow* a, const ComparedRow* b) { return off_by(*a).most() > off_by(*b).most(); });
  constexpr std::size_t most_rows = 4;
  for (std::size_t i = 0; i < std::min(most_rows, demanded.size()); ++i) {
    const ComparedRow& row = *demanded[i];
    if (std::isnan(row.value)) {
      add_answer_line(r, "Worst", {fmt::format("{}: {}", row.what, verdict_of_row(row))});
      continue;
    }
    const bool by_reference = std::isnan(row.tolerance) || off_by(row).by_reference();
    const std::string value = shown_value(display, row.value, row.unit);
    const std::string deviation =
        by_reference ? deviation_text(display, row.value, row.reference, row.reference_tolerance, row.unit)
                     : deviation_text(display, row.value, row.published, row.tolerance, row.unit);
    add_answer_line(r, "Worst",
                    {fmt::format("{}: {}{}{} from the {}", row.what, value, deviation.empty() ? "" : ", ", deviation,
                                 by_reference ? "reference" : "published value")});
  }
}

/// What is off beside why: the note of its row.
void tell_misses(const std::vector<ComparedRow>& rows, const Display& display, Result& r) {
  for (const ComparedRow& row : rows) {
    if (std::isnan(row.value) || (row.near_published() && row.near_reference())) continue;
    const bool off_reference = off_by(row).by_reference();
    const double wanted = off_reference ? row.reference : row.published;
    std::pair is{display.quantity(row.value, row.unit), display.quantity(wanted, row.unit)};
    if (is.first == is.second) is = brief_apart(row.value, wanted, row.unit, display);
    r.warnings.push_back(fmt::format("{}: {} instead of {} ({}); {}", row.what, is.first, is.second,
                                     off_reference ? "reference" : "published",
                                     row.note.empty() ? "no reason is stated" : row.note));
  }
}

ComparedRow compared_row(const ComparedValue& one, const io::Node& at, const Result& of, Result& r) {
  ComparedRow row;
  row.what = one.what;
  row.deck = one.deck;
  row.note = one.note.value_or("");
  if (const auto verdict = verdict_of(of)) row.deck_verdict = headline(verdict->kind);
  const Value* value = of.find_value(one.value);
  if (value == nullptr) {
    row.message = of.status == Status::ok ? fmt::format("no value '{}'", one.value) : of.message;
    // whatever was demanded of it fails
    if (one.tolerance) row.tolerance = 0;
    if (one.reference_tolerance) row.reference_tolerance = 0;
    return row;
  }
  row.unit = value->unit;
  row.value = value->value;
  const auto alone = [&](bool asked, bool given, const char* key, const char* name) {
    if (asked && !given) {
      io::place(at, {{.path = key, .message = fmt::format("is of '{}', which the row does not give", name)}}, r.errors);
    }
  };
  alone(one.tolerance.has_value(), one.published.has_value(), "tolerance", "published");
  alone(one.reference_tolerance.has_value(), one.reference.has_value(), "reference_tolerance", "reference");
  row.published = set_quantity(one.published, row.unit, at, "published", r);
  row.reference = set_quantity(one.reference, row.unit, at, "reference", r);
  row.tolerance = tolerance_of(one.tolerance, row.published, row.unit, at, "tolerance", r);
  row.reference_tolerance =
      tolerance_of(one.reference_tolerance, row.reference, row.unit, at, "reference_tolerance", r);
  if (of.status != Status::ok) row.message = of.message;
  return row;
}

}  // namespace

TableWords compared_words() {
  return {.name = "compared",
          .rows = "every value of the set that is compared",
          .columns = words_of(compared_quantities())};
}

Result compare(const Job& job) {
  Result r;
  r.method = "compare";
  r.method_title = "Comparison of a set of decks with published values";
  r.deck_name = job.name;
  io::Document document;
  const ComparedSet set = read_compared(job, document, r);
  std::vector<ComparedRow> rows;
  DeckRuns runs(job, set.values.size());
  if (r.errors.empty()) {
    for (std::size_t i = 0; i < set.values.size() && !r.interrupted; ++i) {
      const io::Node& at = *io::follow(document.root, fmt::format("compare.values[{}]", i)).node;
      const Result& of = runs.of(set.values[i], at.spot, r);
      rows.push_back(compared_row(set.values[i], at, of, r));
    }
  }
  if (r.title.empty()) r.title = r.method_title;
  if (!r.errors.empty()) {
    r.status = Status::bad_deck;
    r.message = r.errors.size() == 1 ? "there is a mistake" : fmt::format("there are {} mistakes", r.errors.size());
    return r;
  }
  if (r.interrupted) {
    r.status = Status::not_converged;
    r.message = fmt::format("interrupted after {} of {} values", rows.size(), set.values.size());
  }
  r.source = set.source;
  std::vector<std::string> files = document.source->reading->texts;
  files.insert(files.end(), runs.hashes.begin(), runs.hashes.end());
  r.deck_hash = fingerprint(job.text, files, job.set);
  r.overrides = job.set;
  const Display display(r.display);
  add_compared_table(rows, display, r);
  add_compared_checks(rows, r);
  add_deviation_plot(rows, r);
  if (!r.figures.empty()) r.key_figure = "deviations";
  add_compared_answers(rows, display, r);
  tell_misses(rows, display, r);
  for (const ComparedRow& row : rows) {
    if (row.message.empty()) continue;
    // without a value a row of which something is demanded fails
    if (!std::isnan(row.value) || !row.demanded()) r.unmade.push_back(fmt::format("{}: {}", row.what, row.message));
    std::string reported = fmt::format("{}: {}", row.deck, row.message);  // once for all values of a deck
    if (std::find(r.warnings.begin(), r.warnings.end(), reported) == r.warnings.end())
      r.warnings.push_back(std::move(reported));
  }
  std::move(runs.flaws.begin(), runs.flaws.end(), std::back_inserter(r.warnings));
  for (const std::string& erratum : set.errata)
    r.assumptions.push_back(fmt::format("Erratum of the source: {}", erratum));
  finish_answers(r);
  return r;
}

tl::expected<Job, FileError> read_set(const std::string& path) {
  std::error_code failed;
  const bool folder = fs::is_directory(path, failed);
  return read_job(folder ? (fs::path(path) / "compare.part.yaml").string() : path);
}

}  // namespace taut::app
