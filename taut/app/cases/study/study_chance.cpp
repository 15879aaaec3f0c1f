#include "taut/app/cases/study/study_chance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/app/cases/study/study_run.hpp"
#include "taut/app/cases/study/study_words.hpp"
#include "taut/chance/reliability/importance.hpp"
#include "taut/chance/standard_laws.hpp"
#include "taut/units/any_quantity.hpp"

namespace taut::app {
namespace {

using chance::Estimate;

std::span<const double> part_of(const std::vector<double>& all, const CaseBlock& block) {
  return std::span(all).subspan(block.first, block.count);
}

/// How probable it is that one limit is not kept, from all that was asked.
struct LimitAnswer {
  chance::LimitProbability sampled;
  std::optional<chance::Form> form;
  std::optional<chance::ImportanceSampling> importance;
  bool interrupted = false;  ///< before both had ended: they have no numbers

  /// Importance sampling has a number.
  bool weighted() const { return importance && importance->status == chance::ImportanceStatus::found; }
  /// The sample of the study, with the cases that importance sampling has added for its check.
  const chance::LimitProbability& plain() const {
    return importance && importance->plain ? *importance->plain : sampled;
  }
  /// The one that decides, failed cases counted as beyond: of importance sampling where there is one.
  Estimate decisive(double confidence) const {
    if (!weighted()) return plain().counted;
    const chance::Weighted& w = importance->counted;
    const double q = chance::normal_score((1 + confidence) / 2);
    return {.value = w.value,
            .interval = {.low = std::max(0.0, w.value - q * w.standard_error),
                         .high = std::min(1.0, w.value + q * w.standard_error)}};
  }
};

/// FORM, and what goes on from its design points. Not ok: the limit state has no answer.
Outcome add_reliability(const Study& study, const StudyLimit& limit, const StudyOptions& options, LimitAnswer& answer) {
  chance::ImportanceOptions sampling;
  CaseCounter counter("FORM and importance sampling", sampling.most_samples + sampling.plain_samples, false,
                      options.progress);
  const chance::LimitState state(study.inputs, parallel(study.model, options.threads, &counter), limit.output,
                                 limit.limit);
  const auto seed = static_cast<std::uint64_t>(study.request.seed);
  chance::FormOptions search;
  search.seed = seed;
  answer.form = chance::form(state, search);
  answer.interrupted = counter.ended();
  if (answer.interrupted) return {};
  if (answer.form->status != chance::FormStatus::found) {
    return not_converged(fmt::format("FORM of '{}': {}", beyond_in_words(study, limit), answer.form->reason));
  }
  // Breitung's and FORM's numbers are asymptotic: a sample around the design points always stands beside them
  sampling.seed = seed;
  sampling.confidence = study.request.confidence;
  answer.importance = chance::importance_sampling(state, *answer.form, sampling, answer.sampled);
  answer.interrupted = counter.ended();
  if (answer.interrupted) return {};
  if (answer.importance->status != chance::ImportanceStatus::found) {
    return not_converged(
        fmt::format("importance sampling of '{}': {}", beyond_in_words(study, limit), answer.importance->reason));
  }
  return {};
}

/// The points of the limit nearest to the medians: one table for each, its inputs as rows.
void add_design_points(const Study& study, std::size_t k, const chance::Form& form, Result& r) {
  const std::string end = name_ending(k, study.limits.size());
  const std::string words = beyond_in_words(study, study.limits[k]);
  for (std::size_t p = 0; p < form.points.size(); ++p) {
    const chance::DesignPoint& one = form.points[p];
    const std::string sorm =
        std::isfinite(one.breitung) ? ", SORM " + probability_in_words(one.breitung) : std::string{};
    Table t{.name = fmt::format("design_point{}{}", end, name_ending(p, form.points.size())),
            .title = fmt::format("A most likely failure, {}: beta {:.4g}, FORM {}{}", words, one.beta,
                                 probability_in_words(one.probability), sorm),
            .columns = {{.name = "input", .unit = si::one},
                        {.name = "value", .unit = si::one},
                        {.name = "in the deck", .unit = si::one},
                        {.name = "importance", .unit = si::one}},
            .rows = {}};
    for (std::size_t i = 0; i < study.model.inputs.size(); ++i) {
      const CaseInput& input = study.model.inputs[i];
      t.rows.push_back({short_name(study, i), study.display.brief(one.values[i], input.unit),
                        study.display.brief(input.base, input.unit), one.importance[i]});
    }
    r.tables.push_back(std::move(t));
  }
  const chance::DesignPoint& first = form.points.front();
  r.values.push_back({"beta" + end, first.beta, si::one, "beta", "reliability index of " + words, {}});
  r.values.push_back({"p_form" + end, first.probability, si::one, "p_FORM", "FORM: probability of " + words, {}});
  if (study.asks("sorm")) {
    r.values.push_back(
        {"p_sorm" + end, first.breitung, si::one, "p_SORM", "SORM (Breitung): probability of " + words, {}});
  }
  r.answers.push_back({"Most likely failure",
                       fmt::format("{}: {} (beta {:.4g})", words, values_in_words(study, first.values), first.beta)});
}

/// So many cases as the deck's `samples` has to give to decide by the sample alone; empty: no number would.
std::string samples_to_tell(const chance::LimitProbability& sampled, double allowed) {
  const auto needed = chance::cases_needed(sampled, allowed);
  return needed ? fmt::format(": about {} samples would tell", *needed) : std::string{};
}

/// A limit without a number of FORM or importance sampling: the plain sample decides where its interval does. Else
/// false, and the result has no answer, with what to change.
bool falls_back(const Study& study, std::size_t k, const Outcome& outcome, const LimitAnswer& answer, Result& r) {
  const chance::LimitProbability& plain = answer.plain();
  const std::optional<double>& allowed = study.limits[k].allowed;
  if (allowed && chance::judged(plain.counted, *allowed) != chance::Allowed::not_judged) {
    r.warnings.push_back(fmt::format("{}. The plain sample of {} cases decides", outcome.message, plain.cases));
    return true;
  }
  const auto& [low, high] = plain.counted.interval;
  const std::string what = allowed ? fmt::format("which holds the allowed {}{}", probability_in_words(*allowed),
                                                 samples_to_tell(plain, *allowed))
                                   : "take it by leaving form, sorm and importance out of 'answer'";
  r.status = outcome.status;
  r.message = fmt::format("{}. The plain sample of {} cases gives {} to {}, {}", outcome.message, plain.cases,
                          probability_in_words(low), probability_in_words(high), what);
  return false;
}

/// A limit that is kept by importance sampling may yet be missed in a way that FORM has not found. The plain sample
/// sees that down to `missed`: an allowed probability above it has to be kept by the plain sample too. False: it is
/// not, and the limit is not judged. Below `missed` the verdict says on what it rests.
bool is_seen(const std::string& words, const LimitAnswer& answer, double allowed, Result& r) {
  const chance::LimitProbability& plain = answer.plain();
  const double high = plain.counted.interval.high;
  if (high <= allowed) return true;
  if (allowed < chance::ImportanceOptions{}.missed) {
    warn_unsafe(r, fmt::format("{}: a way to fail that FORM has not found is excluded only above {} ({} plain cases)",
                               words, probability_in_words(high), plain.cases));
    return true;
  }
  r.unmade.push_back(fmt::format(
      "the probability of {} is {} by importance sampling, but a plain sample of {} cases excludes a way to fail that "
      "FORM has not found only above {}, and {} is allowed{}",
      words, probability_in_words(answer.importance->counted.value), plain.cases, probability_in_words(high),
      probability_in_words(allowed), samples_to_tell(plain, allowed)));
  return false;
}

/// The allowed probability against the confidence interval of the one found.
void judge(const Study& study, std::size_t k, const LimitAnswer& answer, Result& r) {
  const StudyLimit& limit = study.limits[k];
  const std::string words = beyond_in_words(study, limit);
  const Estimate p = answer.decisive(study.request.confidence);
  if (!limit.allowed) {
    r.unjudged.push_back(fmt::format("the probability of {}", words));
    return;
  }
  const chance::Allowed judged = chance::judged(p, *limit.allowed);
  if (judged == chance::Allowed::kept && answer.weighted() && !is_seen(words, answer, *limit.allowed, r)) return;
  if (judged != chance::Allowed::not_judged) {
    r.checks.push_back(make_check(
        fmt::format("probability of {}", words), p.interval.high, si::one,
        {.sense = Sense::at_most,
         .limit = *limit.allowed,
         .rule = fmt::format("allowed probability of the deck, against the upper end of the {:.3g} % interval",
                             100 * study.request.confidence),
         .trust = "user"}));
    return;
  }
  r.unmade.push_back(fmt::format("the probability of {} is {} to {}, which holds the allowed {}{}", words,
                                 probability_in_words(p.interval.low), probability_in_words(p.interval.high),
                                 probability_in_words(*limit.allowed),
                                 answer.weighted() ? std::string{} : samples_to_tell(answer.plain(), *limit.allowed)));
}

void add_limits(const Study& study, const StudyData& data, const StudyOptions& options, ChanceSummary& summary,
                Result& r) {
  if (study.limits.empty()) return;
  Table t{.name = "probabilities",
          .title = "How probable it is that a limit is not kept; cases without an answer count as beyond it",
          .columns = {{.name = "event", .unit = si::one},
                      {.name = "probability", .unit = si::one},
                      {.name = "low", .unit = si::one},
                      {.name = "high", .unit = si::one},
                      {.name = "failed_left_out", .unit = si::one},
                      {.name = "allowed", .unit = si::one},
                      {.name = "from", .unit = si::one}},
          .rows = {}};
  const bool reliability = study.asks("form") || study.asks("sorm") || study.asks("importance");
  for (std::size_t k = 0; k < study.limits.size(); ++k) {
    const StudyLimit& limit = study.limits[k];
    const std::string words = beyond_in_words(study, limit), end = name_ending(k, study.limits.size());
    LimitAnswer answer{.sampled = chance::limit_probability(sample_of(study, data, limit.output), limit.limit),
                       .form = {},
                       .importance = {}};
    summary.probabilities.push_back(answer.sampled);
    if (reliability) {
      const Outcome outcome = add_reliability(study, limit, options, answer);
      if (answer.interrupted) {
        r.interrupted = true;
        r.unmade.push_back(fmt::format("the probability of {}: FORM was interrupted", words));
        continue;
      }
      if (!outcome.ok() && !falls_back(study, k, outcome, answer, r)) continue;
      if (outcome.ok()) add_design_points(study, k, *answer.form, r);
    }
    const Estimate p = answer.decisive(study.request.confidence);
    const chance::LimitProbability& plain = answer.plain();
    const double left_out = answer.weighted() ? answer.importance->left_out.value : plain.left_out.value;
    const std::string from =
        answer.weighted()
            ? fmt::format("importance sampling, {} samples", answer.importance->samples)
            : fmt::format("{} cases, {} beyond, {} without an answer", plain.cases, plain.beyond, plain.failed);
    t.rows.push_back({words, p.value, p.interval.low, p.interval.high, left_out,
                      limit.allowed ? *limit.allowed : std::nan(""), from});
    r.values.push_back({"p" + end, p.value, si::one, "p", "probability of " + words, {}});
    summary.lines.push_back({words, "probability", si::one, p});
    r.answers.push_back(
        {"Probability", fmt::format("{}: {} ({} to {})", words, probability_in_words(p.value),
                                    probability_in_words(p.interval.low), probability_in_words(p.interval.high))});
    if (answer.weighted() && !answer.importance->rests_on.empty()) r.warnings.push_back(answer.importance->rests_on);
    judge(study, k, answer, r);
  }
  r.tables.insert(r.tables.begin(), std::move(t));
}

void add_indices(const Study& study, const StudyData& data, ChanceSummary& summary, Result& r) {
  if (!study.indices) return;
  const std::size_t outputs = study.model.outputs.size();
  for (std::size_t k = 0; k < outputs; ++k) {
    const CaseOutput& output = study.model.outputs[k];
    const auto found =
        chance::sensitivity(*study.indices, part_of(data.outputs[k], study.saltelli), study.request.confidence);
    Table t{.name = "sensitivity" + name_ending(k, outputs),
            .title = fmt::format("Sobol indices of {}: {}", output.name,
                                 found.varies ? "the share of its variance from each input" : "it does not vary"),
            .columns = {},
            .rows = {}};
    for (const char* name : {"input", "first", "first_low", "first_high", "total", "total_low", "total_high"}) {
      t.columns.push_back({.name = name, .unit = si::one});
    }
    std::size_t most = 0;
    for (std::size_t i = 0; i < found.of.size(); ++i) {
      const auto& [first, total] = found.of[i];
      t.rows.push_back({short_name(study, i), first.value, first.interval.low, first.interval.high, total.value,
                        total.interval.low, total.interval.high});
      summary.lines.push_back({output.name, "first order index of " + study.model.inputs[i].path, si::one, first});
      summary.lines.push_back({output.name, "total index of " + study.model.inputs[i].path, si::one, total});
      if (total.value > found.of[most].total.value) most = i;
    }
    if (!found.varies) {
      r.answers.push_back({"Matters most", fmt::format("{}: does not vary", output.name)});
    } else if (!found.of.empty() && !std::isnan(found.of[most].total.value)) {
      r.answers.push_back({"Matters most", fmt::format("{}: {}, total Sobol index {:.2g}", output.name,
                                                       short_name(study, most), found.of[most].total.value)});
    }
    summary.indices.push_back(found);
    r.tables.push_back(std::move(t));
  }
}

void add_tornado(const Study& study, const StudyData& data, Result& r) {
  if (study.tornado.empty()) return;
  const std::size_t outputs = study.model.outputs.size();
  for (std::size_t k = 0; k < outputs; ++k) {
    const CaseOutput& output = study.model.outputs[k];
    const std::span<const double> bars = part_of(data.outputs[k], study.bars);
    Table t{.name = "tornado" + name_ending(k, outputs),
            .title = fmt::format(
                "{} while one input goes from its 5 % to its 95 % quantile, all others at their medians", output.name),
            .columns = {{.name = "input", .unit = si::one},
                        {.name = "from", .unit = si::one},
                        {.name = "to", .unit = si::one},
                        {.name = "at_from", .unit = output.unit},
                        {.name = "at_to", .unit = output.unit},
                        {.name = "change", .unit = difference_of(output.unit)}},
            .rows = {}};
    for (std::size_t i = 0; i < study.model.inputs.size(); ++i) {
      const Unit& unit = study.model.inputs[i].unit;
      const double low = bars[1 + 2 * i], high = bars[2 + 2 * i];
      t.rows.push_back({short_name(study, i), study.display.quantity(study.tornado[1 + 2 * i][i], unit),
                        study.display.quantity(study.tornado[2 + 2 * i][i], unit), low, high,
                        chance::is_leftover(high - low, bars[0]) ? 0 : high - low});
    }
    const bool moves =
        std::any_of(t.rows.begin(), t.rows.end(), [](const auto& row) { return std::get<double>(row.back()) != 0; });
    if (!moves) t.title += ": it does not vary";
    const auto change = [](const std::vector<Cell>& row) {
      const double x = std::abs(std::get<double>(row.back()));
      return std::isnan(x) ? -1 : x;  // a case without an answer comes last
    };
    std::stable_sort(t.rows.begin(), t.rows.end(), [&](const auto& a, const auto& b) { return change(a) > change(b); });
    r.tables.push_back(std::move(t));
  }
}

}  // namespace

chance::Sample sample_of(const Study& study, const StudyData& data, std::size_t output) {
  return {.values = part_of(data.outputs[output], study.sample),
          .replicates = study.points->replicates(),
          .confidence = study.request.confidence};
}

void add_chance(const Study& study, const StudyData& data, const StudyOptions& options, ChanceSummary& summary,
                Result& r) {
  add_limits(study, data, options, summary, r);
  add_indices(study, data, summary, r);
  add_tornado(study, data, r);
}

}  // namespace taut::app
