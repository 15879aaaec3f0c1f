#!/usr/bin/env python3
"""Runs the built program on more than 200 bad decks: exit code 2, a message with file:line:column, no crash, no long wait.

TAUT_PROGRAM names the program.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import cpu_time

MOST_SECONDS = 20.0  # of processor time; the slowest takes a tenth of it, under the sanitizers too
PLACE = re.compile(rb"^[^\n:]+:\d+:\d+: error: \S", re.MULTILINE)

HEAD = "taut: 1\ntitle: bad\n"
MAST = HEAD + """method: mast_section
input:
  skyline_force: 100 kN
  mainline_force: 40 kN
  skyline_block_height: 8 m
  branch_angle: 12 deg
  allowable_stress: 160 MPa
"""
DRIVE = HEAD + """method: friction_drive
input:
  cutting_force: 4000 N
  friction: 0.8
  wrap: 200 deg
  rope_mass: 0.35 kg/m
  speed: 15 m/s
  grip_reserve: 1.3
"""
LOOP = HEAD + """method: closed_loop
input:
  span: 200 m
  sag: 10 m
  gathering_force: 3000 kgf
  gathering_angle: 30 deg
  return_weight: 1 kgf/m
  traction_weight: 1.5 kgf/m
  tail_efficiency: 0.9
"""
BOOM = HEAD + """method: boom_ropes
input:
  section_weight: 8.44 kN
  pad_friction: 0.15
  tackle_efficiency: 0.95
  extension_stiffness: 2.72 MN/m
  retraction_stiffness: 1.61 MN/m
  tensioned_last: extension
  tensioning_steps: 4
  cases:
    - {name: lift, operation: lift, luffing_angle: 77 deg, suspended_weight: 248.2 kN, falls: 8}
