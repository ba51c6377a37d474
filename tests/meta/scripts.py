"""Scripts that check or start something say what is wrong in one line, with the exit code that is due."""
import json
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

    def test_matrix_reports_what_fails_and_goes_on(self):
        """The cuda part has a folder of its own, since CMake keeps options; what ends a part ends no other."""
        for name, text in (("scripts/setup.bash", "set -euo pipefail\nvug_root=$PWD\nvug_fail() { exit 1; }\n"
                            'vug_build() { echo "build $*"; [[ $1 != cuda_check ]] || vug_fail; }\n'),
                           ("bin/nvcc", "#!/bin/sh\n")):
            (self.folder / name).parent.mkdir()
            (self.folder / name).write_text(text)
            os.chmod(self.folder / name, 0o755)
        script = shutil.copy(ROOT / "scripts/ci-matrix", self.folder / "scripts")
        path = f"{self.folder}/bin:{os.environ['PATH']}"
        done = self.call(script, "cuda", "headers", env=os.environ | {"PATH": path})
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("build cuda_check --target all\n", done.stdout)
        self.assertRegex(done.stdout, r"\ncuda +FAILED .*\nheaders +passed ")

    def test_presets_are_whole(self):
        """What can be configured can be built, and tested where it has tests; options of one are not those of another."""
        presets = json.loads((ROOT / "CMakePresets.json").read_text())
        options, names = {}, []
        for preset in presets["configurePresets"]:
            options[preset["name"]] = options.get(preset.get("inherits"), {}) | preset.get("cacheVariables", {})
            if not preset.get("hidden"):
                names.append(preset["name"])
        self.assertEqual([preset["name"] for preset in presets["buildPresets"]], names)
        self.assertEqual([preset["name"] for preset in presets["testPresets"]],
                         [name for name in names if options[name].get("VUG_TESTS") != "OFF"])
        self.assertEqual(options["cuda"] | {"VUG_TESTS": "OFF", "VUG_PERF": "OFF", "CMAKE_CXX_FLAGS_RELEASE": "-O0 -DNDEBUG"},
                         options["cuda_check"])


if __name__ == "__main__":
    unittest.main(verbosity=1)
