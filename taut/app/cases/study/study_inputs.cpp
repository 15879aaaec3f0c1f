#include "taut/app/cases/study/study_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/parse.hpp"

namespace taut::app {
namespace {

/// Reads the texts of one input in its unit.
class LawReader {
 public:
  LawReader(const VaryRequest& request, const CaseInput& input, std::vector<Complaint>& complaints)
      : request_(request), input_(input), complaints_(complaints), path_("study.vary." + request.name) {}

  chance::Distribution read() {
    chance::Distribution d;
    if (request_.normal) d.law = chance::Normal{.mean = mean(*request_.normal), .sd = sd(*request_.normal, "normal")};
    if (request_.lognormal) {
      d.law = chance::Lognormal{.mean = mean(*request_.lognormal), .sd = sd(*request_.lognormal, "lognormal")};
    }
    if (const auto& u = request_.uniform) {
      d.law = chance::Uniform{.low = value(u->low, "uniform.low"), .high = value(u->high, "uniform.high")};
    }
    if (const auto& g = request_.gumbel) {
      d.law = chance::Gumbel{.mode = value(g->mode, "gumbel.mode"), .scale = difference(g->scale, "gumbel.scale")};
    }
    if (const auto& w = request_.weibull) {
      d.law = chance::Weibull{.shape = w->shape,
                              .scale = difference(w->scale, "weibull.scale"),
                              .shift = w->shift ? value(*w->shift, "weibull.shift") : 0};
    }
    if (const auto& t = request_.triangular) {
      d.law = chance::Triangular{.low = value(t->low, "triangular.low"),
                                 .mode = value(t->mode, "triangular.mode"),
                                 .high = value(t->high, "triangular.high")};
    }
    if (!request_.list.empty()) d.law = listed();
    if (request_.from) d.law = stepped();
    read_cuts(d);
    check(d);
    return d;
  }

 private:
  void complain(const std::string& key, const std::string& message) {
    complaints_.push_back({key.empty() ? path_ : path_ + "." + key, message});
  }

  double value(const std::string& text, const std::string& key) {
    const auto number = parse_quantity(text, input_.unit);
    if (number) return *number;
    complain(key, number.error().message);
    return std::nan("");
  }

  /// A distance on the axis of the input: of temperatures K, never degC.
  double difference(const std::string& text, const std::string& key) {
    const double x = value(text, key);
    if (is_temperature(input_.unit) && text.find("deg") != std::string::npos) {
      complain(key, "a difference of temperatures is given in K");
    }
    return x;
  }

  double mean(const MeanRequest& law) { return value(law.mean, law_key("mean")); }

  double sd(const MeanRequest& law, const char* name) {
    if (law.sd) return difference(*law.sd, law_key("sd"));
    if (is_temperature(input_.unit)) {
      complain(fmt::format("{}.cov", name),
               "a share of a temperature would depend on the zero of its scale: give 'sd' in K, as in 'sd: 5 K'");
      return std::nan("");
    }
    const auto share = parse_quantity(law.cov.value_or(""), si::one);
    if (share) return *share * std::abs(mean_of(law));
    complain(fmt::format("{}.cov", name), share.error().message);
    return std::nan("");
  }

  std::string law_key(const char* key) const {
    return fmt::format("{}.{}", request_.normal ? "normal" : "lognormal", key);
  }
  double mean_of(const MeanRequest& law) const { return parse_quantity(law.mean, input_.unit).value_or(std::nan("")); }

  chance::Listed listed() {
    chance::Listed all{.values = {}, .weights = request_.weights};
    for (std::size_t i = 0; i < request_.list.size(); ++i) {
      all.values.push_back(value(request_.list[i], fmt::format("list[{}]", i)));
    }
    return all;
  }

  chance::Listed stepped() {
    chance::Listed all;
    if (!request_.to) complain("", "'from' needs 'to'");
    if (!request_.steps) complain("", "'from' needs 'steps'");
    if (!request_.to || !request_.steps) return {.values = {0}, .weights = {}};
    const double from = value(*request_.from, "from"), to = value(*request_.to, "to");
    for (int i = 0; i <= *request_.steps; ++i) all.values.push_back(step_between(from, to, i, *request_.steps));
    if (from == to) complain("to", "is the same value as 'from'");
    return all;
  }

