"""Running decks."""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Callable, Mapping
from typing import Any, Optional

from . import _taut
from ._deck import Deck, Job, job_of
from ._errors import DeckError, FileError, Interrupted, Mistake, raise_mistakes
from ._result import Result

Progress = Optional[Callable[[str, float, str], object]]
"""Called with what is calculated, the part that is done (0 to 1) and words; a returned False ends the calculation."""


MOST_THREADS = 1024


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
        raise Interrupted(f"{what} was interrupted{words}; 'result' of this exception has what was done", result) from raised
    if raised is not None:
        raise raised
    if result is None or native is None:
        raise Interrupted(f"{what} was ended by 'progress'")
    raise_mistakes(native)
    return result


def run_job(job: Job, progress: Progress = None) -> Result:
    """Runs a job."""
    return finished(*_taut.run(job.text, job.name, job.set, progress), "the calculation")


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
    job = job_of(deck, set)
    return [Mistake(*one) for one in _taut.check(job.text, job.name, job.set).errors()]


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
    Raises DeckError, FileError, and Interrupted after Ctrl-C or a False of `progress`.
    """
    threads = number_of_threads(threads)
    job = job_of(deck, set)
    with tempfile.TemporaryDirectory(prefix="taut-") as temporary:
        place = os.fspath(folder) if folder is not None else os.path.join(temporary, "study")
        native, done, of, raised = _taut.study(job.text, job.name, job.set, place, threads, progress)
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
    return finished(*_taut.calibrate(job.text, job.name, job.set, threads, progress), "the calibration")


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
