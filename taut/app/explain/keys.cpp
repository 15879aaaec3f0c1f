#include "taut/app/explain/keys.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/units/display.hpp"

namespace taut::app {
namespace {

/// As a deck writes it.
std::string default_number_text(double si, const Unit& unit) {
  if (std::isinf(si)) return si > 0 ? ".inf" : "-.inf";
  return Display().quantity(si, unit);
}

}  // namespace

void walk_keys(const std::string& prefix, const Description& description, const KeyVisit& visit) {
  for (const Field& f : description.fields) {
    const std::string path = prefix + (f.rest ? "NAME" : f.key);
    visit(path, description, f);
    if (f.record == nullptr) continue;
    const char* const inner = f.is_list ? "[]." : f.kind == FieldKind::named_records && !f.rest ? ".NAME." : ".";
    walk_keys(path + inner, *f.record, visit);
  }
}

std::string kind_text(const Field& f) {
  switch (f.kind) {
    case FieldKind::number:
      return f.unit.needs_text() ? std::string(f.unit.shown) : "number";
    case FieldKind::numbers:
      return fmt::format("{}, one or a list", f.unit.needs_text() ? f.unit.shown : "number");
    case FieldKind::whole_number:
      return "whole number";
    case FieldKind::flag:
      return "true or false";
    case FieldKind::text:
    case FieldKind::choice:
      return "text";
    case FieldKind::record:
      return "map";
    case FieldKind::records:
      return "list of maps";
    case FieldKind::triple:
      return fmt::format("[x, y, z], each {}{}", f.unit.needs_text() ? f.unit.shown : "number",
                         f.map_form ? ", or map" : "");
    case FieldKind::texts:
      return "text, one or a list";
    case FieldKind::named_records:
      return f.rest ? "map" : "map of names and maps";
  }
  return {};
}

std::string default_of(const Description& d, const Field& f) {
  if (f.required) return "required";
  if (const auto number = default_number(d, f)) return default_number_text(*number, f.unit);
  const std::string text = default_text(d, f);
  return text.empty() ? "-" : text;
}

std::string full_words(const Field& f) {
  std::string words = f.words;
  std::string choices;
  for (const std::string& c : f.choices) choices += fmt::format("{}`{}`", choices.empty() ? "" : ", ", c);
  if (!choices.empty()) words += fmt::format(": {}", choices);
  const std::string range = range_text(f);
  if (!range.empty()) words += fmt::format(" ({})", range);
  return words;
}

}  // namespace taut::app
