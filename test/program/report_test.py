"""The report as its reader has it: page 1 is one page, the sections are in order, no report is longer than its kind may be.

TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree with its examples. What is printed is measured with Chromium
where it is installed; the other tests need none.
"""

import concurrent.futures
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import example_runs

PROGRAM = os.environ["TAUT_PROGRAM"]
EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples"
FEWER = "TAUT_FEWER" in os.environ
BROWSER = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)

# of the explorations of one boom a few of each kind
BOOM = ["row1", "pretension", "force_19_hook", "slip_17_hook", "chain_52_load"]
ORDER = ["page-1", "errors", "warnings", "inputs", "checks", "comparison", "calculation", "results", "assumptions", "pictures",
         "appendix"]
METHOD, MACHINE, DESIGN = 8, 10, 12  # pages
ROWS_OF_A_PAGE = 40


def decks():
    if FEWER:
        return ["mast_section.yaml", "machines/three_span_skyline.yaml"]
    return [d for d in example_runs.names() if not d.startswith("telescopic_boom/") or pathlib.Path(d).stem in BOOM]


def sections(page):
    return re.findall(r'<section [^>]*?id="([^"]+)"', page)


def section(page, name):
    found = re.search(rf'<section [^>]*?id="{name}"[^>]*>(.*?)</section>', page, re.S)
    return found[1] if found else ""


def words(markup):
    return html.unescape(re.sub(r"<[^>]+>", " ", markup))


def pages(report):
    """How many pages the browser prints."""
    with tempfile.TemporaryDirectory() as place:
        pdf = pathlib.Path(place, "report.pdf")
        subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                        "--disable-background-networking", "--disable-component-update", "--disable-sync",
                        f"--user-data-dir={place}/profile", "--no-pdf-header-footer", f"--print-to-pdf={pdf}",
                        report.resolve().as_uri()], capture_output=True, check=True)
        return len(re.findall(rb"/Type\s*/Page\b(?!s)", pdf.read_bytes()))


def height_of_page_one(report):
    """Pages that the texts and tables of page 1 take where they may: without its picture, in their own height."""
    page = report.read_text()
    alone = re.sub(r'<section id="(?!page-1).*?</section>', "", page, flags=re.S)
    alone = re.sub(r"\.sheet\{height:\d+mm\}", ".sheet{height:auto!important;break-after:auto!important}.sheet>*{flex:none!important}"
                   ".key,.room{display:none!important}", alone)
    with tempfile.TemporaryDirectory() as place:
        copy = pathlib.Path(place, "page_one.html")
        copy.write_text(alone)
        return pages(copy)


def longest(name, result):
    """Pages that a report may have."""
    if name.startswith("design/"):
        return DESIGN
    return MACHINE if result["method"] == "machine" else METHOD


def many_parts(count):
    """A machine of many parts with long names and a long title, none of which is strong enough."""
    def each(line):
        return "\n".join(line.format(i=i, y=3 * i) for i in range(count))
    return f"""taut: 1
title: {"a title that goes on and on " * 15}
project: {{project: {"a forest with a long name " * 8}, author: A. Meier, checked_by: B. Keller, revision: B}}
machine:
  points:
{each("    top_of_the_hoist_number_{i}: [0 m, {y} m, 20 m]")}
  ropes: {{wire: {{diameter: 14 mm, mass: 0.8 kg/m, stiffness: 9 MN, breaking_force: 136 kN}}}}
  bodies:
{each("    hook_of_the_hoist_number_{i}: {{mass: 2 t, at: [0 m, {y} m, 4 m], free: [x, z]}}")}
  reevings:
{each("    - {{name: a_hoist_with_a_long_name_{i}, rope: wire, path: [{{anchor: top_of_the_hoist_number_{i}}}, "
      "{{anchor: hook_of_the_hoist_number_{i}}}], length: 16 m}}")}
analyses:
  - equilibrium: {{motion: at_rest}}
checks:
  ropes: {{wire: {{safety_factor: 50}}}}
"""


