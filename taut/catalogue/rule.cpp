#include "taut/catalogue/rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/catalogue/csv.hpp"
#include "taut/catalogue/embedded/rules_csv.hpp"

namespace taut::catalogue {
namespace {

struct RuleUnit {
  std::string_view printed;
  std::string_view si;
  double factor;
};

constexpr std::array<RuleUnit, 7> units{{{.printed = "1", .si = "1", .factor = 1.0},
                                         {.printed = "deg", .si = "rad", .factor = std::numbers::pi / 180.0},
                                         {.printed = "m", .si = "m", .factor = 1.0},
                                         {.printed = "GPa", .si = "Pa", .factor = 1e9},
                                         {.printed = "MPa", .si = "Pa", .factor = 1e6},
                                         {.printed = "s/m", .si = "s/m", .factor = 1.0},
                                         {.printed = "kN", .si = "N", .factor = 1e3}}};

void read_numbers(CsvReader& csv, RuleRow& row) {
  const std::string& printed = csv.text("unit");
  const auto unit =
      std::find_if(units.begin(), units.end(), [&](const RuleUnit& one) { return one.printed == printed; });
  if (unit == units.end()) {
    csv.fail("unit", fmt::format("unit {} is not 1, deg, m, GPa, MPa, s/m or kN", in_quotes(printed)));
    return;
  }
  row.unit = std::string(unit->si);
  row.low = csv.optional_positive("low");
  row.high = csv.optional_positive("high");
  if (row.low.has_value() != row.high.has_value()) csv.fail("low", "low and high are both given, or neither");
  if (row.low && row.high && *row.low > *row.high) csv.fail("low", "low is above high");
  if (!row.low && row.text.empty()) csv.fail("text", "a rule without a number needs a text");
  if (row.low) *row.low *= unit->factor;
  if (row.high) *row.high *= unit->factor;
}

}  // namespace

tl::expected<std::vector<RuleRow>, Diagnostics> read_rules(std::string_view csv_text, std::string file) {
  CsvReader csv(csv_text, std::move(file),
                {{.name = "id"},
                 {.name = "field"},
                 {.name = "item"},
                 {.name = "class"},
                 {.name = "low"},
                 {.name = "high"},
                 {.name = "unit"},
                 {.name = "text"},
                 {.name = "source"},
                 {.name = "trust"},
                 {.name = "trust_text", .required = false},
                 {.name = "up_to", .required = false}});
  std::vector<RuleRow> rows;
  while (csv.next()) {
    RuleRow row;
    row.id = csv.unique("id");
    row.field = csv.text("field");
    row.item = csv.required_text("item");
    row.group = csv.text("class");
    row.text = csv.text("text");
    row.source = csv.required_text("source");
    row.trust = csv.trust("trust");
    row.trust_text = csv.text("trust_text");
    row.up_to = csv.optional_positive("up_to");
    read_numbers(csv, row);
    rows.push_back(std::move(row));
  }
  if (csv.failed()) return tl::unexpected(csv.take_diagnostics());
  return rows;
}

const std::vector<RuleRow>& rules() {
  static const std::vector<RuleRow> rows = [] {
    std::vector<RuleRow> all;
    for (const auto& [name, text] : embedded::rules_csv) {
      auto read = read_rules(text, fmt::format("data/rules/{}", name));
      expects(read.has_value(), read ? "" : to_text(read.error()));
      all.insert(all.end(), std::make_move_iterator(read->begin()), std::make_move_iterator(read->end()));
    }
    return all;
  }();
  return rows;
}

std::vector<RuleRow> rules_of(std::string_view prefix, const std::vector<RuleRow>& table) {
  const std::string start = fmt::format("{}.", prefix);
  std::vector<RuleRow> out;
  std::copy_if(table.begin(), table.end(), std::back_inserter(out),
               [&](const RuleRow& row) { return row.id.starts_with(start); });
  return out;
}

Found<RuleRow> find_rule(std::string_view id, const std::vector<RuleRow>& table) {
  const std::string wanted = normalised(id);
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const RuleRow& row) { return is_named(row.id, wanted); });
  if (found != table.end()) return *found;
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const RuleRow& row : table) names.push_back(row.id);
  return tl::unexpected(
      LookupError{.message = fmt::format("no rule {}", in_quotes(id)), .candidates = nearest_names(id, names, 5)});
}

Found<double> value_of(const RuleRow& rule) {
  if (!rule.low || !rule.high) {
    return tl::unexpected(
        LookupError{.message = fmt::format("rule '{}' has no number: {}", rule.id, rule.text), .candidates = {}});
  }
  if (*rule.low != *rule.high) {
    return tl::unexpected(
        LookupError{.message = fmt::format("rule '{}' is a range, {} to {} {}: choose a value in it", rule.id,
                                           short_number(*rule.low), short_number(*rule.high), rule.unit),
                    .candidates = {}});
  }
  return *rule.low;
}

}  // namespace taut::catalogue
