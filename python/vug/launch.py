"""Starting vug from Python."""
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import warnings

from .errors import BY_CODE, Diverged, Interrupted, VugError, VugWarning
from .run_folder import Run
from .study import Study


def executable():
    """The vug that calls use: of the environment variable VUG, of the path, or of the checkout that this package lies in."""
    checkout = pathlib.Path(__file__).resolve().parents[2] / "build" / "openmp" / "src" / "vug"
    for candidate in (os.environ.get("VUG"), shutil.which("vug"), str(checkout) if checkout.exists() else None):
        if candidate:
            return candidate
    raise VugError("no vug found: set the environment variable VUG to its path, or build it with scripts/run")


def _stopped(child):
    """Hands an interrupt on to vug, which ends its step and writes a checkpoint, and waits for that; another one ends it
    at once. subprocess.run gives a quarter of a second, then kills, and all since the last checkpoint is lost."""
    child.send_signal(signal.SIGINT)
    try:
        return child.communicate()
    except KeyboardInterrupt:
        child.kill()
        child.communicate()
        raise


def _call(words):
    """Runs vug; returns what it has printed, passes its warnings on, raises what it ended with."""
    child = subprocess.Popen([executable(), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    interrupt = None
    try:
        out, err = child.communicate()
    except KeyboardInterrupt as caught:
        interrupt = caught
        out, err = _stopped(child)
    for line in err.splitlines():
        if "warning: " in line and not line.startswith("vug: "):
            warnings.warn(line.replace("warning: ", "", 1), VugWarning, stacklevel=3)
    if child.returncode == 0:
        if interrupt:  # vug was done already; whoever called is to stop all the same
            raise interrupt
        return out
    lines = [line for line in err.splitlines() if line.strip()]
    code = Interrupted.exit_code if child.returncode == -signal.SIGINT else child.returncode  # it had not begun to listen
    error = BY_CODE.get(code, VugError)(lines[-1] if lines else f"vug ended with code {code}")
    error.exit_code = code
    raise error


def _toml(value):
    """A value in TOML's syntax, which JSON's is but for numbers that are none; of numpy as of Python."""
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return json.dumps(value, default=lambda array: array.tolist())


def _overrides(overrides):
    """--set words of {"flow.viscosity": 1e-3, "heat.velocity_set": "d2q9"}."""
    return [word for key, value in (overrides or {}).items() for word in ("--set", f"{key}={_toml(value)}")]


def run(case, directory=None, overrides=None, *, steps=None, threads=None, resume=False, overwrite=False):
    """Runs a case to its end and opens what it has written.

    `overrides` are values in place of the case's, as of --set: {"flow.viscosity": 1e-3}. `directory` is where results
    go, runs/<name of the case> without it. Raises CaseError, Diverged, FileTrouble, OutOfMemory or Interrupted, with
    the line that vug has said.
    """
    directory = pathlib.Path(directory) if directory else pathlib.Path("runs") / pathlib.Path(case).stem
    words = ["run", str(case), "-o", str(directory), "--quiet", *_overrides(overrides)]
    for flag, value in (("--steps", steps), ("--threads", threads)):
        if value is not None:
            words += [flag, str(value)]
    words += [flag for flag, wanted in (("--resume", resume), ("--overwrite", overwrite)) if wanted]
    _call(words)
    return Run(directory)


def check(case, overrides=None):
    """What `vug check --json` says of a case."""
    return json.loads(_call(["check", str(case), "--json", *_overrides(overrides)]))


def sweep(study, directory=None, *, jobs=None, resume=False):
    """Runs a study and opens its table. Runs that fail are in `failures` of it and raise nothing."""
    directory = pathlib.Path(directory) if directory else pathlib.Path("runs") / pathlib.Path(study).stem
    words = ["sweep", str(study), "-o", str(directory), "--quiet", *(["--jobs", str(jobs)] if jobs else []),
             *(["--resume"] if resume else [])]
    try:
        _call(words)
    except Diverged:
        pass  # some runs are not done; the others are in the table
    return Study(directory)
