#include "taut/calc/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/expects.hpp"
#include "taut/units/display.hpp"

namespace taut {
namespace {

bool holds(const Slot& slot, const double* x) {
  if (const auto* p = std::get_if<double*>(&slot)) return *p == x;
  if (const auto* p = std::get_if<std::optional<double>*>(&slot)) return (*p)->has_value() && &***p == x;
  if (const auto* p = std::get_if<std::vector<double>*>(&slot)) {
    return !(*p)->empty() && x >= (*p)->data() && x < (*p)->data() + (*p)->size();
  }
  if (const auto* p = std::get_if<Triple*>(&slot)) return x >= (*p)->data() && x < (*p)->data() + (*p)->size();
  return false;
}

const Field* find_by_address(const Description& d, const void* object, const double* x) {
  for (const Field& f : d.fields) {
    const Slot slot = f.slot(const_cast<void*>(object));  // only addresses are looked at
    if (holds(slot, x)) return &f;
    std::vector<const void*> nested;
    if (const auto* record = std::get_if<Record>(&slot)) nested = record->all();
    if (const auto* named = std::get_if<NamedRecords>(&slot)) {
      for (const auto& [name, one] : named->all()) nested.push_back(one);
    }
    for (const void* one : nested) {
      if (const Field* inner = find_by_address(*f.record, one, x)) return inner;
    }
  }
  return nullptr;
}

}  // namespace

namespace {

const Display& own_units() {
  static const Display display;
  return display;
}

}  // namespace

const Display& Sheet<double>::display() const { return own_units(); }

const Display& Sheet<Num>::display() const { return display_ ? *display_ : own_units(); }

void Sheet<Num>::show_in(const Display& display) { display_ = std::make_shared<const Display>(display); }

Sheet<Num>::Sheet(std::string source, const Description& description, const void* input)
    : source_(std::move(source)), description_(&description), input_(input), zero_(make_number(0)) {}

Num Sheet<Num>::given(const double& x) {
  const Field* f = find_by_address(*description_, input_, &x);
  expects(f != nullptr, "given() takes a described member of the input");
  const std::string symbol = f->symbol.empty() ? f->key : f->symbol;
  const bool known = std::any_of(steps_.begin(), steps_.end(), [&](const Step& s) {
    return s.kind == Step::Kind::given && s.symbol == symbol && s.value == x;
  });
  if (!known) steps_.push_back({Step::Kind::given, {}, symbol, {}, x, f->unit, "input", f->words});
  return Num::named(symbol, f->unit, x);
}

Num Sheet<Num>::named(std::string_view symbol, const Unit& unit, double x) {
  return Num::named(std::string(symbol), unit, x);
}

std::string Sheet<Num>::source_of(std::string_view no, std::string_view source) const {
  if (!source.empty()) return std::string(source);
  if (no.empty()) return source_;
  if (no.back() == '*') return fmt::format("correction of {}, ({})", source_, no.substr(0, no.size() - 1));
  return fmt::format("{}, ({})", source_, no);
}

Num Sheet<Num>::eq(std::string_view no, std::string_view symbol, const Unit& unit, const Num& x,
                   std::string_view source) {
  if (x.dimension() != unit.dimension) {
    expects(false, fmt::format("equation ({}) {} = {} has the dimension {}, not {}", no, symbol,
                               formula_text(x.formula()), to_text(x.dimension()), to_text(unit.dimension)));
  }
  steps_.push_back({Step::Kind::equation,
                    std::string(no),
                    std::string(symbol),
                    x.formula(),
                    x.value(),
                    unit,
                    source_of(no, source),
                    {}});
  return Num::named(std::string(symbol), unit, x.value());
}

Num Sheet<Num>::record_root(std::string_view no, std::string_view symbol, const Unit& unit, const Num& residual,
                            double x) {
  steps_.push_back(
      {Step::Kind::root, std::string(no), std::string(symbol), residual.formula(), x, unit, source_of(no, {}), {}});
  return Num::named(std::string(symbol), unit, x);
}

void Sheet<Num>::section(std::string_view words) { add_words(Step::Kind::heading, std::string(words)); }

void Sheet<Num>::add_words(Step::Kind kind, std::string words) {
  steps_.push_back({kind, {}, {}, {}, 0, si::one, {}, std::move(words)});
}

void Sheet<Num>::add_warning(std::string words) {
  if (std::find(warnings_.begin(), warnings_.end(), words) == warnings_.end()) warnings_.push_back(std::move(words));
}

void Sheet<Num>::check(const char* name, const Num& x, const Unit& unit, const SheetBound<Num>& bound) {
  const bool alike = x.dimension() == unit.dimension && bound.limit.dimension() == unit.dimension;
  expects(alike, "a check compares unlike quantities");
  checks_.push_back(
      make_check(name, x.value(), unit,
                 {.sense = bound.sense, .limit = bound.limit.value(), .rule = bound.rule, .trust = bound.trust}));
}

void Sheet<Num>::move_to(Result& r) {
  r.steps.insert(r.steps.end(), std::make_move_iterator(steps_.begin()), std::make_move_iterator(steps_.end()));
  r.checks.insert(r.checks.end(), std::make_move_iterator(checks_.begin()), std::make_move_iterator(checks_.end()));
  for (std::string& w : warnings_) {
    if (std::find(r.warnings.begin(), r.warnings.end(), w) == r.warnings.end()) r.warnings.push_back(std::move(w));
  }
  steps_.clear();
  checks_.clear();
  warnings_.clear();
}

}  // namespace taut
