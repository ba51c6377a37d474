"""What the Python scripts need beyond the standard library: which Python has it."""
import importlib
import os
import sys

LEAST = (3, 11)
SYSTEM = "/usr/bin/python3"  # has the distribution's packages, where another Python comes first in the path


def need(script, *modules):
    """Imports modules that the script needs. Where one is missing, or Python is older than LEAST, the script starts anew
    with the distribution's Python; where that is no better, it ends with one line."""
    problem = None
    try:
        if sys.version_info < LEAST:
            problem = "needs Python {}.{} or later, this is {}.{}".format(*LEAST, *sys.version_info)
        else:
            for module in modules:
                importlib.import_module(module)
    except ImportError as error:
        debian = " ".join(f"python3-{module}" for module in modules)
        problem = f"{error.name} is missing (Debian, Ubuntu: apt-get install {debian})" if error.name else str(error)
    if problem:
        if os.path.exists(SYSTEM) and os.path.realpath(sys.executable) != os.path.realpath(SYSTEM):
            os.execv(SYSTEM, [SYSTEM] + sys.argv)
        sys.exit(f"{script}: {problem}")
