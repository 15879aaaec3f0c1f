#pragma once
#include <string>
#include <tl/expected.hpp>

#include "taut/chance/inputs.hpp"
#include "taut/chance/point_set.hpp"
#include "taut/chance/statistics.hpp"

namespace taut::chance {

/// The cases that Sobol indices of d inputs need (Saltelli et al. 2010, section 3): a base point of 2 d numbers gives a
/// point A and a point B, and for each input i the point A with that number of B. Case index =
/// base (d + 2) + k; k = 0: A, 1: B, 2 + i: A with B's number i. Like a PointSet it gives any case without the others.
class SaltelliPlan {
 public:
  /// About `cases` cases in all, rounded up to whole base points and replicates. 2 d <= 3666.
  SaltelliPlan(PointKind kind, std::size_t inputs, std::uint64_t cases, std::uint64_t seed);

  std::size_t inputs() const { return base_.inputs() / 2; }
  const PointSet& base() const { return base_; }
  std::uint64_t size() const { return base_.size() * (inputs() + 2); }
  /// The point of the unit cube of a case, index < size().
  Point at(std::uint64_t index) const;

 private:
  PointSet base_;
};

/// Why these inputs have no Sobol indices, for the user's eyes; empty where they have. The shares of a variance add up
/// only where the inputs are independent.
std::string indices_refused(const Inputs& inputs);

/// The share of an output's variance that comes from one input: alone (first order), and with all its interplay with
/// others (total). Estimated values may lie a little outside 0 to 1.
struct Indices {
  Estimate first, total;
};

/// Whether a difference of an output is no more than a solver leaves in it, 1e-10 of the value: it says nothing of the
/// inputs. An output that no input acts on comes out with a few last digits of its own in each case.
bool is_leftover(double difference, double value);

struct Sensitivity {
  std::vector<Indices> of = {};  ///< by input; NaN where the output does not vary
  bool varies = true;            ///< false: its standard deviation is a leftover of its mean
  std::uint64_t left_out = 0;    ///< base points with a failed case, left out whole
  std::uint64_t base = 0;        ///< base points in all
};

/// Jansen's estimators (1999; Saltelli et al. 2010, table 2, rows c and f), with f of A, B, AB_i and V the variance of
/// A and B together:  first_i = 1 - mean (f_B - f_ABi)^2/(2 V),  total_i = mean (f_A - f_ABi)^2/(2 V).
/// `outputs`: one for each case of the plan, NaN: failed. Interval: Student's over the replicates; of random points
/// over 16 blocks (infinite with fewer than 32 base points).
Sensitivity sensitivity(const SaltelliPlan& plan, std::span<const double> outputs, double confidence = 0.95);

/// The cases of a tornado plot: first all inputs at their medians, then for each input its p- and its (1 - p)-quantile
/// with all others at their medians (correlation is left out of account). SI values; 0 < p < 0.5.
Points tornado_points(const Inputs& inputs, double p = 0.05);

}  // namespace taut::chance