class Reports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.runs = dict(example_runs.of_all(decks()))

    def for_each(self, check):
        for name, run in self.runs.items():
            with self.subTest(name):
                check(run.folder, run.report, run.result)

    def test_the_sections_are_in_order(self):
        def check(_, page, __):
            found = sections(page)
            self.assertEqual(found, [name for name in ORDER if name in found])
            self.assertLessEqual({"page-1", "inputs"}, set(found))
            for name in found:
                self.assertIn(f'<a href="#{name}">', page)
        self.for_each(check)

    def test_page_one_has_the_verdict_and_who_may_sign(self):
        def letters(text):
            return re.sub(r"[^a-z]", "", text.lower())

        def check(_, page, result):
            first = section(page, "page-1")
            self.assertIn(html.escape(result["title"])[:60], first)
            self.assertIn(letters(result["verdict_reason"].split("_")[0])[:20], letters(words(first)))
            self.assertEqual('class="signature"' in first, result["verdict"].startswith("passes"))
            self.assertIn("hash", first)
            self.assertLessEqual(len(re.findall("<tr class=", first)), 10)
            self.assertLessEqual(len(re.findall("<li>", first)), 4)
        self.for_each(check)

    def test_what_is_linked_is_there(self):
        def check(folder, page, _):
            for name in re.findall(r'href="([^#"]+)"', page):
                self.assertTrue((folder / html.unescape(name)).is_file(), name)
        self.for_each(check)

    def test_every_check_and_every_equation_stands_before_the_appendix(self):
        def check(_, page, result):
            rows = re.findall('<tr class="(?:good|bad)">', section(page, "checks"))
            self.assertEqual(len(rows), len(result["checks"]))
            appendix = section(page, "appendix")
            self.assertNotIn('class="step', appendix)
            self.assertNotIn('class="checks', appendix)
            self.assertNotIn("<details open", appendix)
        self.for_each(check)

    def test_the_appendix_is_unfolded_on_demand(self):
        with tempfile.TemporaryDirectory() as place:
            subprocess.run([PROGRAM, "run", str(EXAMPLES / "mast_section.yaml"), "-q", "-o", place, "--appendix", "--paper=a3"],
                           capture_output=True, check=True)
            page = pathlib.Path(place, "report.html").read_text()
        self.assertIn("<details open>", section(page, "appendix"))
        self.assertIn("size:A3", page)
        done = subprocess.run([PROGRAM, "run", str(EXAMPLES / "mast_section.yaml"), "--paper", "a5"], capture_output=True, check=False)
        self.assertEqual(done.returncode, 2)

    @unittest.skipUnless(BROWSER, "Chromium is not installed: nothing is printed")
    def test_no_report_is_longer_than_its_kind(self):
        def measured(item):
            name, run = item
            return name, pages(run.folder / "report.html"), height_of_page_one(run.folder / "report.html")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            counts = list(pool.map(measured, self.runs.items()))
        for name, count, first in counts:
            with self.subTest(name):
                self.assertLessEqual(count, longest(name, self.runs[name].result))
                self.assertEqual(first, 1, "page 1 fits on one page")

    @unittest.skipUnless(BROWSER, "Chromium is not installed: nothing is printed")
    def test_page_one_is_one_page_for_any_machine(self):
        with tempfile.TemporaryDirectory() as place:
            deck = pathlib.Path(place, "many.yaml")
            deck.write_text(many_parts(14))
            done = subprocess.run([PROGRAM, "run", str(deck), "-q", "-o", place + "/out"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertEqual(height_of_page_one(pathlib.Path(place, "out/report.html")), 1)

    @unittest.skipUnless(BROWSER, "Chromium is not installed: nothing is printed")
    def test_a_comparison_has_page_one_and_40_rows_a_page(self):
        rows = 90
        with tempfile.TemporaryDirectory() as place:
            shutil.copy(EXAMPLES / "friction_drive.yaml", place)
            values = "".join(f"    - {{what: 'row {i // 3}, case: value {i}', deck: friction_drive.yaml, value: P_M, published: 1 kN, "
                             "note: a remark on the row}\n" for i in range(rows))
            pathlib.Path(place, "compare.part.yaml").write_text(f"taut: 1\ncompare:\n  source: the paper\n  values:\n{values}")
            done = subprocess.run([PROGRAM, "compare", place, "-q", "-o", place + "/out"], capture_output=True, text=True, check=False)
            report = pathlib.Path(place, "out/report.html")
            self.assertTrue(report.is_file(), done.stderr)
            for i in range(rows):
                self.assertIn(f"value {i}<", report.read_text())
            self.assertLessEqual(pages(report), 1 + -(-rows // ROWS_OF_A_PAGE))


if __name__ == "__main__":
    unittest.main()
