#include "taut/study/deck/missing.hpp"

#include <fmt/format.h>

#include "taut/calc/verdict.hpp"

namespace taut::study {

void Stretches::take(const std::string& why, const std::string& words, const std::string& analysis) {
  const bool goes_on = open_ && analysis == analysis_;
  open_ = !why.empty();
  analysis_ = analysis;
  if (!open_) return;
  if (all_.empty()) why_ = why;
  if (!goes_on) all_.push_back({.from = words, .to = words});
  all_.back().to = words;
  ++all_.back().states;
}

namespace {

/// The words of a state without the parts, between commas, that those of another begin with too.
std::string without_common(const std::string& words, const std::string& other) {
  const std::string_view between = ", ";
  std::size_t common = 0;
  for (std::size_t end = words.find(between); end != std::string::npos; end = words.find(between, common)) {
    const std::size_t next = end + between.size();
    if (words.compare(common, next - common, other, common, next - common) != 0) break;
    common = next;
  }
  return words.substr(common);
}

}  // namespace

std::string Stretches::Stretch::words(const std::string& other) const {
  const std::string first = without_common(from, other);
  return states == 1 ? first : fmt::format("{} to {} ({} states)", first, without_common(to, from), states);
}

std::string Stretches::places() const {
  std::string text = all_.front().words({});
  for (std::size_t i = 1; i < all_.size(); ++i) text += "; " + all_[i].words(all_[i - 1].from);
  return text;
}

std::string Stretches::words() const { return fmt::format("{}: {}", places(), why_); }

std::string Stretches::words_of_first() const {
  const std::size_t more = all_.size() - 1;
  if (more == 0) return words();
  return fmt::format("{} and on {} more stretch{}: {}", all_.front().words({}), more, more == 1 ? "" : "es", why_);
}

void Missing::take(const Outcome& outcome, const std::string& where) {
  ++places_;
  where_.take(outcome.ok() ? std::string() : outcome.message, where, {});
  if (outcome.ok()) return;
  if (missing_ == 0) {
    why_ = outcome;
    first_ = where;
  }
  ++missing_;
}

void Missing::take(const Outcome& outcome, double x, const Display& display) {
  take(outcome, "x = " + display.brief(x, si::m));
}

void Missing::note(Result& r, const std::string& analysis, bool judged) const {
  if (missing_ == 0) return;
  if (missing_ == places_) return note_failure(r, why_, fmt::format("{}, {}", analysis, first_));
  const MissingStates missing{.analysis = analysis,
                              .missing = missing_,
                              .places = places_,
                              .first = first_,
                              .reason = why_.message,
                              .all = where_.places()};
  if (judged) r.missing.push_back(missing);
  r.warnings.push_back(missing_words(missing));
}

Outcome outcome_of_case(const Result& r) {
  if (r.status != Status::ok) return {.status = r.status, .message = r.message};
  if (r.missing.empty()) return {};
  const MissingStates& first = r.missing.front();
  return infeasible(fmt::format("{}, {}: {}", first.analysis, first.first, first.reason));
}

void note_failure(Result& r, const Outcome& outcome, const std::string& what) {
  if (outcome.ok() || r.status != Status::ok) return;
  r.status = outcome.status;
  r.message = fmt::format("{}: {}", what, outcome.message);
}

}  // namespace taut::study
