"""Scripts that check or start something say what is wrong in one line, with the exit code that is due."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Scripts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, *words, **options):
        return subprocess.run(words, cwd=self.folder, capture_output=True, text=True, **options)

    def require(self, code, *words, says=""):
        done = self.call(*words)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertIn(says, done.stdout + done.stderr)
        self.assertLessEqual(done.stderr.count("\n"), 1, done.stderr)

    def compare(self, code, a, b, *more, says=""):
        for name, text in (("a.csv", a), ("b.csv", b)):
            (self.folder / name).write_text("time_s,x_m\n" + text)
        self.require(code, ROOT / "scripts/compare-histories", "a.csv", "b.csv", *more, says=says)

    def test_histories_that_differ_are_told(self):
        same = "0,1\n1,2\n"
        self.compare(0, same, same)
        self.compare(0, same, "0,1\n1,2.0000001\n")
        self.compare(1, same, "0,1\n1,2.1\n", says="x_m")
        self.compare(0, same, "0,1\n1,2.1\n", "0.1")
        self.compare(1, "0,0\n1,0\n", same)  # a column that is 0 throughout in the first
        for first, second in (("0,1\n1,nan\n", same), (same, "0,1\n1,nan\n"), ("0,1\n1,nan\n", "0,1\n1,nan\n"),
                              (same, "0,1\n1,inf\n")):
            self.compare(1, first, second, says="inf  x_m")

    def test_histories_that_cannot_be_compared_are_told(self):
        same = "0,1\n1,2\n"
        self.compare(2, same, same, "little", says="BOUND = little must be a number")
        self.compare(2, same, same, "-1", says="BOUND")
        self.compare(4, same, "0,1\n1\n", says="b.csv:3: has 1 cells")
        self.compare(4, same, "0,1\n1,two\n", says="'two'")
        self.compare(4, same, "", says="b.csv: holds no row")
        script = ROOT / "scripts/compare-histories"
        self.require(4, script, "a.csv", "missing.csv", says="missing.csv: No such file")
        self.require(2, script, "a.csv", says="wants A.csv B.csv")

    def test_run_tells_its_use_before_it_builds(self):
        """Of a copy beside which nothing can be built."""
        script = self.folder / "scripts/run"
        script.parent.mkdir()
        shutil.copy(ROOT / "scripts/run", script)
        self.require(0, script, "--help", says="CASE.toml")
        self.require(2, script, "missing.toml", says="missing.toml: there is no such file")
        self.require(2, script, "--quiet", says="the case comes first")

    def test_run_leaves_the_folder_to_who_names_it(self):
        script = self.folder / "scripts/run"
        script.parent.mkdir()
        shutil.copy(ROOT / "scripts/run", script)
        (script.parent / "setup.bash").write_text("vug_root=$PWD\nvug_build() { :; }\n")
        (self.folder / "case.toml").touch()
        program = self.folder / "build/openmp/src/vug"
        program.parent.mkdir(parents=True)
        program.write_text('#!/bin/sh\necho "$@"\n')
        plot = script.parent / "plot"
        plot.write_text('#!/bin/sh\necho plot "$@"\n')
        for path in (program, plot):
            os.chmod(path, 0o755)
        for words, expected in ((["-oout"], "run case.toml -oout\n"), (["-o", "out"], "run case.toml -o out\n"),
                                (["--output=out"], "run case.toml --output=out\n"),
                                (["--overwrite"], "run case.toml -o runs/case --overwrite\nplot runs/case\n")):
            self.assertEqual(self.call(script, "case.toml", *words).stdout, expected)


if __name__ == "__main__":
    unittest.main(verbosity=1)
