"""A result: values, tables, series, checks, verdict, and the report."""

from __future__ import annotations

import html
import os
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np
import numpy.typing as npt

from . import _taut
from ._errors import TautError

if TYPE_CHECKING:
    from ._taut import NativeResult

Floats = npt.NDArray[np.float64]
FRAME = (
    '<iframe title="{title}" sandbox="allow-scripts" style="width: 100%; height: {height}px; border: 1px solid #ccc" '
    'srcdoc="{page}"></iframe>'
)
HEIGHT = 640


class Value(float):
    """One number of a result, SI. It calculates like a float and knows its unit, symbol, label and source."""

    name: str
    unit: str
    shown: str
    symbol: str
    label: str
    source: str

    def __new__(
        cls,
        value: float,
        name: str = "",
        unit: str = "1",
        shown: str = "1",
        symbol: str = "",
        label: str = "",
        source: str = "",
    ) -> Value:
        self = super().__new__(cls, value)
        self.name, self.unit, self.shown = name, unit, shown
        self.symbol, self.label, self.source = symbol, label, source
        return self

    def to(self, unit: str) -> float:
        """The number in another unit of its kind: value.to("mm"). Raises ValueError where the unit does not fit.

        As a report shows it: an angle in "%" is a slope, a temperature in "degC" counts from its own zero, and what is
        shown in Hz turns by 2 pi rad a cycle: 1 Hz in "rad/s" is 6.283.
        """
        return _taut.in_unit(float(self), self.unit, self.shown, unit)

    def pint(self, registry: Any = None) -> Any:
        """The value as a quantity of pint. Needs pint; `registry`: default pint's application registry."""
        if registry is None:
            import pint

            registry = pint.get_application_registry()
        unit = "dimensionless" if self.unit == "1" else self.unit.replace(" ", "*")
        return registry.Quantity(float(self), unit)


class Values(Mapping[str, Value]):
    """Numbers by name: values["D_tube"], and values.D_tube where the name is an identifier. In the order of print."""

    def __init__(self, rows: list[tuple[Any, ...]], why_empty: str) -> None:
        self._all = {row[0]: Value(row[1], row[0], *row[2:7]) for row in rows}
        self._why_empty = why_empty

    def __getitem__(self, name: str) -> Value:
        try:
            return self._all[name]
        except KeyError:
            raise KeyError(_no_such("value", name, self._all, self._why_empty)) from None

    def __getattr__(self, name: str) -> Value:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self._all[name]
        except KeyError:
            raise AttributeError(_no_such("value", name, self._all, self._why_empty)) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name for name in self._all if name.isidentifier())]

    def __repr__(self) -> str:
        width = max((len(name) for name in self._all), default=0)
        return "\n".join(f"{name:{width}}  {float(v):.6g} {v.unit if v.unit != '1' else ''}".rstrip()
                         for name, v in self._all.items())

    def to_pandas(self) -> Any:
        """A pandas DataFrame with value, unit, symbol, label by name. Needs pandas."""
        pandas = _pandas()
        rows = {name: (float(v), v.unit, v.symbol, v.label) for name, v in self._all.items()}
        return pandas.DataFrame.from_dict(rows, orient="index", columns=["value", "unit", "symbol", "label"])


class Table:
    """A table, or a series, of a result. Columns by name: a read-only view of float64 (NaN: no value), shape (rows,),
    or a list where the column holds texts. SI.
    """

    def __init__(self, data: dict[str, Any]) -> None:
        self.name: str = data["name"]
        self.title: str = data["title"]
        self.columns: tuple[str, ...] = tuple(one[0] for one in data["columns"])
        self.units: dict[str, str] = {one[0]: one[1] for one in data["columns"]}
        self._columns = dict(zip(self.columns, data["data"]))

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        for column in self._columns.values():
            if isinstance(column, np.ndarray):
                column.flags.writeable = False

    def __getitem__(self, column: str) -> Any:
        try:
            return self._columns[column]
        except KeyError:
            raise KeyError(_no_such("column", column, self._columns, "")) from None

    def numbers(self, column: str) -> Floats:
        """A column of numbers, shape (rows,). Raises TypeError for a column of texts."""
        found = self[column]
        if not isinstance(found, np.ndarray):
            raise TypeError(f"the column '{column}' holds texts; table['{column}'] is the list of them")
        return found

    def texts(self, column: str) -> list[str]:
        """A column as texts."""
        return [str(one) for one in self[column]]

    def __contains__(self, column: object) -> bool:
        return column in self._columns

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self._columns[self.columns[0]]) if self.columns else 0

    def __repr__(self) -> str:
        names = ", ".join(f"{name} [{unit}]" if unit != "1" else name for name, unit in self.units.items())
        return f"<Table {self.name}: {len(self)} rows of {names}>"

    def to_pandas(self) -> Any:
        """A pandas DataFrame of its columns, SI; attrs["units"] are the units. Needs pandas."""
        frame = _pandas().DataFrame(self._columns)
        frame.attrs["units"] = dict(self.units)
        return frame

    def _repr_html_(self) -> str:
        most = 30
        heads = "".join(f"<th>{html.escape(n)}{f' [{u}]' if u != '1' else ''}</th>" for n, u in self.units.items())
        rows = ["".join(f"<td>{_cell(self._columns[name][i])}</td>" for name in self.columns)
                for i in range(min(len(self), most))]
        more = "" if len(self) <= most else f"<p>{len(self) - most} more rows</p>"
        body = "".join(f"<tr>{row}</tr>" for row in rows)
        return f"<table><thead><tr>{heads}</tr></thead><tbody>{body}</tbody></table>{more}"


