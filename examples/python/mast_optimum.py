# %% [markdown]
# # The best anchors of a guyed mast, by scipy
# Two anchors stand behind the mast of a tractor yarder. How far behind, and with which tension of the guys, is the
# largest utilisation of mast and guys least? The deck judges by its rules; scipy only turns the numbers.

# %%
import numpy as np
from scipy.optimize import differential_evolution

import taut

DECK = "../design/yarder_mast.yaml"
PATHS = ["machine.points.stump1[0]", "machine.points.stump2[0]",
         "machine.guys.guy1.install.tension", "machine.guys.guy2.install.tension"]
CHECKS = ["mast.allowable_stress", "mast.top_stiffness", "guy1.guy_safety", "guy2.guy_safety",
          "guy1.pretension_max", "guy2.pretension_max", "guy1.pretension_min", "guy2.pretension_min"]
judged = taut.cases(DECK, PATHS, [f"checks.{name}.utilisation" for name in CHECKS])


def worst(free: taut.Floats) -> float:
    """Largest utilisation, for the distance of the anchors [m] and the tension of the guys [kN]."""
    distance, tension = free
    row = judged([-distance, -distance, 1e3 * tension, 1e3 * tension], threads=1)
    return float(np.max(row)) if np.isfinite(row).all() else 10.0


print(f"as it is: {worst(np.array([11.0, 25.0])):.3f}")

# %%
best = differential_evolution(worst, [(8.0, 16.0), (18.0, 36.0)], seed=1, popsize=5, maxiter=6, polish=False)
distance, tension = best.x
print(f"anchors {distance:.2f} m behind the mast, guys {tension:.1f} kN: {best.fun:.3f} after {best.nfev} machines")

# %% [markdown]
# The whole report of the optimum, to be signed:

# %%
machine = taut.Machine(DECK)
for path, value in zip(PATHS, (-distance, -distance, 1e3 * tension, 1e3 * tension)):
    machine.set(path, float(value))
result = machine.run()
print(result.verdict, result.verdict_reason)
result
