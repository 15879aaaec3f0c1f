#!/usr/bin/env python3
"""`taut schema` is valid draft 7 and accepts every example; it refuses a deck that the program refuses.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = os.environ["TAUT_PROGRAM"]
SOURCE = pathlib.Path(os.environ["TAUT_SOURCE_DIR"])


def validate(schema, *decks):
    command = [sys.executable, str(SOURCE / "test/schema/validate.py"), str(schema), *map(str, decks)]
    return subprocess.run(command, check=False).returncode


def main():
    decks = sorted((SOURCE / "examples").rglob("*.yaml"))
    with tempfile.TemporaryDirectory() as folder:
        schema = pathlib.Path(folder) / "schema.json"
        schema.write_bytes(subprocess.run([PROGRAM, "schema"], capture_output=True, check=True).stdout)
        good = validate(schema, *decks) == 0
        bad = pathlib.Path(folder) / "bad.yaml"
        bad.write_text((SOURCE / "examples/mast_section.yaml").read_text().replace("skyline_force:", "skyline_forse:"))
        refused = validate(schema, bad) == 1
    print(f"{good + refused} passed, {2 - good - refused} failed")
    return 0 if good and refused else 1


if __name__ == "__main__":
    sys.exit(main())
