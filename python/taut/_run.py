"""Running decks."""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Callable, Mapping
from typing import Any, Optional, TypeVar

from . import _taut
from ._deck import Deck, Job, job_of, readable, with_units
from ._errors import DeckError, FileError, Interrupted, Mistake, raise_mistakes
from ._result import Result

Progress = Optional[Callable[[str, float, str], object]]
"""Called with what is calculated, the part that is done (0 to 1) and words; a returned False ends the calculation."""


MOST_THREADS = 1024
Asked = TypeVar("Asked")


def number_of_threads(threads: int) -> int:
    """The same number, where so many threads can be at work."""
    if not 0 <= threads <= MOST_THREADS:
        raise ValueError(f"threads: 0 for all cores, or a number of them up to {MOST_THREADS}, not {threads}")
    return threads


def finished(native: _taut.NativeResult | None, raised: BaseException | None, what: str) -> Result:
    """The result; raises what has ended the calculation, or the mistakes of the deck."""
    result = None if native is None else Result(native)
    if isinstance(raised, KeyboardInterrupt):
        words = f": {result.message}" if result is not None and result.message else ""
        kept = "" if result is None else "; 'result' of this exception has what was done"
        raise Interrupted(f"{what} was interrupted{words}{kept}", result) from raised
    if raised is not None:
        raise raised
    if result is None or native is None:
        raise Interrupted(f"{what} was ended by 'progress'")
    raise_mistakes(native)
    return result


def mistakes_of(native: _taut.NativeResult | None) -> list[Mistake]:
    """The mistakes of the deck that a result tells."""
    return [] if native is None else [Mistake(*one) for one in native.errors()]


def asked(job: Job, ask: Callable[[Job], Asked], native: Callable[[Asked], _taut.NativeResult | None]) -> Asked:
    """The answer to a job, of which `native` is the result with the mistakes; asked anew with the SI units that these
    want of bare numbers. Mistakes are told before anything is calculated.
    """
    answer = ask(readable(job))
    while (more := with_units(job, mistakes_of(native(answer)))) != job:
        job = more
        answer = ask(job)
    return answer


def run_job(job: Job, progress: Progress = None) -> Result:
    """Runs a job."""
    answer = asked(job, lambda one: _taut.run(one.text, one.name, one.set, progress), lambda found: found[0])
    return finished(*answer, "the calculation")


def run(deck: Deck, set: Mapping[str, Any] | None = None, *, progress: Progress = None) -> Result:
    """Runs a deck and returns its result, also where there is no answer (`result.ok`, `result.message`).

    deck: text, path, dict or Machine. set: values over the deck by path, {"machine.loads[0].mass": "2 t"}; a bare
    number is SI. progress: called a few times a second with what, part done (0 to 1), words; False ends it, and the
    result has what was done (`interrupted`).
    Raises DeckError (file, line, column, caret) for mistakes of the deck, FileError for files that can't be read,
    Interrupted after Ctrl-C, with what was done as its `result`.
    """
    return run_job(job_of(deck, set), progress)


def check(deck: Deck, set: Mapping[str, Any] | None = None) -> list[Mistake]:
    """All mistakes of a deck without calculating it; an empty list where there is none.

    Raises FileError where the deck itself can't be read.
    """
    native = asked(job_of(deck, set), lambda one: _taut.check(one.text, one.name, one.set), lambda found: found)
    return mistakes_of(native)


def schema() -> str:
    """The JSON Schema (draft 7) of decks."""
    return _taut.schema()


def new(name: str) -> str:
    """The text of a deck to begin from: of a method or of a machine, see names(). Raises ValueError for others."""
    return _taut.new(name)


def names() -> list[str]:
    """Names that new() takes."""
    return _taut.names()


def read(path: str | os.PathLike[str]) -> str:
    """The text of a deck's file. Raises FileError where it can't be read."""
    return _taut.read_file(os.fspath(path))[0]


def explain(name: str) -> str:
    """What the program prints for `taut explain NAME`. Raises ValueError where nothing has the name."""
    return _taut.explain(name)


def listing(what: str, name: str = "") -> str:
    """What the program prints for `taut list WHAT`: ropes, sections, steels, units, methods. `name`: a part of it."""
    return _taut.listing(what, name)


def compare(path: str | os.PathLike[str]) -> Result:
    """Runs a set of decks beside published numbers: a folder with compare.part.yaml, or such a file."""
    native = _taut.compare(*_taut.read_set(os.fspath(path)))
    return finished(native, None, "the comparison")


def study(
    deck: Deck,
    set: Mapping[str, Any] | None = None,
    *,
    folder: str | os.PathLike[str] | None = None,
    threads: int = 0,
    progress: Progress = None,
) -> Result:
    """Calculates the `study:` of a deck, as `taut study run` does, on all cores or `threads` of them.

    folder: keeps the cases there; called again with the same deck it goes on where it was ended. Default: a temporary
    one. All cases are in series["cases"].
    Raises DeckError, FileError, and Interrupted after Ctrl-C or a False of `progress`: without a result, as the cases
    that are done stand in `folder` alone.
    """
    threads = number_of_threads(threads)
    job = job_of(deck, set)
    with tempfile.TemporaryDirectory(prefix="taut-") as temporary:
        place = os.fspath(folder) if folder is not None else os.path.join(temporary, "study")
        native, done, of, raised = asked(
            job, lambda one: _taut.study(one.text, one.name, one.set, place, threads, progress), lambda found: found[0]
        )
    kept = f"the study, with {done} of {of} cases done,"
    return finished(native, raised, kept if of else "the study")


def calibrate(
    deck: Deck, set: Mapping[str, Any] | None = None, *, threads: int = 0, progress: Progress = None
) -> Result:
    """Finds the numbers that the deck's `calibrate:` leaves free, by least squares of what was measured.

    attachments["calibrated.yaml"] is the deck with the numbers found. progress: as in run(). Raises DeckError,
    FileError, and Interrupted after Ctrl-C or a False of `progress`.
    """
    threads = number_of_threads(threads)
    job = job_of(deck, set)
    answer = asked(
        job, lambda one: _taut.calibrate(one.text, one.name, one.set, threads, progress), lambda found: found[0]
    )
    return finished(*answer, "the calibration")


def show_progress(what: str, done: float, words: str) -> None:
    """A `progress` that writes one line to standard error."""
    sys.stderr.write(f"\r\033[K{what}: {words or ''} {100 * done:.0f} %" + ("\n" if done >= 1 else ""))
    sys.stderr.flush()


__all__ = [
    "DeckError",
    "FileError",
    "calibrate",
    "check",
    "compare",
    "explain",
    "listing",
    "names",
    "new",
    "read",
    "run",
    "schema",
    "show_progress",
    "study",
]
