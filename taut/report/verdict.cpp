#include "taut/report/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

#include "taut/report/quantity.hpp"

namespace taut::report {
namespace {

std::string plural(std::size_t n, std::string_view word) { return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s"); }

/// NaN is worse than any number.
double severity(const Check& c) { return std::isnan(c.utilisation) ? INFINITY : c.utilisation; }

std::string named(const Check& c) {
  return fmt::format("{} (utilisation {})", c.name, utilisation_text(c.utilisation));
}

std::string unverified_words(const Result& r) {
  const auto n = std::count_if(r.checks.begin(), r.checks.end(), [](const Check& c) { return is_unverified(c.trust); });
  if (n == 0) return {};
  return fmt::format("{} on an unverified limit.", n == 1 ? "1 check rests" : fmt::format("{} checks rest", n));
}

Verdict failing(const Result& r, std::vector<Check> failed) {
  std::stable_sort(failed.begin(), failed.end(), [](auto& a, auto& b) { return severity(a) > severity(b); });
  constexpr std::size_t most = 3;
  std::string names;
  for (std::size_t i = 0; i < std::min(most, failed.size()); ++i) {
    if (i > 0) names += ", ";
    names += named(failed[i]);
  }
  if (failed.size() > most) names += fmt::format(" and {} more", failed.size() - most);
  return {Mood::bad, fmt::format("Fails {} of {}", failed.size(), plural(r.checks.size(), "check")), names + "."};
}

Verdict computed(const Result& r) {
  if (r.checks.empty()) return {Mood::neutral, "Computed", "Nothing is checked against a limit here."};
  std::vector<Check> failed;
  std::copy_if(r.checks.begin(), r.checks.end(), std::back_inserter(failed), [](const Check& c) { return !c.passes; });
  if (!failed.empty()) return failing(r, std::move(failed));
  const auto top =
      std::max_element(r.checks.begin(), r.checks.end(), [](auto& a, auto& b) { return severity(a) < severity(b); });
  if (r.checks.size() == 1) return {Mood::good, "Passes its check", named(*top) + "."};
  return {Mood::good, fmt::format("Passes all {} checks", r.checks.size()),
          fmt::format("Closest to its limit: {}.", named(*top))};
}

}  // namespace

bool is_unverified(std::string_view trust) {
  constexpr std::string_view word = "unverified";
  return trust.size() >= word.size() && std::equal(word.begin(), word.end(), trust.begin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

std::string utilisation_text(double u) {
  if (u > 0 && u < 0.001) return "< 0.001";
  return number_plain(u, 3);
}

std::string_view outcome_text(const Check& c) { return c.passes ? "passes" : "fails"; }

Verdict verdict(const Result& r) {
  switch (r.status) {
    case Status::infeasible:
      return {Mood::bad, "Not feasible", r.message};
    case Status::not_converged:
      return {Mood::bad, "No solution found", r.message};
    case Status::bad_deck:
      return {Mood::bad,
              r.errors.empty() ? "The deck has a mistake"
                               : fmt::format("The deck has {}", plural(r.errors.size(), "mistake")),
              r.message};
    case Status::ok:
      break;
  }
  Verdict v = computed(r);
  const std::string more = unverified_words(r);
  if (!more.empty()) v.detail += (v.detail.empty() ? "" : " ") + more;
  if (!r.message.empty()) v.detail += (v.detail.empty() ? "" : " ") + r.message;
  return v;
}

}  // namespace taut::report
