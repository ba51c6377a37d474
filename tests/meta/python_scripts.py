"""The Python scripts of scripts/ and perf/ say in one line what is missing or wrong, and replace no page unasked."""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NEED_PACKAGES = ("scripts/acid-ensemble", "scripts/acid-ladder", "scripts/campaign", "scripts/plot",
                 "scripts/reproduce-paper", "scripts/validate", "perf/accuracy_cost", "perf/report", "perf/slow_scenes")


class Called(unittest.TestCase):
    """A folder of its own, from which scripts are called."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, *words, **environment):
        return subprocess.run([sys.executable, "-B", *words], cwd=self.folder, capture_output=True, text=True,
                              env=os.environ | environment)

    def require(self, code, *words, says="", **environment):
        """The exit code, what is said, and no traceback; returns standard output."""
        done = self.call(*words, **environment)
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode, code, said)
        self.assertIn(says, said)
        self.assertNotIn("Traceback", said)
        return done.stdout

    @staticmethod
    def each(check, items):
        """The check of every item; two at a time, because most of it is waiting for a Python to start."""
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(check, items))


# As if another Python had come first, which would not do either: whichever this one is, it starts no further one.
AFTER_ANOTHER = {"VUG_FIRST_PYTHON": "/opt/python3: h5py is missing"}


class Packages(Called):
    def test_an_older_python_is_told(self):
        (self.folder / "sitecustomize.py").write_text("import sys\nsys.version_info = (3, 9, 18)\n")

        def is_told(script):
            says = (f"{pathlib.Path(script).name}: /opt/python3: h5py is missing; {sys.executable}: "
                    "needs Python 3.11 or later, this is 3.9\n")
            self.require(1, ROOT / script, "--help", says=says, PYTHONPATH=str(self.folder), **AFTER_ANOTHER)

        self.each(is_told, NEED_PACKAGES)
        self.require(1, "-c", "try:\n  import vug\nexcept ImportError as error: raise SystemExit(str(error))",
                     says="vug needs Python 3.11", PYTHONPATH=f"{self.folder}:{ROOT / 'python'}")

    def test_packages_that_are_missing_or_do_not_load_are_told(self):
        for text, says in (("raise ModuleNotFoundError('No module', name='numpy')", "numpy is missing (Debian, Ubuntu: apt-get"),
                           ("raise ImportError('built for another numpy')", ": built for another numpy\n")):
            for module in ("h5py", "matplotlib", "numpy"):
                (self.folder / f"{module}.py").write_text(text)

            def is_told(script):
                done = self.call(ROOT / script, "--help", PYTHONPATH=str(self.folder), **AFTER_ANOTHER)
                self.assertRegex(done.stderr, rf"\A{pathlib.Path(script).name}: .*\n\Z")
                self.assertIn(says, done.stderr)

            self.each(is_told, NEED_PACKAGES)

    def test_a_python_without_packages_gives_way_to_that_of_the_distribution(self):
        """A virtual environment of it, which is the same file; its PYTHONPATH is not taken along."""
        system = "/usr/bin/python3"
        if subprocess.run([system, "-c", "import h5py, matplotlib, tomllib"], capture_output=True, check=False).returncode:
            self.skipTest("the distribution's Python has no packages")
        subprocess.run([system, "-m", "venv", "--without-pip", self.folder / "venv"], check=True)
        (self.folder / "numpy.py").write_text("raise ImportError('of the first Python')")

        def gives_way(script):
            done = subprocess.run([self.folder / "venv/bin/python3", "-B", ROOT / script, "--help"], capture_output=True,
                                  text=True, check=False, env=os.environ | {"PYTHONPATH": str(self.folder)})
            self.assertRegex(done.stdout, r"\Ausage: ", done.stderr)

        # one that looks for its Python itself, and one in each folder that leaves it to system_python
        self.each(gives_way, ("scripts/plot", "scripts/campaign", "perf/slow_scenes"))

    def test_help_is_help(self):
        others = ("perf/processors", "perf/report_gpu", "perf/report_step", "perf/sweep_cost", "scripts/mutate",
                  "scripts/scaling")
        self.each(lambda script: self.assertRegex(self.require(0, ROOT / script, "--help"), r"\Ausage: "),
                  (*NEED_PACKAGES, *others))


class Validate(Called):
    """Of a copy of the script whose tests are a ctest that records a row or two, and fails where it is told to."""

    def setUp(self):
        super().setUp()
        (self.folder / "scripts").mkdir()
        for name in ("validate", "validation", "system_python.py", "tables.py"):
            source, to = ROOT / "scripts" / name, self.folder / "scripts" / name
            shutil.copy(source, to) if name == "validate" else to.symlink_to(source)
        self.page = self.folder / "docs/validation.md"
        (self.folder / "docs/validation").mkdir(parents=True)
        self.page.write_text("# Validation\n\n### Speed of the platens\n\n### Toughness\n")
        ctest = self.folder / "bin/ctest"
        ctest.parent.mkdir()
        ctest.write_text("""#!/bin/sh
