#include "taut/app/explain.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <set>

#include "taut/units/parse.hpp"

namespace taut::app {
namespace {

std::string shown_number(double si, const Unit& unit) {
  if (std::isinf(si)) return si > 0 ? ".inf" : "-.inf";
  const double factor = unit.needs_text() ? unit_factor(unit.shown, unit).value_or(1) : 1;
  return fmt::format("{:.6g}", si / factor);
}

std::string with_unit(const std::string& number, const Unit& unit) {
  return unit.needs_text() ? fmt::format("{} {}", number, unit.shown) : number;
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
  }
  return {};
}

std::string default_of(const Description& d, const Field& f) {
  if (f.required) return "required";
  if (const auto number = default_number(d, f)) return with_unit(shown_number(*number, f.unit), f.unit);
  const std::string text = default_text(d, f);
  return text.empty() ? "-" : text;
}

std::string words_of(const Field& f) {
  std::string words = f.words;
  std::string choices;
  for (const std::string& c : f.choices) choices += fmt::format("{}`{}`", choices.empty() ? "" : ", ", c);
  if (!choices.empty()) words += fmt::format(": {}", choices);
  const std::string range = range_text(f);
  if (!range.empty()) words += fmt::format(" ({})", range);
  return words;
}

using Visit = std::function<void(const std::string& key, const Description&, const Field&)>;

/// Visits a description and its nested ones, with dotted keys.
void walk(const std::string& prefix, const Description& d, const Visit& visit) {
  for (const Field& f : d.fields) {
    const std::string key = prefix + f.key;
    visit(key, d, f);
    if (f.record != nullptr) walk(key + (f.is_list ? "[]." : "."), *f.record, visit);
  }
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

}  // namespace

std::string range_text(const Field& f) {
  const bool low = std::isfinite(f.range.low);
  const bool high = std::isfinite(f.range.high);
  if (!low && !high) return {};
  const std::string from = shown_number(f.range.low, f.unit);
  const std::string to = with_unit(shown_number(f.range.high, f.unit), f.unit);
  if (!high) return fmt::format("{} {}", f.range.low_included ? "at least" : "above", with_unit(from, f.unit));
  if (!low) return fmt::format("{} {}", f.range.high_included ? "at most" : "below", to);
  return fmt::format("{}{} to {}{}", f.range.low_included ? "" : "above ", from, f.range.high_included ? "" : "below ",
                     to);
}

std::string explain_text(const Method& about, const Description& input, const Description& output,
                         const Result& example) {
  std::string text = fmt::format("{} ({})\n\nSource: {}\n\n{}\n", about.title, about.name, about.source, about.scope);
  if (!about.limits.empty()) text += "\nLimits\n";
  for (const std::string& limit : about.limits) text += fmt::format("  - {}\n", limit);
  text += "\nEquations (numbers of the source; * is a correction)\n";
  text += equations(example);
  text += "\nDeck keys below `input:`\n";
  walk("", input, [&](const std::string& key, const Description& d, const Field& f) {
    text += fmt::format("  {:<32}{:<24}{:<14}{}{}\n", key, kind_text(f), default_of(d, f),
                        f.symbol.empty() ? "" : f.symbol + ": ", words_of(f));
  });
  text += "\nResult values\n";
  walk("", output, [&](const std::string& key, const Description&, const Field& f) {
    text += fmt::format("  {:<24}{:<8}{}{}\n", key, f.unit.symbol, f.words, f.source.empty() ? "" : "  " + f.source);
  });
  if (!about.errata.empty()) text += "\nErrata of the source (each with the test that shows it)\n";
  for (const Erratum& e : about.errata) {
    text += fmt::format("  {}: printed {}; correct {}. {} [{}]\n", e.where, e.printed, e.correct, e.evidence, e.test);
  }
  return text;
}

std::string reference_markdown(const Method& about, const Description& input, const Description& output) {
  std::string text = fmt::format("## `method: {}`\n\n{}. Source: {}\n\n", about.name, about.title, about.source);
  text += "| key below `input:` | unit | default | symbol | meaning |\n|---|---|---|---|---|\n";
  walk("", input, [&](const std::string& key, const Description& d, const Field& f) {
    const std::string symbol = f.symbol.empty() ? "" : fmt::format("`{}`", f.symbol);
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key, kind_text(f), default_of(d, f), symbol, words_of(f));
  });
  text += "\n| value | SI unit | meaning | equation |\n|---|---|---|---|\n";
  walk("", output, [&](const std::string& key, const Description&, const Field& f) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", key, f.unit.symbol, f.words, f.source);
  });
  return text + "\n";
}

}  // namespace taut::app
