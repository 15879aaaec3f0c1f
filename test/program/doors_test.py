#!/usr/bin/env python3
"""Completion, man page, PDF and browser: what the command line offers beside the calculation.

TAUT_PROGRAM names the program. Shells, man readers and Chromium that are not installed are skipped.
"""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from decks import MAST

PROGRAM = os.environ["TAUT_PROGRAM"]
CHROMIUM = next((c for c in ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
                 if shutil.which(c)), None)
# A browser in place of Chromium: it writes a small whole PDF.
FAKE = """#!/bin/sh
for one; do case $one in --print-to-pdf=*) to=${one#*=};; esac; done
printf '%s\\n' "$@" > "$0.arguments"
printf '%%PDF-1.4\\nstartxref\\n9\\n%%%%EOF\\n' > "$to"
"""


def taut(*args, **more):
    return subprocess.run([PROGRAM, *map(str, args)], capture_output=True, text=True, check=False, **more)


def verbs():
    listed = re.findall(r"^  (\w+) +\S", taut("help").stdout.split("\n\n")[0], re.M)
    assert len(listed) > 8, listed
    return listed


def options(verb):
    """Every option in the help of a verb."""
    text = taut("help", verb).stdout
    block = text.split("\nOptions:\n", 1)[1].split("\n\n", 1)[0]
    return {o for line in block.splitlines() for o in re.findall(r"--?[a-z][\w-]*", line[:29].split(" ")[2])}


