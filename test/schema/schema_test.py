#!/usr/bin/env python3
"""`taut schema` is valid draft 7 and accepts every example and starter deck; it refuses decks that the program refuses.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = os.environ["TAUT_PROGRAM"]
SOURCE = pathlib.Path(os.environ["TAUT_SOURCE_DIR"])

# example, a word of it, the same misspelt
TYPOS = (("mast_section.yaml", "skyline_force:", "skyline_forse:"),
         ("machines/skyline_over_terrain.yaml", "supports:", "suports:"),
         ("machines/skyline_over_terrain.yaml", "friction:", "frictoin:"),
         ("machines/skyline_over_terrain.yaml", "load_path:", "loadpath:"),
         ("machines/skyline_over_terrain.yaml", "hold: clamped", "hold: clampd"),
         ("design/crane_hoist.yaml", "seek:", "seeks:"))


def validate(schema, *decks):
    command = [sys.executable, str(SOURCE / "test/schema/validate.py"), str(schema), *map(str, decks)]
    return subprocess.run(command, check=False).returncode


def main():
    decks = sorted((SOURCE / "examples").rglob("*.yaml"))
    with tempfile.TemporaryDirectory() as folder:
        schema = pathlib.Path(folder) / "schema.json"
        schema.write_bytes(subprocess.run([PROGRAM, "schema"], capture_output=True, check=True).stdout)
        starter = pathlib.Path(folder) / "starter.yaml"
        starter.write_bytes(subprocess.run([PROGRAM, "new", "skyline_over_terrain"], capture_output=True, check=True).stdout)
        results = [validate(schema, *decks, starter) == 0]
        bad = pathlib.Path(folder) / "bad.yaml"
        for deck, word, typo in TYPOS:
            text = (SOURCE / "examples" / deck).read_text()
            assert word in text, (deck, word)
            bad.write_text(text.replace(word, typo))
            results.append(validate(schema, bad) == 3)
            refused = subprocess.run([PROGRAM, "check", str(bad)], capture_output=True, check=False).returncode == 2
            results.append(refused)
    print(f"{sum(results)} passed, {len(results) - sum(results)} failed")
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
