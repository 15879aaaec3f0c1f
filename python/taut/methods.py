"""The published methods as functions: taut.methods.mast_section(skyline_force="100 kN", ...).

Their keywords are the keys of `input:` of the method's deck, and its blocks `checks` and `design`; methods.pyi lists
them. `taut.explain("mast_section")` prints equations, scope and limits.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from . import _describe
from ._keywords import PROGRESS, Extra, Words
from ._run import Result, run

TITLE = Extra("title", "str", "title of the report")
DISPLAY = Extra("display", "Mapping[str, str]", "units of print by kind of quantity: {'force': 'kN'}")
CHECKS = Extra("checks", "Mapping[str, Any]", "the block `checks` of the deck")
DESIGN = Extra("design", "Mapping[str, Any]", "the block `design` of the deck")


def methods() -> dict[str, Words]:
    """Every method with its words."""
    found = {}
    for one in _describe.methods():
        more = f"{one['source']} {one['scope']}"
        found[one["name"]] = Words(one["name"], one["title"], _describe.table(one["input"]), (),
                                   (CHECKS, DESIGN, TITLE, DISPLAY, PROGRESS), method=False, more=more)
    return found


def _run_method(name: str, fields: Mapping[str, Any], extra: dict[str, Any]) -> Result:
    progress = extra.pop("progress", None)
    deck = {"taut": 1, "title": extra.pop("title", None), "method": name, "display": extra.pop("display", None)}
    return run({**deck, "input": dict(fields), **extra}, progress=progress)


def _add(name: str, words: Words) -> None:
    globals()[name] = words.function(lambda fields, extra: _run_method(name, fields, extra))


for _name, _words in methods().items():
    _add(_name, _words)
__all__ = [one["name"] for one in _describe.methods()]
