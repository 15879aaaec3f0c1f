"""Machines in motion, from outside: decks with figures of their own beside formulas.

TAUT_PROGRAM is the program.
"""
import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["TAUT_PROGRAM"]

HANGING = """taut: 1
title: A mass on a rope
machine:
  gravity: 9.7 m/s^2
  points: {top: [0 m, 0 m, 12 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 750 kN}}
  bodies: {hook: {mass: HOOK, at: [0 m, 0 m, 2 m], free: [x, z]}}
  reevings:
    - {rope: hoist, path: [{anchor: top}, {anchor: hook}], length: 10 m}
LOADS
  observe: [hook.z, hook.vz, hoist.T_max]
analyses:
  - modes: {count: 2}
  - transient: {duration: 1 s, output_step: 0.05 s, tolerance: 1e-6, start: assembled}
"""

PULLEY = """taut: 1
title: Two masses over a held pulley, released
machine:
  gravity: 9.81 m/s^2
  ropes: {r: {mass: 0 kg/m, stiffness: 1 MN}}
  bodies:
    light: {mass: 100 kg, at: [SIDE -0.2 m, 0 m, -5 m], free: [z]}
    heavy: {mass: 120 kg, at: [SIDE 0.2 m, 0 m, -5 m], free: [z]}
  sheaves:
    pulley: {at: [0 m, 0 m, 0 m], diameter: 400 mm, inertia: 0.8 kg m^2, motor: {speed: 0 m/s}}
  reevings:
    - {rope: r, path: [{anchor: light}, {over: pulley}, {anchor: heavy}], tension_at_start: 981 N, tension_at_end: 1177.2 N}
  events: [{at: 0 s, drive: pulley, torque: 0 N m}]
  observe: ["r[1].T", "r[2].T"]
analyses:
  - transient: {duration: 1 s, output_step: 0.1 s, tolerance: 1e-7, start: assembled}
"""

HINGE = """taut: 1
title: A body on a hinge falls over from above it
machine:
  gravity: 9.81 m/s^2
  points: {far: [0 m, 0.5 m, 3 m], near: {body: b, at: [0 m, 0 m, 0 m]}}
  bodies: {b: {mass: 800 kg, centre: [2 m, 0 m, 1.5 m], inertia: 900 kg m^2, free: [ry]}}
  ropes: {slack: {mass: 0 kg/m, stiffness: 1 MN}}
  reevings: [{rope: slack, path: [{anchor: far}, {anchor: near}], length: 4 m}]
  signals: {round: {ramp: {to: 800 deg, duration: 2 s, smooth: true}}}
  observe: [b.ry, b.rx, b.wy, turner.rz]
  events: [{when: b.ry > 200 deg, stop: true}]
analyses:
  - transient: {duration: 4 s, output_step: 0.05 s, tolerance: 1e-6, start: assembled}
"""

BREAK = """taut: 1
title: One end of a stretched rope let go, far from any gravity
machine:
  gravity: 0 m/s^2
  points: {a: [0 m, 0 m, 0 m], b: [50.15 m, 0 m, 0 m]}
  ropes: {r: {mass: 2 kg/m, stiffness: 8 MN}}
  reevings:
    - {rope: r, path: [{anchor: a}, {anchor: b}], length: 50 m, segments: 100}
  events: [{at: 0 s, break: r}]
  observe: [r.T_end, energy.kinetic, energy.elastic]
analyses:
  - transient: {duration: 0.03 s, output_step: 5 ms, method: METHOD, tolerance: 1e-4, start: assembled}
"""