echo '{"speed": 0.5, "modulus": 27.8e9, "strength": 91.1e6}' >> "$VUG_RECORD/platen_speed.jsonl"
[ -z "$LONG" ] || echo '{"edge": 1e-3, "ratio": 0.9}' >> "$VUG_RECORD/toughness_straight.jsonl"
exit ${FAILS:-0}
""")
        ctest.chmod(0o755)
        (self.folder / "build/openmp").mkdir(parents=True)

    def validate(self, code, *words, says="", **environment):
        return self.require(code, self.folder / "scripts/validate", *words, says=says,
                            PATH=f"{self.folder}/bin:{os.environ['PATH']}", **environment)

    def made(self):
        return (self.folder / "build/validation/validation.md").read_text()

    def test_without_a_build_or_records_nothing_is_made(self):
        before = self.page.read_text()
        self.validate(1, "--write", says="holds no build with tests; scripts/test makes one")
        self.validate(1, "--write", "--draw-only", says="holds no records")
        self.assertEqual(self.page.read_text(), before)

    def test_the_page_of_docs_is_replaced_when_asked_and_whole(self):
        before = self.page.read_text()
        (self.folder / "build/openmp/CTestTestfile.cmake").touch()
        self.validate(0)
        self.assertIn("### Speed of the platens", self.made())
        self.assertEqual(self.page.read_text(), before)
        self.validate(1, "--write", says="no records of Toughness; docs/validation.md is kept")
        self.assertEqual(self.page.read_text(), before)
        self.validate(0, "--write", LONG="1")
        self.assertEqual(self.page.read_text(), self.made())
        self.validate(0, "--write")  # the records of the long test are still there
        self.assertIn("91.10 MPa", self.made())

    def test_tests_that_fail_leave_the_records_of_the_last_time(self):
        (self.folder / "build/openmp/CTestTestfile.cmake").touch()
        self.validate(0)
        before = self.made()
        self.validate(1, "--write", says="tests failed", FAILS="1")
        self.validate(0, "--draw-only")
        self.assertEqual(self.made(), before)


VUG = """#!/bin/sh
# A vug that leaves a run of two snapshots, as much as the scripts read of it.
exec "$PYTHON" - "$@" <<'END'
import json, pathlib, sys
import h5py, numpy as np
words = sys.argv[1:]
case, folder = pathlib.Path(words[1]), pathlib.Path(words[words.index("-o") + 1])
folder.mkdir(parents=True)
sets = [after for word, after in zip(words, words[1:]) if word == "--set"]
(folder / "run.json").write_text(json.dumps(
    {"status": "done", "case_text": case.read_text(), "overrides": sets, "commit": "abc"}))
with h5py.File(folder / "fields.h5", "w") as fields:
    for step, time in enumerate((0, 0.16)):
        group = fields.create_group(f"step_{step}")
        group.attrs.update(time=time, step=step)
        for name in ("node_type", "concentration_L1", "dissolved_fraction"):
            group[name] = np.ones((28, 40)) * (name != "node_type")
            group[name].attrs.update(time=time, dx=2.5e-3)
