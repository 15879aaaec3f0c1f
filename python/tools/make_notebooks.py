"""Makes a notebook of each program in a folder: python3 python/tools/make_notebooks.py [--check] FOLDER

A line `# %%` begins a cell of code, `# %% [markdown]` one of text, whose lines begin with `# `. With --check nothing is
written, and it ends with 1 where a notebook is not what it would write.
"""

import json
import sys
from pathlib import Path

KERNEL = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}


def cells(text):
    for block in text.split("\n# %%")[1:]:
        head, _, body = block.partition("\n")
        body = body.strip("\n")
        if head.strip() == "[markdown]":
            lines = [line.removeprefix("#").removeprefix(" ") for line in body.split("\n")]
            yield {"cell_type": "markdown", "metadata": {}, "source": "\n".join(lines)}
        elif body:
            yield {"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": [], "source": body}


def notebook(text):
    all_ = [{**one, "id": f"cell-{i}"} for i, one in enumerate(cells("\n" + text))]
    data = {"cells": all_, "metadata": KERNEL, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(data, indent=1, ensure_ascii=False) + "\n"


def main(folder, check):
    stale = []
    for source in sorted(Path(folder).glob("*.py")):
        place = source.with_suffix(".ipynb")
        text = notebook(source.read_text(encoding="utf-8"))
        if place.exists() and place.read_text(encoding="utf-8") == text:
            continue
        stale.append(place.name)
        if not check:
            place.write_text(text, encoding="utf-8")
    if stale and check:
        sys.exit(f"stale: {', '.join(stale)}; run ./dev python stub")


if __name__ == "__main__":
    main([one for one in sys.argv[1:] if one != "--check"][0], "--check" in sys.argv)
