# %% [markdown]
# # The length and the stiffness of a skyline from measured tensions
# taut fits them itself; scipy's least squares on the same function gives the same numbers.

# %%
import csv

import numpy as np
from scipy.optimize import least_squares

import taut

DECK = "../study/calibrated_line.yaml"
found = taut.calibrate(DECK)
LENGTH, STIFFNESS = "machine.reevings.skyline.length", "machine.ropes.skyline.stiffness"
print(found.values.to_pandas()[["value", "unit"]])

# %%
with open("../study/calibrated_line.csv", encoding="utf-8") as file:
    measured = list(csv.DictReader(file))
MORE = ["machine.reevings.mainline.length", "machine.loads[0].mass"]
states = np.array([[taut.si(row[path]) for path in MORE] for row in measured])
tension = np.array([taut.si(row["value"]) for row in measured])
sd = np.array([taut.si(row["sd"]) for row in measured])
line = taut.cases(DECK, [LENGTH, STIFFNESS, *MORE], ["equilibrium.skyline.T_start"])


def residuals(free: taut.Floats) -> taut.Floats:
    """Calculated less measured tension in standard deviations; free: length [m], stiffness [MN]."""
    rows = np.column_stack([np.full(len(states), free[0]), np.full(len(states), 1e6 * free[1]), states])
    return np.asarray((line(rows)[:, 0] - tension) / sd, dtype=np.float64)


fit = least_squares(residuals, [382.0, 20.0], x_scale=[0.1, 3.0], bounds=([380.0, 10.0], [384.0, 30.0]))
print(f"scipy: {fit.x[0]:.3f} m, {fit.x[1]:.2f} MN; taut: {found.values[LENGTH]:.3f} m, "
      f"{found.values[STIFFNESS] / 1e6:.2f} MN")

# %%
assert abs(fit.x[0] - found.values[LENGTH]) < 0.01
