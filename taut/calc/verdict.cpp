#include "taut/calc/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include "taut/calc/shown.hpp"
#include "taut/units/display.hpp"

namespace taut {
namespace {

constexpr double deciding = 0.5;  ///< utilisation from which on a limit decides
constexpr std::size_t most_names = 3;

/// "a, b, c and 2 more".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(most_names, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > most_names) text += fmt::format(" and {} more", names.size() - most_names);
  return text;
}

}  // namespace

std::string against_limit(const Check& c, const Display& display) {
  const auto [value, limit] = brief_apart(c, display);
  return fmt::format("{}, limit {} {}{}: {}", std::isnan(c.value) ? "no number" : value,
                     c.sense == Sense::at_most ? "at most" : "at least", limit,
                     c.where.empty() ? "" : fmt::format(" ({})", c.where), c.rule);
}

std::vector<std::string> unsafe_of(const Result& r) {
  std::vector<std::string> all = r.unsafe;
  std::vector<std::string> doubted;
  for (const Check& c : r.checks) {
    if (decides(c)) doubted.push_back(c.name);
  }
  if (!doubted.empty()) {
    all.push_back(fmt::format("{} on an unverified limit that decides: {}",
                              doubted.size() == 1 ? "1 check rests" : fmt::format("{} checks rest", doubted.size()),
                              listed(doubted)));
  }
  for (const Comparison& c : r.comparisons) {
    if (c.printed_unsafe && !c.corrected_decides) {
      all.push_back(fmt::format("the published value of '{}' is unsafe and decides here", c.quantity));
    }
  }
  return all;
}

std::string missing_words(const MissingStates& m) {
  std::string where = "first " + m.first;
  if (!m.all.empty()) where = m.missing == 1 ? m.all : m.all + "; the first";
  return fmt::format("{}: no equilibrium at {} of {} places, {}: {}", m.analysis, m.missing, m.places, where, m.reason);
}

namespace {

Verdict failing(const Result& r, std::vector<const Check*> failed) {
  std::stable_sort(failed.begin(), failed.end(), [](auto* a, auto* b) { return severity(*a) > severity(*b); });
  std::string reason = failed.front()->name + " " + against_limit(*failed.front(), Display(r.display));
  std::vector<std::string> others;
  for (const Check* c : failed) {
    if (c != failed.front()) others.push_back(c->name);
  }
  if (!others.empty()) reason += fmt::format("; fails too: {}", listed(others));
  if (r.status != Status::ok && !r.interrupted && !r.message.empty())
    reason += fmt::format("; other states have no answer: {}", r.message);
  return {.kind = VerdictKind::fails, .verdict_class = {}, .reason = std::move(reason)};
}

std::optional<Verdict> not_judged(const Result& r) {
  if (!r.unmade.empty()) {
    const std::size_t more = r.unmade.size() - 1;
    return Verdict{.kind = VerdictKind::not_judged,
                   .verdict_class = "unmade",
                   .reason = r.unmade.front() + (more > 0 ? fmt::format(" (and {} more)", more) : std::string{})};
  }
  if (!r.missing.empty())
    return Verdict{
        .kind = VerdictKind::not_judged, .verdict_class = "unmade", .reason = missing_words(r.missing.front())};
  std::vector<std::string> refused;
  for (const Check& c : r.checks) {
    if (c.refused) refused.push_back(c.name);
  }
  if (!refused.empty()) {
    const auto first = std::find_if(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.refused; });
    return Verdict{
        .kind = VerdictKind::not_judged,
        .verdict_class = "unverified",
        .reason = fmt::format("{} {}: {}", listed(refused),
                              refused.size() == 1 ? "rests on an unverified limit" : "rest on unverified limits",
                              first->rule)};
  }
  if (!r.unjudged.empty()) {
    return Verdict{.kind = VerdictKind::not_judged,
                   .verdict_class = "unasked",
                   .reason = fmt::format("no limit is given for {}", listed(r.unjudged))};
  }
  const bool limited = std::any_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return c.limits; });
  if (!limited)
    return Verdict{
        .kind = VerdictKind::not_judged, .verdict_class = "unasked", .reason = "nothing is checked against a limit"};
  return std::nullopt;
}

/// The check nearest to its limit, of all that have a utilisation: what can fail, as D/d does, is a limit here too.
std::string governing(const Result& r) {
  const Check* top = nullptr;
  for (const Check& c : r.checks) {
    if (c.refused || std::isnan(c.utilisation)) continue;
    if (top == nullptr || severity(c) > severity(*top)) top = &c;
  }
  if (top == nullptr) return "every check passes";
  return fmt::format("nearest to its limit is {}, utilisation {:.3g}{}", top->name, top->utilisation,
                     top->where.empty() ? std::string{} : fmt::format(" ({})", top->where));
}

