#include "taut/io/deck/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "taut/calc/result.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/units/display.hpp"
#include "taut/units/names.hpp"

namespace taut::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* number_pattern = "[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?";
constexpr double nearly_infinite = 1.797e308;

/// All names of the unit list that `fits` accepts, longest first, joined by |.
template <class Fits>
std::string names(Fits&& fits) {
  std::vector<std::string> all;
  for (const NameRow& r : name_rows()) {
    if (fits(r)) all.emplace_back(r.name);
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return fmt::format("{}", fmt::join(all, "|"));
}

/// A unit that fits: one name of its dimension, or any product of powers (whose dimension a schema can't check).
std::string unit_pattern(const Unit& unit) {
  const std::string any = fmt::format("({})", names([](const NameRow& r) { return r.name != "%"; }));
  const std::string power = "(\\^-?[1-4]|\\*\\*-?[1-4]|[1-4]|¹|²|³|⁴)";
  const std::string own = names([&](const NameRow& r) {
    return r.dimension == unit.dimension && r.is_angle == unit.is_angle && (r.name != "%" || unit.is_angle);
  });
  if (unit.is_angle) return fmt::format("({})", own);
  const std::string compound = fmt::format(
      "(1/{0}{1}?|{0}{1}|{0}{1}?[ \t]*(\\*|·|/| )[ \t]*{0}{1}?([ \t]*(\\*|·|/| )[ \t]*{0}{1}?)*)", any, power);
  return own.empty() ? compound : fmt::format("({}|{})", own, compound);
}

std::string words_of(const Field& f) {
  std::string text = f.words;
  if (!f.symbol.empty()) text += fmt::format("; {}", f.symbol);
  if (f.unit.needs_text()) text += fmt::format(" [{}]", f.unit.shown);
  const std::string range = range_text(f);
  if (!range.empty()) text += fmt::format("; {}", range);
  return text;
}

void add_range(Json& schema, const Range& range) {
  if (std::isfinite(range.low)) schema[range.low_included ? "minimum" : "exclusiveMinimum"] = range.low;
  if (std::isfinite(range.high)) schema[range.high_included ? "maximum" : "exclusiveMaximum"] = range.high;
}

/// "= 2 * travel": over the deck's parameters.
const Json& expression() {
  static const Json pattern = {{"type", "string"}, {"pattern", "^="}};
  return pattern;
}

Json one_number(const Field& f) {
  Json choices = Json::array();
  if (f.unit.needs_text()) {
    choices.push_back({{"type", "string"}, {"pattern", quantity_pattern(f.unit)}});
    // .inf is a number to whoever reads YAML
    if (f.may_be_infinite) choices.push_back({{"type", "number"}, {"exclusiveMinimum", nearly_infinite}});
  } else {
    Json plain = {{"type", "number"}};
    add_range(plain, f.range);
    choices.push_back(std::move(plain));
    choices.push_back({{"type", "string"}, {"pattern", fmt::format("^{}[ \t]*%$", number_pattern)}});
  }
  choices.push_back(expression());
  return {{"anyOf", std::move(choices)}};
}

Json object(const Description& d, bool whole);

Json of_kind(const Field& f, bool whole);

/// A nested struct, or what may stand for it.
Json nested(const Field& f, bool whole) {
  Json full = object(*f.record, whole);
  if (f.shorthand.empty()) return full;
  return {{"anyOf", {std::move(full), of_kind(*f.record->find(f.shorthand), whole)}}};
}

Json of_kind(const Field& f, bool whole) {
  switch (f.kind) {
    case FieldKind::number:
      return one_number(f);
    case FieldKind::numbers: {
      const Json one = one_number(f);
      return {{"anyOf", {one, Json{{"type", "array"}, {"items", one}, {"minItems", 1}}}}};
    }
    case FieldKind::whole_number: {
      Json whole_number = {{"type", "integer"}};
      add_range(whole_number, f.range);
      return {{"anyOf", {std::move(whole_number), expression()}}};
    }
    case FieldKind::flag:
      return {{"type", "boolean"}};
    case FieldKind::text: {
      Json text = {{"type", {"string", "number", "boolean"}}};
      if (f.required) text["minLength"] = 1;
      return text;
    }
    case FieldKind::choice:
      return {{"enum", f.choices}};
    case FieldKind::triple: {
      Json list = {{"type", "array"}, {"items", one_number(f)}, {"minItems", 3}, {"maxItems", 3}};
      if (!f.map_form) return list;
      return {{"anyOf", {std::move(list), object(*f.record, whole)}}};
    }
    case FieldKind::texts: {
      const Json text = f.choices.empty() ? Json{{"type", {"string", "number", "boolean"}}} : Json{{"enum", f.choices}};
      return {{"anyOf", {text, Json{{"type", "array"}, {"items", text}}}}};
    }
    case FieldKind::record:
      return nested(f, whole);
    case FieldKind::records:
      // a list is never merged with an included one: its entries are always whole
      return {{"type", "array"}, {"items", nested(f, true)}, {"minItems", 1}};
    case FieldKind::named_records: {
      const Json map = {{"type", "object"}, {"additionalProperties", nested(f, whole)}};
      return f.one_for_all ? Json{{"anyOf", {map, of_kind(*f.record->find(f.shorthand), whole)}}} : map;
    }
  }
  return {};
}

void add_default(Json& schema, const Description& d, const Field& f) {
  const std::optional<double> number = default_number(d, f);
  if (number && std::isfinite(*number)) {
    if (f.kind == FieldKind::whole_number) {
      schema["default"] = static_cast<int>(*number);
    } else {
      schema["default"] = f.unit.needs_text() ? Json(Display().quantity(*number, f.unit)) : Json(*number);
    }
  }
  const std::string text = default_text(d, f);
  if (text.empty()) return;
  schema["default"] = f.kind == FieldKind::flag ? Json(text == "true") : Json(text);
}

/// `whole`: required keys have to be there.
Json object(const Description& d, bool whole) {
  Json properties = Json::object();
  Json required = Json::array();
  Json others = false;
  for (const Field& f : d.fields) {
    if (f.rest) {
      others = nested(f, whole);
      others["description"] = words_of(f);
      continue;
    }
    Json schema = of_kind(f, whole);
    const std::string words = words_of(f);
    if (!words.empty()) schema["description"] = words;
    add_default(schema, d, f);
    const bool list = f.kind == FieldKind::records || f.kind == FieldKind::texts || f.kind == FieldKind::numbers;
    if (list && !whole) properties[f.key + "+"] = schema;  // adds to the list of an included deck
    properties[f.key] = std::move(schema);
    if (f.required) required.push_back(f.key);
  }
  Json all = {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", std::move(others)}};
  if (whole && !required.empty()) all["required"] = std::move(required);
  for (const std::vector<std::string>& group : d.exactly_one) {
    if (!whole) continue;
    Json one = Json::array();
    for (const std::string& key : group) one.push_back({{"required", {key}}});
    all["allOf"].push_back({{"oneOf", std::move(one)}});
  }
  return all;
}

Json display() {
  Json kinds = Json::object();
  for (const Unit& u : display_kinds()) {
    const std::string pattern =
        u.is_angle ? fmt::format("({})", names([](const NameRow& r) { return r.is_angle && r.name != "%"; }))
                   : unit_pattern(u);
    kinds[std::string(u.kind)] = {{"type", "string"}, {"pattern", fmt::format("^{}$", pattern)}};
  }
  return {{"type", "object"},
          {"description", "units of print, by kind of quantity"},
          {"properties", std::move(kinds)},
          {"additionalProperties", false}};
}

Json project() {
  Json all = object(Project::describe(), false);
  all["description"] = "what the head of the report says of the order; every key may be left out";
  return all;
}

Json top_level(const std::vector<SchemaMethod>& methods) {
  Json names_of_methods = Json::array();
  for (const SchemaMethod& m : methods) names_of_methods.push_back(m.name);
  const Json path = {{"type", "string"}, {"minLength", 1}};
  return {{"taut", {{"const", 1}, {"description", "format of the deck"}}},
          {"title", {{"type", {"string", "number", "boolean"}}, {"description", "what the calculation is of"}}},
          {"project", project()},
          {"method", {{"enum", std::move(names_of_methods)}, {"description", "the published method"}}},
          {"display", display()},
          {"include",
           {{"anyOf", {path, Json{{"type", "array"}, {"items", path}}}},
            {"description", "decks whose values hold where this one says nothing"}}},
          {"parameters",
           {{"type", "object"},
            {"additionalProperties", {{"type", {"string", "number", "boolean"}}}},
            {"description", "named values; a text '= 2 * travel' anywhere in the deck is an expression over them"}}},
          {"input", {{"type", "object"}, {"description", "the data of the method"}}}};
}

Json when(Json condition, Json consequence) { return {{"if", std::move(condition)}, {"then", std::move(consequence)}}; }

/// The keys of a machine's deck: whole when nothing is included, and never beside those of a method.
void add_machine(const Description& machine, Json& top, Json& definitions, Json& rules) {
  const Json has_include = {{"required", {"include"}}};
  for (const bool whole : {true, false}) {
    const Json keys = object(machine, whole)["properties"];
    Json properties = Json::object();
    for (const auto& [key, schema] : keys.items()) {
      const std::string name = whole ? key : key + ".part";
      definitions[name] = schema;
      properties[key] = {{"$ref", fmt::format("#/definitions/{}", name)}};
      top[key] = Json::object();
    }
    rules.push_back(when(whole ? Json{{"not", has_include}} : has_include, {{"properties", std::move(properties)}}));
  }
  const Json both = {{"anyOf", {Json{{"required", {"method"}}}, Json{{"required", {"input"}}}}}};
  rules.push_back(when({{"required", {"machine"}}}, {{"not", both}}));
}

}  // namespace

std::string quantity_pattern(const Unit& unit) {
  return fmt::format("^{}[ \t]*{}[ \t]*$", number_pattern, unit_pattern(unit));
}

std::string deck_schema(const std::vector<SchemaMethod>& methods, const Description* machine) {
  Json rules = Json::array();
  const Json has_include = {{"required", {"include"}}};
  Json definitions = Json::object();
  Json top = top_level(methods);
  Json whole = {{"required", {"taut", "method", "input"}}};
  if (machine != nullptr) {
    whole = {{"anyOf", {whole, Json{{"required", {"taut", "machine"}}}}}};
    add_machine(*machine, top, definitions, rules);
  }
  rules.push_back(when({{"not", has_include}}, std::move(whole)));
  for (const SchemaMethod& m : methods) {
    definitions[m.name] = object(*m.input, true);
    definitions[m.name]["title"] = m.title;
    definitions[m.name + ".part"] = object(*m.input, false);
    const Json is_method = {{"properties", {{"method", {{"const", m.name}}}}}, {"required", {"method"}}};
    const auto input = [](const std::string& definition) {
      return Json{{"properties", {{"input", {{"$ref", fmt::format("#/definitions/{}", definition)}}}}}};
    };
    rules.push_back(when({{"allOf", {is_method, Json{{"not", has_include}}}}}, input(m.name)));
    rules.push_back(when({{"allOf", {is_method, has_include}}}, input(m.name + ".part")));
  }
  const Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                       {"title", "taut deck"},
                       {"type", "object"},
                       {"properties", std::move(top)},
                       {"additionalProperties", false},
                       {"allOf", std::move(rules)},
                       {"definitions", std::move(definitions)}};
  return schema.dump(1) + "\n";
}

}  // namespace taut::io
