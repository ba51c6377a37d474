"""The same bytes of every file for any number of ranks and threads, over births, cracks and restarts.

    same_bytes.py [--all] VUG CASE... -- MPIRUN...      (names of the table below)

On 1, 2 and 3 ranks; with --all on 1, 2, 3, 4, 7 and 16 ranks of one and of two threads, but for those.
"""
import csv
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))
from compare_runs import differences_of  # noqa: E402

ROCK_OFTEN = "output.interval=2.5e-5"
COUPLED = "tests/cases/coupled/"
FINE = ["lattice.spacing=1.25e-4"]  # as many blocks of fluid nodes as ranks
OFTEN = "output.interval_steps=10"
SURFACES = ["output.forces=true", "output.flows=true"]
CASES = {  # case, steps, keys, output at every tenth step
    "channel": ("cases/cylinder.toml", 40, [], "output.interval=1e-2"),
    "cavity": ("cases/heated_cavity.toml", 60, [], "output.interval=4e-3"),
    "lids": ("cases/cylinder.toml", 40,
             ['boundary.left.flow={ type = "velocity", velocity = [0.2, 0.1], ramp_time = 0.03 }',
              'boundary.bottom.flow={ type = "velocity", velocity = [-0.2, 0] }',
              'boundary.top.flow={ type = "wall", velocity = [0.3, 0] }',
              'boundary.injection={ side = "top", centre = 1.1, width = 0.5, flow = { type = "wall" } }',
              *SURFACES],
             "output.interval=1e-2"),  # velocities along sides, and where they end
    "joins": ("cases/cylinder.toml", 40,
              ['boundary.left.flow={ type = "velocity", velocity = [0.2, 0.1], ramp_time = 0.03 }',
               'boundary.bottom.flow={ type = "velocity", velocity = [0.2, 0.1], ramp_time = 0.03 }',
               'boundary.right.flow={ type = "outflow" }', 'boundary.top.flow={ type = "outflow" }',
               'boundary.injection={ side = "right", centre = 0.2, width = 0.1, flow = { type = "outflow" } }',
               *SURFACES],
              "output.interval=1e-2"),  # outflows that meet on a side and at a corner
    "outflow": ("cases/tutorial/heated_channel.toml", 800, ["heat.velocity_set=d2q9", *SURFACES],
                "output.interval=1.25e-3"),  # of heat, that looks back across cuts
    "diffusion": ("cases/diffusion_reaction.toml", 60, [], "output.interval=0.03"),
    "rock": (COUPLED + "small_rock.toml", 207, FINE, ROCK_OFTEN),  # ends between two births: what walls conduct is set
    "single": (COUPLED + "small_rock.toml", 120, FINE + ["accuracy.precision=single", "flow.collision=bgk"], ROCK_OFTEN),
    "intervals": (COUPLED + "small_rock.toml", 120,
                  FINE + ["accuracy.solute_interval=3", "accuracy.heat_interval=2", "accuracy.exchange_interval=7",
                          "accuracy.flow_tolerance=0.5", "accuracy.guard_interval=10"], ROCK_OFTEN),
    "tolerance": (COUPLED + "small_rock.toml", 300, FINE + ["accuracy.tolerance=0.1"], ROCK_OFTEN),
    "slits": (COUPLED + "small_rock.toml", 120,
              FINE + ["damage.aperture=opening", "damage.residual_aperture=4e-5"], ROCK_OFTEN),
    "thick_slits": (COUPLED + "small_rock.toml", 120,
                    FINE + ["damage.aperture=opening", "damage.residual_aperture=4e-5",
                            "flow.viscosity_activation_energy=15000", "flow.reference_temperature=400"],
                    ROCK_OFTEN),  # what drags at triangles depends on the temperature of other ranks' nodes
    "faces": (COUPLED + "small_rock.toml", 120, FINE + SURFACES + ["solute.face_exchange=true"], ROCK_OFTEN),
    "d2q9": (COUPLED + "small_rock.toml", 120,
             FINE + SURFACES + ["heat.velocity_set=d2q9", "solute.velocity_set=d2q9"], ROCK_OFTEN),
    "sleep": (COUPLED + "small_rock.toml", 120,
              FINE + ["rock.element_size=1e-3", "mechanics.local_damping=0.7", "mechanics.rest_tolerance=0.3", ROCK_OFTEN],
              ROCK_OFTEN),
    "slow": (COUPLED + "slow_grain.toml", 3000, [], OFTEN),
    "warm_well": (COUPLED + "warm_well.toml", 60, SURFACES, OFTEN),
    "well": (COUPLED + "well.toml", 200, SURFACES + ["lattice.spacing=2.5e-4"], OFTEN),
}
NOTHING_OPENS = {"warm_well"}  # of the coupled ones
MANY = "rock"  # the case that is run on more ranks than the others
COMPARED = [(2, 1), (3, 1), (2, 2)]  # ranks, threads
COMPARED_MANY = [(4, 1), (7, 1), (1, 2), (3, 2)]
COMPARED_ALL = [(1, 2), (3, 2)] + [(ranks, threads) for ranks in (4, 7, 16) for threads in (1, 2)]  # beside COMPARED
# (ranks, threads) of a run that is stopped and goes on, in turn
TURNS, TURNS_ALL = [(4, 1), (3, 1), (2, 1)], [(16, 1), (7, 2), (4, 1), (1, 2)]


