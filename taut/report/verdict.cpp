#include "taut/report/verdict.hpp"

#include <fmt/format.h>

#include "taut/report/text/quantity.hpp"

namespace taut::report {
namespace {

Mood mood_of(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::fails:
    case VerdictKind::no_answer:
      return Mood::bad;
    case VerdictKind::not_judged:
      return Mood::neutral;
    case VerdictKind::passes_with_warnings:
      return Mood::warning;
    case VerdictKind::passes:
      break;
  }
  return Mood::good;
}

const char* icon_of(Mood mood) {
  switch (mood) {
    case Mood::good:
      return "\u2713";
    case Mood::warning:
      return "!";
    case Mood::bad:
      return "\u2715";
    case Mood::neutral:
      break;
  }
  return "?";
}

std::string scope_of(const Result& r) {
  std::string text;
  if (!r.exempt.empty()) text = fmt::format("Exempt by the deck: {}.", fmt::join(r.exempt, ", "));
  if (!r.beside.empty()) {
    text += fmt::format("{}Not part of the verdict: {}.", text.empty() ? "" : " ", fmt::join(r.beside, "; "));
  }
  return text;
}

}  // namespace

Banner banner(const Result& r) {
  const auto verdict = verdict_of(r);
  if (!verdict) {
    const std::string count =
        r.errors.size() > 1 ? fmt::format("The deck has {} mistakes", r.errors.size()) : "The deck has a mistake";
    return {.mood = Mood::bad, .icon = icon_of(Mood::bad), .headline = count, .detail = r.message, .scope = {}};
  }
  const Mood mood = mood_of(verdict->kind);
  return {.mood = mood,
          .icon = icon_of(mood),
          .headline = std::string(headline(verdict->kind)),
          .detail = verdict->reason,
          .scope = scope_of(r)};
}

std::string utilisation_text(double u) {
  if (u > 0 && u < 0.001) return "< 0.001";
  constexpr double first_whole = 99.95;
  if (!(u >= 0.001 && u < first_whole)) return number_plain(u, 3);
  return fmt::format("{:#.3g}", u);  // with its zeros: numbers below each other are compared
}

std::string_view outcome_text(const Check& c) { return c.refused ? "refused" : c.passes ? "passes" : "fails"; }

}  // namespace taut::report
