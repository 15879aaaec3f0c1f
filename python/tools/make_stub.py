"""Writes the stubs of the package from the descriptions: python3 python/tools/make_stub.py FOLDER.

With --check it writes nothing and ends with 1 where a stub in FOLDER is not what it would write.
"""

import hashlib
import sys
from pathlib import Path

from taut import _analyses, _parts, methods, schema

# By its schema the program's tests see that a description has changed and the stub has not.
HEAD = f'''"""Made from the descriptions by python/tools/make_stub.py; do not edit. `./dev python stub` makes it again.

schema: {hashlib.sha256(schema().strip().encode()).hexdigest()}
"""

'''
TYPES = """from collections.abc import Mapping, Sequence
{path}from typing import Any, Literal

"""
OURS = """from ._result import Result
from ._run import Progress
from ._units import Quantity
"""


def stub(begin, functions, imports):
    lines = [begin] if begin else []
    for one in functions:
        lines += one.stub()
    return HEAD + imports + "\n" + "\n".join(lines) + "\n"


def stubs():
    analyses = [*_analyses.analyses().values(), _analyses.study()]
    parts = "from ._machine import Machine\nfrom ._units import Quantity\n"
    yield "_analyses.pyi", stub("class Analyses:", analyses, TYPES.format(path="from os import PathLike\n") + OURS)
    yield "_parts.pyi", stub("class Parts:", _parts.parts().values(), TYPES.format(path="") + parts)
    yield "methods.pyi", stub("", methods.methods().values(), TYPES.format(path="") + OURS)


def main(folder, check):
    stale = []
    for name, text in stubs():
        path = Path(folder) / name
        if path.exists() and path.read_text(encoding="utf-8") == text:
            continue
        stale.append(name)
        if not check:
            path.write_text(text, encoding="utf-8")
    if stale and check:
        sys.exit(f"stale: {', '.join(stale)}; run ./dev python stub")


if __name__ == "__main__":
    main([one for one in sys.argv[1:] if one != "--check"][0], "--check" in sys.argv)
