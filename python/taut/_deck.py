"""Decks: the text, a file, a dict. A dict becomes the text that a person could have written."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple, Protocol, Union

from . import _describe, _taut
from ._describe import Description, Field
from ._errors import DeckError, Mistake
from ._units import is_pint, quantity_text


class Job(NamedTuple):
    """A deck's text, its name in messages, and values set over it."""

    text: str
    name: str
    set: tuple[str, ...] = ()
    made: bool = False
    """Whether the text was made of a dict, in which a bare number is SI."""


class HasJob(Protocol):
    """What knows its own deck, as a Machine does."""

    def job(self) -> Job: ...


Deck = Union[str, "os.PathLike[str]", Mapping[str, Any], HasJob]
"""A deck: its text (with a line end in it), the path of its file, a dict with its keys, or a Machine."""

MADE = "deck.yaml made of a dict"
SET = "--set"
WITHOUT_UNIT = re.compile(r"needs its unit, such as '\S+ ([^']+)'$")
BARE = re.compile(rb"[-+]?[0-9.]+(e[-+]?[0-9]+)?")
SURROGATE = re.compile("[\ud800-\udfff]")
PLAIN = re.compile(r"^(?!- |---|[-+]?[0-9.]+(e[-+]?[0-9]+)?$)[A-Za-z0-9=.+-][A-Za-z0-9 _./|%²³°+*()=-]*(?<! )$")
NULLS = {"null", "Null", "NULL", "~", "", "true", "false"}
WIDTH = 110


def job_of(deck: Deck, set: Mapping[str, Any] | None = None) -> Job:
    """The job of a deck, with more values set over it. Raises FileError where a file can't be read."""
    if isinstance(deck, Mapping):
        job = Job(text_of(deck), MADE, made=True)
    elif isinstance(deck, str) and "\n" in deck:
        job = Job(deck, "deck")
    elif isinstance(deck, (str, os.PathLike)):
        job = Job(*_taut.read_file(os.fspath(deck)))
    elif hasattr(deck, "job"):
        job = deck.job()
    else:
        raise TypeError(f"a deck is a text, the path of a file, a dict or a Machine, not {type(deck).__name__}")
    if not set:
        return job
    method = method_of(job.text)
    return job._replace(set=job.set + tuple(assignment(path, value, method) for path, value in set.items()))


def readable(job: Job) -> Job:
    """The same job. Raises DeckError where its text holds half of a character, which no file could."""
    for name, text in ((job.name, job.text), *((SET, one) for one in job.set)):
        found = SURROGATE.search(text)
        if found is None:
            continue
        begin = text.rfind("\n", 0, found.start()) + 1
        line, column = text.count("\n", 0, begin) + 1, found.start() - begin + 1
        message = f"this is half of a character (U+{ord(found[0]):04X}), as a text of UTF-16 has that was cut: write it whole"
        source = SURROGATE.sub("?", text[begin:].split("\n", 1)[0])
        shown = f"{name}:{line}:{column}: error: {message}\n  {source}\n  {' ' * (column - 1)}^\n"
        raise DeckError((Mistake(name, line, column, message, source, 1, shown, False),))
    return job


def with_units(job: Job, mistakes: Iterable[Mistake]) -> Job:
    """The job with the SI unit behind the bare numbers that the reader wants one of: their keys do not tell it by
    themselves, as the ends of a sweep have the unit of its parameter. The same job where there are none.
    """
    lines, values = job.text.split("\n"), list(job.set)
    # from the last one on, so that the columns of the others stay
    for one in sorted(mistakes, key=lambda one: one.column, reverse=True):
        wanted = WITHOUT_UNIT.search(one.message)
        if wanted is None:
            continue
        if one.file == SET and one.source_line in job.set:
            at = job.set.index(one.source_line)
            values[at] = _with_unit(values[at], one, wanted[1])
        elif job.made and one.file == job.name:
            lines[one.line - 1] = _with_unit(lines[one.line - 1], one, wanted[1])
    return job._replace(text="\n".join(lines), set=tuple(values))


def _with_unit(line: str, mistake: Mistake, unit: str) -> str:
    """The line with an SI unit behind the bare number of that mistake. `unit`: one of the same kind, "kN". The same
    line where the number is a text, which stands in quotes: a text carries its unit.
    """
    data = line.encode()
    begin = mistake.column - 1
    end = begin + mistake.width
    if not BARE.fullmatch(data[begin:end]) or data[:begin].endswith(b'"'):
        return line
    return (data[:end] + f" {_taut.quantity(f'1 {unit}')[1]}".encode() + data[end:]).decode()


