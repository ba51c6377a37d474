"""The tests that look for a mutant: of its library and of what is built on it, the quick ones first."""
import collections
import json
import subprocess
import time

from .build import environment

# Executables by the library of the mutant, in the order in which they are asked.
SUITES = {
    "kernels": ["unit_kernels", "unit_coupling", "verification_kernels", "verification_coupling"],
    "dem": ["unit_dem", "verification_dem", "unit_coupling", "verification_coupling", "scenes_coupling"],
    "coupling": ["unit_coupling", "verification_coupling", "scenes_coupling", "stability_coupling"],
    "io": ["unit_io", "unit_coupling", "verification_coupling"],
    "study": ["unit_study"],
}
STAGES = (0.3, 2, 10, float("inf"))  # s a test takes: all of one stage before the first of the next
FAVOURITES = 8  # tests that have noticed others of the same file
TESTS = "build/openmp/tests"


def executable(suite):
    return f"vug_{suite}_tests"


class Suite:
    """The tests and how long each takes without a mutant."""

    def __init__(self, folder, longest, suites, left_out=""):
        self.folder = folder
        self.tests = "-*Long.*" + (f":{left_out}" if left_out else "")
        self.noticed = collections.defaultdict(collections.Counter)  # file -> {test: how many of its mutants}
        self.seconds = {}  # suite -> {test: s}
        self.sick = []  # fail without a mutant: they cannot tell
        for suite in suites:
            self.seconds[suite] = self.measure(suite, longest)

    def measure(self, suite, longest):
        """Without a mutant; kept beside the executable until that changes."""
        program, report = self.folder / TESTS / executable(suite), self.folder / TESTS / f"{suite}.json"
        if not report.exists() or report.stat().st_mtime < program.stat().st_mtime:
            self.call(suite, self.tests, 0, 3600, f"--gtest_output=json:{report}")
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

    def remember(self, mutant, test):
        """What has noticed a mutant is asked first of the others in its file."""
        self.noticed[mutant.path][test] += 1

    def stages(self, mutant):
        """Lists of tests by suite, in the order in which they are asked."""
        suites = [suite for suite in SUITES[mutant.library] if suite in self.seconds]
        first = {test for test, _ in self.noticed[mutant.path].most_common(FAVOURITES)}
        yield {suite: [test for test in self.seconds[suite] if test in first] for suite in suites}
        low = 0.0
        for high in STAGES:
            yield {suite: [test for test, s in self.seconds[suite].items() if low <= s < high and test not in first]
                   for suite in suites}
            low = high

    def hunt(self, number, mutant):
        """(the test that notices the mutant or None, s that it took)."""
        began = time.monotonic()
        for stage in self.stages(mutant):
            for suite, tests in stage.items():
                if not tests:
                    continue
                limit = 60 + 10 * sum(self.seconds[suite][test] for test in tests)
                caught = self.call(suite, ":".join(tests), number, limit, "--gtest_fail_fast", "--gtest_brief=0")
                if caught:
                    self.remember(mutant, caught)
                    return caught, time.monotonic() - began
        return None, time.monotonic() - began
