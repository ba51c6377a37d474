"""The tests that look for a mutant: of its library and of what is built on it, the quick ones first."""
import json
import subprocess
import time

from .build import environment

# Executables by the library of the mutant, in the order in which they are asked.
SUITES = {
    "kernels": ["unit_kernels", "unit_coupling", "verification_kernels", "verification_coupling"],
    "dem": ["unit_dem", "verification_dem", "unit_coupling", "verification_coupling"],
    "coupling": ["unit_coupling", "verification_coupling"],
}
STAGES = (0.3, 2, 10, float("inf"))  # s a test takes: all of one stage before the first of the next
TESTS = "build/openmp/tests"


def executable(suite):
    return f"vug_{suite}_tests"


class Suite:
    """The tests and how long each takes without a mutant."""

    def __init__(self, folder, longest, suites):
        self.folder = folder
        self.seconds = {}  # suite -> {test: s}
        self.sick = []  # fail without a mutant: they cannot tell
        for suite in suites:
            self.seconds[suite] = self.measure(suite, longest)

    def measure(self, suite, longest):
        """Without a mutant; kept beside the executable until that changes."""
        program, report = self.folder / TESTS / executable(suite), self.folder / TESTS / f"{suite}.json"
        if not report.exists() or report.stat().st_mtime < program.stat().st_mtime:
            self.call(suite, "-*Long.*", 0, 3600, f"--gtest_output=json:{report}")
        seconds = {}
        for group in json.loads(report.read_text())["testsuites"]:
            for test in group["testsuite"]:
                name = f"{group['name']}.{test['name']}"
                if test.get("failures"):
                    self.sick.append(name)
                elif test["result"] == "COMPLETED" and float(test["time"].rstrip("s")) <= longest:
                    seconds[name] = float(test["time"].rstrip("s"))
        return seconds

    def call(self, suite, tests, number, limit, *options):
        command = [f"{TESTS}/{executable(suite)}", f"--gtest_filter={tests}", *options]
        try:
            run = subprocess.run(command, cwd=self.folder, env=environment(number), capture_output=True, text=True,
                                 errors="replace", timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return "no end"
        if run.returncode == 0:
            return None
        failed = [line.split()[-1] if "(" not in line else line.split("]")[1].split()[0].rstrip(",")
                  for line in run.stdout.splitlines() if line.startswith("[  FAILED  ]")]
        running = [line.split("]")[1].strip() for line in run.stdout.splitlines() if line.startswith("[ RUN ")]
        return failed[0] if failed else f"{running[-1] if running else suite} (ended by itself)"

    def hunt(self, number, library):
        """(the test that notices the mutant or None, s that it took)."""
        began, low = time.monotonic(), 0.0
        for high in STAGES:
            for suite in [suite for suite in SUITES[library] if suite in self.seconds]:
                tests = {test: s for test, s in self.seconds[suite].items() if low <= s < high}
                if not tests:
                    continue
                limit = 60 + 10 * sum(tests.values())
                caught = self.call(suite, ":".join(tests), number, limit, "--gtest_fail_fast", "--gtest_brief=0")
                if caught:
                    return caught, time.monotonic() - began
            low = high
        return None, time.monotonic() - began
