"""Numbers of every example of cases/ (and of the coupled cases of the tests), reduced to a few steps, held against those
recorded in values/NAME.json.

  examples.py --vug EXECUTABLE NAME...            compares; exit code 1 when one differs
  examples.py --vug EXECUTABLE --record [NAME...] writes the records anew and prints what moved (scripts/record-regression)

Held are rows of the history, and of every field at the end its sum, its sum of squares and a sum with weights that
differ from place to place. Compilers round differently, so a number may differ by 1e-9 of the largest of its kind;
kinetic energies, which are squares of small velocities, by 1e-6.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
TOLERANCE = 1e-9
# of these kinds, by what is in the name
WIDER = {"kinetic_energy": 1e-6}
# differences of nearly equal numbers: nothing but rounding, small against what they are differences of
ROUNDING = ("balance_error", "overdrawn", "gain_advective_form")
# zero by symmetry, whatever is left is rounding, which another order of sums makes anew: may be a thousand times as large
ZERO = {"cylinder": ("left_force_y", "left_torque"), "minerals": ("mean_velocity_y",),
        "heated_cavity": ("fluid_mass_stored", "heat_stored", "heat_gain_sides", "mean_velocity")}

COARSE = ["lattice.spacing=1e-3", "lattice.time_step=4e-5", "flow.pressure_scale=400", "rock.element_size=6e-3",
          "boundary.injection.flow.ramp_time=4e-4", "mechanics.preload_time=2e-5", "accuracy.update_interval=4", "output.interval=2.4e-4"]
# those of acid_fracturing/coarse are the same cases once they are reduced
ACID = {f"acid_fracturing/p{pressure}_da{da}": (12, COARSE)
        for pressure in (10, 20, 30) for da in ("1.5", "1.5e-3", "1.5e-5")}
# name below cases/: lattice steps, overrides; rows of the history three times
RUNS = ACID | {
    "quickstart": (12, COARSE),
    "cylinder": (60, ["output.interval=0.02"]),
    "heated_cavity": (60, ["output.interval=8e-3"]),
    "poiseuille": (60, ["output.interval_steps=20"]),
    "minerals": (60, ["output.interval=2e-3"]),
    "diffusion_reaction": (60, ["output.interval=0.06"]),
    "../tests/cases/coupled/small_rock": (60, ["output.interval=5e-5"]),
    "../tests/cases/coupled/well": (60, ["output.interval_steps=20"]),
}
LABORATORY = {
    "laboratory/brazilian": ["rock.element_size=6e-3", "mechanics.bond.normal_strength=3e6", "laboratory.largest_strain=3e-4"],
    "laboratory/compression": ["rock.element_size=1e-2", "laboratory.largest_strain=5e-4"],
    "laboratory/quench": ["rock.element_size=3e-3", "laboratory.duration=2e-5"],
    "laboratory/tension": ["rock.element_size=1e-2", "laboratory.largest_strain=2e-4"],
}


def run(vug, command, case, folder, overrides, *more):
    line = [vug, command, ROOT / "cases" / f"{case}.toml", "-o", folder, "--quiet", "--threads", "1", *more]
    for override in overrides:
        line += ["--set", override]
    done = subprocess.run(line, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{case}: vug ended with {done.returncode}: {done.stderr.strip()}")


def rows_of(path, count):
    """Column -> its values in about `count` rows: evenly spread, the last among them."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    chosen = sorted({round(k * (len(rows) - 1) / max(1, count - 1)) for k in range(count)})
    return {name: [float(rows[k][name]) for k in chosen] for name in rows[0]} | {"rows": [float(len(rows))]}


def weights(count):
    """As good as random, and the same everywhere."""
    return np.modf(np.arange(1, count + 1) * 0.6180339887498949)[0] - 0.5


def digest(values):
    flat = np.nan_to_num(np.asarray(values, dtype=float)).ravel()
    return [float(flat.size), float(flat.sum()), float(flat @ flat), float(flat @ weights(flat.size))]


