"""Analyses of a machine as methods. Their keywords are the keys of a deck's `analyses:`; _analyses.pyi lists them."""

from __future__ import annotations

from typing import Any

from . import _describe
from ._keywords import PROGRESS, SET, Extra, Words

CALLED = {"equilibrium": "solve", "transient": "motion"}
"""Analyses by another word than the deck's."""

FOLDER = Extra("folder", "str | PathLike[str]", "keeps the cases there and goes on where it was ended")
THREADS = Extra("threads", "int", "default: all cores")


def analyses() -> dict[str, Words]:
    """Every analysis of a deck: its kind and its words."""
    found = {}
    for field in _describe.record(_describe.machine_deck(), "analyses").fields:
        if field.record is None:
            continue
        name = CALLED.get(field.key, field.key)
        title = f"Calculates {field.key} of the machine: {field.words}" if field.words else f"Calculates {field.key}"
        more = ("The deck's own analyses are left out; its checks are made. Returns the result, also where there is "
                "no answer.")
        found[field.key] = Words(name, title, _describe.table(field.record), (), (SET, PROGRESS), more=more)
    return found


def study() -> Words:
    """The study of a deck."""
    more = "Without keywords: the `study:` of the deck. All cases are in series[\"cases\"] of the result."
    description = _describe.record(_describe.machine_deck(), "study")
    return Words("study", "Calculates many cases of the machine on all cores", _none_required(description), (),
                 (FOLDER, THREADS, SET, PROGRESS), more=more)


def _none_required(description: _describe.Description) -> _describe.Description:
    """Of a block that may be left away as a whole; taut checks it where it is given."""
    copy = object.__new__(_describe.Description)
    copy.__dict__.update(description.__dict__)
    copy.fields = [one._replace(required=False) for one in description.fields]
    return copy


class Analyses:
    """What a machine is asked. Machine is one."""


def _add(kind: str, words: Words) -> None:
    def call(fields: dict[str, Any], extra: dict[str, Any]) -> Any:
        machine = extra.pop("self")
        if kind == "study":
            return machine._run_study(fields, **extra)
        return machine._run_analysis(kind, fields, **extra)

    setattr(Analyses, words.name, words.function(call))


for _kind, _words in {**analyses(), "study": study()}.items():
    _add(_kind, _words)
