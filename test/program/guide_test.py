"""Guides and README are true: every command runs as typed, every quoted output appears, every deck shown runs.

A block is marked by its language and, where it needs one, by a comment on the line before it:

    ```sh            commands, one a line; each ends with exit code 0
    ```console       `$ command` and, below it, lines of its output in their order; `...` stands for any lines, or
                     inside a line for any text. A command ends with 0, or with the N of `# exit code N` behind it
    <!-- file: NAME -->   the block is the file NAME of the folder in which the commands run; a deck must have no mistake
    <!-- from: PATH -->   an excerpt: the lines of the block stand in that file in this order
    <!-- into: PATH -->   a part of a deck: that deck with this part in it has no mistake

The commands of one page run one after the other in one folder, with `taut` on the path, `build/bin/taut` and
`examples` where the page names them. TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree.
"""

import dataclasses
import importlib.util
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

PROGRAM = pathlib.Path(os.environ["TAUT_PROGRAM"]).resolve()
SOURCE = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]).resolve()
# Under the sanitizers this study takes minutes: thousands of cases of importance sampling.
LEFT_OUT = "taut study run examples/study/three_span_chance.yaml -o out" if "TAUT_FEWER" in os.environ else None
PAGES = sorted(p for p in (SOURCE / "docs/guide").glob("*.md") if p.name != "reference.md") + [SOURCE / "README.md"]

# ./dev builds and installs: its commands must be in `./dev help`, and are not run here
DEV = re.compile(r"^\./dev (\w+)")
BLOCK = re.compile(r"(?:<!-- (file|from|into): (\S+) -->\n)?^```(\w*)\n(.*?)^```$", re.S | re.M)
# pieces of decks that are shown by themselves: one line of a comment
SCHEMA_LINE = re.compile(r"^# yaml-language-server: \S+\n$")


@dataclasses.dataclass
class Block:
    role: str  # file, from, into, or empty
    path: str
    language: str
    text: str


def blocks_of(page):
    return [Block(*(group or "" for group in found.groups())) for found in BLOCK.finditer(page.read_text("utf-8"))]


@dataclasses.dataclass
class Command:
    text: str
    code: int
    output: list  # lines that are quoted

    @staticmethod
    def of(line):
        found = re.search(r"\s+# exit code (\d+)$", line)
        return Command(line[: found.start()] if found else line, int(found.group(1)) if found else 0, [])


def commands_of(block):
    commands = []
    for line in block.text.splitlines():
        if block.language == "sh":
            if line.strip() and not line.startswith("#"):
                commands.append(Command.of(line))
        elif line.startswith("$ "):
            commands.append(Command.of(line[2:]))
        elif commands:
            commands[-1].output.append(line)
        else:
            raise AssertionError(f"output before a command: {line}")
    return commands


def pattern_of(line):
    return re.compile(r".*?".join(re.escape(part) for part in line.rstrip().split("...")) + r"\s*$")


def missing_line(quoted, output):
    """The first quoted line that does not appear in its order; None where all do."""
    at = 0
    anywhere = False
    for line in quoted:
        if line.strip() == "...":
            anywhere = True
            continue
        wanted = pattern_of(line)
        while at < len(output) and anywhere and not wanted.match(output[at]):
            at += 1
        if at == len(output) or not wanted.match(output[at]):
            return line
        at += 1
        anywhere = False
    return None


def lines_missing_in(excerpt, whole):
    """Lines of an excerpt that do not follow in the file, blanks at their ends aside."""
    there = [line.strip() for line in whole.splitlines()]
    missing, at = [], 0
    for line in (line.strip() for line in excerpt.splitlines()):
        if line in there[at:]:
            at = there.index(line, at) + 1
        elif line:
            missing.append(line)
    return missing


