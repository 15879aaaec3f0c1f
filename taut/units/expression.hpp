#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "taut/base/array.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/dimension.hpp"

namespace taut {

/// What kelvins are: a temperature, read from a thermometer in degC; the difference of two such readings; or, written
/// in K, either.
enum class Kelvins { either, reading, difference };

/// A number with its dimension, SI. An angle is a plain number that may stand where an angle is asked for.
struct Measure {
  double value = 0;
  Dimension dimension;
  bool is_angle = false;
  Kelvins kelvins = Kelvins::either;  ///< of a temperature
  /// Of a frequency: whether it is a speed of turning, in rad/s, that was written in Hz, deg/s or rad/s. Where cycles
  /// per time are asked for, it is divided by 2 pi; what is in 1/s alone counts as it is, here and there.
  bool turns = false;
};

/// A quantity that was read, as a measure.
Measure measure_of(const AnyQuantity& quantity);

/// What a name stands for, or why it stands for nothing.
using NameMeaning = std::function<tl::expected<Measure, std::string>(std::string_view name)>;

/// The value of an arithmetic text: quantities with their units ("9 m", "3.5 kN/m"), names, + - * / ^ and parentheses,
/// `pi`, and the functions sqrt abs min max sin cos tan asin acos atan atan2. Sums take equal dimensions (an angle and
/// a plain number differ), a power a whole exponent, sin, cos and tan an angle. What follows a number and is the name
/// of a unit is its unit: names that are units mean nothing here. A temperature in degC counts from its own zero: only
/// a difference is added to it, two of them give their difference, and it has no multiples. Errors point into the text;
/// parentheses at most 64 deep.
tl::expected<Measure, UnitError> evaluate(std::string_view text, const NameMeaning& meaning);

/// One step of a formula: of the results `a` and `b` of steps before it, or a `constant` (of a power: the exponent).
struct Operation {
  enum class Kind {
    constant,
    variable,
    plus,
    minus,
    times,
    over,
    power,
    root,
    size,
    least,
    most,
    sin,
    cos,
    tan,
    asin,
    acos,
    atan,
    atan2
  };
  Kind kind = Kind::constant;
  int a = 0, b = 0;
  double constant = 0;
};

/// A text as a function of one variable.
struct FormulaText {
  std::string text;
  Measure is;                   ///< the kind of its values; its value where it does not depend on the variable
  Array<Operation> operations;  ///< the last one is its value
};

/// The formula of a text as `evaluate` reads it, in which the name `variable` has the given dimension and no other name
/// means anything. Where it is the name of a unit too, it never stands for that.
tl::expected<FormulaText, UnitError> formula_text(std::string_view text, std::string_view variable,
                                                  Dimension dimension);

/// Whether `name` can stand for a value: letters, digits and _, no digit first; neither a unit nor a function.
bool is_free_name(std::string_view name);

/// The value as a deck writes it, with its SI unit and every digit: "0.95 m", "1200 kg m^2", "0.3"; an angle in rad.
/// A reading of a thermometer is in degC, a speed of turning in rad/s. Empty when it has a fraction of a dimension,
/// such as the square root of a length.
std::string to_text(const Measure& measure);

}  // namespace taut
