"""scripts/gpu-check on this machine: gpu_check.py VUG.

run: the bundle holds this vug and three programs that stand for tests of a GPU: one passes, one fails, one ends without a
word. What the script says of them, and its exit code, is compared. A vug that was built there is there again afterwards.
pack: a cmake that builds nothing notes how it is called.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SMALL_ROCK = "tests/cases/coupled/small_rock.toml"
PROGRAM = """#!/bin/sh
case "$1" in
--gtest_list_tests) printf 'Suite.\\n  One\\n  Two\\nSlowLong.\\n  Three\\n' ;;
--gtest_filter=Suite.\\*) printf '%s\\n'; exit {code} ;;
*) exit 99 ;;
esac
"""
GOOD = PROGRAM.replace("%s", "[  PASSED  ] 2 tests.").format(code=0).replace(
    "printf '[", "[ -L build/cuda/src/vug ] && printf '[")  # passes where it tests the vug of the bundle
BAD = PROGRAM.replace("%s", "[  FAILED  ] Suite.Two (3 ms)\\n[  FAILED  ] 1 test, listed below:\\n[  FAILED  ] Suite.Two").format(code=1)
SILENT = PROGRAM.replace("%s", "nothing").format(code=0)  # neither passed nor failed
# What a build makes: programs that do nothing, that of cuda unless it is there.
CMAKE = """#!/bin/sh
printf '%s: ' "$(command -v nvcc)" >>calls.txt
printf '<%s>' "$@" >>calls.txt
echo >>calls.txt
[ "$1" = --build ] || exit 0
mkdir -p build/cuda/src build/cuda/tests build/cuda/perf
[ -e build/cuda/src/vug ] || cp /bin/true build/cuda/src/vug
cp /bin/true build/cuda/tests/vug_x_tests
cp /bin/true build/cuda/perf/vug_x_perf
"""
SETUP = """vug_fail() { echo "$*"; exit 1; }
vug_build() { mkdir -p build/openmp/src "$bundle/processor"; cp /bin/true build/openmp/src/vug; }
"""


def check_pack(root):
    for name, text in (("bin/cmake", CMAKE), ("bin/nvcc", "#!/bin/sh\n"), ("bin/xz", "#!/bin/sh\ncat\n"),
                       ("scripts/setup.bash", SETUP)):
        (root / name).parent.mkdir(exist_ok=True)
        (root / name).write_text(text)
        (root / name).chmod(0o755)
    script = shutil.copy(ROOT / "scripts/gpu-check", root / "scripts")
    environment = {"PATH": f"{root}/bin:/usr/bin:/bin"}

    def pack(**more):
        (root / "calls.txt").unlink(missing_ok=True)
        done = subprocess.run([script, "pack"], env=environment | more, capture_output=True, text=True, check=False)
        calls = (root / "calls.txt").read_text()
        if done.returncode != 0 or f"{root}/bin/nvcc: <--preset><cuda>" not in calls:
            sys.exit(f"pack: exit code {done.returncode}:\n{calls}\n{done.stdout}\n{done.stderr}")
        with tarfile.open(root / ".gpu-bundle/bundle.tar.xz") as archive:
            missing = {"./vug", "./vug_x_tests", "./vug_x_perf"} - set(archive.getnames())
        if missing:
            sys.exit(f"pack: the bundle lacks {missing}")
        return calls

    calls = pack()
    if "<-DCMAKE_CXX_FLAGS_RELEASE=-O3 -DNDEBUG>" not in calls or "VUG_GPU_ARCH" in calls:
        sys.exit(f"pack: options of an earlier configuration stay, or the preset's GPU does not:\n{calls}")
    if "<-DVUG_GPU_ARCH=ADA89>" not in pack(VUG_GPU_ARCH="ADA89"):
        sys.exit("pack: not for the GPU of VUG_GPU_ARCH")
    # what `run` leaves where nothing had been built
    (root / "build/cuda/src/vug").unlink()
    (root / "build/cuda/src/vug").symlink_to(root / "build/gpu-bundle/vug")
    pack()


def check_run(vug):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in ("scripts", "tests", "cases"):
            (root / name).symlink_to(ROOT / name)
        bundle = root / "bundle"
        bundle.mkdir()
        (bundle / "vug").symlink_to(vug)
        (bundle / "lib").mkdir()
        built = root / "build/cuda/src/vug"
        built.parent.mkdir(parents=True)
        built.write_text("built here")
        environment = os.environ | {"OMP_PROC_BIND": "false", "VUG_JOBS": "2", "PATH": f"/usr/bin:{os.environ['PATH']}"}
        for name, text in (("good", GOOD), ("bad", BAD), ("silent", SILENT)):
            (bundle / f"vug_{name}_tests").write_text(text)
            (bundle / f"vug_{name}_tests").chmod(0o755)
        subprocess.run([vug, "run", SMALL_ROCK, "--quiet", "-o", bundle / "processor"], cwd=root, env=environment, check=True)
        (root / ".gpu-bundle").mkdir()
        with tarfile.open(root / ".gpu-bundle/bundle.tar.xz", "w:xz", preset=0, dereference=True) as archive:
            archive.add(bundle, ".")
        done = subprocess.run([root / "scripts/gpu-check", "run", root / "out", "tests"], env=environment, capture_output=True,
                              text=True, check=False)
        summary = (root / "out/summary.txt").read_text()
        expected = ["info", "small_rock", "against_processor", "3 test suites, 2 of them failed", "vug_bad_tests Suite.",
                    "vug_silent_tests Suite.", "[  FAILED  ] Suite.Two\n"]
        missing = [text for text in expected if text not in summary]
        if missing or done.returncode != 1 or "vug_good_tests" in summary or summary.count("Suite.Two") != 1:
            sys.exit(f"exit code {done.returncode}, missing {missing}:\n{summary}\n{done.stdout}\n{done.stderr}")
        if built.is_symlink() or built.read_text() != "built here":
            sys.exit(f"{built} is not the one that was built")
        with tarfile.open(root / "out/logs.tar.gz") as logs:
            if "./vug_bad_tests-Suite.log" not in logs.getnames():
                sys.exit(f"logs: {logs.getnames()}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_pack(pathlib.Path(folder))
    check_run(pathlib.Path(sys.argv[1]).resolve())


if __name__ == "__main__":
    main()
