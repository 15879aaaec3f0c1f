#pragma once
#include <string>
#include <string_view>

namespace taut {

/// How a calculation ended. `infeasible`: physics says no; `not_converged`: the solver does.
enum class Status { ok, infeasible, not_converged, bad_deck };

/// "ok", "infeasible", "not_converged", "bad_deck".
constexpr std::string_view to_text(Status s) {
  switch (s) {
    case Status::ok:
      return "ok";
    case Status::infeasible:
      return "infeasible";
    case Status::not_converged:
      return "not_converged";
    case Status::bad_deck:
      return "bad_deck";
  }
  return "bad_deck";
}

/// The end of a computation: `message` says what to change when it is not ok.
struct Outcome {
  Status status = Status::ok;
  std::string message;
  bool ok() const { return status == Status::ok; }
};

inline Outcome infeasible(std::string message) { return {Status::infeasible, std::move(message)}; }
inline Outcome not_converged(std::string message) { return {Status::not_converged, std::move(message)}; }

}  // namespace taut
