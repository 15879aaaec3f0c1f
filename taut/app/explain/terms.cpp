#include "taut/app/explain/terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "taut/app/explain/described.hpp"
#include "taut/app/explain/keys.hpp"
#include "taut/app/machine_deck.hpp"
#include "taut/app/methods.hpp"
#include "taut/machine/links/observable.hpp"
#include "taut/results/described.hpp"

namespace taut::app {
namespace {

using Words = std::vector<std::string>;
constexpr std::string_view any_name = "*";

/// A word in capitals stands for a name of the deck.
bool stands_for_a_name(std::string_view word) {
  return word.size() >= 3 &&
         std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isupper(c) != 0; });
}

void add_word(Words& words, std::string_view word, bool of_path) {
  const std::size_t index = word.find('[');
  const std::string_view bare = word.substr(0, index);
  if (of_path && stands_for_a_name(bare)) {
    words.emplace_back(any_name);
  } else if (!bare.empty()) {
    std::string& text = words.emplace_back(bare);
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (of_path && index != std::string_view::npos) words.emplace_back(any_name);
}

/// "machine.reevings[].length": machine, reevings, *, length.
Words words_of_path(std::string_view path, bool of_path) {
  Words words;
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    add_word(words, path.substr(0, dot), of_path);
    if (dot == std::string_view::npos) break;
    path.remove_prefix(dot + 1);
  }
  return words;
}

/// Whether the last `n` words of the name are the end of the first `m` words of the path.
bool ends_with(const Words& name, std::size_t n, const Words& path, std::size_t m, bool names) {
  if (n == 0) return true;
  if (m == 0) return false;
  if (path[m - 1] == any_name) {
    return ends_with(name, n, path, m - 1, names) || (names && ends_with(name, n - 1, path, m - 1, names));
  }
  return name[n - 1] == path[m - 1] && ends_with(name, n - 1, path, m - 1, names);
}

/// "friction" in "static_friction".
bool has_word(const std::string& text, const std::string& word) {
  std::size_t at = text.find(word);
  for (; at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || text[at - 1] == '_') && (end == text.size() || text[end] == '_')) return true;
  }
  return false;
}

/// The path of the key that holds this one: "machine.reevings" of "machine.reevings[].length".
std::string holder_of(const std::string& path) {
  std::string holder = path.substr(0, path.rfind('.') == std::string::npos ? 0 : path.rfind('.'));
  if (holder.ends_with(".NAME")) holder.resize(holder.size() - 5);
  if (holder.ends_with("[]")) holder.resize(holder.size() - 2);
  return holder;
}

void add_keys(std::vector<Term>& all, const std::string& prefix, const Description& description) {
  std::map<std::string, std::string> places;
  walk_keys(prefix, description, [&](const std::string& path, const Description& d, const Field& f) {
    const std::string holder = holder_of(path);
    places[path] = fmt::format("{}: {}", path, f.words);
    const std::string place = places.contains(holder) ? places[holder] : "the deck";
    all.push_back({.kind = Term::Kind::key,
                   .path = path,
                   .unit = kind_text(f),
                   .words = f.words,
                   .place = place,
                   .description = &d,
                   .field = &f});
  });
}

void add_results(std::vector<Term>& all, Term::Kind kind, const std::string& prefix, const std::string& place,
                 const std::vector<QuantityWords>& quantities) {
  for (const QuantityWords& q : quantities) {
    const std::string unit = q.unit.needs_text() ? std::string(q.unit.shown) : std::string();
    all.push_back({.kind = kind, .path = prefix + q.name, .unit = unit, .words = q.words, .place = place});
  }
}

void add_values(std::vector<Term>& all, const std::vector<ValueKind>& kinds) {
  for (const ValueKind& kind : kinds) {
    add_results(all, Term::Kind::value, "", "values of results: " + kind.of, {kind.about});
    if (!kind.page.empty()) all.back().page = "docs/" + kind.page;
  }
}

void add_tables(std::vector<Term>& all, const std::vector<TableWords>& tables) {
  for (const TableWords& t : tables) {
    add_results(all, Term::Kind::column, t.name + ".", fmt::format("table {}: a row for: {}", t.name, t.rows),
                t.columns);
  }
}

void add_values_of(std::vector<Term>& all, const std::string& method, const Description& output) {
  walk_keys("", output, [&](const std::string& path, const Description&, const Field& f) {
    const std::string unit = f.unit.needs_text() ? std::string(f.unit.shown) : std::string();
    all.push_back({.kind = Term::Kind::value,
                   .path = method + "." + path,
                   .unit = unit,
                   .words = f.words,
                   .place = fmt::format("values of method {}{}", method, f.source.empty() ? "" : ", " + f.source)});
  });
}

std::string rule_words(const catalogue::RuleRow& r) {
  std::string words = r.item;
  if (!r.field.empty()) words += fmt::format(" ({})", r.field);
  return words;
}

}  // namespace

const std::vector<Term>& terms() {
  static const std::vector<Term> all = [] {
    std::vector<Term> found;
    add_keys(found, "", MachineDeck::describe());
    add_keys(found, "project.", Project::describe());
    for (const MethodEntry& m : methods()) add_keys(found, m.about->name + ".input.", *m.input);
    for (const catalogue::RuleRow& r : catalogue::rules()) {
      found.push_back({.kind = Term::Kind::rule,
                       .path = r.id,
                       .unit = r.unit == "1" ? "" : r.unit,
                       .words = rule_words(r),
                       .place = "rules",
                       .rule = &r});
    }
    for (const ValueGroup& group : value_groups()) add_values(found, group.values);
    for (const MethodEntry& m : methods()) {
      add_values_of(found, m.about->name, *m.output);
      if (m.exact != nullptr) add_values_of(found, m.about->name, *m.exact);
    }
    add_tables(found, results::table_words());
    for (const TableGroup& group : table_groups()) add_tables(found, group.tables);
    add_results(found, Term::Kind::observable, "", "observe, measures and conditions of events",
                machine::observable_words());
    return found;
  }();
  return all;
}

Fit fit_of(std::string_view name, std::string_view path) {
  const Words asked = words_of_path(name, false);
  const Words words = words_of_path(path, true);
  if (asked.empty() || words.empty()) return Fit::none;
  if (words.back() != any_name && ends_with(asked, asked.size(), words, words.size(), false)) {
    Words bare = words;
    std::erase(bare, std::string(any_name));
    return bare.size() == asked.size() ? Fit::whole : Fit::tail;
  }
  const bool last = words.back() != any_name;
  if (asked.size() > 1 && last && asked.back() == words.back() &&
      ends_with(asked, asked.size(), words, words.size(), true)) {
    return Fit::by_name;
  }
  if (asked.size() == 1 && has_word(words.back(), asked[0])) return Fit::part;
  const auto before_last = words.end() - 1;
  return std::search(words.begin(), before_last, asked.begin(), asked.end()) == before_last ? Fit::none : Fit::below;
}

}  // namespace taut::app