Verdict judged(const Result& r) {
  std::vector<const Check*> failed;
  for (const Check& c : r.checks) {
    if (!c.passes && !c.refused) failed.push_back(&c);
  }
  // A state that exists and fails says more than one that does not exist.
  if (!failed.empty()) return failing(r, std::move(failed));
  if (r.status != Status::ok && !r.interrupted)
    return {.kind = VerdictKind::no_answer, .verdict_class = {}, .reason = r.message};
  if (r.interrupted) {
    // an interrupted result without a message says what was not done
    const bool told = !r.message.empty() || r.unmade.empty();
    return {.kind = VerdictKind::not_judged, .verdict_class = "unmade", .reason = told ? r.message : r.unmade.front()};
  }
  if (auto open = not_judged(r)) return *std::move(open);
  const std::string best = r.headline.empty() ? governing(r) : r.headline;
  const std::vector<std::string> unsafe = unsafe_of(r);
  if (unsafe.empty()) return {.kind = VerdictKind::passes, .verdict_class = {}, .reason = best};
  std::string reason = unsafe.front();
  if (unsafe.size() > 1) reason += fmt::format(" (and {} more)", unsafe.size() - 1);
  return {.kind = VerdictKind::passes_with_warnings, .verdict_class = {}, .reason = reason};
}

/// One sentence: a capital letter, one full stop.
std::string as_sentence(std::string text) {
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text.empty() ? text : text + ".";
}

}  // namespace

std::optional<Verdict> verdict_of(const Result& r) {
  if (r.status == Status::bad_deck) return std::nullopt;
  Verdict v = judged(r);
  if (!r.preface.empty()) v.reason = r.preface + "; " + v.reason;
  if (!r.left_out.empty()) v.reason += fmt::format("; left out by 'judge: false': {}", listed(r.left_out));
  v.reason = as_sentence(std::move(v.reason));
  return v;
}

std::string_view to_text(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::fails:
      return "fails";
    case VerdictKind::no_answer:
      return "no_answer";
    case VerdictKind::not_judged:
      return "not_judged";
    case VerdictKind::passes_with_warnings:
      return "passes_with_warnings";
    case VerdictKind::passes:
      break;
  }
  return "passes";
}

std::string_view headline(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::fails:
      return "Fails";
    case VerdictKind::no_answer:
      return "No answer";
    case VerdictKind::not_judged:
      return "Not judged";
    case VerdictKind::passes_with_warnings:
      return "Passes, with warnings";
    case VerdictKind::passes:
      break;
  }
  return "Passes";
}

bool is_unverified(std::string_view trust) {
  constexpr std::string_view word = "unverified";
  return trust.size() >= word.size() && std::equal(word.begin(), word.end(), trust.begin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

bool decides(const Check& c) { return is_unverified(c.trust) && !c.refused && severity(c) >= deciding; }

double severity(const Check& c) {
  constexpr double steps = 1e9;
  if (std::isnan(c.utilisation)) return c.passes ? 0 : HUGE_VAL;
  if (!(std::abs(c.utilisation) < 1e6)) return c.utilisation;
  return (std::round(steps * c.utilisation) + (c.passes ? 0 : 0.5)) / steps;
}

bool worse_state(const Check& a, const Check& b) {
  if (a.passes != b.passes) return b.passes;
  if (!std::isnan(a.utilisation) && !std::isnan(b.utilisation)) return a.utilisation > b.utilisation;
  const auto beyond = [](const Check& c) { return c.sense == Sense::at_most ? c.value - c.limit : c.limit - c.value; };
  return beyond(a) > beyond(b);
}

int exit_code(const Result& r, bool strict) {
  if (r.status == Status::bad_deck) return only_unreadable_files(r.errors) ? 5 : 2;
  if (r.interrupted) return 130;
  const Verdict v = *verdict_of(r);
  switch (v.kind) {
    case VerdictKind::fails:
      return 4;
    case VerdictKind::no_answer:
      return 3;
    case VerdictKind::not_judged:
      return v.verdict_class == "unasked" && !strict ? 0 : 4;
    case VerdictKind::passes_with_warnings:
    case VerdictKind::passes:
      break;
  }
  return 0;
}

}  // namespace taut
