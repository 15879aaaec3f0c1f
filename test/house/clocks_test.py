#!/usr/bin/env python3
"""No test looks at the clock on the wall: it would fail when the machine has other things to do. Processor time
(std::clock, test/program/cpu_time.py) and numbers of steps say how long a thing takes; ctest ends what hangs.

TAUT_SOURCE_DIR names the source tree.
"""
import os
import pathlib
import re
import sys

WALL = re.compile(r"steady_clock|system_clock|high_resolution_clock|time\.time\(|monotonic\(|perf_counter|\btimeout=|gettimeofday")
ROOT = pathlib.Path(os.environ["TAUT_SOURCE_DIR"])


def places(text):
    return [number for number, line in enumerate(text.splitlines(), 1) if WALL.search(line)]


def main():
    me = pathlib.Path(__file__).resolve()
    files = [f for folder in ("test", "taut", "cli", "web") for f in (ROOT / folder).rglob("*") if f.suffix in (".py", ".cpp", ".hpp", ".sh")]
    tests = [f for f in files if f != me and ("_test." in f.name or ROOT / "test" in f.parents)]
    found = [f"{f.relative_to(ROOT)}:{line}" for f in tests for line in places(f.read_text(encoding="utf-8"))]
    print("\n".join(found) or f"{len(tests)} files, none looks at the clock on the wall")
    can_tell = places("a = 1\nstart = time.monotonic()\n") == [2] and not places("std::clock() and cpu_time.wait(p, 2)")
    return 0 if can_tell and not found and len(tests) > 100 else 1


if __name__ == "__main__":
    sys.exit(main())
