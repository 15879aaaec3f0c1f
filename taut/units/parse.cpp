#include "taut/units/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"
#include "taut/units/factor.hpp"
#include "taut/units/names.hpp"

namespace taut {
namespace {

using Failure = tl::unexpected<UnitError>;

Failure fail(std::string message, std::size_t offset = 0, std::size_t width = 1) {
  return Failure(UnitError{.message = std::move(message),
                           .offset = static_cast<int>(offset),
                           .width = static_cast<int>(std::max<std::size_t>(width, 1))});
}

constexpr std::size_t longest_quantity = 100;

struct Expression {
  std::vector<UnitPower> factors;
  Dimension dimension;
  int angles = 0;  ///< the power of the angle in it
  bool is_angle = false;
};

const NameRow* find_name(std::string_view name) {
  const auto& rows = name_rows();
  const auto at = std::find_if(rows.begin(), rows.end(), [&](const NameRow& r) { return r.name == name; });
  return at == rows.end() ? nullptr : &*at;
}

std::string unknown_unit(std::string_view name) {
  for (const RefusedName& r : refused_names()) {
    if (r.name == name) return fmt::format("'{}' is ambiguous or not a unit here; write {}", name, r.choices);
  }
  std::vector<std::string> known;
  for (const NameRow& r : name_rows()) known.emplace_back(r.name);
  const std::string hint = did_you_mean(name, known);
  return fmt::format("'{}' is not a unit{}", name, hint.empty() ? " (see 'taut list units')" : hint);
}

bool is_name_byte(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '%' || c == '\'' || c == '"' || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80U;
}

struct Superscript {
  std::string_view text;
  int value;
};
constexpr std::array<Superscript, 4> superscripts = {
    {{.text = "¹", .value = 1}, {.text = "²", .value = 2}, {.text = "³", .value = 3}, {.text = "⁴", .value = 4}}};
constexpr std::array<std::string_view, 3> printed_spaces = {"\u00a0", "\u2009", "\u202f"};
constexpr std::string_view printed_minus = "\u2212";
constexpr std::string_view middle_dot = "·";
constexpr std::string_view degree_sign = "°";

/// Reads "kN s/m", "mm^2", "kg/(m s)" over the allow-list.
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, std::size_t offset) : text_(text), offset_(offset) {}

  tl::expected<Expression, UnitError> read() {
    Expression e;
    bool divide = false;
    bool divided_before = false;
    while (true) {
      skip_spaces();
      const auto factor = read_factor(divide);
      if (!factor) return tl::unexpected(factor.error());
      add(e, *factor);
      divided_before = divided_before || divide;
      divide = false;
      const std::size_t gap = at_;
      skip_spaces();
      if (at_ == text_.size()) return e;
      if (text_[at_] == '/') {
        divide = true;
        ++at_;
      } else {
        if (divided_before) {
          return fail(
              "ambiguous after '/': put the factors before the '/', as in 'kN s/m', or repeat it, as in 'J/kg/K'",
              offset_ + gap, text_.size() - gap);
        }
        skip_product_sign();
      }
    }
  }

 private:
  void skip_spaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }
  void skip_product_sign() {
    if (!take("*")) take(middle_dot);
  }

  std::string_view read_name() {
    const std::size_t from = at_;
    if (take(degree_sign)) return text_.substr(from, at_ - from);
    while (at_ < text_.size() && is_name_byte(text_[at_])) {
      const std::string_view rest = text_.substr(at_);
      const bool power = std::any_of(superscripts.begin(), superscripts.end(),
                                     [&](const Superscript& s) { return rest.substr(0, s.text.size()) == s.text; });
      if (power || rest.substr(0, middle_dot.size()) == middle_dot) break;
      ++at_;
    }
    return text_.substr(from, at_ - from);
  }

  tl::expected<int, UnitError> read_exponent() {
    for (const Superscript& s : superscripts) {
      if (take(s.text)) return s.value;
    }
    const bool caret = take("^") || take("**");
    const std::size_t from = at_;
    const bool minus = caret && take("-");
    if (at_ < text_.size() && text_[at_] >= '1' && text_[at_] <= '4') {
      const int value = text_[at_++] - '0';
      if (at_ == text_.size() || (std::isdigit(static_cast<unsigned char>(text_[at_])) == 0 && text_[at_] != '.')) {
        return minus ? -value : value;
      }
      return fail("an exponent is a whole number up to 4", offset_ + from, at_ - from + 1);
    }
    if (caret || (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0)) {
      return fail("an exponent is a whole number from 1 to 4", offset_ + from, 1);
    }
    return 1;
  }

  tl::expected<UnitPower, UnitError> read_factor(bool divide) {
    const std::size_t from = at_;
    if (divide && at_ == from && take("1")) return fail("nothing to divide by", offset_ + from, 1);
    if (!divide && text_.substr(at_, 2) == "1/") {  // "1/s"
      ++at_;
      return UnitPower{.row = nullptr, .exponent = 0};
    }
    const std::string_view name = read_name();
    if (name.empty()) {
      return at_ < text_.size() ? fail(fmt::format("'{}' is not part of a unit", text_[at_]), offset_ + at_, 1)
                                : fail("the unit ends too early", offset_ + (from > 0 ? from - 1 : 0), 1);
    }
    const NameRow* row = find_name(name);
    if (row == nullptr) return fail(unknown_unit(name), offset_ + from, name.size());
    const auto exponent = read_exponent();
    if (!exponent) return tl::unexpected(exponent.error());
    return UnitPower{.row = row, .exponent = divide ? -*exponent : *exponent};
  }

  static void add(Expression& e, const UnitPower& f) {
    if (f.row == nullptr) return;
    e.factors.push_back(f);
    e.dimension = e.dimension * power(f.row->dimension, f.exponent);
    if (f.row->is_angle) e.angles += f.exponent;
    e.is_angle = e.is_angle || f.row->is_angle;
  }

  std::string_view text_;
  std::size_t offset_;
  std::size_t at_ = 0;
};

