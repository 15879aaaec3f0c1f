"""Quantities: SI numbers, texts with a unit, quantities of pint."""

from __future__ import annotations

import math
import numbers
from typing import TYPE_CHECKING, Any, Protocol, Union

from . import _taut

if TYPE_CHECKING:
    from ._describe import Field


class PintQuantity(Protocol):
    """A quantity of pint, known by what it can do; the package itself never needs pint."""

    @property
    def magnitude(self) -> Any: ...
    @property
    def dimensionality(self) -> Any: ...
    def to(self, other: Any) -> Any: ...


Quantity = Union[float, str, PintQuantity]
"""A number in SI units, a text with its unit ("12 mm"), or a quantity of pint."""

SI = {"[mass]": "kg", "[length]": "m", "[time]": "s", "[temperature]": "K"}


def is_pint(value: object) -> bool:
    """Whether it is a quantity of pint."""
    return hasattr(value, "magnitude") and hasattr(value, "dimensionality") and hasattr(value, "to")


def pint_number(value: Any, symbol: str) -> Any:
    """The magnitude of a quantity of pint in an SI unit of taut ("N m"; "1": a plain number).

    Raises ValueError where it measures something else.
    """
    unit = "dimensionless" if symbol == "1" else symbol.replace(" ", "*")
    try:
        return value.to(unit).magnitude
    except Exception as error:  # its own classes, which only pint could name
        raise ValueError(f"{value} is not in '{symbol}' and can't be turned into it: {error}") from error


def pint_text(value: Any) -> str:
    """A quantity of pint as a deck writes it, by its dimension: "12.5 kg*m/s^2".

    Raises ValueError for dimensions that no deck has: amounts, currents, luminous intensities.
    """
    if dict(value.dimensionality) == {"[time]": -1}:  # Hz, rpm and rad/s differ by 2 pi from what is in 1/s
        if "radian" in str(value.to_root_units().units):
            return f"{number_text(value.to('radian/s').magnitude)} rad/s"
        unit = "Hz" if "hertz" in str(value.units) else "1/s"
        return f"{number_text(value.to('1/s').magnitude)} {unit}"
    over: list[str] = []
    under: list[str] = []
    for name, power in value.dimensionality.items():
        if name not in SI or power != int(power):
            raise ValueError(f"{value}: a deck has no quantity of dimension {value.dimensionality}")
        into = over if power > 0 else under
        into.append(SI[name] + ("" if abs(power) == 1 else f"^{abs(int(power))}"))
    if not over and not under:
        angle = "radian" in str(value.to_root_units().units)
        return f"{number_text(pint_number(value, '1'))}{' rad' if angle else ''}"
    unit = "*".join(over or ["1"]) + "".join("/" + one for one in under)
    magnitude = value.to("*".join(over + [f"1/{one}" for one in under]) if over else "1/" + "/".join(under)).magnitude
    return f"{number_text(magnitude)} {unit}"


def number_text(value: Any) -> str:
    """A number with every digit; NaN has none and is refused."""
    number = float(value)
    if math.isnan(number):
        raise ValueError("a number of a deck can't be NaN")
    if math.isinf(number):
        return ".inf" if number > 0 else "-.inf"
    return repr(int(number)) if isinstance(value, numbers.Integral) else repr(number)


def quantity_text(value: Any, field: Field | None) -> str:
    """One number as a deck writes it. `field` says its unit; without one a bare number stays bare."""
    symbol = field.unit if field is not None and field.is_number else None
    if is_pint(value):
        if field is None or symbol is None or symbol == "1/s":
            return pint_text(value)
        value = pint_number(value, symbol)
    text = number_text(value)
    return f"{text} {symbol}" if symbol is not None and field is not None and field.needs_text else text


def si(value: Quantity, unit: str | None = None) -> float:
    """The SI number of a quantity: si("12 mm") is 0.012, si("30 deg") 0.5236, si(5.0) 5.0.

    `unit`: the SI unit that it must have ("m", "N", "rad"). Raises ValueError for a text that is no quantity, for an
    unknown or ambiguous unit, and where it measures something else than `unit`.
    """
    if isinstance(value, str):
        number, symbol = _taut.quantity(value)
        if unit is not None and symbol != unit:
            raise ValueError(f"'{value}' is in {symbol}, not in {unit}")
        return number
    if is_pint(value):
        if unit is not None:
            return float(pint_number(value, unit))
        return _taut.quantity(pint_text(value))[0]
    return float(value)  # type: ignore[arg-type]
