#pragma once
#include <optional>
#include <string>

#include "taut/chance/point.hpp"
#include "taut/chance/statistics.hpp"

namespace taut::chance {

/// A parameter of the model that the measurements shall tell, SI; low < high.
struct FreeParameter {
  std::string name;  ///< as the messages call it
  double low = 0, high = 1;
  std::optional<double> start = {};  ///< the first of the starts; else the middle
};

/// What was measured, in the order of the model's outputs, SI.
struct Measured {
  std::vector<double> values;
  std::vector<double> sd;  ///< standard deviation of each, > 0; empty: one for all, estimated from the residuals
};

enum class ParameterState {
  estimated,
  at_low,           ///< the fit ends at the lower bound and would go on below it
  at_high,          ///< the same at the upper one
  not_identifiable  ///< the measurements do not tell it: alone, or from others
};

struct CalibratedParameter {
  double value = 0;
  ParameterState state = ParameterState::estimated;
  double standard_error = 0;  ///< NaN unless estimated, and where the sd of the measurements is not known
  double spread = 0;  ///< standard deviation of the normal law with this interval: where the sd of the measurements is
                      ///< estimated, more than the standard error; NaN without one
  Interval interval;  ///< within the bounds; the bounds themselves where there is no standard error
  std::string note = {};  ///< for the user's eyes: at a bound, or why it is not identifiable; else empty
};

/// Parameters that the measurements cannot tell apart: the model's outputs stay as they are when these move together.
struct Inseparable {
  std::vector<std::size_t> parameters;  ///< two or more
  double correlation = 0;  ///< of the estimates of the first two; +-1 where nothing at all tells them apart
};

enum class CalibrationStatus { found, not_converged };

struct Calibration {
  CalibrationStatus status = CalibrationStatus::not_converged;
  std::string reason;                           ///< where there is none: why
  std::vector<CalibratedParameter> parameters;  ///< in the order of the free ones
  std::vector<double> covariance;               ///< of the parameters, row by row; NaN where one is not estimated
  std::vector<Inseparable> inseparable;         ///< with |correlation| >= 0.99
  std::vector<double> model;                    ///< outputs at the fit
  std::vector<double> residuals;                ///< measured - model
  double sd = 0;           ///< estimated from the residuals; NaN where they are given, or freedom is 0
  double chi_squared = 0;  ///< sum of (residual/sd)^2 where sd is given, else sum of residual^2
  int freedom = 0;         ///< measurements less told parameters
  double p_value = 0;      ///< P(chi squared > its value) where sd is given; else NaN. Small: the model does not fit
  Points other_fits;       ///< parameters of clearly different fits that are as good (within 4 of chi squared)
  std::uint64_t evaluations = 0;
};

struct CalibrationOptions {
  double confidence = 0.95;
  double step = 1e-3;  ///< of the differences, as a share of a parameter's range
  int most_iterations = 100;
  std::size_t starts = 5;
  std::uint64_t seed = 1;  ///< of the starts after the first
};

/// What is wrong with the question, for the user's eyes: counts, bounds, sd; empty: nothing. calibrate expects that.
std::string mistake(const std::vector<FreeParameter>& free, const Measured& measured);

/// Least squares of residual/sd within the bounds by Levenberg-Marquardt (Marquardt 1963; More 1978 for the scaling):
/// (J^T J + mu D) d = J^T r over the parameters that are not held at a bound, steps cut at the bounds. J by central
/// differences, three-point ones at a bound. Several starts, the best fit counts. `model` gives for each point of
/// parameters one row with the outputs in the order of the measurements; NaN: failed, no step is taken there.
///
/// Covariance (J^T J)^-1, times the variance of the residuals where sd is estimated; interval value +- q standard
/// errors with q of the normal law where sd is given, of Student's with `freedom` where it is estimated. These are of
/// the model linearised at the fit. A parameter is not identifiable where a null direction of J holds it (least
/// eigenvalue below 1e-9 with columns of unit length), where no output depends on it, or where its standard error is
/// above half its range.
Calibration calibrate(const Evaluate& model, const std::vector<FreeParameter>& free, const Measured& measured,
                      const CalibrationOptions& options = {});

}  // namespace taut::chance
