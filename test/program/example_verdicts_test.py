"""Each example has the verdict that its author would sign: verdict, class, exit code, and what its reason names.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""

import json
import os
import pathlib
import re
import subprocess
import unittest

PROGRAM = os.environ["TAUT_PROGRAM"]
EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples"
FEWER = "TAUT_FEWER" in os.environ
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
    "machines/six_part_tackle.yaml": (PASSES, "hoist.safety_factor"),
    "machines/three_span_skyline.yaml": (PASSES, "carries 2.957"),
    "machines/tower_yarder.yaml": (WARNS, "mainline.on_sheave"),
    "machines/two_section_loop.yaml": (WARNS, "return.on_sheave"),
    "more/guyed_mast.yaml": (WARNS, "guylines"),
    "more/rope_saw_take_up.yaml": (FAILS, "no slip"),  # the published tension, as always
    "motion/longspan_sag.yaml": (PASSES, "skyline.safety_factor"),
    "motion/rope_break.yaml": (PASSES, "The deck breaks skyline"),
    "motion/rope_saw.yaml": (WARNS, "loop.on_sheave"),
    "motion/rope_saw_fixed.yaml": (PASSES, "drive.grip"),
    "motion/rope_saw_paper.yaml": (FAILS, "drive.grip"),  # the published tension slips
    "motion/skyline_load_drop.yaml": (WARNS, "The deck breaks strop"),
    "motion/skyline_recoil.yaml": (PASSES, "The deck breaks skyline"),
    "motion/slewing_crane.yaml": (PASSES, "hoist.dynamic_safety_factor"),
    "motion/tackle_hoist.yaml": (WARNS, "hoist.phi2"),
    "motion/yarder_pickup.yaml": (WARNS, "tower.wall"),
}
# explorations of one boom against published figures: no limit is asked; the quick ones of them run here
BOOM = "telescopic_boom"
QUICK_BOOM = ["row1.yaml", "pretension.yaml", "force_52_load.yaml", "slip_out_21_hook.yaml"]
LONG = ["design/guyed_tower.yaml"]  # 20 s


# tables that come with checks and designs, not with an analysis
OF_CHECKS = ("anchor_forces", "design", "discard", "guys", "life", "mast_sections", "masts")


def reference():
    """Tables of docs/guide/reference.md: name -> patterns of its columns; a word in capitals, or N, is any text."""
    tables = {}
    for line in GUIDE.read_text().splitlines():
        if head := re.match(r"### Table `(.+)`", line):
            columns = tables[head[1]] = []
        elif line.startswith("### "):
            columns = []
        elif tables and (row := re.match(r"\| `(.+?)` \|", line)):
            columns.append(re.compile(re.sub(r"[A-Z]{3,}|(?<=_)N$", ".+", re.escape(row[1]))))
    return tables


def decks():
    return {p.relative_to(EXAMPLES).as_posix() for p in EXAMPLES.rglob("*.yaml") if not p.name.endswith(".part.yaml")}


REFERENCE = reference()


class ExampleVerdicts(unittest.TestCase):
    def check(self, name, expected, words):
        got = subprocess.run([PROGRAM, "run", str(EXAMPLES / name), "--json", "--quiet"], capture_output=True, text=True)
        result = json.loads(got.stdout)
        said = (result["verdict"], result["verdict_class"], got.returncode)
        self.assertEqual(said, expected, f"{name}: {result['verdict_reason']}")
        self.assertIn(words, result["verdict_reason"], name)
        if result["method"] == "machine":
            self.check_described(name, result["tables"])

    def check_described(self, name, tables):
        """The reference, made of the quantities, has every column of every table of an analysis."""
        for table, content in tables.items():
            if table.startswith(OF_CHECKS):
                continue
            known = [t for t in REFERENCE if table == t or table.startswith(t + "_")]
            self.assertTrue(known, f"{name}: the reference has no table {table}")
            columns = [c["name"] for c in content["columns"]]
            described = max(known, key=len)
            if described == "envelope" and "quantity" in columns and "t_min" in columns:
                described = "envelope (of a motion)"
            unknown = [c for c in columns if not any(p.fullmatch(c) for p in REFERENCE[described])]
            if described == "tensioning":  # and whatever the deck observes
                unknown = [c for c in unknown if "." in c and c.split(".")[-1] in ("T_start", "T_end")]
            self.assertEqual(unknown, [], f"{name}: table {table}")

    def test_every_example_has_a_row(self):
        rows = set(VERDICTS) | {name for name in decks() if name.startswith(BOOM)}
        self.assertEqual(decks(), rows)

    def test_those_that_judge(self):
        for name, (expected, words) in VERDICTS.items():
            if FEWER and not name.startswith("machines/") or name in LONG:
                continue
            with self.subTest(name):
                self.check(name, expected, words)

    def test_explorations(self):
        for name in QUICK_BOOM[:1] if FEWER else QUICK_BOOM:
            with self.subTest(name):
                self.check(f"{BOOM}/{name}", UNASKED, "limit")

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
