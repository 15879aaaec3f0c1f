#!/usr/bin/env python3
"""The telescopic boom's decks against an independent model with the same data: table 2 and figure 4 of the paper.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""
import json
import os
import pathlib
import subprocess
import unittest

PROGRAM = os.environ["TAUT_PROGRAM"]
DECKS = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples" / "telescopic_boom"

# deck, value, the model's figure, how near: N, the second a share of it or, over 1, newtons
REFERENCE = (
    ("row1", "S1", 94.9e3, 0.01), ("row1", "S2", 188.4e3, 0.01),
    ("row2", "S1", 177.5e3, 0.015), ("row2", "S2", 17.3e3, 2.5e3),
    ("row3", "S1", 164.3e3, 0.015), ("row3", "S2", 44.6e3, 2.5e3),
    ("row4", "S1", 105.0e3, 0.01), ("row4", "S2", 168.1e3, 0.01),
    ("row5", "S1", 110.8e3, 0.015), ("row5", "S2", 151.9e3, 0.015),
    ("row6", "S1", 101.1e3, 0.01), ("row6", "S2", 176.4e3, 0.01),
    ("row7", "S1", 110.6e3, 0.015), ("row7", "S2", 152.5e3, 0.015),
    ("row8", "S1", 88.6e3, 0.03), ("row8", "S2", 203.3e3, 0.03),
    ("row9", "S1", 96.9e3, 0.015), ("row9", "S2", 183.7e3, 0.015),
    ("force_52_load", "Fh", 165.7e3, 0.03), ("force_76_load", "Fh", 135.7e3, 0.03),
    ("force_19_load", "Fh_9", 65e3, 0.03), ("force_52_load", "Fh_9", 102e3, 0.03), ("force_76_load", "Fh_9", 113e3, 0.03),
    ("force_19_hook", "Fh", 47e3, 0.04), ("force_52_hook", "Fh", 53e3, 0.04), ("force_76_hook", "Fh", 49e3, 0.04),
)


def run(deck):
    done = subprocess.run([PROGRAM, "run", "--json", str(DECKS / f"{deck}.yaml")], capture_output=True, text=True,
                          timeout=200, check=False)
    return done.returncode, json.loads(done.stdout)


def value(result, name):
    return result["values"][name]["value"]


class Boom(unittest.TestCase):
    def test_every_deck_reads(self):
        decks = [d for d in sorted(DECKS.glob("*.yaml")) if not d.name.endswith(".part.yaml")]
        self.assertGreaterEqual(len(decks), 24)
        for deck in decks:
            done = subprocess.run([PROGRAM, "check", str(deck)], capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_rows_and_forces_agree_with_the_reference(self):
        for deck in dict.fromkeys(d for d, *_ in REFERENCE):
            code, result = run(deck)
            self.assertEqual(code, 0, f"{deck}: {result['message']}")
            for _, name, wanted, near in (one for one in REFERENCE if one[0] == deck):
                with self.subTest(deck=deck, value=name):
                    self.assertLess(abs(value(result, name) - wanted), near if near > 1 else near * wanted)

    def test_ropes_as_chains_give_the_same(self):
        _, plain = run("row4")
        code, chain = run("chain_52_load")
        self.assertEqual(code, 0, chain["message"])
        for name in ("S1", "S2"):
            self.assertLess(abs(value(chain, name) / value(plain, name) - 1), 0.005)

    def test_a_broken_rope_tells_its_jerk_or_why_not(self):
        for deck, jerk, near in (("break_extension_21_load", 0.11, 0.2), ("break_retraction_21_load", 0.11, 0.2)):
            code, result = run(deck)
            if code != 0:
                self.assertEqual((code, result["status"]), (3, "not_converged"))
                self.assertIn("t = ", result["message"])
            self.assertLess(abs(value(result, "jerk") / jerk - 1), near)


if __name__ == "__main__":
    unittest.main()
