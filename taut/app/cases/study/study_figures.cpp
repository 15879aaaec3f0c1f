#include "taut/app/cases/study/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "taut/app/cases/study/study_words.hpp"

namespace taut::app {
namespace {

constexpr std::size_t least_points = 3;  ///< of a curve of convergence
constexpr std::size_t most_dots = 1500;  ///< of a scatter plot: more hide each other

/// The outline of a histogram: the share of the cases in each bin.
Curve outline(const chance::Histogram& h) {
  Curve c{.label = "share of the cases", .x = {}, .y = {}};
  const double all = std::accumulate(h.counts.begin(), h.counts.end(), 0.0,
                                     [](double sum, std::uint64_t n) { return sum + static_cast<double>(n); });
  const auto add = [&](double x, double y) {
    c.x.push_back(x);
    c.y.push_back(y);
  };
  for (std::size_t i = 0; i < h.counts.size(); ++i) {
    const double share = static_cast<double>(h.counts[i]) / all;
    if (i == 0) add(h.edges[0], 0);
    add(h.edges[i], share);
    add(h.edges[i + 1], share);
  }
  if (!h.edges.empty()) add(h.edges.back(), 0);
  return c;
}

void add_histograms(const Study& study, const StudyData& data, Result& r) {
  const std::size_t outputs = study.model.outputs.size();
  for (std::size_t k = 0; k < outputs; ++k) {
    const CaseOutput& output = study.model.outputs[k];
    const chance::Histogram h = chance::histogram(sample_of(study, data, k).values);
    if (h.edges.empty()) continue;
    Plot p{.name = "histogram" + name_ending(k, outputs),
           .title = "Distribution of " + output.name,
           .caption = fmt::format("{} cases; the height is the share of the cases in a bin", study.sample.count),
           .x = {.label = output.name, .unit = output.unit},
           .y = {.label = "share", .unit = si::one},
           .curves = {outline(h)},
           .marks = {}};
    for (const StudyLimit& limit : study.limits) {
      if (limit.output != k) continue;
      const bool least = limit.limit.bound == chance::Bound::at_least;
      if (limit.limit.value < h.edges.front() || limit.limit.value > h.edges.back()) {
        p.caption += fmt::format("; the limit, {} {}, lies outside", least ? "at least" : "at most",
                                 study.display.brief(limit.limit.value, output.unit));
      }
      p.marks.push_back({.x = limit.limit.value,
                         .y = 0,
                         .label = fmt::format("limit, {} {}", least ? "at least" : "at most",
                                              study.display.quantity(limit.limit.value, output.unit)),
                         .whole_line = false,
                         .upright = true});
    }
    r.figures.emplace_back(std::move(p));
  }
}

/// How the probability of a limit settles as the cases get more.
void add_convergence(const Study& study, const StudyData& data, Result& r) {
  for (std::size_t k = 0; k < study.limits.size(); ++k) {
    const StudyLimit& limit = study.limits[k];
    Plot p{.name = "convergence" + name_ending(k, study.limits.size()),
           .title = "Probability of " + beyond_in_words(study, limit),
           .caption = "of the first cases, as their number grows; dashed: its confidence interval",
           .x = {.label = "cases", .unit = si::one},
           .y = {.label = "probability", .unit = si::one},
           .curves = {{.label = "probability", .x = {}, .y = {}},
                      {.label = "lower end", .x = {}, .y = {}, .dashed = true},
                      {.label = "upper end", .x = {}, .y = {}, .dashed = true}},
           .marks = {}};
    for (const auto& one : chance::convergence(sample_of(study, data, limit.output), limit.limit)) {
      const std::array<double, 3> y = {one.counted.value, one.counted.interval.low, one.counted.interval.high};
      for (std::size_t i = 0; i < y.size(); ++i) {
        p.curves[i].x.push_back(static_cast<double>(one.cases));
        p.curves[i].y.push_back(y[i]);
      }
    }
    if (p.curves[0].x.size() < least_points) continue;
    if (limit.allowed) {
      p.marks.push_back({.x = 0, .y = *limit.allowed, .label = "allowed", .whole_line = true, .upright = false});
    }
    r.figures.emplace_back(std::move(p));
  }
}

/// Ranks of the values, 0 and on; equal values have the mean of their ranks, so that their order does not matter.
std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t i = first; i < end; ++i) ranks[order[i]] = static_cast<double>(first + end - 1) / 2;
  }
  return ranks;
}

/// Spearman's correlation of ranks, from -1 to 1; 0 where one of the two is constant. No value is NaN.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const std::vector<double> a = ranks_of(x), b = ranks_of(y);
  const double middle = (static_cast<double>(a.size()) - 1) / 2;
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - middle) * (b[i] - middle);
    aa += (a[i] - middle) * (a[i] - middle);
    bb += (b[i] - middle) * (b[i] - middle);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

