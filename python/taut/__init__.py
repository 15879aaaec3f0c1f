"""taut: checked, explained calculations of rope-driven machines.

    import taut
    result = taut.run(taut.new("mast_section"))
    print(result.verdict, result.values.D_tube)

A deck is the text, the path of a file, a dict or a Machine. Numbers are SI (m, kg, N, Pa, s, rad); a text carries its
unit ("12 mm"), and a quantity of pint is taken as it is. docs/guide/python.md is the guide.
"""

from . import methods
from ._cases import Cases, cases, evaluate
from ._deck import Deck
from ._errors import (
    DeckError,
    FileError,
    Interrupted,
    Mistake,
    NoAnswer,
    QuestionError,
    TautError,
)
from ._machine import Machine, anchor, falls, on_drum, over, through
from ._result import Check, Floats, Result, Table, Tables, Value, Values
from ._run import (
    calibrate,
    check,
    compare,
    explain,
    listing,
    names,
    new,
    read,
    run,
    schema,
    show_progress,
    study,
)
from ._taut import version as __version__
from ._units import Quantity, si

__all__ = [
    "Cases",
    "Check",
    "Deck",
    "DeckError",
    "FileError",
    "Floats",
    "Interrupted",
    "Machine",
    "Mistake",
    "NoAnswer",
    "Quantity",
    "QuestionError",
    "Result",
    "Table",
    "Tables",
    "TautError",
    "Value",
    "Values",
    "__version__",
    "anchor",
    "calibrate",
    "cases",
    "check",
    "compare",
    "evaluate",
    "explain",
    "falls",
    "listing",
    "methods",
    "names",
    "new",
    "on_drum",
    "over",
    "read",
    "run",
    "schema",
    "show_progress",
    "si",
    "study",
    "through",
]
