"""A machine: from a deck, from a dict, or built in Python with the words of the C++ builder."""

from __future__ import annotations

import copy
import os
import re
from collections.abc import Mapping, Sequence
from typing import Any, Union

import numpy.typing as npt

from . import _describe
from ._analyses import Analyses
from ._cases import Cases
from ._deck import Deck, Job, _flow, assignment, job_of, method_of, text_of
from ._errors import Mistake
from ._parts import Parts
from ._result import Floats, Result
from ._run import Progress, check, run_job, study
from ._units import Quantity

PathElement = dict[str, Any]
BUILT = "machine built in Python"


def anchor(name: str) -> PathElement:
    """Element of a rope's path: the rope ends at this point, body or carriage."""
    return {"anchor": name}


def over(name: str, side: str | None = None) -> PathElement:
    """Element of a rope's path: the rope runs over this sheave, saddle or point. side: "left" or "right" of the path."""
    return {"over": name, "side": side}


def through(carriage: str) -> PathElement:
    """Element of a rope's path: the carriage rides on the rope here."""
    return {"through": carriage}


def on_drum(name: str, side: str | None = None) -> PathElement:
    """Element of a rope's path: the rope ends on this drum."""
    return {"drum": name, "side": side}


def falls(count: int, first: str, second: str) -> PathElement:
    """Element of a rope's path: `count` parts between two blocks; the rope reaches `first` first."""
    return {"over": first, "parts": count, "between": [first, second]}


class Machine(Analyses, Parts):
    """A machine, its analyses and checks.

        machine = taut.Machine("skyline.yaml")
        machine.set("machine.loads[0].mass", "2 t").solve().values.T_max

    deck: text, path, dict or another Machine; without it a machine that is built by its words: point, rope, sheave,
    reeve and so on. Each returns the machine. Mistakes are told when it is calculated: DeckError.
    It may be changed, so use one in one thread; copy() gives another. It can be pickled.
    """

    def __init__(self, deck: Deck | None = None, *, title: str | None = None) -> None:
        self._built: dict[str, Any] | None = None
        self._job: Job | None = None
        self._set: dict[str, str] = {}
        if deck is None or (isinstance(deck, Mapping) and deck.get("method") is None):
            self._built = {"taut": 1, **copy.deepcopy(dict(deck or {}))}
            self._built.setdefault("machine", {})
        else:
            self._job = job_of(deck)
        if title is not None:
            self.set("title", title)

    def job(self) -> Job:
        """The deck as text, with what was set over it."""
        job = self._job if self._built is None else Job(text_of(self._built), BUILT, made=True)
        assert job is not None
        return job._replace(set=job.set + tuple(self._set.values()))

    @property
    def text(self) -> str:
        """The deck's text, without what was set over it."""
        return self.job().text

    def copy(self) -> Machine:
        """Another machine with the same parts, which can be changed by itself."""
        return copy.deepcopy(self)

    def set(self, path: str, value: Any) -> Machine:
        """Puts a value in place of the deck's: set("machine.loads[0].mass", 1500.0), set("analyses", [...]).

        path: as the program's --set has it; "machine." may be left away. value: an SI number, a text with its unit, a
        quantity of pint, true or false, a list, a dict; of a later call for the same path the later one.
        """
        text = assignment(path, value, method_of(self.job().text))
        self._set.pop(path, None)
        self._set[path] = text
        return self

    def drive(self, drum: str, speed: str) -> Machine:
        """Drives a drum: speed is a text, "0.5 m/s", or the name of a signal. A positive speed takes rope in."""
        drums = self._machine().get("drums", {})
        if drum not in drums:
            raise ValueError(f"there is no drum '{drum}'; add it first: machine.drum('{drum}', ...)")
        drums[drum]["drive"] = {"speed": speed}
        return self

    def force(self, at: str, force: Sequence[Quantity]) -> Machine:
        """A force on a point, body or carriage, [x, y, z] in N, constant in direction."""
        return self._add_part("loads", "records", None, {"at": at, "force": list(force)})

    def run(self, *, progress: Progress = None) -> Result:
        """Runs the deck as it is, with all its analyses and checks: see taut.run."""
        return run_job(self.job(), progress)

    def check(self) -> list[Mistake]:
        """All mistakes, without calculating; an empty list where there is none."""
        return check(self)

    def cases(self, paths: Sequence[str], of: Sequence[str] = ()) -> Cases:
        """The machine as a function of numbers, compiled once: see Cases."""
        return Cases(self, paths, of)

    def evaluate(
        self,
        paths: Sequence[str],
        values: npt.ArrayLike,
        of: Sequence[str] = (),
        *,
        threads: int = 0,
        progress: Progress = None,
    ) -> Floats:
        """The wanted values of many rows of numbers: shapes (n, paths) -> (n, of), SI. See taut.evaluate."""
        return Cases(self, paths, of)(values, threads=threads, progress=progress)

    def _machine(self) -> dict[str, Any]:
        if self._built is None:
            raise TypeError("this machine is the text of a deck: change it by set('machine.points.head', ...), or build "
                            "one with taut.Machine()")
        machine: dict[str, Any] = self._built["machine"]
        return machine

    def _add_part(self, key: str, kind: str, name: Union[str, None], fields: Mapping[str, Any]) -> Machine:
        machine = self._machine()
        if kind == "record":
            machine[key] = copy.deepcopy(dict(fields))
        elif kind == "records":
            machine.setdefault(key, []).append(copy.deepcopy(dict(fields)))
        else:
            named = machine.setdefault(key, {})
            if name in named:
                raise ValueError(f"{key} has '{name}' already; each name stands for one part")
            named[name] = copy.deepcopy(dict(fields))
        return self

    def _run_analysis(
        self,
        kind: str,
        fields: Mapping[str, Any],
        set: Mapping[str, Any] | None = None,
        progress: Progress = None,
    ) -> Result:
        asked = f"analyses={_flow([{kind: dict(fields)}], _describe.machine_deck().find('analyses'))}"
        more = tuple(assignment(path, value) for path, value in (set or {}).items())
        job = self.job()
        blocks = ("design", "study", "calibrate")  # they may speak of the analyses that are left out
        without = tuple(f"{block}=null" for block in blocks if re.search(rf"\b({block}|include)['\"]?\s*:", job.text))
        return run_job(job._replace(set=job.set + without + (asked,) + more), progress)

    def _run_study(
        self,
        fields: Mapping[str, Any],
        folder: Union[str, os.PathLike[str], None] = None,
        threads: int = 0,
        set: Mapping[str, Any] | None = None,
        progress: Progress = None,
    ) -> Result:
        asked = {"study": dict(fields)} if fields else {}
        return study(self, {**asked, **(set or {})}, folder=folder, threads=threads, progress=progress)

    def __repr__(self) -> str:
        job = self.job()
        return f"<taut.Machine {job.name}, {len(job.set)} values set>"
