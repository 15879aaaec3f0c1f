"""Words that build a machine. Their keywords are the keys of a deck's `machine:`; _parts.pyi lists them."""

from __future__ import annotations

from typing import Any

from . import _describe
from ._keywords import Words

CALLED = {
    "points": ("point", ("at",)),
    "ropes": ("rope", ("rope",)),
    "bodies": ("body", ("at", "mass", "free")),
    "sheaves": ("sheave", ("at", "diameter", "efficiency", "body")),
    "supports": ("saddle", ("at", "friction", "diameter")),
    "drums": ("drum", ("at", "core_diameter")),
    "carriages": ("carriage", ("mass", "rides", "mainline")),
    "reevings": ("reeve", ("rope", "path")),
    "loads": ("load", ("at", "mass")),
    "guys": ("guy", ("rope", "from", "to")),
    "faces": ("face", ()),
    "terrain": ("ground", ("x", "z")),
}
"""Word and keys that may stand without their keyword, where they are not the singular alone: those of the C++ builder."""


def parts() -> dict[str, Words]:
    """Every list and map of a deck's machine: its key and the words that add to it."""
    found = {}
    for field in _describe.record(_describe.machine_deck(), "machine").fields:
        if field.kind not in ("named_records", "records", "record") or field.record is None:
            continue
        name, first = CALLED.get(field.key, (field.key.removesuffix("s"), ()))
        one_ = "Gives" if field.kind == "record" else "Adds one to"
        found[field.key] = Words(name, f"{one_} `{field.key}`: {field.words}", _describe.table(field.record), first,
                                 named=field.kind == "named_records", returns="Machine")
    return found


class Parts:
    """The words of a machine that is built in Python. Machine is one."""


def _add(key: str, kind: str, words: Words) -> None:
    def call(fields: dict[str, Any], extra: dict[str, Any]) -> Any:
        return extra["self"]._add_part(key, kind, extra.get("name"), fields)

    setattr(Parts, words.name, words.function(call))


_machine = _describe.record(_describe.machine_deck(), "machine")
for _key, _words in parts().items():
    _field = _machine.find(_key)
    if _field is not None:
        _add(_key, _field.kind, _words)
