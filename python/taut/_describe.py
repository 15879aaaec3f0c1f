"""The descriptions of decks: fields by key, tables by index, and what is made of them."""

from __future__ import annotations

import keyword
import re
from functools import cache
from typing import Any, NamedTuple

from . import _taut

NUMBERS = ("number", "numbers", "triple")


class Field(NamedTuple):
    """One key of a deck. `unit`: SI symbol; `record`: index of the table of a nested map."""

    key: str
    kind: str
    symbol: str
    unit: str
    shown: str
    needs_text: bool
    quantity: str
    words: str
    full_words: str
    source: str
    range: str
    required: bool
    default: str
    choices: list[str]
    shorthand: str
    one_for_all: bool
    rest: bool
    record: int | None

    @property
    def is_number(self) -> bool:
        """Whether it takes numbers with this unit."""
        return self.kind in NUMBERS

    @property
    def python(self) -> str:
        """The key as a keyword of a function: `from` is `from_`."""
        return self.key + "_" if keyword.iskeyword(self.key) else self.key

    @property
    def line(self) -> str:
        """One line for a docstring: "span: m. Horizontal distance; above 0 m."."""
        unit = f"{self.unit}. " if self.is_number and self.unit != "1" else ""
        default = "" if self.required or self.default in ("-", "required", "") else f" Default: {self.default}."
        words = self.full_words or self.words
        ends = "" if not words or words.endswith(".") else "."
        return f"{self.python}: {unit}{words}{ends}{default}"


class Description:
    """The fields of one map of a deck."""

    def __init__(self, data: dict[str, Any]) -> None:
        self.fields = [Field(**one) for one in data["fields"]]
        self.exactly_one: list[list[str]] = data["exactly_one"]
        self._by_key = {one.key: one for one in self.fields}
        self.rest = next((one for one in self.fields if one.rest), None)

    def find(self, key: str) -> Field | None:
        """The field of a key; of a name that stands beside the keys the field of all such names; else None."""
        found = self._by_key.get(key)
        return found if found is not None and not found.rest else self.rest


@cache
def _data() -> dict[str, Any]:
    return _taut.descriptions()


@cache
def table(index: int) -> Description:
    """A table by its index."""
    return Description(_data()["tables"][index])


def machine_deck() -> Description:
    """Keys of a machine's deck: machine, analyses, checks, design, study, calibrate."""
    return table(_data()["machine"])


def blocks() -> Description:
    """Keys beside the input of a method."""
    return table(_data()["blocks"])


def methods() -> list[dict[str, Any]]:
    """The methods with name, title, source, scope, limits and the indices input, output, exact."""
    found: list[dict[str, Any]] = _data()["methods"]
    return found


def record(d: Description, key: str) -> Description:
    """The table of a nested map. Raises LookupError where there is none."""
    found = d.find(key)
    if found is None or found.record is None:
        raise LookupError(f"'{key}' is no map of its own")
    return table(found.record)


def keys_of(d: Description) -> dict[str, str]:
    """Keywords of functions and the keys that they stand for."""
    return {one.python: one.key for one in d.fields}


STEP = re.compile(r"\[([^\]]*)\]|([^.\[]+)")


def field_at(path: str, method: str | None = None) -> Field | None:
    """The field of a path as `set` has it, "machine.loads[0].mass", "ropes.skyline.mass", "points.head[2]"; None where
    the path leads to no number by itself. `method`: of a deck with a method; its paths begin with "input.".
    """
    steps = [a or b for a, b in STEP.findall(path)]
    if not steps:
        return None
    found = machine_deck() if method is None else blocks()
    if method is not None and (steps[0] == "input" or found.find(steps[0]) is None):
        steps = steps[1:] if steps[0] == "input" else steps
        index = next((one["input"] for one in methods() if one["name"] == method), None)
        if index is None:
            return None
        found = table(index)
    elif method is None and found.find(steps[0]) is None:
        found = record(found, "machine")
    return _walk(found, steps)


def _walk(d: Description, steps: list[str]) -> Field | None:
    found = d.find(steps[0])
    if found is None:
        return None
    rest = steps[1:]
    if found.kind in ("named_records", "records") and not (found.rest and d.find(steps[0]) is found):
        rest = rest[1:]  # the name or the index
    if found.kind == "triple":
        # a place over the ground has keys of its own: points.head.lean
        own = table(found.record).find(rest[0]) if rest and found.record is not None else None
        return own or (_direction(found) if rest[:1] == ["angle"] else found)
    if found.record is None:
        return found
    inner = table(found.record)
    if not found.shorthand and not rest:
        return found
    # what stands for one field alone may leave its key away: points.head[2]
    short = bool(found.shorthand) and (not rest or inner.find(rest[0]) is None)
    return _walk(inner, [found.shorthand, *rest] if short else rest)


def _direction(field: Field) -> Field:
    return field._replace(kind="number", unit="rad", shown="deg", needs_text=True)
