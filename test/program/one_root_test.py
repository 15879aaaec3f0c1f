"""Ropes of given tension are taut, and sheaves take their side from the answer, whatever the first guess.

TAUT_PROGRAM is the program.
"""
import json
import os
import subprocess
import unittest

PROGRAM = os.environ["TAUT_PROGRAM"]
FEWER = "TAUT_FEWER" in os.environ  # under the sanitizers

HOOK = """taut: 1
title: A hook on a sling, helped by a rope of given tension over a sheave
machine:
  points: {pin: [0.1 m, 0 m, 13.5 m], hang: [0 m, 0 m, 16 m]}
  ropes:
    hoist: {mass: 0.84 kg/m, stiffness: 5.1 MN, breaking_force: 185 kN}
    sling: {mass: 0.98 kg/m, stiffness: 12 MN, breaking_force: 216 kN}
  bodies: {hook: {mass: 10 t, at: [X m, 0 m, Z m], free: [x, z]}}
  sheaves:
    head: {at: [0 m, 0 m, 14 m], diameter: D mm, efficiency: ETA}
    block: {body: hook, at: [0 m, 0 m, 0 m], diameter: D mm, efficiency: ETA}
  drums: {winch: {at: [7.5 m, 0 m, 4 m]}}
  reevings:
    - {rope: sling, path: [{anchor: hang}, {anchor: hook}], length: 6.77 m}
    - {rope: hoist, path: [PATH], haul: to_start, GIVEN}
analyses:
  - ANALYSIS
"""
SINGLE = "{drum: winch}, {over: head}, {anchor: hook}"
TACKLE = "{drum: winch}, {over: head, parts: 4, between: [head, block]}, {anchor: pin}"

SKYLINE = """taut: 1
title: A carriage that rolls on a skyline of given tension
machine:
  points: {A: [0 m, 0 m, 10 m], B: [409 m, 0 m, 148 m]}
  ropes: {sky: {mass: 0.866 kg/m, stiffness: 11.4 MN, breaking_force: 190 kN}}
  supports: {S1: {at: [138 m, 0 m, 70 m], diameter: 0.4 m, efficiency: 0.94, law: sheave, uplift: hold}}
  carriages: {car: {mass: 900 kg, rides: sky, at: [49 m, 0 m, Z m]}}
  reevings:
    - {rope: sky, path: [{anchor: A}, {through: car}, {over: S1}, {anchor: B}], haul: to_end, copies: 3, GIVEN}
analyses:
  - ANALYSIS
"""

SIDE = """taut: 1
title: A line over a sheave whose side nobody gives
machine:
  points: {A: [0 m, 0 m, 10 m], B: [412 m, 0 m, -119.5 m], winch: [0 m, 0 m, 8 m]}
  ropes:
    sky: {mass: 0.36 kg/m, stiffness: 3.1 MN, breaking_force: 80 kN}
    main: {mass: 0.5 kg/m, stiffness: 4.6 MN, breaking_force: 110 kN}
  supports:
    S1: {at: [106.7 m, 0 m, -7.15 m], diameter: 1 m, efficiency: 0.92, law: sheave, uplift: hold}
    S2: {at: [197.8 m, 0 m, -12.33 m], diameter: 1 m, efficiency: 0.98, law: sheave, uplift: hold}
  carriages: {car: {mass: 230 kg, rides: sky, mainline: main, at: [61.8 m, 0 m, Z m]}}
  reevings:
    - {rope: sky, path: [{anchor: A}, {through: car}, {over: S1}, {over: S2}, {anchor: B}], length: 440.3 m}
    - {rope: main, path: [{anchor: winch}, {anchor: car}], length: 62.45 m}
analyses:
  - ANALYSIS
"""

PAYLOAD = """taut: 1
title: A skyline of given tension that runs out under too much
machine:
  points: {A: [0 m, 0 m, 10 m], B: [566 m, 0 m, 246 m], winch: [566 m, 0 m, 244 m]}
  ropes:
    sky: {mass: 0.726 kg/m, stiffness: 8.26 MN, breaking_force: 160 kN}
    main: {mass: 0.938 kg/m, stiffness: 7.1 MN, breaking_force: 206 kN}
  supports:
    S2: {at: [191.5 m, 0 m, 139 m], diameter: 0.4 m, friction: 0.0716, law: saddle, uplift: hold}
    S3: {at: [420.6 m, 0 m, 226 m], diameter: 0 m, friction: 0.173, law: saddle, uplift: hold}
  reevings:
    - rope: sky
      path: [anchor: A, over: S2, over: S3, through: car, anchor: B]
      haul: to_start
      tension_at_end: 24.45 kN
    - {rope: main, path: [anchor: winch, anchor: car], length: 52.87 m}
  carriages:
    car: {mass: 100 kg, rides: sky, hold: rolling, friction: 0.0165, at: [513 m, 0 m, 233 m], mainline: main}
  loads: [{at: car, mass: 414 kg}]
analyses:
  - payload: {carriage: car, from: FROM m, to: 521 m, steps: STEPS, motion: in, limits: {sky: {tension: 34.5 kN}}}
"""


def deck(text, **values):
    for key, value in sorted(values.items(), key=lambda item: -len(item[0])):
        text = text.replace(key, str(value))
    return text


