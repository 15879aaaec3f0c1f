"""Numbers that a solver chooses are its special cases: they are listed here, and may only become fewer."""
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(os.environ["TAUT_SOURCE_DIR"])
ROOMS = ("solve", "mechanics")
PLAIN = {0, 1, 2, 0.5}  # belong to the formulas
MOST = 225  # as of today; lower it with every one that goes
NUMBER = re.compile(r"(?<![\w.'])(?:\d[\d']*\.\d*(?:e[+-]?\d+)?|\d+e[+-]?\d+)")


def literals(text):
    """Numbers with a point or an exponent in C++, without those of texts and comments."""
    for number, line in enumerate(text.splitlines(), 1):
        code = re.sub(r'"[^"]*"', "", line).split("//")[0]
        for found in NUMBER.findall(code):
            if float(found.replace("'", "")) not in PLAIN:
                yield number, found


def check_itself():
    text = 'double a = 1.0 + 0.5 * 2.0e0 + 1\'000.5;  // 3.5\nf("4.5", 1e-9, x3.y, 7);\n'
    assert list(literals(text)) == [(1, "1'000.5"), (2, "1e-9")], list(literals(text))


def main():
    check_itself()
    found = []
    for room in ROOMS:
        for file in sorted((ROOT / "taut" / room).rglob("*.?pp")):
            if file.name.endswith("_test.cpp"):
                continue
            found += [f"{file.relative_to(ROOT)}:{line}: {text}" for line, text in literals(file.read_text("utf-8"))]
    print("\n".join(found))
    print(f"{len(found)} numbers, at most {MOST}")
    sys.exit(len(found) > MOST)


main()
