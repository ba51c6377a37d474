"""Runs of vug that begin or go on where they stand."""
import argparse
import concurrent.futures
import os
import subprocess
import sys

from .run_data import Run, vug

# Of full size, beyond the preset fast: a fifth of the time of the cases' own "careful" (README of the cases has the errors).
# A step is 25 times shorter than on the coarse lattice, where these intervals were held against the preset's.
FULL_SIZE = ['accuracy.preset="fast"', "accuracy.heat_interval=7", "accuracy.solute_interval=4", "accuracy.exchange_interval=16",
             "accuracy.wall_interval=400", "accuracy.update_interval=80", "mechanics.mass_scaling=4.1", "flow.speed_limit=0.07"]
DOUBLE = ['accuracy.precision="double"']  # after these, whose preset is in single precision
DIVERGED = 3  # exit code: a result, which the tables tell


def kept(run, case, settings):
    """Why a finished run is not run anew, in a few words where it is of something else; else empty."""
    record = run.record
    for what, then, now in (("another case file", record.get("case_text"), case.read_text(encoding="utf-8")),
                            ("other settings", sorted(record.get("overrides", [])), sorted(settings))):
        if then != now:
            return f"finished with {what}; kept (remove {run.directory} to run it anew)"
    return ""


def compute(case, directory, executable, threads, settings=()):
    """Runs a case (with `key=value` settings) to its end, or resumes it; returns whether it went wrong."""
    run = Run(directory)
    name = f"{directory.parent.name}/{directory.name}"
    if run.status in ("done", "diverged"):
        if of_else := kept(run, case, settings):
            print(f"{name}: {of_else}", flush=True)
        return False
    command = [str(executable), "run", str(case), "--quiet", "--threads", str(threads), "-o", str(directory), "--resume"]
    for setting in settings:
        command += ["--set", setting]
    print("resuming" if run.status else "running", name, flush=True)
    directory.parent.mkdir(parents=True, exist_ok=True)
    path = directory.parent / f"{directory.name}.log"
    with open(path, "a", encoding="utf-8") as log:
        done = subprocess.run(command, stdout=log, stderr=log, check=False, env=os.environ | {"OMP_PROC_BIND": "false"})
    wrong = done.returncode not in (0, DIVERGED)
    print(f"{name}: vug ended with code {done.returncode}; see {path}" if wrong else f"{name} {run.status}", flush=True)
    return wrong


def compute_all(runs, executable, threads, jobs):
    """Runs (case, directory, settings) `jobs` at a time; returns how many went wrong."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return sum(pool.map(lambda run: compute(run[0], run[1], executable, threads, run[2]), runs))


def positive(text):
    """A number of an option, 1 or more."""
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r} must be a whole number, 1 or more")
    return int(text)


def finish(name, main):
    """Ends a script with what main returns, or with one line where a file cannot be read or Ctrl-C was pressed."""
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print(f"{name}: interrupted; call it again to go on", file=sys.stderr)
        sys.exit(130)
    except (OSError, vug.VugError) as error:
        sys.exit(f"{name}: {error}")
