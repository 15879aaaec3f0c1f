#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "taut/calc/num.hpp"
#include "taut/calc/result.hpp"
#include "taut/math/roots.hpp"

namespace taut {

class Display;

/// What a quantity of a sheet is held against; see Bound.
template <class T>
struct SheetBound {
  Sense sense = Sense::at_most;
  T limit;
  const char* rule = "";
  const char* trust = "";
};

/// A calculation note. A method is written once over a number type `T` and a `Sheet<T>`. With `double` the sheet does
/// nothing and costs nothing. With `Num` it records each line (formula, numbers, value, unit, equation number) and
/// checks dimensions.
template <class T>
class Sheet;

template <>
class Sheet<double> {
 public:
  double given(const double& x) const { return x; }
  double named(std::string_view, const Unit&, double x) const { return x; }
  double eq(std::string_view, std::string_view, const Unit&, double x, std::string_view = {}) const { return x; }

  /// The root of `f` in [low, high]; empty when there is none. See find_root.
  template <class F>
  std::optional<double> root(std::string_view, std::string_view, const Unit&, F&& f, double low, double high) const {
    return find_root(std::forward<F>(f), low, high);
  }
  void section(std::string_view) const {}
  template <class Words>
  void note(Words&&) const {}
  template <class Words>
  void warn(Words&&) const {}
  void check(const char*, double, const Unit&, const SheetBound<double>&) const {}
  const Display& display() const;
};

template <>
class Sheet<Num> {
 public:
  /// `source`: the method's source in short ("Shoshin et al. 2022"), put before each equation number.
  /// `description` and `input` let `given` find symbol, unit and words of a field by its address.
  Sheet(std::string source, const Description& description, const void* input);

  /// A field of the input as a named quantity, recorded once as a "given" line. `x` must be a member of the input or an
  /// element of one of its lists. Throws ContractViolation otherwise.
  Num given(const double& x);

  /// A quantity that is neither an input nor computed by an equation: a constant, a value of a sweep, a catalogue
  /// value.
  Num named(std::string_view symbol, const Unit& unit, double x);

  /// Records one equation, checks its dimension against `unit` (throws ContractViolation) and returns a new quantity
  /// named `symbol`.
  /// `no`: number in the source; a trailing * marks a correction by taut; "": a line without a number. `source`
  /// replaces the text "source, (no)" where the line is from elsewhere.
  Num eq(std::string_view no, std::string_view symbol, const Unit& unit, const Num& x, std::string_view source = {});

  /// The root of f(x) = 0 for x in [low, high], bit-identical to that of Sheet<double>; empty when there is none.
  /// Records "f = 0" and the value.
  template <class F>
  std::optional<Num> root(std::string_view no, std::string_view symbol, const Unit& unit, F&& f, double low,
                          double high) {
    const auto plain = [&](double x) { return value(f(Num(x, unit.dimension, Formula{zero_}))); };
    const std::optional<double> x = find_root(plain, low, high);
    if (!x) return std::nullopt;
    return record_root(no, symbol, unit, f(Num::named(std::string(symbol), unit, *x)), *x);
  }

  /// A heading over the lines that follow.
  void section(std::string_view words);
  /// A sentence between the lines: a text, or a callable that returns it, so that Sheet<double> does not build the
  /// text.
  template <class Words>
  void note(Words&& words) {
    add_words(Step::Kind::note, text(std::forward<Words>(words)));
  }
  /// A warning of the result. Repeated warnings are kept once.
  template <class Words>
  void warn(Words&& words) {
    add_warning(text(std::forward<Words>(words)));
  }
  void check(const char* name, const Num& x, const Unit& unit, const SheetBound<Num>& bound);

  /// The units of sentences; each number's own where nothing is set.
  const Display& display() const;
  void show_in(const Display& display);

  const std::vector<Step>& steps() const { return steps_; }
  const std::vector<Check>& checks() const { return checks_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Appends steps, checks and warnings to a result.
  void move_to(Result& r);

 private:
  template <class Words>
  static std::string text(Words&& words) {
    if constexpr (std::is_invocable_v<Words>) {
      return words();
    } else {
      return std::string(std::forward<Words>(words));
    }
  }
  void add_words(Step::Kind kind, std::string words);
  void add_warning(std::string words);
  Num record_root(std::string_view no, std::string_view symbol, const Unit& unit, const Num& residual, double x);
  std::string source_of(std::string_view no, std::string_view source) const;

  std::string source_;
  const Description* description_;
  const void* input_;
  std::shared_ptr<const Display> display_;  ///< nullptr: none is set
  Formula zero_;
  std::vector<Step> steps_;
  std::vector<Check> checks_;
  std::vector<std::string> warnings_;
};

}  // namespace taut
