# %% [markdown]
# # How much does a skyline carry, by its length and the height of a jack?
# A deck is a function of its numbers: `taut.cases` reads it once, and each row of an array is one machine.

# %%
import matplotlib.pyplot as plt
import numpy as np

import taut

DECK = "../machines/three_span_skyline.yaml"
PATHS = ["machine.reevings.skyline.length", "machine.supports.jack1.at[2]"]
carries = taut.cases(DECK, PATHS, ["payload.payload_min"])
print(carries, carries.base, carries.of_base, carries.of_units)

# %%
lengths = np.linspace(381.0, 383.0, 7)
heights = np.linspace(32.0, 36.0, 5)
grid = np.array([(length, height) for height in heights for length in lengths])
found, reasons = carries.evaluate(grid)
payload = found[:, 0].reshape(len(heights), len(lengths))
print(f"{np.nanmin(payload):.0f} kg to {np.nanmax(payload):.0f} kg, {len(reasons)} machines without an answer")

# %%
figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
drawn = axes.contourf(lengths, heights, payload / 1e3, 12)
figure.colorbar(drawn, label="least payload along the line [t]")
axes.set_xlabel("unstretched length of the skyline [m]")
axes.set_ylabel("height of jack 1 [m]")
plt.show()
