"""What each of several ranks takes in memory, at the most, beside one rank: fields are shared out, also after a restart.

    memory.py VUG MPIRUN...

Ends with 77, skipped, where pages that are only read take memory: there it cannot tell what ranks hold from what they look at.
"""
import mmap
import os
import pathlib
import subprocess
import sys
import tempfile

VUG, MPIRUN = sys.argv[1], sys.argv[2:]
# 2.25 million nodes of flow and heat, whose populations are most of the memory
CASE = ["run", "cases/heated_cavity.toml", "--set", "lattice.size=[0.525,0.525]", "--threads", "1", "--quiet"]
RANKS = 4
# Of one rank's: a quarter of the fields, tables of the neighbours of all nodes, libraries, and the pieces in which files are
# written and read, which are the first rank's alone.
SHARE = 0.72
# A file for each rank: what several print may come out mixed.
MEASURE = """import os, pathlib, resource, subprocess, sys
code = subprocess.run(sys.argv[2:], stdout=subprocess.DEVNULL).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
pathlib.Path(sys.argv[1], str(os.getpid())).write_text(str(used))
sys.exit(code)"""
ENVIRONMENT = os.environ | {"OMP_PROC_BIND": "false", "OMP_WAIT_POLICY": "passive"}


def used(ranks, folder, *words):
    """Largest memory of each rank, KiB, ascending."""
    with tempfile.TemporaryDirectory() as notes:
        run = subprocess.run([*MPIRUN, "-n", str(ranks), sys.executable, "-c", MEASURE, notes, VUG, *CASE, "-o", str(folder),
                              *words], env=ENVIRONMENT, text=True, capture_output=True, timeout=300)
        found = sorted(int(note.read_text()) for note in pathlib.Path(notes).iterdir())
    assert run.returncode == 0 and len(found) == ranks, run.stdout + run.stderr
    return found


def reading_takes_memory():
    """Whether the system counts pages that nobody has written once they are read; Linux as it comes maps one page of zeros."""
    def resident():
        return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * mmap.PAGESIZE

    size = 64 << 20
    with mmap.mmap(-1, size, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS) as pages:
        before = resident()
        assert not any(pages[i] for i in range(0, size, mmap.PAGESIZE))
        return resident() - before > size // 2


def main():
    if reading_takes_memory():
        print("skipped: on this system pages that are only read take memory")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        one = used(1, folder / "one", "--steps", "2")[0]
        for what, words in (("run", []), ("resumed", ["--resume"])):
            several = used(RANKS, folder / "several", "--steps", "2", *words)
            print(f"{what}: one rank {one >> 10} MiB, each of {RANKS} {[kib >> 10 for kib in several]} MiB")
            assert several[-1] < SHARE * one, "memory is not shared out"


main()
