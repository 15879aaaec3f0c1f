"""Machines in motion, from outside: interrupts, saved states, files, and runs that can't go on.

TAUT_PROGRAM is the program, TAUT_SOURCE_DIR the source tree with its examples.
"""
import csv
import json
import math
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["TAUT_PROGRAM"]
EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples" / "motion"

HOIST = """taut: 1
title: A load on a winch
machine:
  signals:
    hoist_speed: {ramp: {to: 0.5 m/s, start: 0.5 s, duration: 0.5 s}}
  points: {lead: [0 m, 0 m, 20 m]}
  ropes:
    hoist: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 150 kN, damping_ratio: 0.03}
  bodies:
    load: {mass: 2 t, at: [0 m, 0 m, 2 m], free: [x, z]}
  drums:
    winch: {at: [0.2 m, 0 m, 20 m], core_diameter: 400 mm, drive: {speed: hoist_speed}}
  reevings:
    - {rope: hoist, path: [{drum: winch, side: left}, {anchor: load}], length: 18 m}
  observe: [load.z, load.vz, hoist.T_max, winch.speed, energy.kinetic]
analyses:
  - transient: {duration: 2 s, output_step: 10 ms}
"""


def taut(*args, stdin="", cwd=None):
    return subprocess.run([PROGRAM, *args], input=stdin, capture_output=True, text=True, timeout=100, check=False, cwd=cwd)


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    return rows[0], [[float(x) for x in row] for row in rows[1:]]


