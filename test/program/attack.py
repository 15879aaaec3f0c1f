#!/usr/bin/env python3
"""usage: TAUT_PROGRAM=build/bin/taut attack.py N SEED [FOLDER]

Runs N machines by chance, looks whether their answers obey mechanics, and whether the same machine described in another way
(mirrored, turned, in other units, in another order, from its other end, from another first guess, with a rope cut and
knotted) has the same answer. Exit code 1 when not; the smallest deck that still shows it goes into FOLDER.
"""
import collections
import copy
import pathlib
import random
import sys

from attack_laws import ask, difference_faults, law_faults
from attack_machines import CHANGES, EXACT, MACHINES, deck_text

MOST_CUTS = 200  # tries to make a faulty deck smaller


def faults_of_change(deck, change, chance, first=None):
    """Faults of the changed deck's answer, and that deck; None: nothing to compare."""
    changed = change(copy.deepcopy(deck), random.Random(chance))
    if changed is None:
        return None
    other, how = changed
    first = first or ask(deck)
    answer = ask(other, how.system)
    text = deck_text(other, how.system)
    if answer.code not in (0, 3, 4):
        return [f"exit code {answer.code}: {answer.complaint}"], text
    if first.solved and answer.solved:
        return difference_faults(deck, first, answer, how), text
    if change in EXACT and first.code in (0, 3, 4) and first.solved != answer.solved:
        return [f"solved: {first.solved}, described in another way: {answer.solved}; {first.complaint or answer.complaint}"], text
    return None


def faults_of_machine(deck, answer):
    if answer.code not in (0, 3, 4):
        return [f"exit code {answer.code}: {answer.complaint}"]
    return law_faults(deck, answer) if answer.solved else []


def is_faulty_machine(deck):
    """What is left of a machine is refused as a deck: that is no fault."""
    answer = ask(deck)
    return answer.code != 2 and bool(faults_of_machine(deck, answer))


def parts_of(thing, path=()):
    """Paths of all that could be left out of a machine."""
    inner = thing.items() if isinstance(thing, dict) else enumerate(thing) if isinstance(thing, list) else ()
    for key, value in inner:
        yield (*path, key)
        yield from parts_of(value, (*path, key))


def without(deck, path):
    deck = copy.deepcopy(deck)
    inner = deck["machine"]
    for key in path[:-1]:
        inner = inner[key]
    del inner[path[-1]]
    return deck


def smallest(deck, is_faulty):
    """Leaves out of the deck what it can while it stays faulty."""
    tries, smaller = 0, True
    while smaller:
        smaller = False
        for path in sorted(parts_of(deck["machine"]), key=len):
            try:
                less = without(deck, path)
                faulty = is_faulty(less)
            except (KeyError, IndexError, TypeError, ValueError, ZeroDivisionError):
                continue  # no machine any more
            tries += 1
            if faulty:
                deck, smaller = less, True
                break
            if tries >= MOST_CUTS:
                return deck
    return deck


def keep(folder, name, deck, is_faulty):
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{name}.yaml"
    path.write_text(deck_text(smallest(deck, is_faulty)), encoding="utf-8")
    return path


class Attack:
    def __init__(self, seed, folder):
        self.seed, self.folder = seed, folder
        self.counts, self.faulty = collections.Counter(), []

    def report(self, name, deck, faults, is_faulty):
        self.faulty.append(name)
        where = f", see {keep(self.folder, name, deck, is_faulty)}" if self.folder else ""
        print(f"{name}: {faults[0]}{where}", flush=True)

    def machine(self, i):
        make = MACHINES[i % len(MACHINES)]
        deck = make(random.Random(f"{self.seed}/{i}"))
        answer = ask(deck)
        self.counts[f"{make.__name__}: {'solved' if answer.solved else 'refused'}"] += 1
        faults = faults_of_machine(deck, answer)
        if faults:
            self.report(f"{make.__name__}_{self.seed}_{i}", deck, faults, is_faulty_machine)
        for change in CHANGES:
            chance = f"{self.seed}/{i}/{change.__name__}"
            compared = faults_of_change(deck, change, chance, answer)
            if compared is None:
                continue
            self.counts[change.__name__] += 1
            if compared[0]:
                self.report(f"{make.__name__}_{self.seed}_{i}_{change.__name__}", deck, compared[0],
                          lambda d, c=change, s=chance: bool((faults_of_change(d, c, s) or [[]])[0]))

    def run(self, number):
        for i in range(number):
            self.machine(i)
        print("; ".join(f"{name} {count}" for name, count in sorted(self.counts.items())))
        print(f"{number} machines with seed {self.seed}: {len(self.faulty)} violations")
        return not self.faulty


def main():
    if len(sys.argv) not in (3, 4) or not all(a.isdigit() for a in sys.argv[1:3]):
        print(__doc__, file=sys.stderr)
        return 2
    folder = pathlib.Path(sys.argv[3]) if len(sys.argv) == 4 else None
    return 0 if Attack(int(sys.argv[2]), folder).run(int(sys.argv[1])) else 1


if __name__ == "__main__":
    sys.exit(main())
