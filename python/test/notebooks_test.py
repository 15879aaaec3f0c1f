"""The notebooks of examples/python: made of their programs, typed, executed, with pictures."""

import base64
import os
import subprocess
import sys
import unittest
from pathlib import Path

import nbclient
import nbformat

SOURCE = Path(os.environ["TAUT_SOURCE_DIR"])
BUILD = Path(os.environ["TAUT_BUILD_DIR"])
FOLDER = SOURCE / "examples/python"
TITLES = sorted(one.stem for one in FOLDER.glob("*.py"))


class Notebooks(unittest.TestCase):
    def test_they_are_made_of_their_programs(self):
        command = [sys.executable, SOURCE / "python/tools/make_notebooks.py", "--check", FOLDER]
        self.assertEqual(subprocess.run(command, check=False).returncode, 0)

    def test_strict_types(self):
        command = [sys.executable, "-m", "mypy", "--strict", "--config-file", SOURCE / "pyproject.toml",
                   "--cache-dir", BUILD / "mypy"]
        for title in TITLES:  # each a program of its own
            done = subprocess.run([*command, FOLDER / f"{title}.py"], capture_output=True, text=True, check=False,
                                  env={**os.environ, "MYPYPATH": os.environ["PYTHONPATH"]})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_they_run(self):
        (BUILD / "notebooks").mkdir(exist_ok=True)
        # they draw into the notebook, whatever the backend of the tests is
        os.environ.pop("MPLBACKEND", None)
        for title in TITLES:
            with self.subTest(title):
                book = nbformat.read(FOLDER / f"{title}.ipynb", as_version=4)
                client = nbclient.NotebookClient(book, timeout=1800, kernel_name="python3",
                                                 resources={"metadata": {"path": str(FOLDER)}})
                client.execute()
                nbformat.write(book, BUILD / "notebooks" / f"{title}.ipynb")
                pictures = [output["data"]["image/png"] for cell in book.cells if cell.cell_type == "code"
                            for output in cell.outputs if "image/png" in output.get("data", {})]
                for i, picture in enumerate(pictures):
                    (BUILD / "notebooks" / f"{title}-{i}.png").write_bytes(base64.b64decode(picture))
                if "plt.show()" in (FOLDER / f"{title}.py").read_text():
                    self.assertTrue(pictures)


if __name__ == "__main__":
    unittest.main()