class Completion(unittest.TestCase):
    def test_every_verb_and_option_is_in_every_script(self):
        scripts = {shell: taut("completion", shell).stdout for shell in ("bash", "zsh", "fish")}
        for verb in verbs():
            found = options(verb)
            self.assertIn("--help", found, verb)
            bash = re.search(rf"^    {verb}\)\n      options='([^']*)'", scripts["bash"], re.M)
            self.assertEqual(set(bash[1].split()), found, verb)
            zsh = re.search(rf"^        {verb}\)\n(.*?)\n          ;;", scripts["zsh"], re.M | re.S)[1]
            fish = re.findall(rf"^complete -c taut -n '__fish_seen_subcommand_from {verb}'(.*)", scripts["fish"], re.M)
            for option in found:
                self.assertRegex(zsh, rf"['{{,]{option}[='}},]", verb)
                spelled = f" -l {option[2:]} " if option.startswith("--") else f" -s {option[1:]} "
                self.assertTrue(any(spelled in line for line in fish), (verb, option))

    def test_an_unknown_shell(self):
        done = taut("completion", "zhs")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("there is no completion for 'zhs'; did you mean 'zsh'?; the shells are bash, fish, zsh", done.stderr)

    def complete(self, *words, folder="."):
        script = 'source <("$0" completion bash); COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _taut; ' \
                 'printf "%s\\n" "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-c", script, PROGRAM, *words], capture_output=True, text=True, check=True,
                              cwd=folder)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.split("\n")) - {""}

    def test_bash(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for deck in ("loop.yaml", "my loop.yml", "notes.txt"):
                (folder / deck).write_text("")
            (folder / "out").mkdir()
            decks = {"loop.yaml", "my loop.yml", "out"}
            self.assertEqual(self.complete("taut", "", folder=name), set(verbs()) | {"-h", "--help", "--version"})
            self.assertEqual(self.complete("taut", "ch"), {"check"})
            self.assertEqual(self.complete("taut", "run", "", folder=name), decks)
            self.assertEqual(self.complete("taut", "run", "--set", "a", "=", "5", "l", folder=name), {"loop.yaml"})
            self.assertEqual(self.complete("taut", "run", "-o", "", folder=name), {"out"})
            self.assertEqual(self.complete("taut", "run", "loop.yaml", "--output", "=", "o", folder=name), {"out"})
            self.assertEqual(self.complete("taut", "run", "loop.yaml", "", folder=name), set())
            self.assertEqual(self.complete("taut", "run", "--a"), {"--all"} | {o for o in options("run") if o.startswith("--a")})
            self.assertEqual(self.complete("taut", "export", ""), {"vtk"})
            self.assertEqual(self.complete("taut", "export", "vtk", "", folder=name), decks)
            self.assertEqual(self.complete("taut", "nothing", ""), set())
        self.assertIn("closed_loop", self.complete("taut", "new", "clo"))
        self.assertIn("six_part_tackle", self.complete("taut", "new", "six"))
        self.assertLessEqual({"ropes", "rope_loads"}, self.complete("taut", "explain", "rope"))
        self.assertEqual(self.complete("taut", "list", "s"), {"sections", "steels"})
        self.assertEqual(self.complete("taut", "list", "ropes", "--core", "F"), {"FC"})
        self.assertEqual(self.complete("taut", "help", "sch"), {"schema"})
        for verb, place in (("new", "STARTER"), ("list", "LIST")):
            names = self.complete("taut", verb, "")
            self.assertGreater(len(names), 5, place)
            for name in names:
                self.assertEqual(taut(verb, name).returncode, 0, name)
        for name in self.complete("taut", "explain", ""):
            self.assertEqual(taut("explain", name).returncode, 0, name)

    @unittest.skipUnless(shutil.which("fish"), "fish is not installed")
    def test_fish(self):
        with tempfile.TemporaryDirectory() as name:
            (pathlib.Path(name) / "loop.yaml").write_text("")
            (pathlib.Path(name) / "out").mkdir()
            (pathlib.Path(name) / "taut.fish").write_text(taut("completion", "fish").stdout)

            def complete(line):
                done = subprocess.run(["fish", "--no-config", "-c", f"source taut.fish; complete -C '{line}'"], cwd=name,
                                      capture_output=True, text=True, check=True)
                self.assertEqual(done.stderr, "")
                return {found.split("\t")[0] for found in done.stdout.splitlines()}

            self.assertEqual(complete("taut "), set(verbs()))
            self.assertIn("loop.yaml", complete("taut run l"))
            self.assertEqual(complete("taut run loop.yaml -o o"), {"out/"})
            self.assertEqual(complete("taut list ropes --core F"), {"FC"})
            self.assertIn("closed_loop", complete("taut new clo"))
            self.assertIn("--pdf", complete("taut run --p"))

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh(self):
        with tempfile.TemporaryDirectory() as name:
            (pathlib.Path(name) / "_taut").write_text(taut("completion", "zsh").stdout)
            # compinit reads the file as it does at the start of a shell; _taut itself needs a line editor
            script = "autoload -Uz compinit && compinit -u -D; print $_comps[taut]; " \
                     "_arguments() { print -r -- called; state=verb }; _describe() { print -rl -- $verbs }; _taut"
            done = subprocess.run(["zsh", "-f", "-c", f"fpath=({name} $fpath); {script}"], capture_output=True, text=True,
                                  check=False)
        self.assertEqual(done.stderr, "")
        lines = done.stdout.splitlines()
        self.assertEqual(lines[:2], ["_taut", "called"])
        self.assertEqual([line.split(":")[0] for line in lines[2:]], verbs())


class ManPage(unittest.TestCase):
    def setUp(self):
        done = taut("man", env={**os.environ, "SOURCE_DATE_EPOCH": "1770940800"})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.page = done.stdout

    def test_every_verb_and_option_is_described(self):
        self.assertIn('.TH TAUT 1 "2026-02-13"', self.page)
        parts = dict(re.findall(r'^\.SS "(\w+)"\n(.*?)(?=^\.S[SH] )', self.page, re.M | re.S))
        self.assertEqual(list(parts), verbs())
        for verb, part in parts.items():
            self.assertIn(f"\\fBtaut\\fR \\fB{verb}\\fR", part)
            tags = set(re.findall(r"\\fB(\\-\S*?)\\fR", "\n".join(re.findall(r"\.TP\n(.*)", part))))
            found = {tag.replace("\\", "") for tag in tags}
            self.assertEqual(found, options(verb) - {"-h", "--help"}, verb)
        for section in ("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "FILES", "ENVIRONMENT", "EXAMPLES"):
            self.assertIn(f"\n.SH {section}\n", self.page)
        for name in ("NO_COLOR", "BROWSER", "TAUT_CHROMIUM", ".taut\\-files"):
            self.assertIn(name, self.page)

    def test_its_examples_run_as_typed(self):
        block = self.page.split(".SH EXAMPLES\n")[1]
        commands = [c.replace("\\&", "").replace("\\-", "-") for c in re.findall(r"^\.TP\n\\fB(.*)\\fR$", block, re.M)]
        self.assertGreater(len(commands), 3)
        with tempfile.TemporaryDirectory() as name:
            bin_folder = pathlib.Path(name) / "bin"
            bin_folder.mkdir()
            (bin_folder / "taut").symlink_to(PROGRAM)
            (bin_folder / "chromium").write_text(FAKE)
            (bin_folder / "xdg-open").write_text("#!/bin/sh\n")
            for tool in ("chromium", "xdg-open"):
                (bin_folder / tool).chmod(0o755)
            env = {**os.environ, "PATH": f"{bin_folder}:{os.environ['PATH']}", "DISPLAY": ":0"}
            env.pop("TAUT_CHROMIUM", None)
            env.pop("BROWSER", None)
            for command in commands:
                done = subprocess.run(["bash", "-c", command], cwd=name, env=env, capture_output=True, text=True, check=False)
                self.assertIn(done.returncode, (0, 4), f"{command}\n{done.stderr}")
                self.assertNotIn("taut:", done.stderr, command)
            self.assertTrue((pathlib.Path(name) / "out" / "report.pdf").exists())

    def test_readers_do_not_complain(self):
        readers = {"mandoc": ["-Tlint"], "groff": ["-man", "-Tutf8", "-ww", "-z"]}
        there = {reader: args for reader, args in readers.items() if shutil.which(reader)}
        if not there:
            self.skipTest("neither mandoc nor groff is installed")
        for reader, args in there.items():
            done = subprocess.run([reader, *args], input=self.page, capture_output=True, text=True, check=False)
            self.assertEqual(done.stdout + done.stderr, "", reader)

    def test_the_codes_are_those_of_the_help(self):
        codes = re.findall(r"^  (\d+) +(\S.*)$", taut("run", "--help").stdout.split("Exit codes:")[1], re.M) or \
            re.findall(r"^  (\d+) +(\S.*)$", taut("--help").stdout.split("Exit codes:")[1], re.M)
        self.assertEqual([int(c) for c, _ in codes], [0, 1, 2, 3, 4, 5, 130])
        block = self.page.split(".SH EXIT STATUS\n")[1].split("\n.SH ")[0]
        block = block.replace("\\-", "-").replace("\n", " ")
        for code, words in codes:
            self.assertIn(f"\\fB{code}\\fR {words}", block)


class Report(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.top = pathlib.Path(self.scratch.name)
        (self.top / "tmp").mkdir()
        (self.top / "mast.yaml").write_text(MAST)
        self.env = {**os.environ, "TMPDIR": str(self.top / "tmp")}
        for name in ("BROWSER", "TAUT_CHROMIUM", "DISPLAY", "WAYLAND_DISPLAY"):
            self.env.pop(name, None)

    def tearDown(self):
        self.assertEqual(list((self.top / "tmp").iterdir()), [], "scratch folders are removed")
        self.scratch.cleanup()

    def tool(self, name, text):
        path = self.top / name
        path.write_text(text)
        path.chmod(0o755)
        return path

    def run_mast(self, *args, **env):
        return taut("run", "mast.yaml", *args, cwd=self.top, env={**self.env, **{k: str(v) for k, v in env.items()}})

    def files(self, folder="out"):
        return {p.name for p in (self.top / folder).iterdir()}

    def test_pdf_belongs_to_the_folder(self):
        fake = self.tool("fake", FAKE)
        done = self.run_mast("-o", "out", "--pdf", TAUT_CHROMIUM=fake)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("report: out/report.html and report.pdf\n", done.stderr)
        self.assertIn("report.pdf", self.files())
        self.assertIn("report.pdf", (self.top / "out" / ".taut-files").read_text().splitlines())
        given = (self.top / "fake.arguments").read_text().splitlines()
        self.assertEqual("--no-sandbox" in given, os.geteuid() == 0)
        self.assertIn("--disable-background-networking", given)
        # the next run without it takes it away, as every file of an earlier result
        self.assertEqual(self.run_mast("-o", "out", "-q").returncode, 0)
        self.assertNotIn("report.pdf", self.files())
        # somebody else's is not touched
        (self.top / "out" / "report.pdf").write_text("mine")
        done = self.run_mast("-o", "out", "-q", "--pdf", TAUT_CHROMIUM=fake)
        self.assertEqual(done.returncode, 5)
        self.assertIn("report.pdf in it is not of an earlier run", done.stderr)
        self.assertEqual((self.top / "out" / "report.pdf").read_text(), "mine")

    def test_without_chromium_the_rest_is_written(self):
        for env, words in (({"PATH": str(self.top)}, "Install Debian's package chromium"),
                           ({"TAUT_CHROMIUM": "/no/where"}, "TAUT_CHROMIUM names '/no/where'"),
                           ({"TAUT_CHROMIUM": self.tool("bad", "#!/bin/sh\necho no display >&2\nexit 3\n")}, "no display")):
            done = self.run_mast("-o", "out", "--pdf", **env)
            self.assertEqual(done.returncode, 5, done.stderr)
            self.assertIn(words, done.stderr)
            self.assertIn("report.pdf is not written", done.stderr)
            self.assertTrue(done.stdout.splitlines()[-1].startswith("Passes"), "the verdict is the last line")
            self.assertLessEqual({"result.json", "report.html"}, self.files())
            self.assertNotIn("report.pdf", self.files())

    def test_both_need_a_folder(self):
        for option in ("--pdf", "--open"):
            done = self.run_mast(option)
            self.assertEqual(done.returncode, 2)
            self.assertIn("--output", done.stderr)

    def test_a_bad_deck_has_neither(self):
        (self.top / "mast.yaml").write_text(MAST.replace("100 kN", "100"))
        done = self.run_mast("-o", "out", "--pdf", "--open", TAUT_CHROMIUM=self.tool("fake", FAKE), BROWSER="false")
        self.assertEqual(done.returncode, 2)
        self.assertFalse((self.top / "out").exists())
        self.assertNotIn("--open", done.stderr)

    def test_an_interrupt_ends_chromium_and_keeps_the_result(self):
        slow = self.tool("slow", '#!/bin/sh\necho $$ > "$0.pid"\nexec sleep 1000\n')
        running = subprocess.Popen([PROGRAM, "run", "mast.yaml", "-q", "-o", "out", "--pdf"], cwd=self.top,
                                   env={**self.env, "TAUT_CHROMIUM": str(slow)}, stderr=subprocess.PIPE, text=True)
        pid = self.top / "slow.pid"
        while running.poll() is None and not (pid.exists() and pid.read_text().strip()):
            time.sleep(0.02)
        running.send_signal(signal.SIGINT)
        said = running.communicate()[1]
        self.assertEqual(running.returncode, 130, said)
        self.assertIn("interrupted", said)
        self.assertFalse(pathlib.Path(f"/proc/{pid.read_text().strip()}").exists())
        self.assertIn("report.html", self.files())
        self.assertNotIn("report.pdf", self.files())

    @unittest.skipUnless(CHROMIUM, "no Chromium is installed")
    def test_chromium_prints(self):
        folder = 'Ergebnis "ä" #1 %41 & $(x)'
        title = """title=it's "quoted" <b> \u00e4 & $(date)"""
        done = self.run_mast("-q", "-o", folder, "--pdf", "--set", title)
        self.assertEqual(done.returncode, 0, done.stderr)
        pdf = (self.top / folder / "report.pdf").read_bytes()
        self.assertTrue(pdf.startswith(b"%PDF-"))
        self.assertGreaterEqual(len(re.findall(rb"/Type\s*/Page\b", pdf)), 2)
        boxes = {tuple(float(x) for x in box.split()) for box in re.findall(rb"/MediaBox\s*\[([^\]]*)\]", pdf)}
        for left, bottom, right, top in boxes:
            self.assertAlmostEqual(right - left, 595.28, delta=1)
            self.assertAlmostEqual(top - bottom, 841.89, delta=1)
        self.assertEqual(self.files(folder) - self.files_without_pdf(folder), {"report.pdf"})

    def files_without_pdf(self, folder):
        self.assertEqual(self.run_mast("-q", "-o", folder).returncode, 0)
        return self.files(folder)

    def test_open_leaves_the_browser_running(self):
        self.tool("browser", '#!/bin/sh\nprintf "%s\\n" "$@" > "$0.arguments"\n'
                             'while [ ! -e "$0.go" ]; do sleep 0.05; done\necho end > "$0.end"\n')
        done = self.run_mast("-q", "-o", "my out", "--open", BROWSER="no-such-browser:./browser --new %s")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        end = self.top / "browser.end"
        self.assertFalse(end.exists(), "taut has not waited for it")
        (self.top / "browser.go").write_text("")
        while not end.exists():
            time.sleep(0.02)
        address = f"file://{self.top.resolve()}/my%20out/report.html"
        self.assertEqual((self.top / "browser.arguments").read_text().splitlines(), ["--new", address])

    def test_open_by_xdg_open(self):
        self.tool("xdg-open", '#!/bin/sh\necho "$@" > "$0.arguments"\n')
        done = self.run_mast("-q", "-o", "out", "--open", PATH=f"{self.top}:{os.environ['PATH']}", DISPLAY=":0")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("/out/report.html", (self.top / "xdg-open.arguments").read_text())

    def test_what_cannot_open_is_said(self):
        self.tool("xdg-open", "#!/bin/sh\nexit 3\n")
        path = f"{self.top}:{os.environ['PATH']}"
        for env, words in (({"BROWSER": "no-such-browser"}, "no program can be run"),
                           ({"BROWSER": "false"}, "ended with 1"),
                           ({"PATH": path}, "there is no display"),
                           ({"PATH": path, "DISPLAY": ":0"}, "ended with 3"),
                           ({"PATH": "/nowhere"}, "package xdg-utils")):
            done = self.run_mast("-q", "-o", "out", "--open", **env)
            self.assertEqual(done.returncode, 0, "the result is there")
            self.assertIn(words, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
            self.assertIn("out/report.html", done.stderr)


class Pipes(unittest.TestCase):
    def test_a_closed_pipe_is_silent(self):
        with tempfile.TemporaryDirectory() as name:
            (pathlib.Path(name) / "mast.yaml").write_text(MAST)
            for words in ('run mast.yaml -o out -a 2>err', "list ropes 2>err", "man 2>err", "completion zsh 2>err",
                          "schema 2>err", "help 2>err"):
                script = f'set -o pipefail; "$0" {words} | head -n 1'
                done = subprocess.run(["bash", "-c", script, PROGRAM], cwd=name, capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stdout.count("\n")), (0, 1), words)
                said = (pathlib.Path(name) / "err").read_text()
                self.assertEqual(said, "report: out/report.html\n" if words.startswith("run") else "", words)

    def test_a_set_value_does_not_take_the_deck(self):
        with tempfile.TemporaryDirectory() as name:
            (pathlib.Path(name) / "mast.yaml").write_text(MAST)
            done = taut("run", "-q", "--set", "title=x", "mast.yaml", cwd=name)
            self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