BELT = """taut: 1
title: A belt that is driven at once, over an idler without inertia
machine:
  gravity: 9.81 m/s^2
  ropes: {belt: {mass: 0.3 kg/m, stiffness: 200 kN}}
  sheaves:
    drive: {at: [0 m, 0 m, 0 m], diameter: 500 mm, friction: 0.4, motor: {speed: SPEED}}
    idler: {at: [3 m, 0 m, HEIGHT], diameter: 400 mm, efficiency: 0.97}
    guide: {at: [1 m, 0 m, -0.2 m], diameter: 300 mm, efficiency: 0.98}
  reevings:
    - {rope: belt, path: [{over: drive, side: left}, {over: guide, side: right}, {over: idler, side: left}], closed: true, length: LENGTH}
  observe: [idler.T_in, idler.T_out, idler.speed, guide.T_in, guide.T_out, drive.slip]
analyses:
  - equilibrium: {motion: at_rest}
  - transient: {duration: 4 s, output_step: 10 ms, tolerance: 1e-4, start: START}
"""

WINCH = """taut: 1
title: A winch with several layers
machine:
  gravity: 9.81 m/s^2
  ropes: {c: {mass: 0 kg/m, stiffness: 50 MN, diameter: 20 mm, damping_ratio: 0.2}}
  bodies: {a: {mass: 500 kg, at: [0.26 m, 0 m, -40 m], free: [z]}}
  drums:
    w: {at: [0 m, 0 m, 0 m], core_diameter: 500 mm, layers: auto, length_on_drum: 3 m, face_width: 100 mm, drive: {speed: SPEED}}
  reevings:
    - {rope: c, path: [{drum: w, side: left}, {anchor: a}], length: 40 m}
  observe: [w.length, w.torque, a.z]
analyses:
  - transient: {duration: 10 s, output_step: 0.5 s, tolerance: 1e-4}
"""


CLAMPED = """taut: 1
title: A carriage clamped to its rope, which runs over a saddle
machine:
  gravity: 9.81 m/s^2
  points: {a: [0 m, 0 m, 0 m], b: [12 m, 0 m, 1 m]}
  ropes: {q: {mass: 0 kg/m, stiffness: 6 MN, damping_ratio: 0.05}}
  bodies: {}
  supports: {s: {at: [9 m, 0 m, 0.5 m], diameter: 400 mm, friction: 0.05}}
  carriages: {w: {mass: 900 kg, at: [3 m, 1 m, -4 m], rides: whole, hold: clamped, length_before: 5.2 m}}
  reevings:
    - {name: whole, rope: q, path: [{anchor: a}, {through: w}, {over: s}, {anchor: b}], length: 16 m}
  observe: [w.x, w.y, w.z]
analyses:
  - transient: {duration: 1 s, output_step: 0.1 s, tolerance: 1e-7, start: assembled}
"""


ON_BOTH_SIDES = """taut: 1
title: Two ropes on one drum
machine:
  gravity: 9.81 m/s^2
  bodies:
    a: {mass: 300 kg, at: [-0.3 m, 0 m, -8 m], free: [z]}
    b: {mass: 200 kg, at: [PLACE 0.3 m, 0 m, -8 m], free: [z]}
  drums: {dr: {at: [0 m, 0 m, 0 m], core_diameter: 600 mm, inertia: 15 kg m^2, drive: {brake: open}}}
  ropes: {q: {mass: 0 kg/m, stiffness: 50 MN, damping_time: 1 ms}}
  reevings:
    - {name: ra, rope: q, path: [{drum: dr, side: left}, {anchor: a}], length: 8 m}
    - {name: rb, rope: q, path: PATH, length: 8 m}
  observe: [a.vz, b.vz, dr.speed]
analyses:
  - transient: {duration: 1 s, output_step: 0.1 s, tolerance: 1e-6, start: assembled}
"""


