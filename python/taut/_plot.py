"""Figures of a result drawn by matplotlib, in the units of print."""

from __future__ import annotations

import difflib
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from . import _taut

COLOURS = {
    "rope": "#1f4e79",
    "second_rope": "#5b9bd5",
    "structure": "#404040",
    "body": "#7f6000",
    "ground": "#8d6e63",
    "hidden": "#a6a6a6",
    "force": "#c00000",
    "second_force": "#ed7d31",
    "axis": "#595959",
    "highlight": "#d62728",
}


def chosen(figures: list[dict[str, Any]], name: str | int | None, key_figure: str) -> dict[str, Any]:
    """The figure of a name, a title or an index; without one the key figure, else the first."""
    if not figures:
        raise LookupError("the result has no figures")
    by_name = {one["name"] or one["title"]: one for one in reversed(figures)}
    if name is None:
        return by_name.get(key_figure, figures[0])
    if isinstance(name, int):
        return figures[name]
    found = by_name.get(name) or next((one for one in figures if one["title"] == name), None)
    if found is None:
        known = list(reversed(by_name))
        near = difflib.get_close_matches(name, known, 1)
        hint = f"did you mean '{near[0]}'?" if near else f"there are {', '.join(known)}"
        raise KeyError(f"there is no figure '{name}'; {hint}")
    return found


def draw(figure: dict[str, Any], ax: Any) -> Any:
    """Draws a figure and returns the axes."""
    if ax is None:
        try:
            from matplotlib import pyplot
        except ImportError as error:
            raise ImportError("plot() needs matplotlib: apt install python3-matplotlib") from error
        ax = pyplot.subplots(figsize=(8, 4.5), layout="constrained")[1]
    DRAW[figure["kind"]](figure, ax)
    ax.set_title(figure["title"], fontsize="medium")
    return ax


def scale_of(unit: tuple[str, str]) -> tuple[float, str]:
    """Numbers in SI times this are in the unit of print; that of SI where the unit of print has an offset."""
    symbol, shown = unit
    if symbol == "1":
        return 1.0, ""
    if shown == "degC" or (symbol == "rad" and shown == "%"):
        return 1.0, symbol
    return _taut.in_unit(1.0, symbol, shown, shown), shown


def _named(label: str, unit: str) -> str:
    return f"{label} [{unit}]" if unit else label


def _legend(ax: Any) -> None:
    if ax.get_legend_handles_labels()[1]:
        ax.legend(fontsize="small")


def _plot(f: dict[str, Any], ax: Any) -> None:
    (kx, ux), (ky, uy) = scale_of(f["x"]["unit"]), scale_of(f["y"]["unit"])
    for curve in f["curves"]:
        style: dict[str, Any] = {"linestyle": "--" if curve["dashed"] else "-"}
        if curve["points_only"]:
            style = {"linestyle": "none", "marker": "o", "markersize": 3}
        ax.plot(kx * curve["x"], ky * curve["y"], label=curve["label"], **style)
    for mark in f["marks"]:
        if mark["whole_line"]:
            ax.axhline(ky * mark["y"], color=COLOURS["highlight"], linestyle=":", label=mark["label"])
        elif mark["upright"]:
            ax.axvline(kx * mark["x"], color=COLOURS["hidden"], linestyle=":", label=mark["label"])
        else:
            ax.plot(kx * mark["x"], ky * mark["y"], "o", color=COLOURS["highlight"], label=mark["label"])
    ax.set_xlabel(_named(f["x"]["label"], ux))
    ax.set_ylabel(_named(f["y"]["label"], uy))
    ax.grid(alpha=0.3)
    _legend(ax)


def _circle_points(shape: dict[str, Any]) -> tuple[Any, Any]:
    begin, end = shape["from"], shape["to"]
    angle = np.linspace(begin, end if end != begin else begin + 2 * math.pi, 73)
    return shape["centre"][0] + shape["radius"] * np.cos(angle), shape["centre"][1] + shape["radius"] * np.sin(angle)


