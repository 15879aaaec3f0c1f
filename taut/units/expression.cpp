#include "taut/units/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "taut/base/expects.hpp"
#include "taut/base/suggest.hpp"

namespace taut {
namespace {

constexpr int deepest_parentheses = 64;
constexpr int largest_exponent = 8;
bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_name(char c) { return starts_name(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool is_unit(std::string_view name) {
  const auto& all = unit_names();
  return std::any_of(all.begin(), all.end(), [&](const UnitName& unit) { return unit.name == name; });
}

bool is_plain_measure(const Measure& m) { return is_plain_number(m.dimension) && !m.is_angle; }
bool same_measure(const Measure& a, const Measure& b) { return a.dimension == b.dimension && a.is_angle == b.is_angle; }

std::string measure_kind(const Measure& m) {
  if (m.is_angle) return "an angle";
  return is_plain_number(m.dimension) ? "a plain number" : fmt::format("in {}", to_text(m.dimension));
}

bool is_reading(const Measure& m) { return m.kelvins == Kelvins::reading; }

/// What a sum or a difference of kelvins is, or why it is nothing. 20 degC + 5 degC has no meaning: it would depend on
/// the zero of the scale. 20 K + 5 degC has two, as K may be a temperature or a difference.
tl::expected<Kelvins, std::string> kelvins_of_sum(Kelvins a, Kelvins b, bool plus) {
  using enum Kelvins;
  if (plus && a == reading && b == reading) {
    return tl::unexpected(
        std::string("two temperatures in degC have no sum: write the difference in K, as in '20 degC + 5 K'"));
  }
  if (plus && a == either && b == reading) {
    return tl::unexpected(std::string(
        "a temperature in degC stands first, and what is added to it is a difference in K, as in '20 degC + 5 K'"));
  }
  if (!plus && a != reading && b == reading) {
    return tl::unexpected(
        std::string("a temperature in degC can't be taken from kelvins: write both in degC, or both in K"));
  }
  if (!plus && a == reading && b == reading) return difference;
  if (a == reading || b == reading) return reading;
  return a == b ? a : either;
}

constexpr const char* no_multiple =
    "a temperature in degC counts from its own zero: this works with a temperature in K, or with the difference of "
    "two, "
    "as in '(30 degC - 10 degC) / 2'";

constexpr const char* turns_and_not =
    "one side is a speed of turning (Hz, rad/s), the other one is in 1/s: write both in the same unit; '* 1 rad' makes "
    "1/s a speed of turning";

/// What a function gives, or what is wrong with its values in words.
using Applied = tl::expected<Measure, std::string>;

Applied root(const Measure& a) {
  if (a.value < 0) return tl::unexpected(std::string("the value is below 0"));
  return Measure{.value = std::sqrt(a.value), .dimension = power(a.dimension, 1, 2), .is_angle = false};
}

Applied of_angle(double (*f)(double), const Measure& a) {
  if (!a.is_angle) return tl::unexpected(fmt::format("an angle is expected, the value is {}", measure_kind(a)));
  return Measure{.value = f(a.value), .dimension = {}, .is_angle = false};
}

Applied angle_of(double (*f)(double), const Measure& a, double most) {
  if (!is_plain_measure(a)) {
    return tl::unexpected(fmt::format("a plain number is expected, the value is {}", measure_kind(a)));
  }
  if (std::abs(a.value) > most) return tl::unexpected(std::string("the value is outside -1 to 1"));
  return Measure{.value = f(a.value), .dimension = {}, .is_angle = true};
}

/// A function of one value, which it gets twice, or of two of the same kind.
struct Function {
  const char* name;
  std::size_t values;
  Operation::Kind operation;
  Applied (*of)(const Measure& a, const Measure& b);
};
constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr std::array<Function, 11> functions{{
    {.name = "sqrt",
     .values = 1,
     .operation = Operation::Kind::root,
     .of = [](const Measure& a, const Measure&) { return root(a); }},
    {.name = "abs",
     .values = 1,
     .operation = Operation::Kind::size,
     .of = [](const Measure& a, const Measure&) -> Applied {
       Measure size = a;
       size.value = std::abs(a.value);
       return size;
     }},
    {.name = "min",
     .values = 2,
     .operation = Operation::Kind::least,
     .of = [](const Measure& a, const Measure& b) -> Applied { return a.value <= b.value ? a : b; }},
    {.name = "max",
     .values = 2,
     .operation = Operation::Kind::most,
     .of = [](const Measure& a, const Measure& b) -> Applied { return a.value >= b.value ? a : b; }},
    {.name = "sin",
     .values = 1,
     .operation = Operation::Kind::sin,
     .of = [](const Measure& a, const Measure&) { return of_angle(std::sin, a); }},
    {.name = "cos",
     .values = 1,
     .operation = Operation::Kind::cos,
     .of = [](const Measure& a, const Measure&) { return of_angle(std::cos, a); }},
    {.name = "tan",
     .values = 1,
     .operation = Operation::Kind::tan,
     .of = [](const Measure& a, const Measure&) { return of_angle(std::tan, a); }},
    {.name = "asin",
     .values = 1,
     .operation = Operation::Kind::asin,
     .of = [](const Measure& a, const Measure&) { return angle_of(std::asin, a, 1); }},
    {.name = "acos",
     .values = 1,
     .operation = Operation::Kind::acos,
     .of = [](const Measure& a, const Measure&) { return angle_of(std::acos, a, 1); }},
    {.name = "atan",
     .values = 1,
     .operation = Operation::Kind::atan,
     .of = [](const Measure& a, const Measure&) { return angle_of(std::atan, a, unbounded); }},
    {.name = "atan2",
     .values = 2,
     .operation = Operation::Kind::atan2,
     .of = [](const Measure& a, const Measure& b) -> Applied {
       return Measure{.value = std::atan2(a.value, b.value), .dimension = {}, .is_angle = true};
     }},
}};

/// The function of that name; null: there is none.
const Function* function_named(std::string_view name) {
  const auto at =
      std::find_if(functions.begin(), functions.end(), [&](const Function& one) { return one.name == name; });
  return at == functions.end() ? nullptr : at;
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  names.reserve(functions.size());
  for (const Function& one : functions) names.emplace_back(one.name);
  return names;
}

/// A part of a text: its value where it depends on no variable, else its place among the operations.
struct Part {
  Measure is;
  int operation = -1;
};

/// Recursive descent over the text; throws its UnitError, which `evaluate` gives back. What depends on `variable`
/// (empty: nothing does) becomes a list of operations, everything else its value.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, const NameMeaning& meaning, std::string_view variable = {},
                   const Measure& of_variable = {})
      : text_(text), meaning_(meaning), variable_(variable), of_variable_(of_variable) {}

  Part all() {
    const Part part = sum();
    skip();
    if (i_ < text_.size()) fail("an operator (+ - * / ^) is expected here", i_);
    return part;
  }

  /// The place of a part among the operations.
  int place_of(const Part& part) {
    return part.operation >= 0 ? part.operation : add({.kind = Operation::Kind::constant, .constant = part.is.value});
  }

  Array<Operation> operations;

 private:
  [[noreturn]] static void fail(std::string message, std::size_t from, std::size_t width = 1) {
    throw UnitError{.message = std::move(message),
                    .offset = static_cast<int>(from),
                    .width = static_cast<int>(std::max<std::size_t>(width, 1))};
  }

  void skip() {
    while (i_ < text_.size() && (text_[i_] == ' ' || text_[i_] == '\t')) ++i_;
  }
  bool take(char c) {
    skip();
    if (i_ >= text_.size() || text_[i_] != c) return false;
    ++i_;
    return true;
  }

  int add(const Operation& operation) {
    operations.push_back(operation);
    return static_cast<int>(operations.size()) - 1;
  }

  static bool varies(const Part& a, const Part& b) { return a.operation >= 0 || b.operation >= 0; }

  Part sum() {
    Part left = product();
    while (true) {
      skip();
      const std::size_t from = i_;
      const bool plus = take('+');
      if (!plus && !take('-')) return left;
      const Part right = product();
      const bool both_plain = is_plain_number(left.is.dimension) && is_plain_number(right.is.dimension);
      if (both_plain && varies(left, right)) {  // "2 rad/s * t + 20 deg"
        left.is.is_angle = left.is.is_angle || right.is.is_angle;
      } else if (!same_measure(left.is, right.is)) {
        fail(fmt::format("the left side is {}, the right one {}", measure_kind(left.is), measure_kind(right.is)), from);
      }
      if (left.is.turns != right.is.turns) fail(turns_and_not, from);
      const auto kelvins = kelvins_of_sum(left.is.kelvins, right.is.kelvins, plus);
      if (!kelvins) fail(kelvins.error(), from);
      left.is.kelvins = *kelvins;
      if (varies(left, right)) {
        const int a = place_of(left), b = place_of(right);
        left.operation = add({.kind = plus ? Operation::Kind::plus : Operation::Kind::minus, .a = a, .b = b});
      }
      left.is.value += plus ? right.is.value : -right.is.value;
    }
  }

  Part product() {
    Part left = factor();
    while (true) {
      skip();
      const std::size_t from = i_;
      const bool times = take('*');
      if (!times && !take('/')) return left;
      const Part right = factor();
      if (is_reading(left.is) || is_reading(right.is)) fail(no_multiple, from);
      const bool multiple = is_plain_measure(right.is) || (times && is_plain_measure(left.is));
      const Kelvins kelvins = times && is_plain_measure(left.is) ? right.is.kelvins : left.is.kelvins;
      const bool angle = times ? left.is.is_angle != right.is.is_angle : left.is.is_angle && !right.is.is_angle;
      const bool turns = multiple ? left.is.turns || right.is.turns : angle;  // "90 deg / 2 s" turns too
      if (varies(left, right)) {
        const int a = place_of(left), b = place_of(right);
        left.operation = add({.kind = times ? Operation::Kind::times : Operation::Kind::over, .a = a, .b = b});
      }
      left.is.value = times ? left.is.value * right.is.value : left.is.value / right.is.value;
      left.is.dimension = times ? left.is.dimension * right.is.dimension : left.is.dimension / right.is.dimension;
      left.is.is_angle = angle && is_plain_number(left.is.dimension);
      left.is.kelvins = multiple ? kelvins : Kelvins::either;
      left.is.turns = turns && left.is.dimension == si::per_s.dimension;
    }
  }

  Part factor() {
    if (take('-')) {
      skip();
      const std::size_t number = i_;
      Part part = deeper(&ExpressionParser::factor);
      if (is_reading(part.is)) return below_zero(number);
      if (part.operation >= 0) {
        const int zero = add({.kind = Operation::Kind::constant});
        part.operation = add({.kind = Operation::Kind::minus, .a = zero, .b = part.operation});
      }
      part.is.value = -part.is.value;
      return part;
    }
    if (take('+')) return deeper(&ExpressionParser::factor);
    Part base = primary();
    skip();
    const std::size_t from = i_;
    if (!take('^')) return base;
    if (is_reading(base.is)) fail(no_multiple, from);
    const Part exponent = deeper(&ExpressionParser::factor);
    const double whole = std::round(exponent.is.value);
    const bool fits = exponent.operation < 0 && is_plain_measure(exponent.is) && whole == exponent.is.value;
    if (!fits || std::abs(whole) > largest_exponent) {
      fail(fmt::format("the exponent has to be a whole number up to {}", largest_exponent), from);
    }
    if (base.operation >= 0) {
      base.operation = add({.kind = Operation::Kind::power, .a = base.operation, .constant = whole});
    }
    base.is = {.value = std::pow(base.is.value, whole),
               .dimension = power(base.is.dimension, static_cast<int>(whole)),
               .is_angle = base.is.is_angle && whole == 1,
               .turns = base.is.turns && whole == 1};
    return base;
  }

  /// The temperature "-20 degC", of which the text from `number` has been read: the sign belongs to its number.
  Part below_zero(std::size_t number) const {
    if (text_[number] != '.' && std::isdigit(static_cast<unsigned char>(text_[number])) == 0) fail(no_multiple, number);
    const auto read = parse_any_quantity(fmt::format("-{}", text_.substr(number, i_ - number)));
    expects(read.has_value(), "a number has a negative");
    return {measure_of(*read)};
  }

  /// Everything that nests goes through here, so that no text can exhaust the stack.
  Part deeper(Part (ExpressionParser::*part)()) {
    if (++depth_ > deepest_parentheses) fail(fmt::format("nested deeper than {}", deepest_parentheses), i_);
    const Part read = (this->*part)();
    --depth_;
    return read;
  }

  Part primary() {
    skip();
    if (i_ >= text_.size()) fail("a value is missing at the end", text_.empty() ? 0 : text_.size() - 1);
    if (take('(')) {
      const std::size_t opened = i_ - 1;
      const Part part = deeper(&ExpressionParser::sum);
      if (!take(')')) fail("this '(' is not closed", opened);
      return part;
    }
    const char c = text_[i_];
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return quantity();
    if (starts_name(c)) return name();
    fail("a number, a name or '(' is expected here", i_);
  }

  /// Where the digits of a number end.
  std::size_t number_end(std::size_t i) const {
    const auto digits = [&] {
      while (i < text_.size() && std::isdigit(static_cast<unsigned char>(text_[i])) != 0) ++i;
    };
    digits();
    if (i < text_.size() && text_[i] == '.') ++i, digits();
    if (i + 1 < text_.size() && (text_[i] == 'e' || text_[i] == 'E')) {
      const std::size_t sign = text_[i + 1] == '+' || text_[i + 1] == '-' ? i + 2 : i + 1;
      if (sign < text_.size() && std::isdigit(static_cast<unsigned char>(text_[sign])) != 0) i = sign, digits();
    }
    return i;
  }

  /// The end of a unit's name with its power that stands at or behind blanks at `i`; `i` where there is none.
  std::size_t unit_end(std::size_t i) const {
    std::size_t from = i;
    while (from < text_.size() && text_[from] == ' ') ++from;
    if (from < text_.size() && text_[from] == '%') return from + 1;
    if (text_.substr(from, 2) == "1/") {
      const std::size_t below = unit_end(from + 2);
      return below > from + 2 ? below : i;
    }
    std::size_t end = from;
    while (end < text_.size() && (in_name(text_[end]) || static_cast<unsigned char>(text_[end]) >= 0x80)) ++end;
    std::size_t letters = end;  // "mm2" is a unit and its power
    while (letters > from && std::isdigit(static_cast<unsigned char>(text_[letters - 1])) != 0) --letters;
    const std::string_view whole = text_.substr(from, end - from);
    if (!variable_.empty() && whole == variable_) return i;  // "90 deg/s * t": not tonnes
    std::size_t behind = end;
    while (behind < text_.size() && text_[behind] == ' ') ++behind;
    const bool called = behind < text_.size() && text_[behind] == '(';
    if (called && function_named(whole) != nullptr) return i;  // "2 m/s * min(1, 2)": not minutes
    const bool high =
        std::any_of(whole.begin(), whole.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    if (end == from || (!high && !is_unit(whole) && !is_unit(text_.substr(from, letters - from)))) return i;
    if (end < text_.size() && text_[end] == '^') {
      std::size_t digit = end + 1;
      if (digit < text_.size() && text_[digit] == '-') ++digit;
      if (digit < text_.size() && std::isdigit(static_cast<unsigned char>(text_[digit])) != 0) end = digit + 1;
    }
    return end;
  }

  Part quantity() {
    const std::size_t from = i_;
    i_ = number_end(i_);
    std::size_t end = unit_end(i_);
    if (end == i_) {  // a word behind a number could only be its unit
      std::size_t word = i_;
      while (word < text_.size() && text_[word] == ' ') ++word;
      if (word < text_.size() && starts_name(text_[word])) {
        const std::size_t begins = word;
        while (word < text_.size() && in_name(text_[word])) ++word;
        if (!variable_.empty() && text_.substr(begins, word - begins) == variable_) {
          fail(fmt::format("'*' is missing between the number and '{}'", variable_), begins);
        }
        end = word;
      }
    }
    while (end > i_) {
      i_ = end;
      std::size_t joint = i_;
      while (joint < text_.size() && text_[joint] == ' ') ++joint;
      if (joint < text_.size() && (text_[joint] == '/' || text_[joint] == '*')) ++joint;
      const std::size_t next = unit_end(joint);
      end = next > joint ? next : i_;
    }
    const auto read = parse_any_quantity(text_.substr(from, i_ - from));
    if (!read) {
      const UnitError& e = read.error();
      fail(e.message, from + static_cast<std::size_t>(e.offset), static_cast<std::size_t>(e.width));
    }
    return {measure_of(*read)};
  }

  Part name() {
    const std::size_t from = i_;
    while (i_ < text_.size() && in_name(text_[i_])) ++i_;
    const std::string_view word = text_.substr(from, i_ - from);
    skip();
    if (i_ < text_.size() && text_[i_] == '(') return call(word, from);
    if (word == "pi") return {{.value = std::numbers::pi, .dimension = {}, .is_angle = false}};
    if (!variable_.empty() && word == variable_) {
      return {.is = of_variable_, .operation = add({.kind = Operation::Kind::variable})};
    }
    const auto found = meaning_(word);
    if (!found) fail(found.error(), from, word.size());
    return {*found};
  }

  Part call(std::string_view word, std::size_t from) {
    const Function* function = function_named(word);
    if (function == nullptr) {
      fail(fmt::format("there is no function '{}'{}", word, did_you_mean(word, function_names())), from, word.size());
    }
    take('(');
    std::vector<Part> given;
    do {
      given.push_back(deeper(&ExpressionParser::sum));
    } while (take(','));
    if (!take(')')) fail("this function's '(' is not closed", from, word.size());
    const auto refuse = [&](std::string_view message) {
      fail(fmt::format("{}: {}", word, message), from, word.size());
    };
    if (given.size() != function->values) {
      refuse(function->values == 2 ? "two values are expected" : "one value is expected");
    }
    Part a = given.front(), b = given.back();
    if (!same_measure(a.is, b.is)) {
      refuse(fmt::format("the first value is {}, the second one {}", measure_kind(a.is), measure_kind(b.is)));
    }
    const bool one_of_them =
        function->operation == Operation::Kind::least || function->operation == Operation::Kind::most;
    const bool same_kelvins = a.is.kelvins == b.is.kelvins;
    if ((is_reading(a.is) || is_reading(b.is)) && !(one_of_them && same_kelvins)) {
      refuse(one_of_them ? "one temperature is in degC, the other one in K: write both in the same unit" : no_multiple);
    }
    if (!same_kelvins) a.is.kelvins = b.is.kelvins = Kelvins::either;
    if (a.is.turns != b.is.turns) refuse(turns_and_not);
    if (!varies(a, b)) {
      const Applied applied = function->of(a.is, b.is);
      if (!applied) refuse(applied.error());
      return {*applied};
    }
    // an angular velocity by a time is an angle; nothing else says that it is one
    const bool of_angle = function->operation == Operation::Kind::sin || function->operation == Operation::Kind::cos ||
                          function->operation == Operation::Kind::tan;
    a.is.is_angle = a.is.is_angle || (of_angle && is_plain_measure(a.is));
    a.is.value = b.is.value = 1;  // every function has a value there, of the kind that it always has
    const Applied applied = function->of(a.is, b.is);
    if (!applied) refuse(applied.error());
    const int first = place_of(given.front());
    return {.is = *applied,
            .operation =
                add({.kind = function->operation, .a = first, .b = given.size() > 1 ? place_of(given.back()) : first})};
  }

  std::string_view text_;
  const NameMeaning& meaning_;
  std::string_view variable_;
  Measure of_variable_;
  std::size_t i_ = 0;
  int depth_ = 0;
};

}  // namespace

Measure measure_of(const AnyQuantity& quantity) {
  return {.value = counts_cycles(quantity.unit) ? 2 * std::numbers::pi * quantity.value : quantity.value,
          .dimension = quantity.unit.dimension,
          .is_angle = quantity.unit.is_angle,
          .kelvins = counts_from_zero_celsius(quantity.unit) ? Kelvins::reading : Kelvins::either,
          .turns = is_turning(quantity.unit)};
}

tl::expected<Measure, UnitError> evaluate(std::string_view text, const NameMeaning& meaning) {
  const std::string plain = with_plain_signs(text);
  try {
    const Measure m = ExpressionParser(plain, meaning).all().is;
    if (!std::isfinite(m.value))
      return tl::unexpected(UnitError{.message = "this is not a finite number", .offset = 0, .width = 1});
    return m;
  } catch (UnitError& e) {
    return tl::unexpected(std::move(e));
  }
}

tl::expected<FormulaText, UnitError> formula_text(std::string_view text, std::string_view variable,
                                                  Dimension dimension) {
  const NameMeaning nothing = [&](std::string_view name) -> tl::expected<Measure, std::string> {
    return tl::unexpected(
        fmt::format("there is no '{}' here: a formula has numbers with their units, pi and '{}'", name, variable));
  };
  const std::string plain = with_plain_signs(text);
  try {
    ExpressionParser parser(plain, nothing, variable, {.value = 1, .dimension = dimension, .is_angle = false});
    const Part whole = parser.all();
    parser.place_of(whole);  // the last one is the formula's
    return FormulaText{.text = std::string(text), .is = whole.is, .operations = std::move(parser.operations)};
  } catch (UnitError& e) {
    return tl::unexpected(std::move(e));
  }
}

bool is_free_name(std::string_view name) {
  const bool letters = !name.empty() && starts_name(name.front()) && std::all_of(name.begin(), name.end(), in_name);
  return letters && !is_unit(name) && function_named(name) == nullptr && name != "pi";
}

std::string to_text(const Measure& measure) {
  if (measure.is_angle) return fmt::format("{:.17g} rad", measure.value);
  if (is_reading(measure)) return fmt::format("{:.17g} degC", measure.value - zero_celsius);
  if (measure.turns) return fmt::format("{:.17g} rad/s", measure.value);
  std::string text = fmt::format("{:.17g}", measure.value);
  const Dimension& d = measure.dimension;
  const std::array<std::pair<int, std::string_view>, 4> parts{
      {{d.mass, "kg"}, {d.length, "m"}, {d.time, "s"}, {d.temperature, "K"}}};
  for (const auto& [sixths, name] : parts) {
    if (sixths % whole_exponent != 0) return {};
    if (sixths != 0) text += fmt::format(" {}^{}", name, sixths / whole_exponent);
  }
  return text;
}

}  // namespace taut
