"""What the Python scripts need beyond the standard library: which Python has it."""
import importlib
import os
import sys

LEAST = (3, 11)
SYSTEM = "/usr/bin/python3"  # has the distribution's packages, where another Python comes first in the path
FIRST = "VUG_FIRST_PYTHON"  # variable that says why the first Python would not do, and keeps the second from starting a third


def need(script, *modules):
    """Imports modules that the script needs. Where one is missing, or Python is older than LEAST, the script starts anew
    with the distribution's Python; where that is no better, it ends with one line that says what both lack."""
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
    first = os.environ.pop(FIRST, None)  # what another Python lacks, which has started this one
    if problem and not first and os.path.exists(SYSTEM) and not is_system():
        for variable in ("PYTHONPATH", "PYTHONHOME"):  # of the first Python
            os.environ.pop(variable, None)
        os.environ[FIRST] = f"{sys.executable}: {problem}"
        os.execv(SYSTEM, [SYSTEM] + sys.argv)
    if problem:
        sys.exit(f"{script}: {first}; {sys.executable}: {problem}" if first else f"{script}: {problem}")


def is_system():
    """Whether this is SYSTEM itself: a virtual environment made of it is the same file, but lacks its packages."""
    return sys.prefix == sys.base_prefix and os.path.realpath(sys.executable) == os.path.realpath(SYSTEM)
