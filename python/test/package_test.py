"""The package `taut` as a user has it. The environment names TAUT_SOURCE_DIR and TAUT_PROGRAM."""

import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import h5py
import numpy as np

import taut

SOURCE = Path(os.environ["TAUT_SOURCE_DIR"])
EXAMPLES = SOURCE / "examples"
SKYLINE = EXAMPLES / "machines/three_span_skyline.yaml"
PATHS = ["machine.loads[0].mass", "machine.ropes.skyline.stiffness", "machine.reevings.skyline.length",
         "machine.temperature"]
OF = ["equilibrium.skyline.T_max", "equilibrium.skyline.safety_factor"]


def processor_time():
    used = os.times()
    return used.user + used.system


def rows(count, cases):
    return cases.base * (1 + np.random.default_rng(1).uniform(-1e-3, 1e-3, (count, len(cases.base))))


class Runs(unittest.TestCase):
    def test_values_checks_and_verdict(self):
        result = taut.run(taut.new("mast_section"))
        self.assertEqual(result.values["D_tube"], result.values.D_tube)
        self.assertAlmostEqual(result.values.D_tube.to("mm"), 532.468, 2)
        self.assertEqual((result.status, result.verdict), ("ok", "passes"))
        self.assertTrue(all(one.passes == (one.utilisation <= 1) for one in result.checks))
        with self.assertRaisesRegex(AttributeError, "did you mean D_tube"):
            result.values.D_tub

    def test_method_by_keywords_in_units_of_every_kind(self):
        words = {"mainline_force": "40 kN", "skyline_block_height": "8 m", "branch_angle": "8 deg",
                 "allowable_stress": "160 MPa", "tube_ratio": 0.9}
        by_text = taut.methods.mast_section(skyline_force="100 kN", **words)
        by_number = taut.methods.mast_section(skyline_force=1e5, **words)
        self.assertEqual(by_text.values.D_tube, by_number.values.D_tube)
        try:
            import pint
        except ImportError:
            return
        unit = pint.UnitRegistry()
        by_pint = taut.methods.mast_section(skyline_force=100 * unit.kN, **words)
        self.assertEqual(by_text.values.D_tube, by_pint.values.D_tube)
        self.assertAlmostEqual(taut.si(30 * unit.degree), np.pi / 6)
        self.assertAlmostEqual(taut.si(12.5 * unit.kN / unit.m), 12500)
        with self.assertRaisesRegex(ValueError, "not in 'N'"):
            taut.methods.mast_section(skyline_force=100 * unit.m, **words)

    def test_every_unit_of_a_field_is_read_back(self):
        from taut import _describe, _taut
        from taut._units import quantity_text

        for index in range(len(_describe._data()["tables"])):
            for field in _describe.table(index).fields:
                # of the others no text tells by itself what they measure
                if field.is_number and field.needs_text and field.unit not in ("1/K", "m/N", "N m s"):
                    text = quantity_text(0.1, field)
                    self.assertEqual(_taut.quantity(text)[0], 0.1, f"{field.key}: {text}")
        by_number = taut.Machine(SKYLINE).set("machine.ropes.skyline.expansion", 1.3e-5).solve()
        by_text = taut.Machine(SKYLINE).set("machine.ropes.skyline.expansion", "1.3e-5 1/K").solve()
        self.assertEqual(by_number.values.T_max, by_text.values.T_max)

    def test_a_mistake_has_its_place_and_a_caret(self):
        with self.assertRaises(taut.DeckError) as caught:
            taut.run("taut: 1\nmethod: mast_section\ninput:\n  skyline_forc: 100 kN\n")
        self.assertEqual((caught.exception.file, caught.exception.line, caught.exception.column), ("deck", 4, 3))
        self.assertIn("\n    ^~~~~~~~~~~~", str(caught.exception))
        self.assertEqual(str(pickle.loads(pickle.dumps(caught.exception))), str(caught.exception))
        self.assertEqual(len(taut.check("taut: 1\nmethod: mast_section\ninput: {}\n")), 3)
        with self.assertRaises(taut.FileError):
            taut.run("there_is_no_such_deck.yaml")
        with self.assertRaisesRegex(TypeError, "did you mean 'carriage'"):
            taut.Machine(SKYLINE).load_path(carriag="car")

    def test_no_answer_is_a_result(self):
        result = taut.Machine(SKYLINE).solve(carriage="car", x=300.0)
        self.assertEqual((result.status, result.ok), ("infeasible", False))
        self.assertIn("choose another x", result.message)
        self.assertEqual(result.verdict, "no_answer")
        with self.assertRaisesRegex(KeyError, result.status):
            result.values["no_such"]

    def test_tables_and_series(self):
        result = taut.Machine(SKYLINE).load_path(carriage="car", from_="135 m", to=230.0, steps=5)
        table = result.tables["load_path"]
        self.assertEqual(table.numbers("x").tolist(), [135, 154, 173, 192, 211, 230])
        self.assertFalse(table["x"].flags.writeable)
        self.assertFalse(table["x"].flags.owndata)
        self.assertEqual(table.units["x"], "m")
        again = pickle.loads(pickle.dumps(result))
        self.assertEqual(again.html(), result.html())
        self.assertEqual(again.tables["load_path"].numbers("x").tolist(), table.numbers("x").tolist())
        with tempfile.TemporaryDirectory() as folder:
            self.assertTrue(any(one.endswith("report.html") for one in result.write(folder)))
        with self.assertRaises(taut.TautError):
            again.write("anywhere")

    def test_tables_without_rows(self):
        deck = taut.new("guyed_tower")
        for result in (taut.run(deck), pickle.loads(pickle.dumps(taut.run(deck)))):
            empty = [name for name in result.tables if len(result.tables[name]) == 0]
            self.assertTrue(empty, "the starter has no table without rows any more")
            for name in empty:
                table = result.tables[name]
                self.assertTrue(all(len(table[column]) == 0 for column in table), name)

    def test_the_report_stands_in_a_frame_of_its_own(self):
        page = taut.run(taut.new("mast_section"))._repr_html_()
        self.assertTrue(page.startswith("<iframe") and page.endswith("</iframe>"))
        self.assertIn('sandbox="allow-scripts"', page)
        self.assertNotIn("<style", page)


