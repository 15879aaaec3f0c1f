#include "taut/report/page_plan.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "taut/report/figure/any_figure.hpp"
#include "taut/report/pictures.hpp"
#include "taut/report/tables/inputs.hpp"
#include "taut/report/text/text.hpp"

namespace taut::report {
namespace {

// Sizes in print, mm.
constexpr double page_height = 250;
constexpr double heading_height = 15;
constexpr double row_height = 4.9;
constexpr double line_height = 4.6;
constexpr double table_frame = 15;
constexpr double picture_height = 104;
constexpr int line_characters = 115;

double print_lines_of(int characters, int room = line_characters) {
  return std::max(1.0, std::ceil(static_cast<double>(characters) / room));
}

double size_of(const std::vector<std::string>& paragraphs) {
  double size = paragraphs.empty() ? 0 : heading_height;
  for (const std::string& p : paragraphs) size += line_height * print_lines_of(length(p));
  return size;
}

double size_of_inputs(const Result& r) {
  const Display display = display_of(r);
  double size = heading_height + row_height * static_cast<double>(single_inputs(r.given, false).size());
  for (const InputTable& t : input_tables(r.given, display)) {
    size += table_frame;
    for (const auto& cells : t.rows) {
      int characters = 0;
      for (const InputCell& c : cells) characters += length(c.text);
      size += row_height + 3.6 * (print_lines_of(characters) - 1);
    }
  }
  return size;
}

double size_of_checks(const Result& r) {
  if (r.checks.empty()) return 0;
  constexpr int rule_characters = 130;
  constexpr double rule_line = 3.7;
  double size = heading_height + table_frame;
  std::set<std::string_view> rules, parts;
  for (const Check& c : r.checks) {
    size += row_height;
    if (parts.insert(c.part).second) size += row_height;
    if (rules.insert(c.rule).second)
      size += rule_line * print_lines_of(length(c.rule) + length(c.trust), rule_characters);
  }
  return size;
}

double size_of_steps(const Result& r) {
  constexpr double equation = 16, note = 2;
  double size = r.steps.empty() ? 0 : heading_height;
  for (const Step& s : r.steps) {
    if (s.kind == Step::Kind::heading) size += 10;
    if (s.kind == Step::Kind::note) size += note + line_height * print_lines_of(length(s.words));
    if (s.kind == Step::Kind::equation || s.kind == Step::Kind::root) size += equation;
  }
  return size;
}

int pages_of(const Result& r) {
  const bool design = std::any_of(r.given.begin(), r.given.end(),
                                  [](const Given& g) { return g.key.starts_with("design.") || g.chosen; });
  constexpr int design_pages = 12, machine_pages = 10, method_pages = 8;
  return design ? design_pages : r.method == "machine" ? machine_pages : method_pages;
}

/// What is left for values, tables and pictures.
double room_of(const Result& r) {
  const double comparisons =
      r.comparisons.empty() ? 0 : heading_height + 1.4 * row_height * static_cast<double>(r.comparisons.size());
  const double used = size_of(r.warnings) + size_of(r.assumptions) + size_of_inputs(r) + size_of_checks(r) +
                      size_of_steps(r) + comparisons;
  constexpr double broken_pages = 140;  ///< left empty where a picture or a table goes to the next page
  return (pages_of(r) - 1) * page_height - broken_pages - used;
}

/// Puts the first values among the results, as many as `room` holds, a dozen at least, one page at most; the height
/// they take.
double place_values(const Result& r, double room, PagePlan& plan) {
  constexpr double least = 12, largest = 45;
  const double most = std::clamp((room - heading_height - table_frame) / row_height, least, largest);
  for (const Value& v : r.values) {
    const bool fits = !v.detail && static_cast<double>(plan.values.size()) < most;
    (fits ? plan.values : plan.appendix_values).push_back(&v);
  }
  if (plan.values.empty()) return 0;
  return heading_height + table_frame + row_height * static_cast<double>(plan.values.size());
}

/// A turned figure has a page of its own, the last of the pictures: that of page 1 once more, as large as a page.
double place_turned(const std::vector<const Figure*>& shown, const std::vector<const Figure*>& all, PagePlan& plan) {
  double used = 0;
  for (const Figure* f : all) {
    if (!is_turned(*f)) continue;
    const bool on_page_one = std::find(shown.begin(), shown.end(), f) != shown.end();
    (on_page_one ? plan.pictures : plan.appendix_pictures).push_back(f);
    if (on_page_one) used += page_height;
  }
  return used;
}

/// The height that the pictures among the results take, mm. `room`: for all of them.
double place_pictures(const Result& r, const std::vector<const Figure*>& shown, double room, PagePlan& plan) {
  const std::vector<const Figure*> all = figures_in_order(r);
  PagePlan turned;
  double used = place_turned(shown, all, turned);
  for (const Figure* f : all) {
    const bool on_page_one = std::find(shown.begin(), shown.end(), f) != shown.end();
    if (is_turned(*f) || (on_page_one && !std::holds_alternative<Animation>(*f))) continue;
    const bool fits = used + picture_height <= room || plan.pictures.empty();
    if (fits) used += picture_height;
    (fits ? plan.pictures : plan.appendix_pictures).push_back(f);
  }
  plan.pictures.insert(plan.pictures.end(), turned.pictures.begin(), turned.pictures.end());
  plan.appendix_pictures.insert(plan.appendix_pictures.end(), turned.appendix_pictures.begin(),
                                turned.appendix_pictures.end());
  return used;
}

void place_tables(const Result& r, double room, PagePlan& plan) {
  double left = room;
  for (const Table& t : r.tables) {
    if (t.rows.empty() || t.columns.empty() || (t.name == "comparison" && !r.comparisons.empty())) continue;
    const Table shown = without_detail(t);
    const bool narrowed = shown.columns.size() < t.columns.size();
    const double size = printed_height(shown, plan.limits);
    const bool fits = !t.detail && !shown.columns.empty() && size <= left;
    if (fits) {
      left -= size;
      plan.tables.push_back(&t);
    }
    if (!fits || narrowed || size < printed_height(t, plan.appendix_limits)) plan.appendix_tables.push_back(&t);
  }
}

}  // namespace

PagePlan plan_pages(const Result& r, const std::vector<const Figure*>& shown) {
  constexpr TableLimits among_results{.rows = 14, .parts = 2};
  constexpr TableLimits in_appendix{.rows = 60};
  PagePlan plan{.values = {},
                .tables = {},
                .pictures = {},
                .appendix_values = {},
                .appendix_tables = {},
                .appendix_pictures = {},
                .limits = among_results,
                .appendix_limits = in_appendix};
  if (r.method == "compare") {
    plan.limits = {};
    place_values(r, HUGE_VAL, plan);
    place_tables(r, HUGE_VAL, plan);
    place_pictures(r, shown, HUGE_VAL, plan);
    return plan;
  }
  constexpr double share_of_values = 0.4, share_of_pictures = 0.6;
  double room = std::max(0.0, room_of(r));
  room = std::max(0.0, room - place_values(r, share_of_values * room, plan));
  const double pictures = place_pictures(r, shown, share_of_pictures * room, plan);
  place_tables(r, room - pictures, plan);
  return plan;
}

std::vector<ResultGroup> groups_of(const PagePlan& plan) {
  std::vector<ResultGroup> all(1);
  const auto group = [&](const std::string& heading) -> ResultGroup& {
    const auto known = std::find_if(all.begin(), all.end(), [&](const ResultGroup& g) { return g.heading == heading; });
    return known != all.end() ? *known : all.emplace_back(ResultGroup{.heading = heading, .values = {}, .tables = {}});
  };
  for (const Value* v : plan.values) group(v->heading).values.push_back(v);
  for (const Table* t : plan.tables) group(t->heading).tables.push_back(t);
  return all;
}

}  // namespace taut::report
