"""The scenes of perf/accuracy_cost, the paper's rock with physics left out, are cases of today: each passes `vug check`.

  accuracy_scenes.py VUG
"""
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "perf"))
sys.dont_write_bytecode = True
from accuracy import scenes  # noqa: E402

with tempfile.TemporaryDirectory() as folder:
    cases = scenes.write_cases(ROOT, pathlib.Path(folder))
    refused = []
    for name, case in cases:
        done = subprocess.run([sys.argv[1], "check", "--json", case], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            refused.append(f"{name}: {done.stderr.strip()}")
        elif json.loads(done.stdout)["bytes"] <= 0:
            refused.append(f"{name}: no memory")
    if refused:
        sys.exit("\n".join(refused))