END
"""


class Acid(Called):
    """acid-ladder and acid-ensemble with a vug that takes no time."""

    def setUp(self):
        super().setUp()
        self.vug, self.runs = self.folder / "vug", self.folder / "runs"
        self.vug.write_text(VUG)
        self.vug.chmod(0o755)

    def acid(self, code, script, *words, says="", vug=None):
        return self.require(code, ROOT / "scripts" / script, "--runs", self.runs, "--vug", vug or self.vug, *words,
                            says=says, PYTHON=sys.executable)

    def test_tables_lie_beside_the_runs_unless_told_otherwise(self):
        docs = {path: path.stat().st_mtime_ns for path in (ROOT / "docs/acid_fracturing").iterdir()}
        self.acid(0, "acid-ladder", "--only", "kept_400", says="written: " + str(self.runs / "ladder.csv"))
        self.assertEqual((self.runs / "ladder.csv").read_text().count("\n"), 2)
        self.assertIn(",abc\n", (self.runs / "ladder.csv").read_text())
        self.acid(0, "acid-ladder", "--draw-only", "-o", "made/anew")
        self.assertTrue((self.folder / "made/anew/ladder.csv").exists())
        self.acid(0, "acid-ensemble", "numerics", "--only", "*p10_da1.5e-05*", says="0 of 1")
        self.assertTrue((self.runs / "ensemble.csv").exists())
        self.assertEqual({path: path.stat().st_mtime_ns for path in (ROOT / "docs/acid_fracturing").iterdir()}, docs)

    def test_a_run_that_is_not_finished_has_no_row(self):
        self.acid(0, "acid-ladder", "--only", "kept_400")
        record = self.runs / "p20_da0.0015/kept_400/run.json"
        record.write_text(record.read_text().replace('"done"', '"interrupted"'))
        self.acid(1, "acid-ladder", "--draw-only", says="no run is finished yet")

    def test_runs_that_fail_are_told(self):
        for script, name, words in (("acid-ladder", "kept_400", ["--only", "kept_400"]),
                                    ("acid-ensemble", "p10_da1.5e-05_seed1", ["numerics", "--only", "the_paper*p10_da1.5e-05*"])):
            self.acid(0, script, *words)  # the table is still written
            for folder in self.runs.rglob(name):
                shutil.rmtree(folder)
            self.acid(1, script, *words, vug="/bin/false", says=f"{name}: vug ended with code 1; see {self.runs}")
        self.require(1, ROOT / "scripts/reproduce-paper", "--coarse", "--only", "p10*5", "-o", self.runs,
                     "--vug", "/bin/false", says="vug ended with code 1; see")

    def test_double_precision_comes_after_the_preset(self):
        for words, settings in (([], 'speed_limit=0.07 *$'), (["--double"], 'speed_limit=0.07 --set accuracy.precision="double" *$')):
            self.require(1, ROOT / "scripts/reproduce-paper", "--medium", *words, "--only", "p10_da1.5", "-o", self.runs,
                         "--vug", "/bin/echo", says="no run has got anywhere yet")
            self.assertRegex((self.runs / "p10_da1.5.log").read_text().splitlines()[-1], settings)

    def test_finished_runs_of_something_else_are_told(self):
        words = ["--only", "kept_400"]
        self.acid(0, "acid-ladder", *words)
        self.assertNotIn("kept (", self.acid(0, "acid-ladder", *words))
        record = self.runs / "p20_da0.0015/kept_400/run.json"
        for old, new, says in (("case_text", "case", "another case file"), ("2e-3", "3e-3", "another case file"),
                               ("lattice.spacing=", "lattice.size=", "other settings")):
            text = record.read_text()
            self.assertIn(old, text)
            record.write_text(text.replace(old, new))
            self.acid(0, "acid-ladder", *words, says=f"finished with {says}; kept (remove ")
            record.write_text(text)

    def test_wrong_words_are_told(self):
        wrong = (("acid-ladder", ["--condition", "20"], "'20' must be a pressure in MPa and Da"),
                 ("acid-ladder", ["--jobs", "0"], "'0' must be a whole number"),
                 ("acid-ensemble", ["--jobs", "-1"], "must be a whole number"),
                 ("reproduce-paper", ["--jobs", "0"], "must be a whole number"),
                 ("mutate", ["--part", "3"], "'3' must be K/N"),
                 ("mutate", ["--part", "0/3"], "'0/3' must be K/N"))
        self.each(lambda each: self.require(2, ROOT / "scripts" / each[0], *each[1], says=each[2]), wrong)

    def test_an_interruption_is_told(self):
        for error, code, says in (("KeyboardInterrupt", 130, "name: interrupted; call it again"),
                                  ("OSError('lost')", 1, "name: lost\n")):
            self.require(code, "-c", f"from paper.compute import finish\ndef main():\n  raise {error}\nfinish('name', main)",
                         says=says, PYTHONPATH=str(ROOT / "scripts"))


class AccuracyCost(Called):
    """Of a copy of the script, with results of its own."""

    def setUp(self):
        super().setUp()
        for name in ("perf/results", "docs", "cases"):
            (self.folder / name).mkdir(parents=True)
        shutil.copy(ROOT / "perf/accuracy_cost", self.folder / "perf")
        (self.folder / "perf/accuracy").symlink_to(ROOT / "perf/accuracy")
        (self.folder / "scripts").symlink_to(ROOT / "scripts")
        self.results = self.folder / "perf/results/accuracy_cost.json"
        shutil.copy(ROOT / "perf/results/accuracy_cost.json", self.results)

    def test_what_there_is_none_of_is_told(self):
        self.require(2, self.folder / "perf/accuracy_cost", "--only", "foo", says="invalid choice: 'foo'")
        self.require(1, self.folder / "perf/accuracy_cost", "--vug", "/bin/false", "--choice", "foo",
                     says="no choice has 'foo' in its name")

    def test_rows_of_choices_that_went_are_dropped_and_machines_are_told(self):
        script = self.folder / "perf/accuracy_cost"
        self.require(0, script, "--draw-only")
        self.assertEqual((self.folder / "docs/accuracy.md").read_text(), (ROOT / "docs/accuracy.md").read_text())
        results = json.loads(self.results.read_text())
        results["rows"][0]["choice"] = "an earlier one"
        results["rows"][1]["machine"] = "another machine"
        self.results.write_text(json.dumps(results))
        self.require(0, script, "--draw-only", says='no choice "an earlier one" any more; its row is dropped')
        self.assertEqual(len(json.loads(self.results.read_text())["rows"]), len(results["rows"]) - 1)
        page = (self.folder / "docs/accuracy.md").read_text().replace("\n", " ")
        self.assertIn("(another machine; x86_64, 2 cores, one thread)", page)


if __name__ == "__main__":
    unittest.main(verbosity=1)
