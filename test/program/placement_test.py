"""In the figures of every example's report no two texts touch and no text leaves its picture.

Twice: with a model of the texts' widths (Helvetica's letters, on the safe side), and, where a Chromium is installed, with
the boxes that it draws. On a screen the playing animation is checked, in print the strip of moments: both are in the page.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as tree

import example_runs

PROGRAM = os.environ["TAUT_PROGRAM"]
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")

# Helvetica's widths in thousandths of the size, space to tilde (Adobe's font metrics).
WIDTHS = [278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278] + [556] * 10 + [
    278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667,
    778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278, 556,
    556, 222, 222, 500, 222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584]
SIZES = {"label": 12.5, "number": 12, "tick": 12, "v": 14, "s": 9.5, "sv": 9.5}
LETTER = 0.6  # of the size: a letter that is not in the table, or of the formula font
TOUCH = 0.5   # pixels by which two boxes may run into each other: numbers are written with one decimal

# A deck in which everything is close to everything: more names than the picture has room for.
CROWD = 100


def crowd(n):
    """n hoists side by side, each a rope over a sheave with a load and a winch."""
    rows = range(n)
    return {
        "taut": 1, "title": f"{n} hoists", "analyses": [{"equilibrium": {"motion": "hoist"}}],
        "machine": {
            "points": {f"hook_{i}": {"body": f"load_{i}", "at": ["0 m", "0 m", "0 m"]} for i in rows},
            "ropes": {"hoist": {"rope": "EN 12385-4|6x36-IWRC|16|1960", "stiffness": "13 MN"}},
            "bodies": {f"load_{i}": {"mass": f"{1000 + 10 * i} kg", "at": [f"{4 * i + 0.15} m", "0 m", "3 m"],
                                     "free": ["z"]} for i in rows},
            "sheaves": {f"head_{i}": {"at": [f"{4 * i} m", "0 m", "10 m"], "diameter": "300 mm", "efficiency": 0.97}
                        for i in rows},
            "drums": {f"winch_{i}": {"at": [f"{4 * i - 1.5} m", "0 m", "1 m"], "core_diameter": "300 mm"} for i in rows},
            "reevings": [{"name": f"rope_{i}", "rope": "hoist", "length": "16 m",
                          "path": [{"drum": f"winch_{i}"}, {"over": f"head_{i}"}, {"anchor": f"hook_{i}"}]}
                         for i in rows]}}


def text_width(text, size):
    return sum((WIDTHS[ord(c) - 32] / 1000 if 32 <= ord(c) < 127 else LETTER) * size for c in text)


def local(element):
    return element.tag.rpartition("}")[2]


def box_of(element):
    """Left, top, right, bottom of a <text>, before its transform."""
    kind = element.get("class", "label")
    size = SIZES[kind]
    wide = text_width(element.text or "", size)
    for span in element:
        wide += text_width(span.text or "", SIZES.get(span.get("class"), size)) + text_width(span.tail or "", size)
    x, y = float(element.get("x", 0)), float(element.get("y", 0))
    left = x - {"middle": wide / 2, "end": wide}.get(element.get("text-anchor"), 0)
    lowered = any(span.get("class") in ("s", "sv") for span in element)
    return left, y - 0.76 * size, left + wide, y + (0.36 if lowered else 0.22) * size


def moved(box, transform):
    """The box after translate(x y), alone or before rotate(-90)."""
    if not transform:
        return box
    match = re.fullmatch(r"translate\((\S+) (\S+)\)( rotate\(-90\))?", transform)
    dx, dy = float(match[1]), float(match[2])
    left, top, right, bottom = box
    if match[3]:
        left, top, right, bottom = top, -right, bottom, -left
    return left + dx, top + dy, right + dx, bottom + dy


def texts(element, transforms=()):
    """All texts below an element: words, box."""
    found = []
    own = transforms + ((element.get("transform"),) if element.get("transform") else ())
    if local(element) == "text":
        box = box_of(element)
        for transform in reversed(own):
            box = moved(box, transform)
        words = "".join(element.itertext())
        return [(words, box)] if words else []
    for child in element:
        found += texts(child, own)
    return found


def faults(svg):
    """What touches, and what leaves the picture, in words."""
    left, top, wide, high = (float(x) for x in svg.get("viewBox").split())
    all_texts = texts(svg)
    found = []
    for i, (words, box) in enumerate(all_texts):
        if box[0] < left - TOUCH or box[1] < top - TOUCH or box[2] > left + wide + TOUCH or box[3] > top + high + TOUCH:
            found.append(f"'{words}' leaves the picture")
        for others, other in all_texts[:i]:
            across = min(box[2], other[2]) - max(box[0], other[0])
            down = min(box[3], other[3]) - max(box[1], other[1])
            if across > TOUCH and down > TOUCH:
                found.append(f"'{words}' touches '{others}'")
    return found


def figures(page):
    """The pictures of a page: not the small bars of its tables."""
    return [text for text in re.findall(r"<svg class=\"(?:drawing|plot|strip|moving|profile).*?</svg>", page, re.S)]


SCRIPT = """
var all = [];
document.querySelectorAll("div[data-name] > svg").forEach(function (svg) {
  var name = svg.parentNode.dataset.name, frame = svg.getBoundingClientRect(), boxes = [];
  svg.querySelectorAll("text").forEach(function (text) {
    if (text.textContent) boxes.push([text.textContent, text.getBoundingClientRect()]);
  });
  boxes.forEach(function (one, i) {
    var a = one[1];
    if (a.left < frame.left - 1 || a.right > frame.right + 1 || a.top < frame.top - 1 || a.bottom > frame.bottom + 1)
      all.push(name + ": '" + one[0] + "' leaves the picture");
    for (var k = 0; k < i; ++k) {
      var b = boxes[k][1];
      if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1.5 &&
          Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 2.5)
        all.push(name + ": '" + one[0] + "' touches '" + boxes[k][0] + "'");
    }
  });
});
document.body.innerHTML = "<pre id=faults></pre>";
document.getElementById("faults").textContent = "FAULTS" + JSON.stringify(all) + "END";
"""


class Placement(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        cls.pages = {name: run.report for name, run in example_runs.of_all(example_runs.those_that_run())}
        hoists = folder / f"hoists_{CROWD}.yaml"
        hoists.write_text(json.dumps(crowd(CROWD)), encoding="utf-8")
        subprocess.run([PROGRAM, "run", str(hoists), "-o", str(folder / "out"), "--quiet"], capture_output=True, check=False)
        cls.pages[hoists.name] = (folder / "out/report.html").read_text(encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_example_has_figures(self):
        self.assertGreater(sum(len(figures(page)) for page in self.pages.values()), len(self.pages))

    def test_no_text_touches_another_by_the_model(self):
        found = []
        for name, page in self.pages.items():
            for text in figures(page):
                svg = tree.fromstring(text)
                found += [f"{name}, {svg.get('aria-label')}: {x}" for x in faults(svg)]
        self.assertEqual(found, [], f"{len(found)} faults")

    def test_print_is_legible(self):
        """A page is 660 pixels wide and 176 mm; a high figure is shrunk to 112 mm, a whole page to 235 mm. A profile has a
        turned page: 263 mm by 160 mm."""
        for name, page in self.pages.items():
            for text in figures(page):
                svg = tree.fromstring(text)
                if svg.get("class") == "moving":
                    continue
                wide, high = float(svg.get("width")), float(svg.get("height"))
                tall = "tall" in svg.get("class").split()
                most_wide, most_high = (263, 160) if wide > 660 else (176, 235 if tall else 112)
                shrunk = min(1, most_wide / 25.4 * 96 / wide, most_high / 25.4 * 96 / high)
                with self.subTest(deck=name, figure=svg.get("aria-label")):
                    self.assertGreaterEqual(12 * 0.75 * shrunk, 8, "points of the smallest label")

    @unittest.skipUnless(CHROMIUM, "no Chromium is installed: its text boxes cannot be compared")
    def test_no_text_touches_another_in_the_browser(self):
        style = re.search(r"<style>.*?</style>", next(iter(self.pages.values())), re.S)[0]
        body = "".join(f"<div data-name=\"{name}\">{text}</div>\n"
                       for name, page in self.pages.items() for text in figures(page))
        page = pathlib.Path(self.folder.name) / "all.html"
        page.write_text(f"<!doctype html><meta charset=utf-8>{style}<style>svg{{display:block!important;max-width:none!"
                        f"important}}</style><body>{body}<script>{SCRIPT}</script>", encoding="utf-8")
        with tempfile.TemporaryDirectory() as profile:
            ran = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
                                  "--disable-background-networking", f"--user-data-dir={profile}", "--dump-dom",
                                  page.as_uri()], capture_output=True, text=True, check=False)
        match = re.search("FAULTS(.*)END", ran.stdout, re.S)
        self.assertIsNotNone(match, ran.stderr[-2000:])
        found = json.loads(match[1].replace("&amp;", "&").replace("&lt;", "<").replace("&gt;", ">"))
        self.assertEqual(found, [], f"{len(found)} faults")


if __name__ == "__main__":
    unittest.main()
