#include "taut/app/cases/study/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/app/cases/read_cases.hpp"
#include "taut/app/cases/study/calibrated_deck.hpp"
#include "taut/app/cases/study/measured.hpp"
#include "taut/app/cases/study/study_run.hpp"
#include "taut/calc/shown.hpp"
#include "taut/chance/calibration.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/source.hpp"
#include "taut/io/file.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/parse.hpp"

namespace taut::app {
namespace {

/// A calibration, read.
struct Calibrating {
  ReadCases read;
  MeasuredTable table;
  CaseModel model;  ///< inputs: the free ones, then the settings
  Measurements measured;
  std::vector<chance::FreeParameter> free;
};

/// The bounds of each free number, and the deck's own value as the first start.
std::vector<chance::FreeParameter> free_parameters(const CalibrateRequest& request, const CaseModel& model,
                                                   std::vector<Complaint>& complaints) {
  std::vector<chance::FreeParameter> free;
  for (std::size_t i = 0; i < request.free.size(); ++i) {
    const FreeRequest& one = request.free[i];
    const std::string path = "calibrate.free." + one.name;
    chance::FreeParameter p{.name = one.name, .low = 0, .high = 1};
    if (one.range.size() != 2) {
      complaints.push_back({path, "two values are expected, [least, largest]"});
      continue;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const auto x = parse_quantity(one.range[k], model.inputs[i].unit);
      if (!x) complaints.push_back({fmt::format("{}[{}]", path, k), x.error().message});
      (k == 0 ? p.low : p.high) = x.value_or(static_cast<double>(k));
    }
    if (model.inputs[i].base > p.low && model.inputs[i].base < p.high) p.start = model.inputs[i].base;
    free.push_back(std::move(p));
  }
  return free;
}

CaseQuestion question_of(const CalibrateRequest& request, const MeasuredTable& table) {
  CaseQuestion q;
  for (const FreeRequest& one : request.free) q.inputs.push_back({one.name, "calibrate.free." + one.name});
  for (const std::string& path : table.paths) q.inputs.push_back({path, "calibrate.measured.file"});
  for (const std::string& name : table.outputs) q.outputs.push_back({name, "calibrate.measured.file"});
  return q;
}

MeasuredTable read_table(const ReadCases& read, Diagnostics& mistakes) {
  const io::Found at = io::follow(read.blocks(), "calibrate.measured.file");
  const auto file = io::read_named(*at.node, read.calibrate->measured.file, mistakes);
  return file ? read_measured(file->text, file->path, mistakes) : MeasuredTable{};
}

tl::expected<Calibrating, Result> read_calibration(const Job& job) {
  auto read = read_cases(job);
  if (!read) return tl::unexpected(std::move(read.error()));
  Calibrating c{.read = std::move(*read), .table = {}, .model = {}, .measured = {}, .free = {}};
  const io::Node& blocks = c.read.blocks();
  Diagnostics mistakes;
  if (!c.read.calibrate) {
    io::add(mistakes, c.read.deck.input.spot,
            "the deck has no 'calibrate': a map that says which numbers are sought ('free') and what was 'measured'");
    return tl::unexpected(bad_deck(std::move(mistakes)));
  }
  const CalibrateRequest& request = *c.read.calibrate;
  c.table = read_table(c.read, mistakes);
  if (!mistakes.empty()) return tl::unexpected(bad_deck(std::move(mistakes)));
  auto model = c.read.cases(question_of(request, c.table));
  if (!model) return tl::unexpected(refusal(model.error(), blocks));
  c.model = std::move(*model);
  c.measured = in_si(c.table, c.model, request.free.size(), mistakes);
  if (!mistakes.empty()) return tl::unexpected(bad_deck(std::move(mistakes)));
  NoCases wrong;
  c.free = free_parameters(request, c.model, wrong.complaints);
  if (wrong.complaints.empty()) {
    const std::string why = chance::mistake(c.free, {.values = c.measured.values, .sd = c.measured.sd});
    if (!why.empty()) wrong.complaints.push_back({"calibrate", why});
  }
  if (!wrong.complaints.empty()) return tl::unexpected(refusal(wrong, blocks));
  return c;
}

/// Each point of the free numbers gives one row: the measured outputs, each in its own state.
chance::Evaluate measured_outputs(const Calibrating& c, int threads, CaseCounter& counter) {
  return [&c, run = parallel(c.model, threads, &counter)](std::span<const chance::Point> points) {
    std::vector<chance::Point> cases;
    for (const chance::Point& p : points) {
      for (const auto& state : c.measured.states) {
        cases.push_back(p);
        cases.back().insert(cases.back().end(), state.begin(), state.end());
      }
    }
    const auto outputs = run(cases);
    std::vector<std::vector<double>> rows(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t m = 0; m < c.measured.values.size(); ++m) {
        rows[i].push_back(outputs[i * c.measured.states.size() + c.measured.state[m]][c.measured.output[m]]);
      }
    }
    return rows;
  };
}

/// "loads.w.force[2] -900 kN, temperature 20 degC": the settings of a state.
std::string state_in_words(const Calibrating& c, std::size_t state) {
  const Display& display = c.read.deck.display;
  const std::vector<double>& settings = c.measured.states[state];
  std::string words;
  for (std::size_t k = 0; k < settings.size(); ++k) {
    const CaseInput& input = c.model.inputs[c.free.size() + k];
    words += fmt::format("{}{} {}", k > 0 ? ", " : "", input.path, display.brief(settings[k], input.unit));
  }
  return words;
}

/// Which measurements have no answer where the search begins, the first with its reason; empty: all have one.
std::string failed_at_start(const Calibrating& c) {
  chance::Point start;
  for (const chance::FreeParameter& p : c.free) start.push_back(p.start.value_or(p.low + 0.5 * (p.high - p.low)));
  std::vector<std::string> why;  // by state; empty: it has an answer
  for (const auto& state : c.measured.states) {
    chance::Point values = start;
    values.insert(values.end(), state.begin(), state.end());
    const Outcome outcome = c.model.answer(values).outcome;
    why.push_back(outcome.ok() ? std::string{} : outcome.message);
  }
  std::size_t failed = 0, first = 0;
  for (std::size_t m = 0; m < c.measured.values.size(); ++m) {
    if (why[c.measured.state[m]].empty()) continue;
    if (failed++ == 0) first = m;
  }
  if (failed == 0) return {};
  const std::string words = state_in_words(c, c.measured.state[first]);
  return fmt::format("{} of {} measurements have no answer at the first start, the first is measurement {}{}: {}",
                     failed, c.measured.values.size(), first + 1, words.empty() ? "" : fmt::format(" ({})", words),
                     why[c.measured.state[first]]);
}

/// About so many cases a calibration takes, for its progress: each step needs its point and two for each difference.
std::uint64_t usual_cases(const Calibrating& c, const chance::CalibrationOptions& options) {
  constexpr std::uint64_t usual_steps = 10;
  return options.starts * usual_steps * (2 * c.free.size() + 1) * c.measured.states.size();
}

const char* words_of(chance::ParameterState state) {
  switch (state) {
    case chance::ParameterState::estimated:
      return "estimated";
    case chance::ParameterState::at_low:
      return "at its lower bound";
    case chance::ParameterState::at_high:
      return "at its upper bound";
    case chance::ParameterState::not_identifiable:
      return "not identifiable";
  }
  return "";
}

/// A number found, and its standard error, where there are such.
void add_values(const CaseInput& input, const chance::CalibratedParameter& p, Result& r) {
  if (p.state != chance::ParameterState::not_identifiable) {
    r.values.push_back({input.path, p.value, input.unit, "", fmt::format("{}, {}", input.path, words_of(p.state)), {}});
  }
  if (!std::isfinite(p.standard_error)) return;
  r.values.push_back({input.path + ".standard_error",
                      p.standard_error,
                      difference_of(input.unit),
                      "",
                      "standard error of " + input.path,
                      {},
                      true});
}

void add_parameters(const Calibrating& c, const chance::Calibration& found, Result& r) {
  const Display& display = c.read.deck.display;
  Table t{.name = "calibrated", .title = "The numbers found", .columns = {}, .rows = {}};
  for (const char* name : {"number", "in the deck", "found", "low", "high", "state", "note"}) {
    t.columns.push_back({.name = name, .unit = si::one});
  }
  for (std::size_t i = 0; i < found.parameters.size(); ++i) {
    const chance::CalibratedParameter& p = found.parameters[i];
    const CaseInput& input = c.model.inputs[i];
    const auto shown = [&](double x) { return display.brief(x, input.unit); };
    const bool told = p.state != chance::ParameterState::not_identifiable;
    // without a standard error the ends are the bounds of the deck: they tell of what is not told, and of no other
    const bool has_interval = std::isfinite(p.standard_error);
    const auto [low, high] = brief_apart(p.interval.low, p.interval.high, input.unit, display);
    const auto apart = [&](double x) { return brief_apart(p.value, x, input.unit, display).first; };
    const std::string below = apart(p.interval.low), above = apart(p.interval.high);
    const std::string value = !has_interval ? shown(p.value) : below.size() > above.size() ? below : above;
    const auto end = [&](const std::string& x) { return told && !has_interval ? std::string("-") : x; };
    t.rows.push_back({input.path, shown(input.base), told ? value : std::string("-"), end(low), end(high),
                      std::string(words_of(p.state)), p.note});
    add_values(input, p, r);
    if (p.state != chance::ParameterState::estimated) {
      warn_unsafe(r, fmt::format("{}: {}{}{}", input.path, words_of(p.state), p.note.empty() ? "" : ": ", p.note));
    }
    const std::string range = fmt::format("({} to {})", low, high);
    if (told) {
      const std::string how_sure = has_interval ? range
                                   : p.state == chance::ParameterState::estimated
                                       ? std::string("(no interval)")
                                       : fmt::format("({}, no interval)", words_of(p.state));
      r.answers.push_back({"Found", fmt::format("{} {} {}", input.path, value, how_sure)});
    } else {
      r.answers.push_back({"Not told", fmt::format("{}: anything in its bounds {}", input.path, range)});
    }
  }
  r.tables.push_back(std::move(t));
}

void add_residuals(const Calibrating& c, const chance::Calibration& found, Result& r) {
  const Display& display = c.read.deck.display;
  Table t{.name = "residuals",
          .title = "What was measured, and the deck with the numbers found",
          .columns = {},
          .rows = {}};
  for (const char* name : {"measurement", "output", "state", "measured", "calculated", "difference", "difference/sd"}) {
    t.columns.push_back({.name = name, .unit = si::one});
  }
  Plot plot{.name = "residuals_plot",
            .title = "Residuals",
            .caption = "measured less calculated, over the standard deviation; about 95 % lie within 2",
            .x = {.label = "measurement", .unit = si::one},
            .y = {.label = "difference/sd", .unit = si::one},
            .curves = {{.label = "difference/sd", .x = {}, .y = {}, .dashed = false, .points_only = true}},
            .marks = {{.x = 0, .y = 2, .label = "", .whole_line = true, .upright = false},
                      {.x = 0, .y = -2, .label = "", .whole_line = true, .upright = false}}};
  for (std::size_t m = 0; m < c.measured.values.size(); ++m) {
    const CaseOutput& output = c.model.outputs[c.measured.output[m]];
    const double sd = c.measured.sd.empty() ? found.sd : c.measured.sd[m];
    t.rows.push_back({static_cast<double>(m + 1), output.name, state_in_words(c, c.measured.state[m]),
                      display.brief(c.measured.values[m], output.unit), display.brief(found.model[m], output.unit),
                      display.brief(found.residuals[m], difference_of(output.unit)), found.residuals[m] / sd});
    plot.curves[0].x.push_back(static_cast<double>(m + 1));
    plot.curves[0].y.push_back(found.residuals[m] / sd);
  }
  r.tables.push_back(std::move(t));
  r.figures.emplace_back(std::move(plot));
}

constexpr double doubtful = 0.01;  ///< chance of a fit that is no better

bool fits(const chance::Calibration& found) { return !(found.p_value < doubtful); }

/// Why a study cannot go on from the numbers found; empty: it can.
std::string why_no_deck(const Calibrating& c, const chance::Calibration& found) {
  constexpr int least_freedom = 3;  // below, Student's law has no standard deviation
  const bool all_told = std::all_of(found.parameters.begin(), found.parameters.end(), [](const auto& p) {
    return p.state == chance::ParameterState::estimated && p.standard_error > 0;
  });
  if (!all_told) return "a study on it would take numbers that the measurements do not tell as exact";
  if (!fits(found)) return "the numbers are less sure than the standard deviations of the measurements let them seem";
  if (!found.other_fits.empty()) return "the measurements do not choose among the fits";
  if (c.measured.sd.empty() && found.freedom < least_freedom) {
    return fmt::format(
        "{} measurements more than numbers tell no standard deviation: give that of the measurements, "
        "or {} more of these",
        found.freedom, least_freedom - found.freedom);
  }
  return "";
}

/// "machine.points.q[0] = -6 m".
std::string words_of_fit(const Calibrating& c, const chance::Point& fit, const Display& display) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < fit.size(); ++i) {
    all.push_back(fmt::format("{} = {}", c.model.inputs[i].path, display.brief(fit[i], c.model.inputs[i].unit)));
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

void add_fit(const Calibrating& c, const chance::Calibration& found, Result& r) {
  const Display& display = c.read.deck.display;
  for (const chance::Inseparable& one : found.inseparable) {
    std::vector<std::string> names;
    names.reserve(one.parameters.size());
    for (const std::size_t i : one.parameters) names.push_back(c.model.inputs[i].path);
    warn_unsafe(r, fmt::format("the measurements can't tell these apart: {} (correlation {:.4g})",
                               fmt::join(names, ", "), one.correlation));
  }
  if (!fits(found)) {
    warn_unsafe(r,
                fmt::format("the deck does not fit the measurements within their standard deviations (chance {:.2g})",
                            found.p_value));
  }
  for (const chance::Point& other : found.other_fits) {
    warn_unsafe(r, fmt::format("another fit is as good, {}: the measurements do not choose between them",
                               words_of_fit(c, other, display)));
  }
  r.assumptions.push_back(c.measured.sd.empty()
                              ? fmt::format("one standard deviation for all measurements, estimated from {} residuals",
                                            found.residuals.size())
                              : std::string("standard deviations as given, errors independent and normal"));
  r.assumptions.emplace_back("intervals of the model linearised at the fit");
  if (!c.measured.sd.empty()) {
    r.values.push_back(
        {"chi_squared", found.chi_squared, si::one, "chi^2", "sum of squares of difference/sd", {}, true});
  } else if (std::isfinite(found.sd)) {
    // without sd all measurements are of one kind (in_si)
    const Unit unit = difference_of(c.model.outputs[c.measured.output.front()].unit);
    r.values.push_back(
        {"sd", found.sd, unit, "s", "standard deviation of the measurements by their residuals", {}, true});
  }
  r.values.push_back(
      {"freedom", static_cast<double>(found.freedom), si::one, "", "measurements less numbers found", {}, true});
  Table t{.name = "covariance",
          .title = "Covariance of the numbers found, SI",
          .columns = {},
          .rows = {},
          .long_rows = nullptr,
          .detail = true};
  t.columns.push_back({.name = "number", .unit = si::one});
  const std::size_t n = found.parameters.size();
  for (std::size_t i = 0; i < n; ++i) t.columns.push_back({.name = c.model.inputs[i].path, .unit = si::one});
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Cell> row = {c.model.inputs[i].path};
    for (std::size_t k = 0; k < n; ++k) row.emplace_back(found.covariance[i * n + k]);
    t.rows.push_back(std::move(row));
  }
  r.tables.push_back(std::move(t));
}

}  // namespace

