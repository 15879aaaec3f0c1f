"""What the answer for a machine has to obey: mechanics, from its own tables, and the answer for the same machine described
in another way. Each fault is a line of text; attack.py runs them."""
import collections
import dataclasses
import json
import math
import os
import subprocess

from attack_machines import STANDARD_GRAVITY, Place, applied, deck_text

NEAR = 1e-6  # of the largest tension, of the machine's size


@dataclasses.dataclass
class Answer:
    code: int
    result: dict
    complaint: str

    def rows(self, table):
        t = self.result.get("tables", {}).get(table, {"columns": [], "rows": []})
        names = [column["name"] for column in t["columns"]]
        return [dict(zip(names, row)) for row in t["rows"]]

    @property
    def solved(self):
        return self.code in (0, 4) and self.result.get("status") == "ok"

    @property
    def tension(self):
        return max([max(abs(s["T_from"]), abs(s["T_to"])) for s in self.rows("spans")], default=0.0)


def ask(deck, system="SI"):
    done = subprocess.run([os.environ["TAUT_PROGRAM"], "run", "-", "--json"], input=deck_text(deck, system), capture_output=True,
                          encoding="utf-8", check=False)
    try:
        result = json.loads(done.stdout)
    except ValueError:
        return Answer(done.returncode, {}, f"no JSON: {done.stderr[:300]}")
    return Answer(done.returncode, result, result.get("message") or str(result.get("errors", ""))[:300])


def size_of(deck):
    places = []

    def look(thing):
        if isinstance(thing, Place):
            places.append(max(map(abs, thing.x)))
        for inner in thing.values() if isinstance(thing, dict) else thing if isinstance(thing, list) else ():
            look(inner)
    look(deck)
    return max(places, default=1.0) + 1.0


def lines_of(machine):
    """Reevings and guys by the name that tables use."""
    lines = {x.get("name", x["rope"]): x for x in machine.get("reevings", [])}
    return lines | machine.get("guys", {})


# ---- mechanics

def span_faults(span, rope, tension):
    """A span hangs as an elastic catenary between its ends."""
    w, EA, length = rope["mass"].value * STANDARD_GRAVITY, rope["stiffness"].value, span["unstretched"]
    H, below, above = span["H"], span["V_from"], span["V_from"] + w * length
    pull = math.hypot(H, below)
    if w * length > NEAR * tension:
        across = H * length / EA + (H / w * (math.asinh(above / H) - math.asinh(below / H)) if H > 1e-12 * tension else 0)
        up = (below + above) / 2 * length / EA + (math.hypot(H, above) - pull) / w
        chord = math.hypot(across, up)
    elif pull > NEAR * tension:  # straight
        chord = length * (1 + pull / EA)
    else:  # slack: any distance that it reaches
        chord = min(span["chord"], length)
    wanted = {"V_to": above, "T_from": math.hypot(H, below), "T_to": math.hypot(H, above)}
    faults = [f"{name} is {span[name]}, not {value}" for name, value in wanted.items() if abs(span[name] - value) > NEAR * tension]
    if abs(chord - span["chord"]) > NEAR * max(span["chord"], 1):
        faults.append(f"its chord is {span['chord']}, not {chord}")
    return [f"span {span['from']}-{span['to']} of {span['rope']}: {fault}" for fault in faults]


def contact_faults(contact, machine, tension):
    """No contact holds back more than its friction or its bearing can."""
    name = contact["name"].split("[")[0]
    law = machine.get("sheaves", {}).get(name) or machine.get("supports", {}).get(name)
    more, less = max(contact["T_in"], contact["T_out"]), min(contact["T_in"], contact["T_out"])
    if law is None or more <= less / law["efficiency"] + NEAR * tension:
        return []
    return [f"{contact['name']}: {more} against {less} is beyond its efficiency {law['efficiency']}"]


def balance_faults(deck, answer):
    """What is free to move is pulled nowhere: ropes, loads and weight."""
    machine, free = deck["machine"], {}
    for group in ("bodies", "carriages"):
        for name, body in machine.get(group, {}).items():
            free[name] = [0.0, 0.0, -STANDARD_GRAVITY * body["mass"].value]
    held = {name: sheave["body"] for name, sheave in machine.get("sheaves", {}).items() if "body" in sheave}
    for row in answer.rows("anchors") + answer.rows("sheaves"):
        name = row["name"].split("[")[0]
        body = held.get(name, name)
        if body in free:
            free[body] = [a + row[c] for a, c in zip(free[body], ("Fx", "Fy", "Fz"))]
    for load in machine.get("loads", []):
        if load["at"] in free:
            pull = load["force"].x if "force" in load else [0, 0, -STANDARD_GRAVITY * load["mass"].value]
            free[load["at"]] = [a + b for a, b in zip(free[load["at"]], pull)]
    return [f"{name} is pulled by {force}" for name, force in free.items() if max(map(abs, force)) > NEAR * answer.tension]


