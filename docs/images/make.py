#!/usr/bin/env python3
"""usage: make.py [--taut PROGRAM] [--only NAME] [--no-page]

Makes the pictures of the guides and of the README from reports of taut: docs/images/guide/*.svg, docs/images/report.png.
Each guide has a figure of one example deck; the figure is found in the report by its label, not by its place. The first
page of a report needs Chromium and pdftoppm; without them, or with --no-page, docs/images/report.png is left as it is.
Run it in any folder after the figures or the page of the report have changed:

    ./dev build taut_cli && docs/images/make.py
"""
import argparse
import html
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs/images"

# picture: example deck, beginnings of the labels of its figure (the first one that the report has); of a study no
# probabilities, which take thousands of cases more
FIGURES = {
    "first-deck": ("examples/machines/clamped_load.yaml", ("Side view",)),
    "skyline": ("examples/machines/skyline_over_terrain.yaml", ("Side view",)),
    "skyline-payload": ("examples/machines/skyline_over_terrain.yaml", ("The line and what it carries",)),
    "tackle": ("examples/machines/six_part_tackle.yaml", ("Side view",)),
    "boom": ("examples/boom_ropes.yaml", ("Ropes and pads along the boom", "The boom")),
    "mast": ("examples/mast_section.yaml", ("Mast",)),
    "motion": ("examples/motion/brake_stop.yaml", ("Over time: force", "Over time")),
    "study": ("examples/study/three_span_chance.yaml", ("What moves equilibrium.skyline.safety_factor",)),
    "design": ("examples/design/crane_hoist.yaml", ("Side view",)),
}
PAGE = "examples/machines/skyline_over_terrain.yaml"
LARGEST_PAGE = 200_000  # bytes

SVG = re.compile(r"<svg\b[^>]*>.*?</svg>", re.S)
FONTS = "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif"


def attribute(svg, name):
    found = re.match(r"<svg\b[^>]*?\b%s=\"([^\"]*)\"" % re.escape(name), svg)
    return html.unescape(found.group(1)) if found else ""


def figure_of(page, labels):
    """The svg whose label begins with one of the labels, tried in their order; None where the page has none."""
    figures = [svg for svg in SVG.findall(page) if attribute(svg, "aria-label")]
    for label in labels:
        for svg in figures:
            if attribute(svg, "aria-label").startswith(label):
                return svg
    return None


def rules_of(css):
    """(selectors, declarations) of the rules outside @media, @page and @font-face."""
    css = re.sub(r"/\*.*?\*/", "", css, flags=re.S)
    css = re.sub(r"@[^{}]*\{(?:[^{}]*\{[^{}]*\})*[^{}]*\}", "", css)
    return [(head.strip(), body.strip()) for head, body in re.findall(r"([^{}]+)\{([^{}]*)\}", css)]


def style_for(svg, css):
    """The rules of the page that concern the figure, with the values of variables in place of their names."""
    rules = rules_of(css)
    variables = {}
    for head, body in rules:
        if head == ":root":
            variables.update(re.findall(r"(--[\w-]+)\s*:\s*([^;]+)", body))
    own = set(attribute(svg, "class").split())
    classes = {c for group in re.findall(r'class="([^"]*)"', svg) for c in group.split()}
    elements = set(re.findall(r"<([a-zA-Z]+)", svg))
    kept = []
    for head, body in rules:
        selectors = []
        for selector in head.split(","):
            bare = re.sub(r"^\s*(?:figure\s+)?svg(?=[\s.])", "", selector).strip()
            names = set(re.findall(r"\.([\w-]+)", bare))
            tags = set(re.findall(r"(?:^|\s)([a-zA-Z]+)", bare))
            head_classes = set(re.findall(r"\.([\w-]+)", "".join(re.findall(r"svg([.\w-]*)", selector))))
            of_figure = "svg" in selector and ":" not in selector and head_classes <= own
            if of_figure and (names or tags) and names <= classes and tags <= elements:
                selectors.append(bare)
        if selectors:
            kept.append("%s{%s}" % (",".join(selectors), re.sub(r"\s+", " ", body)))
    text = "".join(kept)
    for _ in range(3):  # a variable may name another one
        text = re.sub(r"var\((--[\w-]+)(?:,[^()]*)?\)", lambda m: variables.get(m.group(1), "#222"), text)
    return "text{font-family:%s}" % FONTS + text.replace('"', "'")


