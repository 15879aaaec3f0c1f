#include "taut/report/summary.hpp"

#include <algorithm>
#include <string_view>

#include "taut/calc/verdict.hpp"

namespace taut::report {

namespace {

bool is_worse(const Check& a, const Check& b) {
  const auto rank = [](const Check& c) { return c.refused ? 1 : c.passes ? 0 : 2; };
  return rank(a) != rank(b) ? rank(a) > rank(b) : severity(a) > severity(b);
}

}  // namespace

std::vector<const Check*> worst_by_part(const Result& r) {
  std::vector<const Check*> worst;
  for (const Check& c : r.checks) {
    const auto same = std::find_if(worst.begin(), worst.end(),
                                   [&](const Check* other) { return !c.part.empty() && other->part == c.part; });
    if (same == worst.end()) {
      worst.push_back(&c);
    } else if (is_worse(c, **same)) {
      *same = &c;
    }
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