class Tables(Mapping[str, Table]):
    """Tables by name, in the order of print."""

    def __init__(self, data: list[dict[str, Any]], what: str) -> None:
        self._all = {one["name"]: Table(one) for one in data}
        self._what = what

    def __getitem__(self, name: str) -> Table:
        try:
            return self._all[name]
        except KeyError:
            raise KeyError(_no_such(self._what, name, self._all, "")) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __repr__(self) -> str:
        return "\n".join(repr(one) for one in self._all.values())


class Check(NamedTuple):
    """A value against its limit, SI. `sense`: at_most or at_least.

    `refused`: the limit is unverified, and the deck refuses such limits: nothing is judged by it, and `passes` is
    False. Else `passes` is True exactly where utilisation <= 1; that is nan where limit or value are no measure of each
    other (a limit of 0). `limits` is False for breaking force, yield and ground: they judge no rope and no beam. `covers`
    names the ropes and beams that another limit judges; it is empty for one of something else than strength.
    `outcome` is what the report says.
    """

    name: str
    value: float
    limit: float
    unit: str
    sense: str
    utilisation: float
    passes: bool
    rule: str
    trust: str
    part: str
    where: str
    limits: bool
    covers: list[str]
    refused: bool

    @property
    def outcome(self) -> str:
        """passes, fails or refused."""
        return "refused" if self.refused else "passes" if self.passes else "fails"


Head = dict[str, Any]