class Motion(unittest.TestCase):
    def run_to(self, folder, *sets, deck=HOIST, expected=0):
        sets = [part for one in sets for part in ("--set", one)]
        done = taut("run", "-", "-o", str(folder), "-q", *sets, stdin=deck)
        self.assertEqual(done.returncode, expected, done.stderr)
        return json.loads((pathlib.Path(folder) / "result.json").read_text())

    def test_series_tables_and_values(self):
        with tempfile.TemporaryDirectory() as folder:
            r = self.run_to(folder)
            head, rows = rows_of(pathlib.Path(folder) / "time.csv")
            self.assertEqual(head[0], "t [s]")
            self.assertEqual(head[1:], ["load.z [m]", "load.vz [m/s]", "hoist.T_max [N]", "winch.speed [m/s]",
                                        "energy.kinetic [J]"])
            self.assertEqual(len(rows), 201)
            self.assertEqual([row[0] for row in rows], sorted(row[0] for row in rows))
            self.assertAlmostEqual(rows[-1][0], 2, places=12)
            self.assertEqual(r["series"]["time"]["file"], "time.csv")
            # what the drum took in: 0.5 m/s from 1 s on, half of it in the half second before
            self.assertAlmostEqual(rows[-1][1] - rows[0][1], 0.125 + 0.5, delta=0.01)
            for name in ("envelope", "events", "energy", "dynamic"):
                self.assertIn(name, r["tables"])
            z = [row[1] for row in rows]
            self.assertLessEqual(r["values"]["load.z_min"]["value"], min(z) + 1e-12)
            self.assertGreaterEqual(r["values"]["load.z_max"]["value"], max(z) - 1e-12)
            self.assertEqual(r["values"]["load.z_end"]["value"], z[-1])
            self.assertGreater(r["values"]["hoist.dynamic_factor"]["value"], 1)
            self.assertLess(abs(r["values"]["energy_residual"]["value"]), 1e-3)
            files = {p.name for p in pathlib.Path(folder).iterdir()}
            self.assertLessEqual({"report.html", "time.csv", "series.h5", "envelope.csv", "events.csv"}, files)
            self.assertFalse([name for name in files if name.endswith(".part")])
            html = (pathlib.Path(folder) / "report.html").read_text()
            self.assertLess(len(html.encode()), 500_000)
            self.assertIn("<svg class=\"moving\"", html)
            self.assertNotIn("http://", html.replace("http://www.w3.org/", ""))

    def test_the_same_deck_gives_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as two:
            self.run_to(one)
            self.run_to(two)
            for path in sorted(pathlib.Path(one).iterdir()):
                self.assertEqual(path.read_bytes(), (pathlib.Path(two) / path.name).read_bytes(), path.name)

    def test_a_saved_state_goes_on_as_if_nothing_had_been(self):
        with tempfile.TemporaryDirectory() as folder:
            fixed = "analyses[0].transient.step=1 ms"
            whole = self.run_to(folder + "/whole", fixed)
            self.run_to(folder + "/first", fixed, "analyses[0].transient.duration=1 s",
                        "analyses[0].transient.save=state.json")
            second = self.run_to(folder + "/second", fixed, "analyses[0].transient.duration=1 s",
                                 f"analyses[0].transient.restart={folder}/first/state.json")
            for name in ("load.z_end", "load.vz_end", "hoist.T_max_end"):
                a, b = whole["values"][name]["value"], second["values"][name]["value"]
                # the accelerations of the scheme begin anew: the same within the error of its steps
                self.assertAlmostEqual(a, b, delta=1e-4 * max(1, abs(a)), msg=name)
            _, rows = rows_of(folder + "/second/time.csv")
            self.assertAlmostEqual(rows[0][0], 1, places=9)

    def test_a_state_of_another_machine_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            self.run_to(folder, "analyses[0].transient.save=state.json", "analyses[0].transient.duration=0.1 s")
            state = f"analyses[0].transient.restart={folder}/state.json"
            other = HOIST.replace("load", "bucket")
            done = taut("run", "-", "--set", state, stdin=other)
            self.assertEqual(done.returncode, 3)
            self.assertIn("another machine", done.stderr + done.stdout)
            done = taut("run", "-", "--set", "analyses[0].transient.restart=/nowhere/state.json", stdin=HOIST)
            self.assertEqual(done.returncode, 2)
            self.assertIn("can't read", done.stderr)

    def test_an_interrupt_keeps_what_is_done(self):
        with tempfile.TemporaryDirectory() as folder:
            deck = pathlib.Path(folder) / "deck.yaml"
            deck.write_text(HOIST.replace("ramp: {to: 0.5 m/s, start: 0.5 s, duration: 0.5 s}", "sine: {amplitude: 0.2 m/s, period: 2 s}")
                            .replace("duration: 2 s, output_step: 10 ms",
                                     "duration: 20000 s, output_step: 200 ms, tolerance: 1e-10, save: state.json"))
            out = pathlib.Path(folder) / "out"
            with subprocess.Popen([PROGRAM, "run", str(deck), "-o", str(out), "-q"], stderr=subprocess.PIPE,
                                  text=True) as running:
                time.sleep(3)
                self.assertIsNone(running.poll(), "it should still run")
                running.send_signal(signal.SIGINT)
                _, told = running.communicate(timeout=60)
            self.assertEqual(running.returncode, 130, told)
            r = json.loads((out / "result.json").read_text())
            self.assertIn("interrupted at t =", r["message"])
            head, rows = rows_of(out / "time.csv")
            self.assertEqual(head[0], "t [s]")
            self.assertGreater(len(rows), 2)
            self.assertLess(rows[-1][0], 10000)
            self.assertTrue(all(math.isfinite(x) for row in rows for x in row))
            state = json.loads((out / "state.json").read_text())
            self.assertGreaterEqual(state["t"], rows[-1][0] - 1e-9)
            self.assertFalse(list(out.glob("*.part")))

    def test_a_machine_that_cant_move_says_why(self):
        deck = HOIST.replace("mass: 2 t, ", "")
        with tempfile.TemporaryDirectory() as folder:
            r = self.run_to(folder, deck=deck, expected=3)
            self.assertIn(r["status"], ("infeasible", "not_converged"))
            self.assertTrue(r["message"].startswith("transient: "), r["message"])
            self.assertIn("load", r["message"])

    def test_mistakes_have_their_place(self):
        for change, words in (
                (("output_step: 10 ms", "output_step: 3 s"), "is longer than the duration"),
                (("output_step: 10 ms", "output_step: 10 ms, save: ../x.json"), "a file's name is expected"),
                (("output_step: 10 ms", "start: sliding"), "is not a choice"),
                (("free: [x, z]", "free: [x, z, ry]"), "needs its 'inertia'"),
                (("speed: hoist_speed", "speed: hoist_sped"), "did you mean 'hoist_speed'"),
                (("load.vz", "load.v"), "'load' has x, y, z")):
            done = taut("check", "-", stdin=HOIST.replace(*change))
            self.assertEqual(done.returncode, 2, change)
            self.assertIn(words, done.stderr)
            self.assertIn("<stdin>:", done.stderr)

    def test_vtk(self):
        with tempfile.TemporaryDirectory() as folder:
            done = taut("export", "vtk", "-", "-o", folder, "--set", "analyses[0].transient.output_step=0.5 s", stdin=HOIST)
            self.assertEqual(done.returncode, 0, done.stderr)
            names = sorted(p.name for p in pathlib.Path(folder).iterdir())
            self.assertEqual(names, ["motion.pvd"] + [f"motion_{i:04}.vtp" for i in range(5)])
            self.assertIn("timestep=\"0.5\"", (pathlib.Path(folder) / "motion.pvd").read_text())
            self.assertEqual(taut("export", "stl", "-", "-o", folder, stdin=HOIST).returncode, 2)

    def test_the_examples_run(self):
        decks = [p for p in sorted(EXAMPLES.glob("*.yaml")) if not p.name.endswith(".part.yaml")]
        self.assertGreaterEqual(len(decks), 3)
        for deck in decks:
            with tempfile.TemporaryDirectory() as folder:
                done = taut("run", str(deck), "-o", folder, "-q")
                self.assertEqual(done.returncode, 0, f"{deck.name}: {done.stderr}")
                r = json.loads((pathlib.Path(folder) / "result.json").read_text())
                self.assertEqual(r["warnings"], [], deck.name)
                self.assertLess(len((pathlib.Path(folder) / "report.html").read_bytes()), 500_000, deck.name)


if __name__ == "__main__":
    unittest.main()
