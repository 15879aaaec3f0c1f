"""Machines by chance, as trees of named things whose numbers know what they measure, and the same machine described
in another way: mirrored, turned, in other units, from its other end. attack.py runs them."""
import copy
import dataclasses
import json
import math

STANDARD_GRAVITY = 9.80665


@dataclasses.dataclass
class Amount:
    """A number in SI units."""
    value: float
    kind: str  # length, mass, force, line (mass per length)


@dataclasses.dataclass
class Place:
    """A point of the ground's axes, m."""
    x: list


@dataclasses.dataclass
class Arm:
    """A vector: a point of a body (m), a force (N) or a direction (no unit)."""
    x: list
    kind: str


def m(value):
    return Amount(value, "length")


def kg(value):
    return Amount(value, "mass")


def newton(value):
    return Amount(value, "force")


SYSTEMS = {
    "SI": {"length": (1, "m"), "mass": (1, "kg"), "force": (1, "N"), "line": (1, "kg/m")},
    "shop": {"length": (1e-3, "mm"), "mass": (1e3, "t"), "force": (1e3, "kN"), "line": (1e-3, "g/m")},
    "feet": {"length": (0.3048, "ft"), "mass": (0.45359237, "lb"), "force": (4.4482216152605, "lbf"),
             "line": (0.45359237 / 0.3048, "lb/ft")},
    "Cyrillic": {"length": (0.01, "см"), "mass": (1e3, "т"), "force": (9.80665, "кгс"), "line": (1, "кг/м")},
}


def written(thing, system):
    """The tree as a deck has it."""
    def amount(value, kind):
        one, unit = system[kind]
        return f"{value / one!r} {unit}"
    if isinstance(thing, Amount):
        return amount(thing.value, thing.kind)
    if isinstance(thing, Place):
        return [amount(x, "length") for x in thing.x]
    if isinstance(thing, Arm):
        return list(thing.x) if thing.kind == "direction" else [amount(x, thing.kind) for x in thing.x]
    if isinstance(thing, dict):
        return {key: written(value, system) for key, value in thing.items()}
    if isinstance(thing, list):
        return [written(value, system) for value in thing]
    return thing


def deck_text(deck, system="SI"):
    return json.dumps(written(deck, SYSTEMS[system]), indent=1, ensure_ascii=False) + "\n"


# ---- machines

def a_rope(r, largest=3.0):
    """A wire rope; now and then one that is thought to weigh nothing, or to give hardly at all."""
    line, kind = r.uniform(0.3, largest), r.random()
    stiff = 1e5 if kind > 0.9 else 1
    return {"mass": Amount(0 if kind < 0.1 else line, "line"), "stiffness": newton(line * r.uniform(7e6, 15e6) * stiff),
            "breaking_force": newton(line * 2.2e5)}


def deck_of(machine, motion, title):
    return {"taut": 1, "title": title, "machine": machine, "analyses": [{"equilibrium": {"motion": motion}}]}