def run(text):
    done = subprocess.run([PROGRAM, "run", "-", "--json"], input=text, capture_output=True, text=True, check=False)
    return done.returncode, json.loads(done.stdout)


def values_of(result):
    return {key: entry["value"] for key, entry in result["values"].items()}


def rows(result, table):
    names = [column["name"] for column in result["tables"][table]["columns"]]
    return [dict(zip(names, row)) for row in result["tables"][table]["rows"]]


class OneRoot(unittest.TestCase):
    def same(self, decks, keys):
        first = None
        for text in decks:
            code, result = run(text)
            self.assertIn(code, (0, 4), text + str(result.get("message")))
            now = values_of(result)
            first = first or now
            for key in keys:
                self.assertAlmostEqual(now[key] / first[key], 1, delta=1e-7, msg=key + "\n" + text)
        return first

    def test_a_hook_is_found_from_any_first_guess(self):
        for path, given in ((SINGLE, "tension_at_start: 7.4 kN"), (TACKLE, "tension_at_start: 2.5 kN"),
                            (TACKLE, "tension_at_end: 4 kN")):
            for eta, motion in ((0.9, "hoist"),) if FEWER else ((1, "at_rest"), (0.9, "lower"), (0.9, "hoist")):
                common = {"PATH": path, "GIVEN": given, "ETA": eta, "ANALYSIS": "equilibrium: {motion: %s}" % motion, "D": 300}
                guesses = [deck(HOOK, X=x, Z=z, **common) for x, z in ((0, 9.2), (0, 3), (0, 8.8), (0.3, 9.5))]
                found = self.same(guesses, ("sling.T_max", "hoist.unstretched", "hook.z"))
                self.assertLess(found["hoist.unstretched"], 60)

    def test_a_motion_begins_taut(self):
        for z in (8.8, 9.11, 9.3):
            code, result = run(deck(HOOK, X=0, Z=z, ETA=1, D=0, PATH=SINGLE, GIVEN="tension_at_start: 7.4 kN",
                                    ANALYSIS="transient: {duration: 0.02 s, output_step: 0.01 s}"))
            self.assertEqual(code, 0, result["message"])
            self.assertLess(values_of(result)["T_max"], 95e3)

    def test_a_skyline_of_given_tension_is_that_of_its_length_or_refused(self):
        code, result = run(deck(SKYLINE, Z=26, GIVEN="tension_at_start: 4800 N", ANALYSIS="equilibrium: {motion: in}"))
        if code in (0, 4):
            self.assertGreater(values_of(result)["car.z"], 0)
        else:
            self.assertEqual(code, 3)
            self.assertIn("sky", result["message"])

    def test_a_load_path_keeps_to_it(self):
        analysis = "load_path: {carriage: car, from: 20 m, to: 130 m, steps: 11, motion: in, held: true}"
        heights = None
        for z in (-250, 20, 60):
            code, result = run(deck(SKYLINE, Z=z, GIVEN="tension_at_start: 12 kN", ANALYSIS=analysis))
            self.assertIn(code, (0, 4), result["message"])
            now = [row["z"] for row in rows(result, "load_path")]
            heights = heights or now
            for one, other in zip(now, heights):
                self.assertAlmostEqual(one, other, delta=1e-4)
            self.assertGreater(min(now), -30)

    def test_a_sweep_ends_at_the_least_pull(self):
        analysis = 'sweep: {parameter: "reevings.sky.tension_at_start", from: 12 kN, to: 0.2 kN, steps: 8, carriage: car, x: 60 m}'
        code, result = run(deck(SKYLINE, Z=20, GIVEN="tension_at_start: 12 kN", ANALYSIS=analysis))
        self.assertIn(code, (0, 3, 4))
        for row in rows(result, "sweep") if "sweep" in result["tables"] else []:
            self.assertLess(row.get("sky.unstretched", 0), 700)

    def test_a_side_follows_from_the_answer(self):
        for analysis in ("equilibrium: {carriage: car, x: 61.76 m}", "equilibrium: {motion: in, carriage: car, x: 61.76 m}",
                         "load_path: {carriage: car, from: 30 m, to: 100 m, steps: 7}"):
            first = None
            for z in (-40, 5) if FEWER else (-40, -6, -4.2, 5, 40):
                code, result = run(deck(SIDE, Z=z, ANALYSIS=analysis))
                self.assertIn(code, (0, 4), result["message"])
                for row in rows(result, "sheaves") if "sheaves" in result["tables"] else []:
                    self.assertGreaterEqual(row["wrap"], 0, row)
                first = first or values_of(result)["sky.T_max"]
                self.assertAlmostEqual(values_of(result)["sky.T_max"] / first, 1, delta=1e-7)

    def test_a_payload_does_not_begin_where_the_one_before_ran_out(self):
        last = []
        for begin, steps in ((513, 1), (517, 1)) if FEWER else ((505, 2), (513, 1), (517, 1)):
            code, result = run(deck(PAYLOAD, FROM=begin, STEPS=steps))
            self.assertIn(code, (0, 4), result["message"])
            last.append(rows(result, "payload")[-1])
        for row in last:
            self.assertGreater(row["z"], -200)
            self.assertAlmostEqual(row["payload"] / last[0]["payload"], 1, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