/// What 0 of this unit is in the SI unit: only a temperature alone counts from elsewhere.
double zero_of(const Expression& e) {
  return e.factors.size() == 1 && e.factors[0].exponent == 1 ? e.factors[0].row->scale.zero : 0;
}

/// What a person may write for this unit: "1 kN", "1 deg". Never their own number with a unit that they may not mean.
std::string example(const Unit& target) { return fmt::format("'1 {}'", target.shown); }

/// The kind of quantity that a unit expression measures, as a word for messages.
std::string kind_of(const Expression& e) {
  if (e.factors.size() == 1 && e.factors[0].exponent == 1) return std::string(e.factors[0].row->kind);
  for (const Unit& u : {si::one, si::m, si::m2, si::m3, si::m4, si::N, si::N_m, si::Pa, si::N_per_m, si::kg_per_m,
                        si::N_per_m3, si::m_per_s, si::m_per_s2, si::per_s, si::kg_m2, si::N_s_per_m, si::W}) {
    if (u.dimension == e.dimension) return std::string(u.kind);
  }
  return to_text(e.dimension);
}

/// Whether it says cycles per time by name; 1/s is rad/s where a speed of turning is asked for.
bool is_hertz(const Expression& e) {
  return e.factors.size() == 1 && e.factors[0].exponent == 1 && e.factors[0].row->kind == "frequency";
}

/// The SI value of 1 of these units in that one.
double factor_for(const Expression& e, const Unit& target) {
  const double factor = factor_of(e.factors);
  if (counts_cycles(target) && e.angles == 1) return factor / (2 * M_PI);
  const bool turns = target.dimension == si::per_s.dimension && !counts_cycles(target);
  return turns && is_hertz(e) ? factor * 2 * M_PI : factor;
}

bool fits(const Expression& e, const Unit& target) {
  if (e.dimension != target.dimension) return false;
  if (counts_cycles(target)) return e.angles == 0 || e.angles == 1;
  if (target.is_angle) return e.angles == 1;
  // an angle's unit counts only where an angle, or a speed of turning, is asked for
  return !e.is_angle || !is_plain_number(e.dimension);
}

bool is_percent(const Expression& e) { return e.factors.size() == 1 && e.factors[0].row->name == "%"; }

std::string with_article(std::string_view kind) {
  const bool vowel = !kind.empty() && std::string_view("aeio").find(kind.front()) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", kind);
}

tl::expected<Expression, UnitError> read_unit(std::string_view unit, std::size_t offset, const Unit& target) {
  auto e = ExpressionReader(unit, offset).read();
  if (!e) return e;
  const bool percent =
      std::any_of(e->factors.begin(), e->factors.end(), [](const UnitPower& f) { return f.row->name == "%"; });
  if (percent && !is_percent(*e)) return fail("'%' stands alone", offset, unit.size());
  const bool percent_fits = is_percent(*e) && is_plain_number(target.dimension);
  if (percent_fits || fits(*e, target)) return e;
  if (!target.needs_text()) {
    return fail(fmt::format("a plain number is expected here, not {}", with_article(kind_of(*e))), offset, unit.size());
  }
  return fail(fmt::format("'{}' is a unit of {}; {} is expected here, such as {}", unit, kind_of(*e),
                          with_article(target.kind), example(target)),
              offset, unit.size());
}

struct Split {
  double number = 0;
  std::size_t unit_from = 0;
  bool infinite = false;
};

bool starts_infinite(std::string_view rest) {
  return rest.substr(0, 4) == ".inf" || rest.substr(0, 4) == ".Inf" || rest.substr(0, 4) == ".INF";
}

/// Whether a sign that some write between thousands stands there, and a digit behind it: "1'000".
bool is_between_thousands(std::string_view rest) {
  for (const std::string_view sign : {"'", "\u2019", "_"}) {
    if (!rest.starts_with(sign) || rest.size() == sign.size()) continue;
    if (std::isdigit(static_cast<unsigned char>(rest[sign.size()])) != 0) return true;
  }
  return false;
}

