# %% [markdown]
# # First-order reliability: OpenTURNS beside taut
# How probable is it that the factor of the three-span skyline falls below 3? The deck of the study has the laws; here
# OpenTURNS has the same ones and asks the same machine.

# %%
import openturns as ot

import taut

DECK = "../study/three_span_chance.yaml"
PATHS = ["machine.ropes.skyline.stiffness", "machine.reevings.skyline.length", "machine.loads[0].mass",
         "machine.temperature"]
OF = "equilibrium.skyline.safety_factor"
cases = taut.cases(DECK, PATHS, [OF])

# %%
stiffness = ot.TruncatedDistribution(ot.Normal(20e6, 0.06 * 20e6), 15e6, 25e6)
laws = ot.ComposedDistribution([stiffness, ot.Normal(382.0, 0.3), ot.Gumbel(250.0, 2200.0),
                                ot.Uniform(258.15, 303.15)])
factor = ot.CompositeRandomVector(ot.PythonFunction(4, 1, func_sample=lambda x: cases(x)), ot.RandomVector(laws))
form = ot.FORM(ot.Cobyla(), ot.ThresholdEvent(factor, ot.Less(), 3.0), laws.getMean())
form.run()
theirs = form.getResult()
print(f"OpenTURNS: beta {theirs.getHasoferReliabilityIndex():.4f}, p {theirs.getEventProbability():.4g}")

# %%
asked = {"study.samples": 256, "study.of": [OF], "study.limit": {OF: {"at_least": 3.0, "allowed": 1e-2}},
         "study.answer": ["form"]}
ours = taut.study(DECK, asked)
print(f"taut:      beta {float(ours.values['beta']):.4f}, p {float(ours.values['p_form']):.4g}")
ours.tables["design_point"]

# %%
assert abs(ours.values["beta"] - theirs.getHasoferReliabilityIndex()) < 0.01
