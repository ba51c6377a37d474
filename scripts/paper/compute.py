"""Runs of vug that begin or go on where they stand."""
import os
import subprocess

from .run_data import Run

# Of full size, beyond the preset fast: a fifth of the time of the cases' own "careful" (README of the cases has the errors).
# A step is 25 times shorter than on the coarse lattice, where these intervals were held against the preset's.
FULL_SIZE = ['accuracy.preset="fast"', "accuracy.heat_interval=7", "accuracy.solute_interval=4", "accuracy.exchange_interval=16",
             "accuracy.wall_interval=400", "accuracy.update_interval=80", "mechanics.mass_scaling=4.1", "flow.speed_limit=0.1"]


def compute(case, directory, executable, threads, settings=()):
    """Runs a case (with `key=value` settings) to its end, or resumes it; returns the status it is left in."""
    run = Run(directory)
    if run.status in ("done", "diverged"):
        return run.status
    command = [str(executable), "run", str(case), "--quiet", "--threads", str(threads), "-o", str(directory), "--resume"]
    for setting in settings:
        command += ["--set", setting]
    name = f"{directory.parent.name}/{directory.name}"
    print("resuming" if run.status else "running", name, flush=True)
    directory.parent.mkdir(parents=True, exist_ok=True)
    with open(directory.parent / f"{directory.name}.log", "a", encoding="utf-8") as log:
        subprocess.run(command, stdout=log, stderr=log, check=False, env=os.environ | {"OMP_PROC_BIND": "false"})
    print(name, run.status or "failed", flush=True)
    return run.status