/// The number at the front of a text, behind blanks.
tl::expected<Split, UnitError> split_number(std::string_view text) {
  if (text.size() > longest_quantity) return fail("too long for a quantity", 0, text.size());
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  const std::string_view sign = text.substr(begin, 1);
  const std::size_t from = begin + (sign == "+" ? 1 : 0);
  const bool minus = sign == "-";
  if (starts_infinite(text.substr(from + (minus ? 1U : 0U)))) {
    const double value = std::numeric_limits<double>::infinity();
    return Split{.number = minus ? -value : value, .unit_from = from + (minus ? 5U : 4U), .infinite = true};
  }
  if (from < text.size() && (text[from] == '+' || (from > begin && text[from] == '-')))
    return fail("two signs", from, 1);
  Split s;
  const NumberAtFront number = number_at_front(text.substr(from));
  const std::size_t used = number.length;
  if (used == 0) return fail(fmt::format("'{}' does not begin with a number", text), 0, text.size());
  if (!number.in_range) return fail("a number that is too large or too small to hold", 0, from + used);
  s.number = number.value;
  s.unit_from = from + used;
  if (s.unit_from < text.size() && text[s.unit_from] == ',') {
    return fail("a comma in a number: write a decimal point, and no signs between thousands", s.unit_from, 1);
  }
  if (is_between_thousands(text.substr(s.unit_from))) {
    return fail("a sign between thousands: write 1000 without one; feet are 'ft'", s.unit_from, 1);
  }
  return s;
}

}  // namespace

bool counts_cycles(const Unit& unit) { return unit.dimension == si::per_s.dimension && unit.shown == "Hz"; }

std::string with_plain_spaces(std::string_view text) {
  std::string plain(text);
  for (const std::string_view space : printed_spaces) {
    for (std::size_t at = plain.find(space); at != std::string::npos; at = plain.find(space, at))
      plain.replace(at, space.size(), space.size(), ' ');
  }
  return plain;
}

std::string with_plain_signs(std::string_view text) {
  std::string plain = with_plain_spaces(text);
  for (std::size_t at = plain.find(printed_minus); at != std::string::npos; at = plain.find(printed_minus, at + 1)) {
    if (at == 0 || plain[at - 1] != '^') plain.replace(at, printed_minus.size(), "  -");
  }
  return plain;
}

tl::expected<double, UnitError> parse_number(std::string_view text) {
  const std::string plain = with_plain_signs(text);
  const auto s = split_number(plain);
  if (!s) return tl::unexpected(s.error());
  if (s->infinite) return fail("a finite number is expected", 0, text.size());
  if (s->unit_from != plain.size()) return fail(fmt::format("'{}' is not a plain number", text), 0, text.size());
  return s->number;
}

tl::expected<double, UnitError> unit_factor(std::string_view unit, const Unit& target) {
  if (unit == target.symbol && !target.is_angle) return 1.0;
  const auto e = read_unit(unit, 0, target);
  if (!e) return tl::unexpected(e.error());
  if (zero_of(*e) != 0) return fail("a unit with an offset can't be used here; write 'K'", 0, unit.size());
  return factor_for(*e, target);
}

tl::expected<double, UnitError> parse_quantity(std::string_view text, const Unit& target, bool allow_infinite) {
  const std::string plain = with_plain_signs(text);
  text = plain;
  const auto s = split_number(text);
  if (!s) return tl::unexpected(s.error());
  if (s->infinite && !allow_infinite) return fail("a finite number is expected", 0, text.size());
  std::size_t unit_from = s->unit_from;
  while (unit_from < text.size() && (text[unit_from] == ' ' || text[unit_from] == '\t')) ++unit_from;
  std::string_view unit = text.substr(unit_from);
  while (!unit.empty() && (unit.back() == ' ' || unit.back() == '\t')) unit.remove_suffix(1);
  if (unit.empty()) {
    if (!target.needs_text() || s->infinite) return s->number;
    return fail(fmt::format("{} needs its unit, such as {}", with_article(target.kind), example(target)), 0,
                text.size());
  }
  if (std::isdigit(static_cast<unsigned char>(unit[0])) != 0 && unit.substr(0, 2) != "1/") {
    return fail("two numbers: write digits without spaces, and one unit", unit_from, unit.size());
  }
  const auto e = read_unit(unit, unit_from, target);
  if (!e) return tl::unexpected(e.error());
  if (s->infinite) return s->number;
  if (is_percent(*e)) return target.is_angle ? std::atan(s->number / 100.0) : s->number / 100.0;
  const double value = factor_for(*e, target) * s->number + zero_of(*e);
  if (!std::isfinite(value)) return fail("a number that is too large to hold in SI units", 0, text.size());
  return value;
}

const std::vector<UnitName>& unit_names() {
  static const std::vector<UnitName> names = [] {
    std::vector<UnitName> list;
    for (const NameRow& r : name_rows()) {
      list.push_back({std::string(r.name), std::string(r.meaning), std::string(r.kind)});
    }
    return list;
  }();
  return names;
}

}  // namespace taut
