# %% [markdown]
# # A rope of a telescopic boom breaks
# The extension rope breaks at 1 s: section 3 jerks inwards. The motion is an array over time.

# %%
import matplotlib.pyplot as plt

import taut

boom = taut.Machine("../telescopic_boom/break_extension_17_load.yaml")
result = boom.motion(duration="4 s", output_step=0.01, tolerance=1e-4, start="settled")
time = result.series["time"]
print(len(time), "states;", result.message or result.status)

# %%
figure, (above, below) = plt.subplots(2, 1, figsize=(7, 5), sharex=True, layout="constrained")
for rope in ("extension", "retraction", "slings"):
    above.plot(time["t"], time.numbers(f"{rope}.T_max") / 1e3, label=rope)
above.set_ylabel("largest tension [kN]")
above.legend()
below.plot(time["t"], time.numbers("out"))
below.set_ylabel("section 3 over section 2 [m]")
below.set_xlabel("time [s]")
plt.show()

# %%
print(f"largest tension of the slings: {result.values['slings.T_max_max'].to('kN'):.1f} kN")
