#!/usr/bin/env python3
"""A few machines of attack.py with a fixed seed, and that it finds what is wrong; `./dev attack N SEED` runs any number.

TAUT_PROGRAM names the program.
"""
import copy
import os
import random
import unittest

import attack
import attack_laws
import attack_machines

MACHINES = 8 if "TAUT_FEWER" in os.environ else 48


class Machines(unittest.TestCase):
    def test_obey_mechanics_and_answer_the_same_however_described(self):
        run = attack.Attack(1, None)
        self.assertTrue(run.run(MACHINES), run.faulty)
        solved = sum(count for name, count in run.counts.items() if name.endswith("solved"))
        self.assertGreaterEqual(solved, 0.9 * MACHINES)
        for change in attack_machines.CHANGES:
            self.assertGreater(run.counts[change.__name__], 0, change.__name__)


class WhatIsWrong(unittest.TestCase):
    def setUp(self):
        self.deck = attack_machines.hung_masses(random.Random("wrong"))
        self.answer = attack_laws.ask(self.deck)
        self.assertTrue(self.answer.solved, self.answer.complaint)
        self.assertEqual(attack_laws.law_faults(self.deck, self.answer), [])

    def test_a_wrong_number_is_found(self):
        for table, column in (("spans", "V_to"), ("spans", "T_from"), ("spans", "unstretched"), ("anchors", "Fz")):
            wrong = copy.deepcopy(self.answer)
            t = wrong.result["tables"][table]
            k = [c["name"] for c in t["columns"]].index(column)
            last = max(range(len(t["rows"])), key=lambda i: t["rows"][i][0].startswith("mass"))
            t["rows"][last][k] *= 1 + 1e-4
            self.assertTrue(attack_laws.law_faults(self.deck, wrong), column)

    def test_another_answer_is_found(self):
        def heavier(deck, _):
            deck["machine"]["bodies"]["mass0"]["mass"].value *= 1.001
            return deck, attack_machines.How()

        self.assertTrue(attack.faults_of_change(self.deck, heavier, "1", self.answer)[0])

    def test_a_faulty_deck_is_made_smaller(self):
        deck = attack_machines.a_line(random.Random("small"))
        whole = len(list(attack.parts_of(deck["machine"])))
        small = attack.smallest(deck, lambda d: d["machine"]["points"]["low"] is not None)
        self.assertEqual(small["machine"], {"points": {"low": deck["machine"]["points"]["low"]}})
        self.assertGreater(whole, 10)


if __name__ == "__main__":
    unittest.main()
