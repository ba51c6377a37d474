"""Where a campaign takes place: the executable, a folder, random numbers, and what was counted and found."""
import collections
import os
import pathlib
import random
import shutil
import subprocess
import time

from support.compare_runs import differences_of

ROCK = "tests/cases/coupled/small_rock.toml"
# a run of half a second in which everything happens, with files written all the time
BRIEF = ["--quiet", "--threads", "1", "--set", "time.steps=160", "--set", "output.checkpoint_interval=5e-5",
         "--set", "output.interval=5e-5"]


class Site:
    def __init__(self, root, build, folder, findings, seed, seconds, patience):
        self.patience = patience  # s: what takes longer hangs
        self.root, self.folder, self.kept = root, folder, findings
        self.build = build.resolve()
        self.vug = str(self.build / "src/vug")
        self.seed, self.random = seed, random.Random(seed)
        self.counts, self.findings = collections.Counter(), []
        self.end = time.monotonic() + seconds if seconds else None

    def rounds(self, count):
        """0, 1, ... count - 1, as long as there is time."""
        for number in range(count):
            if self.end and time.monotonic() > self.end:
                return
            yield number

    def count(self, what, number=1):
        self.counts[what] += number

    def find(self, what):
        self.findings.append(f"seed {self.seed}: {what}")

    def environment(self, **settings):
        kept = {name: value for name, value in os.environ.items() if not name.startswith(("OMP_", "KOKKOS_"))}
        return kept | {"OMP_PROC_BIND": "false", "OMP_WAIT_POLICY": "passive"} | settings

    def start(self, arguments, environment=None, **options):
        """vug with these arguments, its words in a pipe."""
        options = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT} | options
        return subprocess.Popen([self.vug, *map(str, arguments)], cwd=self.root, env=environment or self.environment(), **options)

    def finish(self, process, what, limit=None):
        """(exit code, what it said); a wait and an end by a signal are findings, but for SIGKILL, which vug does not choose."""
        try:
            said = (process.communicate(timeout=limit or self.patience)[0] or b"").decode(errors="replace")
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            self.find(f"{what}: no end after {limit or self.patience:g} s")
            return None, ""
        if process.returncode < 0 and process.returncode != -9:
            self.find(f"{what}: ended by signal {-process.returncode}: {said[-300:]}")
        elif process.returncode not in (0, 2, 3, 4, 5, 130, -9):
            self.find(f"{what}: exit code {process.returncode}: {said[-300:]}")
        return process.returncode, said

    def run(self, arguments, what, limit=None, **options):
        return self.finish(self.start(arguments, **options), what, limit)

    def rock(self, name, *more):
        """Arguments of the brief run in the folder of that name."""
        return ["run", ROCK, *BRIEF, "-o", self.folder / name, *more]

    def whole(self):
        """The brief run, never disturbed; how long it took, s."""
        start = time.monotonic()
        code, said = self.run(self.rock("whole"), "undisturbed run", 60)
        if code != 0:
            raise SystemExit(f"campaign: the undisturbed run failed: {said}")
        return time.monotonic() - start

    def difference(self, name, other="whole"):
        """What is not the same in two folders, bit for bit; empty where everything is."""
        try:
            return " ".join(differences_of(self.folder / other, self.folder / name))
        except (OSError, KeyError, RuntimeError) as error:  # h5py's words for a file that is none
            return f"unreadable: {error}"

    def require_same(self, name, what):
        difference = self.difference(name)
        if difference:
            self.find(f"{what}: not the bits of the undisturbed run: {difference}")

    def require_one_line(self, said, what):
        if said.count("\n") != 1 or not said.startswith("vug: "):
            self.find(f"{what}: not one line: {said[:300]!r}")

    def renew(self, name, source):
        """The folder `name` becomes a copy of `source`."""
        self.remove(name)
        shutil.copytree(self.folder / source, self.folder / name)

    def remove(self, name):
        shutil.rmtree(self.folder / name, ignore_errors=True)

    def keep(self, path):
        """Keeps a file that did harm; its new place."""
        self.kept.mkdir(parents=True, exist_ok=True)
        return shutil.copy(path, self.kept / f"{self.seed}-{pathlib.Path(path).name}")
