"""Every file includes what declares the functions and types of taut/base and taut/math that it names.

Dozens of files are compiled as one, in groups that differ from preset to preset: what a neighbour includes hides a
missing line in one build, and another build fails."""
import collections
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(os.environ["TAUT_SOURCE_DIR"])
INCLUDE = re.compile(r'(?m)^#include "([^"]+)"')
FUNCTION = re.compile(r"(?m)^(?:inline |constexpr )*[A-Za-z_][\w:<>,&* ]*[ &*](\w+)\(")
TYPE = re.compile(r"(?m)^(?:struct|class|enum class) (\w+)[^;\n]*\{")


def without_words(text):
    """The text without comments and strings."""
    return re.sub(r'"(?:\\.|[^"\\\n])*"', '""', re.sub(r"//.*", "", text))


def declared(code):
    return {match[1] for form in (FUNCTION, TYPE) for match in form.finditer(code)}


def main():
    texts = {path.relative_to(ROOT).as_posix(): path.read_text("utf-8")
             for room in ("taut", "cli", "web", "test") for path in (ROOT / room).rglob("*")
             if path.suffix in (".hpp", ".cpp")}
    includes = {name: INCLUDE.findall(text) for name, text in texts.items()}
    codes = {name: without_words(text) for name, text in texts.items()}

    def reached(name, seen):
        for other in includes.get(name, ()):
            if other not in seen:
                seen.add(other)
                reached(other, seen)
        return seen

    headers = collections.defaultdict(set)  # of a name: those that declare it
    for name, code in codes.items():
        if name.endswith(".hpp"):
            for word in declared(code):
                headers[word].add(name)
    basic = {word: next(iter(places)) for word, places in headers.items()
             if len(places) == 1 and next(iter(places)).startswith(("taut/base/", "taut/math/"))}
    assert "as_size" in basic, "the test finds no declarations any more"
    wrong = []
    for name, code in codes.items():
        known = reached(name, {name})
        for word in set(re.findall(r"(?<![\w.>])(\w{3,})\s*[({<]", code)) & basic.keys():
            own = re.search(rf"(?!return)\b[\w:>&*]+ {word}(?: =|[({{])", code)  # it declares a local of that name
            if basic[word] not in known and not own:
                wrong.append(f'{name} names {word} and does not include "{basic[word]}"')
    if wrong:
        sys.exit("\n".join(sorted(wrong)))


if __name__ == "__main__":
    main()
