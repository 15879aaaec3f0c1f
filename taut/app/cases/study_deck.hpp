#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"

/// The block `study:` of a deck. Quantities are texts here: their unit is that of the number which they belong to.
namespace taut::app {

/// A law by its mean and its standard deviation, `sd` or `cov` (sd/mean).
struct MeanRequest {
  std::string mean;
  std::optional<std::string> sd, cov;
  static const Description& describe();
};

struct UniformRequest {
  std::string low, high;
  static const Description& describe();
};

struct GumbelRequest {
  std::string mode, scale;
  static const Description& describe();
};

struct WeibullRequest {
  double shape = 1;
  std::string scale;
  std::optional<std::string> shift;
  static const Description& describe();
};

struct TriangularRequest {
  std::string low, mode, high;
  static const Description& describe();
};

/// How one number of the deck varies: one law, a list of values, or equal steps.
struct VaryRequest {
  std::string name;  ///< path of that number
  std::optional<MeanRequest> normal, lognormal;
  std::optional<UniformRequest> uniform;
  std::optional<GumbelRequest> gumbel;
  std::optional<WeibullRequest> weibull;
  std::optional<TriangularRequest> triangular;
  std::vector<std::string> list;  ///< single values
  std::vector<double> weights;    ///< of the list's values; empty: all alike
  std::optional<std::string> from, to;
  std::optional<int> steps;
  std::vector<std::string> truncate;  ///< [least, largest]
  static const Description& describe();
};

/// [first path, second path, correlation of their Gaussian scores].
struct CorrelateRequest {
  std::vector<std::string> pair;
  static const Description& describe();
};

/// What an output must keep, and how probable it may be that it does not.
struct LimitRequest {
  std::string name;  ///< of the output
  std::optional<std::string> at_least, at_most;
  std::optional<double> allowed;
  static const Description& describe();
};

enum class StudyPoints { random, latin, sobol, grid };

struct StudyRequest {
  std::vector<VaryRequest> vary;
  std::vector<CorrelateRequest> correlate;
  std::vector<std::string> of;
  std::vector<LimitRequest> limit;
  StudyPoints points = StudyPoints::sobol;
  std::vector<std::string> answer = {"quantiles"};
  int samples = 10000;
  int seed = 1;
  double confidence = 0.95;
  static const Description& describe();
};

/// A number of the deck that is sought, between two bounds.
struct FreeRequest {
  std::string name;                ///< its path
  std::vector<std::string> range;  ///< [least, largest]
  static const Description& describe();
};

/// What was measured: a CSV file beside the deck.
struct MeasuredRequest {
  std::string file;
  static const Description& describe();
};

struct CalibrateRequest {
  std::vector<FreeRequest> free;
  MeasuredRequest measured;
  int seed = 1;
  double confidence = 0.95;
  static const Description& describe();
};

}  // namespace taut::app
