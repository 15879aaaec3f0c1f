"""Exceptions: a mistake of the deck, a question it can't be asked, no answer, an interrupt."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from ._taut import FileError, NativeResult

if TYPE_CHECKING:
    from ._result import Result


class TautError(Exception):
    """What all errors of taut are, but those of files (FileError, an OSError) and Ctrl-C (Interrupted)."""


class Mistake(NamedTuple):
    """One mistake of a deck: file, line and column (from 1; 0: no place), and what to do."""

    file: str
    line: int
    column: int
    message: str
    source_line: str
    width: int
    text: str
    """`deck.yaml:12:15: error: message`, the line, and a caret below the column."""
    unreadable_file: bool


class DeckError(TautError, ValueError):
    """A deck has mistakes. `errors`: all of them; `file`, `line`, `column`: the place of the first."""

    def __init__(self, errors: tuple[Mistake, ...]) -> None:
        super().__init__(errors)
        self.errors = errors

    def __str__(self) -> str:
        text = "".join(one.text for one in self.errors).rstrip("\n")
        return text if len(self.errors) < 2 else f"{text}\n{len(self.errors)} mistakes"

    @property
    def file(self) -> str:
        """The file of the first mistake."""
        return self.errors[0].file

    @property
    def line(self) -> int:
        """Its line, from 1; 0 where there is no place."""
        return self.errors[0].line

    @property
    def column(self) -> int:
        """Its column, from 1; 0 where there is no place."""
        return self.errors[0].column


class QuestionError(TautError, ValueError):
    """A deck can't be asked that: a path or an output that it does not have. `complaints`: (place, message) of each."""

    def __init__(self, complaints: tuple[tuple[str, str], ...]) -> None:
        super().__init__(complaints)
        self.complaints = complaints

    def __str__(self) -> str:
        return "\n".join(f"{place}: {message}" for place, message in self.complaints)


class NoAnswer(TautError):
    """Physics or the solver says no: the deck as it is has no answer, so that there is nothing to vary."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C ended a calculation. `result` has what was done until then; None where nothing was."""

    def __init__(self, message: str, result: Result | None = None) -> None:
        super().__init__(message)
        self.result = result

    def __reduce__(self) -> tuple[Any, ...]:
        return Interrupted, (str(self), self.result)


def raise_mistakes(native: NativeResult) -> None:
    """Raises DeckError where the result has mistakes; FileError where every one is a file that can't be read."""
    errors = tuple(Mistake(*one) for one in native.errors())
    if errors and all(one.unreadable_file for one in errors):
        raise FileError("\n".join(one.text for one in errors).rstrip("\n"))
    if errors:
        raise DeckError(errors)


__all__ = [
    "DeckError",
    "FileError",
    "Interrupted",
    "Mistake",
    "NoAnswer",
    "QuestionError",
    "TautError",
    "raise_mistakes",
]
