#pragma once
#include <optional>

#include "taut/chance/reliability/form.hpp"

namespace taut::chance {

struct ImportanceOptions {
  std::uint64_t seed = 1;
  std::uint64_t most_samples = 20000;   ///< in blocks of 1000
  double wanted_variation = 0.01;       ///< coefficient of variation of the sampled region at which sampling ends
  double worst_variation = 0.3;         ///< above it there is no number
  double missed = 1e-3;                 ///< the probability of a missed way to fail that the plain sample is to see
  double confidence = 0.95;             ///< of seeing it, and of the plain sample's interval; two-sided
  std::uint64_t plain_samples = 20000;  ///< to which a plain sample is completed at most; 0: none is made
};

enum class ImportanceStatus {
  found,
  no_design_point,  ///< FORM has none
  not_converged,    ///< too few samples in the region that is sampled
  disagrees         ///< with a plain sample: a region beyond the limit has no design point
};

/// A probability by weighted samples.
struct Weighted {
  double value = 0, standard_error = 0;
  double variation = 0;  ///< standard_error/value; infinite where value = 0
};

/// Importance sampling around the design points, and a plain sample beside it. `left_out` and `counted` count only
/// where status is found; `plain` always does.
struct ImportanceSampling {
  ImportanceStatus status = ImportanceStatus::no_design_point;
  std::string reason;  ///< where there is no number: why
  /// Failed cases left out, sum w beyond/(N - sum w failed). Where the medians fail (p - F)/(1 - F), with the failed
  /// share F of the plain sample, within 0 and 1; NaN without one.
  Weighted left_out;
  Weighted counted;  ///< failed cases counted as beyond; this one decides
  std::uint64_t samples = 0, beyond = 0, failed = 0;
  std::optional<LimitProbability> plain;  ///< what the plain sample gives; none without design point
  /// Below 1e-4: on how many samples the number rests, as a sentence; else empty.
  std::string rests_on;
};

/// Samples u from a mixture of normals of unit covariance centred at all design points, weights of the mixture in
/// proportion to Phi(-|beta|), at least a tenth of the largest: p = mean of w(u) 1[g(u) < 0] with
/// w = phi(u)/sum pi_k phi(u - u_k) (Melchers 1989; Engelund & Rackwitz 1993, section 3). Where the medians fail,
/// beta < 0, the design points are the nearest ones of the region that keeps the limit, and only there is w bounded:
/// p = 1 - mean of w(u) 1[g(u) >= 0], with the same standard error. Sample k is a function of (seed, k); sums run in
/// its order.
///
/// Against it stands a plain sample: `plain`, completed with cases of its own until a missed region of the probability
/// `missed` would be seen with the confidence, or to `plain_samples`. They disagree where they differ by more than 3
/// standard deviations, or where so few or so many plain cases lie beyond the limit that their chance is below 0.00135
/// (exact, used below ten). Where importance sampling has no number the plain sample is completed to `plain_samples`.
ImportanceSampling importance_sampling(const LimitState& state, const Form& form, const ImportanceOptions& options = {},
                                       const std::optional<LimitProbability>& plain = {});

}  // namespace taut::chance