"""
GOOD = {"mast": MAST, "drive": DRIVE, "loop": LOOP, "boom": BOOM}

BAD_VALUES = ["100", "12 mm/s/s", "1e999 N", ".nan", "nan kN", "[]", "{}", "", "yes please", "100 ton", "5 kn", "5 lbs", "1,5 kN",
              "--5 kN", "0x10", "'", "!!binary abc", "*alias", "1 2 3", "1e999", "-.inf", "\u221212 kN", "12 kN kN kN", "[1, [2]]"]


def lines_of_input(deck):
    """Numbers of the lines `  key: value` below input:."""
    rows = deck.split("\n")
    return [i for i, row in enumerate(rows) if re.match(r"^  [a-zA-Z_]+: \S", row)]


def with_line(deck, index, text):
    rows = deck.split("\n")
    rows[index] = text
    return "\n".join(rows)


def mutated():
    """Every input line of every method with bad values, typos, duplicates, and left out."""
    for name, deck in GOOD.items():
        rows = deck.split("\n")
        for i in lines_of_input(deck):
            key, value = rows[i].strip().split(": ", 1)
            plain_number = re.fullmatch(r"[0-9.]+", value) is not None
            is_text = re.match(r"[a-z]", value) is not None
            for bad in ("1e999", "[]", ".nan", "{a: 1}", "5 parsecs", "-5 kN mm", "!!float x"):
                yield f"{name}-{key}-{bad}", with_line(deck, i, f"  {key}: {bad}")
            if not plain_number and not is_text:
                yield f"{name}-{key}-bare", with_line(deck, i, f"  {key}: 100")
            yield f"{name}-{key}-typo", with_line(deck, i, f"  {key}x: {value}")
            yield f"{name}-{key}-twice", with_line(deck, i, f"  {key}: {value}\n  {key}: {value}")
            yield f"{name}-{key}-map", with_line(deck, i, f"  {key}: {{value: {value}}}")
        for key, low in (("skyline_force", "-1 kN"), ("span", "-200 m"), ("friction", "-0.1"), ("section_weight", "-1 kN"),
                         ("tail_efficiency", "1.5"), ("gathering_angle", "95 deg"), ("wrap", "-3 deg")):
            found = [i for i in lines_of_input(deck) if rows[i].startswith(f"  {key}: ")]
            for i in found:
                yield f"{name}-{key}-range", with_line(deck, i, f"  {key}: {low}")


def handmade():
    first = lines_of_input(MAST)[0]
    for i, bad in enumerate(BAD_VALUES):
        yield f"value-{i}", with_line(MAST, first, f"  skyline_force: {bad}")
    yield "empty", ""
    yield "blank", "\n\n  \n"
    yield "only-comment", "# nothing\n"
    yield "scalar", "hello"
    yield "list", "- 1\n- 2\n"
    yield "no-method", HEAD + "input: {}\n"
    yield "no-input", HEAD + "method: mast_section\n"
    yield "input-list", HEAD + "method: mast_section\ninput: [1]\n"
    yield "unknown-method", MAST.replace("mast_section", "mast_sektion")
    yield "version-2", MAST.replace("taut: 1", "taut: 2")
    yield "version-text", MAST.replace("taut: 1", "taut: one")
    yield "no-version", MAST.replace("taut: 1\n", "")
    yield "unknown-top", MAST + "colour: red\n"
    yield "display-kind", MAST + "display: {colour: kN}\n"
    yield "display-unit", MAST + "display: {force: mm}\n"
    yield "title-map", MAST.replace("title: bad", "title: {a: b}")
    yield "tab", MAST.replace("  skyline_force", "\tskyline_force")
    yield "indent", MAST.replace("  mainline_force", "   mainline_force")
    yield "unclosed-quote", MAST.replace("bad", '"bad')
    yield "unclosed-brace", MAST + "display: {force: kN\n"
    yield "unclosed-bracket", MAST + "display: [force\n"
    yield "two-documents", MAST + "---\n" + MAST
    yield "anchor", MAST.replace("100 kN", "&a 100 kN").replace("40 kN", "*a")
    yield "merge", MAST.replace("input:", "input:\n  <<: *b")
    yield "custom-tag", MAST.replace("100 kN", "!force 100 kN")
    yield "complex-key", MAST + "? [a, b]\n: 1\n"
    yield "nul", MAST.replace("100 kN", "100\0 kN")
    yield "bell", MAST.replace("100 kN", "100\a kN")
    yield "latin-1", MAST.encode().replace(b"bad", b"b\xe4d")
    yield "utf-16", MAST.encode("utf-16")
    yield "binary", bytes(range(256)) * 10
    yield "png", b"\x89PNG\r\n\x1a\n" + bytes(100)
    yield "deep-flow", HEAD + "input: " + "[" * 200
    yield "deep-closed", HEAD + "input: " + "[" * 200 + "]" * 200
    yield "deep-map", HEAD + "input: " + "{a: " * 100 + "1" + "}" * 100
    yield "deep-block", "".join("  " * i + "a:\n" for i in range(300))
    yield "many-brackets", "[" * 1_000_000
    yield "many-braces", "{" * 1_000_000
    yield "many-dashes", "- " * 1_000_000
    yield "many-colons", "a: " * 300_000
    yield "many-keys", HEAD + "".join(f"k{i}: 1\n" for i in range(100_000))
    yield "long-line", HEAD + "method: " + "x" * 10_000_000
    yield "long-key", "x" * 5_000_000 + ": 1"
    yield "many-newlines", "\n" * 5_000_000 + "x"
    yield "open-quote-long", '"' + "a" * 10_000_000
    yield "alias-bomb", "a: &a [1,1]\nb: &b [*a,*a]\nc: &c [*b,*b]\n" + MAST
    yield "17-mb", MAST + "# " + "x" * 17_000_000
    yield "100-mb", b"x" * 100_000_000
    yield "angle-and-span", MAST + "  span: {length: 200 m, chord_slope: 0 deg, carriage_position: 50 m, rope_weight: 20 N/m, " \
                                   "load: 10 kN, horizontal_tension: 60 kN}\n"
    yield "neither-angle-nor-span", MAST.replace("  branch_angle: 12 deg\n", "")
    yield "no-stress", MAST.replace("  allowable_stress: 160 MPa\n", "")
    yield "unknown-rope", LOOP.replace("  return_weight: 1 kgf/m", "  return_rope: 'EN 12385-4|6x36-IWRC|16.5|1960'")
    yield "position-outside", LOOP + "  position: 300 m\n"
    yield "position-list-outside", LOOP + "  position: [50 m, 300 m]\n"
    yield "section-distance", LOOP + "  carriage: two_section\n"
    yield "mode", LOOP + "  mode: loop_lenght\n"
    yield "operation", BOOM.replace("operation: lift", "operation: lower")
    yield "no-cases", BOOM[:BOOM.index("  cases:")] + "  cases: []\n"
    yield "falls-half", BOOM.replace("falls: 8", "falls: 7.5")
    yield "falls-zero", BOOM.replace("falls: 8", "falls: 0")
    yield "include-missing", "include: nowhere.part.yaml\n" + MAST
    yield "include-number", "include: 5\n" + MAST


def run(program, path):
    before = cpu_time.of_ended()
    done = subprocess.run([program, "run", str(path)], capture_output=True, check=False)
    return done, cpu_time.of_ended() - before


def faults_of(program, path):
    done, seconds = run(program, path)
    faults = []
    if done.returncode != 2:
        faults.append(f"exit code {done.returncode}")
    if not PLACE.search(done.stderr):
        faults.append(f"no place in {done.stderr[:200]!r}")
    if seconds > MOST_SECONDS:
        faults.append(f"{seconds:.1f} s of processor time")
    return faults


def main():
    program = os.environ["TAUT_PROGRAM"]
    decks = list(mutated()) + list(handmade())
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for i, (name, deck) in enumerate(decks):
            path = pathlib.Path(folder) / f"{i}.yaml"
            path.write_bytes(deck if isinstance(deck, bytes) else deck.encode())
            faults = faults_of(program, path)
            if faults:
                failed += 1
                print(f"{name}: {', '.join(faults)}")
            path.unlink()
        for name, deck in GOOD.items():  # the test itself must be able to tell good from bad
            path = pathlib.Path(folder) / f"{name}.yaml"
            path.write_text(deck)
            done, _ = run(program, path)
            if done.returncode not in (0, 4):
                failed += 1
                print(f"good deck {name}: exit code {done.returncode}: {done.stderr[:300]!r}")
    print(f"{len(decks) - failed} passed, {failed} failed")
    return 1 if failed or len(decks) < 200 else 0


if __name__ == "__main__":
    sys.exit(main())
