"""The stubs of the Python package are those of the descriptions: each names the schema that they were made with."""

import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path

FOLDER = Path(os.environ["TAUT_SOURCE_DIR"]) / "python/taut"
schema = subprocess.run([os.environ["TAUT_PROGRAM"], "schema"], capture_output=True, check=True).stdout.strip()
now = hashlib.sha256(schema).hexdigest()
stale = []
for name in ("_analyses.pyi", "_parts.pyi", "methods.pyi"):
    found = re.search(r"^schema: ([0-9a-f]{64})$", (FOLDER / name).read_text(encoding="utf-8"), re.MULTILINE)
    if found is None or found.group(1) != now:
        stale.append(name)
if stale:
    sys.exit(f"stale: {', '.join(stale)}; run ./dev python stub")
