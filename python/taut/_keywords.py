"""Functions whose keywords are the keys of a description: signature, docstring, stub."""

from __future__ import annotations

import difflib
import inspect
import textwrap
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from ._describe import Description, Field

WIDTH = 116
TYPES = {
    "number": "Quantity",
    "numbers": "Quantity | Sequence[Quantity]",
    "whole_number": "int",
    "flag": "bool",
    "text": "str | Quantity",
    "triple": "Sequence[Quantity] | Mapping[str, Any]",
    "texts": "str | Sequence[str]",
    "records": "Sequence[Mapping[str, Any] | str]",
    "named_records": "Mapping[str, Any]",
}


class Extra(NamedTuple):
    """A keyword that is no key of the deck."""

    name: str
    type: str
    words: str


PROGRESS = Extra("progress", "Progress", "called with what, part done (0 to 1), words; a returned False ends it")
SET = Extra("set", "Mapping[str, Any]", "values over the deck for this call alone, by path; a bare number is SI")


class Words(NamedTuple):
    """A function as it is described. `first`: keys that may be given without their keyword, in this order."""

    name: str
    title: str
    description: Description
    first: Sequence[str] = ()
    extra: Sequence[Extra] = ()
    named: bool = False
    returns: str = "Result"
    method: bool = True
    more: str = ""

    def fields(self) -> tuple[list[Field], list[Field]]:
        """Those that may stand without keyword, and the others: the required ones first."""
        by_key = {one.key: one for one in self.description.fields if not one.rest}
        first = [by_key[key] for key in self.first]
        rest = [one for key, one in by_key.items() if key not in self.first]
        return first, sorted(rest, key=lambda one: not one.required)

    def signature(self) -> inspect.Signature:
        """Its parameters; None stands for "not given"."""
        kinds = inspect.Parameter
        first, rest = self.fields()
        all_ = [inspect.Parameter("self", kinds.POSITIONAL_OR_KEYWORD)] if self.method else []
        if self.named:
            all_.append(inspect.Parameter("name", kinds.POSITIONAL_OR_KEYWORD))
        need = True
        for one in first:
            need = need and one.required
            default = kinds.empty if need else None
            all_.append(inspect.Parameter(one.python, kinds.POSITIONAL_OR_KEYWORD, default=default))
        for one in rest:
            all_.append(inspect.Parameter(one.python, kinds.KEYWORD_ONLY, default=kinds.empty if one.required else None))
        for extra in self.extra:
            all_.append(inspect.Parameter(extra.name, kinds.KEYWORD_ONLY, default=None))
        return inspect.Signature(all_)

    def docstring(self) -> str:
        """Title, keywords with unit, meaning, range and default, and what it raises."""
        first, rest = self.fields()
        lines = [self.title if self.title.endswith(".") else self.title + ".", ""]
        if self.more:
            lines += [*textwrap.wrap(self.more, WIDTH), ""]
        for one in [*first, *rest]:
            lines += textwrap.wrap(one.line, WIDTH, subsequent_indent="    ")
        for group in self.description.exactly_one:
            lines.append(f"Give exactly one of {', '.join(group)}.")
        for extra in self.extra:
            lines += textwrap.wrap(f"{extra.name}: {extra.words}.", WIDTH, subsequent_indent="    ")
        lines += ["", "A number is SI, a text has its unit. " + (
            "Returns the machine; its mistakes are told when it is calculated." if self.returns == "Machine" else
            "Raises DeckError for mistakes; Interrupted after Ctrl-C, with what was done.")]
        return "\n".join(lines)

    def stub(self) -> list[str]:
        """Its lines in a stub."""
        need = {one.name for one in self.signature().parameters.values() if one.default is inspect.Parameter.empty}
        first, rest = self.fields()
        begin = (["self"] if self.method else []) + (["name: str"] if self.named else [])
        args = begin + [_stub_argument(one, one.python in need) for one in first]
        keywords = [_stub_argument(one, one.python in need) for one in rest]
        keywords += [f"{one.name}: {one.type} | None = None" for one in self.extra]
        indent = "    " if self.method else ""
        lines = [f"{indent}def {self.name}("]
        lines += [f"{indent}    {one}," for one in [*args, *(["*"] if keywords else []), *keywords]]
        lines.append(f"{indent}) -> {self.returns}:")
        doc = self.docstring().replace("\\", "\\\\").split("\n")
        lines.append(f'{indent}    """{doc[0]}')
        lines += [f"{indent}    {one}".rstrip() for one in doc[1:]]
        lines.append(f'{indent}    """')
        return lines

    def function(self, call: Callable[..., Any]) -> Callable[..., Any]:
        """A function of this signature, which calls `call(arguments)` with those that were given, by key."""
        signature = self.signature()
        keys = {one.python: one.key for one in self.description.fields}
        extra = {one.name for one in self.extra} | {"self", "name"}

        def described(*args: Any, **keywords: Any) -> Any:
            self._refuse_unknown(signature, keywords)
            try:
                bound = signature.bind(*args, **keywords)
            except TypeError as error:
                raise TypeError(f"{self.name}(): {error}") from None
            given = {key: value for key, value in bound.arguments.items() if value is not None}
            fields = {keys[key]: value for key, value in given.items() if key not in extra or key in self._own(keys)}
            return call(fields, {key: value for key, value in given.items() if key in extra and key not in fields})

        described.__name__ = self.name
        described.__qualname__ = self.name
        described.__doc__ = self.docstring()
        described.__signature__ = signature  # type: ignore[attr-defined]
        return described

    def _own(self, keys: dict[str, str]) -> set[str]:
        """Keys of the deck that are called like one of ours: the name of an analysis."""
        return {key for key in keys if key == "name" and not self.named}

    def _refuse_unknown(self, signature: inspect.Signature, keywords: dict[str, Any]) -> None:
        known = [one for one in signature.parameters if one != "self"]
        for key in keywords:
            if key not in known:
                near = difflib.get_close_matches(key, known, 1)
                hint = f"did you mean '{near[0]}'?" if near else f"there are {', '.join(known)}"
                raise TypeError(f"{self.name}() has no keyword '{key}'; {hint}")


def _stub_argument(field: Field, needed: bool) -> str:
    if field.kind == "choice":
        kind = "Literal[" + ", ".join(f'"{one}"' for one in field.choices) + "]"
    elif field.kind == "texts" and field.choices:
        of = "Literal[" + ", ".join(f'"{one}"' for one in field.choices) + "]"
        kind = f"Sequence[{of}]"
    elif field.kind == "record":
        kind = "Mapping[str, Any]" + (" | Quantity | Sequence[Any]" if field.shorthand else "")
    elif field.kind == "records" and field.shorthand:
        kind = "Sequence[Any]"
    else:
        kind = TYPES[field.kind]
    return f"{field.python}: {kind}" if needed else f"{field.python}: {kind} | None = None"
