#include "taut/report/tables/check_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "taut/report/summary.hpp"
#include "taut/report/tables/html_table.hpp"
#include "taut/report/text/symbol.hpp"
#include "taut/report/text/text.hpp"
#include "taut/report/verdict.hpp"

namespace taut::report {
namespace {

constexpr int check_digits = 4;
constexpr int longest_part = 24, longest_name = 52;  ///< on page 1

std::string bar_html(const Check& c) {
  const double part = std::isnan(c.utilisation) ? (c.passes ? 0 : 1) : std::clamp(c.utilisation, 0.0, 1.25) / 1.25;
  return fmt::format(
      "<svg class=\"bar\" width=\"60\" height=\"9\" viewBox=\"0 0 60 9\" aria-hidden=\"true\"><rect class=\"track\" "
      "width=\"60\" height=\"9\"/><rect class=\"{}\" width=\"{:.1f}\" height=\"9\"/><path d=\"M48 0V9\"/></svg>",
      c.passes ? "good" : "bad", 60 * part);
}

/// The first words of a trust: "verified", "unverified".
std::string trust_word(const std::string& trust) {
  return is_unverified(trust) ? "unverified" : trust.substr(0, trust.find(':'));
}

std::string trust_html(const std::string& trust) {
  if (trust.empty()) return {};
  return fmt::format("<span class=\"badge {}\">{}</span>", is_unverified(trust) ? "doubt" : "calm",
                     escape(trust_word(trust)));
}

/// Each rule with its trust once, by number from 1.
struct Rules {
  std::vector<std::pair<std::string, std::string>> all = {};

  /// 0: the check names none.
  std::size_t number_of(const Check& c) {
    if (c.rule.empty()) return 0;
    const auto rule = std::pair(c.rule, c.trust);
    const auto known = std::find(all.begin(), all.end(), rule);
    if (known != all.end()) return static_cast<std::size_t>(known - all.begin()) + 1;
    all.push_back(rule);
    return all.size();
  }
};

/// "unverified: recalled practice" behind a rule; the bare word stands in the table already.
std::string reason_html(const std::string& trust) {
  const std::size_t colon = trust.find(':');
  if (colon == std::string::npos) return {};
  return fmt::format(" <span class=\"reason\">{}{}</span>", escape(trust_word(trust)), prose_html(trust.substr(colon)));
}

std::string rules_html(const Rules& rules) {
  std::string out;
  for (const auto& [rule, trust] : rules.all)
    out += fmt::format("<li>{}{}</li>\n", prose_html(rule), reason_html(trust));
  return out.empty() ? out : fmt::format("<ol class=\"rules\">\n{}</ol>\n", out);
}

std::string check_row(const Check& c, std::size_t rule, const Display& display) {
  const std::string where = c.where.empty() ? "" : fmt::format(" <span class=\"where\">{}</span>", prose_html(c.where));
  return fmt::format("<tr class=\"{}\">", c.passes ? "good" : "bad") + cell(prose_html(words_below_part(c)) + where) +
         cell(escape(value_text(c, display)), "num") + cell(escape(limit_text(c, display)), "num") +
         cell(fmt::format("{} {}", bar_html(c), escape(utilisation_text(c.utilisation))), "util") +
         cell(fmt::format("<b>{}</b>", outcome_text(c)), "out") + cell(trust_html(c.trust)) +
         cell(rule == 0 ? std::string() : std::to_string(rule), "num") + "</tr>\n";
}

/// Behind the name of a check, which has a limit of its own, that its part lacks another one.
std::string lacking_html(const Check& c, const Result& r) {
  return c.passes && lacks_limit(c, r) ? fmt::format(" <span class=\"where\">{}</span>", no_limit_of_part) : "";
}

}  // namespace

std::string value_text(const Check& c, const Display& display) {
  return quantity_shown(c.value, c.unit, display, digits_apart(c, display, check_digits));
}

std::string limit_text(const Check& c, const Display& display) {
  return (c.sense == Sense::at_most ? "≤ " : "≥ ") +
         quantity_shown(c.limit, c.unit, display, digits_apart(c, display, check_digits));
}

std::string checks_html(const Result& r) {
  if (r.checks.empty()) return {};
  const Display display = display_of(r);
  Rules rules;
  std::string rows;
  const std::string* part = nullptr;
  const bool parts = std::any_of(r.checks.begin(), r.checks.end(), [](const Check& c) { return !c.part.empty(); });
  for (const Check& c : r.checks) {
    if (parts && (part == nullptr || *part != c.part)) {
      rows += fmt::format("<tr class=\"part\"><th colspan=\"7\">{}</th></tr>\n",
                          c.part.empty() ? "General" : escape(c.part));
    }
    part = &c.part;
    rows += check_row(c, rules.number_of(c), display);
  }
  return fmt::format(
             "<div class=\"wide\"><table class=\"checks\"><thead><tr><th>check</th><th class=\"num\">value</th><th "
             "class=\"num\">limit</th><th>use</th><th></th><th>limit is</th><th class=\"num\">rule</th></tr></thead>"
             "<tbody>\n{}</tbody></table></div>\n",
             rows) +
         rules_html(rules);
}

std::string worst_checks_html(const Result& r) {
  const Display display = display_of(r);
  std::vector<const Check*> worst = worst_by_part(r);
  if (worst.empty()) return {};
  const std::size_t all = worst.size();
  worst.resize(std::min(all, most_summary_rows));
  std::string rows;
  for (const Check* check : worst) {
    const Check& c = *check;
    rows += fmt::format("<tr class=\"{}\">", c.passes ? "good" : "bad") +
            cell(escape(shortened(clean(c.part), longest_part))) +
            cell(prose_html(shortened(clean(words_below_part(c)), longest_name)) + lacking_html(c, r), "name") +
            cell(escape(value_text(c, display)), "num") + cell(escape(limit_text(c, display)), "num") +
            cell(escape(utilisation_text(c.utilisation)) +
                     (c.passes ? std::string() : fmt::format(" <b>{}</b>", outcome_text(c))),
                 "use") +
            "</tr>\n";
  }
  std::string more;
  if (worst.size() < all)
    more = fmt::format("<p class=\"cut\">{} more parts below, in the checks</p>", all - worst.size());
  return fmt::format(
      "<table class=\"checks worst\"><thead><tr><th>part</th><th>check</th><th class=\"num\">value</th><th "
      "class=\"num\">limit</th><th class=\"use\">use</th></tr></thead><tbody>\n{}</tbody></table>{}\n",
      rows, more);
}

}  // namespace taut::report
