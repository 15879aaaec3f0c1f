"""The house style of what people read: lines of pages are short, links lead somewhere, pictures are small."""
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(os.environ["TAUT_SOURCE_DIR"])
LONGEST = 120  # characters of a line
LARGEST = 200_000  # bytes of a picture
GENERATED = "docs/guide/reference.md"  # made from the descriptions, with one key a line
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")


def anchors_of(page):
    """Anchors of the headings of a page, as forges make them."""
    heads = re.findall(r"(?m)^#+ (.*)$", page.read_text("utf-8"))
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


def wrong_links(page):
    for link in LINK.findall(page.read_text("utf-8")):
        if re.match(r"\w+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.exists():
            yield f"there is no {link}"
        elif anchor and target.suffix == ".md" and anchor not in anchors_of(target):
            yield f"{link}: there is no such heading"
        elif target.suffix in (".png", ".svg") and target.stat().st_size > LARGEST:
            yield f"{link}: {target.stat().st_size} bytes"


def main():
    wrong = []
    pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
    for page in pages:
        name = page.relative_to(ROOT)
        wrong += [f"{name}: {text}" for text in wrong_links(page)]
        if name.as_posix() == GENERATED:
            continue
        for number, line in enumerate(page.read_text("utf-8").splitlines(), 1):
            if len(line) > LONGEST:
                wrong.append(f"{name}:{number}: {len(line)} characters")
    tasks = ("skyline", "tackle", "boom", "mast", "motion", "design", "study", "report", "first-deck")
    for task in tasks:
        page = ROOT / f"docs/guide/{task}.md"
        if not page.exists() or "](../images/" not in page.read_text("utf-8"):
            wrong.append(f"docs/guide/{task}.md has no picture")
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
