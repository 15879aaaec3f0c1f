#include "taut/app/explain/explain.hpp"

#include <fmt/format.h>

#include <set>

#include "taut/app/explain/described.hpp"
#include "taut/app/explain/keys.hpp"
#include "taut/app/job.hpp"
#include "taut/app/machine_deck.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/machine/links/observable.hpp"
#include "taut/results/described.hpp"

namespace taut::app {
namespace {

/// A bar would end the cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string equations(const Result& example) {
  std::string text;
  std::set<std::string> seen;
  for (const Step& s : example.steps) {
    if (s.kind == Step::Kind::heading) text += fmt::format("\n  {}\n", s.words);
    if (s.kind != Step::Kind::equation && s.kind != Step::Kind::root) continue;
    const std::string right = formula_text(s.formula);
    if (!seen.insert(s.eq + s.symbol + right).second) continue;
    const std::string number = s.eq.empty() ? "" : fmt::format("({})", s.eq);
    const std::string line = s.kind == Step::Kind::root ? fmt::format("{}: root of {} = 0", s.symbol, right)
                                                        : fmt::format("{} = {}", s.symbol, right);
    text += fmt::format("    {:<8}{}  [{}]\n", number, line, s.unit.symbol);
  }
  return text;
}

/// The keys of a description and its nested ones.
std::string keys_table(const std::string& head, const Description& description) {
  std::string text = fmt::format("| {} | unit | default | symbol | meaning |\n|---|---|---|---|---|\n", head);
  walk_keys("", description, [&](const std::string& key, const Description& d, const Field& f) {
    const std::string symbol = f.symbol.empty() ? "" : fmt::format("`{}`", f.symbol);
    text +=
        fmt::format("| `{}` | {} | {} | {} | {} |\n", key, kind_text(f), default_of(d, f), symbol, cell(full_words(f)));
  });
  return text;
}

std::string results_table(const std::string& head, const std::vector<QuantityWords>& all) {
  std::string text = fmt::format("| {} | SI unit | symbol | meaning |\n|---|---|---|---|\n", head);
  for (const QuantityWords& q : all) {
    const std::string symbol = q.symbol.empty() ? "" : fmt::format("`{}`", q.symbol);
    const std::string_view unit = q.unit.symbol == "1" ? "" : q.unit.symbol;
    text += fmt::format("| `{}` | {} | {} | {} |\n", q.name, unit, symbol, cell(q.words));
  }
  return text;
}

std::string values_table(const std::vector<ValueKind>& all) {
  std::string text = "| value | SI unit | symbol | meaning | of | page |\n|---|---|---|---|---|---|\n";
  for (const ValueKind& one : all) {
    const QuantityWords& q = one.about;
    const std::string symbol = q.symbol.empty() ? "" : fmt::format("`{}`", q.symbol);
    const std::string_view unit = q.unit.symbol == "1" ? "" : q.unit.symbol;
    const std::string file = one.page.substr(one.page.rfind('/') + 1);
    const std::string link =
        one.page.empty() ? "" : fmt::format("[{}](../{})", file.substr(0, file.rfind('.')), one.page);
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", q.name, unit, symbol, cell(q.words), cell(one.of), link);
  }
  return text;
}

std::string table_text(const TableWords& t) {
  return fmt::format("### Table `{}`\n\nA row for: {}.\n\n{}\n", t.name, t.rows, results_table("column", t.columns));
}

std::string exact_values(const Description& d) {
  std::string text;
  for (const Field& f : d.fields) text += fmt::format("  {:<24}{:<8}{}\n", f.key, f.unit.symbol, f.words);
  return text;
}

}  // namespace

std::string keys_text(const std::string& prefix, const Description& description) {
  std::string text;
  walk_keys(prefix, description, [&](const std::string& key, const Description& d, const Field& f) {
    text += fmt::format("  {:<31} {:<23} {:<13} {}{}\n", key, kind_text(f), default_of(d, f),
                        f.symbol.empty() ? "" : f.symbol + ": ", full_words(f));
  });
  return text;
}