class Guides(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.place = pathlib.Path(self.folder.name)
        (self.place / "build/bin").mkdir(parents=True)
        (self.place / "build/bin/taut").symlink_to(PROGRAM)
        (self.place / "examples").symlink_to(SOURCE / "examples")
        path = f"{self.place / 'build/bin'}{os.pathsep}{os.environ.get('PATH', '')}"
        self.environment = dict(os.environ, PATH=path, LC_ALL="C.UTF-8", NO_COLOR="1")

    def shell(self, command):
        return subprocess.run(["bash", "-c", command], cwd=self.place, env=self.environment, capture_output=True,
                              text=True, check=False)

    def test_every_command_runs_as_typed(self):
        dev_help = subprocess.run([SOURCE / "dev", "help"], capture_output=True, text=True, check=True).stdout
        count = 0
        for page in PAGES:
            for block in blocks_of(page):
                if block.role == "file":
                    (self.place / block.path).write_text(block.text, encoding="utf-8")
                if block.language not in ("sh", "console"):
                    continue
                for command in commands_of(block):
                    count += 1
                    with self.subTest(page=page.name, command=command.text):
                        self.check(command, dev_help)
        self.assertGreater(count, 25)

    def check(self, command, dev_help):
        if found := DEV.match(command.text):
            self.assertRegex(dev_help, rf"(?m)^  {found.group(1)}\b")
            return
        if command.text == LEFT_OUT:
            return
        done = self.shell(command.text)
        self.assertEqual(done.returncode, command.code, done.stderr)
        # a terminal shows both
        lines = (done.stderr + done.stdout).splitlines() if done.returncode == 2 else done.stdout.splitlines()
        missing = missing_line(command.output, lines)
        self.assertIsNone(missing, f"not in the output:\n{done.stdout}{done.stderr}")

    def test_every_deck_shown_is_a_deck(self):
        for page in PAGES:
            for block in (b for b in blocks_of(page) if b.language == "yaml"):
                with self.subTest(page=page.name, block=block.text[:60]):
                    self.check_deck(block)

    def check_deck(self, block):
        if block.role == "from":
            self.assertEqual(lines_missing_in(block.text, (SOURCE / block.path).read_text("utf-8")), [])
            return
        if SCHEMA_LINE.match(block.text) or block.role == "" and not block.text.startswith("taut: 1"):
            self.assertTrue(SCHEMA_LINE.match(block.text) or ROW.fullmatch(block.text.strip()),
                            "a part of a deck says which deck it is of: from, into")
            return
        deck = self.place / "shown.yaml"
        head = f"include: {block.path}\n" if block.role == "into" else ""
        deck.write_text(head + block.text, encoding="utf-8")
        done = self.shell("taut check shown.yaml")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_every_picture_is_made_from_a_report(self):
        """What docs/images/make.py does, without writing: the figures that it names are in the reports."""
        spec = importlib.util.spec_from_file_location("make", SOURCE / "docs/images/make.py")
        make = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(make)
        for name in make.FIGURES:
            with self.subTest(picture=name), tempfile.TemporaryDirectory() as folder:
                text = make.picture(str(PROGRAM), name, pathlib.Path(folder) / "out")
                root = xml.etree.ElementTree.fromstring(text)
                self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
                self.assertNotIn("var(", text)
                self.assertLess(len(text), 100_000)
                self.assertTrue((SOURCE / f"docs/images/guide/{name}.svg").is_file())

    def test_the_checks_themselves(self):
        output = ["a 1", "b 2", "c 3"]
        self.assertIsNone(missing_line(["a 1", "...", "c ..."], output))
        self.assertIsNone(missing_line(["...", "b 2"], output))
        self.assertEqual(missing_line(["a 1", "c 3"], output), "c 3")
        self.assertEqual(missing_line(["...", "c 3", "...", "a 1"], output), "a 1")
        self.assertEqual(missing_line(["a"], output), "a")
        self.assertEqual(lines_missing_in("b\n a\n", "a\nb\na\n"), [])
        self.assertEqual(lines_missing_in("b\na\n", "a\nb\n"), ["a"])


# names of ropes, sections and steels, each on its line: catalogues.md
ROW = re.compile(r"(?:(?:rope|section|steel): [^\n]*\n?)+")

if __name__ == "__main__":
    unittest.main()