Diagnostics check_calibration(const ReadCases& read) {
  Diagnostics mistakes;
  if (!read.calibrate) return mistakes;
  const MeasuredTable table = read_table(read, mistakes);
  const auto model = read.cases({.inputs = question_of(*read.calibrate, table).inputs, .outputs = {}});
  NoCases wrong = model ? NoCases{} : model.error();
  if (model) {
    const auto free = free_parameters(*read.calibrate, *model, wrong.complaints);
    // of the bounds alone: what was measured is in the units of outputs
    const std::string why = wrong.complaints.empty() ? chance::mistake(free, {.values = {0}, .sd = {}}) : std::string{};
    if (!why.empty()) wrong.complaints.push_back({"calibrate", why});
  }
  io::place(read.blocks(), wrong.complaints, mistakes);
  return mistakes;
}

Result calibrate(const Job& job, int threads) {
  const auto c = read_calibration(job);
  if (!c) return c.error();
  const CalibrateRequest& request = *c->read.calibrate;
  Result r;
  r.title = c->read.deck.title.empty() ? "Calibration" : c->read.deck.title;
  r.method = c->read.deck.is_machine ? "machine" : c->read.deck.method;
  r.method_title = "Calibration against measurements";
  r.project = c->read.deck.project;
  r.display = c->read.deck.display.units();
  r.deck_name = job.name;
  r.deck_hash = c->read.hash;
  r.overrides = job.set;
  chance::CalibrationOptions options;
  options.confidence = request.confidence;
  options.seed = static_cast<std::uint64_t>(request.seed);
  CaseCounter counter("calibration", usual_cases(*c, options), false, job.progress);
  const chance::Calibration found = chance::calibrate(measured_outputs(*c, threads, counter), c->free,
                                                      {.values = c->measured.values, .sd = c->measured.sd}, options);
  if (counter.ended()) {
    r.status = Status::not_converged;
    r.interrupted = true;
    r.message = "the calibration was interrupted before it had found its numbers";
    return r;
  }
  if (found.status != chance::CalibrationStatus::found) {
    r.status = Status::not_converged;
    r.message = found.reason;
    if (const std::string failed = failed_at_start(*c); !failed.empty()) {
      r.message += fmt::format(". {} ({})", failed, c->table.file);
    }
    return r;
  }
  add_parameters(*c, found, r);
  add_residuals(*c, found, r);
  add_fit(*c, found, r);
  if (const std::string why = why_no_deck(*c, found); why.empty()) {
    r.attachments.push_back({"calibrated.yaml", calibrated_deck(c->read, c->model, c->free, found)});
  } else {
    r.warnings.push_back("calibrated.yaml is not written: " + why);
  }
  return r;
}

}  // namespace taut::app
