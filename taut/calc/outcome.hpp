#pragma once
#include <string>
#include <string_view>

namespace taut {

/// How a calculation ended. infeasible: the equations have no admissible solution. not_converged: the solver found
/// none.
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

/// Status of a computation. When it is not ok, `message` gives the reason and what to change.
struct Outcome {
  Status status = Status::ok;
  std::string message;
  bool ok() const { return status == Status::ok; }
};

inline Outcome infeasible(std::string message) { return {.status = Status::infeasible, .message = std::move(message)}; }
inline Outcome not_converged(std::string message) {
  return {.status = Status::not_converged, .message = std::move(message)};
}

}  // namespace taut
