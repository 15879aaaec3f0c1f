#include "taut/app/cases/study_deck.hpp"

namespace taut::app {

const Description& MeanRequest::describe() {
  static const Description d = Describe<MeanRequest>()
                                   .field(&MeanRequest::mean, "mean", "mean value")
                                   .required()
                                   .field(&MeanRequest::sd, "sd", "standard deviation, in the unit of the mean")
                                   .field(&MeanRequest::cov, "cov", "coefficient of variation, sd/mean: '6 %'")
                                   .exactly_one({"sd", "cov"});
  return d;
}

const Description& UniformRequest::describe() {
  static const Description d = Describe<UniformRequest>()
                                   .field(&UniformRequest::low, "low", "least value")
                                   .required()
                                   .field(&UniformRequest::high, "high", "largest value")
                                   .required();
  return d;
}

const Description& GumbelRequest::describe() {
  static const Description d =
      Describe<GumbelRequest>()
          .field(&GumbelRequest::mode, "mode", "most likely value; the mean is mode + 0.5772 scale")
          .required()
          .field(&GumbelRequest::scale, "scale", "scale; the standard deviation is 1.2825 scale")
          .required();
  return d;
}

const Description& WeibullRequest::describe() {
  static const Description d =
      Describe<WeibullRequest>()
          .field(&WeibullRequest::shape, "shape", "k", si::one, "shape: P(X > x) = exp(-((x - shift)/scale)^k)")
          .above(0)
          .required()
          .field(&WeibullRequest::scale, "scale", "scale")
          .required()
          .field(&WeibullRequest::shift, "shift", "least value; 0 where it is not given");
  return d;
}

const Description& TriangularRequest::describe() {
  static const Description d = Describe<TriangularRequest>()
                                   .field(&TriangularRequest::low, "low", "least value")
                                   .required()
                                   .field(&TriangularRequest::mode, "mode", "most likely value")
                                   .required()
                                   .field(&TriangularRequest::high, "high", "largest value")
                                   .required();
  return d;
}

const Description& VaryRequest::describe() {
  static const Description d =
      Describe<VaryRequest>()
          .record(&VaryRequest::normal, "normal", "normal law by mean and sd or cov")
          .record(&VaryRequest::lognormal, "lognormal", "lognormal law; mean and sd are those of the value itself")
          .record(&VaryRequest::uniform, "uniform", "every value from low to high is equally likely")
          .record(&VaryRequest::gumbel, "gumbel", "law of largest values: exp(-exp(-(x - mode)/scale))")
          .record(&VaryRequest::weibull, "weibull", "Weibull law")
          .record(&VaryRequest::triangular, "triangular", "density that rises from low to mode and falls to high")
          .field(&VaryRequest::list, "list", "single values")
          .field(&VaryRequest::weights, "weights", "", si::one, "weight of each value of the list; else all alike")
          .at_least(0)
          .field(&VaryRequest::from, "from", "first of values in equal steps, each as likely as the others")
          .field(&VaryRequest::to, "to", "last value")
          .field(&VaryRequest::steps, "steps", "n", si::one, "number of steps")
          .at_least(1)
          .at_most(10000)
          .field(&VaryRequest::truncate, "truncate", "[least, largest] value: the law is cut there")
          .exactly_one({"normal", "lognormal", "uniform", "gumbel", "weibull", "triangular", "list", "from"});
  return d;
}

const Description& CorrelateRequest::describe() {
  static const Description d =
      Describe<CorrelateRequest>()
          .field(&CorrelateRequest::pair, "pair", "[path, path, correlation of their Gaussian scores]")
          .required();
  return d;
}

const Description& LimitRequest::describe() {
  static const Description d =
      Describe<LimitRequest>()
          .field(&LimitRequest::at_least, "at_least", "the output must not be below")
          .field(&LimitRequest::at_most, "at_most", "the output must not be above")
          .field(&LimitRequest::allowed, "allowed", "p", si::one, "probability beyond the limit that is allowed")
          .above(0)
          .below(1)
          .exactly_one({"at_least", "at_most"});
  return d;
}

const Description& StudyRequest::describe() {
  static const Description d =
      Describe<StudyRequest>()
          .named_records(&StudyRequest::vary, "vary",
                         "how numbers of the deck vary, by their whole path: 'machine.loads[0].mass'")
          .required()
          .record(&StudyRequest::correlate, "correlate", "pairs of inputs that vary together: [path, path, r]")
          .shorthand("pair")
          .field(&StudyRequest::of, "of",
                 "values asked for, by analysis and name: 'equilibrium.skyline.safety_factor'; of a method by name")
          .required()
          .named_records(&StudyRequest::limit, "limit", "limits of some of them")
          .choice(
              &StudyRequest::points, "points",
              {{"random", StudyPoints::random},
               {"lhs", StudyPoints::latin},
               {"sobol", StudyPoints::sobol},
               {"grid", StudyPoints::grid}},
              "where the cases lie: independent random numbers, Latin hypercubes, scrambled Sobol points, or a grid "
              "of lists and steps")
          .field(&StudyRequest::answer, "answer", "what is made of the cases")
          .of({"quantiles", "indices", "tornado", "form", "sorm", "importance"})
          .field(&StudyRequest::samples, "samples", "N", si::one,
                 "number of cases, rounded up to whole replicates; a grid has its own number")
          .at_least(16)
          .at_most(100000000)
          .field(&StudyRequest::seed, "seed", "", si::one, "of the random numbers; the same seed gives the same cases")
          .at_least(0)
          .field(&StudyRequest::confidence, "confidence", "", si::one, "of all intervals, two-sided")
          .above(0.5)
          .below(1);
  return d;
}

const Description& FreeRequest::describe() {
  static const Description d =
      Describe<FreeRequest>().field(&FreeRequest::range, "range", "[least, largest] value that it may have").required();
  return d;
}

const Description& MeasuredRequest::describe() {
  static const Description d =
      Describe<MeasuredRequest>()
          .field(&MeasuredRequest::file, "file",
                 "CSV with the columns output, value, sd (may be empty), and one for each number of the deck that "
                 "differs from row to row, by its path; quantities with their units")
          .required();
  return d;
}

const Description& CalibrateRequest::describe() {
  static const Description d =
      Describe<CalibrateRequest>()
          .named_records(&CalibrateRequest::free, "free", "numbers of the deck that are sought, by their whole path")
          .shorthand("range")
          .required()
          .record(&CalibrateRequest::measured, "measured", "what was measured")
          .shorthand("file")
          .required()
          .field(&CalibrateRequest::seed, "seed", "", si::one, "of the starts of the search")
          .at_least(0)
          .field(&CalibrateRequest::confidence, "confidence", "", si::one, "of the intervals, two-sided")
          .above(0.5)
          .below(1);
  return d;
}

}  // namespace taut::app
