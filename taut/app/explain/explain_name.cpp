#include "taut/app/explain/explain_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "taut/app/explain/example_lines.hpp"
#include "taut/app/explain/explain.hpp"
#include "taut/app/explain/explain_machine.hpp"
#include "taut/app/explain/keys.hpp"
#include "taut/app/explain/listing.hpp"
#include "taut/app/explain/report_names.hpp"
#include "taut/app/explain/synonyms.hpp"
#include "taut/app/explain/terms.hpp"
#include "taut/base/suggest.hpp"

namespace taut::app {
namespace {

using Hits = std::vector<const Term*>;

/// Lines of one list, at most; the rest is counted.
constexpr std::size_t most_lines = 20;

constexpr std::pair<Term::Kind, const char*> kinds[] = {{Term::Kind::key, "Keys of decks"},
                                                        {Term::Kind::rule, "Rules"},
                                                        {Term::Kind::value, "Values of results"},
                                                        {Term::Kind::column, "Columns of tables"},
                                                        {Term::Kind::observable, "Observed quantities"}};

std::string line(const char* head, const std::string& text) {
  return text.empty() ? std::string() : fmt::format("  {:<9} {}\n", head, text);
}

std::string last_word(const std::string& path) { return path.substr(path.rfind('.') + 1); }

/// Names of the other keys beside this one.
std::string neighbours(const Term& key) {
  std::string text;
  for (const Field& f : key.description->fields) {
    if (&f != key.field && !f.rest) text += (text.empty() ? "" : ", ") + f.key;
  }
  return text;
}

std::string text_of_key(const Term& key) {
  const Field& f = *key.field;
  std::string text =
      fmt::format("{}\n", key.path) + line("meaning", f.words) + line("symbol", f.symbol) + line("takes", key.unit);
  std::string choices;
  for (const std::string& c : f.choices) choices += (choices.empty() ? "" : ", ") + c;
  text += line("one of", choices) + line("range", range_text(f));
  text += line("default",
               default_of(*key.description, f) == "-" ? "none; may be left out" : default_of(*key.description, f));
  text += line("part of", key.place);
  const ExampleLine example = example_line(key);
  if (!example.text.empty()) {
    text += line("example", example.text + (example.deck.empty() ? "" : "    (" + example.deck + ")"));
  }
  text += line("related", neighbours(key));
  if (f.record != nullptr) {
    const char* const inner = f.is_list ? "[]." : f.kind == FieldKind::named_records && !f.rest ? ".NAME." : ".";
    text += "\nDeck keys\n" + keys_text(f.key + inner, *f.record);
  }
  return text;
}

/// The number of a rule in its unit: "3", "20 to 25 deg"; empty for a formula or words.
std::string number_of(const catalogue::RuleRow& r) {
  if (!r.low || !r.high) return {};
  const double degree = std::numbers::pi / 180;
  const bool angle = r.unit == "rad";
  const double scale = angle ? 1 / degree : 1;
  const std::string unit = angle ? " deg" : r.unit == "1" ? "" : " " + r.unit;
  if (*r.low == *r.high) return fmt::format("{:.5g}{}", *r.low * scale, unit);
  return fmt::format("{:.5g} to {:.5g}{}", *r.low * scale, *r.high * scale, unit);
}

/// How a deck names it.
std::string use_of(const catalogue::RuleRow& r) {
  constexpr std::string_view factors = "safety.";
  if (!r.id.starts_with(factors)) return "taken by the checks that need it; all rules: taut list rules";
  return fmt::format("checks: {{ropes: {{NAME: {{field: {}}}}}}}, or rule: {}", r.id.substr(factors.size()), r.id);
}

std::string text_of_rule(const Term& term) {
  const catalogue::RuleRow& r = *term.rule;
  std::string text = fmt::format("{}\n", r.id) + line("rule", r.item) + line("field", r.field) +
                     line("class", r.group) + line("limit", number_of(r)) + line("text", r.text) +
                     line("source", r.source);
  std::string trust(catalogue::to_text(r.trust));
  if (!r.trust_text.empty()) trust += ": " + r.trust_text;
  text += line("trust", trust);
  std::string related;
  const std::string family = r.id.substr(0, r.id.rfind('.'));
  for (const catalogue::RuleRow& other : catalogue::rules_of(family)) {
    if (other.id != r.id) related += (related.empty() ? "" : ", ") + other.id;
  }
  if (std::count(related.begin(), related.end(), ',') >= static_cast<std::ptrdiff_t>(most_lines)) related.clear();
  return text + line("related", related) + line("use", use_of(r));
}

std::string text_of(const Term& term) {
  if (term.kind == Term::Kind::key) return text_of_key(term);
  if (term.kind == Term::Kind::rule) return text_of_rule(term);
  return fmt::format("{}\n", term.path) + line("meaning", term.words) + line("unit", term.unit) +
         line("part of", term.place) + line("page", term.page);
}

std::string list_of(const Hits& hits) {
  std::string text;
  for (const auto& [kind, title] : kinds) {
    std::vector<std::vector<std::string>> rows;
    std::size_t count = 0;
    for (const Term* t : hits) {
      if (t->kind != kind || ++count > most_lines) continue;
      const std::string number = t->rule == nullptr ? t->unit : number_of(*t->rule);
      rows.push_back({"  " + t->path, number, t->words});
    }
    if (rows.empty()) continue;
    text += fmt::format("\n{}\n{}", title, aligned(rows));
    if (count > most_lines) text += fmt::format("  and {} more\n", count - most_lines);
  }
  return text;
}

Hits hits_of(const std::string& name, std::initializer_list<Fit> fits) {
  Hits hits;
  for (const Fit wanted : fits) {
    for (const Term& t : terms()) {
      const Fit fit = fit_of(name, t.path);
      if (fit == wanted && (fit != Fit::below || t.rule != nullptr)) hits.push_back(&t);
    }
  }
  return hits;
}

/// Terms in whose path names of a deck stand; where the first word is one of the path's own, only those with it.
Hits hits_by_name(const std::string& name) {
  const Hits all = hits_of(name, {Fit::by_name});
  const std::string first = name.substr(0, name.find_first_of(".["));
  Hits own;
  for (const Term* t : all) {
    if (fmt::format(".{}", t->path).find(fmt::format(".{}", first)) != std::string::npos) own.push_back(t);
  }
  return own.empty() ? all : own;
}

/// Terms in whose meaning the word stands.
Hits hits_in_words(const std::string& name) {
  Hits hits;
  const auto letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (const Term& t : terms()) {
    const std::size_t at = t.words.find(name);
    if (name.size() < 3 || at == std::string::npos) continue;
    const std::size_t end = at + name.size();
    if ((at == 0 || !letter(t.words[at - 1])) && (end == t.words.size() || !letter(t.words[end]))) hits.push_back(&t);
  }
  return hits;
}

/// The text on a method, or on a part or an analysis of machines; a part by its singular too.
std::optional<std::string> topic_text(const std::string& name) {
  for (const std::string& topic : {name, name + "s"}) {
    if (auto text = explain_machine(topic)) return text;
  }
  if (const MethodEntry* method = find_method(name)) return explain_text(*method);
  return std::nullopt;
}

/// What else has the name of a topic, by its path.
std::string see_also(const std::string& name) {
  std::string text;
  std::set<std::string> seen = {"machine." + name, "machine." + name + "s", "analyses[]." + name, name};
  for (const Term* t : hits_of(name, {Fit::whole, Fit::tail, Fit::below})) {
    if (seen.insert(t->path).second) text += fmt::format("  {}\n", t->path);
  }
  return text.empty() ? text : "\nThe same name elsewhere (taut explain PATH)\n" + text;
}

/// The value that has just this name, before the other hits.
std::optional<std::string> text_of_value(const std::string& name, const Hits& hits) {
  const auto own = std::find_if(hits.begin(), hits.end(),
                                [&](const Term* t) { return t->kind == Term::Kind::value && t->path == name; });
  if (own == hits.end()) return std::nullopt;
  Hits others;
  std::copy_if(hits.begin(), hits.end(), std::back_inserter(others), [&](const Term* t) { return t != *own; });
  if (others.empty()) return text_of(**own);
  return fmt::format("{}\nOthers with that name, or a part of it (taut explain PATH)\n{}", text_of(**own),
                     list_of(others));
}

std::optional<std::string> found_text(const std::string& name) {
  if (auto topic = topic_text(name)) return *topic + see_also(name);
  Hits hits = hits_of(name, {Fit::whole, Fit::tail});
  if (hits.empty()) hits = hits_by_name(name);
  if (hits.size() == 1 && hits_of(name, {Fit::part, Fit::below}).empty()) return text_of(*hits.front());
  for (const Term* t : hits) {
    if (fit_of(name, t->path) == Fit::whole && name.find('.') != std::string::npos) return text_of(*t);
  }
  for (const Term* t : hits_of(name, {Fit::part, Fit::below})) hits.push_back(t);
  if (auto text = text_of_value(name, hits)) return text;
  if (hits.empty()) return std::nullopt;
  if (hits.size() == 1) return text_of(*hits.front());
  return fmt::format("'{}' is the name, or a part of the name, of {} things. 'taut explain PATH' explains one.\n{}",
                     name, hits.size(), list_of(hits));
}

/// All names that may have been meant.
std::vector<std::string> all_names() {
  std::set<std::string> last;
  for (const Term& t : terms()) {
    if (t.kind == Term::Kind::rule) last.insert(t.path);
    last.insert(last_word(t.path));
  }
  std::vector<std::string> names = method_names();
  for (const std::string& topic : machine_topics()) names.push_back(topic);
  for (const std::string& word : field_words()) names.push_back(word);
  names.insert(names.end(), last.begin(), last.end());
  return names;
}

/// Whether a value, or what can be observed, has that name; an N at its end stands for a number.
bool is_of_results(const std::string& name) {
  const auto& all = terms();
  return std::any_of(all.begin(), all.end(), [&](const Term& t) {
    if (t.kind != Term::Kind::value && t.kind != Term::Kind::observable) return false;
    const Fit fit = fit_of(name, t.path);
    return fit == Fit::whole || fit == Fit::tail || fit == Fit::by_name || t.path == name + "_N";
  });
}

/// "sag_2" is such a column as "sag_N".
std::optional<std::string> text_of_numbered(const std::string& name) {
  const std::size_t at = name.find_last_not_of("0123456789");
  if (at == std::string::npos || at + 1 == name.size() || name[at] != '_') return std::nullopt;
  return found_text(name.substr(0, at + 1) + "N");
}

/// What has the name without its last words behind "_": those of a further analysis, a number, an extreme.
std::optional<std::string> text_without_ending(const std::string& name) {
  for (std::size_t at = name.rfind('_'); at != std::string::npos && at > 0; at = name.rfind('_', at - 1)) {
    const std::string own = name.substr(0, at);
    const auto text = is_of_results(own) ? found_text(own) : std::nullopt;
    if (!text) continue;
    return fmt::format("'{}' is '{}' with an ending: the name or number of an analysis, a number, or an extreme.\n\n{}",
                       name, own, *text);
  }
  return std::nullopt;
}

}  // namespace

tl::expected<std::string, std::string> explain_name(const std::string& asked) {
  const std::string name = plain_name(asked);
  if (auto text = found_text(name)) return *text;
  if (auto text = explain_report_name(name)) return *text;
  const std::string own = deck_word(name);
  if (!own.empty()) {
    const std::string head = fmt::format("'{}': the word of a deck is '{}'.\n\n", name, own);
    return head + found_text(own).value_or("");
  }
  const Hits hits = hits_in_words(name);
  if (hits.size() == 1)
    return fmt::format("Nothing is named '{}'; the word stands here.\n\n{}", name, text_of(*hits[0]));
  if (!hits.empty()) {
    return fmt::format("Nothing is named '{}'; the word stands in the meaning of {} things.\n{}", name, hits.size(),
                       list_of(hits));
  }
  if (auto text = text_of_numbered(name)) return *text;
  if (auto text = text_without_ending(name)) return *text;
  if (auto text = explain_table_of_analysis(name)) return *text;
  const std::string near = nearest(name, all_names());
  const std::string meant = near.empty() ? std::string() : fmt::format("; did you mean '{}'?", near);
  return tl::unexpected(
      fmt::format("nothing is named '{}'{}\n'taut explain machine' lists parts and analyses, 'taut list methods' and "
                  "'taut list rules' the others",
                  name, meant));
}

}  // namespace taut::app