class Result:
    """What a run of a deck gives. It is never changed; any thread may read it, and it can be pickled.

    status: "ok"; "infeasible" or "not_converged" where there is no answer, which `message` explains.
    verdict: "passes", "passes_with_warnings", "not_judged", "fails" or "no_answer"; verdict_reason says why.
    In a notebook it shows the report, in a frame of its own.
    """

    _parts_of_native = ("head", "values", "tables", "series", "checks", "steps", "given", "comparisons", "figures")

    def __init__(self, native: NativeResult) -> None:
        self._native: NativeResult | None = native
        self._parts: dict[str, Any] = {}

    def _part(self, name: str) -> Any:
        if name not in self._parts:
            if self._native is None:
                raise AttributeError(name)
            # two threads may both make it: the same data, of which one stays
            self._parts.setdefault(name, getattr(self._native, name)())
        return self._parts[name]

    def _made(self, name: str, make: Any) -> Any:
        return self._parts.setdefault(name, make()) if name not in self._parts else self._parts[name]

    def __getstate__(self) -> dict[str, Any]:
        if self._native is not None:
            for name in (*self._parts_of_native, "html", "markdown", "json"):
                self._part(name)
            self._part_text(False)
            self._part_text(True)
        made = ("values made", "tables made", "series made", "checks made")
        return {name: part for name, part in self._parts.items() if name not in made}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._native = None
        self._parts = state

    def _part_text(self, all: bool) -> str:
        name = "text all" if all else "text"
        if name not in self._parts and self._native is not None:
            self._parts.setdefault(name, self._native.text(all))
        text: str = self._parts[name]
        return text

    @property
    def head(self) -> Head:
        """title, method, source, status, message, verdict, warnings, assumptions, answers, deck_hash and so on."""
        head: Head = self._part("head")
        return head

    @property
    def title(self) -> str:
        """Title of the deck."""
        return str(self.head["title"])

    @property
    def status(self) -> str:
        """ok, infeasible or not_converged."""
        return str(self.head["status"])

    @property
    def ok(self) -> bool:
        """Whether there is an answer. It says nothing of the verdict."""
        return self.status == "ok"

    @property
    def message(self) -> str:
        """Why there is no answer, and what to change; empty where there is one."""
        return str(self.head["message"])

    @property
    def verdict(self) -> str:
        """passes, passes_with_warnings, not_judged, fails or no_answer."""
        return str(self.head["verdict"])

    @property
    def verdict_class(self) -> str:
        """Of not_judged: unmade, unverified or unasked; else empty."""
        return str(self.head["verdict_class"])

    @property
    def verdict_reason(self) -> str:
        """One sentence that names the worst thing."""
        return str(self.head["verdict_reason"])

    @property
    def warnings(self) -> list[str]:
        """Sentences."""
        return list(self.head["warnings"])

    @property
    def interrupted(self) -> bool:
        """Whether it was ended from outside; it then holds what was done until then."""
        return bool(self.head["interrupted"])

    @property
    def answers(self) -> dict[str, str]:
        """The main answer, line by line, in the units of print."""
        return dict(self.head["answers"])

    @property
    def attachments(self) -> dict[str, str]:
        """Texts of files that belong to the result: state.json, calibrated.yaml."""
        return dict(self.head["attachments"])

    @property
    def values(self) -> Values:
        """Numbers by name, SI."""
        why = f"the result is {self.status}: {self.message}" if not self.ok else ""
        values: Values = self._made("values made", lambda: Values(self._part("values"), why))
        return values

    @property
    def tables(self) -> Tables:
        """Tables by name, SI."""
        tables: Tables = self._made("tables made", lambda: Tables(self._part("tables"), "table"))
        return tables

    @property
    def series(self) -> Tables:
        """Long tables by name, such as a motion over time, and the data of the plots. SI; columns are views."""
        series: Tables = self._made("series made", lambda: Tables(self._part("series"), "series"))
        return series

    @property
    def checks(self) -> list[Check]:
        """Every value that is held against a limit."""
        checks: list[Check] = self._made("checks made", lambda: [Check(**one) for one in self._part("checks")])
        return checks

    @property
    def steps(self) -> list[dict[str, Any]]:
        """Equations of the calculation note: eq, symbol, value (SI), unit, source, words."""
        return list(self._part("steps"))

    @property
    def given(self) -> list[dict[str, Any]]:
        """Inputs as used: key, symbol, words, unit, numbers (SI), text, is_default, chosen."""
        return list(self._part("given"))

    @property
    def comparisons(self) -> list[dict[str, Any]]:
        """Printed, corrected and exact values side by side, SI; NaN: no value."""
        return list(self._part("comparisons"))

    @property
    def figures(self) -> list[dict[str, Any]]:
        """Drawings and plots as data, SI; see plot()."""
        return list(self._part("figures"))

    def html(self) -> str:
        """The report: one page with all that it needs."""
        return str(self._part("html"))

    def markdown(self) -> str:
        """The report as Markdown."""
        return str(self._part("markdown"))

    def json(self) -> str:
        """The result as `taut run --json` prints it."""
        return str(self._part("json"))

    def text(self, all: bool = False) -> str:
        """The answer as the program prints it on a terminal. `all`: every value, check, table and warning."""
        return self._part_text(all)

    def write(self, folder: str | os.PathLike[str], *, si: bool = False, appendix: bool = False) -> list[str]:
        """Writes what `taut run -o` writes: report.html, result.json, the tables. Returns the paths.

        si: tables in SI units. appendix: the report's appendix is unfolded. Raises FileError where the folder can't be
        written, TautError for a result that was unpickled: run its deck again, or keep html() and json().
        """
        if self._native is None:
            raise TautError("an unpickled result can't be written as files: run its deck again, or use html(), json()")
        return self._native.write(os.fspath(folder), si, appendix)

    def plot(self, name: str | int | None = None, ax: Any = None) -> Any:
        """Draws a figure of the result with matplotlib and returns the axes.

        name: name, title or index of a figure; default: the one on the first page of the report. ax: axes to draw into.
        Needs matplotlib. Raises LookupError for an unknown figure and for a result without figures.
        """
        from ._plot import chosen, draw

        return draw(chosen(self.figures, name, str(self.head["key_figure"])), ax)

    def __repr__(self) -> str:
        words = self.head["headline"] or self.verdict_reason or self.message
        return f"<taut.Result {self.title!r}: {self.status}, {self.verdict}. {words}>"

    def __str__(self) -> str:
        return self.text()

    def _repr_html_(self) -> str:
        """The report in a frame: its styles and scripts see nothing of the notebook, nor the notebook's it."""
        return FRAME.format(title=html.escape(self.title, quote=True), height=HEIGHT,
                            page=html.escape(self.html(), quote=True))


def _cell(value: Union[float, str]) -> str:
    if isinstance(value, str):
        return html.escape(value)
    return "" if value != value else f"{value:.6g}"


def _no_such(what: str, name: str, known: Mapping[str, Any], why_empty: str) -> str:
    import difflib

    if not known:
        return f"there is no {what} '{name}'; {why_empty or 'there are none'}"
    near = difflib.get_close_matches(name, known, 3)
    hint = f"did you mean {', '.join(near)}?" if near else f"there are {', '.join(list(known)[:12])}"
    return f"there is no {what} '{name}'; {hint}"


def _pandas() -> Any:
    try:
        import pandas
    except ImportError as error:
        raise ImportError("this needs pandas: apt install python3-pandas") from error
    return pandas
