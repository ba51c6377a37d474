"""Starting vug from Python."""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import warnings

from .errors import BY_CODE, CaseError, Diverged, Interrupted, VugError, VugWarning
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
    except BaseException:
        child.kill()
        child.communicate()
        raise


def _call(words):
    """Runs vug; returns what it has printed, passes its warnings on, raises what it ended with."""
    program = executable()
    try:
        child = subprocess.Popen([program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                                 errors="replace", env=os.environ | {"VUG_ENDS_WITH_PARENT": "1"})
    except OSError as error:
        raise VugError(f"{program}: cannot be run as vug: {error.strerror}") from None
    stop = None
    try:
        out, err = child.communicate()
    except BaseException as caught:  # Ctrl-C, or what the handler of another signal has raised
        stop = caught
        out, err = _stopped(child)
    for line in err.splitlines():
        if "warning: " in line and not line.startswith("vug: "):
            warnings.warn(line.replace("warning: ", "", 1), VugWarning, stacklevel=3)
    if child.returncode == 0:
        if stop:  # vug was done already; whoever called is to stop all the same
            raise stop
        return out
    if stop and not isinstance(stop, KeyboardInterrupt):
        raise stop
    lines = [line for line in err.splitlines() if line.strip()]
    code = Interrupted.exit_code if child.returncode == -signal.SIGINT else child.returncode  # it had not begun to listen
    error = BY_CODE.get(code, VugError)(lines[-1] if lines else f"vug ended with code {code}")
    error.exit_code = code
    raise error


def _text(value):
    """Text in TOML's syntax: JSON's, but with no character in two halves, and DEL escaped as well."""
    try:
        value.encode()
    except UnicodeEncodeError:
        raise CaseError(f"{value!r} is no text: half a character") from None
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(name):
    return name if re.fullmatch("[A-Za-z0-9_-]+", name) else _text(name)


def _toml(value):
    """A value in TOML's syntax: numbers, text, truth, lists, and dicts as inline tables; of numpy as of Python."""
    if hasattr(value, "tolist"):  # arrays and numbers of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return _text(os.fspath(value))
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(str(name))} = {_toml(inner)}" for name, inner in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    raise CaseError(f"{value!r} is no value of a case: numbers, text, True and False, lists and dicts of them are")


def _overrides(overrides):
    """--set words, in UTF-8 whatever the locale, of {"flow.viscosity": 1e-3, "boundary.left.flow": {"type": "pressure", "pressure": 1e5}}."""
    return [word for key, value in (overrides or {}).items() for word in ("--set", f"{key}={_toml(value)}".encode())]


def run(case, directory=None, overrides=None, *, steps=None, threads=None, resume=False, overwrite=False,
        error_bars=False):
    """Runs a case to its end and opens what it has written.

    `overrides` are values in place of the case's, as of --set: {"flow.viscosity": 1e-3}; dicts are tables. `directory`
    is where results go, runs/<name of the case> without it. `steps` is the last step, `threads` how many compute; `resume`
    goes on from the newest checkpoint of the folder, `overwrite` replaces the run that it holds, `error_bars` runs the
    twins as well: History(directory / "error_bars.csv") has the bars then. Raises CaseError, Diverged, FileTrouble, OutOfMemory or
    Interrupted, with the line that vug has said.
    """
    directory = pathlib.Path(directory) if directory else pathlib.Path("runs") / pathlib.Path(case).stem
    words = ["run", str(case), "-o", str(directory), "--quiet", *_overrides(overrides)]
    for flag, value in (("--steps", steps), ("--threads", threads)):
        if value is not None:
            words += [flag, str(value)]
    words += [flag for flag, wanted in (("--resume", resume), ("--overwrite", overwrite), ("--error-bars", error_bars)) if wanted]
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
