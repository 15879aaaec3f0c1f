#include "taut/report/summary.hpp"

#include <algorithm>
#include <string_view>

#include "taut/calc/answers.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/report/text/symbol.hpp"

namespace taut::report {

namespace {

bool is_worse(const Check& a, const Check& b) {
  const auto rank = [](const Check& c) { return c.refused ? 1 : c.passes ? 0 : 2; };
  return rank(a) != rank(b) ? rank(a) > rank(b) : severity(a) > severity(b);
}

void keep_worst(const Check& c, std::vector<const Check*>& of_parts) {
  const auto same = std::find_if(of_parts.begin(), of_parts.end(),
                                 [&](const Check* other) { return !c.part.empty() && other->part == c.part; });
  if (same == of_parts.end()) {
    of_parts.push_back(&c);
  } else if (is_worse(c, **same)) {
    *same = &c;
  }
}

/// "payload_T_max" -> "payload T_max": what is a symbol stays one.
std::string without_underscores(std::string word) {
  for (std::size_t i = word.find('_'); i != std::string::npos; i = word.find('_', i)) {
    if (looks_like_symbol(std::string_view(word).substr(word.rfind(' ', i) + 1))) break;
    word[i] = ' ';
  }
  return word;
}

}  // namespace

std::vector<const Check*> worst_by_part(const Result& r) {
  std::vector<const Check*> worst, limits;
  for (const Check& c : r.checks) {
    keep_worst(c, worst);
    if (c.limits) keep_worst(c, limits);
  }
  for (const Check* c : limits) {
    if (std::find(worst.begin(), worst.end(), c) != worst.end()) continue;
    const auto shown = std::find_if(worst.begin(), worst.end(), [&](const Check* w) { return w->part == c->part; });
    if (!(*shown)->limits && (*shown)->passes) worst.push_back(c);
  }
  std::stable_sort(worst.begin(), worst.end(), [](const Check* a, const Check* b) { return is_worse(*a, *b); });
  return worst;
}

bool lacks_limit(const Check& c, const Result& r) {
  return !c.part.empty() && std::find(r.unjudged.begin(), r.unjudged.end(), c.part) != r.unjudged.end();
}

std::string name_below_part(const Check& c) {
  if (c.part.empty()) return c.name;
  for (const std::string_view between : {": ", "."}) {
    const std::string before = c.part + std::string(between);
    if (c.name.starts_with(before)) return c.name.substr(before.size());
  }
  return c.name;
}

std::string words_below_part(const Check& c) {
  const std::string name = name_below_part(c);
  std::string words;
  for (std::size_t i = 0; i <= name.size();) {
    const std::size_t end = std::min(name.find(' ', i), name.size());
    words += (i > 0 ? " " : "") + without_underscores(name.substr(i, end - i));
    i = end + 1;
  }
  return words;
}

std::vector<Answer> answers_beside_checks(const Result& r) {
  std::vector<Answer> shown = r.answers;
  if (!r.checks.empty()) std::erase_if(shown, [](const Answer& a) { return a.label == uses_label; });
  return shown;
}

std::vector<std::string> warnings_by_weight(const Result& r) {
  std::vector<std::string> all = r.unsafe;
  for (const std::string& w : r.warnings) {
    if (std::find(r.unsafe.begin(), r.unsafe.end(), w) == r.unsafe.end()) all.push_back(w);
  }
  return all;
}

std::string project_line(const Project& p) {
  std::string line;
  const auto add = [&](std::string_view before, const std::string& text) {
    if (text.empty()) return;
    if (!line.empty()) line += " \u00B7 ";
    line += std::string(before) + text;
  };
  add("", p.project);
  add("no. ", p.number);
  add("calculated by ", p.author);
  add("checked by ", p.checked_by);
  add("", p.date);
  add("revision ", p.revision);
  return line;
}

}  // namespace taut::report