def _shapes(f: dict[str, Any], ax: Any, k: float) -> None:
    legend = dict(f["legend"])
    arrows = [s for s in f["shapes"] if s["shape"] == "arrow"]
    largest = max((math.hypot(*s["force"]) for s in arrows), default=0.0)
    size = _extent(f["shapes"])
    for shape in f["shapes"]:
        colour = COLOURS[shape["role"]]
        if shape["shape"] == "line" and len(shape["points"]):
            x, y = k * shape["points"][:, 0], k * shape["points"][:, 1]
            if shape["closed"]:
                x, y = np.append(x, x[0]), np.append(y, y[0])
            label = legend.pop(shape["role"], None)
            dashes = "--" if shape["role"] in ("hidden", "axis") else "-"
            ax.plot(x, y, dashes, color=colour, label=label, linewidth=1.2)
            if shape["filled"]:
                ax.fill(x, y, color=colour, alpha=0.15)
        elif shape["shape"] == "circle":
            x, y = _circle_points(shape)
            if shape["radius"] > 0:
                ax.plot(k * x, k * y, color=colour, linewidth=1.2)
            if shape["filled"] or shape["radius"] <= 0:
                ax.plot(k * shape["centre"][0], k * shape["centre"][1], ".", color=colour)
        elif shape["shape"] == "arrow":
            # in a polygon of forces the coordinates are newtons: the arrow is the force itself
            _arrow(shape, ax, k, 1.0 if f["unit"][0] == "N" else 0.2 * size / largest if largest > 0 else 0.0)
        elif shape["shape"] == "dimension":
            _dimension(shape, ax, k)
        elif shape["shape"] == "angle":
            x, y = _circle_points(shape)
            ax.plot(k * x, k * y, color=colour, linewidth=0.8)
            ax.text(k * x[36], k * y[36], shape["text"], fontsize="small", color=colour)
        elif shape["shape"] == "label":
            force = f" {shape['force'] / 1e3:.4g} kN" if shape["force"] is not None else ""
            ax.text(k * shape["at"][0], k * shape["at"][1], shape["text"] + force, fontsize="small")


def _extent(shapes: list[dict[str, Any]]) -> float:
    points = [s["points"] for s in shapes if s["shape"] == "line" and len(s["points"])]
    points += [np.array([s["centre"]]) for s in shapes if s["shape"] == "circle"]
    if not points:
        return 1.0
    all_ = np.concatenate(points)
    return float(np.nanmax(np.ptp(all_, axis=0))) or 1.0


def _arrow(shape: dict[str, Any], ax: Any, k: float, long: float) -> None:
    dx, dy = (long * one for one in shape["force"])
    x, y = shape["at"]
    begin = (x - dx, y - dy) if shape["towards"] else (x, y)
    end = (x, y) if shape["towards"] else (x + dx, y + dy)
    free = begin if shape["towards"] else end
    style = {"arrowstyle": "-|>", "color": COLOURS[shape["role"]], "shrinkA": 0, "shrinkB": 0}
    ax.annotate("", (k * end[0], k * end[1]), (k * begin[0], k * begin[1]), arrowprops=style)
    ax.plot([k * begin[0], k * end[0]], [k * begin[1], k * end[1]], alpha=0)  # the axes do not count arrows
    force = math.hypot(*shape["force"]) / 1e3
    ax.text(k * free[0], k * free[1], f"{shape['label']} {force:.4g} kN".strip(), fontsize="small")


def _dimension(shape: dict[str, Any], ax: Any, k: float) -> None:
    (x0, y0), (x1, y1) = shape["from"], shape["to"]
    length = math.hypot(x1 - x0, y1 - y0)
    if length <= 0:
        return
    nx, ny = -(y1 - y0) / length * shape["offset"], (x1 - x0) / length * shape["offset"]
    style = {"arrowstyle": "<->", "color": COLOURS["axis"], "shrinkA": 0, "shrinkB": 0, "linewidth": 0.8}
    ax.annotate("", (k * (x1 + nx), k * (y1 + ny)), (k * (x0 + nx), k * (y0 + ny)), arrowprops=style)
    text = shape["text"] or f"{length:.4g} m"
    if shape["text"] and shape["with_length"]:
        text = f"{shape['text']} {length:.4g} m"
    ax.text(k * ((x0 + x1) / 2 + nx), k * ((y0 + y1) / 2 + ny), text, fontsize="small", ha="center", va="bottom")


def _drawing(f: dict[str, Any], ax: Any) -> None:
    k, unit = scale_of(f["unit"])
    _shapes(f, ax, k)
    if f["vertical_scale"] == 1:
        ax.set_aspect("equal", adjustable="datalim")
    ax.set_xlabel(_named(f["across"] or "x", unit))
    ax.set_ylabel(_named(f["upward"] or "z", unit))
    _legend(ax)


