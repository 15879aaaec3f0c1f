#include "taut/app/cases/study/study_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/units/any_quantity.hpp"

namespace taut::app {
namespace {

/// The numbers of a law in the unit of an input.
class LawWords {
 public:
  LawWords(const Display& display, const Unit& unit) : display_(display), unit_(unit) {}

  std::string operator()(const chance::Normal& law) const { return by_mean("normal", law.mean, law.sd); }
  std::string operator()(const chance::Lognormal& law) const { return by_mean("lognormal", law.mean, law.sd); }
  std::string operator()(const chance::Uniform& law) const {
    return fmt::format("uniform, {} to {}", value(law.low), value(law.high));
  }
  std::string operator()(const chance::Gumbel& law) const {
    return fmt::format("Gumbel, mode {}, scale {}", value(law.mode), difference(law.scale));
  }
  std::string operator()(const chance::Weibull& law) const {
    return fmt::format("Weibull, shape {:.4g}, scale {}, shift {}", law.shape, difference(law.scale), value(law.shift));
  }
  std::string operator()(const chance::Triangular& law) const {
    return fmt::format("triangular, {} to {}, most likely {}", value(law.low), value(law.high), value(law.mode));
  }
  std::string operator()(const chance::Listed& law) const {
    const auto [least, most] = std::minmax_element(law.values.begin(), law.values.end());
    return fmt::format("{} values, {} to {}", law.values.size(), value(*least), value(*most));
  }
  std::string value(double x) const { return display_.brief(x, unit_); }

 private:
  std::string by_mean(const char* name, double mean, double sd) const {
    return fmt::format("{}, mean {}, sd {}", name, value(mean), difference(sd));
  }
  std::string difference(double x) const { return display_.brief(x, difference_of(unit_)); }

  const Display& display_;
  const Unit& unit_;
};

std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps(1);
  for (const char c : path) {
    if (c == '.') {
      steps.emplace_back();
    } else {
      steps.back() += c;
    }
  }
  return steps;
}

std::string end_of(const std::vector<std::string>& steps, std::size_t count) {
  const auto from = steps.end() - static_cast<std::ptrdiff_t>(std::min(count, steps.size()));
  return fmt::format("{}", fmt::join(from, steps.end(), "."));
}

}  // namespace

std::string law_in_words(const Study& study, std::size_t input) {
  const LawWords words(study.display, study.model.inputs[input].unit);
  const chance::Distribution& d = study.inputs.of[input];
  std::string text = std::visit(words, d.law);
  if (d.from && d.to) text += fmt::format(", cut to {} ... {}", words.value(*d.from), words.value(*d.to));
  return text;
}

std::string short_name(const Study& study, std::size_t input) {
  const std::vector<CaseInput>& all = study.model.inputs;
  const std::vector<std::string> own = steps_of(all[input].path);
  for (std::size_t count = 2; count < own.size(); ++count) {
    const auto same = std::count_if(all.begin(), all.end(), [&](const CaseInput& other) {
      return end_of(steps_of(other.path), count) == end_of(own, count);
    });
    if (same == 1) return end_of(own, count);
  }
  return all[input].path;
}

std::string values_in_words(const Study& study, const chance::Point& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += fmt::format("{}{} {}", i > 0 ? ", " : "", short_name(study, i),
                        study.display.brief(values[i], study.model.inputs[i].unit));
  }
  return text;
}

std::string beyond_in_words(const Study& study, const StudyLimit& limit) {
  const CaseOutput& output = study.model.outputs[limit.output];
  return fmt::format("{} {} {}", output.name, limit.limit.bound == chance::Bound::at_least ? "below" : "above",
                     study.display.brief(limit.limit.value, output.unit));
}

std::string name_ending(std::size_t k, std::size_t all) { return all > 1 ? fmt::format("_{}", k + 1) : std::string{}; }

std::string probability_in_words(double p) {
  return p == 0 || p >= 1e-3 ? fmt::format("{:.3g}", p) : fmt::format("{:.2e}", p);
}

}  // namespace taut::app