class Checks(unittest.TestCase):
    def test_a_refused_limit_neither_passes_nor_fails(self):
        deck = EXAMPLES / "machines/running_skyline.yaml"
        result = taut.run(deck, {"checks.refuse_unverified": True})
        self.assertEqual(result.verdict, "not_judged")
        refused = [one for one in result.checks if one.refused]
        self.assertTrue(refused)
        self.assertEqual({one.outcome for one in refused}, {"refused"})
        self.assertFalse(any(one.passes for one in refused))
        self.assertEqual({one.outcome for one in taut.run(deck).checks}, {"passes"})


class Machines(unittest.TestCase):
    def test_built_in_python_as_the_deck(self):
        deck = taut.run(taut.new("clamped_load"), {"analyses": [{"equilibrium": {"carriage": "car", "x": 125}}]})
        machine = taut.Machine()
        machine.point("head", [0, 0, 18]).point("tail", ["250 m", 0, 120])
        machine.rope("skyline", "EN 12385-4|6x36-IWRC|20|1960", stiffness=26.6e6)
        machine.carriage("car", 220, "skyline", hold="clamped").load("car", "1 t")
        path = [taut.anchor("head"), taut.through("car"), taut.anchor("tail")]
        machine.reeve("skyline", path, length=272)
        built = machine.solve(carriage="car", x=125)
        self.assertEqual(built.values.T_max, deck.values.T_max)
        again = pickle.loads(pickle.dumps(machine))
        self.assertEqual(again.solve(carriage="car", x=125).values.T_max, built.values.T_max)
        with self.assertRaises(ValueError):
            machine.point("head", [0, 0, 0])
        with self.assertRaises(TypeError):
            taut.Machine(SKYLINE).point("more", [0, 0, 0])

    def test_an_analysis_of_a_deck_with_parameters_and_a_design(self):
        self.assertEqual(taut.Machine(EXAMPLES / "machines/guys_pulled_in_turn.yaml").solve().status, "ok")
        chooses = taut.Machine(EXAMPLES / "design/saw_take_up.yaml")
        self.assertEqual(chooses.set("machine.ropes.saw.rope", "EN 12385-4|6x36-IWRC|12|1960").solve().status, "ok")

    def test_an_analysis_names_what_it_leaves_out_and_chooses_nothing(self):
        deck = ("taut: 1\nmachine:\n  points: {top: [0 m, 0 m, 9 m]}\n"
                "  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 40 kN}}\n"
                "  bodies: {hook: {mass: 1 t, at: [0 m, 0 m, 4 m], free: [x, z]}}\n"
                "  reevings: [{rope: r, path: [{anchor: top}, {anchor: hook}], length: 5 m}]\n"
                "analyses:\n  - equilibrium: {}\n"
                "  - sweep: {name: more, parameter: bodies.hook.mass, from: 1 t, to: 2 t, steps: 2}\n"
                "checks: {ropes: {r: {safety_factor: 3}}}\n")
        self.assertEqual(taut.run(deck).verdict, "fails")
        alone = taut.Machine(deck).solve()
        self.assertEqual(alone.verdict, "passes")
        self.assertTrue(any("sweep 'more'" in one for one in alone.warnings), alone.warnings)
        chooses = deck + '"design": {vary: {machine.ropes.r.breaking_force: [40 kN, 90 kN]}, minimise: r.T_max}\n'
        self.assertAlmostEqual(taut.Machine(chooses).solve().values["r.safety_factor"], 40e3 / 9806.65, 6)

    def test_what_a_caller_changes_later_changes_no_machine(self):
        place, path = [0.0, 0.0, 9.0], [taut.anchor("top"), taut.anchor("hook")]
        machine = taut.Machine().point("top", place).rope("r", mass=0, stiffness=1e7)
        machine.body("hook", mass=1000, at=[0, 0, 4], free=["x", "z"]).reeve("r", path, length=5)
        before = machine.text
        place[2] = 99.0
        path.append(taut.anchor("top"))
        self.assertEqual(machine.text, before)

    def test_what_is_no_deck_is_told(self):
        for one in (5, None, b"taut: 1\n"):
            with self.assertRaisesRegex(TypeError, "a deck is a text"):
                taut.run(one)
        self.assertEqual(taut.run(taut.new("clamped_load"), {"checks": None}).verdict, "not_judged")
        self.assertEqual(taut.Machine(taut.new("mast_section")).set("input.skyline_force", 1e5).check(), [])

    def test_a_frequency_counts_what_its_unit_says(self):
        deck = ("taut: 1\nparameters: {f: 1 Hz}\nmachine:\n  points: {a: {at: [0 m, 0 m, 10 m]}}\n"
                "  signals: {s: {sine: {amplitude: 1 kN, frequency: = f}}}\n"
                "  ropes: {r: {mass: 1 kg/m, stiffness: 1 MN, damping_ratio: 0.05}}\n"
                "  bodies: {b: {at: [0 m, 0 m, 0 m], mass: 600 kg, free: [z]}}\n"
                "  reevings: [{rope: r, path: [{anchor: a}, {anchor: b}], length: 10 m}]\n"
                "  loads: [{at: b, force: [0 N, 0 N, 1 N], signal: s}]\n"
                "analyses:\n  - transient: {duration: 1 s, output_step: 20 ms}\n")
        literal = taut.run(deck.replace("parameters: {f: 1 Hz}\n", "").replace("= f", "1 Hz")).values.T_max
        for text in ("1 Hz", "360 deg/s", "= 0.5 * 2 Hz", "1 1/s"):
            self.assertAlmostEqual(taut.run(deck, {"parameters.f": text}).values.T_max / literal, 1, 9, text)
        for path in ("parameters.f", "machine.signals.s.sine.frequency"):
            cases = taut.cases(deck, [path], ["transient.T_max"])
            self.assertAlmostEqual(cases(cases.base)[0] / literal, 1, 9, path)
            for text in ("1 Hz", "360 deg/s"):
                self.assertAlmostEqual(cases([text])[0] / literal, 1, 9, f"{path}: {text}")
            with self.assertRaises(TypeError):
                cases([None])
        try:
            import pint
        except ImportError:
            return
        unit = pint.UnitRegistry()
        for one in (1 * unit.Hz, 60 * unit.rpm, 2 * np.pi * unit.rad / unit.s):
            self.assertAlmostEqual(taut.run(deck, {"machine.signals.s.sine.frequency": one}).values.T_max / literal, 1, 9)

    def test_a_value_in_another_unit_is_what_a_report_shows(self):
        from taut._result import Value

        self.assertAlmostEqual(Value(1.5, "f", "1/s", "Hz").to("Hz"), 1.5)
        self.assertAlmostEqual(Value(1.5, "f", "1/s", "Hz").to("rad/s"), 3 * np.pi)
        self.assertAlmostEqual(Value(np.pi / 4, "a", "rad", "deg").to("%"), 100)
        self.assertAlmostEqual(Value(293.15, "T", "K", "degC").to("degC"), 20)
        self.assertAlmostEqual(Value(0.5, "u").to("%"), 50)
        self.assertEqual(Value(0.5, "u").to("1"), 0.5)
        self.assertAlmostEqual(Value(1.2e-5, "a", "1/K", "1/K").to("1/K"), 1.2e-5)
        with self.assertRaises(ValueError):
            Value(1.5, "F", "N", "kN").to("m")

    def test_a_number_set_is_si_wherever_it_stands(self):
        machine = taut.Machine(SKYLINE)
        for path, number, text in (("machine.loads[0].mass", 2000.0, "2 t"), ("loads[0].mass", 2000, "2 t"),
                                   ("machine.points.tower[2]", 125.0, "125 m"),
                                   ("machine.ropes.skyline.stiffness", 21e6, "21 MN"),
                                   ("machine.supports.jack1.at[2]", 34, "34 m"),
                                   ("machine.temperature", 293.15, "20 degC")):
            one = machine.copy().set(path, number).solve().values.T_max
            other = machine.copy().set(path, text).solve().values.T_max
            self.assertAlmostEqual(one / other, 1, 12, path)
        over_jacks = taut.Machine(EXAMPLES / "machines/skyline_over_jacks.yaml")
        leans = [over_jacks.copy().set("machine.supports.jack1.at.lean", lean).solve(carriage="car", x=200.0).values.T_max
                 for lean in (np.radians(2), "2 deg")]
        self.assertAlmostEqual(leans[0] / leans[1], 1, 12)
        # its method stands in the deck that it includes
        chance = EXAMPLES / "study/mast_chance.yaml"
        one = taut.run(chance, {"input.skyline_force": 1e5}).values.D_tube
        self.assertEqual(one, taut.run(chance, {"input.skyline_force": "100 kN"}).values.D_tube)

    def test_a_number_whose_key_does_not_tell_its_unit_is_si(self):
        drives = EXAMPLES / "machines/running_skyline.yaml"
        pull = "machine.drums.haulback_drum.drive.pull"
        forces = [taut.run(drives, {pull: one}).values.T_max for one in (25000.0, 25000, "25 kN")]
        self.assertEqual(forces[0], forces[2])
        self.assertEqual(forces[1], forces[2])
        self.assertNotEqual(taut.run(drives, {pull: 30e3}).values.T_max, forces[0])
        self.assertEqual(taut.check(drives, {pull: 25e3}), [])
        ends = [taut.Machine(SKYLINE).sweep(parameter="loads[0].mass", from_=least, to=most, steps=2).values
                for least, most in ((1000.0, 2000), ("1 t", "2 t"))]
        self.assertEqual(ends[0], ends[1])
        # in a dict, two of them in one line
        line = {"taut": 1, "machine": {"points": {"a": [0, 0, 10], "b": [100, 0, 10]},
                                       "ropes": {"r": {"breaking_force": 2e5, "stiffness": 2e7, "mass": 1}},
                                       "bodies": {"süß": {"mass": 100, "at": [50, 0, 5], "free": ["x", "z"]}},
                                       "reevings": [{"name": "one", "rope": "r", "path": [taut.anchor("a"), taut.anchor("süß")],
                                                     "length": 52.0},
                                                    {"name": "two", "rope": "r", "path": [taut.anchor("süß"), taut.anchor("b")],
                                                     "length": 52.0}],
                                       "loads": [{"at": "süß", "mass": 1000}]},
                "analyses": [{"sweep": {"parameter": "loads.süß.mass", "from": 1e3, "to": 1200, "steps": 2}}]}
        self.assertEqual(taut.check(line), [])
        # of a file that is read, and of what never has a unit, it stays a mistake
        text = drives.read_text().replace("pull: 25 kN", "pull: 25", 1)
        with self.assertRaisesRegex(taut.DeckError, "needs its unit, such as '1 kN'"):
            taut.run(text)
        with self.assertRaisesRegex(taut.DeckError, "needs its unit"):
            taut.run(drives, {pull: "25000"})

    def test_a_text_without_its_unit_is_no_si_number(self):
        line = {"taut": 1, "machine": {"points": {"top": [0, 0, 10]},
                                       "ropes": {"r": {"breaking_force": 1e5, "stiffness": 2e7, "mass": 1e-4}},
                                       "bodies": {"hook": {"mass": 1e-3, "at": [0, 0, 4], "free": ["x", "z"]}},
                                       "reevings": [{"rope": "r", "path": [taut.anchor("top"), taut.anchor("hook")],
                                                     "length": 6}],
                                       "loads": [{"at": "hook", "mass": 2000}]}}
        self.assertAlmostEqual(taut.run(line).values.T_max, 2000 * 9.80665, -1)
        for text in ("2000", "+2000", "-2", "2e3", "2.0e+3"):
            for set in ({"machine.loads[0].mass": text}, {"loads": [{"at": "hook", "mass": text}]}):
                with self.assertRaisesRegex(taut.DeckError, "needs its unit", msg=text):
                    taut.run(line, set)
            with self.assertRaisesRegex(taut.DeckError, "needs its unit", msg=text):
                taut.Machine(line).set("machine.loads[0].mass", text).solve()
            hung = {**line, "machine": {**line["machine"], "loads": [{"at": "hook", "mass": text}]}}
            with self.assertRaisesRegex(taut.DeckError, "needs its unit", msg=text):
                taut.run(hung)

    def test_the_limit_of_a_study_may_be_a_number(self):
        def study(limit):
            return {"vary": {"machine.loads[0].mass": {"from": 1400, "to": 1600, "steps": 2}}, "points": "grid",
                    "of": ["equilibrium.skyline.T_max", "equilibrium.clearance_min"],
                    "limit": {"equilibrium.skyline.T_max": {"at_most": limit[0]},
                              "equilibrium.clearance_min": {"at_least": limit[1]}}}

        number, text = (taut.Machine(SKYLINE).study(**study(limit)) for limit in ((16e4, 0.5), ("160 kN", "0.5 m")))
        self.assertEqual([one.limit for one in number.checks], [one.limit for one in text.checks])
        self.assertIn(16e4, [one.limit for one in number.checks])

    def test_half_a_character_has_its_place(self):
        for deck, more, place in (("taut: 1\ntitle: a\ud800b\nmachine: {}\n", None, ("deck", 2, 9)),
                                  ({"taut": 1, "title": "a\udfff", "machine": {}}, None, ("deck.yaml made of a dict", 2, 10)),
                                  ("taut: 1\nmachine: {}\n", {"title": "ab\ud83d"}, ("--set", 1, 10))):
            for ask in (taut.run, taut.check, taut.study, lambda deck, more: taut.cases(deck, ["a.b"], ["c"], more)):
                with self.assertRaisesRegex(taut.DeckError, "half of a character") as caught:
                    ask(deck, more)
                error = caught.exception
                self.assertEqual((error.file, error.line, error.column), place)
                self.assertLess(len(str(error)), 250)


