#pragma once
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/study/deck/rope_motion.hpp"
#include "taut/study/limits.hpp"
#include "taut/study/load_path.hpp"

namespace taut {
template <class Row>
struct Quantity;
}
namespace taut::catalogue {
struct RuleRow;
}

namespace taut::study {

class Watch;
struct Names;

/// Limits of one rope, or of the pull of one drum, by its name.
struct RopeLimitRequest {
  std::string name;
  std::optional<double> tension;        ///< N
  std::optional<double> safety_factor;  ///< breaking force over tension
  std::optional<std::string> rule;      ///< id of a rule of the catalogue, a safety factor
  std::optional<double> clearance;      ///< of the rope over the ground, m
  std::optional<double> pull;           ///< of a drum, N
  static const Description& describe();
};

struct LimitsRequest {
  std::vector<RopeLimitRequest> named;
  std::optional<double> clearance;       ///< of the carriage over the ground, m
  std::optional<double> rope_clearance;  ///< of the rope that it rides on, m
  std::optional<double> break_angle;     ///< rad
  std::optional<double> least_break_angle;
  bool lift_off = false;
  static const Description& describe();
};

/// The largest load within all limits, as a deck asks for it.
struct PayloadRequest {
  std::optional<std::string> name;
  std::string carriage;
  double from = 0;
  double to = 0;
  int steps = 48;
  std::vector<double> along = {1, 0};  ///< direction of from and to
  std::vector<MotionRequest> motion;
  LimitsRequest limits;
  double most = 100e3;  ///< kg
  bool judge = true;    ///< false: its states do not count for the verdict
  bool held = false;    ///< whatever holds the carriage
  static const Description& describe();
};

/// The largest payload at one position.
struct Payload {
  Outcome outcome;              ///< infeasible: a limit is exceeded even without payload, or there is no equilibrium
  double mass = 0;              ///< kg, in addition to the mass of the body
  std::string governing;        ///< the limit that governs, in words
  std::optional<int> reeving;   ///< the rope whose tension governs; empty: another limit governs
  LimitState limit;             ///< the governing limit, with that payload
  solve::EquilibriumResult at;  ///< with that payload; without payload where a limit is exceeded even so
  std::optional<machine::State> unloaded;  ///< without payload; empty where there is no equilibrium
};

/// The largest mass that may be added at the origin of a body within the limits. With the mass the tensions grow and
/// the clearances fall, so the first limit reached governs. A mass without equilibrium counts as too large. `expected`:
/// a payload nearby, kg, which only saves time. `start`: a state near the one without payload. Throws ContractViolation
/// when `limits.tension` or `limits.rope_clearance` is neither empty nor of the size of the reevings, a limit is NaN, a
/// tension or pull not above 0, `limits.most` not positive and finite, or `body` or `expected` (>= 0) is none.
Payload payload(const machine::Model& model, int body, const PayloadLimits& limits,
                const solve::EquilibriumOptions& options = {},
                const std::optional<machine::State>& start = std::nullopt, double expected = 0);

/// The payload at each position of a load path; clearance is that of the body of the carriage.
struct PayloadPoint {
  double x = 0, z = 0;   ///< of the carriage with that payload, m
  double clearance = 0;  ///< m; NaN without terrain there
  Payload payload;
};
/// Besides, within a step, the place over a top of the terrain that carries less than both its ends, and the one that
/// is nearer to the ground than both: at most two, between them.
Array<PayloadPoint> payload_path(const machine::Model& model, const PayloadLimits& limits,
                                 const LoadPathOptions& options);

/// One position, from a state without payload near it, else from the place alone. `expected`: as for a payload.
PayloadPoint payload_at(const machine::Model& model, const PayloadLimits& limits, const LoadPathOptions& options,
                        double x, const std::optional<machine::State>& start = std::nullopt, double expected = 0);

/// A safety factor that limits the tension of a rope by its breaking force: of a rule of the catalogue, or the deck's
/// own.
struct PayloadFactor {
  int reeving = 0;
  double factor = 1;
  const catalogue::RuleRow* row = nullptr;  ///< none: the deck's own
};

/// One place of the carriage.
struct PayloadPosition {
  const machine::Model* model = nullptr;  ///< of PayloadRun::parts or PayloadRun::over_tops
  PayloadPoint point;
  Array<LimitState> states;  ///< of all limits with the payload
  std::string support;       ///< on which it lies, in no span; else empty

  /// Whether it has an equilibrium; where a limit is exceeded even without payload, that is 0.
  bool answered() const { return support.empty() && point.payload.at.outcome.ok(); }
};

/// What a deck asks, and the answer place by place.
struct PayloadRun {
  std::string ending;
  std::string words;
  RopeMotion motion;
  Way way;
  bool one_place = false;
  bool held = false;
  PayloadLimits limits;
  std::vector<PayloadFactor> factors;
  Array<double> tensions;  ///< by reeving: the limit that the deck gives as a force, N; infinite: none
  Array<WayPart> parts;
  std::deque<machine::Model> over_tops;  ///< of positions over tops of the ground between parts
  Array<PayloadPosition> positions;
};

/// The request with its names resolved; complaints below `path`.
PayloadRun resolve(const PayloadRequest& request, const std::string& path, Names& names);

/// Fills `run.parts` and `run.positions`; fewer where the watch ends it.
void solve(const machine::Model& model, PayloadRun& run, Watch& watch);

/// What a place has besides the state of its machine (load_path.hpp).
const std::vector<Quantity<PayloadPosition>>& payload_quantities();

}  // namespace taut::study
