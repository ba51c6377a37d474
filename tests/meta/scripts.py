"""Scripts that check or start something say what is wrong in one line, with the exit code that is due."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
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

    def test_skipped_tests_are_named_and_must_be_listed(self):
        """Of a report of ctest itself."""
        (self.folder / "CTestTestfile.cmake").write_text(
            'add_test(A.One "echo" "a_test.cpp:7: Skipped\nno gmsh\n[  SKIPPED ]")\n'
            'add_test(Two "echo" "SKIPPED: no MPI")\nadd_test(Three "echo" "done")\n'
            'set_tests_properties(A.One Two Three PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED")\n')
        self.require(0, "ctest", "--output-junit", self.folder / "tests.xml")
        (self.folder / "skips.txt").write_text("# may be skipped\nA.One: without gmsh\nTwo: without MPI\n")
        names = [sys.executable, ROOT / "tests/meta/skipped.py", "tests.xml", "skips.txt"]
        self.require(0, *names, says="skipped: A.One (no gmsh)\nskipped: Two (no MPI)\n")
        (self.folder / "skips.txt").write_text("Two: without MPI\n")
        self.require(1, *names, says="skipped: A.One (no gmsh), which skips.txt does not have\nskipped: Two (no MPI)\n")

    def test_run_tells_its_use_before_it_builds(self):
        """Of a copy beside which nothing can be built."""
        script = self.folder / "scripts/run"
        script.parent.mkdir()
        shutil.copy(ROOT / "scripts/run", script)
        self.require(0, script, "--help", says="CASE.toml")
        self.require(2, script, "missing.toml", says="missing.toml: there is no such file")
        self.require(2, script, "--quiet", says="the case comes first")

    def test_run_draws_the_folder_that_is_named(self):
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
        for words, expected in ((["-oout"], "run case.toml -oout\nplot out\n"),
                                (["-o", "my out", "--quiet"], "run case.toml -o my out --quiet\nplot my out\n"),
                                (["--output=out"], "run case.toml --output=out\nplot out\n"),
                                (["--overwrite"], "run case.toml -o runs/case --overwrite\nplot runs/case\n")):
            self.assertEqual(self.call(script, "case.toml", *words).stdout, expected)

    def test_what_run_configures(self):
        """Warnings are errors in CI only; where there is no dpkg, and so perhaps no GoogleTest, there are no tests."""
        tools = self.folder / "bin"
        for name, text in (("bin/cmake", 'echo "$@" >>called'), ("scripts/plot", ":"), ("build/openmp/src/vug", ":"),
                           *((f"bin/{name}", "echo ii") for name in ("ninja", "c++", "python3", "dpkg-query"))):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text("#!/bin/bash\n" + text + "\n")
            os.chmod(self.folder / name, 0o755)
        for name in ("basename", "dirname", "mkdir"):
            (tools / name).symlink_to(shutil.which(name))
        for name in ("run", "setup.bash"):
            shutil.copy(ROOT / "scripts" / name, self.folder / "scripts")
        for environment, configured in (({}, ""), ({"CI": "1"}, " -DVUG_WERROR=ON")):
            (self.folder / "called").unlink(missing_ok=True)
            done = self.call("/bin/bash", "scripts/run", env={"PATH": str(tools)} | environment)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"--preset openmp{configured}\n", (self.folder / "called").read_text())
        (tools / "dpkg-query").unlink()
        self.call("/bin/bash", "scripts/run", env={"PATH": str(tools)})
        self.assertIn("--preset openmp -DVUG_TESTS=OFF\n", (self.folder / "called").read_text())

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

    def test_matrix_reports_what_is_left_out(self):
        """Where a part's tool is missing, it has not passed."""
        (self.folder / "scripts").mkdir()
        (self.folder / "scripts/setup.bash").write_text("set -euo pipefail\nvug_root=$PWD\nvug_build() { :; }\n")
        (self.folder / "bin").mkdir()
        for tool in filter(shutil.which, ("bash", "cat", "cut", "dirname", "getconf", "git", "grep", "nproc", "sed")):
            (self.folder / "bin" / tool).symlink_to(shutil.which(tool))
        script = shutil.copy(ROOT / "scripts/ci-matrix", self.folder / "scripts")
        done = self.call(script, "format", "tidy", "cuda", "headers", env=os.environ | {"PATH": str(self.folder / "bin")})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for part in ("format", "tidy", "cuda"):
            self.assertRegex(done.stdout, rf"\n{part} +left out ")
        self.assertRegex(done.stdout, r"\nheaders +passed ")

    def test_help_is_help_before_anything_is_installed(self):
        """Of copies beside which nothing can be installed or built."""
        path = self.folder / "bin"
        path.mkdir()
        for tool in ("bash", "dirname", "sed"):
            (path / tool).symlink_to(shutil.which(tool))
        for name in ("ci-matrix", "hip-check", "record-regression", "run", "setup.bash", "site", "stability-map", "test"):
            (self.folder / "scripts").mkdir(exist_ok=True)
            shutil.copy(ROOT / "scripts" / name, self.folder / "scripts")
        (self.folder / "perf").mkdir()
        shutil.copy(ROOT / "perf/measure", self.folder / "perf")
        for name in ("scripts/ci-matrix", "scripts/hip-check", "scripts/record-regression", "scripts/run", "scripts/site",
                     "scripts/stability-map", "scripts/test", "perf/measure"):
            done = self.call(self.folder / name, "--help", env={"PATH": str(path)})
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            self.assertIn(name, done.stdout)

    def test_builds_are_looked_for_from_where_one_stands(self):
        self.require(1, ROOT / "scripts/stability-map", "my", says="stability-map: my is no build")
        self.require(1, ROOT / "perf/measure", "my", says="measure: my/perf/vug_dem_perf is not there")
        (self.folder / "my/src").mkdir(parents=True)
        (self.folder / "my/src/vug").touch()
        self.require(1, ROOT / "scripts/scaling", "strong", "--build", "my", says="scaling: my was built without MPI")
        self.require(1, ROOT / "scripts/scaling", "strong", "--build", "my", "--case", "lost.toml",
                     says="scaling: lost.toml is not there")
        self.require(1, ROOT / "scripts/scaling", "strong", "--build", "other",
                     says="other/src/vug is not there; cmake --preset mpi")
        self.require(1, ROOT / "perf/processors", "my", says="processors: my/perf/vug_kernels_perf is not there")
        self.require(1, ROOT / "perf/slow_scenes", "--vug", "lost", says="slow_scenes: lost is not there")
        self.require(1, ROOT / "perf/sweep_cost", "--vug", "lost", says="sweep_cost: lost is not there")
        self.require(1, ROOT / "scripts/campaign", "--small", "--build", "lost", says="campaign: lost/src/vug is not there")

    def test_hip_check_begins_anew_after_a_configuration_that_failed(self):
        """With two versions of Kokkos beside each other; a cmake that fails the first time, a hipcc that compiles all."""
        def write(name, text):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(text)
            os.chmod(self.folder / name, 0o755)

        version = re.search(r"^set\(VUG_KOKKOS_VERSION (.*)\)", (ROOT / "cmake/kokkos.cmake").read_text(), flags=re.M)[1]
        write("scripts/setup.bash", """set -euo pipefail
vug_root=$PWD vug_packages=()
vug_install_packages() { :; }
vug_build() { :; }
vug_fail() { echo "$*"; exit 1; }
""")
        write("cmake/kokkos.cmake", f"set(VUG_KOKKOS_VERSION {version})\n")
        write("build/openmp/CMakeCache.txt", f"VUG_DEPS_DIR:PATH={self.folder}/.deps\n")
        for name in (version, "5.99.0"):
            write(f".deps/kokkos-{name}/cmake/kokkos_compiler_id.cmake", f"SET(KOKKOS_HIPCC_MINIMUM 6.2.0)\n# {name}\n")
        write("bin/cmake", "#!/bin/sh\n[ -e failed ] || { touch failed; exit 1; }\nmkdir -p build/hip-check/kokkos\n"
                           "touch build/hip-check/kokkos/KokkosCore_config.h\n")
        write("bin/hipcc", "#!/bin/sh\n")
        script = shutil.copy(ROOT / "scripts/hip-check", self.folder / "scripts")
        for code, says in ((1, "configuring Kokkos failed"), (0, "compiled  a.cpp")):
            done = self.call(script, "a.cpp", env=os.environ | {"PATH": f"{self.folder}/bin:{os.environ['PATH']}"})
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
            self.assertIn(says, done.stdout)
        source = self.folder / "build/hip-check/source"
        self.assertEqual([path.name for path in source.iterdir()], ["cmake"])
        text = (source / "cmake/kokkos_compiler_id.cmake").read_text()
        self.assertEqual(text, f"SET(KOKKOS_HIPCC_MINIMUM 5.2.0)\n# {version}\n")

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
