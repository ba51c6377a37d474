"""Runs every block of docs/python.md, in one session and an empty folder: page.py PAGE."""
import os
import pathlib
import re
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "python"))
os.environ["VUG"] = str(pathlib.Path(os.environ["VUG"]).resolve())

import warnings

import matplotlib
import vug

matplotlib.use("Agg")
warnings.filterwarnings("error", ".* is outside ", vug.VugWarning)  # the page mentions none
page = root / sys.argv[1]
text = page.read_text(encoding="utf-8")
session = {}
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    os.symlink(root / "cases", "cases")
    blocks = list(re.finditer(r"^```python\n(.*?)^```", text, re.S | re.M))
    for block in blocks:
        line = text.count("\n", 0, block.start(1))
        exec(compile("\n" * line + block.group(1), str(page), "exec"), session)  # so that a trace names the page's line
    for name in ("porosity.png", "two_fields.png", "fracture.gif"):
        assert pathlib.Path(name).stat().st_size > 5000, name
    if os.environ.get("VUG_KEEP_PLOTS"):
        os.system(f"cp *.png *.gif '{os.environ['VUG_KEEP_PLOTS']}'")
print(f"{len(blocks)} blocks")
