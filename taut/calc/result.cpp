#include "taut/calc/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "taut/base/on_limit.hpp"
#include "taut/calc/method.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/units/any_quantity.hpp"

namespace taut {
namespace {

/// Reads a field of a const struct: the slot functions take a mutable address but only readers run here.
Slot slot_of(const Field& f, const void* object) { return f.slot(const_cast<void*>(object)); }

Given given_head(const std::string& prefix, const Description& d, const Field& f) {
  Given g;
  g.key = prefix + f.key;
  g.symbol = f.symbol;
  g.words = f.words;
  g.unit = f.unit;
  const auto number = default_number(d, f);
  if (number) g.numbers = {*number};
  if (f.kind == FieldKind::triple && !f.required) {
    const auto object = d.make_default();
    const Slot slot = f.slot(object.get());
    if (const auto* triple = std::get_if<Triple*>(&slot)) g.numbers.assign((*triple)->begin(), (*triple)->end());
  }
  if (f.kind == FieldKind::numbers && !f.required) {
    const auto object = d.make_default();
    const Slot slot = f.slot(object.get());
    if (const auto* numbers = std::get_if<std::vector<double>*>(&slot)) g.numbers = **numbers;
  }
  g.text = default_text(d, f);
  return g;
}

/// Puts the value of a slot into a Given; says false when the field is not set.
struct Filler {
  Given& g;

  bool operator()(const double* x) const {
    g.numbers = {*x};
    return !std::isnan(*x);
  }
  bool operator()(const std::optional<double>* x) const {
    if (x->has_value()) g.numbers = {**x};
    return x->has_value();
  }
  bool operator()(const std::vector<double>* x) const {
    g.numbers = *x;
    return !x->empty();
  }
  bool operator()(const int* x) const {
    g.numbers = {static_cast<double>(*x)};
    return true;
  }
  bool operator()(const std::optional<int>* x) const {
    if (x->has_value()) g.numbers = {static_cast<double>(**x)};
    return x->has_value();
  }
  bool operator()(const bool* x) const {
    g.text = *x ? "true" : "false";
    return true;
  }
  bool operator()(const std::string* x) const {
    g.text = *x;
    return !x->empty();
  }
  bool operator()(const std::optional<std::string>* x) const {
    if (x->has_value()) g.text = **x;
    return x->has_value();
  }
  bool operator()(const Choice& x) const {
    g.text = x.get();
    return !g.text.empty();
  }
  bool operator()(const Triple* x) const {
    g.numbers.assign(x->begin(), x->end());
    return true;
  }
  bool operator()(const std::optional<Triple>* x) const { return x->has_value() && (*this)(&**x); }
  bool operator()(const std::vector<std::string>* x) const {
    g.text = fmt::format("{}", fmt::join(*x, ", "));
    return !x->empty();
  }
  bool operator()(const Record&) const { return false; }  // its own fields are listed instead
  bool operator()(const NamedRecords&) const { return false; }
};

/// The records in a field's slot, each with its key: "span", "cases[1]", "points.head". Nothing for other fields.
std::vector<std::pair<std::string, const void*>> records_in(const Field& f, const Slot& slot) {
  std::vector<std::pair<std::string, const void*>> keyed;
  if (const auto* record = std::get_if<Record>(&slot)) {
    const auto present = record->all();
    for (std::size_t i = 0; i < present.size(); ++i) {
      keyed.emplace_back(f.is_list ? fmt::format("{}[{}]", f.key, i) : f.key, present[i]);
    }
  } else if (const auto* named = std::get_if<NamedRecords>(&slot)) {
    for (const auto& [name, one] : named->all()) {
      keyed.emplace_back(f.rest ? name : name.empty() ? f.key : fmt::format("{}.{}", f.key, name), one);
    }
  }
  return keyed;
}

/// The struct of the map that replaces a triple; nullptr where the deck has the triple.
const void* map_of(const Field& f, const void* object) {
  if (!f.map_form) return nullptr;
  const auto present = f.map_form(const_cast<void*>(object)).all();
  return present.empty() ? nullptr : present.front();
}

void collect(std::vector<Given>& all, const std::string& prefix, const Description& d, const void* object) {
  for (const Field& f : d.fields) {
    const Slot slot = slot_of(f, object);
    for (const auto& [key, one] : records_in(f, slot)) {
      collect(all, fmt::format("{}{}.", prefix, key), *f.record, one);
    }
    if (std::holds_alternative<Record>(slot) || std::holds_alternative<NamedRecords>(slot)) continue;
    if (const void* map = map_of(f, object)) {
      collect(all, fmt::format("{}{}.", prefix, f.key), *f.record, map);
      continue;
    }
    Given g = given_head(prefix, d, f);
    const Given by_default = g;
    if (!std::visit(Filler{g}, slot)) continue;
    g.is_default = !f.required && g.numbers == by_default.numbers && g.text == by_default.text;
    all.push_back(std::move(g));
  }
}

}  // namespace

Check make_check(std::string name, double value, const Unit& unit, Bound bound) {
  Check c;
  c.name = std::move(name);
  c.value = value;
  c.limit = bound.limit;
  c.unit = unit;
  c.sense = bound.sense;
  // a share of kelvins says nothing: 20 degC of 100 degC are 0.2
  const double zero = is_temperature(unit) ? zero_celsius : 0;
  const double is = value - zero, may = c.limit - zero, over = c.sense == Sense::at_most ? may : is;
  c.utilisation = over > 0 && may > 0 ? (c.sense == Sense::at_most ? is / may : may / is)
                                      : std::numeric_limits<double>::quiet_NaN();
  const double rounding = rounding_on(c.limit);
  c.passes = c.sense == Sense::at_most ? value <= c.limit + rounding : value >= c.limit - rounding;
  if (c.passes && c.utilisation > 1) c.utilisation = 1;
  c.rule = std::move(bound.rule);
  c.trust = std::move(bound.trust);
  c.doubts = std::move(bound.doubts);
  return c;
}

std::vector<Check> grouped(std::vector<Check> checks) {
  const bool parts = std::any_of(checks.begin(), checks.end(), [](const Check& c) { return !c.part.empty(); });
  if (!parts) return checks;
  std::map<std::string, double> worst;
  for (const Check& c : checks) {
    const auto known = worst.try_emplace(c.part, severity(c)).first;
    known->second = std::max(known->second, severity(c));
  }
  std::stable_sort(checks.begin(), checks.end(), [&](const Check& a, const Check& b) {
    if (a.part == b.part) return severity(a) > severity(b);
    const double of_a = worst[a.part];
    const double of_b = worst[b.part];
    return of_a != of_b ? of_a > of_b : a.part < b.part;
  });
  return checks;
}

const Value* Result::find_value(const std::string& name) const {
  const auto at = std::find_if(values.begin(), values.end(), [&](const Value& v) { return v.name == name; });
  return at == values.end() ? nullptr : &*at;
}

const Table* Result::find_table(const std::string& name) const {
  const auto at = std::find_if(tables.begin(), tables.end(), [&](const Table& t) { return t.name == name; });
  return at == tables.end() ? nullptr : &*at;
}

Table without_detail(const Table& t) {
  Table shown = t;
  shown.columns.clear();
  shown.rows.assign(t.rows.size(), {});
  for (std::size_t k = 0; k < t.columns.size(); ++k) {
    if (t.columns[k].detail) continue;
    shown.columns.push_back(t.columns[k]);
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
      if (k < t.rows[i].size()) shown.rows[i].push_back(t.rows[i][k]);
    }
  }
  return shown;
}

