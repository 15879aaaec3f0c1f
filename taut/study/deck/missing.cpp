#include "taut/study/deck/missing.hpp"

#include <fmt/format.h>

#include "taut/calc/verdict.hpp"

namespace taut::study {

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
