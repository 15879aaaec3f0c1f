#!/usr/bin/env python3
"""The output folder is one result: whole whatever happens, and nobody else's files are touched.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

from decks import MAST

PROGRAM = os.environ["TAUT_PROGRAM"]
EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples"

DRIVE = "taut: 1\nmethod: friction_drive\ninput: {cutting_force: 4 kN, friction: 0.3, wrap: 180 deg, " \
        "rope_mass: 0.4 kg/m, speed: 10 m/s}\n"
LINE = """taut: 1
title: line over a terrain
include: ropes.part.yaml
machine:
  terrain: {file: ground.csv}
  points: {A: [0 m, 0 m, 20 m], B: [100 m, 0 m, 22 m]}
  reevings:
    - {name: sky, rope: skyline, tension_at_start: 40 kN, path: [{anchor: A}, {anchor: B}]}
"""
ROPES = "machine: {ropes: {skyline: {diameter: 20 mm, mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 250 kN}}}\n"
GROUND = "x,z\n0,0\n50,-4\n100,1\n"


def taut(*args, stdin="", **more):
    return subprocess.run([PROGRAM, *map(str, args)], input=stdin, capture_output=True, text=True, check=False, **more)


def sha1(text):
    return hashlib.sha1(text.encode()).hexdigest()


class Files(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.top = pathlib.Path(self.scratch.name)
        (self.top / "mast.yaml").write_text(MAST)
        self.before = {p.name for p in self.top.iterdir()}

    def tearDown(self):
        self.scratch.cleanup()

    def run_into(self, out, deck=MAST):
        done = taut("run", "-", "-q", "-o", out, stdin=deck)
        self.assertIn(done.returncode, (0, 3, 4), done.stderr)
        return done

    def expect_nothing_beside(self, *names):
        self.assertEqual({p.name for p in self.top.iterdir()}, self.before | set(names))

    def written(self, folder):
        return {p.name for p in folder.iterdir() if not p.name.startswith(".taut")}

    def test_files_of_an_earlier_run_are_gone(self):
        out, alone = self.top / "out", self.top / "alone"
        self.run_into(out, MAST)
        of_mast = self.written(out)
        self.run_into(out, DRIVE)
        self.run_into(alone, DRIVE)
        self.assertEqual(self.written(out), self.written(alone))
        self.assertTrue(of_mast - self.written(out), "the two decks write files of different names")
        for name in self.written(out):
            self.assertEqual((out / name).read_bytes(), (alone / name).read_bytes(), name)
        self.expect_nothing_beside("out", "alone")

    def test_files_of_an_earlier_version_are_gone(self):
        out = self.top / "out"
        self.run_into(out, MAST)
        of_mast = self.written(out)
        (out / ".taut-files").unlink()
        (out / "notes.txt").write_text("mine")
        self.run_into(out, DRIVE)
        self.run_into(self.top / "alone", DRIVE)
        self.assertEqual(self.written(out), self.written(self.top / "alone") | {"notes.txt"})
        self.assertTrue(of_mast - self.written(out))
        self.assertEqual((out / "notes.txt").read_text(), "mine")

    def test_files_of_others_stay(self):
        out = self.top / "out"
        out.mkdir()
        (out / "deck.yaml").write_text(MAST)
        (out / "photos").mkdir()
        (out / "photos" / "mast.jpg").write_text("jpg")
        for _ in range(2):
            done = taut("run", out / "deck.yaml", "-q", "-o", out)
            self.assertIn(done.returncode, (0, 4), done.stderr)
            self.assertEqual((out / "deck.yaml").read_text(), MAST)
            self.assertEqual((out / "photos" / "mast.jpg").read_text(), "jpg")
        # a name of ours that somebody else's file has
        other = self.top / "other"
        other.mkdir()
        (other / "report.html").write_text("mine")
        done = taut("run", "-", "-q", "-o", other, stdin=MAST)
        self.assertEqual(done.returncode, 5)
        self.assertIn("report.html", done.stderr)
        self.assertEqual([p.name for p in other.iterdir()], ["report.html"])
        self.assertEqual((other / "report.html").read_text(), "mine")

    def test_what_no_folder_can_be(self):
        for args in (("-o", ""), ("--output", ""), ("--output=",)):
            done = taut("run", "mast.yaml", *args, cwd=self.top)
            self.assertEqual(done.returncode, 2, args)
        for folder in (".", "/", "/proc", "mast.yaml", "mast.yaml/out"):
            done = taut("run", "mast.yaml", "-q", "-o", folder, cwd=self.top)
            self.assertEqual(done.returncode, 5, folder)
            self.assertIn(folder, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        os.symlink("nowhere", self.top / "dangling")
        self.assertEqual(taut("run", "mast.yaml", "-o", "dangling", cwd=self.top).returncode, 5)
        self.expect_nothing_beside("dangling")

    def test_a_link_to_a_folder_stays_a_link(self):
        (self.top / "real").mkdir()
        os.symlink("real", self.top / "link")
        for deck in (MAST, DRIVE):
            self.run_into(self.top / "link", deck)
        self.assertTrue((self.top / "link").is_symlink())
        self.assertTrue((self.top / "real" / "result.json").exists())
        self.expect_nothing_beside("real", "link")

    def test_a_kill_leaves_the_old_or_the_new_result_whole(self):
        deck = str(EXAMPLES / "motion" / "tackle_hoist.yaml")
        out = self.top / "out"
        sets = [["--set", f"title={name}"] for name in ("one", "two")]
        whole = {}
        for i, more in enumerate(sets):
            done = taut("run", deck, "-q", "-o", out, *more)
            self.assertIn(done.returncode, (0, 4), done.stderr)
            whole[i] = {p.name: p.read_bytes() for p in out.iterdir()}
        self.assertIn("series.h5", whole[0])
        kills = 6 if os.environ.get("TAUT_FEWER") else 24
        for k in range(kills):
            more = sets[k % 2]
            running = subprocess.Popen([PROGRAM, "run", deck, "-q", "-o", str(out), *more])
            time.sleep(0.01 * (1 + k))
            running.send_signal(signal.SIGKILL)
            running.wait()
            found = {p.name: p.read_bytes() for p in out.iterdir()}
            self.assertIn(found, whole.values(), f"kill {k}: {sorted(found)}")
        self.assertIn(taut("run", deck, "-q", "-o", out, *sets[0]).returncode, (0, 4))
        self.expect_nothing_beside("out")

    def test_two_runs_at_once_do_not_mix(self):
        out = self.top / "out"
        whole = []
        for deck in (MAST, DRIVE):
            self.run_into(self.top / "alone", deck)
            whole.append({p.name: p.read_bytes() for p in (self.top / "alone").iterdir()})
        for _ in range(2 if os.environ.get("TAUT_FEWER") else 5):
            running = [subprocess.Popen([PROGRAM, "run", "-", "-q", "-o", str(out)], stdin=subprocess.PIPE, text=True)
                       for _ in range(6)]
            for k, one in enumerate(running):
                one.stdin.write((MAST, DRIVE)[k % 2])
                one.stdin.close()
            for one in running:
                self.assertIn(one.wait(), (0, 4))
            self.assertIn({p.name: p.read_bytes() for p in out.iterdir()}, whole)
        self.expect_nothing_beside("out", "alone")

    def test_a_failed_write_leaves_the_old_result(self):
        out = self.top / "out"
        self.run_into(out, MAST)
        old = {p.name: p.read_bytes() for p in out.iterdir()}
        done = subprocess.run(["sh", "-c", 'ulimit -f 8; exec "$0" run - -q -o "$1"', PROGRAM, str(out)], input=DRIVE,
                              text=True, capture_output=True, check=False)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("File too large", done.stderr)
        self.assertEqual({p.name: p.read_bytes() for p in out.iterdir()}, old)
        self.expect_nothing_beside("out")

    def test_the_hash_is_of_everything_that_was_read(self):
        for name, text in (("line.yaml", LINE), ("ropes.part.yaml", ROPES), ("ground.csv", GROUND)):
            (self.top / name).write_text(text)

        def hash_of(*args, deck="line.yaml"):
            done = taut("run", self.top / deck, "--json", *args)
            self.assertIn(done.returncode, (0, 4), done.stderr)
            return json.loads(done.stdout)["taut"]["deck_hash"]

        # of a deck alone it is the deck's own
        self.assertEqual(hash_of(deck="mast.yaml"), sha1(MAST))
        plain = hash_of()
        self.assertEqual(plain, sha1(f"deck {sha1(LINE)}\nfile {sha1(ROPES)}\nfile {sha1(GROUND)}\n"))
        self.assertEqual(plain, hash_of())
        seen = {plain, hash_of("--set", "title=x"), hash_of("--set", "title=y"),
                hash_of("--set", "title=x", "--set", "title=y")}
        for name, text in (("line.yaml", LINE + "# x\n"), ("ropes.part.yaml", ROPES + "# x\n"),
                           ("ground.csv", GROUND.replace("-4", "-5"))):
            before = (self.top / name).read_text()
            (self.top / name).write_text(text)
            seen.add(hash_of())
            (self.top / name).write_text(before)
        self.assertEqual(len(seen), 7)
        self.assertEqual(plain, hash_of())

    def test_the_report_names_hash_and_overrides(self):
        out = self.top / "out"
        done = taut("run", "-", "-o", out, "--set", "input.branch_angle=13 deg", "--set", "title=<b>", stdin=MAST)
        self.assertIn(done.returncode, (0, 4))
        head = json.loads((out / "result.json").read_text())["taut"]
        self.assertEqual(head["overrides"], ["input.branch_angle=13 deg", "title=<b>"])
        self.assertRegex(head["deck_hash"], "^[0-9a-f]{40}$")
        for text in ((out / "report.html").read_text(), (out / "report.md").read_text()):
            self.assertIn(head["deck_hash"], text)
            self.assertIn("input.branch_angle=13 deg", text)
            self.assertNotIn("title=<b>", text)
        self.assertIn(head["deck_hash"][:16], done.stdout)
        self.assertIn("input.branch_angle=13 deg", done.stdout.replace("\n   ", " ").replace("\n  ", " "))
        self.assertIn("--set none", taut("run", "-", stdin=MAST).stdout)


if __name__ == "__main__":
    unittest.main()