def a_line(r):
    """A skyline over none to three supports, which may carry a clamped or a rolling carriage."""
    n = r.randint(1, 4)
    x = [0.0]
    for _ in range(n):
        x.append(x[-1] + r.uniform(50, 250))
    slope, rise = r.uniform(-0.4, 0.4), r.uniform(0.1, 0.3)
    heights = [12 + slope * a + rise * a * (x[-1] - a) / x[-1] for a in x]
    rope = a_rope(r)
    pull = rope["breaking_force"].value * r.uniform(0.15, 0.3)
    machine = {"points": {"low": Place([x[0], 0, heights[0]]), "far": Place([x[-1], 0, heights[-1]])}, "ropes": {"sky": rope}}
    path = [{"anchor": "low"}]
    if n > 1:
        machine["supports"] = {}
    carries, k = r.choice(["nothing", "clamped", "rolling"]), r.randrange(n)
    length, before = 0.0, 0.0
    for i in range(n):
        if i > 0:
            machine["supports"][f"jack{i}"] = {
                "at": Place([x[i], 0, heights[i]]), "diameter": m(r.choice([0, 0.5])), "axis": Arm([0, 1, 0], "direction"),
                "law": "sheave", "efficiency": r.uniform(0.9, 1), "uplift": "hold"}
            path.append({"over": f"jack{i}"})
        chord = math.hypot(x[i + 1] - x[i], heights[i + 1] - heights[i])
        sag = (rope["mass"].value * STANDARD_GRAVITY * (x[i + 1] - x[i]) / pull) ** 2 / 24
        if i == k and carries != "nothing":
            t = r.uniform(0.25, 0.75)
            before = length + t * chord * (1 + sag)
            at = [x[i] + t * (x[i + 1] - x[i]), 0, heights[i] + t * (heights[i + 1] - heights[i]) - 0.04 * chord]
            path.append({"through": "car"})
        length += chord * (1 + sag)
    path.append({"anchor": "far"})
    sky = {"rope": "sky", "path": path, "haul": r.choice(["to_start", "to_end"])}
    machine["reevings"] = [sky]
    if carries == "nothing" and r.random() < 0.5:
        sky["tension_at_start"] = newton(pull)
    else:
        sky["length"] = m(length * r.uniform(1.001, 1.006))
    if carries != "nothing":
        machine["carriages"] = {"car": {"mass": kg(r.uniform(80, 400)), "rides": "sky", "at": Place(at)}}
        machine["loads"] = [{"at": "car", "mass": kg(r.uniform(0.02, 0.2) * pull / STANDARD_GRAVITY)}]
    if carries == "clamped":
        machine["carriages"]["car"] |= {"hold": "clamped", "length_before": m(before)}
    if carries == "rolling":
        top = 0 if heights[0] > heights[-1] else -1
        machine["points"]["winch"] = Place([x[top], 0, heights[top] - 2])
        machine["ropes"]["main"] = a_rope(r, 0.8)
        machine["carriages"]["car"] |= {"hold": "rolling", "mainline": "main"}
        reach = math.dist(machine["points"]["winch"].x, at)
        machine["reevings"].append({"rope": "main", "path": [{"anchor": "winch"}, {"anchor": "car"}], "length": m(reach * 1.004)})
    return deck_of(machine, r.choice(["at_rest", "in", "out"]), "a line")


def hung_masses(r):
    """One to three masses in space, each on three ropes, or on one below another."""
    machine = {"points": {}, "ropes": {}, "bodies": {}, "reevings": []}
    posts = []
    for i in range(4):
        angle, radius = 0.5 * math.pi * (i + r.uniform(-0.2, 0.2)), r.uniform(15, 60)
        posts.append([radius * math.cos(angle), radius * math.sin(angle), r.uniform(25, 40)])
        machine["points"][f"post{i}"] = Place(posts[i])
    for i in range(r.randint(1, 3)):
        at = [r.uniform(-4, 4), r.uniform(-4, 4), r.uniform(12, 18) - 7 * i]
        machine["bodies"][f"mass{i}"] = {"mass": kg(r.uniform(100, 3000)), "at": Place(at), "free": ["x", "y", "z"]}
        below = i > 0 and r.random() < 0.5
        ends = [f"mass{i - 1}"] if below else [f"post{k}" for k in r.sample(range(4), 3)]
        for end in ends:
            name = f"rope{len(machine['ropes'])}"
            machine["ropes"][name] = a_rope(r, 1.5)
            reach = r.uniform(3, 12) if below else math.dist(posts[int(end[4:])], at) * r.uniform(0.99, 1.04)
            machine["reevings"].append({"rope": name, "path": [{"anchor": end}, {"anchor": f"mass{i}"}], "length": m(reach)})
    if r.random() < 0.6:
        machine["loads"] = [{"at": "mass0", "force": Arm([r.uniform(-2e3, 2e3) for _ in range(3)], "force")}]
    return deck_of(machine, "at_rest", "hung masses")


def a_tackle(r):
    """A hook on several parts between two blocks, from a winch."""
    parts, rope = r.randint(2, 7), a_rope(r, 1.5)
    top, hook, d = r.uniform(10, 40), r.uniform(1, 5), r.choice([0, 0.4])
    aside, up = r.choice([-1, 1]) * r.uniform(3, 12), r.uniform(0, 4)
    pull = rope["breaking_force"].value / r.uniform(5, 9)
    block = {"diameter": m(d), "axis": Arm([0, 1, 0], "direction")}
    machine = {
        "points": {"pin": Place([0.3 * d, 0, top - 0.5])}, "ropes": {"hoist": rope},
        "bodies": {"hook": {"mass": kg(r.uniform(20, 300)), "at": Place([0, 0, hook]), "free": ["x", "y", "z"]}},
        "sheaves": {"head": {"at": Place([0, 0, top]), "efficiency": r.uniform(0.9, 1), **block},
                    "lower": {"body": "hook", "at": Arm([0, 0, 0], "length"), "efficiency": r.uniform(0.9, 1), **block}},
        "drums": {"winch": {"at": Place([aside, 0, up]), "core_diameter": m(d), "axis": Arm([0, 1, 0], "direction")}},
        "reevings": [{"rope": "hoist", "haul": "to_start", "length": m(math.hypot(aside, top - up) + parts * (top - hook + 1.6 * d)),
                      "path": [{"drum": "winch"}, {"over": "head", "parts": parts, "between": ["head", "lower"]},
                               {"anchor": "pin" if parts % 2 == 0 else "hook"}]}],
        "loads": [{"at": "hook", "mass": kg(pull * parts / STANDARD_GRAVITY)}]}
    return deck_of(machine, r.choice(["hoist", "lower", "at_rest"]), "a tackle")


