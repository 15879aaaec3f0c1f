"""Draws the figures of docs/theory: python3 docs/images/theory/figures.py writes NAME.svg for each function NAME below.

Lengths are pixels, x to the right, y upwards, the origin at the lower left corner. Ropes are blue and follow the law of
the catenary; forces are red; dimensions and ground are thin. In a label, $T_0$ is italic with an index.
"""
import math
import os
import re
from math import atan2, cos, exp, hypot, pi, radians, sin, sqrt, tan

STYLE = """.l{fill:none;stroke:#222;stroke-width:1.4}.b{fill:none;stroke:#222;stroke-width:2.6}
.r{fill:none;stroke:#1a5fb4;stroke-width:2.4}.q{fill:none;stroke:#1a5fb4;stroke-width:1.3;stroke-dasharray:6 4}
.f{fill:none;stroke:#c01c28;stroke-width:2}.d{fill:none;stroke:#666;stroke-width:1}
.c{fill:none;stroke:#666;stroke-width:1;stroke-dasharray:9 3 2 3}
.h{fill:none;stroke:#222;stroke-width:1.3;stroke-dasharray:5 4}
text{font:15px Arial,'Liberation Sans','DejaVu Sans',sans-serif;fill:#222}
.k{fill:none;stroke:#fff;stroke-width:5;stroke-linejoin:round}
.i{font:italic 17px 'Times New Roman','Liberation Serif','DejaVu Serif',serif}.s{font-size:12px}"""
INK = {"l": "#222", "b": "#222", "r": "#1a5fb4", "f": "#c01c28", "d": "#666", "c": "#666", "h": "#222"}


def at(p, angle, r):
    """The point at the distance r from p in the direction of the angle (rad)."""
    return (p[0] + r * cos(angle), p[1] + r * sin(angle))


def between(p, q, share):
    return (p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]))


def rope_shape(p, q, length, w=1.0, EA=math.inf, loads=(), n=48):
    """A rope of unstretched length between p and q: points, tension (H, V) at p, tension at q, points of the loads.

    A chain of elastic catenaries (docs/theory/catenary.md, loaded-span.md), one between neighbouring loads (s, P): the
    force at p is found by bisection, as x grows with H and z with V.
    """
    cuts = [0.0] + [s for s, _ in loads] + [length]
    weights = [P for _, P in loads] + [0.0]

    def end(H, V, shape=None, marks=None):
        x, z = p
        for k in range(len(cuts) - 1):
            L = cuts[k + 1] - cuts[k]
            pieces = 1 if shape is None else max(2, round(n * L / length))
            for _ in range(pieces):
                l = L / pieces
                V1 = V + w * l
                stretch = l / EA
                I = (math.asinh(V1 / H) - math.asinh(V / H)) / w if w > 0 else l / hypot(H, V)
                x += H * (stretch + I)
                z += (V + V1) / 2 * (stretch + 2 * l / (hypot(H, V) + hypot(H, V1)))
                V = V1
                if shape is not None:
                    shape.append((x, z))
            if marks is not None and k < len(loads):
                marks.append((x, z))
            V += weights[k]
        return x, z, V

    total = w * length + sum(weights)

    def upright(H):  # V at p that brings the end to the height of q
        low, high = -50 * (total + H), 50 * (total + H)
        for _ in range(90):
            V = (low + high) / 2
            if end(H, V)[1] < q[1]:
                low = V
            else:
                high = V
        return (low + high) / 2

    low, high = 1e-6 * total, 1e4 * total
    for _ in range(80):
        H = sqrt(low * high)
        if end(H, upright(H))[0] < q[0]:
            low = H
        else:
            high = H
    H = sqrt(low * high)
    V = upright(H)
    shape, marks = [p], []
    V1 = end(H, V, shape, marks)[2]
    return shape, (H, V), (H, V1), marks


def tangent(c1, r1, s1, c2, r2, s2):
    """Ends of the line from the round (centre, radius, side) to the next one (docs/theory/tangent.md); side +1: the
    rope turns clockwise in the drawing."""
    dx, dy = c2[0] - c1[0], c2[1] - c1[1]
    rho = s2 * r2 - s1 * r1
    square = dx * dx + dy * dy
    l = sqrt(square - rho * rho)
    # axis into the paper: n x t = (t_y, -t_x)
    t = ((l * dx - rho * dy) / square, (l * dy + rho * dx) / square)
    return ((c1[0] - s1 * r1 * t[1], c1[1] + s1 * r1 * t[0]), (c2[0] - s2 * r2 * t[1], c2[1] + s2 * r2 * t[0]), t)


class Figure:
    def __init__(self, width=640, height=320):
        self.width, self.height, self.parts = width, height, []

    def put(self, svg):
        self.parts.append(svg)

    def xy(self, p):
        return f"{p[0]:.1f}".rstrip("0").rstrip(".") + " " + f"{self.height - p[1]:.1f}".rstrip("0").rstrip(".")

    def line(self, *points, kind="l", close=False, fill=None):
        d = "M" + "L".join(self.xy(p) for p in points) + ("z" if close else "")
        style = f' style="fill:{fill}"' if fill else ""
        self.put(f'<path class="{kind}" d="{d}"{style}/>')

    def circle(self, c, r, kind="l", fill="#fff"):
        x, y = self.xy(c).split()
        self.put(f'<circle class="{kind}" cx="{x}" cy="{y}" r="{r:.1f}" style="fill:{fill}"/>')

    def dot(self, c, r=3.2, colour="#222"):
        x, y = self.xy(c).split()
        self.put(f'<circle cx="{x}" cy="{y}" r="{r}" fill="{colour}"/>')

    def arc(self, c, r, a0, a1, kind="l", heads=""):
        """From the angle a0 to a1 (rad, anticlockwise where a1 > a0)."""
        n = max(4, int(abs(a1 - a0) * r / 6), int(abs(a1 - a0) * 8))
        points = [at(c, a0 + (a1 - a0) * i / n, r) for i in range(n + 1)]
        self.line(*points, kind=kind)
        if "e" in heads:
            self.head(at(c, a1 - math.copysign(9 / r, a1 - a0), r), points[-1], kind)
        if "b" in heads:
            self.head(at(c, a0 + math.copysign(9 / r, a1 - a0), r), points[0], kind)

    def head(self, p, q, kind, size=10):
        a = atan2(q[1] - p[1], q[0] - p[0])
        d = "M" + "L".join(self.xy(x) for x in (q, at(q, a + pi - 0.27, size), at(q, a + pi + 0.27, size))) + "z"
        self.put(f'<path d="{d}" fill="{INK[kind]}"/>')

    def arrow(self, p, q, label=None, place=None, kind="f", anchor="middle"):
        """An arrow from p to q; the label stands at its head, `place` pixels off."""
        a = atan2(q[1] - p[1], q[0] - p[0])
        self.line(p, at(q, a, -7), kind=kind)
        self.head(p, q, kind)
        if label:
            off = place or (14 * cos(a), 14 * sin(a))
            self.text((q[0] + off[0], q[1] + off[1]), label, anchor, middle=True)

    def dimension(self, p, q, label, off=0.0, place=None, extend=True):
        """A dimension line from p to q, moved by `off` to its left, with its label above the middle."""
        a = atan2(q[1] - p[1], q[0] - p[0])
        p1, q1 = at(p, a + pi / 2, off), at(q, a + pi / 2, off)
        if extend and abs(off) > 8:
            for u, v in ((p, p1), (q, q1)):
                way = atan2(v[1] - u[1], v[0] - u[0])
                self.line(at(u, way, 4), at(v, way, 5), kind="d")
        self.line(p1, q1, kind="d")
        self.head(p1, q1, "d", 9)
        self.head(q1, p1, "d", 9)
        m = between(p1, q1, 0.5)
        dx, dy = place if place else (-12 * sin(a), 12 * cos(a))
        self.text((m[0] + dx, m[1] + dy), label, "middle", middle=True)

    def text(self, p, label, anchor="start", middle=True, small=False, rim=True):
        """Words; parts in $...$ are symbols, _x or _{xy} an index, ^x a power."""
        x, y = self.xy((p[0], p[1] - (5 if middle else 0))).split()
        out = []
        for k, part in enumerate(label.split("$")):
            part = part.replace("&", "&amp;").replace("<", "&lt;")
            if k % 2 == 0:
                out.append(part)
                continue

            def index(m):
                up = m.group(1) == "^"
                what = (m.group(2) or m.group(3))
                shift = -6 if up else 4
                return f'<tspan dy="{shift}" font-size="12">{what}</tspan><tspan dy="{-shift}">\u200b</tspan>'

            out.append('<tspan class="i">' + re.sub(r"([_^])(?:\{([^}]*)\}|(.))", index, part) + "</tspan>")
        size = "s" if small else ""
        for cls in ("k " + size, size) if rim else (size,):  # a white rim below the letters, where they cross a line
            self.put(f'<text class="{cls.strip()}" x="{x}" y="{y}" text-anchor="{anchor}" xml:space="preserve">'
                     f'{"".join(out)}</text>')

    def ground(self, p, q, depth=9):
        """A held line: hatched on its right-hand side, seen from p to q."""
        a = atan2(q[1] - p[1], q[0] - p[0])
        self.line(p, q, kind="l")
        n = max(1, int(hypot(q[0] - p[0], q[1] - p[1]) / 9))
        d = "".join("M" + self.xy(between(p, q, (i + 0.9) / n)) +
                    "L" + self.xy(at(between(p, q, (i + 0.9) / n), a - 2.2, depth)) for i in range(n))
        self.put(f'<path class="d" d="{d}"/>')

    def pin(self, c, down=-pi / 2, size=13, hatch=True):
        """A fixed bearing: triangle and ground, in the direction `down` from c."""
        l, r = at(at(c, down, size), down - pi / 2, size * 0.7), at(at(c, down, size), down + pi / 2, size * 0.7)
        self.line(c, l, r, close=True, fill="#fff")
        if hatch:
            self.ground(at(l, down - pi / 2, 4), at(r, down + pi / 2, 4), 7)
        self.circle(c, 3.2)

    def sheave(self, c, r, fill="#f2f2f2"):
        self.circle(c, r, fill=fill)
        self.circle(c, max(2.5, r * 0.1), fill="#222")

    def load(self, p, size=26, label=None, cable=14):
        """A block that hangs from p."""
        top = (p[0], p[1] - cable)
        self.line(p, top)
        self.line((p[0] - size / 2, top[1]), (p[0] + size / 2, top[1]), (p[0] + size / 2, top[1] - size * 0.7),
                  (p[0] - size / 2, top[1] - size * 0.7), close=True, fill="#e4e4e4")
        if label:
            self.text((p[0] + size / 2 + 6, top[1] - size * 0.35), label)

    def axes(self, origin, width, height, x, y, below=True):
        self.arrow(origin, (origin[0] + width, origin[1]), kind="l")
        self.arrow(origin, (origin[0], origin[1] + height), kind="l")
        self.text((origin[0] + width, origin[1] + (-17 if below else 14)), x, "end")
        self.text((origin[0] + 8, origin[1] + height - 3), y)

    def save(self, name):
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
                f'viewBox="0 0 {self.width} {self.height}">\n<style>{STYLE}</style>\n'
                f'<rect width="{self.width}" height="{self.height}" fill="#fff"/>\n')
        folder = os.path.dirname(os.path.abspath(__file__))
        with open(os.path.join(folder, name + ".svg"), "w", encoding="utf8") as file:
            file.write(head + "\n".join(self.parts) + "\n</svg>\n")