void warn_unsafe(Result& r, std::string sentence) {
  r.unsafe.push_back(sentence);
  r.warnings.push_back(std::move(sentence));
}

void leave_unmade(Result& r, std::string sentence, About about) {
  r.about.insert_or_assign(sentence, std::move(about));
  r.unmade.push_back(sentence);
  r.warnings.push_back(std::move(sentence));
}

AboutPart::AboutPart(Result& r, Part part)
    : r_(r),
      part_(std::move(part)),
      checks_(r.checks.size()),
      unmade_(r.unmade.size()),
      unjudged_(r.unjudged.size()),
      unsafe_(r.unsafe.size()) {}

AboutPart::~AboutPart() {
  const auto name = [this](const std::vector<std::string>& sentences, std::size_t from) {
    for (std::size_t i = from; i < sentences.size(); ++i) r_.about.try_emplace(sentences[i], About{.part = part_});
  };
  name(r_.unmade, unmade_);
  name(r_.unjudged, unjudged_);
  name(r_.unsafe, unsafe_);
  for (std::size_t i = checks_; i < r_.checks.size(); ++i) {
    Check& check = r_.checks[i];
    if (check.part.empty()) check.part = part_.name;
    if (check.kind == PartKind::unknown && check.part == part_.name) check.kind = part_.kind;
  }
}

void drop_loaded(Result& r) {
  // each thing once: as a check that is unmade, and as a warning
  const auto drop = [&](std::vector<std::string>& sentences) {
    std::set<std::string> told;
    std::erase_if(sentences, [&](const std::string& sentence) {
      const auto found = r.about.find(sentence);
      if (found == r.about.end() || found->second.no_load.empty()) return false;
      return r.loaded.contains(found->second.no_load) || !told.insert(found->second.no_load).second;
    });
  };
  drop(r.unmade);
  drop(r.warnings);
}

void take_out(const std::vector<Part>& parts, Result& r) {
  const auto has = [&](const Part& part) { return std::find(parts.begin(), parts.end(), part) != parts.end(); };
  const auto is_out = [&](const std::string& sentence) {
    const auto found = r.about.find(sentence);
    return found != r.about.end() && has(found->second.part);
  };
  std::erase_if(r.checks, [&](const Check& check) { return has(part_of(check)); });
  for (const std::string& one : r.unmade) {
    if (is_out(one)) std::erase(r.warnings, one);
  }
  std::erase_if(r.unmade, is_out);
  std::erase_if(r.unjudged, is_out);
  std::erase_if(r.unsafe, is_out);
}

std::vector<Value> values_of(const Description& d, const void* output) {
  std::vector<Value> all;
  for (const Field& f : d.fields) {
    const Slot slot = slot_of(f, output);
    const auto* number = std::get_if<double*>(&slot);
    if (number == nullptr || !std::isfinite(**number)) continue;
    all.push_back({f.key, **number, f.unit, f.symbol.empty() ? f.key : f.symbol, f.words, f.source, f.detail});
  }
  return all;
}

std::vector<Given> given_of(const Description& d, const void* input) {
  std::vector<Given> all;
  collect(all, "", d, input);
  return all;
}

Result result_of(const Method& method, const Description& input, const void* values) {
  Result r;
  r.method = method.name;
  r.method_title = method.title;
  r.source = method.source;
  r.given = given_of(input, values);
  return r;
}

const Description& Project::describe() {
  static const Description d = Describe<Project>()
                                   .field(&Project::project, "project", "name of the project")
                                   .field(&Project::number, "number", "number of the project or order")
                                   .field(&Project::author, "author", "who made the calculation")
                                   .field(&Project::checked_by, "checked_by", "who checks and signs it")
                                   .field(&Project::date, "date", "date of the calculation, printed as written")
                                   .field(&Project::revision, "revision", "revision of the calculation, \"A\"");
  return d;
}

}  // namespace taut