def a_mast(r):
    """A guyed mast with a pull at its top."""
    h, n = r.uniform(8, 22), r.randint(3, 6)
    rope, first = a_rope(r), r.uniform(0, 2 * math.pi)
    strong = rope["breaking_force"].value
    machine = {"points": {"foot": Place([0, 0, 0]), "head": Place([0, 0, h])}, "ropes": {"stay": rope}, "guys": {},
               "beams": {"mast": {"from": "foot", "to": "head", "A": f"{r.uniform(80, 180)!r} cm^2", "I": f"{r.uniform(9e3, 3e4)!r} cm^4",
                                  "W": "900 cm^3", "base": r.choice(["hinge", "clamped"]), "order": "second"}},
               "loads": [{"at": "mast.top", "force": Arm([r.uniform(-0.2, 0.2) * strong, r.uniform(-0.2, 0.2) * strong,
                                                           -r.uniform(0, 0.2) * strong], "force")}]}
    for i in range(n):
        angle, radius = first + 2 * math.pi * (i + r.uniform(-0.1, 0.1)) / n, h * r.uniform(0.8, 1.5)
        machine["points"][f"stump{i}"] = Place([radius * math.cos(angle), radius * math.sin(angle), r.uniform(-2, 2)])
        machine["guys"][f"guy{i}"] = {"rope": "stay", "from": "mast.top", "to": f"stump{i}",
                                      "install": {"tension": newton(strong * r.uniform(0.08, 0.15)), "at": "top"}}
    return deck_of(machine, "at_rest", "a mast")


def over_blocks(r):
    """A weight on a rope that runs over and under blocks, through the plane of y = 0, to an anchor or a winch's drum."""
    n, x = r.randint(1, 4), 0.0
    rope = a_rope(r, 1.5)
    machine = {"points": {}, "ropes": {"line": rope}, "sheaves": {}, "bodies": {}, "reevings": []}
    path, places = [], [[0.0, 0.0, r.uniform(0, 2)]]
    for i in range(n):
        x += r.uniform(4, 25)
        high = (n - i) % 2 == 1  # the last one, from which the weight hangs, is a high one
        places.append([x, 0.0, r.uniform(25, 35) if high else r.uniform(0, 5)])
        machine["sheaves"][f"block{i}"] = {"at": Place(places[-1]), "diameter": m(r.choice([0, r.uniform(0.2, 1.2)])),
                                           "axis": Arm([0, 1, 0], "direction"), "efficiency": r.uniform(0.9, 1)}
        path.append({"over": f"block{i}"})
    below = [x + 0.6, 0.0, r.uniform(5, 15)]
    length = sum(math.dist(a, b) for a, b in zip(places, [*places[1:], below]))
    machine["bodies"]["weight"] = {"mass": kg(rope["breaking_force"].value / r.uniform(5, 9) / STANDARD_GRAVITY),
                                   "at": Place(below), "free": ["x", "y", "z"]}
    if r.random() < 0.5:
        machine["drums"] = {"start": {"at": Place(places[0]), "core_diameter": m(0.5), "axis": Arm([0, 1, 0], "direction")}}
    else:
        machine["points"]["start"] = Place(places[0])
    first = {"drum": "start"} if "drums" in machine else {"anchor": "start"}
    machine["reevings"].append({"rope": "line", "path": [first, *path, {"anchor": "weight"}], "haul": "to_start", "length": m(length)})
    return deck_of(machine, r.choice(["in", "out", "at_rest"]), "over blocks")


MACHINES = [a_line, hung_masses, a_tackle, a_mast, over_blocks]


# ---- the same machine, described in another way: deck, chance -> deck, how its answer follows from the first one; None: not for this one