def fields_of(path):
    """Data set -> its digest, of the last snapshot and of what does not change."""
    found = {}

    def collect(group, prefix):
        for name, item in group.items():
            if isinstance(item, h5py.Group):
                collect(item, f"{prefix}{name}/")
            elif np.issubdtype(item.dtype, np.number):
                found[prefix + name] = digest(item[()])

    with h5py.File(path, "r") as file:
        collect(file, "")
    return found


def measure(vug, case):
    """{"history": column -> values, "fields": "file:data set" -> digest}"""
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary) / "run"
        if case in RUNS:
            steps, overrides = RUNS[case]
            run(vug, "run", case, folder, overrides, "--steps", str(steps))
            history = rows_of(folder / "history.csv", 4)
        else:
            run(vug, "lab", case, folder, LABORATORY[case])
            tables = sorted(folder.glob("*.csv"))
            history = {f"{table.stem}:{name}": values for table in tables for name, values in rows_of(table, 6).items()}
        fields = {f"{name}:{key}": value for name in ("fields.h5", "particles.h5") if (folder / name).exists()
                  for key, value in fields_of(folder / name).items()}
    return {"history": history, "fields": fields}


def text_of(values):
    """JSON with a line for every entry."""
    kinds = []
    for kind, entries in values.items():
        lines = ",\n".join(f"    {json.dumps(name)}: {json.dumps(entries[name])}" for name in sorted(entries))
        kinds.append(f'  "{kind}": {{\n{lines}\n  }}')
    return "{\n" + ",\n".join(kinds) + "\n}\n"


def record_of(case):
    return HERE / "values" / (case.replace("../tests/cases/", "").replace("/", "-") + ".json")


def scale_of(kind, name, old):
    """The largest that a difference is held against, for every number of an entry."""
    if kind == "history":
        return [max(map(abs, old))] * len(old)
    size, _, squares, _ = old
    return [1.0, (size * squares) ** 0.5, squares, (size * squares) ** 0.5]


def tolerance_of(name, zero):
    if name.startswith(zero):
        return 1e3
    return next((wider for text, wider in WIDER.items() if text in name), TOLERANCE)


def differences(old, new, zero=()):
    """[(relative difference, kind, name, place, old, new)] beyond the tolerance; inf where something came or went."""
    found = []
    for kind in ("history", "fields"):
        for name in sorted(old[kind].keys() | new[kind].keys()):
            a, b = old[kind].get(name), new[kind].get(name)
            if a is None or b is None or len(a) != len(b):
                found.append((float("inf"), kind, name, "", a, b))
                continue
            for place, (x, y, scale) in enumerate(zip(a, b, scale_of(kind, name, a))):
                if any(text in name for text in ROUNDING):
                    continue
                if not abs(x - y) <= tolerance_of(name, zero) * scale:
                    found.append((abs(x - y) / scale if scale > 0 else float("inf"), kind, name, place, x, y))
    return sorted(found, key=lambda one: -one[0])


def tell(case, moved, most=12):
    print(f"{case}: {len(moved)} numbers moved" if moved else f"{case}: as recorded")
    for size, kind, name, place, old, new in moved[:most]:
        what = f"row {place}" if kind == "history" else ("count", "sum", "squares", "weighted sum")[place or 0]
        if isinstance(old, float):
            print(f"  {size:9.2e}  {name} ({what}): {old:.12g} -> {new:.12g}")
        else:
            print(f"  {'came' if old is None else 'went' if new is None else 'length'}     {name}")
    if len(moved) > most:
        print(f"  ... and {len(moved) - most} more")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--vug", default=str(ROOT / "build/openmp/src/vug"))
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    known = [*RUNS, *LABORATORY]
    if options.list:
        print("\n".join(known))
        return 0
    failed = False
    for case in options.names or known:
        if case not in known:
            sys.exit(f"{case} is none of the examples: {', '.join(known)}")
        new, path = measure(options.vug, case), record_of(case)
        if not path.exists():
            print(f"{case}: not recorded before")
            failed = True
        else:
            moved = differences(json.loads(path.read_text()), new, ZERO.get(case, ()))
            tell(case, moved)
            failed = failed or bool(moved)
        if options.record:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text_of(new))
    return 1 if failed and not options.record else 0


if __name__ == "__main__":
    sys.exit(main())