  void read_cuts(chance::Distribution& d) {
    if (request_.truncate.empty()) return;
    if (request_.truncate.size() != 2) {
      complain("truncate", "two values are expected, [least, largest]");
      return;
    }
    d.from = value(request_.truncate[0], "truncate[0]");
    d.to = value(request_.truncate[1], "truncate[1]");
  }

  /// What the law itself, or the deck's range for the number, does not allow.
  void check(const chance::Distribution& d) {
    if (std::any_of(complaints_.begin(), complaints_.end(),
                    [&](const Complaint& c) { return c.path.starts_with(path_); })) {
      return;
    }
    if (const std::string wrong = chance::mistake(d); !wrong.empty()) {
      complain("", wrong);
      return;
    }
    const double middle = chance::value_at(d, 0.5);
    if (!input_.range.contains(middle)) {
      complain("", fmt::format("half of its values are outside what '{}' may be", input_.path));
    }
  }

  const VaryRequest& request_;
  const CaseInput& input_;
  std::vector<Complaint>& complaints_;
  std::string path_;
};

chance::Correlation study_correlation(const StudyRequest& request, const chance::Inputs& inputs,
                                      std::vector<Complaint>& complaints) {
  std::vector<std::string> names;
  names.reserve(request.vary.size());
  for (const VaryRequest& one : request.vary) names.push_back(one.name);
  std::vector<chance::CorrelatedPair> pairs;
  for (std::size_t i = 0; i < request.correlate.size(); ++i) {
    const std::string path = fmt::format("study.correlate[{}]", i);
    const std::vector<std::string>& text = request.correlate[i].pair;
    const auto r = text.size() == 3 ? parse_quantity(text[2], si::one) : tl::unexpected(UnitError{});
    if (!r) {
      complaints.push_back({path,
                            "[path, path, correlation] is expected, as in [machine.ropes.a.stiffness, "
                            "machine.ropes.b.stiffness, 0.5]"});
      continue;
    }
    chance::CorrelatedPair pair{.first = 0, .second = 0, .r = *r};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = std::find(names.begin(), names.end(), text[k]);
      if (at == names.end()) {
        complaints.push_back(
            {path, fmt::format("'{}' is not among what varies{}", text[k], did_you_mean(text[k], names))});
        continue;
      }
      (k == 0 ? pair.first : pair.second) = static_cast<std::size_t>(at - names.begin());
      if (!chance::continuous(inputs.of[static_cast<std::size_t>(at - names.begin())])) {
        complaints.push_back({path, fmt::format("'{}' has single values: it can't be correlated", text[k])});
      }
    }
    pairs.push_back(pair);
  }
  if (pairs.empty() || !complaints.empty()) return {};
  auto found = chance::correlation(pairs, names);
  if (found) return std::move(*found);
  complaints.push_back({"study.correlate", found.error()});
  return {};
}

}  // namespace

chance::Inputs study_inputs(const StudyRequest& request, const std::vector<CaseInput>& inputs,
                            std::vector<Complaint>& complaints) {
  chance::Inputs made;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    made.of.push_back(LawReader(request.vary[i], inputs[i], complaints).read());
  }
  if (complaints.empty()) made.correlation = study_correlation(request, made, complaints);
  return made;
}

std::vector<StudyLimit> study_limits(const StudyRequest& request, const std::vector<CaseOutput>& outputs,
                                     std::vector<Complaint>& complaints) {
  std::vector<StudyLimit> limits;
  std::vector<std::string> names;
  names.reserve(outputs.size());
  for (const CaseOutput& one : outputs) names.push_back(one.name);
  for (const LimitRequest& one : request.limit) {
    const std::string path = "study.limit." + one.name;
    const auto at = std::find(names.begin(), names.end(), one.name);
    if (at == names.end()) {
      complaints.push_back({path, fmt::format("is not one of the values in 'of'{}", did_you_mean(one.name, names))});
      continue;
    }
    StudyLimit limit{.output = static_cast<std::size_t>(at - names.begin()), .limit = {}, .allowed = one.allowed};
    limit.limit.bound = one.at_least ? chance::Bound::at_least : chance::Bound::at_most;
    const std::string& text = one.at_least ? *one.at_least : *one.at_most;
    const auto value = parse_quantity(text, outputs[limit.output].unit);
    if (value) {
      limit.limit.value = *value;
    } else {
      complaints.push_back({path + (one.at_least ? ".at_least" : ".at_most"), value.error().message});
    }
    limits.push_back(limit);
  }
  return limits;
}

}  // namespace taut::app