def length_faults(line, name, spans, points_only):
    total = sum(s["unstretched"] for s in spans)
    faults = []
    if "length" in line and points_only and abs(total - line["length"].value) > NEAR * total:
        faults.append(f"{name}: its spans are {total} m together, it has {line['length'].value} m")
    if "tension_at_start" in line and total > 1.2 * sum(s["chord"] for s in spans):
        faults.append(f"{name}: a rope of given tension hangs in a loop of {total} m")
    return faults


def law_faults(deck, answer):
    machine, tension = deck["machine"], answer.tension
    lines, spans = lines_of(machine), collections.defaultdict(list)
    faults = balance_faults(deck, answer)
    for span in answer.rows("spans"):
        spans[span["rope"]].append(span)
        faults += span_faults(span, machine["ropes"][lines[span["rope"]]["rope"]], tension)
    for contact in answer.rows("sheaves"):
        faults += contact_faults(contact, machine, tension)
    rounds = list(machine.get("sheaves", {}).values()) + list(machine.get("supports", {}).values())
    points_only = all(s["diameter"].value == 0 for s in rounds)
    for name, line in lines.items():
        faults += length_faults(line, name, spans[name], points_only)
    return faults


# ---- the same machine described in another way

@dataclasses.dataclass
class Seen:
    """One number or vector of an answer."""
    value: list
    kind: str  # force, length, moment; place and pull are vectors


def seen_of_spans(answer, how, reevings, out):
    """By line and number along it, so that a line read from its other end is the same."""
    for table, ends in (("spans", ("from", "to")), ("sheaves", ("in", "out"))):
        lines = collections.defaultdict(list)
        for row in answer.rows(table):
            lines[row["rope"]].append(row)
        for rope, rows in lines.items():
            back = how.swapped and rope in reevings
            first, last = reversed(ends) if back else ends
            for k, row in enumerate(reversed(rows) if back else rows):
                key = (table, rope, k)
                out[(*key, "T first")], out[(*key, "T last")] = Seen([row[f"T_{first}"]], "force"), Seen([row[f"T_{last}"]], "force")
                if table == "spans":
                    out |= {(*key, name): Seen([row[name]], "length") for name in ("unstretched", "stretched", "chord", "sag")}
                    out[(*key, "H")] = Seen([row["H"]], "force")
                else:
                    out[(*key, row["name"].split("[")[0])] = Seen([row["Fx"], row["Fy"], row["Fz"]], "pull")


def seen(answer, how, reevings):
    """What both answers have to have; `how` is the way in which this one was described."""
    out = {}
    if not how.split:
        seen_of_spans(answer, how, reevings, out)
    for row in answer.rows("anchors"):
        rope = how.split if row["rope"] in ("first_half", "second_half") else row["rope"]
        if row["name"] != "knot":
            out["anchor", row["name"], rope] = Seen([row["Fx"], row["Fy"], row["Fz"]], "pull")
    for row in answer.rows("bodies"):
        if row["name"] != "knot":
            out["body", row["name"]] = Seen([row["x"], row["y"], row["z"]], "place")
    for row in answer.rows("beam_ends"):
        out["beam", row["name"], "R"] = Seen([row["Rx"], row["Ry"], row["Rz"]], "pull")
        out["beam", row["name"], "M_max"] = Seen([row["M_max"]], "moment")
    return out


def difference_faults(deck, first, other, how):
    """How the other answer is not what follows from the first one."""
    reevings = {x.get("name", x["rope"]) for x in deck["machine"].get("reevings", [])}
    a = seen(first, dataclasses.replace(how, swapped=False), reevings)
    if how.split:
        a = {key: value for key, value in a.items() if key[0] in ("anchor", "body", "beam")}
    b = seen(other, how, reevings)
    faults = [f"{key} is in one answer only" for key in a.keys() ^ b.keys()]
    size = size_of(deck)
    near = {"length": NEAR * size, "place": NEAR * (size + max(map(abs, how.moved))), "moment": NEAR * size * first.tension}
    for key in a.keys() & b.keys():
        x, y, kind = a[key].value, b[key].value, a[key].kind
        if kind in ("pull", "place"):
            x = applied(how.turned, x)
        if kind == "place":
            x = [p + q for p, q in zip(x, how.moved)]
        if any(abs(p - q) > near.get(kind, NEAR * first.tension) for p, q in zip(x, y)):
            faults.append(f"{key} is {y}, not {x}")
    verdicts = [r.result.get("verdict") for r in (first, other)]
    if not how.split and (first.code, verdicts[0]) != (other.code, verdicts[1]):
        faults.append(f"exit code {other.code}, verdict {verdicts[1]}, not {first.code}, {verdicts[0]}")
    return faults

