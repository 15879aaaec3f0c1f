#!/usr/bin/python3
"""The witness of taut/chance: OpenTURNS (Debian's python3-openturns 1.20) calculates the cases of
taut/chance/reliability/witness_test.cpp, by its own FORM, SORM and importance sampling, and values of distributions.

  chance_numbers.py          recalculates everything and compares it with chance_numbers.csv beside it (exit code 1: differs)
  chance_numbers.py --write  writes chance_numbers.csv

It is no part of ./dev test, which reads the stored numbers.
"""
import csv
import pathlib
import sys

import openturns as ot

STORED = pathlib.Path(__file__).with_name("chance_numbers.csv")
SAMPLES = 2_000_000


def lognormal(mean, sd):
    return ot.LogNormalMuSigma(mean, sd, 0).getDistribution()


def gumbel(mode, scale):
    return ot.Gumbel(scale, mode)


def correlated(size, pairs):
    matrix = ot.CorrelationMatrix(size)
    for i, j, r in pairs:
        matrix[i, j] = r
    return ot.NormalCopula(matrix)


# name: inputs, copula, output, limit (output < limit fails), starts in scores
CASES = {
    "worked": ([lognormal(400, 16), ot.Normal(25, 3), ot.Normal(0.06, 0.004), gumbel(1.05, 0.03)], None,
               "x0/(x3*x1/(4*x2))", 3, [[0, 0, 0, 0]]),
    "correlated": ([lognormal(100, 10), ot.Normal(50, 7), ot.WeibullMin(12, 2.5, 0)],
                   correlated(3, [(0, 1, -0.4), (1, 2, 0.6)]), "x0 - x1 - x2", 0, [[0, 0, 0]]),
    "curved": ([ot.Normal(0, 1)] * 3, None, "2 + 0.4*x1*x1 - 0.1*x2*x2 + 0.2*x1*x2 - x0", 0, [[0, 0, 0]]),
    "two_points": ([ot.Normal(0, 1)] * 2, None, "(x0 + 2.5)*(3 - x0) + 0.4*x1", 0, [[2, 0], [-2, 0]]),
    "rare": ([lognormal(10, 0.7), ot.Normal(5, 0.7), ot.Uniform(0.9, 1.1)], None, "x0 - x1*x2", 0, [[0, 0, 0]]),
    "gumbel": ([ot.Normal(20, 0.5), gumbel(5, 2), ot.Normal(1, 0.02)], None, "x0*x2 - x1", 0, [[0, 0, 0]]),
}

# Their values at these scores, lower tail to upper.
DISTRIBUTIONS = {
    "lognormal": lognormal(400, 16),
    "gumbel": gumbel(1.5, 0.2),
    "weibull": ot.WeibullMin(3, 1.7, 0.5),
    "triangular": ot.Triangular(1, 2, 5),
    "normal_cut": ot.TruncatedDistribution(ot.Normal(20, 1.2), 18.0, 25.0),
    "gumbel_cut": ot.TruncatedDistribution(gumbel(1.5, 0.2), 1.0, 2.5),
}
SCORES = [-5, -2, -0.5, 0, 1, 2.5, 4.5]


def reached(event, start):
    """FORM and SORM from a start in scores: the solver's tolerances are those of tight agreement, not of habit."""
    solver = ot.AbdoRackwitz()
    solver.setMaximumIterationNumber(1000)
    for tolerance in ("AbsoluteError", "RelativeError", "ResidualError", "ConstraintError"):
        getattr(solver, f"setMaximum{tolerance}")(1e-9)
    inputs = event.getAntecedent().getDistribution()
    algorithm = ot.SORM(solver, event, inputs.getInverseIsoProbabilisticTransformation()(start))
    algorithm.run()
    return algorithm.getResult()


def rows():
    for name, (marginals, copula, output, limit, starts) in CASES.items():
        inputs = ot.ComposedDistribution(marginals, copula or ot.IndependentCopula(len(marginals)))
        model = ot.SymbolicFunction([f"x{i}" for i in range(len(marginals))], [output])
        event = ot.ThresholdEvent(ot.CompositeRandomVector(model, ot.RandomVector(inputs)), ot.Less(), float(limit))
        centres = []
        for k, start in enumerate(starts):
            result = reached(event, start)
            point = result.getStandardSpaceDesignPoint()
            centres.append(ot.Normal(point, [1.0] * len(point), ot.CorrelationMatrix(len(point))))
            yield name, f"beta_{k}", result.getHasoferReliabilityIndex()
            yield name, f"breitung_{k}", result.getEventProbabilityBreitung()
            for i, x in enumerate(result.getPhysicalSpaceDesignPoint()):
                yield name, f"design_{k}_{i}", x
        ot.RandomGenerator.SetSeed(1)
        experiment = ot.ImportanceSamplingExperiment(ot.Mixture(centres))
        sampling = ot.ProbabilitySimulationAlgorithm(ot.StandardEvent(event), experiment)
        sampling.setBlockSize(20_000)
        sampling.setMaximumOuterSampling(SAMPLES // 20_000)
        sampling.setMaximumCoefficientOfVariation(0)
        sampling.run()
        yield name, "probability", sampling.getResult().getProbabilityEstimate()
        yield name, "standard_error", sampling.getResult().getStandardDeviation()
    for name, law in DISTRIBUTIONS.items():
        yield f"law_{name}", "mean", law.getMean()[0]
        yield f"law_{name}", "sd", law.getStandardDeviation()[0]
        for z in SCORES:
            tail = ot.Normal().computeCDF(-abs(z))
            yield f"law_{name}", f"at_{z}", law.computeScalarQuantile(tail, z > 0)


def main():
    fresh = [(case, key, f"{value:.10g}") for case, key, value in rows()]
    if "--write" in sys.argv[1:]:
        with STORED.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(("case", "key", "value"))
            writer.writerows(fresh)
        return 0
    with STORED.open(encoding="utf-8") as file:
        stored = {(case, key): float(value) for case, key, value in list(csv.reader(file))[1:]}
    wrong = [(case, key, stored.get((case, key)), value) for case, key, value in fresh
             if abs(float(value) - stored.get((case, key), float("inf"))) > 1e-6 * abs(float(value))]
    for line in wrong:
        print("differs from what is stored:", *line)
    print(f"OpenTURNS {ot.__version__}: {len(fresh)} numbers, {len(wrong)} differ")
    return 1 if wrong or len(fresh) != len(stored) else 0


if __name__ == "__main__":
    sys.exit(main())