class Cases(unittest.TestCase):
    def test_equal_to_the_study_of_the_program_to_the_bit(self):
        cases = taut.cases(SKYLINE, PATHS, OF)
        steps = {"from": "1.4 t", "to": "1.6 t", "steps": 3}, {"from": "19 MN", "to": "21 MN", "steps": 2}
        study = {"vary": dict(zip(PATHS, steps)), "of": OF, "points": "grid"}
        data = taut.Machine(SKYLINE).study(**study).series["cases"]
        values = np.column_stack([data.numbers(path) for path in PATHS[:2]])
        found = taut.evaluate(SKYLINE, PATHS[:2], values, OF)
        self.assertEqual(len(found), 12)
        for column, name in enumerate(OF):
            self.assertEqual(found[:, column].tobytes(), np.ascontiguousarray(data.numbers(name)).tobytes())
        with tempfile.TemporaryDirectory() as folder:
            from taut._deck import assignment

            run = [os.environ["TAUT_PROGRAM"], "study", "run", str(SKYLINE), "-o", folder, "--quiet", "--set",
                   assignment("study", study)]
            subprocess.run(run, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
            with h5py.File(Path(folder) / "series.h5") as file:
                written = np.column_stack([file["cases"][name][:] for name in OF])
        self.assertEqual(written.tobytes(), found.tobytes())
        # the base is calculated cold, a case from the base
        self.assertAlmostEqual(cases(cases.base)[0] / cases.of_base[0], 1, 12)

    def test_threads_give_the_same_bits_and_cost_no_more(self):
        cases = taut.cases(SKYLINE, PATHS, OF[:1])
        values = rows(10000, cases)
        costs, found = [], []
        for threads in (1, 2):
            # the less of two: other programs on the machine only add to it
            runs = []
            for _ in range(2):
                begin = processor_time()
                found.append(cases(values, threads=threads))
                runs.append(processor_time() - begin)
            costs.append(min(runs))
        print(f"10000 x 4: {costs[0]:.2f} s of CPU with one thread, {costs[1]:.2f} s with two", file=sys.stderr)
        self.assertEqual(len({one.tobytes() for one in found}), 1)
        self.assertFalse(np.isnan(found[0]).any())
        self.assertLess(costs[1], 1.1 * costs[0])

    def test_more_threads_than_a_machine_gives_are_refused(self):
        cases = taut.cases(SKYLINE, PATHS[:1], OF)
        self.assertEqual(cases([1500.0], threads=1024).tolist(), cases([1500.0]).tolist())
        for threads in (-1, 1025, 100000):
            for ask in (lambda: cases([1500.0], threads=threads), lambda: taut.study(SKYLINE, threads=threads),
                        lambda: taut.calibrate(SKYLINE, threads=threads)):
                with self.assertRaisesRegex(ValueError, "up to 1024"):
                    ask()

    def test_a_row_without_an_answer_is_nan_with_its_reason(self):
        cases = taut.cases(SKYLINE, PATHS[:1], OF)
        found, reasons = cases.evaluate([[1500.0], [-5.0], [np.nan]])
        self.assertEqual(np.isnan(found).any(axis=1).tolist(), [False, True, True])
        self.assertEqual(list(reasons), [1, 2])
        self.assertIn("machine.loads[0].mass", reasons[1])
        self.assertEqual(cases(["1.5 t"]).tolist(), cases([1500.0]).tolist())
        with self.assertRaisesRegex(ValueError, "shape"):
            cases([[1.0, 2.0]])
        with self.assertRaisesRegex(taut.QuestionError, "did you mean 'mass'"):
            taut.cases(SKYLINE, ["machine.loads[0].masss"], OF)
        with self.assertRaises(taut.QuestionError):
            taut.cases(SKYLINE, PATHS)
        again = pickle.loads(pickle.dumps(cases))
        self.assertEqual(again([1500.0]).tolist(), found[0].tolist())

    def test_many_threads_of_python(self):
        cases = taut.cases(SKYLINE, PATHS, OF)
        values = rows(50, cases)
        alone = cases(values).tobytes()
        deck = taut.new("mast_section")
        with ThreadPoolExecutor(4) as pool:
            self.assertEqual({one.tobytes() for one in pool.map(cases, [values] * 8)}, {alone})
            diameters = {float(one.values.D_tube) for one in pool.map(taut.run, [deck] * 8)}
        self.assertEqual(len(diameters), 1)

    def test_memory_does_not_grow(self):
        def resident():
            return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20

        fewer = 20 if "TAUT_FEWER" in os.environ else 1
        deck = taut.new("mast_section")
        cases = taut.cases(SKYLINE, PATHS, OF)
        values = rows(1000, cases)

        def work(loads, blocks):
            for _ in range(loads):
                taut.Machine(SKYLINE).solve().values.T_max
            for _ in range(blocks):
                cases(values)
            taut.run(deck).html()

        work(100 // fewer, 10)
        before = resident()
        work(1000 // fewer, 100 // fewer)
        self.assertLess(resident() - before, 20, "MiB")


class Ends(unittest.TestCase):
    def test_ctrl_c_ends_a_motion_with_what_is_done(self):
        seen = []

        def interrupt():
            begin.wait(60)
            os.kill(os.getpid(), signal.SIGINT)
            cost.append(processor_time())

        def progress(what, done, words):
            seen.append(done)
            begin.set()

        begin, cost = threading.Event(), []
        thread = threading.Thread(target=interrupt)
        thread.start()
        with self.assertRaises(taut.Interrupted) as caught:
            taut.run(EXAMPLES / "telescopic_boom/break_extension_17_load.yaml", progress=progress)
        used = processor_time() - cost[0]
        thread.join()
        result = caught.exception.result
        self.assertTrue(result.interrupted)
        self.assertGreater(len(result.series["time"]), 1)
        self.assertLess(used, 1, "s of processor time after Ctrl-C")
        self.assertIsInstance(caught.exception, KeyboardInterrupt)

    def test_progress_may_end_it(self):
        deck = EXAMPLES / "telescopic_boom/break_extension_17_load.yaml"
        self.assertTrue(taut.run(deck, progress=lambda *_: False).interrupted)
        with self.assertRaisesRegex(ZeroDivisionError, "division"):
            taut.run(deck, progress=lambda *_: 1 // 0)

    def test_an_interrupted_study_promises_no_result(self):
        begin = threading.Event()

        def interrupt():
            begin.wait(60)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        thread.start()
        with self.assertRaises(taut.Interrupted) as caught:
            taut.study(EXAMPLES / "study/rope_life_chance.yaml", progress=lambda *_: begin.set())
        thread.join()
        self.assertIsNone(caught.exception.result)
        self.assertNotIn("'result'", str(caught.exception))

    def test_a_calibration_that_is_ended_has_no_numbers(self):
        fit = taut.calibrate(EXAMPLES / "study/calibrated_line.yaml", progress=lambda *_: False)
        self.assertTrue(fit.interrupted)
        self.assertEqual(list(fit.values), [])


if __name__ == "__main__":
    unittest.main()
