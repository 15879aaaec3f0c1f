"""A deck as a function of numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _taut
from ._deck import Deck, Job, job_of
from ._errors import Interrupted, NoAnswer, QuestionError, raise_mistakes
from ._result import Floats
from ._run import Progress, asked, number_of_threads
from ._units import is_pint, pint_text


class Cases:
    """A deck as a pure function of some of its numbers, read and compiled once.

    paths: numbers that change, by their whole path ("machine.loads[0].mass", "input.span", "parameters.travel").
    of: values that are wanted, by analysis and name ("equilibrium.skyline.safety_factor", "checks.skyline.T_max"); of
    a method by name. Without it those of the deck's `study:`.
    What the wanted values do not need is not calculated. The same numbers give the same bits, on any number of threads
    and in any order; they are those of `taut study`. Any thread may call it; it can be pickled, and is then compiled
    again.
    Raises DeckError, FileError; QuestionError for paths and names that the deck does not have; NoAnswer where the deck
    as it is has no answer.
    """

    def __init__(
        self,
        deck: Deck,
        paths: Sequence[str],
        of: Sequence[str] = (),
        set: Mapping[str, Any] | None = None,
    ) -> None:
        if isinstance(paths, str) or isinstance(of, str):
            raise TypeError("paths and of are lists of texts")
        self._question = (job_of(deck, set), list(paths), list(of))
        self._make()

    def _make(self) -> None:
        job, paths, of = self._question
        native, result, complaints, message = asked(
            job, lambda one: _taut.make_cases(one.text, one.name, one.set, paths, of), lambda found: found[1]
        )
        if result is not None:
            raise_mistakes(result)
        if complaints:
            raise QuestionError(tuple(complaints))
        if native is None:
            raise NoAnswer(message)
        self._native = native
        inputs, outputs = native.inputs(), native.outputs()
        self.paths: tuple[str, ...] = tuple(one[0] for one in inputs)
        """Numbers that change."""
        self.units: tuple[str, ...] = tuple(one[1] for one in inputs)
        """Their SI units."""
        self.base: Floats = np.array([one[3] for one in inputs])
        """Their values in the deck, SI, shape (paths,)."""
        self.of: tuple[str, ...] = tuple(one[0] for one in outputs)
        """Values that are wanted."""
        self.of_units: tuple[str, ...] = tuple(one[1] for one in outputs)
        """Their SI units."""
        self.of_base: Floats = np.array([one[3] for one in outputs])
        """Their values of the deck as it is, SI, shape (of,)."""

    def __getstate__(self) -> tuple[Job, list[str], list[str]]:
        return self._question

    def __setstate__(self, state: tuple[Job, list[str], list[str]]) -> None:
        self._question = state
        self._make()

    def __call__(self, values: npt.ArrayLike, *, threads: int = 0, progress: Progress = None) -> Floats:
        """The wanted values, SI, of rows of numbers.

        values: SI, shape (n, paths), or (paths,) for one row; entries of a single row may be texts with a unit or
        quantities of pint. Returns shape (n, of), or (of,). A row without an answer is NaN; reasons() says why.
        threads: 0 for all cores. Other threads of Python run meanwhile. Raises ValueError for another shape,
        Interrupted after Ctrl-C.
        """
        return self.evaluate(values, threads=threads, progress=progress)[0]

    def evaluate(
        self, values: npt.ArrayLike, *, threads: int = 0, progress: Progress = None
    ) -> tuple[Floats, dict[int, str]]:
        """The same, and the reason of each row without an answer, by its index."""
        rows = self._rows(values)
        single = rows.ndim == 1
        if single:
            rows = rows.reshape(1, -1)
        if rows.ndim != 2 or rows.shape[1] != len(self.paths):
            raise ValueError(f"an array of shape (n, {len(self.paths)}) is expected, a column for each of "
                             f"{', '.join(self.paths)}; this one has {rows.shape}")
        found, without, interrupted, raised = self._native.evaluate(rows, number_of_threads(threads), progress)
        reasons = dict(without)
        if isinstance(raised, KeyboardInterrupt):
            raise Interrupted("the evaluation was interrupted") from raised
        if raised is not None:
            raise raised
        if interrupted:
            raise Interrupted("the evaluation was ended by 'progress'")
        return (found[0] if single else found), reasons

    def reasons(self, values: npt.ArrayLike) -> dict[int, str]:
        """Why rows have no answer, by index; empty where all have one."""
        return self.evaluate(values)[1]

    def _rows(self, values: Any) -> Floats:
        if is_pint(values):
            raise TypeError("give a column for each path: their units differ. [4 * ureg.m, 2 * ureg.kN] is one row")
        if isinstance(values, (list, tuple)) and any(isinstance(one, str) or is_pint(one) for one in values):
            if len(values) != len(self.paths):
                raise ValueError(f"a row has {len(self.paths)} numbers: {', '.join(self.paths)}; this one {len(values)}")
            return np.array([self._number(i, one) for i, one in enumerate(values)])
        if isinstance(values, (list, tuple)) and any(one is None for one in values):
            raise TypeError("None is no number")
        return np.asarray(values, dtype=np.float64)

    def _number(self, i: int, value: Any) -> float:
        if is_pint(value):
            value = pint_text(value)
        return float(self._native.number(i, value) if isinstance(value, str) else value)

    def __repr__(self) -> str:
        return f"<taut.Cases {', '.join(self.paths)} -> {', '.join(self.of)}>"


def cases(deck: Deck, paths: Sequence[str], of: Sequence[str] = (), set: Mapping[str, Any] | None = None) -> Cases:
    """The deck as a function of numbers, compiled once: see Cases."""
    return Cases(deck, paths, of, set)


def evaluate(
    deck: Deck,
    paths: Sequence[str],
    values: npt.ArrayLike,
    of: Sequence[str] = (),
    set: Mapping[str, Any] | None = None,
    *,
    threads: int = 0,
    progress: Progress = None,
) -> Floats:
    """The wanted values of many rows of numbers: cases(deck, paths, of)(values). Shapes (n, paths) -> (n, of), SI."""
    return Cases(deck, paths, of, set)(values, threads=threads, progress=progress)
