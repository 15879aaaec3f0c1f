#include "taut/app/explain/report_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "taut/app/explain/described.hpp"
#include "taut/checks/described.hpp"
#include "taut/results/described.hpp"

namespace taut::app {
namespace {

/// "safety_factor" of "safety_factor_2".
std::string without_number(std::string name) {
  const std::size_t digits = name.find_last_not_of("0123456789");
  if (digits + 1 < name.size() && digits != std::string::npos && digits > 0 && name[digits] == '_') name.resize(digits);
  return name;
}

std::optional<std::string> check_text(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::string key = without_number(dot == std::string::npos ? name : name.substr(dot + 1));
  const auto& all = checks::check_words();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.key == key; });
  if (found == all.end()) return std::nullopt;
  return fmt::format("{}\n  meaning   {}\n  part of   checks of a {}: NAME.{}\n  page      docs/guide/checks.md\n",
                     name, found->words, found->of, found->key);
}

/// "discard_hoist" is such a table as "discard_ROPE": a word in capitals stands for a name of the deck.
bool is_such(const std::string& name, const std::string& pattern) {
  const auto capital = [](unsigned char c) { return std::isupper(c) != 0; };
  const auto begin = std::find_if(pattern.begin(), pattern.end(), capital);
  if (begin == pattern.end()) return name == pattern;
  const std::string_view before(pattern.begin(), begin),
      behind(std::find_if_not(begin, pattern.end(), capital), pattern.end());
  return name.size() > before.size() + behind.size() && name.starts_with(before) && name.ends_with(behind);
}

/// The table of a name.
std::optional<TableWords> table_named(const std::string& name) {
  std::vector<TableWords> all = results::table_words();
  for (const TableGroup& group : table_groups()) all.insert(all.end(), group.tables.begin(), group.tables.end());
  const auto find = [&](const auto& is) -> std::optional<TableWords> {
    const auto found = std::find_if(all.begin(), all.end(), is);
    return found == all.end() ? std::nullopt : std::optional(*found);
  };
  const auto named = [&](const std::string& own) {
    return find([&](const TableWords& one) { return one.name == own; });
  };
  if (auto own = named(name)) return own;
  return find([&](const TableWords& one) { return is_such(name, one.name); });
}

std::optional<std::string> table_text(const std::string& name, const std::optional<TableWords>& found) {
  if (!found) return std::nullopt;
  std::string text = fmt::format("{}\n  meaning   a table of results, a row for: {}\n", name, found->rows);
  text += fmt::format("  part of   tables of results: {}\n\nColumns (taut explain COLUMN)\n", found->name);
  for (const QuantityWords& column : found->columns) text += fmt::format("  {}: {}\n", column.name, column.words);
  return text;
}

}  // namespace

std::string plain_name(std::string name) {
  const std::size_t at = name.rfind(" [");
  if (at != std::string::npos && name.ends_with(']')) name.resize(at);
  constexpr std::string_view roller = ".roller";
  const std::size_t from = name.find(roller);
  const std::size_t to = from == std::string::npos ? from : name.find_first_not_of("0123456789", from + roller.size());
  if (to != std::string::npos && to > from + roller.size() && name[to] == '.') name.erase(from, to - from);
  return name;
}

std::optional<std::string> explain_report_name(const std::string& name) {
  if (auto text = check_text(name)) return text;
  return table_text(name, table_named(name));
}

std::optional<std::string> explain_table_of_analysis(const std::string& name) {
  for (std::size_t at = name.rfind('_'); at != std::string::npos && at > 0; at = name.rfind('_', at - 1)) {
    if (auto text = table_text(name, table_named(name.substr(0, at)))) return text;
  }
  return std::nullopt;
}

}  // namespace taut::app
