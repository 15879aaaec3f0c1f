#pragma once
#include <cstdint>
#include <string>

#include "taut/chance/reliability/design_point.hpp"

namespace taut::chance {

enum class FormStatus {
  found,         ///< at least one design point
  refused,       ///< the question has no FORM: an input without density, no margin at the medians
  not_converged  ///< no search reached a design point: no probability
};

/// A point of the limit that is nearest to the medians in standard normal space: a most likely failure.
struct DesignPoint {
  Point scores;            ///< u*, independent standard normal
  Point values;            ///< SI values of the inputs there
  double beta = 0;         ///< reliability index; below 0 where the medians do not keep the limit
  double probability = 0;  ///< FORM: Phi(-beta)
  std::vector<double>
      importance;  ///< of each input, sum 1: alpha_i^2; of correlated inputs gamma_i^2, gamma ~ L^-T alpha
  std::vector<double> curvatures;  ///< main curvatures of the limit, falling; empty where a case beside it failed
  double breitung = 0;             ///< SORM; NaN where there are no curvatures
  std::size_t searches = 0;        ///< how many of them ended here
};

struct FormOptions {
  SearchOptions search = {};
  double curvature_step = 0.1;  ///< of the second differences, in scores
  std::uint64_t seed = 1;       ///< of the cases that look for starts
};

struct Form {
  FormStatus status = FormStatus::not_converged;
  std::string reason;               ///< where nothing was found: why, and what to do
  std::vector<DesignPoint> points;  ///< the nearest first
  std::size_t starts = 0, searches = 0, converged = 0;
  std::uint64_t evaluations = 0;  ///< cases calculated
};

/// First order reliability method. Starts: the origin (medians of all inputs), +-2 along each axis (up to eight
/// inputs) or along eight fixed directions, and up to four of the nearest cases beyond the limit among 256 scattered
/// ones (sd 2.5). improved_hlrf from each; slsqp from the origin, and where the first does not converge. Step of the
/// differences: options.search.step, or (noise/|gradient|)^(1/3) up to 0.2 where the model is noisier than that. Points
/// nearer to each other than a quarter of max(1, |beta|) are one; saddles of the distance (see sorm.hpp) are left to
/// both sides and dropped. At most 12 points. The same arguments give the same bits.
Form form(const LimitState& state, const FormOptions& options = {});

}  // namespace taut::chance