def _animation(f: dict[str, Any], ax: Any) -> None:
    """The first and the last state over each other."""
    last = len(f["t"]) - 1
    for state, alpha in ((0, 0.3), (last, 1.0)) if last > 0 else ((0, 1.0),):
        for line in f["lines"]:
            if state < len(line["points"]) and len(line["points"][state]):
                points = line["points"][state]
                ax.plot(points[:, 0], points[:, 1], color=COLOURS[line["role"]], alpha=alpha, linewidth=1.2)
        for one in f["rounds"]:
            if state < len(one["at"]):
                x, y = one["at"][state]
                ax.plot(x, y, "o", color=COLOURS[one["role"]], alpha=alpha, markersize=4)
                if state == last:
                    ax.annotate(one["label"], (x, y), fontsize="small", xytext=(4, 4), textcoords="offset points")
    if len(f["t"]):
        ax.text(0.02, 0.98, f"pale: t = {f['t'][0]:.4g} s, dark: t = {f['t'][last]:.4g} s", transform=ax.transAxes,
                fontsize="small", va="top")
    ax.set_aspect("equal", adjustable="datalim")
    ax.set_xlabel("x [m]")
    ax.set_ylabel("z [m]")


def _profile(f: dict[str, Any], ax: Any) -> None:
    """The line over the ground, and on a second axis what it bears at each place."""
    if len(f["ground"]):
        ax.plot(f["ground"][:, 0], f["ground"][:, 1], color=COLOURS["ground"], label="ground")
    for name, role, points in f["ropes"]:
        if len(points):
            ax.plot(points[:, 0], points[:, 1], color=COLOURS[role], label=name)
    for name, x, top, ground in f["supports"]:
        if not math.isnan(ground):
            ax.plot([x, x], [ground, top], color=COLOURS["structure"], linewidth=2)
        ax.annotate(name, (x, top), fontsize="small", xytext=(2, 4), textcoords="offset points")
    if f["carriage"] and not any(math.isnan(one) for one in f["carriage_at"]):
        ax.plot(*f["carriage_at"], "s", color=COLOURS["body"], label=f["carriage"])
    ax.set_xlabel("x [m]")
    ax.set_ylabel("z [m]")
    if not f["places"]:
        return
    k, unit = scale_of(f["value"]["unit"])
    second = ax.twinx()
    second.plot([p[0] for p in f["places"]], [k * p[3] for p in f["places"]], "--", color=COLOURS["force"],
                label=f["value"]["label"])
    if not math.isnan(f["limit"]):
        second.axhline(k * f["limit"], color=COLOURS["highlight"], linestyle=":", label="limit")
    second.set_ylabel(_named(f["value"]["label"], unit))
    handles, labels = ax.get_legend_handles_labels()
    more = second.get_legend_handles_labels()
    second.legend(handles + more[0], labels + more[1], fontsize="small")


def _bars(f: dict[str, Any], ax: Any) -> None:
    k, unit = scale_of(f["value"]["unit"])
    count = max((len(bars) for _, bars in f["rows"]), default=1) or 1
    height = 0.8 if f["in_line"] else 0.8 / count
    for j in range(count):
        rows = [(i, bars[j]) for i, (_, bars) in enumerate(f["rows"]) if j < len(bars)]
        at = [i if f["in_line"] else i - 0.4 + (j + 0.5) * height for i, _ in rows]
        ax.barh(at, [k * (b[1] - b[0]) for _, b in rows], height, [k * b[0] for _, b in rows],
                label=f["series"][j] if j < len(f["series"]) else None)
        for y, (_, bar) in zip(at, rows):
            if not (math.isnan(bar[2]) or math.isnan(bar[3])):
                ax.plot([k * bar[2], k * bar[3]], [y, y], color="black", linewidth=1)
    ax.set_yticks(range(len(f["rows"])), [label for label, _ in f["rows"]], fontsize="small")
    ax.invert_yaxis()
    ax.axvline(k * f["base"], color=COLOURS["axis"], linewidth=0.8)
    ax.set_xlabel(_named(f["value"]["label"], unit))
    _legend(ax)


DRAW: dict[str, Callable[[dict[str, Any], Any], None]] = {
    "plot": _plot,
    "drawing": _drawing,
    "animation": _animation,
    "profile": _profile,
    "bars": _bars,
}
