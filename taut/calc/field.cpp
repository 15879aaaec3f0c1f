#include "taut/calc/field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/units/display.hpp"

namespace taut {

Field& DescriptionBuilder::add(FieldKind kind, std::string_view key, std::string_view symbol, const Unit& unit,
                               std::string_view words) {
  Field& f = description_.fields.emplace_back();
  f.kind = kind;
  f.key = key;
  f.symbol = symbol;
  f.unit = unit;
  f.words = words;
  f.is_list = kind == FieldKind::numbers || kind == FieldKind::texts || kind == FieldKind::records;
  return f;
}

Field& DescriptionBuilder::add(FieldKind kind, std::string_view key, std::string_view words,
                               const Description& record) {
  Field& f = add(kind, key, "", si::one, words);
  f.record = &record;
  return f;
}

bool Range::contains(double x) const {
  const bool above = low_included ? x >= low : x > low;
  const bool below = high_included ? x <= high : x < high;
  return above && below;
}

const Field* Description::find(const std::string& key) const {
  const auto at = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == key; });
  return at == fields.end() ? nullptr : &*at;
}

std::vector<std::string> Description::keys() const {
  std::vector<std::string> all;
  all.reserve(fields.size());
  for (const Field& f : fields) {
    if (!f.rest) all.push_back(f.key);
  }
  return all;
}

std::optional<double> default_number(const Description& d, const Field& f) {
  if (f.required) return std::nullopt;
  const auto object = d.make_default();
  const Slot slot = f.slot(object.get());
  if (const auto* number = std::get_if<double*>(&slot); number != nullptr && !std::isnan(**number)) return **number;
  if (const auto* maybe = std::get_if<std::optional<double>*>(&slot)) return **maybe;
  if (const auto* whole = std::get_if<int*>(&slot)) return **whole;
  return std::nullopt;
}

std::string default_text(const Description& d, const Field& f) {
  if (f.required) return {};
  const auto object = d.make_default();
  const Slot slot = f.slot(object.get());
  if (const auto* choice = std::get_if<Choice>(&slot)) return choice->get();
  if (const auto* text = std::get_if<std::string*>(&slot)) return **text;
  if (const auto* maybe = std::get_if<std::optional<std::string>*>(&slot)) return (*maybe)->value_or("");
  if (const auto* flag = std::get_if<bool*>(&slot)) return **flag ? "true" : "false";
  return {};
}

std::string range_text(const Field& f) {
  const Display display;
  std::string text;
  if (std::isfinite(f.range.low)) {
    text = fmt::format("{} {}", f.range.low_included ? "at least" : "above", display.quantity(f.range.low, f.unit));
  }
  if (std::isfinite(f.range.high)) {
    text += fmt::format("{}{} {}", text.empty() ? "" : " and ", f.range.high_included ? "at most" : "below",
                        display.quantity(f.range.high, f.unit));
  }
  return text;
}

std::string DeckPlace::text() const {
  if (up_ == nullptr) return std::string(key_);
  return key_.empty() ? fmt::format("{}[{}]", up_->text(), index_) : fmt::format("{}.{}", up_->text(), key_);
}

}  // namespace taut
