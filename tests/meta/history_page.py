"""Every column of the histories of the recorded examples is one that docs/history.md tells of, and the reverse."""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
sys.dont_write_bytecode = True

from vug.history import name_and_unit  # noqa: E402

NOT_RECORDED = {"slit_nodes", "flow_held_steps", "<surface>_mass_flow", "<surface>_<species>_mean",
                "dissolution_factor", "dissolution_error", "<what>_interval"}  # columns that no recorded example has

OF_CASES = {"<gauge>", "<probe>_<field>"}  # any name: no recorded example has one

told = re.findall(r"`([^`]+)`", "".join(line.split("|")[1] for line in (ROOT / "docs/history.md").read_text().splitlines()
                                        if line.startswith("| ")))
told = [name for name in told if name not in OF_CASES]
patterns = [re.compile(re.sub(r"X|<\w+>", ".+", name)) for name in told]
columns = {name_and_unit(column)[0] for record in (ROOT / "tests/regression/values").glob("*.json")
           for column in json.loads(record.read_text())["history"] if ":" not in column}  # those are of other files
columns -= {"rows"}  # their number
missing = [f"does not tell of {column}" for column in sorted(columns) if not any(p.fullmatch(column) for p in patterns)]
told_of = dict(zip(told, patterns))
unknown = {name for name, pattern in told_of.items()  # a quantity X of the ledger has columns X_stored and others
           if not any(pattern.fullmatch(c) or pattern.fullmatch(c.removesuffix("_stored")) for c in columns)}
missing += [f"tells of {name}, which no recorded example has" for name in sorted(unknown - NOT_RECORDED)]
missing += [f"does not tell of {name}, or an example has it: NOT_RECORDED of this test" for name in sorted(NOT_RECORDED - unknown)]
if len(columns) < 50:
    sys.exit("too few columns found to be right")
sys.exit("\n".join(f"docs/history.md {what}" for what in missing) or 0)
