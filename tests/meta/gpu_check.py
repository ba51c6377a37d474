"""scripts/gpu-check run on this machine: gpu_check.py VUG. The bundle holds this vug and three programs that stand for
tests of a GPU: one passes, one fails, one ends without a word. What the script says of them, and its exit code, is compared.
"""
import os
import pathlib
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
GOOD = PROGRAM.replace("%s", "[  PASSED  ] 2 tests.").format(code=0)
BAD = PROGRAM.replace("%s", "[  FAILED  ] Suite.Two (3 ms)\\n[  FAILED  ] 1 test, listed below:\\n[  FAILED  ] Suite.Two").format(code=1)
SILENT = PROGRAM.replace("%s", "nothing").format(code=0)  # neither passed nor failed


def main():
    vug = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in ("scripts", "tests", "cases"):
            (root / name).symlink_to(ROOT / name)
        bundle = root / "bundle"
        bundle.mkdir()
        (bundle / "vug").symlink_to(vug)
        (bundle / "lib").mkdir()
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
        with tarfile.open(root / "out/logs.tar.gz") as logs:
            if "./vug_bad_tests-Suite.log" not in logs.getnames():
                sys.exit(f"logs: {logs.getnames()}")


if __name__ == "__main__":
    main()
