"""Every column of the histories of the recorded examples is one that docs/history.md tells of."""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
sys.dont_write_bytecode = True

from vug.history import name_and_unit  # noqa: E402

told = re.findall(r"`([^`]+)`", "".join(line.split("|")[1] for line in (ROOT / "docs/history.md").read_text().splitlines()
                                        if line.startswith("| ")))
patterns = [re.compile(re.sub(r"X|<\w+>", ".+", name)) for name in told]
columns = {name_and_unit(column)[0] for record in (ROOT / "tests/regression/values").glob("*.json")
           for column in json.loads(record.read_text())["history"] if ":" not in column}  # those are of other files
columns -= {"rows"}  # their number
missing = sorted(column for column in columns if not any(pattern.fullmatch(column) for pattern in patterns))
if len(columns) < 50:
    sys.exit("too few columns found to be right")
sys.exit("\n".join(f"docs/history.md does not tell of {column}" for column in missing) or 0)
