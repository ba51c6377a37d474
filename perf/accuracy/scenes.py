"""Model only what a scene requires: the paper's rock with physics left out, its memory and its time."""
import json
import re
import subprocess

CASE = "cases/acid_fracturing/coarse/p30_da1.5e-3.toml"
# name, the tables that go, and the conditions of the sides that go with them
SCENES = [
    ("all", (), ()),
    ("without mechanics", ("mechanics", "damage"), ("traction",)),
    ("without heat", ("heat",), ("heat",)),
    ("without reaction", ("reaction",), ()),
    ("without solutes", ("solute", "reaction"), ("solute",)),
    ("without flow", ("flow", "damage"), ("flow",)),
    ("flow alone", ("heat", "solute", "reaction", "mechanics", "damage"), ("heat", "solute", "traction")),
    ("heat alone", ("flow", "solute", "reaction", "mechanics", "damage"), ("flow", "solute", "traction")),
    ("mechanics alone", ("flow", "heat", "solute", "reaction", "damage"), ("flow", "heat", "solute")),
]
STEPS = 2000


def without(text, tables, conditions):
    """A case without some of its tables, and without those conditions of its sides."""
    if "reaction" in tables:
        conditions = (*conditions, "fragments")  # of the mechanics: what the fluid carries off where rock dissolves
    kept, drop = [], False
    for line in text.splitlines():
        header = re.match(r"\[+([\w.]+)\]+", line)
        if header:
            drop = header[1].split(".")[0] in tables
        if not drop and not any(re.match(rf"{condition}\s*=", line) for condition in conditions):
            kept.append(line)
    return "\n".join(kept) + "\n"


def write_cases(root, folder):
    """The name of every scene and its case file in the folder."""
    text = (root / CASE).read_text()
    cases = []
    for name, tables, conditions in SCENES:
        case = folder / f"{name.replace(' ', '_')}.toml"
        case.write_text(without(text, tables, conditions))
        cases.append((name, case))
    return cases


def measure(vug, root, folder, processor_time):
    """One row per scene: bytes per node of the lattice, and processor time of a step."""
    rows = []
    for name, case in write_cases(root, folder):
        report = json.loads(subprocess.run([vug, "check", "--json", case], capture_output=True, text=True, check=True).stdout)
        command = [vug, "run", case, "--quiet", "--threads", "1", "--set=output.interval=0.16"]
        start_up = processor_time(command + ["--steps", "1", "-o", folder / f"{case.stem}_start"])
        time = processor_time(command + ["--steps", str(STEPS + 1), "-o", folder / case.stem]) - start_up
        rows.append({"scene": name, "bytes_per_node": report["bytes"] / (report["nx"] * report["ny"]),
                     "milliseconds": 1e3 * time / STEPS})
        print(f"{name:<20} {rows[-1]['bytes_per_node']:7.1f} bytes per node  {rows[-1]['milliseconds']:.2f} ms per step",
              flush=True)
    return rows
