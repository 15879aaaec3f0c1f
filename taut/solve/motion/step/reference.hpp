#pragma once
#include <limits>
#include <memory>

#include "taut/solve/motion/run/run.hpp"

/// The reference of motions: the laws of the machine at one time, as transient_follow and transient_assemble say them,
/// integrated by IDA of SUNDIALS (backward differences of variable order, its own control of the error). Nothing of the
/// steps of the fast schemes is in it. Where a contact begins to slip or stick, a branch goes slack or taut, a bearing
/// begins to turn, its dense output is searched for the moment, and it begins anew there.
namespace taut::solve::dynamics {

struct ReferenceState;

/// Where the integrator stands between two restarts.
class Reference {
 public:
  Reference();
  ~Reference();
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  bool begun() const { return state_ != nullptr; }
  /// Begins at run.before, whose accelerations are consistent.
  StepEnd begin(Run& run);
  /// One step, at most to `limit`, into run.now; run.scheme.h is its length. `changed`: a law has changed there.
  StepEnd step(Run& run, double limit, bool& changed);

 private:
  std::unique_ptr<ReferenceState> state_;
  double first_change_ = -std::numeric_limits<double>::infinity();  ///< of laws that change in quick succession, s
  int changes_ = 0;                                                 ///< of laws since then
};

/// What the reference can't do with a machine.
Outcome reference_refuses(const Mechanism& m);

}  // namespace taut::solve::dynamics
