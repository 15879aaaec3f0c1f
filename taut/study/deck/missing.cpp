#include "taut/study/deck/missing.hpp"

#include <fmt/format.h>

namespace taut::study {

void Missing::lose(const Outcome& outcome, const std::string& where, int states) {
  if (missing_ == 0) {
    why_ = outcome;
    first_ = where;
  }
  missing_ += states;
  places_ += states;
}

void Missing::take(const Outcome& outcome, const std::string& where) {
  if (outcome.ok()) {
    ++places_;
  } else {
    lose(outcome, where);
  }
}

void Missing::take(const Outcome& outcome, double x) { take(outcome, fmt::format("x = {:.6g} m", x)); }

void Missing::note(Result& r, const std::string& analysis, bool judged) const {
  if (missing_ == 0) return;
  if (missing_ == places_) return note_failure(r, why_, fmt::format("{}, {}", analysis, first_));
  if (judged) r.missing.push_back({analysis, missing_, places_, first_, why_.message});
  r.warnings.push_back(fmt::format("{}: no equilibrium at {} of {} places, first {}: {}", analysis, missing_, places_,
                                   first_, why_.message));
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