def blocks(path):
    """What a checkpoint holds, by name: all but whose run it is."""
    data = path.read_bytes()
    at = 8

    def word():
        nonlocal at
        at += 8
        return struct.unpack_from("<q", data, at - 8)[0]

    def text():
        nonlocal at
        size = word()
        start, at = at, at + (size + 7) // 8 * 8
        return data[start:start + size]

    found = {"head": [word() for _ in range(3)], "case": text()}
    text()  # the run's name
    for _ in range(word()):
        name = text().decode()
        found[name] = text()
    return found


def differences(first, second):
    found = differences_of(first, second)
    saved = sorted(path.name for path in (first / "checkpoint").iterdir())
    if saved != sorted(path.name for path in (second / "checkpoint").iterdir()):
        return found + ["checkpoint: not the same files"]
    for name in saved:
        a, b = blocks(first / "checkpoint" / name), blocks(second / "checkpoint" / name)
        found += [f"{name}: not the same blocks"] if sorted(a) != sorted(b) else []
        found += [f"{name}:{key}" for key in a if a[key] != b.get(key)]
    return found


class Runner:
    def __init__(self, vug, mpirun):
        self.vug, self.mpirun = vug, mpirun
        self.environment = os.environ | {"OMP_PROC_BIND": "false", "OMP_WAIT_POLICY": "passive"}

    def run(self, case, folder, ranks, threads, *more, to=None, resume=False):
        path, steps, keys, _ = CASES[case]
        sets = [word for key in keys + list(more) for word in ("--set", key)]
        command = [*self.mpirun, "-n", str(ranks), self.vug, "run", path, "-o", str(folder), "--quiet", "--threads",
                   str(threads), *sets, "--steps", str(steps if to is None else to), *(["--resume"] if resume else [])]
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")


def births(folder):
    """Nodes that have turned fluid, by the last row of the history."""
    rows = list(csv.DictReader((folder / "history.csv").open()))
    return sum(int(rows[-1].get(name, 0)) for name in ("nodes_dissolved_1", "nodes_opened_by_damage_1"))


def least_awake(folder):
    """Of all rows of the history; 1 where no rock may sleep."""
    return min(float(row.get("rock_awake_1", 1)) for row in csv.DictReader((folder / "history.csv").open()))


def check(runner, case, root, everything):
    """Compares runs, and runs that were stopped and went on with another number of ranks."""
    compared = COMPARED_ALL if everything else COMPARED + (COMPARED_MANY if case == MANY else [])
    turns = TURNS_ALL if everything else TURNS
    wrong = 0

    def compare(what, first, second):
        nonlocal wrong
        found = differences(first, second)
        print(f"{case}, {what}: {'the same' if not found else found[:8]}", flush=True)
        wrong += bool(found)

    one = root / case
    runner.run(case, one, 1, 1)
    if CASES[case][0].startswith(COUPLED) and case not in NOTHING_OPENS and births(one) == 0:
        sys.exit(f"{case}: no node has turned fluid, so that nothing is tested")
    if case == "sleep" and least_awake(one) == 1:
        sys.exit(f"{case}: no rock has slept, so that nothing is tested")
    for ranks, threads in compared:
        other = root / f"{case}_{ranks}_{threads}"
        runner.run(case, other, ranks, threads)
        compare(f"{ranks} ranks of {threads}", one, other)
    often, steps = CASES[case][3], CASES[case][1]
    whole, parts = root / f"{case}_whole", root / f"{case}_parts"
    runner.run(case, whole, 1, 1, often)
    for turn, (ranks, threads) in enumerate(turns):
        last = turn + 1 == len(turns)
        to = steps if last else steps // 20 * 10 + 10 * turn
        runner.run(case, parts, ranks, threads, often, to=to, resume=turn > 0)
    compare("ranks in turn " + ", ".join(str(ranks) for ranks, _ in turns), whole, parts)
    return wrong


def main(arguments):
    everything = arguments[0] == "--all"
    split, first = arguments.index("--"), int(everything)
    runner = Runner(arguments[first], arguments[split + 1:])
    with tempfile.TemporaryDirectory() as root:
        wrong = sum(check(runner, case, pathlib.Path(root), everything) for case in arguments[first + 1:split])
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