/// Each output over the input whose ranks follow its own best.
void add_scatter(const Study& study, const StudyData& data, Result& r) {
  const std::size_t outputs = study.model.outputs.size(), inputs = study.model.inputs.size();
  for (std::size_t k = 0; k < outputs; ++k) {
    std::vector<std::vector<double>> x(inputs);
    std::vector<double> y;
    const std::uint64_t step = std::max<std::uint64_t>(1, (study.sample.count + most_dots - 1) / most_dots);
    for (std::uint64_t i = study.sample.first; i < study.sample.end(); i += step) {
      if (std::isnan(data.outputs[k][i])) continue;
      const chance::Point values = study.values_at(i);
      for (std::size_t j = 0; j < inputs; ++j) x[j].push_back(values[j]);
      y.push_back(data.outputs[k][i]);
    }
    if (y.size() < 2) continue;
    const auto ends = std::minmax_element(y.begin(), y.end());
    const double least = *ends.first;
    if (chance::is_leftover(*ends.second - least, least)) y.assign(y.size(), least);  // it follows no input
    std::size_t most = 0;
    std::vector<double> correlation;
    for (std::size_t j = 0; j < inputs; ++j) {
      correlation.push_back(rank_correlation(x[j], y));
      if (std::abs(correlation[j]) > std::abs(correlation[most])) most = j;
    }
    const CaseOutput& output = study.model.outputs[k];
    r.figures.emplace_back(
        Plot{.name = "scatter" + name_ending(k, outputs),
             .title = fmt::format("{} over {}", output.name, short_name(study, most)),
             .caption = fmt::format("{} of the cases; the input that it follows most, rank correlation {:.2f}",
                                    y.size(), correlation[most]),
             .x = {.label = short_name(study, most), .unit = study.model.inputs[most].unit},
             .y = {.label = output.name, .unit = output.unit},
             .curves = {{.label = "cases", .x = x[most], .y = y, .dashed = false, .points_only = true}},
             .marks = {}});
  }
}

void add_bars_of_indices(const Study& study, const ChanceSummary& chance, Result& r) {
  for (std::size_t k = 0; k < chance.indices.size(); ++k) {
    const chance::Sensitivity& found = chance.indices[k];
    Bars bars{.name = "sobol" + name_ending(k, chance.indices.size()),
              .title = "What moves " + study.model.outputs[k].name,
              .caption =
                  "Sobol indices: the share of the variance from one input alone (first order), and with all its "
                  "interplay with others (total). The thin line is the confidence interval.",
              .value = {.label = "share of the variance", .unit = si::one},
              .series = {"total", "first order"},
              .rows = {}};
    for (std::size_t i = 0; i < found.of.size(); ++i) {
      const auto bar = [](const chance::Estimate& e) {
        return Bars::Bar{.from = 0, .to = e.value, .low = e.interval.low, .high = e.interval.high};
      };
      if (std::isnan(found.of[i].total.value)) continue;
      bars.rows.push_back({.label = short_name(study, i), .bars = {bar(found.of[i].total), bar(found.of[i].first)}});
    }
    std::stable_sort(bars.rows.begin(), bars.rows.end(),
                     [](const auto& a, const auto& b) { return a.bars.front().to > b.bars.front().to; });
    if (!bars.rows.empty()) r.figures.emplace_back(std::move(bars));
  }
}

void add_bars_of_tornado(const Study& study, const StudyData& data, Result& r) {
  if (study.tornado.empty()) return;
  const std::size_t outputs = study.model.outputs.size();
  for (std::size_t k = 0; k < outputs; ++k) {
    const CaseOutput& output = study.model.outputs[k];
    const double* at = data.outputs[k].data() + study.bars.first;
    Bars bars{.name = "tornado_bars" + name_ending(k, outputs),
              .title = "What moves " + output.name,
              .caption = "one input from its 5 % to its 95 % quantile, all others at their medians",
              .value = {.label = output.name, .unit = output.unit},
              .series = {"input at its 5 % quantile", "input at its 95 % quantile"},
              .rows = {},
              .base = at[0],
              .in_line = true};
    for (std::size_t i = 0; i < study.model.inputs.size(); ++i) {
      const auto bar = [&](double to) {
        return Bars::Bar{.from = at[0], .to = to, .low = std::nan(""), .high = std::nan("")};
      };
      bars.rows.push_back({.label = short_name(study, i), .bars = {bar(at[1 + 2 * i]), bar(at[2 + 2 * i])}});
    }
    if (std::isnan(at[0])) continue;  // nothing to go from
    const bool moves = std::any_of(bars.rows.begin(), bars.rows.end(), [&](const Bars::Row& row) {
      return !chance::is_leftover(row.bars[1].to - row.bars[0].to, at[0]);
    });
    if (!moves) continue;
    const auto width = [](const Bars::Row& row) {
      const double x = std::abs(row.bars[1].to - row.bars[0].to);
      return std::isnan(x) ? -1 : x;
    };
    std::stable_sort(bars.rows.begin(), bars.rows.end(),
                     [&](const auto& a, const auto& b) { return width(a) > width(b); });
    r.figures.emplace_back(std::move(bars));
  }
}

/// Each output over the only input of a grid.
void add_grid_curves(const Study& study, const StudyData& data, Result& r) {
  if (study.model.inputs.size() != 1) return;
  const std::size_t outputs = study.model.outputs.size();
  std::vector<double> x;
  x.reserve(study.size());
  for (std::uint64_t i = 0; i < study.size(); ++i) x.push_back(study.values_at(i)[0]);
  for (std::size_t k = 0; k < outputs; ++k) {
    const CaseOutput& output = study.model.outputs[k];
    r.figures.emplace_back(Plot{.name = "grid" + name_ending(k, outputs),
                                .title = fmt::format("{} over {}", output.name, short_name(study, 0)),
                                .caption = "",
                                .x = {.label = short_name(study, 0), .unit = study.model.inputs[0].unit},
                                .y = {.label = output.name, .unit = output.unit},
                                .curves = {{.label = output.name, .x = x, .y = data.outputs[k]}},
                                .marks = {}});
  }
}

}  // namespace

void add_study_figures(const Study& study, const StudyData& data, const ChanceSummary& chance, Result& r) {
  if (!study.points) {
    add_grid_curves(study, data, r);
    return;
  }
  add_histograms(study, data, r);
  add_bars_of_indices(study, chance, r);
  add_bars_of_tornado(study, data, r);
  add_convergence(study, data, r);
  add_scatter(study, data, r);
}

}  // namespace taut::app
