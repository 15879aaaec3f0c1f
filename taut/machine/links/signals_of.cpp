#include "taut/machine/links/signals_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/base/suggest.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/dimension.hpp"
#include "taut/units/expression.hpp"
#include "taut/units/jet.hpp"

namespace taut::machine {
namespace {

/// What a signal has in Hz is a speed of turning.
Unit kind_of(const Unit& unit) { return is_turning(unit) ? si::per_s : unit; }

/// Reads the values of one signal: the first one says what kind of quantity it is.
class Values {
 public:
  Values(std::string path, std::vector<Complaint>& complaints) : path_(std::move(path)), complaints_(complaints) {}

  double read(const std::string& text, const std::string& key) {
    const auto found = parse_any_quantity(text);
    if (!found) {
      complain(key, found.error().message);
      return 0;
    }
    if (!known_) {
      unit_ = kind_of(found->unit);
      known_ = true;
    } else if (!same_kind(unit_, found->unit)) {
      complain(key, fmt::format("'{}' is a {}, the values before it are {}s", text, found->unit.kind, unit_.kind));
    }
    return measure_of(*found).value;
  }
  double read(const std::optional<std::string>& text, const std::string& key) { return text ? read(*text, key) : 0; }

  void complain(const std::string& key, std::string message) {
    complaints_.push_back({path_ + key, std::move(message)});
  }
  const Unit& unit() const { return unit_; }
  void set_unit(const Unit& unit) { unit_ = unit; }

 private:
  std::string path_;
  std::vector<Complaint>& complaints_;
  Unit unit_ = si::one;
  bool known_ = false;
};

template <class Given>
Change change_of(const Given& given, const std::string& key, Values& values) {
  if (given.smooth && given.half_cosine) values.complain(key, "is either 'smooth' or a 'half_cosine', not both");
  return given.smooth ? Change::smooth : given.half_cosine ? Change::half_cosine : Change::linear;
}

Moves ramp_of(const description::Ramp& given, Values& values) {
  Moves law;
  law.moves.push_back(
      {given.start, values.read(given.to, ".ramp.to"), given.duration, change_of(given, ".ramp", values)});
  law.from = values.read(given.from, ".ramp.from");
  return law;
}

Moves sequence_of(const Array<description::Move>& given, Values& values) {
  Moves law;
  double free_from = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string key = fmt::format(".sequence[{}]", i);
    law.moves.push_back(
        {given[i].at, values.read(given[i].to, key + ".to"), given[i].over, change_of(given[i], key, values)});
    if (given[i].at < free_from) {
      values.complain(key, fmt::format("begins at {:.6g} s, before the change before it has ended", given[i].at));
    }
    free_from = given[i].at + given[i].over;
  }
  return law;
}

Curve table_of(const description::SignalTable& given, Values& values) {
  Curve law;
  for (std::size_t i = 0; i < given.value.size(); ++i) {
    law.value.push_back(values.read(given.value[i], fmt::format(".table.value[{}]", i)));
  }
  law.t = given.t;
  if (law.t.size() != law.value.size()) {
    values.complain(".table", fmt::format("{} values for {} times", law.value.size(), law.t.size()));
    return law;
  }
  for (std::size_t i = 1; i < law.t.size(); ++i) {
    if (law.t[i] > law.t[i - 1]) continue;
    values.complain(fmt::format(".table.t[{}]", i), "times have to grow");
    return law;
  }
  if (law.t.size() < 2) {
    values.complain(".table", "two times and values or more are expected; for one value write 'constant'");
    return law;
  }
  if (given.interpolation == description::Interpolation::linear) return law;
  return smooth_curve(std::move(law.t), std::move(law.value));
}

Sine sine_of(const description::Sine& given, Values& values) {
  Sine law;
  law.amplitude = values.read(given.amplitude, ".sine.amplitude");
  law.mean = values.read(given.mean, ".sine.mean");
  const double cycles = given.frequency ? *given.frequency : 1 / given.period.value_or(1);
  law.omega = 2 * M_PI * cycles;
  law.phase = given.phase;
  return law;
}

constexpr Unit no_kind{
    .dimension = {}, .symbol = "", .shown = "", .is_angle = false, .kind = ""};  ///< not to be told twice

/// 0 where the text is no formula.
std::variant<double, Moves, Curve, Sine, TimeFormula> formula_law(const std::string& text, Values& values) {
  const auto refuse = [&](std::string message) {
    values.complain(".formula", std::move(message));
    values.set_unit(no_kind);
    return 0.0;
  };
  auto formula = formula_text(text, "t", si::s.dimension);
  if (!formula) {
    const UnitError& e = formula.error();
    const auto from = static_cast<std::size_t>(std::max(e.offset, 0));
    return refuse(fmt::format("at '{}': {}", from < text.size() ? text.substr(from) : text, e.message));
  }
  taut::Measure one = formula->is;
  one.value = 1;
  const auto kind = parse_any_quantity(to_text(one));
  if (!kind) return refuse(fmt::format("its values are in {}, which nothing takes", to_text(one.dimension)));
  if (!std::isfinite(jet_at(*formula, 0).value)) return refuse("has no value at t = 0");
  values.set_unit(kind_of(kind->unit));
  return std::make_shared<const FormulaText>(*std::move(formula));
}

Signal signal_of(const description::Signal& given, std::vector<Complaint>& complaints) {
  Values values(fmt::format("signals.{}", given.name), complaints);
  Signal signal;
  signal.name = given.name;
  if (given.constant) signal.law = values.read(*given.constant, ".constant");
  if (given.ramp) signal.law = ramp_of(*given.ramp, values);
  if (given.table) signal.law = table_of(*given.table, values);
  if (given.sine) signal.law = sine_of(*given.sine, values);
  if (!given.sequence.empty()) signal.law = sequence_of(given.sequence, values);
  if (given.formula) signal.law = formula_law(*given.formula, values);
  signal.unit = values.unit();
  return signal;
}

}  // namespace

bool looks_like_quantity(const std::string& text) {
  const std::size_t first = text.find_first_not_of("+-.");
  return first != std::string::npos && std::isdigit(static_cast<unsigned char>(text[first])) != 0;
}

Array<Signal> signals_of(const Machine& machine, std::vector<Complaint>& complaints) {
  Array<Signal> all;
  all.reserve(machine.signals.size());
  for (const auto& given : machine.signals) all.push_back(signal_of(given, complaints));
  return all;
}

std::optional<Signal> signal_or_constant(const std::string& text, const Unit& unit, const Array<Signal>& signals,
                                         const std::string& path, std::vector<Complaint>& complaints) {
  const auto named = std::find_if(signals.begin(), signals.end(), [&](const Signal& s) { return s.name == text; });
  if (named != signals.end()) {
    if (same_kind(named->unit, unit) || named->unit.kind == no_kind.kind) return *named;
    complaints.push_back(
        {path, fmt::format("signal '{}' is a {}; here a {} is wanted", text, named->unit.kind, unit.kind)});
    return std::nullopt;
  }
  if (looks_like_quantity(text)) {
    const auto value = parse_quantity(text, unit);
    if (value) return Signal{.name = {}, .unit = unit, .law = *value};
    complaints.push_back({path, value.error().message});
    return std::nullopt;
  }
  std::vector<std::string> names;
  names.reserve(signals.size());
  for (const Signal& s : signals) names.push_back(s.name);
  complaints.push_back({path, fmt::format("there is no signal '{}'{}; write one of 'signals' or a {} with its unit",
                                          text, did_you_mean(text, names), unit.kind)});
  return std::nullopt;
}

}  // namespace taut::machine