def catenary(f):
    p, q = (90, 145), (430, 235)
    shape, (H, V0), (_, V1), _ = rope_shape(p, q, 385, 1.0)
    f.axes(p, 395, 125, "$x$", "$z$")
    f.line(*shape, kind="r")
    f.dot(p)
    f.dot(q)
    f.line(p, q, kind="c")
    k = 0.24
    f.arrow(p, (p[0] - k * H, p[1] - k * V0), "$T_0$", (-4, 16))
    f.arrow(q, (q[0] + k * H, q[1] + k * V1), "$T_1$", (14, 8))
    m = shape[len(shape) // 2]
    V = (V0 + V1) / 2
    f.dot(m)
    f.arrow(m, (m[0] + k * H, m[1]), "$H$", (-4, -15))
    f.arrow((m[0] + k * H, m[1]), (m[0] + k * H, m[1] + k * V), "$V$", (13, -9))
    f.text((m[0] + 6, m[1] - 24), "middle, $s$ = $L$/2", "end")
    f.arrow((p[0] + 8, p[1] - 19), (p[0] + 52, p[1] - 41), "$s$", (2, -12), kind="d")
    f.dimension((p[0], 40), (q[0], 40), "$x$")
    f.line((q[0], 230), (q[0], 32), kind="d")
    f.line((p[0], 140), (p[0], 32), kind="d")
    f.text((240, 218), "chord $c$", "middle")
    # an element
    a, b = (525, 96), (575, 122)
    f.line(a, b, kind="r")
    f.arrow(a, (492, 83), "$T$", (-10, -8))
    f.arrow(b, (612, 147), "$T$ + d$T$", (-6, 14))
    f.arrow((550, 109), (550, 62), "$w$ d$s$", (0, -10))
    f.text((560, 200), "element d$s$", "middle")


def parabola(f):
    p, q = (85, 215), (560, 285)
    l, h = q[0] - p[0], q[1] - p[1]
    sag = 105
    curve = [(p[0] + l * i / 40, p[1] + h * i / 40 - 4 * sag * (i / 40) * (1 - i / 40)) for i in range(41)]
    f.line(p, q, kind="c")
    f.line(*curve, kind="r")
    f.dot(p)
    f.dot(q)
    for i in range(1, 12):  # weight along the chord
        a = between(p, q, i / 12)
        f.arrow((a[0], a[1] + 30), (a[0], a[1] + 8), kind="f")
    f.line((p[0] + 10, p[1] + 31.5), (q[0] - 10, q[1] + 28.5), kind="f")
    f.text((230, 287), "$w$ per metre of chord $c$", "middle")
    m = curve[20]
    f.dimension(between(p, q, 0.5), m, "$f$", place=(14, 0))
    a = curve[11]
    f.line((a[0], a[1]), (a[0], a[1] + 4 * sag * 0.275 * 0.725), kind="d")
    f.dot(a, 3)
    f.text((a[0] - 7, a[1] + 40), "$f$($x$)", "end")
    f.dimension((p[0], 92), (a[0], 92), "$x$")
    f.dimension((p[0], 52), (q[0], 52), "$l$")
    f.dimension((600, p[1]), (600, q[1]), "$h$", place=(14, 0))
    for x, top in ((p[0], p[1] - 5), (q[0], q[1] - 5)):
        f.line((x, top), (x, 44), kind="d")
    f.line((a[0], a[1] - 5), (a[0], 84), kind="d")
    f.line((q[0] + 6, q[1]), (608, q[1]), kind="d")
    f.line((p[0], p[1]), (608, p[1]), kind="d")
    s0 = h / l - 4 * sag / l
    f.arrow(p, (p[0] - 52, p[1] - 52 * s0), "$T_0$", (-12, 10))
    f.arrow(p, (p[0] - 52, p[1]), "$H$", (-10, -10))


def guy(f):
    foot, head = (60, 45), (330, 260)
    f.ground((20, 45), (390, 45))
    f.line((330, 45), head, kind="b")
    f.line((330, 45), (330, 285), kind="b")
    length = hypot(270, 215)
    shape, (H, V0), (_, V1), _ = rope_shape(foot, head, length * 1.008)
    f.line(foot, head, kind="c")
    f.line(*shape, kind="r")
    f.dot(foot)
    f.dot(head)
    f.arc(foot, 58, 0, atan2(215, 270), "d", "e")
    f.text(at(foot, 0.33, 74), "$θ$", "middle")
    f.text((176, 174), "$L$", "middle")
    f.text((246, 148), "$w$", "middle")
    a = atan2(V1, H)
    f.arrow(head, at(head, a + pi, 75), "$T$", (14, -10))
    f.arrow(head, (400, 260), "displacement $u$", (8, 0), kind="l", anchor="start")
    # plan
    c = (520, 125)
    f.text((520, 232), "plan: a ring of guys", "middle")
    for k in (0.5, 0.5 + 2 * pi / 3, 0.5 + 4 * pi / 3):
        f.line(c, at(c, k, 82), kind="r")
        f.dot(at(c, k, 82))
    f.circle(c, 6, fill="#ddd")
    f.arrow((526, 125), (618, 125), kind="l")
    f.text((612, 109), "$x$")
    f.arc(c, 48, 0, 0.5, "d", "e")
    f.text(at(c, 0.25, 61), "$φ$", "middle")


def length(f):
    rows = (("unstretched", "$L$", 300, 250, "reference temperature, $T$ = 0: mass per metre, $EA$"),
            ("installed", "$L$ (1 + $a$ $ΔT$)", 345, 190, "at the temperature, $T$ = 0: what a tape measures"),
            ("stretched", "$L$ (1 + $a$ $ΔT$) (1 + $T$/$EA$)", 405, 130, "at the temperature, under load"))
    for name, law, width, y, words in rows:
        f.text((20, y), name)
        f.line((140, y), (140 + width, y), kind="r")
        for x in (140, 140 + width):
            f.line((x, y - 7), (x, y + 7), kind="l")
        f.text((150, y + 19), law)
        f.text((150, y - 17), words, small=True)
    f.arrow((545, 130), (590, 130), "$T$", (12, 0))
    f.arrow((140, 130), (122, 130))
    f.line((140, 262), (140, 60), kind="c")
    c = (330, 20)
    f.arc(c, 62, 0.25, pi - 0.25, "r")
    f.line(c, at(c, 0.25, 78), kind="d")
    f.line(c, at(c, pi - 0.25, 78), kind="d")
    f.arc(c, 34, 0.25, pi - 0.25, "d", "be")
    f.text((330, 40), "$θ$", "middle")
    f.text((412, 40), "arc $R$$θ$: the tension goes")
    f.text((412, 20), "from $T_1$ to $T_2$")
    f.text((262, 42), "$T_1$", "end")
    f.text((398, 60), "$T_2$", "middle")


def contact(f):
    c, R = (125, 140), 72
    f.sheave(c, R)
    a_in, a_out = pi - 0.25, 0.35
    d_in, d_out = a_in - pi / 2, a_out - pi / 2
    start, end = at(c, a_in, R), at(c, a_out, R)
    f.arc(c, R, a_in, a_out, "r")
    f.line(at(start, d_in, -105), start, kind="r")
    f.line(end, at(end, d_out, 105), kind="r")
    f.arrow(at(start, d_in, -70), at(start, d_in, -112), "$T_{in}$", (22, 4))
    f.arrow(at(end, d_out, 70), at(end, d_out, 112), "$T_{out}$", (-26, 0))
    f.line(c, start, kind="c")
    f.line(c, end, kind="c")
    f.arc(c, 34, a_in, a_out, "d", "e")
    f.text((125, 187), "$θ$", "middle")
    f.arc(c, R + 18, 2.0, 1.1, "l", "e")
    f.text((125, 258), "motion, in to out", "middle")
    # element
    e = (345, 0)
    lo, hi, r = pi / 2 + 0.25, pi / 2 - 0.25, 170
    f.arc(e, r, lo, hi, "r")
    p, q = at(e, lo, r), at(e, hi, r)
    f.line(at(e, lo, r - 55), at(e, lo, r + 12), kind="d")
    f.line(at(e, hi, r - 55), at(e, hi, r + 12), kind="d")
    f.arrow(p, at(p, lo + pi / 2, 42), "$T$", (-4, -15))
    f.arrow(q, at(q, hi - pi / 2, 52), "$T$ + d$T$", (-4, -16))
    f.arrow((345, 128), (345, 164), "d$N$", (20, -24))
    f.arrow((366, 189), (322, 189), "$μ$ d$N$", (26, 17))
    f.arc(e, 105, lo, hi, "d", "be")
    f.text((345, 84), "d$φ$", "middle")
    f.text((345, 258), "element $R$ d$φ$", "middle")
    # grooves
    for x, name in ((487, "V-groove"), (582, "undercut")):
        f.text((x, 258), name, "middle")
    v, rr = (487, 70), 30
    b = atan2(42, 135)
    f.line((445, 205), v, (529, 205))
    f.line(v, (487, 215), kind="c")
    f.circle((487, 70 + rr / sin(b)), rr, "r", "#eef4fc")
    f.arc(v, 60, pi / 2, pi / 2 - b, "d", "e")
    f.text((516, 130), "$b$", "middle")
    u, bb, gg = (582, 165), radians(80), radians(40)
    for s in (-1, 1):
        side = [at(u, -pi / 2 + s * (bb / 2 + (pi / 2 - gg / 2 - bb / 2) * i / 12), 37) for i in range(13)]
        out = at(side[-1], -gg / 2 + pi / 2 if s > 0 else gg / 2 + pi / 2, 50)
        f.line((side[0][0], 105), *side, out)
    f.line((at(u, -pi / 2 - bb / 2, 37)[0], 105), (at(u, -pi / 2 + bb / 2, 37)[0], 105))
    f.circle(u, 35.5, "r", "#eef4fc")
    f.line(at(u, -pi / 2 - bb / 2, 35), u, at(u, -pi / 2 + bb / 2, 35), kind="d")
    f.arc(u, 22, -pi / 2 - bb / 2, -pi / 2 + bb / 2, "d", "be")
    f.text((582, 115), "$b$", "middle", rim=False)
    f.line(u, at(u, 0, 35), kind="d")
    f.line(u, at(u, -gg / 2, 35), kind="d")
    f.arc(u, 30, 0, -gg / 2, "d")
    f.text((594, 180), "$g$/2", "middle")


def drum(f):
    x0, x1, axis = 95, 455, 60
    f.line((30, axis), (625, axis), kind="c")
    f.text((625, axis - 12), "axis", "end")
    core, d = 95, 26
    f.line((x0, axis + core), (x1, axis + core), kind="b")
    for x, s in ((x0, -1), (x1, 1)):
        f.line((x, axis), (x, 300), (x + 12 * s, 300), (x + 12 * s, axis), kind="l")
    pitch = 28
    n = 1 + int((x1 - x0 - d) / pitch)
    for k, count in ((1, n), (2, n), (3, 5)):
        y = axis + core + (k - 0.5) * d
        for i in range(count):
            x = x0 + d / 2 + pitch * i if k % 2 else x0 + d / 2 + pitch * i + (x1 - x0 - d - pitch * (n - 1))
            f.circle((x, y), d / 2, "l", "#dce8f7")
    xs = x0 + d / 2 + pitch * 4
    y3 = axis + core + 2.5 * d
    f.arrow((xs, y3 + 13), (xs, 305), kind="r")
    f.text((xs + 8, 295), "$T$ = $M$/$R_k$ to the machine")
    f.dimension((500, axis), (500, y3), "$R_k$", place=(18, 0))
    f.line((xs + 18, y3), (508, y3), kind="d")
    f.dimension((60, axis), (60, axis + core), "$D$/2", place=(-22, 0))
    f.line((52, axis + core), (x0, axis + core), kind="d")
    yb = axis + core
    f.dimension((x0, 108), (x1, 108), "width")
    f.line((x0 + d / 2 + pitch * 8, yb - 4), (x0 + d / 2 + pitch * 8, 128), kind="d")
    f.line((x0 + d / 2 + pitch * 9, yb - 4), (x0 + d / 2 + pitch * 9, 128), kind="d")
    f.text((x0 + d / 2 + pitch * 9 + 8, 137), "pitch")
    f.text((540, 244), "layer $k$ = 3")
    f.text((540, 192), "2")
    f.text((540, 166), "1")
    turn = [(565 - 9 * cos(a), axis + 24 * sin(a)) for a in [(-1.3 + 2.9 * i / 20) for i in range(21)]]
    f.line(*turn, kind="f")
    f.head(turn[-2], turn[-1], "f")
    f.text((578, axis + 24), "$M$")


def tangent_figure(f):
    c1, r1, c2, r2 = (130, 150), 85, (470, 190), 50
    f.sheave(c1, r1)
    f.sheave(c2, r2)
    p, q, t = tangent(c1, r1, 1, c2, r2, 1)
    f.line(c1, c2, kind="c")
    f.arc(c1, r1, 2.6, atan2(p[1] - c1[1], p[0] - c1[0]), "r")
    f.line(p, q, kind="r")
    f.arc(c2, r2, atan2(q[1] - c2[1], q[0] - c2[0]), -0.6, "r")
    u, v, t2 = tangent(c1, r1, 1, c2, r2, -1)
    f.line(u, v, kind="q")
    f.line(c1, p, kind="d")
    f.line(c2, q, kind="d")
    f.text((between(c1, p, 0.5)[0] - 8, between(c1, p, 0.5)[1]), "$R_1$", "end")
    f.text((between(c2, q, 0.5)[0] + 8, between(c2, q, 0.5)[1]), "$R_2$")
    f.dot(p)
    f.dot(q)
    m = between(p, q, 0.5)
    f.arrow(between(p, q, 0.62), at(between(p, q, 0.62), atan2(t[1], t[0]), 55), "$t$", (-4, 14))
    f.text((m[0] - 40, m[1] + 17), "free length $l$", "middle")
    f.text((335, 162), "$d$", "middle")
    f.text((292, 108), "crossed: $s_2$ = −1", "start")
    f.text((130, 40), "$s_1$ = +1", "middle")
    f.text((480, 116), "$s_2$ = +1", "middle")
    f.arc(c1, r1 + 16, 2.4, 1.75, "l", "e")
    f.text((588, 60), "axis $n$ into the drawing", "end")
    f.circle((604, 60), 8)
    f.line((598.5, 54.5), (609.5, 65.5))
    f.line((598.5, 65.5), (609.5, 54.5))


def loaded_span(f):
    p, q = (110, 205), (570, 265)
    L = 520
    loads = ((150, 120.0), (370, 200.0))
    shape, (H, V0), (_, V1), marks = rope_shape(p, q, L, 0.35, math.inf, loads)
    f.dot(p)
    f.dot(q)
    f.line(p, q, kind="c")
    f.line(*shape, kind="r")
    k = 0.24
    for i, m in enumerate(marks):
        f.dot(m)
        f.arrow(m, (m[0], m[1] - (45 if i == 0 else 62)), f"$P_{i + 1}$", (18, 6))
    f.arrow(p, (p[0] - k * H, p[1] - k * V0), "$F$", (12, 10))
    f.text((between(p, marks[0], 0.5)[0] - 14, between(p, marks[0], 0.5)[1] - 22), "$L_1$", "end")
    f.text((between(*marks, 0.5)[0], between(*marks, 0.5)[1] - 24), "$L_2$", "middle")
    f.text((between(marks[1], q, 0.5)[0] + 14, between(marks[1], q, 0.5)[1] - 14), "$L_3$")
    f.text((330, 252), "chord $c$", "middle")


def beside(p, direction, r, side):
    """Centre of a round that the rope touches at p; side +1: the rope turns clockwise."""
    return at(p, direction - side * pi / 2, r)


def equilibrium(f):
    p, q = (165, 255), (505, 240)
    shape, (H, V0), (_, V1), marks = rope_shape(p, q, 378, 0.25, math.inf, ((175, 110.0),))
    a0, a1 = atan2(V0, H), atan2(V1, H)
    c1 = beside(p, a0, 22, 1)
    drum, r = (70, 70), 26
    u, v, _ = tangent(drum, r, 1, c1, 22, 1)
    f.ground((20, 40), (620, 40))
    f.line((c1[0], 40), (c1[0], c1[1]), kind="b")
    f.line((535, 40), (515, q[1] - 12), kind="b")
    f.sheave(drum, r)
    f.sheave(c1, 22)
    f.line(u, v, kind="r")
    f.arc(c1, 22, atan2(v[1] - c1[1], v[0] - c1[0]), atan2(p[1] - c1[1], p[0] - c1[0]), "r")
    f.line(*shape, kind="r")
    sc = beside(q, a1, 16, 1)
    end = (605, 40)
    w = atan2(end[1] - q[1], end[0] - q[0])
    out = at(sc, w + pi / 2, 16)
    f.arc(sc, 16, a1 + pi / 2, w + pi / 2, "r")
    f.line(out, end, kind="r")
    f.circle(sc, 15, fill="#e4e4e4")
    f.dot(end)
    m = marks[0]
    f.circle((m[0], m[1] + 9), 8, fill="#f2f2f2")
    f.load((m[0], m[1] + 9), 34, None, 34)
    f.arrow((m[0], m[1] - 50), (m[0], m[1] - 92), "$m g$", (22, 4))
    f.arrow((m[0] + 2, m[1] + 38), (m[0] + 42, m[1] + 38), "$q$", (10, 0), kind="l")
    f.text((78, 185), "branch", "end")
    f.text((68, 168), "$L_1$", "end")
    f.text((232, 188), "branch $L_2$", "middle")
    f.text((450, 172), "branch $L_3$", "middle")
    f.text((104, 62), "drum")
    f.text((135, 300), "contact: sheave", "middle")
    f.text((500, 283), "contact: saddle", "middle")
    f.text((590, 175), "$L_4$")
    f.text((592, 58), "anchor", "end")
    s = shape[6]
    f.arrow(s, at(s, atan2(s[1] - shape[4][1], s[0] - shape[4][0]), 34), "$T_{out}$", (10, 13))
    t = between(v, u, 0.12)
    f.arrow(t, at(t, atan2(u[1] - v[1], u[0] - v[0]), 36), "$T_{in}$", (20, -2))


def carriages(f):
    # a carriage with two rollers
    p, q = (20, 245), (365, 225)
    b = 90
    shape, (H, V0), (_, V1), marks = rope_shape(p, q, 357, 0.12, math.inf, ((128, 60.0), (222, 60.0)))
    f.line(*shape, kind="r")
    a, c = marks
    tilt = atan2(c[1] - a[1], c[0] - a[0])
    up = tilt + pi / 2
    for m in marks:
        f.circle(at(m, up, 8), 7, fill="#f2f2f2")
    mid = between(a, c, 0.5)
    o = at(mid, up, -44)
    f.line(at(a, up, 8), at(at(a, tilt, 14), up, -44), at(at(c, tilt, -14), up, -44), at(c, up, 8))
    f.dot(o)
    f.arrow(o, (o[0], o[1] - 58), "$F$", (14, 6))
    f.text((o[0] + 8, o[1] + 10), "origin")
    f.dimension(at(a, up, 32), at(c, up, 32), "$b$")
    for m in marks:
        f.line(at(m, up, 17), at(m, up, 37), kind="d")
    h = at(c, tilt, 26)
    f.dimension(at(h, up, -44), at(h, up, 8), "height", place=(30, 0))
    f.line(at(at(c, tilt, -10), up, -44), at(at(c, tilt, 31), up, -44), kind="d")
    f.line(at(at(c, tilt, 10), up, 8), at(at(c, tilt, 31), up, 8), kind="d")
    s = shape[6]
    f.arrow(s, at(s, atan2(V0, H) + pi, 42), "$T_{in}$", (-2, -16))
    s = shape[-6]
    f.arrow(s, at(s, atan2(V1, H), 42), "$T_{out}$", (4, -18))
    f.text((190, 30), "two rollers on the track rope", "middle")
    # a dragged bunch
    alpha, delta = radians(10), radians(30)
    g0 = (395, 82)
    g1 = at(g0, alpha, 238)
    f.ground(g0, g1)
    rear = at(g0, alpha, 60)
    front = at(rear, alpha + delta, 158)
    f.line(rear, front, kind="b")
    centre = between(rear, front, 0.5)
    f.dot(centre, 4)
    f.arrow(centre, (centre[0], centre[1] - 40), "$m g$", (22, 10))
    f.arrow(rear, at(rear, alpha + pi / 2, 52), "$N$", (-8, 10))
    f.arrow(rear, at(rear, alpha + pi, 42), "$μ N$", (2, 15))
    f.dot(front)
    f.line(front, (front[0], front[1] + 34), kind="l")
    f.circle((front[0], front[1] + 44), 11, fill="#f2f2f2")
    f.text((front[0] - 18, front[1] + 46), "carriage", "end")
    f.arc(rear, 118, alpha, alpha + delta, "d", "e")
    f.text(at(rear, alpha + delta / 2, 131), "$δ$", "middle")
    f.line(g0, (600, 82), kind="c")
    f.arc(g0, 185, 0, alpha, "d", "e")
    f.text((592, 96), "$α$", "middle")
    above = at(g0, alpha + pi / 2, 8)
    f.arrow(at(above, alpha, 196), at(above, alpha, 232), "$t$", (-2, 14), kind="l")
    f.text((515, 30), "dragged bunch", "middle")
    f.text((centre[0] - 54, centre[1] + 2), "$s$", "middle")
    f.dimension(rear, centre, "", 22)


def load_path(f):
    p, q, L = (45, 262), (590, 300), 585
    ground = [(20, 105), (150, 120), (280, 70), (400, 62), (520, 130), (620, 145)]
    for a, b in zip(ground, ground[1:]):
        f.ground(a, b)
    path = []
    for i in range(1, 24):
        s = L * (1 - cos(pi * i / 24)) / 2
        shape, _, _, marks = rope_shape(p, q, L, 0.06, math.inf, ((s, 100.0),), 24)
        path.append(marks[0])
        if i in (8, 14):
            f.line(*shape, kind="r" if i == 14 else "q")
            here = marks[0]
            if i == 14:
                f.circle((here[0], here[1] + 8), 7, fill="#f2f2f2")
                f.load((here[0], here[1] + 8), 26, None, 24)
                x = here
    f.line(*path, kind="h")
    f.dot(p)
    f.dot(q)
    f.line((p[0], p[1]), (p[0], 108), kind="b")
    f.line((q[0], q[1]), (q[0], 141), kind="b")
    y = 62 + (130 - 62) * max(0, (x[0] + 34 - 400) / 120)
    f.dimension((x[0] + 34, y), (x[0] + 34, x[1]), "clearance", place=(42, 12))
    f.line((x[0] + 6, x[1]), (x[0] + 42, x[1]), kind="d")
    f.dimension((p[0], 30), (x[0], 30), "$x$, prescribed")
    f.line((p[0], 100), (p[0], 22), kind="d")
    f.line((x[0], 52), (x[0], 22), kind="d")
    f.text((150, 168), "load path $z$($x$)", "middle")


def payload(f):
    # a level span of 200 m with a mass at midspan: margins by the exact law
    o = (75, 75)
    W, Hh = 500, 215
    L, w, EA = 202.0, 20.0, 25e6
    masses = [100.0 * i for i in range(0, 31)]
    tension, clearance = [], []
    for m in masses:
        _, (H, V0), _, marks = rope_shape((0, 0), (200, 0), L, w, EA, ((L / 2, 9.81 * m + 1e-6),), 2)
        tension.append(1 - hypot(H, V0) / 80e3)
        clearance.append((26 + marks[0][1] - 5) / 26)
    top = 1.0

    def place(i, value):
        return (o[0] + W * masses[i] / masses[-1], o[1] + 40 + (Hh - 60) * value / top)

    f.arrow((o[0], 45), (o[0], 300), kind="l")
    f.text((o[0] + 8, 296), "margin")
    f.arrow((o[0], place(0, 0)[1]), (o[0] + W + 40, place(0, 0)[1]), kind="l")
    f.text((o[0] + W + 40, place(0, 0)[1] - 17), "mass $m$", "end")
    f.text((o[0] - 10, place(0, 0)[1]), "0", "end")
    f.line(*[place(i, t) for i, t in enumerate(tension) if t > -0.3], kind="r")
    f.line(*[place(i, t) for i, t in enumerate(clearance) if t > -0.3], kind="h")
    k = next(i for i, t in enumerate(tension) if min(t, clearance[i]) < 0)
    g = tension if tension[k] < clearance[k] else clearance
    share = g[k - 1] / (g[k - 1] - g[k])
    root = between(place(k - 1, 0), place(k, 0), share)
    f.dot(root, 5, "#c01c28")
    f.arrow((root[0], root[1] + 62), (root[0], root[1] + 8))
    f.text((root[0] + 26, root[1] + 92), "payload: the", "middle")
    f.text((root[0] + 26, root[1] + 74), "least margin is 0", "middle")
    a = place(8, tension[8])
    f.text((a[0] + 6, a[1] + 16), "1 − $T_{max}$/$T_{limit}$")
    a = place(13, clearance[13])
    f.text((a[0], a[1] - 18), "clearance", "middle")
    f.text((o[0] + W - 20, 68), "a limit is exceeded", "end")


def installation(f):
    p, q = (40, 200), (300, 215)
    shape, (H, V0), (_, V1), _ = rope_shape(p, q, 275)
    f.ground((20, 60), (320, 60))
    for e in (p, q):
        f.line((e[0], 60), e, kind="b")
        f.dot(e)
    f.line(p, q, kind="c")
    f.line(*shape, kind="r")
    m = min(shape, key=lambda s: abs(s[0] - 170))
    f.dimension(between(p, q, 0.5), m, "$f$", place=(14, 0))
    f.arrow(q, at(q, atan2(V1, H), 46), "$T$", (12, 4))
    f.text((170, 90), "empty line: no carriage", "middle")
    # the chart: a rope of 100 m span, sag 2.5 m at 10 degrees
    o, W, Hh = (395, 60), 205, 175
    f.axes(o, W + 25, Hh + 45, "temperature", "tension, sag")
    a, w, EA, span = 1.2e-5, 20.0, 20e6, 100.0
    low, high = 100.01, 101.0
    sags = {}

    def state(L0, dT):
        L, wt = L0 * (1 + a * dT), w / (1 + a * dT)
        shape, (H, V), _, _ = rope_shape((0, 0), (span, 0), L, wt, EA, (), 20)
        return hypot(H, V), -min(z for _, z in shape)

    for _ in range(30):
        mid = (low + high) / 2
        if state(mid, 0)[1] < 1.5:
            low = mid
        else:
            high = mid
    rows = [(t, *state(low, t - 10)) for t in range(-30, 51, 10)]
    T0, f0 = rows[4][1], rows[4][2]
    T0, f0 = [(T, s) for t, T, s in rows if t == 10][0]
    for kind, k, scale in (("f", 1, T0), ("r", 2, f0)):
        f.line(*[(o[0] + W * (r[0] + 30) / 80, o[1] + 85 * r[k] / scale) for r in rows], kind=kind)
    x = o[0] + W * 40 / 80
    f.line((x, o[1]), (x, o[1] + 85), kind="d")
    f.dot((x, o[1] + 85))
    for t in (-30, 10, 50):
        f.text((o[0] + W * (t + 30) / 80, o[1] - 17), f"{t} °C".replace("-", "−"), "middle", small=True)
    f.parts = [s for s in f.parts if ">temperature<" not in s]
    f.text((o[0] + W / 2, 22), "temperature", "middle")
    f.text((o[0] + 12, o[1] + 85 * rows[0][1] / T0 + 10), "$T$")
    f.text((o[0] + W - 2, o[1] + 85 * rows[-1][2] / f0 + 16), "$f$", "end")


def modes(f):
    drum, tail, L = (80, 80), (560, 235), 440
    head = (140, 255)
    f.ground((20, 50), (610, 50))
    f.line((140, 50), (140, 240), kind="b")
    f.line((560, 50), (560, 235), kind="b")
    shape, (H, V0), _, marks = rope_shape((148, 267), tail, 450, 0.12, math.inf, ((240, 90.0),))
    f.sheave(head, 14)
    f.sheave(drum, 24)
    u, v, _ = tangent(drum, 24, 1, head, 14, 1)
    f.line(u, v, kind="r")
    f.arc(head, 14, atan2(v[1] - head[1], v[0] - head[0]), pi / 2 - 0.55, "r")
    f.line(*shape, kind="r")
    f.line((148, 267), tail, kind="c")
    f.dot(tail)
    m = marks[0]
    f.circle((m[0], m[1] + 8), 7, fill="#f2f2f2")
    f.load((m[0], m[1] + 8), 30, None, 26)
    y = 267 + (235 - 267) * (m[0] - 148) / (560 - 148)
    f.dimension((m[0], y), (m[0], m[1] + 18), "`sag`".replace("`", ""), place=(24, 0))
    f.arrow(u, at(u, atan2(v[1] - u[1], v[0] - u[0]), 52), None)
    f.text((12, 190), "winch_pull")
    f.text((255, 168), "loop_length", "end")
    f.arrow((m[0] - 48, m[1] - 52), (m[0] - 88, m[1] - 52), None, kind="l")
    f.arrow((m[0] + 48, m[1] - 52), (m[0] + 88, m[1] - 52), None, kind="l")
    f.text((m[0], m[1] - 72), "free_running: no force along the track", "middle")


def cycle(f):
    drum = (60, 90)
    f.sheave(drum, 26)
    head, tail = (120, 235), (330, 150)
    f.sheave(head, 12)
    u, v, _ = tangent(drum, 26, 1, head, 12, 1)
    f.line(u, v, kind="r")
    g = [(20, 58), (150, 62), (250, 40), (360, 78)]
    for a, b in zip(g, g[1:]):
        f.ground(a, b)
    f.line((120, 60), (120, 225), kind="b")
    shape, (H, V0), _, _ = rope_shape((128, 246), (290, 150), 192, 0.4)
    f.arc(head, 12, atan2(v[1] - head[1], v[0] - head[0]), pi / 2 - 0.75, "r")
    f.line(*shape, kind="r")
    f.circle((290, 150), 8, fill="#f2f2f2")
    f.load((290, 150), 28, None, 22)
    w = between(u, v, 0.5)
    f.arrow(w, at(w, atan2(u[1] - v[1], u[0] - v[0]), 44), "$T$", (-16, 6))
    f.arc(drum, 36, -0.6, 0.6, "l", "e")
    f.text((240, 235), "rope out: $L$", "middle")
    # work: the area under T (1 + T/EA) over L
    o = (410, 65)
    f.axes(o, 205, 205, "$L$", "$T$ (1 + $T$/$EA$)")

    def hauled(load):
        """Rope out and pull of a winch that draws a load up the load path of a skyline: T dL = -dU."""
        found = []
        for k in range(15):
            part = 60 + 10.0 * k
            shape, _, _, marks = rope_shape((0, 0), (300, -60), 316, 0.02, math.inf, ((part, load),), 24)
            U = load * marks[0][1] + sum(0.02 * hypot(b[0] - a[0], b[1] - a[1]) * (a[1] + b[1]) / 2
                                         for a, b in zip(shape, shape[1:]))
            found.append((hypot(*marks[0]), U))
        return [((a[0] + b[0]) / 2, (a[1] - b[1]) / (b[0] - a[0])) for a, b in zip(found, found[1:])]

    rows = [hauled(12.0), hauled(4.0)]
    top = max(T for _, T in rows[0])
    pts, empty = ([(o[0] + 10 + 175 * (L - 55) / 155, o[1] + 150 * T / top) for L, T in row] for row in rows)
    f.line((pts[0][0], o[1]), *pts, (pts[-1][0], o[1]), kind="d", close=True, fill="#f7e3e4")
    f.line(*pts, kind="f")
    f.line(*empty, kind="r")
    f.head(pts[7], pts[6], "f")
    f.head(empty[6], empty[7], "r")
    f.text((545, o[1] + 130), "loaded, taken in", "middle")
    f.text((500, o[1] + 14), "empty, let out", "middle", rim=False)
    f.text((474, o[1] + 74), "work: area", "middle", small=True, rim=False)


def continuation(f):
    o = (70, 60)
    f.axes(o, 520, 230, "parameter $λ$", "state $x$")
    lc, xc = 470.0, 150.0

    def x_of(l):
        return xc - 5.2 * sqrt(max(0.0, lc - l))

    def place(l):
        return (o[0] + l, o[1] + x_of(l))

    stable = [place(lc * (1 - (1 - i / 60) ** 2)) for i in range(5, 61)]
    beyond = [(p[0], 2 * (o[1] + xc) - p[1]) for p in reversed(stable) if p[0] > 330]
    f.line(*stable, kind="r")
    f.line(*beyond, kind="q")
    for l in (120, 200, 280, 360, 440):
        f.dot(place(l))
        f.line(place(l), (o[0] + l, o[1]), kind="d")
    f.line((o[0] + lc, o[1]), (o[0] + lc, o[1] + 215), kind="c")
    f.text((o[0] + lc + 6, o[1] + 205), "$λ_c$")
    f.dimension((o[0] + 200, o[1] + 16), (o[0] + 280, o[1] + 16), "step")
    f.dot(place(lc), 4.5, "#c01c28")
    f.text((o[0] + lc + 8, o[1] + xc - 2), "turning point")
    f.text((o[0] + 150, o[1] + 96), "stable, followed", "middle")
    f.text((o[0] + 330, o[1] + 180), "unstable", "middle")


def drives(f):
    # a driven sheave
    c, R = (130, 150), 70
    f.sheave(c, R)
    f.arc(c, R, pi, 0, "r")
    f.line((60, 150), (60, 30), kind="r")
    f.line((200, 150), (200, 30), kind="r")
    f.arrow((60, 100), (60, 38), "$T_{in}$", (22, 6))
    f.arrow((200, 100), (200, 38), "$T_{out}$", (-24, 6))
    f.arc(c, 40, 2.4, 0.6, "f", "e")
    f.text((130, 168), "$M$", "middle")
    f.line(c, at(c, -0.6, R), kind="d")
    f.text((150, 118), "$R$", "end")
    f.arc(c, R + 16, 2.1, 1.1, "l", "e")
    f.text((130, 252), "$v$", "middle")
    # running element
    e, r = (368, -60), 255
    lo, hi = pi / 2 + 0.22, pi / 2 - 0.22
    f.arc(e, r, lo, hi, "r")
    p, q = at(e, lo, r), at(e, hi, r)
    f.arrow(p, at(p, lo + pi / 2, 46), "$T$", (-6, 14))
    f.arrow(q, at(q, hi - pi / 2, 46), "$T$", (6, 14))
    f.line(p, at(e, lo, r - 62), kind="d")
    f.line(q, at(e, hi, r - 62), kind="d")
    f.arrow((368, 195), (368, 150), "$m v^2$ d$φ$", (0, -14))
    f.arrow((338, 206), (398, 206), "$v$", (2, 14), kind="l")
    f.text((368, 112), "the thrust takes $c$ = $m v^2$ of $T$", "middle", small=True)
    f.text((368, 252), "element of a running rope", "middle")
    # speed along the loop
    o = (515, 60)
    f.axes(o, 105, 165, "$T$", "rope speed")
    f.line((515, 118), (605, 185), kind="r")
    f.text((572, 92), "$u$ (1 + $T$/$EA$)", "middle")


def belt_drive(f):
    c1, r1, c2, r2 = (140, 160), 75, (520, 160), 75
    f.sheave(c1, r1)
    f.sheave(c2, r2)
    f.line((140, 235), (520, 235), kind="r")
    f.line((140, 85), (520, 85), kind="r")
    f.arc(c2, r2, pi / 2, -pi / 2, "r")
    slip = radians(75)
    f.arc(c1, r1, pi / 2, 3 * pi / 2 - slip, "r")
    f.arc(c1, r1, 3 * pi / 2 - slip, 3 * pi / 2, "f")
    f.line(c1, at(c1, 3 * pi / 2 - slip, r1 + 26), kind="d")
    f.line(c1, (140, 62), kind="d")
    f.line(c1, (140, 262), kind="d")
    f.arc(c1, r1 + 18, 3 * pi / 2 - slip, 3 * pi / 2, "d", "be")
    f.text((66, 72), "$φ_{slip}$", "middle")
    f.arc(c1, r1 + 18, pi / 2, 3 * pi / 2 - slip, "d", "be")
    f.text((42, 205), "rest", "end")
    f.arc(c1, 38, -0.5, 0.9, "l", "e")
    f.text((188, 172), "drive")
    f.arrow((240, 235), (300, 235), "$T_1$", (2, -16))
    f.arrow((240, 85), (300, 85), "$T_2$", (2, 15))
    f.arrow((420, 235), (480, 235), "$P$", (-6, 17))
    f.text((330, 256), "tight", "middle")
    f.text((330, 62), "slack", "middle")
    f.arrow((520, 160), (612, 160), "$W$", (10, 12))
    f.text((520, 56), "idler: loss $r$", "middle")


def equilibrium_search(f):
    # tension at the end over length, of a level rope of the span 1 and the weight 1 per metre, elastic
    o, W, Hh = (70, 60), 330, 210
    f.axes(o, W + 40, Hh + 30, "rope length $L$", "$T$ at its end")
    points = []
    for i in range(70):
        L = 0.915 + 1.6 * (i / 69) ** 2.2
        _, (H, V), _, _ = rope_shape((0, 0), (1, 0), L, 1.0, 12.0, (), 2)
        points.append((L, hypot(H, V)))
    def place(L, T):
        return (o[0] + (L - 0.9) * W / 1.6, o[1] + (T - 0.5) * 170)
    f.line(*[place(*p) for p in points if place(*p)[1] < o[1] + Hh], kind="r")
    T = 1.0
    f.line(place(0.9, T), place(2.5, T), kind="h")
    f.text((place(2.5, T)[0] + 34, place(2.5, T)[1] - 14), "given $T$", "end")
    roots = []
    for a, b in zip(points, points[1:]):
        if (a[1] - T) * (b[1] - T) < 0:
            roots.append(a[0] + (b[0] - a[0]) * (a[1] - T) / (a[1] - b[1]))
    names = ("taut", "deep loop")
    for L, name in zip(roots, names):
        f.dot(place(L, T), 4.5, "#c01c28")
        off = (12, 26) if name == "taut" else (2, -24)
        f.text((place(L, T)[0] + off[0], place(L, T)[1] + off[1]), name, "start" if name == "taut" else "middle")
    # the two shapes
    p, q = (455, 260), (605, 260)
    for L, kind in zip(roots, "rq"):
        shape, _, _, _ = rope_shape((0, 0), (1, 0), L, 1.0, 12.0)
        f.line(*[(p[0] + 150 * x, p[1] + 150 * z) for x, z in shape], kind=kind)
    f.dot(p)
    f.dot(q)
    f.text((530, 200), "taut", "middle")
    f.text((530, 116), "deep loop", "middle")


def column_shape(foot, h, H, kh, n=24, scale=1.0):
    """Deflected axis of a cantilever column under H and N: w = (H/N k)(tan kh (1 - cos kx) + sin kx - kx)."""
    k = kh / h
    return [(foot[0] + scale * H / k * (tan(kh) * (1 - cos(k * x)) + sin(k * x) - k * x), foot[1] + x)
            for x in (h * i / n for i in range(n + 1))]


def beam(f):
    foot, h = (110, 50), 240
    axis = column_shape(foot, h, 0.13, 1.05)
    f.line(foot, (foot[0], foot[1] + h), kind="c")
    f.line(*axis, kind="b")
    f.ground((75, 50), (145, 50))
    top = axis[-1]
    f.arrow(top, (top[0] + 62, top[1] - 8), "rope force", (6, 0), anchor="start")
    f.arrow((top[0], top[1] + 46), (top[0], top[1] + 4), "$N$", (-14, 40))
    m = axis[14]
    g = atan2(axis[15][1] - axis[13][1], axis[15][0] - axis[13][0])
    f.dot(m)
    f.arrow(m, at(m, g, 58), "$d_3$", (16, -6), kind="l")
    f.arrow(m, at(m, g - pi / 2, 44), "$d_1$", (10, -10), kind="l")
    f.dimension((foot[0], foot[1] + h + 8), (top[0], foot[1] + h + 8), "$v$", place=(-24, 0))
    f.arrow((82, 175), (82, 205), None, kind="d")
    f.line((82, 60), (82, 200), kind="d")
    f.text((66, 130), "$s$", "middle")
    # a piece
    a, b = (400, 60), (440, 150)
    f.line(a, b, kind="b")
    f.arrow(b, (492, 190), "$F$", (8, 10))
    f.arc(b, 24, 0.2, 2.6, "f", "e")
    f.text((420, 186), "$M$", "middle")
    f.arrow(a, (348, 20), "$−F$", (-14, 2))
    f.arc(a, 24, -2.6, -0.3, "f", "b")
    f.text((448, 36), "$−M$", "middle")
    f.arrow((420, 105), (420, 66), "$w$ d$s$", (30, 8))
    f.text((372, 120), "d$r$ = $r'$ d$s$", "end")
    f.text((425, 230), "piece between two sections", "middle")
    # bow
    o = (585, 60)
    bow = [(o[0] + 22 * sin(pi * i / 20), o[1] + 180 * i / 20) for i in range(21)]
    f.line(o, (585, 240), kind="c")
    f.line(*bow, kind="b")
    f.dimension((585, 150), (607, 150), "", 0)
    f.text((612, 150), "$e$")
    f.text((590, 40), "bow as built", "middle")


def guyed_mast(f):
    foot, h = (230, 50), 250
    f.ground((20, 50), (600, 50))
    axis = column_shape(foot, h, 0.07, 0.9)
    f.line(foot, (foot[0], foot[1] + h), kind="c")
    top, mid = axis[-1], axis[15]
    for anchor, head, extra in (((40, 50), top, 1.0015), ((40, 50), mid, 1.0015), ((430, 50), top, 1.03)):
        L = hypot(head[0] - anchor[0], head[1] - anchor[1]) * extra
        if anchor[0] < head[0]:
            shape = rope_shape(anchor, head, L)[0]
        else:
            shape = rope_shape(head, anchor, L)[0]
        f.line(*shape, kind="r")
        f.dot(anchor)
    f.line(*axis, kind="b")
    f.pin(foot, hatch=False, size=0.1)
    f.arrow(top, (top[0] + 76, top[1] - 10), "$P$", (14, 0))
    f.arrow(axis[19], (axis[19][0] + 58, axis[19][1] - 30), "$P$", (12, -8))
    f.text((70, 205), "taut guy", "middle")
    f.text((395, 150), "slack guy: its own", "start")
    f.text((395, 130), "weight alone", "start")
    f.arrow((500, 210), (560, 210), "$x$", (12, 0), kind="l")
    f.arrow((500, 210), (500, 270), "$z$", (0, 14), kind="l")
    f.text((530, 190), "to the span", "middle")
    f.text((254, 24), "foot: clamped or hinged", "middle")


def mast_checks(f):
    # forces along the mast
    x, y0, h = 60, 45, 240
    f.ground((25, y0), (95, y0))
    f.line((x, y0), (x, y0 + h), kind="b")
    f.arrow((x, y0 + h), (x + 56, y0 + h), "$H$", (12, 0))
    f.arrow((x, y0 + h + 36), (x, y0 + h + 2), None)
    f.text((x - 20, y0 + h + 20), "$N$", "middle")
    o = 150
    k = 1.0 / h
    first = [(o + 48 * (1 - i / 20), y0 + h * i / 20) for i in range(21)]
    second = [(o + 48 * (sin(k * h * (1 - i / 20)) / (k * h * cos(k * h))), y0 + h * i / 20) for i in range(21)]
    f.line((o, y0), (o, y0 + h))
    f.line(*first, kind="h")
    f.line(*second, kind="f")
    f.line((o, y0), second[0], kind="d")
    f.text((o + 30, y0 + h - 32), "$M$")
    f.text((o - 4, 22), "first, second order", "start", small=True)
    # sections
    c = (330, 225)
    f.circle(c, 48, fill="#e4e4e4")
    f.circle(c, 41)
    f.dimension((282, 160), (378, 160), "$D$", place=(0, -13))
    f.text((330, 225), "$t$", "middle")
    f.arrow((330, 236), (330, 263), None, kind="d")
    f.text((330, 292), "tube", "middle")
    for i, (w, hh) in enumerate(((44, 60), (36, 52))):
        f.line((330 - w, 85 - hh / 1.3), (330 + w, 85 - hh / 1.3), (330 + w, 85 + hh / 1.3), (330 - w, 85 + hh / 1.3),
               close=True, fill="#e4e4e4" if i == 0 else "#fff")
    f.dimension((286, 24), (374, 24), "$b$", place=(0, -13))
    f.dimension((388, 39), (388, 131), "$h$", place=(13, 0))
    # interaction
    o = (450, 60)
    f.axes(o, 184, 215, "$M$/$M_{pl}$", "$n$ = $N$/$N_{pl}$")
    curve = [(o[0] + 140 * (1 - (i / 30) ** 1.7), o[1] + 165 * i / 30) for i in range(31)]
    f.line(*curve, kind="l")
    f.text((o[0] + 95, o[1] + 140), "1 − $n^{1.7}$")
    p = (o[0] + 62, o[1] + 52)
    f.dot(p, 4, "#c01c28")
    f.line(o, p, kind="f")
    f.text((p[0] - 4, p[1] + 16), "in use", "middle")
    for v, q in (("1", (o[0] + 130, o[1] - 15)), ("1", (o[0] - 10, o[1] + 165))):
        f.text(q, v, "middle")


def rope_checks(f):
    drum, head = (100, 95), (340, 230)
    f.sheave(head, 34)
    f.circle((drum[0], drum[1]), 44, fill="#f2f2f2")
    f.circle(drum, 5, fill="#222")
    u, v, _ = tangent(drum, 47, 1, head, 34, 1)
    f.line(u, v, kind="r")
    f.arc(drum, 47, 3.3, atan2(u[1] - drum[1], u[0] - drum[0]), "r")
    f.arc(head, 34, atan2(v[1] - head[1], v[0] - head[0]), 0, "r")
    f.line((374, 230), (374, 140), kind="r")
    f.circle((374, 128), 12, fill="#e4e4e4")
    f.load((374, 120), 34, None, 12)
    f.text((395, 138), "termination:")
    f.text((395, 116), "$Z_T$ = $η_T$ $F_{min}$ / $T_{end}$")
    f.text((385, 252), "$D$/$d$, groove pressure,")
    f.text((385, 230), "strength on the sheave: $Z_D$")
    m = between(u, v, 0.5)
    f.text((m[0] - 26, m[1] + 44), "largest tension: $Z$ = $F_{min}$ / $T$", "middle")
    f.text((100, 30), "drum: layers, pull", "middle")
    # fleet angle, in plan
    o = (225, 52)
    f.line((o[0], 20), (o[0], 84), kind="b")
    f.line((o[0] + 150, 42), (o[0] + 150, 62), kind="b")
    f.line((o[0], 52), (o[0] + 150, 52), kind="c")
    f.line((o[0], 84), (o[0] + 150, 52), kind="r")
    f.arc((o[0] + 150, 52), 80, pi, pi - atan2(32, 150), "d")
    f.text((o[0] + 162, 50), "fleet angle, in plan")


def rope_life(f):
    o, W, Hh = (90, 60), 430, 220
    f.axes(o, W + 85, Hh + 25, "$S$/$d^2$, N/mm²", "bending cycles $N$")
    a0, a1, a2, a3 = 1.278, 0.029, 6.241, -1.613

    def cycles(ratio, pull):
        return a0 + (a1 + a3 * math.log10(ratio)) * math.log10(pull) + a2 * math.log10(ratio)

    def place(pull, lg):
        return (o[0] + W * (math.log10(pull) - 1.5) / 1.2, o[1] + Hh * (lg - 3.5) / 4.0)

    for lg in (4, 5, 6, 7):
        y = place(40, lg)[1]
        f.line((o[0], y), (o[0] + W, y), kind="d")
        f.text((o[0] - 8, y), f"$10^{lg}$", "end")
    for pull in (50, 100, 200, 400):
        x = place(pull, 4)[0]
        f.line((x, o[1]), (x, o[1] + 6), kind="l")
        f.text((x, o[1] - 16), str(pull), "middle", small=True)
    for ratio, kind in ((16, "r"), (25, "r"), (40, "r")):
        pts = [place(p, cycles(ratio, p)) for p in (40, 70, 120, 200, 320, 480)]
        pts = [p for p in pts if o[1] < p[1] < o[1] + Hh]
        f.line(*pts, kind=kind)
        f.text((pts[-1][0] + 6, pts[-1][1] + 8), f"$D$/$d$ = {ratio}")
    p = place(117, cycles(25, 117))
    f.dot(p, 4.5, "#c01c28")
    f.line(p, (p[0], o[1]), kind="h")
    f.line(p, (o[0], p[1]), kind="h")
    q = (o[0] + 262, o[1] + 196)
    f.line(p, q, kind="d")
    f.text((q[0] + 6, q[1] + 4), "worked number")


def rope_choice(f):
    # two lists: the sums in the order of a heap
    a, b = (2.0, 2.6, 3.1, 4.2), (1.0, 1.9, 2.3, 3.4)
    o, w = (95, 55), 58
    order = sorted(((x + y, i, j) for i, x in enumerate(a) for j, y in enumerate(b)))
    passes = {(i, j) for i in range(4) for j in range(4) if i >= 2 and j >= 1}
    best = next(k for k, (_, i, j) in enumerate(order) if (i, j) in passes)
    for k, (c, i, j) in enumerate(order):
        x, y = o[0] + w * i, o[1] + w * j
        fill = "#dff0df" if (i, j) in passes else "#fff"
        f.line((x, y), (x + w, y), (x + w, y + w), (x, y + w), close=True, fill=fill)
        f.text((x + w / 2, y + w / 2 + 10), f"{c:.1f}", "middle", rim=False)
        if k <= best:
            f.text((x + w / 2, y + w / 2 - 12), f"trial {k + 1}", "middle", small=True, rim=False)
    _, i, j = order[best]
    x, y = o[0] + w * i, o[1] + w * j
    f.line((x + 3, y + 3), (x + w - 3, y + 3), (x + w - 3, y + w - 3), (x + 3, y + w - 3), kind="f", close=True)
    f.text((o[0] + 2 * w, 30), "rope, by cost", "middle")
    f.text((o[0] - 12, o[1] + 2 * w + 10), "section,", "end")
    f.text((o[0] - 12, o[1] + 2 * w - 10), "by cost", "end")
    f.text((o[0] + 2 * w, o[1] + 4 * w + 16), "cost of the choice; green: passes", "middle")
    # unknown numbers: cost lines and constraints
    c = (400, 55)
    f.axes(c, 215, 245, "$x_1$", "$x_2$")
    curve = [(c[0] + 25 + 6 * i, c[1] + 20 + 4200 / (25 + 6 * i)) for i in range(5, 31)]
    f.line(*curve, kind="b")
    line2 = [(c[0] + 62, c[1] + 15), (c[0] + 92, c[1] + 195)]
    f.line(*line2, kind="b")
    for s in (100, 150, 200):
        f.line((c[0] + max(0, s - 200), c[1] + min(200, s)), (c[0] + min(200, s), c[1] + max(0, s - 200)), kind="h")
    f.text((c[0] + 150, c[1] + 130), "all $g_i$ ≤ 0", "middle")
    f.text((c[0] + 118, c[1] + 208), "$g_1$ = 0", "middle")
    f.text((c[0] + 208, c[1] + 58), "$g_2$ = 0", "end")
    best_point = min(((p[0] - c[0]) + (p[1] - c[1]), p) for p in curve if p[0] > c[0] + 62 + (p[1] - c[1] - 15) / 6)[1]
    f.dot(best_point, 5, "#c01c28")
    f.text((c[0] + 24, c[1] + 24), "$c$ falls", "middle")


def checks_tested(f):
    f.ground((15, 50), (625, 50))
    mast, h = (260, 50), 225
    top = (mast[0], mast[1] + h)
    f.line(mast, top, kind="b")
    f.line(*rope_shape((60, 50), top, hypot(200, h) * 1.003)[0], kind="r")
    f.dot((60, 50))
    end = (590, 190)
    f.line((590, 50), end, kind="b")
    shape, _, _, marks = rope_shape((272, 283), end, 338, 0.12, math.inf, ((190, 60.0),))
    f.line(*shape, kind="r")
    f.sheave(top, 14)
    f.circle((marks[0][0], marks[0][1] + 7), 6, fill="#f2f2f2")
    f.load((marks[0][0], marks[0][1] + 7), 26, None, 20)
    drum = (170, 72)
    f.sheave(drum, 20)
    u, v, _ = tangent(drum, 20, 1, top, 14, 1)
    f.line(u, v, kind="r")
    f.arc(top, 14, atan2(v[1] - top[1], v[0] - top[0]), 0.7, "r")
    f.dot(end)
    f.text((345, 262), "rope: safety_factor, life")
    f.text((285, 305), "sheave: sheave_ratio, groove_pressure")
    f.text((172, 28), "drum_layers", "middle")
    f.text((275, 150), "mast: section, member,")
    f.text((275, 130), "buckling, top_stiffness")
    f.text((118, 185), "guy_safety,", "end")
    f.text((112, 165), "slackness", "end")
    f.text((60, 28), "anchor_strength", "middle")
    y = 50
    f.dimension((marks[0][0] + 30, y), (marks[0][0] + 30, marks[0][1]), "clearance", place=(42, 0))
    f.text((end[0] + 30, end[1] + 22), "break_angle", "end")


def faces(f):
    slope = radians(14)
    a, b = (30, 50), at((30, 50), slope, 330)
    f.ground(a, b)
    p = at(at(a, slope, 190), slope + pi / 2, 3)
    n, t = slope + pi / 2, slope
    body = [at(at(p, t, dx), n, dy) for dx, dy in ((-55, 28), (55, 28), (55, 100), (-55, 100))]
    f.line(*body, close=True, fill="#e4e4e4")
    # normal spring and bristle
    q = at(p, n, 28)
    zig = [at(at(q, n, -i * 2.5), t, (0, 7, -7)[(i % 2) + 1] if 0 < i < 10 else 0) for i in range(11)]
    f.line(*zig)
    f.dot(p)
    f.text(at(at(p, t, -12), n, 16), "$P$", "end")
    f.arrow(at(p, t, 16), at(at(p, t, 16), n, 62), "$N$", (14, 4))
    f.arrow(at(p, t, -4), at(p, t, -70), "$f N$", (2, 18))
    f.text(at(at(p, t, 20), n, 134), "body with the point $P$", "middle")
    f.arrow(at(at(p, t, 60), n, 64), at(at(p, t, 112), n, 64), "$v_t$", (-6, 14), kind="l")
    f.text((a[0] + 4, a[1] + 26), "from", "middle")
    f.text((b[0] + 16, b[1] + 2), "to", "middle")
    f.arrow(at(b, slope + pi, 12), at(at(b, slope + pi, 12), n, 44), "$n$", (14, 0), kind="l")
    # Stribeck
    o = (410, 70)
    f.axes(o, 205, 195, "$|v|$", "$f$")
    f0, fi, vs = 150.0, 85.0, 45.0
    f.line(*[(o[0] + 4.5 * i, o[1] + fi + (f0 - fi) * exp(-4.5 * i / vs)) for i in range(42)], kind="f")
    f.line((o[0], o[1] + fi), (o[0] + 190, o[1] + fi), kind="h")
    f.text((o[0] - 8, o[1] + f0), "$f_0$", "end")
    f.text((o[0] - 8, o[1] + fi), "$f_∞$", "end")
    f.line((o[0] + vs, o[1]), (o[0] + vs, o[1] + fi + (f0 - fi) / math.e), kind="d")
    f.text((o[0] + vs, o[1] - 17), "$v_s$", "middle")


def sagging(f):
    p, q = (70, 250), (560, 225)
    shape, (H, V0), (_, V1), marks = rope_shape(p, q, 545, 0.25, math.inf, ((230, 60.0),))
    a0 = atan2(V0, H)
    f.pin(p, pi)
    f.pin(q, 0)
    f.line(*shape, kind="r")
    m = marks[0]
    f.line(p, m, kind="c")
    f.line(m, q, kind="c")
    f.circle((m[0], m[1] + 9), 8, fill="#f2f2f2")
    f.load((m[0], m[1] + 9), 32, None, 30)
    k = next(i for i, s in enumerate(shape) if s == m)
    left = atan2(m[1] - shape[k - 1][1], m[0] - shape[k - 1][0]) + pi
    right = atan2(shape[k + 1][1] - m[1], shape[k + 1][0] - m[0])
    f.arrow(m, at(m, left, 62), "$T_1$", (-8, -15))
    f.arrow(m, at(m, right, 62), "$T_0$", (2, -16))
    f.arrow((m[0] + 24, m[1] - 46), (m[0] + 74, m[1] - 46), "$v$", (12, 0), kind="l")
    f.text((170, 243), "chord $c$", "middle")
    s = shape[(k + len(shape)) // 2]
    f.text((s[0] + 60, s[1] - 36), "$L$: catenary at rest", "middle")
    c = between(m, q, 0.55)
    f.dimension(c, (c[0], [s for s in shape if s[0] > c[0]][0][1]), "", 0)
    f.text((c[0] + 8, c[1] + 16), "sag", "middle")


def rope_load(f):
    p, q = (60, 290), (580, 270)
    # the rope keeps its direction at the force: choose the place so that both parts agree
    lo, hi = 115.0, 355.0
    for _ in range(40):
        y = (lo + hi) / 2
        a = rope_shape(p, (340, y), 300, 0.5, math.inf, (), 40)[2]
        b = rope_shape((340, y), q, 262, 0.5, math.inf, (), 40)[1]
        if atan2(a[1], a[0]) < atan2(b[1], b[0]):
            lo = y
        else:
            hi = y
    m = (340, y)
    left, _, (H1, V1), _ = rope_shape(p, m, 300, 0.5)
    right, (H2, V2), _, _ = rope_shape(m, q, 262, 0.5)
    f.line(*left, kind="r")
    f.line(*right, kind="r")
    f.dot(p)
    f.dot(q)
    d = atan2(V1, H1)
    f.line(at(at(m, d, -20), d - pi / 2, 10), at(at(m, d, 20), d - pi / 2, 10), at(at(m, d, 20), d - pi / 2, 34),
           at(at(m, d, -20), d - pi / 2, 34), close=True, fill="#e4e4e4")
    f.text((m[0] - 32, m[1] - 30), "cutter or brake shoe", "end")
    f.arrow(m, at(m, d, 74), "$F$, along the path", (-6, -20), anchor="start")
    f.text((left[20][0], left[20][1] + 26), "$p$ of the length, $T_{in}$", "start")
    f.text((right[26][0] - 4, right[26][1] + 24), "1 − $p$, $T_{out}$", "end")
    f.text((60, 60), "spread: $q$ per metre", "start")
    base = [(230 + 26 * i, 52 + 4 * ((i - 6) / 6) ** 2 * 5) for i in range(13)]
    f.line(*base, kind="r")
    for i in range(1, 12, 2):
        f.arrow((base[i][0] - 12, base[i][1] + 11), (base[i][0] + 16, base[i][1] + 11), None)


def vibrations(f):
    # a taut string of 20 segments: shapes of its lumped masses
    x0, x1 = 60, 380
    for j, y in ((1, 250), (2, 165), (3, 80)):
        pts = [(x0 + (x1 - x0) * i / 20, y + 32 * sin(j * pi * i / 20)) for i in range(21)]
        neg = [(p[0], 2 * y - p[1]) for p in pts]
        f.line((x0, y), (x1, y), kind="c")
        f.line(*neg, kind="q")
        f.line(*pts, kind="r")
        for p in pts[1:-1]:
            f.dot(p, 2.2)
        f.text((40, y), str(j), "middle")
    f.text((220, 24), "shapes of a taut rope in 20 segments", "middle")
    # contact stuck and released
    for cx, words in ((460, "stuck"), (570, "released")):
        f.sheave((cx, 220), 32)
        f.arc((cx, 220), 32, pi, 0, "r")
        f.line((cx - 32, 220), (cx - 32, 130), kind="r")
        f.line((cx + 32, 220), (cx + 32, 110), kind="r")
        f.load((cx - 32, 130), 24, None, 4)
        f.load((cx + 32, 110), 24, None, 4)
        f.text((cx, 60), words, "middle")
    f.line((452, 262), (468, 246), kind="f")
    f.line((452, 246), (468, 262), kind="f")
    f.arc((570, 220), 44, 2.2, 0.9, "l", "be")


def motion(f):
    c1, r1, c2, r2 = (140, 170), 66, (480, 210), 44
    f.sheave(c1, r1)
    f.sheave(c2, r2)
    p, q, t = tangent(c1, r1, 1, c2, r2, 1)
    f.arc(c1, r1, 3.2, atan2(p[1] - c1[1], p[0] - c1[0]), "r")
    f.line(at(c1, 3.2, r1), (at(c1, 3.2, r1)[0] + 3, 40), kind="r")
    f.line(p, q, kind="r")
    f.arc(c2, r2, atan2(q[1] - c2[1], q[0] - c2[0]), 0, "r")
    f.line((c2[0] + r2, c2[1]), (c2[0] + r2, 95), kind="r")
    f.load((c2[0] + r2, 95), 36, "$M$", 12)
    f.dot(p)
    f.dot(q)
    f.arrow(p, at(p, atan2(t[1], t[0]), 62), "$T t$", (-2, -16))
    f.text((between(p, q, 0.6)[0], between(p, q, 0.6)[1] + 18), "branch: $l$ now, $L$ unstretched", "middle")
    f.line(c1, p, kind="d")
    f.text((between(c1, p, 0.5)[0] + 8, between(c1, p, 0.5)[1]), "$R_j$")
    f.arc(c1, r1 + 18, 2.9, 2.1, "l", "e")
    f.text((58, 262), "$m_j$ passes", "middle")
    f.arc(c1, 30, -0.4, -2.4, "l", "e")
    f.text((140, 124), "$ω_j$", "middle")
    f.arc(c2, r2 + 16, 0.9, 0.1, "l", "e")
    f.text((572, 274), "$m_{j+1}$ passes", "middle")
    f.arrow((c1[0], 60), (c1[0] + 46, 60), "$v_j$", (14, 0), kind="l")
    f.arrow((400, 120), (446, 120), "$v_{j+1}$", (22, 0), kind="l")
    f.text((60, 28), "to the drum", "start")


def motion_steps(f):
    # a load that is lifted off the ground by a stiff rope and falls back into it: the real law T = EA max(0, e)
    o, W, Hh = (70, 70), 530, 200
    f.axes(o, W + 20, Hh + 40, "time $t$", "tension $T$")
    x, v, t, dt, w2, zeta = 1.0, 0.0, 0.0, 0.0025, 1.0, 0.06
    points = []
    x, v = -1.6, 0.0  # place above the length of the slack rope; weight 0.35
    while t < 21:
        T = 0.0
        if x > 0:
            T = max(0.0, min(w2 * x + 2 * zeta * v, 2 * w2 * x))
        points.append((t, T, x))
        v += (0.35 - T) * dt
        x += v * dt
        t += dt
    scale = Hh / max(p[1] for p in points)

    def place(t, T):
        return (o[0] + W * t / 21, o[1] + T * scale)

    f.line(*[place(p[0], p[1]) for p in points[::25]], kind="f")
    kinks = []
    for a, b in zip(points, points[1:]):
        if (a[2] > 0) != (b[2] > 0):
            kinks.append((b[0], "taut" if b[2] > 0 else "slack"))
    for k, (time, word) in enumerate(kinks[:4]):
        f.dot(place(time, 0), 4, "#222")
        f.line(place(time, 0), (place(time, 0)[0], o[1] + 150), kind="d")
        f.text((place(time, 0)[0], o[1] + 162), word, "middle")
    times, t, h = [], 0.0, 0.9
    i = 0
    while t < 20.6:
        times.append(t)
        near = min([abs(t - k[0]) for k in kinks if k[0] >= t - 1e-9] or [9])
        h = 0.55 if near > 0.6 else 0.14
        t += h
        i += 1
    for t in times:
        x = o[0] + W * t / 21
        f.line((x, o[1] - 8), (x, o[1]), kind="l")
    f.text((o[0] + 150, o[1] - 22), "steps, shorter at a change of law", "middle")


def motion_energy(f):
    # a rope that leaves its round out of its plane, seen along the chord of the round
    d = radians(24)
    x = 110
    for side in (-1, 1):
        f.line((x + 21 * side, 60), (x + 21 * side, 250), (x + 15 * side, 250), (x + 15 * side, 60), close=True,
               fill="#f2f2f2")
    c = (x, 190)
    f.line((x, 70), c, kind="r")
    f.line(c, at(c, pi / 2 - d, 120), kind="r")
    f.line(c, (x, 305), kind="c")
    f.arc(c, 82, pi / 2, pi / 2 - d, "d", "e")
    f.text(at(c, pi / 2 - d / 2, 96), "$d$", "middle")
    f.arrow(at(c, pi / 2 - d, 70), at(c, pi / 2 - d, 122), "$T$", (14, 0))
    f.arrow((x, 120), (x, 76), "$T$", (34, 6))
    f.arrow((x + 50, 130), (x + 50, 168), "$T$ (1 − cos $d$)", (10, -16), anchor="start")
    f.text((x, 34), "groove, and rope at an angle", "middle")
    # the ledger as bars
    o = (325, 70)
    stored = (("kinetic", 55), ("elastic", 38), ("potential", 62))
    taken = (("damped, slipped, ...", 36), ("broken, slack, flanges", 20), ("numerical, residual", 8))
    y = o[1]
    fills = ("#dce8f7", "#c5d9f1", "#aec9ea")
    for (name, size), fill in zip(stored, fills):
        f.line((o[0], y), (o[0] + 60, y), (o[0] + 60, y + size), (o[0], y + size), close=True, fill=fill)
        f.text((o[0] + 68, y + size / 2 + 1), name)
        y += size
    for (name, size), fill in zip(taken, ("#f7e3e4", "#efc9cc", "#e5a9ad")):
        f.line((o[0], y), (o[0] + 60, y), (o[0] + 60, y + size), (o[0], y + size), close=True, fill=fill)
        f.text((o[0] + 68, y + size / 2 + (6 if size < 10 else 1)), name)
        y += size
    f.line((o[0] + 255, o[1]), (o[0] + 300, o[1]), (o[0] + 300, y), (o[0] + 255, y), close=True, fill="#eee")
    f.line((o[0] + 255, o[1] + 90), (o[0] + 300, o[1] + 90))
    f.text((o[0] + 278, o[1] + 45), "start", "middle", small=True, rim=False)
    f.text((o[0] + 278, o[1] + 155), "sup-", "middle", small=True, rim=False)
    f.text((o[0] + 278, o[1] + 140), "plied", "middle", small=True, rim=False)
    f.text((o[0] + 150, 40), "both columns have the same height", "middle")


FIGURES = {  # name: function, height
    "beam": (beam, 355),
    "belt-drive": (belt_drive, 290),
    "carriages": (carriages, 300),
    "catenary": (catenary, 330),
    "checks-tested": (checks_tested, 330),
    "contact": (contact, 275),
    "continuation": (continuation, 310),
    "cycle": (cycle, 300),
    "drives": (drives, 275),
    "drum": (drum, 325),
    "motion": (motion, 300),
    "motion-energy": (motion_energy, 330),
    "motion-steps": (motion_steps, 345),
    "equilibrium": (equilibrium, 320),
    "equilibrium-search": (equilibrium_search, 320),
    "faces": (faces, 300),
    "guy": (guy, 310),
    "guyed-mast": (guyed_mast, 335),
    "installation": (installation, 300),
    "length": (length, 285),
    "load-path": (load_path, 320),
    "loaded-span": (loaded_span, 290),
    "mast-checks": (mast_checks, 335),
    "modes": (modes, 300),
    "parabola": (parabola, 320),
    "payload": (payload, 310),
    "rope-checks": (rope_checks, 300),
    "rope-choice": (rope_choice, 325),
    "rope-life": (rope_life, 320),
    "rope-load": (rope_load, 325),
    "sagging": (sagging, 290),
    "tangent": (tangent_figure, 270),
    "vibrations": (vibrations, 315),
}

if __name__ == "__main__":
    for name, (draw, height) in FIGURES.items():
        figure = Figure(640, height)
        draw(figure)
        figure.save(name)
