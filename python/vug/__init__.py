"""Runs of vug: open what one has written, and start one.

    import vug

    run = vug.run("cases/quickstart.toml", "runs/short", {"time.end": 0.01})   # or vug.open("runs/short")
    run.history["dissolved_volume"]        # over run.history["time"]; run.history.units["dissolved_volume"]
    pressure = run[-1]["pressure"]         # of the last snapshot; nothing is read before it is used
    pressure.values, pressure.units, pressure.x, pressure.y
"""
import sys

if sys.version_info < (3, 11):
    raise ImportError(f"vug needs Python 3.11 or later, this is {sys.version_info[0]}.{sys.version_info[1]}")

from .errors import (CaseError, Diverged, FileTrouble, Interrupted, OutOfMemory, VugError, VugWarning)
from .field import Field
from .focusing import flow_focusing
from .history import History
from .launch import check, executable, run, sweep
from .run_folder import Rock, Run, Snapshot
from .study import Study

open = Run  # noqa: A001 (vug.open reads as what it does)

__all__ = ["CaseError", "Diverged", "Field", "FileTrouble", "History", "Interrupted", "OutOfMemory", "Rock", "Run",
           "Snapshot", "Study", "VugError", "VugWarning", "check", "executable", "flow_focusing", "open", "run", "sweep"]
