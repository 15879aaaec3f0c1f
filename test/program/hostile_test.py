#!/usr/bin/env python3
"""Decks and surroundings that mean no good: a clear message, the exit code of the contract, no crash, no leak.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""
import csv
import json
import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import unittest

from decks import MAST

PROGRAM = os.environ["TAUT_PROGRAM"]
EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples"
SANITIZED = bool(os.environ.get("TAUT_FEWER"))

LINE = """taut: 1
machine:
  terrain: {file: %s}
  points: {A: [0 m, 0 m, 20 m], B: [100 m, 0 m, 22 m]}
  ropes: {skyline: {diameter: 20 mm, mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 250 kN}}
  reevings:
    - {name: sky, rope: skyline, tension_at_start: 40 kN, path: [{anchor: A}, {anchor: B}]}
"""


def taut(*args, stdin="", **more):
    """Nothing here may take long: what hangs is ended by CPU time or, where it sleeps, after ten minutes."""
    return subprocess.run([PROGRAM, *map(str, args)], input=stdin, capture_output=True, text=True, check=False, errors="replace", **more)


def shell(command, *args, stdin=MAST):
    return subprocess.run(["bash", "-c", command, PROGRAM, *map(str, args)], input=stdin, capture_output=True, text=True,
                          check=False)


class Hostile(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.top = pathlib.Path(self.scratch.name)
        self.deck = self.top / "deck.yaml"
        self.deck.write_text(MAST)

    def tearDown(self):
        self.scratch.cleanup()

    def test_what_is_no_file_is_refused_at_once(self):
        os.mkfifo(self.top / "fifo")
        server = socket.socket(socket.AF_UNIX)
        self.addCleanup(server.close)
        server.bind(str(self.top / "socket"))
        (self.top / "folder").mkdir()
        for name in ("fifo", "socket", "folder", "/dev/zero", "/dev/tty", "/dev/full"):
            path = self.top / name
            if not path.exists():
                continue
            for deck in (None, MAST + f"include: {path}\n", LINE % path,
                         LINE % "x.csv" + f"include: [{path}]\n" + "checks: {}\n"):
                if deck is not None:
                    self.deck.write_text(deck)
                (self.top / "x.csv").write_text("x,z\n0,0\n100,0\n")
                for verb in ("run", "check"):
                    done = taut(verb, path if deck is None else self.deck, "--json")
                    self.assertEqual(done.returncode, 5, (name, deck, done.stderr))
                    self.assertIn("is not a file", done.stderr)
                    self.assertEqual(json.loads(done.stdout)["status"], "bad_deck")

    def test_a_missing_file_beside_other_mistakes_is_a_mistake_of_the_deck(self):
        self.assertEqual(taut("run", "-", stdin=MAST + "include: /nowhere.yaml\n").returncode, 2)
        self.assertEqual(taut("run", "-", stdin=MAST + "include: /dev/zero\nspeed: 1\nspeed: 2\n").returncode, 2)

    def test_a_pipe_that_the_shell_opened_is_read(self):
        for command in ('exec "$0" run -q <(cat "$1")', 'cat "$1" | exec "$0" run -q /dev/stdin',
                        'exec "$0" run -q /dev/fd/7 7<"$1"'):
            self.assertIn(shell(command, self.deck).returncode, (0, 4), command)
        self.assertEqual(shell('exec "$0" run /dev/fd/77').returncode, 5)

    def test_messages_do_not_quote_other_files(self):
        secret = "hunter2:x:0:0:the_password"
        for text in (secret + "\n", f"password: {secret}\n", f"input: {{skyline_force: {secret}}}\n",
                     f"[{secret}\n", f"machine: {{ropes: {{a: {secret}}}}}\n", f"{secret}: {{\n", f"include: {secret}\n",
                     f"display: {{force: {secret}}}\n", f"parameters: {{hunter2: {secret}, x: = hunter2 + 1}}\n"):
            (self.top / "secret").write_text(text)
            for deck in (MAST + "include: secret\n", LINE % "secret",
                         MAST + "design: {catalogue: secret, ropes: {a: {}}}\n"):
                self.deck.write_text(deck)
                done = taut("run", self.deck, "--json")
                self.assertIn(done.returncode, (0, 2), text)  # the deck's own keys may stand over those of the file
                self.assertNotIn("hunter2", done.stderr + done.stdout, text)
                if done.returncode == 2:
                    self.assertIn("secret", done.stderr)

    def test_texts_in_tables_are_no_formulas(self):
        rows = "taut: 1\ntitle: t\ncompare:\n  source: x\n  values:\n" + "".join(
            f"    - {{what: {json.dumps(what)}, deck: deck.yaml, value: N}}\n"
            for what in ("+1+1", "-2+3", "@SUM(A1)", "\t=1", "fine", "a=1"))
        (self.top / "set.part.yaml").write_text(rows)
        done = taut("compare", self.top / "set.part.yaml", "-q", "-o", self.top / "out")
        self.assertIn(done.returncode, (0, 4), done.stderr)
        with open(self.top / "out" / "compared.csv", encoding="utf-8", newline="") as file:
            cells = [row[0] for row in csv.reader(file)][1:]
        self.assertEqual(cells, ["'+1+1", "'-2+3", "'@SUM(A1)", "'\t=1", "fine", "a=1"])

    def test_outputs_that_are_closed_or_full(self):
        out = self.top / "out"
        both = 'exec "$0" run - >&- 2>&-'
        self.assertEqual(shell(both).returncode, 5)
        self.assertEqual(shell('exec "$0" run - >&-').returncode, 5)
        self.assertIn(shell('exec "$0" run - 2>&-').returncode, (0, 4))
        self.assertIn(shell('exec "$0" run - 2>/dev/full').returncode, (0, 4))
        self.assertEqual(shell('exec "$0" run - >/dev/full 2>/dev/full').returncode, 5)
        self.assertEqual(shell('exec "$0" run - <&- >&- 2>&-').returncode, 5)
        self.assertEqual(shell('exec "$0" run - <&-').returncode, 5)
        self.assertEqual(shell('exec "$0" run nowhere.yaml 2>&-').returncode, 5)
        self.assertEqual(shell('exec "$0" run - 2>/dev/full', stdin="x").returncode, 2)
        self.assertEqual(shell('exec "$0" --help >/dev/full').returncode, 5)
        self.assertEqual(shell('exec "$0" list ropes >&-').returncode, 5)
        # with the files asked for, they are written and hold nothing of what goes to the screen
        for command in (both,) if SANITIZED else (both, 'exec "$0" run - -q >&- 2>&-', 'exec "$0" run - <&0 >&- 2>&-'):
            self.assertIn(shell(command + ' -o "$1"', out).returncode, (0, 4, 5))
            alone = self.top / "alone"
            self.assertIn(shell('exec "$0" run - -q -o "$1"', alone).returncode, (0, 4))
            for path in alone.iterdir():
                self.assertEqual(path.read_bytes(), (out / path.name).read_bytes(), path.name)

    def test_a_closed_pipe_is_silent(self):
        for command in ('"$0" list ropes | head -1', '"$0" schema | true', '"$0" run - --json | head -1',
                        '"$0" --help | true', '"$0" explain mast_section | true'):
            done = shell("set -o pipefail; " + command)
            self.assertEqual(done.stderr, "", command)
            self.assertIn(done.returncode, (0, 4), command)

    @unittest.skipIf(SANITIZED, "the sanitizers need descriptors, files and memory of their own")
    def test_limits_of_the_system(self):
        out = self.top / "out"
        transient = EXAMPLES / "motion" / "tackle_hoist.yaml"
        for limit, allowed in (("-n 5", (0, 4, 5)), ("-n 6", (0, 4, 5)),
                               ("-f 0", (5,)), ("-f 1", (5,)), ("-f 40", (5,))):
            for deck in (self.deck, transient):
                shutil.rmtree(out, ignore_errors=True)
                done = shell(f'ulimit {limit}; exec "$0" run "$1" -q -o "$2"', deck, out, stdin="")
                self.assertIn(done.returncode, allowed, (limit, deck, done.stderr))
                if done.returncode == 5:
                    self.assertTrue(done.stderr)
                    self.assertFalse(out.exists(), "nothing by half")
        done = shell('ulimit -f 1; exec "$0" schema >"$1"', self.top / "schema", stdin="")
        self.assertEqual(done.returncode, 5)

    def test_texts_that_are_no_decks(self):
        hostile = {
            "deep": "taut: 1\n" + "a: " + "[" * 5000 + "]" * 5000 + "\n",
            "deep blocks": "".join(" " * i + f"k{i}:\n" for i in range(2000)),
            "braces": "{" * 100000,
            "laughs": "a: &a [x,x]\n" + "".join(f"b{i}: &b{i} [*b{i - 1}, *b{i - 1}]\n" if i else "b0: &b0 [*a, *a]\n"
                                                 for i in range(40)),
            "merge": "taut: 1\n<<: &x {<<: *x}\n",
            "long line": "taut: 1\ntitle: " + "x" * 3_000_000 + "\nspeed: 1\n",
            "long key": "taut: 1\n" + "x" * 500_000 + ": 1\n",
            "nul": "taut: 1\0\n",
            "many keys": "".join(f"k{i}: 1\n" for i in range(100_000)),
            "many documents": "---\na: 1\n" * 50_000,
            "quotes": "'" * 99_999,
            "comment": "#" * 1_000_000,
            "expression": MAST.replace("8 m", "= " + "(" * 10_000 + "1" + ")" * 10_000),
            "power": MAST.replace("8 m", "= 9^9^9^9^9^9 * 1 m"),
            "large": "#" * (16 * 1024 * 1024 + 1),
            "tag": "!!python/object:os.system {x: 1}\n",
        }
        for name, text in hostile.items():
            self.deck.write_text(text)
            done = taut("check", self.deck)
            self.assertEqual(done.returncode, 2, (name, done.stderr[:300]))
            self.assertIn("error: ", done.stderr, name)
            self.assertLess(len(done.stderr), 40_000, name)
            self.assertLess(max(map(len, done.stderr.splitlines())), 1000, name)

    def test_circles_of_includes(self):
        (self.top / "a.yaml").write_text("taut: 1\ninclude: b.yaml\n")
        (self.top / "b.yaml").write_text("include: [c.yaml, ./sub/../c.yaml]\n")
        (self.top / "c.yaml").write_text("include: b.yaml\n")
        (self.top / "sub").mkdir()
        done = taut("check", self.top / "a.yaml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("includes itself", done.stderr)
        # each of twenty files includes the next one ten times
        for i in range(20):
            (self.top / f"n{i}.yaml").write_text(f"include: [{', '.join([f'n{i + 1}.yaml'] * 10)}]\n")
        (self.top / "n20.yaml").write_text("taut: 1\n")
        done = taut("check", self.top / "n0.yaml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("more than", done.stderr)


if __name__ == "__main__":
    unittest.main()