class Laws(unittest.TestCase):
    def run_deck(self, deck, expected=0):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([PROGRAM, "run", "-", "-o", folder, "-q"], input=deck, capture_output=True, text=True,
                                  check=False)
            self.assertEqual(done.returncode, expected, done.stderr)
            with open(pathlib.Path(folder) / "time.csv", encoding="utf-8", newline="") as file:
                rows = list(csv.reader(file))
            result = json.loads((pathlib.Path(folder) / "result.json").read_text())
        names = [name.split(" [")[0] for name in rows[0]]
        result["rows"] = [dict(zip(names, map(float, row))) for row in rows[1:]]
        return result

    def test_a_load_has_the_inertia_of_its_mass(self):
        whole = self.run_deck(HANGING.replace("HOOK", "800 kg").replace("LOADS\n", ""))
        hung = self.run_deck(HANGING.replace("HOOK", "150 kg").replace("LOADS", "  loads: [{at: hook, mass: 650 kg}]"))
        bare = self.run_deck(HANGING.replace("mass: HOOK, ", "").replace("LOADS", "  loads: [{at: hook, mass: 0.8 t}]"))
        stretched = math.sqrt(750e3 / 10 / 800) / (2 * math.pi)
        for r in (whole, hung, bare):
            self.assertAlmostEqual(r["values"]["frequency_2"]["value"], stretched, delta=1e-6)
            # it falls from the unstretched rope: twice the weight at the lowest place
            self.assertAlmostEqual(r["values"]["hoist.T_max_max"]["value"], 2 * 800 * 9.7, delta=0.1)
            for a, b in zip(r["rows"], whole["rows"]):
                self.assertAlmostEqual(a["hook.z"], b["hook.z"], delta=1e-7)

    def test_a_pulley_is_released(self):
        for side in ("", "-"):
            deck = PULLEY.replace("SIDE -", side + "-").replace("SIDE ", side).replace("--", "")
            rows = self.run_deck(deck.replace("start: assembled", "start: assembled, arcs: rigid"))["rows"]
            for i, T1, T2 in ((0, 981, 1177.2), (1, 1113.734318, 1021.676961), (5, 1045.907490, 1080.440868),
                              (10, 1155.896844, 1008.819138)):
                self.assertAlmostEqual(rows[i]["r[1].T"] / T1, 1, delta=1e-6, msg=f"{side} {i}")
                self.assertAlmostEqual(rows[i]["r[2].T"] / T2, 1, delta=1e-6, msg=f"{side} {i}")
            # each leg with half of the rope on the sheave; by Runge-Kutta of order 4 in 1e5 steps
            rows = self.run_deck(deck)["rows"]
            for i, T1, T2 in ((0, 981, 1177.2), (1, 1076.409002, 1056.317451), (5, 1138.071755, 1002.164877),
                              (10, 1003.238647, 1115.915852)):
                self.assertAlmostEqual(rows[i]["r[1].T"] / T1, 1, delta=2e-6, msg=f"{side} {i}")
                self.assertAlmostEqual(rows[i]["r[2].T"] / T2, 1, delta=2e-6, msg=f"{side} {i}")

    def test_a_rope_let_go_at_the_start(self):
        EA, mass, length = 8e6, 2, 50
        T = EA * 0.003
        for method in ("verlet", "implicit"):
            r = self.run_deck(BREAK.replace("METHOD", method))
            events = [dict(zip([c["name"] for c in r["tables"]["events"]["columns"]], row))
                      for row in r["tables"]["events"]["rows"]]
            self.assertEqual((events[0]["t"], events[0]["what"], events[0]["where"]), (0, "break", "r: a - b (1)"))
            through = length / math.sqrt(EA / mass)  # 25 ms: all of it runs, without tension
            self.assertLess(r["rows"][6]["r.T_end"], 0.01 * T)
            recoil = T / math.sqrt(EA * mass)
            whole = 0.99 * mass * length * recoil**2 / 2  # the piece that breaks takes its strain with it
            self.assertAlmostEqual(r["rows"][6]["energy.kinetic"], whole, delta=2e-3 * whole)
            self.assertLess(through, 0.03)

    def test_a_belt_that_is_driven_at_once(self):
        for speed in (8, 1.5, -8):
            for start in ("settled", "assembled"):
                deck = BELT.replace("SPEED", f"{speed} m/s").replace("START", start)
                deck = deck.replace("HEIGHT", "0.2 m").replace("LENGTH", "7.4 m")
                r = self.run_deck(deck)
                of = f"{speed} m/s, {start}"
                self.assertLess(abs(r["values"]["energy_residual"]["value"]), 1e-5, of)
                if start == "settled":  # straight, the rope has next to no sag here: the statics' tension
                    sheaves = r["tables"]["sheaves"]
                    column = [c["name"] for c in sheaves["columns"]].index("T_in")
                    at_rest = next(row[column] for row in sheaves["rows"] if row[0] == "idler")
                    self.assertAlmostEqual(r["rows"][0]["idler.T_in"] / at_rest, 1, delta=1e-3, msg=of)
                for row in r["rows"][10:]:
                    self.assertAlmostEqual(row["idler.speed"] / speed, 1, delta=0.01, msg=of)
                    for sheave, eta in (("idler", 0.97), ("guide", 0.98)):
                        behind, before = row[f"{sheave}.T_out"], row[f"{sheave}.T_in"]
                        if speed < 0:
                            behind, before = before, behind
                        thrust = 0.3 * speed**2 * behind / before  # by the flow per unstretched metre, to 1 %
                        self.assertAlmostEqual((before - thrust) / (behind - thrust) / eta, 1, delta=1e-3, msg=of)

    def test_a_drum_winds_layers_and_runs_out(self):
        r = self.run_deck(WINCH.replace("SPEED", "2 m/s"))
        times = [row[0] for row in r["tables"]["events"]["rows"] if row[1] == "layer"]
        filled = 0
        for k, t in enumerate(times, 1):  # five turns each, at the middle of the rope
            filled += 5 * 2 * math.pi * (0.25 + (k - 0.5) * 0.02)
            self.assertAlmostEqual(t, (filled - 3) / 2, delta=2e-3)
        self.assertEqual(len(times), 2)
        r = self.run_deck(WINCH.replace("SPEED", "-2 m/s"), expected=3)
        self.assertIn("no rope is left on the drum 'w'", r["message"])
        self.assertAlmostEqual(r["rows"][-1]["t"], 1.5, delta=2e-3)

    def test_a_hinge_turns_as_far_as_it_turns(self):
        turner = "{turner: {at: [9 m, 0 m, 0 m], motion: {rz: round}}, b: {"
        deck = HINGE.replace("bodies: {b: {", "bodies: " + turner)
        r = self.run_deck(deck)
        arm, angle, rate, h = math.atan2(2, 1.5), 0.0, 0.0, 1e-4
        steps = {round(row["t"] / h): row for row in r["rows"][:-1]}
        for k in range(max(steps) + 1):  # semi-implicit, at half steps: second order
            if k in steps:
                self.assertAlmostEqual(steps[k]["b.ry"], angle, delta=1e-5)
                self.assertAlmostEqual(steps[k]["b.rx"], 0, delta=1e-9)
            rate += (h / 2 if k == 0 else h) * 800 * 9.81 * 2.5 * math.sin(arm + angle) / (900 + 800 * 2.5**2)
            angle += h * rate
        self.assertAlmostEqual(r["rows"][-1]["b.ry"], math.radians(200), delta=1e-6)  # the event's
        self.assertGreater(r["rows"][-1]["b.wy"], 0)
        slewed = self.run_deck(deck.replace("200 deg", "900 deg").replace("duration: 4 s", "duration: 2.5 s"))
        self.assertAlmostEqual(slewed["rows"][-1]["turner.rz"], math.radians(800), delta=1e-9)

    def test_all_modes_of_sagging_ropes_are_drawn(self):
        source = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples" / "motion" / "longspan_sag.yaml"
        done = subprocess.run([PROGRAM, "run", str(source), "-q", "--json", "--set", "analyses[1].modes.count=20",
                               "--set", "analyses[0].transient.duration=0.1 s"], capture_output=True, text=True,
                              check=False)
        self.assertIn(done.returncode, (0, 4), done.stderr)
        self.assertIn("damping_6", json.loads(done.stdout)["values"])

    def test_ropes_on_both_sides_of_a_drum(self):
        for place, path, b in (("", "[{drum: dr, side: right}, {anchor: b}]", -1),
                               ("", "[{anchor: b}, {drum: dr, side: left}]", -1),  # the other way along its path
                               ("-", "[{drum: dr, side: left}, {anchor: b}]", 1)):
            r = self.run_deck(ON_BOTH_SIDES.replace("PLACE ", place).replace("PATH", path))
            speed = -(300 + b * 200) * 9.81 / (500 + 15 / 0.3**2)
            last = r["rows"][-1]
            self.assertAlmostEqual(last["a.vz"], speed, delta=1e-3)
            self.assertAlmostEqual(last["b.vz"], b * speed, delta=1e-3)
            self.assertAlmostEqual(last["dr.speed"], speed, delta=1e-3)
            self.assertLess(abs(r["values"]["energy_residual"]["value"]), 1e-6)

    def test_a_clamped_carriage_is_where_its_rope_is_clamped(self):
        one = self.run_deck(CLAMPED.replace("  bodies: {}\n", ""))["rows"]
        lines = CLAMPED.replace("bodies: {}", "bodies: {w: {mass: 900 kg, at: [3 m, 1 m, -4 m], free: [x, y, z]}}").splitlines()
        deck = "\n".join(line for line in lines if not line.startswith("  carriages:"))
        cut = "name: before, rope: q, path: [{anchor: a}, {anchor: w}], length: 5.2 m}\n    - {name: behind"
        deck = deck.replace("name: whole", cut).replace("{anchor: a}, {through: w}, {over", "{anchor: w}, {over")
        two = self.run_deck(deck.replace("length: 16 m", "length: 10.8 m"))["rows"]
        for a, b in zip(one, two, strict=True):
            for name in ("w.x", "w.y", "w.z"):
                self.assertAlmostEqual(a[name], b[name], delta=1e-6)

    def test_what_does_not_happen_is_told(self):
        deck = HANGING.replace("HOOK", "150 kg").replace(
            "LOADS", "  events: [{at: 3 s, break: hoist}, {when: hook.z > 11 m, stop: true}]")
        reported = self.run_deck(deck)
        self.assertEqual(reported["warnings"],
                         ["transient: 'break hoist' at 3 s does not happen: the motion ends at 1 s"])
        begun = self.run_deck(deck.replace("hook.z > 11 m", "hook.z > 1 m"))
        self.assertEqual(begun["rows"][-1]["t"], 0)

    def test_what_is_dissipated_has_all_that_the_ledger_names(self):
        source = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples" / "motion" / "yarder_pickup.yaml"  # its ropes go slack
        names = ("kinetic", "elastic", "potential", "supplied", "dissipated", "residual")
        lines = source.read_text(encoding="utf-8").splitlines()
        observe = "  observe: [" + ", ".join("energy." + name for name in names) + "]"
        deck = "\n".join(observe if line.startswith("  observe:") else line for line in lines)
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([PROGRAM, "run", "-", "-o", folder, "-q"], input=deck, capture_output=True, text=True,
                                  check=False)
            self.assertIn(done.returncode, (0, 4), done.stderr)
            with open(pathlib.Path(folder) / "time.csv", encoding="utf-8", newline="") as file:
                rows = [[float(x) for x in row] for row in list(csv.reader(file))[1:]]
        start = sum(rows[0][1:4])
        for _, kinetic, elastic, potential, supplied, dissipated, residual in rows:
            self.assertAlmostEqual(kinetic + elastic + potential - start - supplied + dissipated, residual, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
