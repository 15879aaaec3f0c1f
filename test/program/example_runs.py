"""The examples, each run once for all tests that look at its answer or its report.

ctest runs this file first (program.examples) and names the folder of the runs, TAUT_EXAMPLE_RUNS. A test that is started
alone has no such folder and runs what it asks for. TAUT_PROGRAM names the program, TAUT_SOURCE_DIR the source tree.
"""

import concurrent.futures
import dataclasses
import functools
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples"
FEWER = "TAUT_FEWER" in os.environ
# Under the sanitizers: one of each kind of motion and of the boom, beside the machines at rest.
FEW = ["mast_section.yaml", "motion/rope_break.yaml", "motion/skyline_load_drop.yaml", "motion/slewing_crane.yaml",
       "telescopic_boom/pretension.yaml"]


@dataclasses.dataclass(frozen=True)
class Run:
    code: int  # exit code
    screen: str  # what a terminal shows
    folder: pathlib.Path  # result.json, report.html, tables

    @functools.cached_property
    def result(self):
        return json.loads((self.folder / "result.json").read_text(encoding="utf-8"))

    @functools.cached_property
    def report(self):
        return (self.folder / "report.html").read_text(encoding="utf-8")


def names():
    """Every deck of examples/, as a path below it."""
    return sorted(p.relative_to(EXAMPLES).as_posix() for p in EXAMPLES.rglob("*.yaml") if not p.name.endswith(".part.yaml"))


def those_that_run():
    return [name for name in names() if not FEWER or name.startswith("machines/") or name in FEW]


def folder_of(place, name):
    return pathlib.Path(place) / name.removesuffix(".yaml").replace("/", "-")


def run(name, place):
    folder = folder_of(place, name)
    done = subprocess.run([os.environ["TAUT_PROGRAM"], "run", str(EXAMPLES / name), "-o", str(folder)], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "screen.json").write_text(json.dumps([done.returncode, done.stdout]), encoding="utf-8")


@functools.lru_cache(maxsize=None)
def own_place():
    return tempfile.TemporaryDirectory()


@functools.lru_cache(maxsize=None)
def of(name):
    """The run of an example: the one that is kept, or a new one."""
    folder = folder_of(os.environ.get("TAUT_EXAMPLE_RUNS") or own_place().name, name)
    if not (folder / "screen.json").exists():
        folder = folder_of(own_place().name, name)
        run(name, own_place().name)
    return Run(*json.loads((folder / "screen.json").read_text(encoding="utf-8")), folder)


def of_all(some):
    """Name and run of each, in their order; several at a time."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        yield from zip(some, pool.map(of, some))


def main():
    place = pathlib.Path(os.environ["TAUT_EXAMPLE_RUNS"])
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda name: run(name, place), those_that_run()))


if __name__ == "__main__":
    main()
