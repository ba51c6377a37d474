"""The Python scripts of scripts/ and perf/ say in one line what is missing or wrong, and replace no page or table unasked."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NEED_PACKAGES = ("scripts/acid-ensemble", "scripts/acid-ladder", "scripts/campaign", "scripts/plot", "scripts/reproduce-paper",
                 "scripts/validate", "perf/accuracy_cost", "perf/report", "perf/slow_scenes")


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
        """Standard error of at most one line, besides the use that argparse prints."""
        done = self.call(*words, **environment)
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode, code, said)
        self.assertIn(says, said)
        self.assertNotIn("Traceback", said)
        return done.stdout


class Packages(Called):
    def test_an_older_python_is_told(self):
        (self.folder / "sitecustomize.py").write_text("import sys\nsys.version_info = (3, 9, 18)\n")
        for script in NEED_PACKAGES:
            name = pathlib.Path(script).name
            self.require(1, ROOT / script, "--help", says=f"{name}: needs Python 3.11 or later, this is 3.9\n", PYTHONPATH=str(self.folder))
        self.require(1, "-c", "try:\n  import vug\nexcept ImportError as error: raise SystemExit(str(error))",
                     says="vug needs Python 3.11", PYTHONPATH=f"{self.folder}:{ROOT / 'python'}")

    def test_packages_that_are_missing_or_do_not_load_are_told(self):
        for text, says in (("raise ModuleNotFoundError('No module', name='numpy')", "numpy is missing (Debian, Ubuntu: apt-get"),
                           ("raise ImportError('built for another numpy')", ": built for another numpy\n")):
            for module in ("h5py", "matplotlib", "numpy"):
                (self.folder / f"{module}.py").write_text(text)
            for script in NEED_PACKAGES:
                self.require(1, ROOT / script, "--help", says=f"{pathlib.Path(script).name}: ", PYTHONPATH=str(self.folder))
                self.require(1, ROOT / script, "--help", says=says, PYTHONPATH=str(self.folder))

    def test_help_is_help(self):
        for script in (*NEED_PACKAGES, "perf/processors", "perf/report_gpu", "perf/report_step", "perf/sweep_cost", "scripts/mutate",
                       "scripts/scaling"):
            self.assertRegex(self.require(0, ROOT / script, "--help"), r"\Ausage: ")


class Validate(Called):
    """Of a copy of the script whose tests are a ctest that records one row of one section, and fails where it is told to."""

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


if __name__ == "__main__":
    unittest.main(verbosity=1)