def method_of(text: str) -> str | None:
    """The method that a deck's text names, None of a machine. Only asked for the units of bare numbers."""
    found = re.search(r"^method:\s*['\"]?([A-Za-z0-9_]+)", text, re.MULTILINE)
    return found.group(1) if found else None


def assignment(path: str, value: Any, method: str | None = None) -> str:
    """ "path=value" as `--set` has it. A bare number gets the SI unit of its field; None takes the key out."""
    if value is None:
        return f"{path}=null"
    field = _describe.field_at(path, method)
    if field is None and method is None and path.startswith("input."):
        field = _field_of_any(path)
    return f"{path}={_flow(value, field)}"


def _field_of_any(path: str) -> Field | None:
    """Of a deck whose method stands in what it includes: the field, where all methods that have it agree on its unit."""
    found = [_describe.field_at(path, one["name"]) for one in _describe.methods()]
    known = {one.unit: one for one in found if one is not None and one.is_number}
    return next(iter(known.values())) if len(known) == 1 else None


def text_of(deck: Mapping[str, Any]) -> str:
    """The text of a deck given as a dict. Numbers get the SI units of their fields; None is left out."""
    method = deck.get("method")
    lines: list[str] = []
    for key, value in deck.items():
        if value is None:
            continue
        _block(lines, 0, key, value, _top_field(key, str(method) if method is not None else None))
    return "\n".join(lines) + "\n"


def _top_field(key: str, method: str | None) -> Field | None:
    if method is None:
        return _describe.machine_deck().find(key)
    if key != "input":
        return _describe.blocks().find(key)
    index = next((one["input"] for one in _describe.methods() if one["name"] == method), None)
    return None if index is None else _map_field(index)


def _map_field(index: int) -> Field:
    return Field("", "record", "", "1", "1", False, "", "", "", "", "", False, "", [], "", False, False, index)


def _inner(field: Field | None) -> Description | None:
    return None if field is None or field.record is None else _describe.table(field.record)


def _entry_field(field: Field | None) -> Field | None:
    """The field of one of several named or listed maps."""
    return None if field is None else field._replace(kind="record")


def _child(field: Field | None, key: str) -> Field | None:
    if field is not None and field.kind == "named_records":
        return _entry_field(field)
    inner = _inner(field)
    if inner is None:
        return None
    found = inner.find(key)
    return _entry_field(found) if found is not None and found.rest else found


def _is_list(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, (str, bytes))


def _plain_data(value: Any) -> Any:
    """Arrays and scalars of NumPy as Python's own."""
    return value.tolist() if hasattr(value, "tolist") and not is_pint(value) else value


def _scalar(value: Any, field: Field | None) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)) or is_pint(value):
        return quantity_text(value, _shortened(field))
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if not isinstance(value, str):
        raise TypeError(f"{value!r}: a deck takes numbers, texts, true and false, lists and maps, not {type(value).__name__}")
    return value if PLAIN.match(value) and value not in NULLS else json.dumps(value, ensure_ascii=False)


def _shortened(field: Field | None) -> Field | None:
    """Of a map in whose place a single value stands: the field that it is."""
    while field is not None and not field.is_number and field.shorthand and field.record is not None:
        field = _describe.table(field.record).find(field.shorthand)
    return field


def _flow(value: Any, field: Field | None) -> str:
    value = _plain_data(value)
    if isinstance(value, Mapping):
        pairs = (f"{_key(k)}: {_flow(v, _child(field, str(k)))}" for k, v in value.items() if v is not None)
        return "{" + ", ".join(pairs) + "}"
    if _is_list(value):
        of = _entry_field(field) if field is not None and field.kind == "records" else _shortened(field)
        return "[" + ", ".join(_flow(one, of) for one in value) + "]"
    return _scalar(value, field)


def _key(key: Any) -> str:
    return _scalar(str(key), None)


def _block(lines: list[str], depth: int, key: Any, value: Any, field: Field | None) -> None:
    value = _plain_data(value)
    begin = "  " * depth + _key(key) + ":"
    nested = isinstance(value, Mapping) or (_is_list(value) and any(isinstance(one, Mapping) for one in value))
    flow = f"{begin} {_flow(value, field)}"
    simple = not isinstance(value, Mapping) or not any(isinstance(one, Mapping) for one in value.values())
    if not nested or not value or (depth > 0 and simple and isinstance(value, Mapping) and len(flow) <= WIDTH):
        lines.append(flow)
    elif isinstance(value, Mapping):
        lines.append(begin)
        for inner_key, inner in value.items():
            if inner is not None:
                _block(lines, depth + 1, inner_key, inner, _child(field, str(inner_key)))
    else:
        lines.append(begin)
        for one in value:
            lines.append("  " * (depth + 1) + "- " + _flow(one, _entry_field(field)))
