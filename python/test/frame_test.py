"""A result in a notebook: the report is seen, and the notebook's own style stays as it is. Needs Chromium."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import taut

CHROMIUM = shutil.which("chromium")
BUILD = Path(os.environ["TAUT_BUILD_DIR"])
NOTEBOOK = """<!doctype html><html><head><style>html {{overflow-y: scroll}} body {{font: 14px serif}} h1 {{color: rgb(1, 2, 3)}}</style></head>
<body><h1>A notebook</h1><p>text</p><table><tr><td>cell</td></tr></table><pre>code</pre>{frame}<script>
addEventListener("load", () => setTimeout(() => {{
  const styles = [];
  for (const one of document.querySelectorAll("html, body, h1, p, table, td, pre")) {{
    const style = getComputedStyle(one);
    for (const name of style) if (!/height|size|origin|inset/.test(name)) styles.push(name + style.getPropertyValue(name));
  }}
  const ours = document.createElement("output");
  ours.textContent = styles.join("|") + "|" + document.styleSheets.length + "|" + Object.keys(window).length;
  document.body.append(ours);
}}, 300));
</script></body></html>"""


@unittest.skipUnless(CHROMIUM, "chromium is not installed: the frame was not looked at")
class Frame(unittest.TestCase):
    def chromium(self, page, *what):
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder) / "page.html"
            place.write_text(page, encoding="utf-8")
            command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/user",
                       "--virtual-time-budget=3000", *what, f"file://{place}"]
            return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    def test_the_style_of_the_notebook_does_not_change(self):
        frame = taut.run(taut.new("mast_section"))._repr_html_()
        seen = []
        for content in ("", frame):
            page = self.chromium(NOTEBOOK.format(frame=content), "--dump-dom")
            seen.append(re.search(r"<output>(.*?)</output>", page, re.DOTALL).group(1))
        self.assertIn("rgb(1, 2, 3)", seen[0])
        self.assertEqual(*(re.sub(r"\|\d+$", "", one) for one in seen))
        picture = BUILD / "frame.png"
        self.chromium(NOTEBOOK.format(frame=frame), f"--screenshot={picture}", "--window-size=1000,900")
        self.assertGreater(picture.stat().st_size, 20000)


if __name__ == "__main__":
    unittest.main()