std::string explain_text(const MethodEntry& method) {
  const Method& about = *method.about;
  const Result example = run(Job{.text = std::string(method.example), .name = about.name + ".yaml", .set = {}});
  std::string text = fmt::format("{} ({})\n\nSource: {}\n\n{}\n", about.title, about.name, about.source, about.scope);
  if (!about.limits.empty()) text += "\nLimits\n";
  for (const std::string& limit : about.limits) text += fmt::format("  - {}\n", limit);
  text += "\nEquations (numbers of the source; * is a correction)\n";
  text += equations(example);
  text += "\nDeck keys below `input:`\n";
  text += keys_text("", *method.input);
  text += "\nResult values\n";
  walk_keys("", *method.output, [&](const std::string& key, const Description&, const Field& f) {
    text += fmt::format("  {:<24}{:<8}{}{}\n", key, f.unit.symbol, f.words, f.source.empty() ? "" : "  " + f.source);
  });
  if (method.exact != nullptr) text += "\nValues of the exact solution by the engine\n" + exact_values(*method.exact);
  if (!about.errata.empty()) text += "\nErrata of the source (each with the test that shows it)\n";
  for (const Erratum& e : about.errata) {
    text += fmt::format("  {}: printed {}; correct {}. {} [{}]\n", e.where, e.printed, e.correct, e.evidence, e.test);
  }
  return text;
}

std::string reference_markdown(const MethodEntry& method) {
  const Method& about = *method.about;
  std::string text = fmt::format("## `method: {}`\n\n{}. Source: {}\n\n", about.name, about.title, about.source);
  text += keys_table("key below `input:`", *method.input);
  text += "\n| value | SI unit | meaning | equation |\n|---|---|---|---|\n";
  walk_keys("", *method.output, [&](const std::string& key, const Description&, const Field& f) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", key, f.unit.symbol, cell(f.words), cell(f.source));
  });
  if (method.exact != nullptr) {
    text += "\n| value of the engine | SI unit | meaning |\n|---|---|---|\n";
    for (const Field& f : method.exact->fields) {
      text += fmt::format("| `{}` | {} | {} |\n", f.key, f.unit.symbol, cell(f.words));
    }
  }
  return text + "\n";
}

std::string reference_guide() {
  std::string text =
      "# Reference: deck keys and result names\n\n"
      "Generated by `taut explain all --markdown`; a test compares this page with the program.\n"
      "A quantity is written with a unit; the unit column shows the usual one. Results (`--json`) are in SI.\n\n"
      "Every deck has `taut: 1`, and `method:` with `input:` or `machine:` with `analyses:`, and may have `title:`, "
      "`display:` (kind of quantity to unit), `project:` "
      "and\n"
      "`include:` (decks that this one is merged with; its own keys replace theirs).\n\n"
      "## `project:`\n\nThe head of the report. Every key may be left out.\n\n";
  text += keys_table("key", Project::describe()) + "\n";
  for (const MethodEntry& method : methods()) text += reference_markdown(method);
  text +=
      "## `machine:` and `analyses:`\n\nA machine in place of a method; see [machine decks](machine-decks.md), also "
      "for "
      "the result tables.\n\n";
  text += keys_table("key", MachineDeck::describe()) + "\n";
  text +=
      "## Results of a machine\n\n"
      "Words in capitals stand for names of the deck: `ROPE.T_max` is `skyline.T_max`. The second and every further "
      "analysis of a kind\n"
      "adds an ending to its tables and values, its `name` or its number: `spans_hoist`, `skyline.T_start_2`.\n\n";
  for (const TableWords& t : results::table_words()) text += table_text(t);
  for (const ValueGroup& group : value_groups()) {
    text += fmt::format("### {}\n\n{}\n", group.title, values_table(group.values));
  }
  text +=
      "### What `observe`, conditions and measures take\n\nOf a moving machine; each is a column of `time.csv`, and "
      "`NAME_min`, `NAME_max`, `NAME_end` are values.\n\n";
  text += results_table("path", machine::observable_words());
  for (const TableGroup& group : table_groups()) {
    text += fmt::format("\n## {}\n\n{}\n\n", group.title, group.words);
    for (const TableWords& t : group.tables) text += table_text(t);
    text.pop_back();
  }
  return text;
}

}  // namespace taut::app
