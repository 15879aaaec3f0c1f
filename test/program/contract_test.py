#!/usr/bin/env python3
"""The program's contract, checked from outside: verbs, exit codes, JSON, files, overrides.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""
import csv
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from decks import MAST

PROGRAM = os.environ["TAUT_PROGRAM"]
EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples"
METHODS = ("mast_section", "closed_loop", "friction_drive", "boom_ropes")[2 if "TAUT_FEWER" in os.environ else 0:]
RESULT_KEYS = {"taut", "title", "method", "status", "message", "values", "tables", "checks", "steps", "series", "warnings", "errors"}
VALUE_KEYS = {"value", "unit", "symbol", "label", "source"}
CHECK_KEYS = {"name", "value", "limit", "unit", "utilisation", "passes", "rule", "trust"}
STEP_KEYS = {"eq", "symbol", "formula", "numbers", "value", "unit", "source"}



def taut(*args, stdin=""):
    return subprocess.run([PROGRAM, *args], input=stdin, capture_output=True, text=True, check=False)


def result(*args, stdin=""):
    done = taut("run", "--json", *args, stdin=stdin)
    return json.loads(done.stdout), done.returncode


class Contract(unittest.TestCase):
    def test_json_has_the_shape_of_the_contract(self):
        for deck in sorted(EXAMPLES.glob("*.yaml")):
            if deck.name.endswith(".part.yaml"):
                continue
            r, code = result(str(deck))
            self.assertIn(code, (0, 4), deck.name)
            self.assertLessEqual(RESULT_KEYS, set(r), deck.name)
            self.assertEqual(r["status"], "ok")
            self.assertEqual(r["taut"]["format"], 2)
            for name, value in r["values"].items():
                self.assertLessEqual(VALUE_KEYS, set(value), name)
                self.assertTrue(math.isfinite(value["value"]), name)
            for check in r["checks"]:
                self.assertLessEqual(CHECK_KEYS, set(check))
                self.assertTrue(check["trust"], check["name"])
            self.assertEqual(code == 0, all(c["passes"] for c in r["checks"]), deck.name)
            self.assertGreater(len(r["steps"]), 5, deck.name)
            for step in r["steps"]:
                self.assertLessEqual(STEP_KEYS, set(step))
            for name, table in r["tables"].items():
                for row in table["rows"]:
                    self.assertEqual(len(row), len(table["columns"]), name)

    def test_values_are_si_whatever_the_display(self):
        shown, _ = result("-", stdin=MAST + "display: {force: kN, length: mm}\n")
        plain, _ = result("-", stdin=MAST)
        self.assertEqual(shown["values"], plain["values"])
        self.assertAlmostEqual(plain["values"]["N"]["value"], 162638.979, places=3)
        self.assertEqual(plain["values"]["N"]["unit"], "N")

    def test_same_deck_same_bytes(self):
        for name in METHODS:
            deck = str(EXAMPLES / f"{name}.yaml")
            self.assertEqual(taut("run", deck, "--json").stdout, taut("run", deck, "--json").stdout)

    def test_set_puts_values_over_the_deck(self):
        r, code = result("-", "--set", "input.branch_angle=20 deg", "--set", "title=other", stdin=MAST)
        self.assertEqual((code, r["title"]), (0, "other"))
        self.assertAlmostEqual(r["values"]["alpha"]["value"], math.radians(20), places=12)
        done = taut("run", "-", "--set", "input.brunch_angle=20 deg", stdin=MAST)
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean 'branch_angle'", done.stderr)
        for bad in ("no-equals-sign", "=5", "input..a=5", "input.cases[x]=5"):
            self.assertEqual(taut("run", "-", "--set", bad, stdin=MAST).returncode, 2, bad)

    def test_all_mistakes_at_once_each_with_its_place(self):
        bad = MAST.replace("100 kN", "100").replace("mainline_force", "mainlin_force").replace("8 m", "8 kg")
        done = taut("run", "-", "--json", stdin=bad)
        r = json.loads(done.stdout)
        self.assertEqual((done.returncode, r["status"]), (2, "bad_deck"))
        self.assertGreaterEqual(len(r["errors"]), 3)
        for e in r["errors"]:
            self.assertLessEqual({"file", "line", "column", "message"}, set(e))
            self.assertGreater(e["line"], 0)
        self.assertIn("<stdin>:5:18: error:", done.stderr)
        self.assertIn("^", done.stderr)
        self.assertEqual(taut("check", "-", stdin=bad).returncode, 2)
        self.assertEqual(taut("check", "-", stdin=MAST).returncode, 0)

    def test_physics_says_no(self):
        drive = "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 4 kN, friction: 0.05, wrap: 20 deg, " \
                "rope_mass: 0.4 kg/m, speed: 10 m/s}\n"
        r, code = result("-", stdin=drive)
        self.assertEqual((code, r["status"]), (3, "infeasible"))
        self.assertTrue(r["message"])
        self.assertTrue(r["steps"], "the steps up to there are shown")

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in METHODS:
                out = pathlib.Path(folder) / "new" / name
                done = taut("run", str(EXAMPLES / f"{name}.yaml"), "-o", str(out))
                self.assertIn(done.returncode, (0, 4), done.stderr)
                files = {p.name for p in out.iterdir()}
                self.assertLessEqual({"result.json", "report.html"}, files)
                r = json.loads((out / "result.json").read_text())
                for series in r["series"].values():
                    self.assertIn(series["file"], files)
                html = (out / "report.html").read_text()
                self.assertLess(len(html.encode()), 500_000, name)
                self.assertNotIn("http://", html.replace("http://www.w3.org/", ""))
                self.assertNotIn("https://", html)

    def test_csv_in_the_units_of_the_report_or_si(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder)
            deck = str(EXAMPLES / "machines" / "base_tension.yaml")
            rows, results = {}, {}
            for name, more in (("shown", ()), ("si", ("--si",))):
                self.assertIn(taut("run", deck, "-q", "-o", str(out / name), *more).returncode, (0, 4))
                with open(out / name / "put_up.csv", encoding="utf-8", newline="") as file:
                    rows[name] = list(csv.reader(file))
                results[name] = json.loads((out / name / "result.json").read_text())
                # the columns of a series have the units of its file
                for series in results[name].pop("series").values():
                    if not series["file"].endswith(".csv"):
                        continue
                    with open(out / name / series["file"], encoding="utf-8", newline="") as file:
                        titles = next(csv.reader(file))
                    for title, column in zip(titles, series["columns"]):
                        unit = "" if column["unit"] == "1" else f" [{column['unit']}]"
                        self.assertEqual(title, column["name"] + unit)
            self.assertEqual(results["shown"], results["si"])
            column = rows["si"][0].index("T_start [N]")
            self.assertEqual(rows["shown"][0][column], "T_start [kN]")
            for kilonewton, newton in zip(rows["shown"][1:], rows["si"][1:]):
                self.assertAlmostEqual(float(kilonewton[column]) * 1e3, float(newton[column]), places=3)

    def test_unreadable_and_unwritable(self):
        self.assertEqual(taut("run", "/nowhere/deck.yaml").returncode, 5)
        self.assertEqual(taut("run", "/").returncode, 5)
        self.assertEqual(json.loads(taut("run", "/nowhere.yaml", "--json").stdout)["status"], "bad_deck")
        with tempfile.NamedTemporaryFile() as file:
            self.assertEqual(taut("run", "-", "-o", file.name, stdin=MAST).returncode, 5)
        if os.path.exists("/dev/full"):
            with open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([PROGRAM, "schema"], stdout=full, stderr=subprocess.DEVNULL, check=False)
            self.assertEqual(done.returncode, 5)

    def test_usage(self):
        for args in ((), ("walk",), ("run",), ("run", "--speed", "x"), ("list",), ("list", "boats"), ("explain", "magic"),
                     ("new", "magic"), ("list", "ropes", "--grade", "5 mm")):
            self.assertEqual(taut(*args).returncode, 2, args)
        for args in (("--help",), ("--version",), ("run", "--help"), ("help",), ("help", "run")):
            self.assertEqual(taut(*args).returncode, 0, args)
        for args in ((), ("walk",), ("help", "walk")):
            self.assertRegex(taut(*args).stderr, r"\n  check +Read a deck", args)
        self.assertIn("there is no verb 'rnu'; did you mean 'run'?", taut("rnu", "deck.yaml").stderr)
        self.assertIn("Usage: taut check", taut("help", "check").stdout)
        self.assertIn("\n  check ", taut("help").stdout)

    def test_new_gives_a_deck_that_runs(self):
        for name in METHODS:
            deck = taut("new", name)
            self.assertEqual(deck.returncode, 0)
            self.assertIn("#", deck.stdout, "a starter deck is commented")
            self.assertIn(taut("run", "-", "--quiet", stdin=deck.stdout).returncode, (0, 4))

    def test_explain_has_formulas_and_errata(self):
        for name in METHODS:
            text = taut("explain", name).stdout
            for part in ("Source:", "Equations", "Deck keys", "Result values", "Errata"):
                self.assertIn(part, text, name)

    def test_list(self):
        ropes = taut("list", "ropes", "--construction", "6x36", "--min-breaking-force", "150 kN").stdout
        rows = [row for row in ropes.splitlines() if "6x36" in row]
        self.assertGreater(len(rows), 5)
        self.assertTrue(all(any(t in row for t in ("verified", "derived", "unverified")) for row in rows))
        for what in ("methods", "sections", "steels", "rules", "carriages", "yarders", "units"):
            self.assertGreater(len(taut("list", what).stdout.splitlines()), 4, what)

    def test_quiet_prints_nothing(self):
        done = taut("run", "-", "--quiet", stdin=MAST)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))


if __name__ == "__main__":
    unittest.main()
