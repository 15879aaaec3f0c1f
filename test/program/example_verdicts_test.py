"""Each example has the verdict that its author would sign: verdict, class, exit code, and what its reason names.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import example_runs

PROGRAM = os.environ["TAUT_PROGRAM"]
EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples"
RUN = example_runs.those_that_run()
GUIDE = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "docs/guide/reference.md"

PASSES = ("passes", None, 0)
WARNS = ("passes_with_warnings", None, 0)
FAILS = ("fails", None, 4)
UNASKED = ("not_judged", "unasked", 0)

# deck: verdict, words of its reason
VERDICTS = {
    "boom_ropes.yaml": (UNASKED, "extension, retraction"),  # the paper names no ropes
    "closed_loop.yaml": (PASSES, "return rope"),
    "friction_drive.yaml": (FAILS, "no slip"),  # the published tension; the deck says so
    "mast_section.yaml": (PASSES, "CHS 610x25"),
    "design/crane_hoist.yaml": (WARNS, "hoist.termination"),
    "design/guyed_tower.yaml": (WARNS, "unverified"),
    "design/loop_by_cases.yaml": (WARNS, "traction.elastic_limit"),
    "design/mast_case_a.yaml": (FAILS, "factored"),  # shows what a bare check hides
    "design/rope_saw_life.yaml": (WARNS, "saw.on_sheave"),
    "design/saw_take_up.yaml": (WARNS, "saw.on_sheave"),
    "design/swiss_skyline.yaml": (WARNS, "unverified"),
    "design/yarder_mast.yaml": (WARNS, "unverified"),
    "machines/base_tension.yaml": (WARNS, "skyline.elastic_limit"),
    "machines/clamped_load.yaml": (PASSES, "skyline.safety_factor"),
    "machines/counterweighted_ropeway.yaml": (WARNS, "haul.safety_factor"),
    "machines/dragged_bunch.yaml": (PASSES, "mainline.safety_factor"),
    "machines/endless_haul.yaml": (WARNS, "haul.on_sheave"),
    "machines/guyed_tower.yaml": (WARNS, "g1.pretension_min"),
    "machines/guys_pulled_in_turn.yaml": (PASSES, "g2.safety_factor"),
    "machines/rope_saw_drive.yaml": (WARNS, "saw.on_sheave"),
    "machines/running_skyline.yaml": (WARNS, "haulback.on_sheave"),
    "machines/six_part_tackle.yaml": (PASSES, "hoist.sheave_ratio"),
    "machines/skyline_over_jacks.yaml": (PASSES, "carries 1.575"),
    "machines/skyline_over_terrain.yaml": (PASSES, "carries 0.47"),
    "machines/three_span_skyline.yaml": (PASSES, "carries 2.876"),
    "machines/tower_yarder.yaml": (WARNS, "mainline.on_sheave"),
    "machines/two_section_loop.yaml": (WARNS, "return.on_sheave"),
    "machines/yarder_and_carriage.yaml": (WARNS, "skyline.on_sheave"),
    "more/guyed_mast.yaml": (WARNS, "guylines"),
    "more/rope_saw_take_up.yaml": (UNASKED, "rope"),  # its grip holds; the deck gives no limit for its rope
    "motion/brake_stop.yaml": (PASSES, "hoist.sheave_ratio"),
    "motion/equal_ropes.yaml": (UNASKED, "new, old"),
    "motion/hoist_in_segments.yaml": (WARNS, "winder.on_sheave"),
    "motion/longspan_sag.yaml": (PASSES, "skyline.safety_factor"),
    "motion/rope_break.yaml": (PASSES, "The deck breaks skyline"),
    "motion/rope_saw.yaml": (WARNS, "loop.on_sheave"),
    "motion/rope_saw_fixed.yaml": (PASSES, "drive.grip"),
    "motion/rope_saw_paper.yaml": (FAILS, "drive.grip"),  # the published tension slips
    "motion/skyline_load_drop.yaml": (WARNS, "The deck breaks strop"),
    "motion/skyline_recoil.yaml": (PASSES, "The deck breaks skyline"),
    "motion/slewing_crane.yaml": (PASSES, "hoist.dynamic_safety_factor"),
    "motion/tackle_hoist.yaml": (UNASKED, "hoist"),  # its dynamic factor is judged, not its strength
    "motion/two_motors.yaml": (WARNS, "loop.on_sheave"),
    "motion/yarder_pickup.yaml": (WARNS, "tower.wall"),
    "study/boom_break_chance.yaml": (UNASKED, "The deck breaks retraction"),  # one motion of the study
    "study/calibrated_line.yaml": (PASSES, "carries 2.876"),
    "study/mast_chance.yaml": (PASSES, "CHS 610x25"),
    "study/rope_life_chance.yaml": (WARNS, "saw.on_sheave"),
    "study/three_span_chance.yaml": (PASSES, "carries 2.876"),
}
# explorations of one boom against published figures: no limit is asked
BOOM = "telescopic_boom"
JUDGED_BOOM = ["row1.yaml", "pretension.yaml", "force_52_load.yaml", "slip_out_21_hook.yaml"]


def patterns_of(rows):
    """Of the columns in the reference: a word in capitals, or N behind a line, is any text."""
    return [re.compile(re.sub(r"[A-Z]{3,}|(?<=_)N$", ".+", re.escape(name))) for name in rows]


def reference():
    """Tables of docs/guide/reference.md: heading of their section -> name -> columns."""
    sections = {}
    tables, columns = {}, []
    for line in GUIDE.read_text().splitlines():
        if head := re.match(r"## (.+)", line):
            tables = sections[head[1]] = {}
            columns = []
        elif head := re.match(r"### (Table `(.+)`)?", line):
            columns = []
            if head[2]:
                tables[head[2]] = columns
        elif row := re.match(r"\| `(.+?)` \|", line):
            columns.append(row[1])
    return sections


REFERENCE = reference()


def tables_for(method):
    """What the result of a machine, a method or a comparison may have: name -> columns."""
    if method == "compare":
        return REFERENCE["Table of `taut compare`"]
    own = [REFERENCE["Results of a machine"]] if method == "machine" else [
        REFERENCE["Tables of the methods"], REFERENCE[f"Tables of `method: {method}`"]]
    return {name: columns for group in own + [REFERENCE["Tables of checks"], REFERENCE["Tables of a design"]]
            for name, columns in group.items()}


def described(table, columns, known):
    """The columns that the reference gives a table: its name may have the ending of its analysis, "spans_hoist"."""
    if "t_min" in columns:
        return known["envelope (of a motion)"]
    fitting = [t for t in known if re.fullmatch(re.sub(r"[A-Z]{3,}", ".+", re.escape(t)) + "(_.+)?", table)]
    return known[max(fitting, key=len)] if fitting else None


def named_by_the_deck(place, table, column, result):
    """What stands for any name at all has to be one of the deck: an unknown of the design, or what is observed."""
    if place == "UNKNOWN":
        return column != "cost" and f"design_{column}" in result["values"]
    if table.startswith("time"):
        return any(row[0] == column for t in result["tables"].values() for row in t["rows"])
    return any(re.fullmatch(re.escape(column) + r"_\d+(_.+)?", value) for value in result["values"])


class ExampleVerdicts(unittest.TestCase):
    def check(self, name, run, expected, words):
        said = (run.result["verdict"], run.result["verdict_class"], run.code)
        self.assertEqual(said, expected, f"{name}: {run.result['verdict_reason']}")
        self.assertIn(words, run.result["verdict_reason"], name)

    def check_described(self, name, result):
        """The reference, made of the quantities, has every column of every table."""
        known = tables_for(result["method"])
        series = {t: content for t, content in result.get("series", {}).items() if t.startswith("time")}
        for table, content in [*result["tables"].items(), *series.items()]:
            columns = [c["name"] for c in content["columns"]]
            names = described(table, columns, known)
            self.assertIsNotNone(names, f"{name}: the reference has no table {table}")
            places = [place for place in names if re.fullmatch("[A-Z]{3,}", place)]
            patterns = patterns_of([place for place in names if place not in places])
            unknown = [c for c in columns if not any(p.fullmatch(c) for p in patterns)
                       and not any(named_by_the_deck(place, table, c, result) for place in places)]
            self.assertEqual(unknown, [], f"{name}: table {table}")

    def check_answers(self, name, result):
        """Page 1 has something to say and to show; nothing that fails or is not judged is to be built."""
        answers = result["answers"]
        self.assertTrue(answers, f"{name}: no answer")
        self.assertLessEqual(len(answers), 8, name)
        for answer in answers:
            self.assertTrue(answer["label"] and answer["text"], f"{name}: {answer}")
            self.assertLessEqual(len(answer["text"]), 240, f"{name}: {answer}")
            self.assertNotRegex(answer["text"], r"\bnan\b|\binf\b", f"{name}: {answer}")
        if result["verdict"] not in ("passes", "passes_with_warnings"):
            self.assertNotIn("Build", [a["label"] for a in answers], name)
        self.assertIn(result["key_figure"], result["figures"], name)
        self.assertNotEqual(result["key_figure"], "", name)

    def test_every_example_has_a_row(self):
        names = set(example_runs.names())
        self.assertEqual(names, set(VERDICTS) | {name for name in names if name.startswith(BOOM)})

    def test_those_that_judge(self):
        for name, run in example_runs.of_all([name for name in VERDICTS if name in RUN]):
            with self.subTest(name):
                self.check(name, run, *VERDICTS[name])
                self.check_described(name, run.result)
                self.check_answers(name, run.result)

    def test_the_screen(self):
        """At most 40 lines for any deck, with the names of the files; the last is the verdict's sentence."""
        for name, run in example_runs.of_all([name for name in VERDICTS if name in RUN]):
            with self.subTest(name):
                lines = run.screen.splitlines()
                self.assertLessEqual(len(lines), 40)
                self.assertTrue(lines[-1].endswith(": " + run.result["verdict_reason"]), lines[-1])

    def test_explorations(self):
        """All are described; of some the verdict is known here."""
        for name, run in example_runs.of_all([name for name in RUN if name.startswith(BOOM)]):
            with self.subTest(name):
                if name.removeprefix(f"{BOOM}/") in JUDGED_BOOM:
                    self.check(name, run, UNASKED, "limit")
                self.check_described(name, run.result)
                self.check_answers(name, run.result)

    def test_a_comparison_is_described(self):
        with tempfile.TemporaryDirectory() as place:
            shutil.copy(EXAMPLES / "friction_drive.yaml", place)
            pathlib.Path(place, "compare.part.yaml").write_text(
                "taut: 1\ncompare:\n  source: the paper\n"
                "  values: [{what: initial tension, deck: friction_drive.yaml, value: P_M, published: 1 kN}]\n")
            got = subprocess.run([PROGRAM, "compare", place, "--json", "--quiet"], capture_output=True, text=True)
        result = json.loads(got.stdout)
        self.assertIn("compared", result["tables"], result["message"])
        self.check_described("compare", result)
        self.check_answers("compare", result)

    def test_the_ropes_of_the_boom_are_judged_once_they_have_limits(self):
        deck = (EXAMPLES / "boom_ropes.yaml").read_text()
        ropes = {"extension": 1.5, "retraction": 1.5}
        for limited in (["extension"], ["extension", "retraction"]):
            checks = "checks:\n  ropes:\n" + "".join(
                f"    {name}: {{breaking_force: 400 kN, safety_factor: {ropes[name]}}}\n" for name in limited)
            got = subprocess.run([PROGRAM, "run", "-", "--json", "--quiet"], input=deck + checks, capture_output=True, text=True)
            result = json.loads(got.stdout)
            self.assertEqual(got.returncode, 0, result["message"])
            self.assertEqual(result["verdict_class"], "unasked" if len(limited) == 1 else None, result["verdict_reason"])


if __name__ == "__main__":
    unittest.main()
