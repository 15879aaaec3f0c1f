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
import unittest

import cpu_time
import example_runs

PROGRAM = os.environ["TAUT_PROGRAM"]
FAILS = 4  # exit code: computed, and a check fails
FEWER = "TAUT_FEWER" in os.environ
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

SLIPPING = """taut: 1
title: A belt that slips on its drive
machine:
  signals:
    running: {ramp: {to: 4 m/s, start: 0 s, duration: 0.3 s, smooth: true}}
  ropes: {belt: {mass: 0.6 kg/m, stiffness: 0.65 MN, damping_ratio: 0.02}}
  bodies: {slide: {mass: 85 kg, at: [9 m, 0 m, 0 m], free: [x]}}
  sheaves:
    drive: {at: [0 m, 0 m, 0 m], diameter: 500 mm, friction: 0.2, inertia: 4 kg m^2, motor: {speed: running}}
    tail: {body: slide, at: [0 m, 0 m, 0 m], diameter: 500 mm, efficiency: 0.95, inertia: 2 kg m^2}
  take_up: [{body: slide, weight: 300 kg, along: [1, 0, 0]}]
  reevings: [{rope: belt, path: [{over: drive, side: left}, {over: tail, side: left}], closed: true, length: 19.53 m}]
  rope_loads: [{name: cut, rope: belt, between: [tail, drive], rate: 450 N/m, from: 0.2, to: 0.7}]
  observe: [drive.T_in, drive.T_out, drive.slip, slide.x, tail.speed]
analyses:
  - transient: {duration: 1 s, output_step: 50 ms, method: METHOD}
"""