@dataclasses.dataclass
class How:
    turned: list = dataclasses.field(default_factory=lambda: [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    moved: list = dataclasses.field(default_factory=lambda: [0, 0, 0])
    system: str = "SI"
    swapped: bool = False
    split: str = ""


def each(thing, change):
    if isinstance(thing, dict):
        return {key: each(value, change) for key, value in thing.items()}
    if isinstance(thing, list):
        return [each(value, change) for value in thing]
    return change(thing)


def applied(matrix, x):
    return [sum(a * b for a, b in zip(row, x)) for row in matrix]


def in_other_axes(deck, matrix, moved):
    def change(leaf):
        if isinstance(leaf, Place):
            return Place([a + b for a, b in zip(applied(matrix, leaf.x), moved)])
        return Arm(applied(matrix, leaf.x), leaf.kind) if isinstance(leaf, Arm) else leaf
    return each(deck, change), How(turned=matrix, moved=moved)


def mirrored(deck, _):
    return in_other_axes(deck, [[-1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0])


def turned(deck, r):
    c, s = math.cos(angle := r.uniform(0, 2 * math.pi)), math.sin(angle)
    return in_other_axes(deck, [[c, -s, 0], [s, c, 0], [0, 0, 1]], [r.uniform(-300, 300), r.uniform(-300, 300), r.uniform(0, 300)])


def in_other_units(deck, r):
    return deck, How(system=r.choice(["shop", "feet", "Cyrillic"]))


def in_other_order(deck, r):
    def shuffled(thing):
        if isinstance(thing, dict):
            return {key: shuffled(thing[key]) for key in r.sample(list(thing), len(thing))}
        return [shuffled(x) for x in thing] if isinstance(thing, list) else thing
    deck = shuffled(deck)
    for name in ("reevings", "loads"):
        if name in deck["machine"]:
            r.shuffle(deck["machine"][name])
    return deck, How()


def with_ends_swapped(deck, _):
    deck = copy.deepcopy(deck)
    if not deck["machine"].get("reevings"):
        return None
    for line in deck["machine"]["reevings"]:
        line["path"].reverse()
        for step in line["path"]:
            if "parts" in step and step["parts"] % 2 == 0:  # it ended at the other block
                step["between"].reverse()
                step["over"] = step["between"][0]
        if "tension_at_start" in line:
            line["tension_at_end"] = line.pop("tension_at_start")
        line["haul"] = "to_start" if line.get("haul", "to_start") == "to_end" else "to_end"
        for car in deck["machine"].get("carriages", {}).values():
            if "length_before" in car and car["rides"] == line["rope"]:
                car["length_before"] = m(line["length"].value - car["length_before"].value)
    return deck, How(swapped=True)


def from_another_guess(deck, r):
    deck = copy.deepcopy(deck)
    moves = [b for b in deck["machine"].get("bodies", {}).values() if "z" in b.get("free", [])]
    moves += list(deck["machine"].get("carriages", {}).values())
    for thing in moves:
        thing["at"] = Place([a + r.uniform(-4, 4) for a in thing["at"].x])
    return (deck, How()) if moves else None


def with_a_knot(deck, r):
    """One rope between two ends is two ropes, tied to a point without mass."""
    deck = copy.deepcopy(deck)
    machine = deck["machine"]
    plain = [x for x in machine.get("reevings", []) if len(x["path"]) == 2 and "length" in x and
             all(x["rope"] != car.get("mainline") for car in machine.get("carriages", {}).values())]
    if not plain:
        return None
    line, share = r.choice(plain), r.uniform(0.2, 0.8)
    ends = [step["anchor"] for step in line["path"]]
    a, b = ((machine["points"].get(e) or machine["bodies"][e]["at"]).x for e in ends)
    at = [p + share * (q - p) for p, q in zip(a, b)]
    machine.setdefault("bodies", {})["knot"] = {"mass": kg(0), "at": Place(at), "free": ["x", "y", "z"]}
    k = machine["reevings"].index(line)
    machine["reevings"][k:k + 1] = [
        {**line, "name": "first_half", "path": [{"anchor": ends[0]}, {"anchor": "knot"}], "length": m(share * line["length"].value)},
        {**line, "name": "second_half", "path": [{"anchor": "knot"}, {"anchor": ends[1]}], "length": m((1 - share) * line["length"].value)}]
    return deck, How(split=line["rope"])


CHANGES = [mirrored, turned, in_other_units, in_other_order, with_ends_swapped, from_another_guess, with_a_knot]
EXACT = {mirrored, turned, in_other_units, in_other_order, with_ends_swapped}  # also what is refused stays refused
