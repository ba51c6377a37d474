"""The Python scripts of scripts/ and perf/ say in one line what is missing or wrong, and replace no page or table unasked."""
import os
import pathlib
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


if __name__ == "__main__":
    unittest.main(verbosity=1)