def taut(*args, stdin="", cwd=None):
    return subprocess.run([PROGRAM, *args], input=stdin, capture_output=True, text=True, check=False, cwd=cwd)


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
                self.assertEqual(a, b, name)
            _, rows = rows_of(folder + "/second/time.csv")
            self.assertEqual(rows[0][0], 1)
            # at its beginning signals are read at that time, at an end just before it
            self.assertEqual(rows[1:], rows_of(folder + "/whole/time.csv")[1][101:])

    def test_a_motion_that_goes_on_tells_that_a_foot_has_lifted(self):
        # 30 kN x 4 m against 8 t x g x 1 m: it tips from the start; the saved state is of later
        deck = """taut: 1
machine:
  points: {f1: {body: yarder, at: [-1 m, 0 m, -1 m]}, f2: {body: yarder, at: [1 m, 0 m, -1 m]}}
  ropes: {r: {mass: 0.5 kg/m, stiffness: 10 MN, breaking_force: 300 kN, damping_ratio: 0.1}}
  bodies:
    yarder: {mass: 8 t, inertia: [16000 kg m^2, 16000 kg m^2, 16000 kg m^2], at: [0 m, 0 m, 1 m], free: [x, z, ry]}
    log: {mass: 5 t, at: [60 m, 0 m, 4 m], free: [x]}
  drums: {winch: {body: yarder, at: [0 m, 0 m, 3 m], core_diameter: 400 mm}}
  faces: {ground: {from: [-20 m, 0 m, 0 m], to: [50 m, 0 m, 0 m], normal: [0, 0, 1]}}
  contacts:
    - {point: f1, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.8}
    - {point: f2, face: ground, stiffness: 5 MN/m, damping: 100 kN s/m, static_friction: 0.8}
  loads: [{at: log, force: [30 kN, 0 kN, 0 kN]}]
  reevings: [{rope: r, path: [{drum: winch}, {anchor: log}], length: 59.9 m}]
analyses: [{transient: {duration: 0.3 s, output_step: 10 ms}}]
checks: {ropes: {r: {safety_factor: 2}}}
"""
        with tempfile.TemporaryDirectory() as folder:
            self.run_to(folder + "/first", "analyses[0].transient.save=state.json", deck=deck)
            second = self.run_to(folder + "/second", f"analyses[0].transient.restart={folder}/first/state.json", deck=deck)
            self.assertIn("lifts 'f1' off the ground", " ".join(second["warnings"]))

    def goes_on(self, deck, step, whole, halves, expected=0):
        """Each half run and what goes on from it give the lines of the whole run, but at the moment between them."""
        with tempfile.TemporaryDirectory() as folder:
            given = f"analyses[0].transient.step={step}"
            last = "analyses[0].transient.duration="
            self.run_to(folder + "/whole", given, f"{last}{whole:.15g} s", deck=deck, expected=expected)
            head, rows = rows_of(folder + "/whole/time.csv")
            for half in halves:
                self.run_to(folder + "/first", given, f"{last}{half:.15g} s", "analyses[0].transient.save=state.json",
                            deck=deck, expected=expected)
                self.run_to(folder + "/second", given, f"{last}{whole - half:.15g} s",
                            f"analyses[0].transient.restart={folder}/first/state.json", deck=deck, expected=expected)
                second = rows_of(folder + "/second/time.csv")[1]
                self.assertGreater(len(second), 2)
                self.assertEqual(second[1:], rows[len(rows) - len(second) + 1:], f"{head} from {half} s on")
            return head, rows

    def test_a_rope_that_slips_goes_on_to_the_last_bit(self):
        for method in ("implicit", "verlet"):
            halves = (0.3,) if FEWER else (0.3, 0.4, 0.55, 0.6)
            head, rows = self.goes_on(SLIPPING.replace("METHOD", method), "0.5 ms", 1, halves, FAILS)
            slip = [row[head.index("drive.slip [m/s]")] for row in rows]
            self.assertGreater(min(abs(x) for x in slip[6:]), 1, "it slips all the time")

    def test_a_saw_driven_at_once_either_way_round(self):
        """The example's rope saw, whose sheaves are light, with its six forces along the rope: from rest to full speed.
        Backwards the tight side is the short one, and the rope slips all the way."""
        deck = (EXAMPLES.parent / "machines" / "rope_saw_drive.yaml").read_text().split("analyses:")[0]
        deck += "analyses: [transient: {duration: 4 s, output_step: 10 ms, tolerance: 1e-3, damping_ratio: 0.02}]\n"
        for speed in (-5,) if FEWER else (18, 5, -5, -18):
            with tempfile.TemporaryDirectory() as folder:
                result = self.run_to(folder, f"machine.sheaves.drive.motor.speed={speed} m/s", deck=deck,
                                     expected=FAILS if speed < 0 else 0)
                values = result["values"]
                failed = [check["name"] for check in result["checks"] if not check["passes"]]
                self.assertEqual(failed, ["drive.slipped"] if speed < 0 else [], speed)
                self.assertLess(abs(values["energy_residual"]["value"]), 1e-5, speed)
                self.assertLess(values["T_max"]["value"], 60e3, speed)

    def test_a_carriage_on_an_endless_haul_rope_begins_at_rest(self):
        """It is put at the share of the rope's way all round where it stands, so the machine settles near there."""
        deck = (EXAMPLES.parent / "machines" / "endless_haul.yaml").read_text().split("analyses:")[0]
        deck = deck.replace("car: {mass: 260 kg,", "car: {mass: 260 kg, inertia: 40 kg m^2, at: [PLACE],")
        deck = deck.replace("  terrain:", "  observe: [car.x, car.vx, slide.x]\n  terrain:")
        deck += "analyses: [transient: {duration: 0.5 s, output_step: 50 ms, tolerance: 1e-4, branches: SHAPE}]\n"
        for place in ("60 m, 0 m, 27 m", "100 m, 0 m, 38 m", "150 m, 0 m, 52 m"):
            for shape in ("straight", "catenary"):
                with tempfile.TemporaryDirectory() as folder:
                    one = deck.replace("PLACE", place).replace("SHAPE", shape)
                    values = self.run_to(folder, deck=one)["values"]
                    self.assertAlmostEqual(values["car.x_end"]["value"], float(place.split()[0]), delta=5)
                    self.assertAlmostEqual(values["slide.x_end"]["value"], 419.6, delta=1)
                    self.assertLess(abs(values["car.vx_end"]["value"]), 1e-3)

    def test_a_force_along_a_rope_in_segments(self):
        deck = SLIPPING.replace("METHOD", "implicit").replace("tail: {body: slide, at: [0 m, 0 m, 0 m]", "tail: {at: [9 m, 0 m, 0 m]")
        deck = deck[:deck.index("  bodies:")] + """  points: {top: [0 m, 0 m, 0 m]}
  bodies: {load: {mass: 200 kg, at: [0 m, 0 m, -10 m], free: [x, z]}}
  reevings: [{name: line, rope: belt, path: [{anchor: top}, {anchor: load}], length: 9.9 m, segments: 1}]
  rope_loads: [{name: brake, rope: line, between: [top, load], tangential: 300 N, position: 0.4, direction: along_path}]
  observe: [load.z, brake.T_in, brake.T_out, brake.speed]
analyses:
  - transient: {duration: 0.5 s, output_step: 50 ms, start: START}
"""
        for start in ("settled", "assembled"):
            ends = []
            for segments in (1, 8):
                with tempfile.TemporaryDirectory() as folder:
                    values = self.run_to(folder, f"machine.reevings[0].segments={segments}",
                                         deck=deck.replace("START", start))["values"]
                    ends.append(values["load.z_end"]["value"])
                    if segments > 1:
                        self.assertLess(abs(values["energy_residual"]["value"]), 1e-6)
                    self.assertAlmostEqual(values["brake.T_in_end"]["value"] - values["brake.T_out_end"]["value"], 300,
                                           delta=1e-3)
            # a force that is there at once makes waves in the chain
            self.assertAlmostEqual(ends[0], ends[1], delta=1e-6 if start == "settled" else 0.02)

    def test_what_measures_relate_to_and_events_of_the_last_moment_go_on(self):
        deck = HOIST.replace("observe: [", "measures: {gone: {of: load.z, since: 0.4 s, relative: difference}}\n  observe: [gone, ")
        for event in ("at: 0.9 s", "when: load.vz > 0.4 m/s"):
            twice = f"  events: [{{{event}, drive: winch, torque: 5 kN m}}]\n  observe:"
            self.goes_on(deck.replace("  observe:", twice), "1 ms", 2, (0.6, 0.9, 1))
        # the event comes true in the very last step of the first run
        twice = "  events: [{when: load.z > 2.1299 m, drive: winch, torque: 5 kN m}]\n  observe:"
        deck = deck.replace("  observe:", twice)
        with tempfile.TemporaryDirectory() as folder:
            events = self.run_to(folder, "analyses[0].transient.step=1 ms", deck=deck)["tables"]["events"]["rows"]
            at = next(row[0] for row in events if row[1] == "drive")
        self.goes_on(deck.replace("output_step: 10 ms", f"output_step: {at / 50:.17g} s"), "1 ms", 2 * at, (at,))

    def test_the_dynamic_factor_of_the_second_part_is_of_the_tension_at_rest(self):
        deck = HOIST.replace("duration: 2 s", "duration: 1 s, hoist_factor: {rope: hoist, class: HC1, speed: 0.5 m/s}")
        with tempfile.TemporaryDirectory() as folder:
            first = self.run_to(folder, "analyses[0].transient.save=state.json", "analyses[0].transient.duration=0.55 s", deck=deck)
            state = pathlib.Path(folder) / "state.json"
            go_on = f"analyses[0].transient.restart={state}"
            second = self.run_to(folder + "/second", go_on, deck=deck, expected=4)
            self.assertFalse(next(check for check in second["checks"] if "phi2" in check["name"])["passes"])
            at_rest = [run["tables"]["dynamic"]["rows"][0][1] for run in (first, second)]
            self.assertEqual(*at_rest)
            self.assertAlmostEqual(at_rest[0] / (2000 * 9.80665), 1, places=3)
            # a state that does not say it: not judged
            older = json.loads(state.read_text())
            for rope in older["ropes"]:
                del rope["T_static"]
            state.write_text(json.dumps(older))
            blind = self.run_to(folder + "/blind", go_on, deck=deck, expected=4)
            self.assertEqual(blind["verdict"], "not_judged")
            self.assertFalse([check for check in blind["checks"] if "phi2" in check["name"]])

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
            self.assertIn("can't be read", done.stderr)

    def test_an_interrupt_keeps_what_is_done(self):
        with tempfile.TemporaryDirectory() as folder:
            deck = pathlib.Path(folder) / "deck.yaml"
            deck.write_text(HOIST.replace("ramp: {to: 0.5 m/s, start: 0.5 s, duration: 0.5 s}", "sine: {amplitude: 0.2 m/s, period: 2 s}")
                            .replace("duration: 2 s, output_step: 10 ms",
                                     "duration: 20000 s, output_step: 200 ms, tolerance: 1e-10, save: state.json"))
            for asked in (signal.SIGINT, signal.SIGTERM):
                self.interrupt(deck, pathlib.Path(folder) / asked.name, asked)

    def interrupt(self, deck, out, asked):
        with subprocess.Popen([PROGRAM, "run", str(deck), "-o", str(out), "-q"], stderr=subprocess.PIPE,
                              text=True) as running:
            cpu_time.wait(running, 2)
            self.assertIsNone(running.poll(), "it should still run")
            running.send_signal(asked)
            _, reported = running.communicate()
        self.assertEqual(running.returncode, 130, reported)
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

    def test_an_interrupt_is_heard_between_two_outputs(self):
        deck = HOIST.replace("duration: 2 s, output_step: 10 ms", "duration: 20000 s, output_step: 20000 s, tolerance: 1e-10")
        deck = deck.replace("ramp: {to: 0.5 m/s, start: 0.5 s, duration: 0.5 s}", "sine: {amplitude: 0.2 m/s, period: 2 s}")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "deck.yaml"
            path.write_text(deck)
            for wait in (0.02, 0.3, 1.5):
                with subprocess.Popen([PROGRAM, "run", str(path), "-o", folder + "/out", "-q"], stderr=subprocess.PIPE,
                                      text=True) as running:
                    cpu_time.wait(running, wait)
                    pressed, before = cpu_time.of_running(running), cpu_time.of_ended()
                    running.send_signal(signal.SIGINT)
                    running.communicate()
                self.assertIn(running.returncode, (130, -signal.SIGINT), wait)
                self.assertLess(cpu_time.of_ended() - before - pressed, 20)

    def test_a_killed_run_leaves_readable_files(self):
        long = ("duration: 2 s, output_step: 10 ms", "duration: 20000 s, output_step: 200 ms, tolerance: 1e-10")
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out"
            self.run_to(out)
            whole = {p.name: p.read_bytes() for p in out.iterdir()}
            path = pathlib.Path(folder) / "deck.yaml"
            to_and_fro = ("ramp: {to: 0.5 m/s, start: 0.5 s, duration: 0.5 s}", "sine: {amplitude: 0.2 m/s, period: 2 s}")
            path.write_text(HOIST.replace(*long).replace(*to_and_fro))
            with subprocess.Popen([PROGRAM, "run", str(path), "-o", str(out), "-q"]) as running:
                cpu_time.wait(running, 1.5)
                self.assertIsNone(running.poll(), "it should still run")
                running.kill()
            for name, content in whole.items():  # what stood there before stands there still
                self.assertEqual((out / name).read_bytes(), content, name)
        # killed at any moment of a short run, while it writes too: each file is whole or not there
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "deck.yaml"
            path.write_text(HOIST)
            begin = cpu_time.of_ended()
            self.assertEqual(taut("run", str(path), "-o", folder + "/first", "-q").returncode, 0)
            lasts = cpu_time.of_ended() - begin
            whole = {p.name: p.read_bytes() for p in (pathlib.Path(folder) / "first").iterdir()}
            for i in range(12):
                out = pathlib.Path(folder) / str(i)
                with subprocess.Popen([PROGRAM, "run", str(path), "-o", str(out), "-q"]) as running:
                    cpu_time.wait(running, lasts * (i + 1) / 11)
                    running.kill()
                for name in (p.name for p in out.glob("*") if not p.name.endswith(".part")):
                    self.assertEqual((out / name).read_bytes(), whole[name], name)

    def test_a_load_hauled_into_its_drum_ends_in_time(self):
        deck = HOIST.replace("duration: 2 s", "duration: 60 s")
        with tempfile.TemporaryDirectory() as folder:
            begin = cpu_time.of_ended()
            r = self.run_to(folder, deck=deck, expected=3)
            self.assertLess(cpu_time.of_ended() - begin, 30)
            self.assertEqual(r["status"], "infeasible")
            self.assertIn("no rope is left between 'winch' and 'load' of 'hoist'", r["message"])
            self.assertIn("at t = ", r["message"])
            with open(pathlib.Path(folder) / "events.csv", encoding="utf-8", newline="") as file:
                events = list(csv.reader(file))
            self.assertIn("length_zero", [cell for row in events for cell in row])
            # 18 m at 0.5 m/s, from 0.75 s on
            _, rows = rows_of(pathlib.Path(folder) / "time.csv")
            self.assertAlmostEqual(rows[-1][0], 36.75, delta=1)

    def test_a_machine_that_cant_move_says_why(self):
        # a second body, too heavy for its cylinder, comes nowhere to rest
        deck = HOIST.replace("free: [x, z]}", "free: [x, z]}\n    loose: {mass: 9 kg, at: [0 m, 0 m, 2 m], free: [z]}")
        deck = deck.replace("  drums:", "  actuators: {jack: {from: lead, to: loose, force: 1 N}}\n  drums:")
        with tempfile.TemporaryDirectory() as folder:
            r = self.run_to(folder, deck=deck, expected=3)
            self.assertIn(r["status"], ("infeasible", "not_converged"))
            self.assertTrue(r["message"].startswith("transient: "), r["message"])
            self.assertIn("does not come to rest", r["message"])

    def test_mistakes_have_their_place(self):
        for change, words in (
                (("output_step: 10 ms", "output_step: 3 s"), "is longer than the duration"),
                (("output_step: 10 ms", "output_step: 10 ms, save: ../x.json"), "a file's name is expected"),
                (("output_step: 10 ms", "start: slidng"), "is not a choice"),
                (("output_step: 10 ms", "start: sliding"), "needs 'slid'"),
                (("free: [x, z]", "free: [x, z, ry]"), "needs its 'inertia'"),
                (("mass: 2 t, ", ""), "needs its 'mass'"),
                (("length: 18 m", "length: 18 m, segments: 5"), "it has none: give its 'mass'"),
                (("10 MN", ".inf"), "in motion a rope stretches"),
                (("mass: 0 kg/m, stiffness: 10 MN", "mass: 1 kg/m, stiffness: .inf"), "in motion a rope stretches"),
                (("damping_ratio: 0.03", "damping_ratio: 0.03, damping_time: 1 ms"), "give one of the two"),
                (("output_step: 10 ms", "method: reference, step: 1 ms"), "chooses its steps itself"),
                (("mass: 2 t", "mass: 2 t, inertia: 3 kg"), "an inertia is expected here"),
                (("speed: hoist_speed", "speed: hoist_sped"), "did you mean 'hoist_speed'"),
                (("core_diameter: 400 mm, ", ""), "a motion needs its 'core_diameter'"),
                (("core_diameter: 400 mm, drive: {speed: hoist_speed}", "drive: {brake: open}"), "turns: a motion needs"),
                (("load.vz", "load.z"), "'load.z' stands here a second time"),
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
            self.assertEqual([n for n in names if not n.startswith(".")], ["motion.pvd"] + [f"motion_{i:04}.vtp" for i in range(5)])
            self.assertIn("timestep=\"0.5\"", (pathlib.Path(folder) / "motion.pvd").read_text())
            self.assertEqual(taut("export", "stl", "-", "-o", folder, stdin=HOIST).returncode, 2)

    def test_no_vtk_without_an_answer(self):
        # the rope of 6 m cannot reach from the top to the load
        deck = ("taut: 1\nmachine:\n  points: {a: [0 m, 0 m, 0 m], b: [10 m, 0 m, 0 m]}\n"
                "  ropes: {r: {mass: 1 kg/m, stiffness: .inf}}\n"
                "  reevings: [{rope: r, path: [{anchor: a}, {anchor: b}], length: 6 m}]\n")
        with tempfile.TemporaryDirectory() as folder:
            done = taut("export", "vtk", "-", "-o", folder, stdin=deck)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("infeasible", done.stderr)
            self.assertNotIn("no analysis of the deck", done.stderr)

    def test_two_envelopes_have_two_names(self):
        deck = HOIST.replace("analyses:\n", "analyses:\n  - envelope: {motions: [in, out]}\n")
        with tempfile.TemporaryDirectory() as folder:
            r = self.run_to(folder, deck=deck)
            self.assertIn("t_max", [c["name"] for c in r["tables"]["envelope_motion"]["columns"]])
            self.assertNotIn("t_max", [c["name"] for c in r["tables"]["envelope"]["columns"]])

    def test_the_reference_agrees_with_the_implicit_scheme(self):
        with tempfile.TemporaryDirectory() as folder:
            fast = self.run_to(folder + "/fast")
            slow = self.run_to(folder + "/slow", "analyses[0].transient.method=reference")
            for name in ("load.z_end", "load.vz_end", "hoist.T_max_max", "hoist.T_max_end"):
                a, b = fast["values"][name]["value"], slow["values"][name]["value"]
                self.assertAlmostEqual(a, b, delta=1e-3 * max(1, abs(b)), msg=name)
            self.assertIn("SUNDIALS", (pathlib.Path(folder) / "slow/report.html").read_text(encoding="utf-8"))

    def test_the_examples_run(self):
        decks = [name for name in example_runs.those_that_run() if name.startswith("motion/")]
        self.assertGreaterEqual(len(decks), 3)
        for deck, run in example_runs.of_all(decks):
            with self.subTest(deck):
                slips = deck == "motion/rope_saw_paper.yaml"  # its drive has no grip: a check fails
                self.assertEqual(run.code, 4 if slips else 0, run.screen)
                warnings = run.result["warnings"]
                self.assertEqual(len(warnings), 1 if slips else 0, warnings)
                self.assertTrue(all("the rope slips on 'drive'" in one for one in warnings), warnings)
                self.assertLess(len(run.report), 500_000)

    def most_memory(self, *args, stdin):
        """Of the program while it runs, in bytes."""
        child = subprocess.Popen([PROGRAM, *args], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, text=True)
        child.stdin.write(stdin)
        child.stdin.close()
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        self.assertIn(child.returncode, (0, 4))
        return used.ru_maxrss * 1024

    def test_memory_does_not_grow_with_the_duration(self):
        with tempfile.TemporaryDirectory() as folder:
            given = ["--set", "analyses[0].transient.step=0.1 ms", "--set", "analyses[0].transient.output_step=0.2 ms"]
            deck = (EXAMPLES / "skyline_recoil.yaml").read_text()
            short, long = (self.most_memory("run", "-", "-o", folder, "-q", *given, "--set",
                                            f"analyses[0].transient.duration={t} s", stdin=deck) for t in (1, 5))
            # 20 000 lines more; each frame of the chain takes 20 kB
            self.assertLess(long - short, 250e6, f"{short / 1e6:.0f} MB, {long / 1e6:.0f} MB")
            self.assertEqual(len(rows_of(pathlib.Path(folder) / "time.csv")[1]), 25001)


if __name__ == "__main__":
    unittest.main()
