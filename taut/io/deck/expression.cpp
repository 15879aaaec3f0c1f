#include "taut/io/deck/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "taut/base/suggest.hpp"
#include "taut/io/deck/source.hpp"

namespace taut::io {
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
  Applied (*of)(const Measure& a, const Measure& b);
};
constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr std::array<Function, 11> functions{{
    {.name = "sqrt", .values = 1, .of = [](const Measure& a, const Measure&) { return root(a); }},
    {.name = "abs",
     .values = 1,
     .of = [](const Measure& a, const Measure&) -> Applied {
       return Measure{.value = std::abs(a.value), .dimension = a.dimension, .is_angle = a.is_angle};
     }},
    {.name = "min",
     .values = 2,
     .of = [](const Measure& a, const Measure& b) -> Applied { return a.value <= b.value ? a : b; }},
    {.name = "max",
     .values = 2,
     .of = [](const Measure& a, const Measure& b) -> Applied { return a.value >= b.value ? a : b; }},
    {.name = "sin", .values = 1, .of = [](const Measure& a, const Measure&) { return of_angle(std::sin, a); }},
    {.name = "cos", .values = 1, .of = [](const Measure& a, const Measure&) { return of_angle(std::cos, a); }},
    {.name = "tan", .values = 1, .of = [](const Measure& a, const Measure&) { return of_angle(std::tan, a); }},
    {.name = "asin", .values = 1, .of = [](const Measure& a, const Measure&) { return angle_of(std::asin, a, 1); }},
    {.name = "acos", .values = 1, .of = [](const Measure& a, const Measure&) { return angle_of(std::acos, a, 1); }},
    {.name = "atan",
     .values = 1,
     .of = [](const Measure& a, const Measure&) { return angle_of(std::atan, a, unbounded); }},
    {.name = "atan2",
     .values = 2,
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

/// Recursive descent over the text; throws its UnitError, which `evaluate` gives back.
class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, const NameMeaning& meaning) : text_(text), meaning_(meaning) {}

  Measure all() {
    const Measure m = sum();
    skip();
    if (i_ < text_.size()) fail("an operator (+ - * / ^) is expected here", i_);
    return m;
  }

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

  Measure sum() {
    Measure left = product();
    while (true) {
      skip();
      const std::size_t from = i_;
      const bool plus = take('+');
      if (!plus && !take('-')) return left;
      const Measure right = product();
      if (!same_measure(left, right)) {
        fail(fmt::format("the left side is {}, the right one {}", measure_kind(left), measure_kind(right)), from);
      }
      left.value += plus ? right.value : -right.value;
    }
  }

  Measure product() {
    Measure left = factor();
    while (true) {
      const bool times = take('*');
      if (!times && !take('/')) return left;
      const Measure right = factor();
      const bool angle = times ? left.is_angle != right.is_angle : left.is_angle && !right.is_angle;
      left.value = times ? left.value * right.value : left.value / right.value;
      left.dimension = times ? left.dimension * right.dimension : left.dimension / right.dimension;
      left.is_angle = angle && is_plain_number(left.dimension);
    }
  }

  Measure factor() {
    if (take('-')) {
      Measure m = deeper(&ExpressionParser::factor);
      m.value = -m.value;
      return m;
    }
    if (take('+')) return deeper(&ExpressionParser::factor);
    const Measure base = primary();
    skip();
    const std::size_t from = i_;
    if (!take('^')) return base;
    const Measure exponent = deeper(&ExpressionParser::factor);
    const double whole = std::round(exponent.value);
    if (!is_plain_measure(exponent) || whole != exponent.value || std::abs(whole) > largest_exponent) {
      fail(fmt::format("the exponent has to be a whole number up to {}", largest_exponent), from);
    }
    return {.value = std::pow(base.value, whole),
            .dimension = power(base.dimension, static_cast<int>(whole)),
            .is_angle = base.is_angle && whole == 1};
  }

  /// Everything that nests goes through here, so that no text can exhaust the stack.
  Measure deeper(Measure (ExpressionParser::*part)()) {
    if (++depth_ > deepest_parentheses) fail(fmt::format("nested deeper than {}", deepest_parentheses), i_);
    const Measure m = (this->*part)();
    --depth_;
    return m;
  }

  Measure primary() {
    skip();
    if (i_ >= text_.size()) fail("a value is missing at the end", text_.empty() ? 0 : text_.size() - 1);
    if (take('(')) {
      const std::size_t opened = i_ - 1;
      const Measure m = deeper(&ExpressionParser::sum);
      if (!take(')')) fail("this '(' is not closed", opened);
      return m;
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

  Measure quantity() {
    const std::size_t from = i_;
    i_ = number_end(i_);
    std::size_t end = unit_end(i_);
    if (end == i_) {  // a word behind a number could only be its unit
      std::size_t word = i_;
      while (word < text_.size() && text_[word] == ' ') ++word;
      if (word < text_.size() && starts_name(text_[word])) {
        while (word < text_.size() && in_name(text_[word])) ++word;
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
    return {.value = read->value, .dimension = read->unit.dimension, .is_angle = read->unit.is_angle};
  }

  Measure name() {
    const std::size_t from = i_;
    while (i_ < text_.size() && in_name(text_[i_])) ++i_;
    const std::string_view word = text_.substr(from, i_ - from);
    skip();
    if (i_ < text_.size() && text_[i_] == '(') return call(word, from);
    if (word == "pi") return {.value = std::numbers::pi, .dimension = {}, .is_angle = false};
    const auto found = meaning_(word);
    if (!found) fail(found.error(), from, word.size());
    return *found;
  }

  Measure call(std::string_view word, std::size_t from) {
    const Function* function = function_named(word);
    if (function == nullptr) {
      fail(fmt::format("there is no function {}{}", in_quotes(word), did_you_mean(word, function_names())), from,
           word.size());
    }
    take('(');
    std::vector<Measure> given;
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
    const Measure a = given.front(), b = given.back();
    if (!same_measure(a, b))
      refuse(fmt::format("the first value is {}, the second one {}", measure_kind(a), measure_kind(b)));
    const Applied applied = function->of(a, b);
    if (!applied) refuse(applied.error());
    return *applied;
  }

  std::string_view text_;
  const NameMeaning& meaning_;
  std::size_t i_ = 0;
  int depth_ = 0;
};

}  // namespace

tl::expected<Measure, UnitError> evaluate(std::string_view text, const NameMeaning& meaning) {
  try {
    const Measure m = ExpressionParser(text, meaning).all();
    if (!std::isfinite(m.value))
      return tl::unexpected(UnitError{.message = "this is not a finite number", .offset = 0, .width = 1});
    return m;
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

}  // namespace taut::io