def standing_alone(svg, css):
    """The figure as a file of its own: name space, white ground, its rules; inside comments and scripts left out."""
    svg = re.sub(r"<script\b.*?</script>", "", svg, flags=re.S)
    head, rest = re.match(r"(<svg\b[^>]*>)(.*)", svg, re.S).groups()
    if "xmlns=" not in head:
        head = head.replace("<svg", '<svg xmlns="http://www.w3.org/2000/svg"', 1)
    x, y, width, height = attribute(svg, "viewBox").split()
    ground = f'<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="#fff"/>'
    return f"{head}\n<style>{style_for(svg, css)}</style>\n{ground}\n{rest}\n"


def report_of(taut, deck, folder):
    study = "\nstudy:" in (ROOT / deck).read_text(encoding="utf-8")
    verb = ["study", "run", "--set", "study.answer=[quantiles, indices]"] if study else ["run"]
    done = subprocess.run([taut, *verb, deck, "-o", str(folder), "--quiet"], capture_output=True, text=True, cwd=ROOT,
                          check=False)
    if done.returncode not in (0, 4):
        sys.exit(f"{deck}: taut ends with {done.returncode}: {done.stderr}")
    return (folder / "report.html").read_text(encoding="utf-8")


def picture(taut, name, folder):
    """The text of docs/images/guide/NAME.svg."""
    deck, labels = FIGURES[name]
    page = report_of(taut, deck, folder)
    svg = figure_of(page, labels)
    if svg is None:
        there = ", ".join(repr(attribute(s, "aria-label")) for s in SVG.findall(page) if attribute(s, "aria-label"))
        sys.exit(f"{name}: the report on {deck} has no figure {' or '.join(labels)}; it has {there}")
    css = "\n".join(re.findall(r"<style[^>]*>(.*?)</style>", page, re.S))
    return standing_alone(svg, css)


def first_page(taut, folder):
    """docs/images/report.png: page 1 of a report; False where the programs for it are missing."""
    chromium = next((p for p in ("chromium", "chromium-browser", "google-chrome") if shutil.which(p)), None)
    if chromium is None or not shutil.which("pdftoppm"):
        return False
    report_of(taut, PAGE, folder)
    pdf = folder / "page.pdf"
    subprocess.run([chromium, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                    "--disable-background-networking", "--disable-component-update", "--disable-sync",
                    f"--user-data-dir={folder / 'profile'}", "--no-pdf-header-footer", f"--print-to-pdf={pdf}",
                    (folder / "report.html").as_uri()], check=True, capture_output=True, timeout=300)
    for dots in (100, 90, 80, 70, 60, 50):
        subprocess.run(["pdftoppm", "-r", str(dots), "-png", "-singlefile", "-f", "1", "-l", "1", str(pdf),
                        str(folder / "page")], check=True)
        if (folder / "page.png").stat().st_size <= LARGEST_PAGE:
            shutil.copyfile(folder / "page.png", IMAGES / "report.png")
            return True
    sys.exit(f"page 1 of the report on {PAGE} is over {LARGEST_PAGE} bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--taut", default=str(ROOT / "build/bin/taut"), help="the program; default: build/bin/taut")
    parser.add_argument("--only", choices=sorted(FIGURES), help="one picture")
    parser.add_argument("--no-page", action="store_true", help="without docs/images/report.png")
    options = parser.parse_args()
    for name in [options.only] if options.only else FIGURES:
        with tempfile.TemporaryDirectory() as folder:
            text = picture(options.taut, name, pathlib.Path(folder) / "out")
        (IMAGES / "guide" / f"{name}.svg").write_text(text, encoding="utf-8")
        print(f"docs/images/guide/{name}.svg: {len(text)} bytes")
    if options.only or options.no_page:
        return
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "out").mkdir()
        made = first_page(options.taut, pathlib.Path(folder) / "out")
    print("docs/images/report.png: " + ("made" if made else "left as it is; Chromium or pdftoppm is missing"))


if __name__ == "__main__":
    main()
