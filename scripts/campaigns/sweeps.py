"""kill -9 of a study's sweep and of its runs, then --resume: the bytes of the table of one process undisturbed."""
import os
import pathlib
import signal
import time

SMALL, FULL = 6, 20

STUDY = """
[study]
case = "{case}"
set = ["time.steps=160", "output.checkpoint_interval=5e-5", "output.interval=5e-5"]

[[study.keys]]
key = "rock.seed"
seeds = 3

[[study.keys]]
key = "flow.viscosity"
values = [1e-5, 2e-5]
"""


def children_of(process):
    """Ids of its runs."""
    try:
        return [int(word) for word in pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]
    except OSError:
        return []


def strike(site, sweep):
    """Kills the sweep or one of its runs, whichever the lot falls on."""
    runs = children_of(sweep)
    if runs and site.random.random() < 0.5:
        try:
            os.kill(site.random.choice(runs), signal.SIGKILL)
            site.count("runs killed")
        except ProcessLookupError:  # has just ended
            pass
    elif sweep.poll() is None:
        sweep.kill()
        site.count("sweeps killed")


def tables(site, name):
    """The bytes of the table and of the list of failures."""
    return [(site.folder / name / file).read_bytes() for file in ("table.csv", "failures.csv")]


def campaign(site, count):
    study = site.folder / "study.toml"
    study.write_text(STUDY.format(case=site.root / "tests/cases/coupled/small_rock.toml"))
    began = time.monotonic()
    code, said = site.run(["sweep", study, "-o", site.folder / "one", "-j", 1, "--quiet"], "undisturbed study", 120)
    whole = time.monotonic() - began
    if code != 0:
        raise SystemExit(f"campaign: the undisturbed study failed: {said}")
    code, _ = site.run(["sweep", study, "-o", site.folder / "two", "-j", 2, "--quiet"], "two runs at once", 120)
    if code != 0 or tables(site, "two") != tables(site, "one"):
        site.find("two runs at once: not the table of one at a time")
    number = 0

    def kills():
        return site.counts["runs killed"] + site.counts["sweeps killed"]

    while kills() < count and any(True for _ in site.rounds(1)):
        name, at_once = f"killed{number}", 1 + number % 2
        call = ["sweep", study, "-o", site.folder / name, "-j", at_once, "--resume", "--quiet"]
        code = None
        while code != 0:
            sweep = site.start(call)
            while sweep.poll() is None and kills() < count:
                time.sleep(site.random.uniform(0, 2 * whole / count))
                strike(site, sweep)
            code, said = site.finish(sweep, f"study after {kills()} kills", 120)
            if code not in (0, 3, -9):  # 3: a run was killed under the sweep, which goes on with the others
                site.find(f"study after {kills()} kills: exit code {code}: {said[-300:]}")
                return
        if tables(site, name) != tables(site, "one"):
            site.find(f"study after {kills()} kills: not the table of the undisturbed one")
        site.count("studies that ended")
        site.remove(name)
        number += 1
