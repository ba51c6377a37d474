"""How several ranks end: one line, one exit code, no rank left behind, and a checkpoint that can be resumed.

    ends.py VUG MPIRUN...
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

VUG, MPIRUN = sys.argv[1], sys.argv[2:]
ROCK = "tests/cases/coupled/small_rock.toml"
ENVIRONMENT = os.environ | {"OMP_PROC_BIND": "false", "OMP_WAIT_POLICY": "passive"}
LONG = ["--quiet", "--threads", "1", "--set", "lattice.spacing=1.25e-4", "--set", "output.interval=2.5e-5"]


def start(ranks, *words):
    return subprocess.Popen([*MPIRUN, "-n", str(ranks), VUG, *map(str, words)], env=ENVIRONMENT, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)


def end(process, within=60):
    out, err = process.communicate(timeout=within)
    return process.returncode, [line for line in (out + err).splitlines() if line.startswith("vug: ")]


def ranks_below(pid):
    """The processes of vug that a launcher has started, itself or by a helper of its own."""
    found = []
    for child in pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split():
        is_rank = pathlib.Path(f"/proc/{child}/comm").read_text().strip() == "vug"
        found += [int(child)] if is_rank else ranks_below(int(child))
    return found


def wait_for_checkpoint(folder):
    for _ in range(1200):
        if any(folder.glob("checkpoint/*.checkpoint")):
            return
        time.sleep(0.05)
    sys.exit("no checkpoint came")


def expect(what, found, wanted):
    print(f"{what}: {found}", flush=True)
    if found != wanted:
        sys.exit(f"{what}: expected {wanted}")


def main(root):
    for words in (["check", ROCK], ["new", "channel", root / "new.toml"], ["sweep", "study.toml"], ["watch", root], ["man"]):
        code, lines = end(start(2, *words))
        expect("a command for one rank", (code, len(lines)), (2, 1))
        assert "2 ranks were started" in lines[0], lines
    assert not (root / "new.toml").exists()
    process = start(3, "info")
    places = [line for line in process.communicate(timeout=60)[0].splitlines() if line.startswith("rank ")]
    expect("where ranks compute", [place.split()[:2] for place in places], [["rank", str(r)] for r in range(3)])
    environment = {name: value for name, value in ENVIRONMENT.items() if name not in ("OMP_NUM_THREADS", "KOKKOS_NUM_THREADS")}
    two = set(sorted(os.sched_getaffinity(0))[:2])  # of three or more they are not all that the machine has
    shared = subprocess.run([*MPIRUN, "-n", "2", VUG, "info", "--json"], env=environment, text=True, capture_output=True,
                            preexec_fn=lambda: os.sched_setaffinity(0, two))
    expect("threads of two ranks on two processors", json.loads(shared.stdout)["threads"], 1)
    crowded = subprocess.run([*MPIRUN, "-n", "2", VUG, "run", "cases/tutorial/channel.toml", "-o", root / "crowded", "--quiet",
                              "--steps", "2", "--threads", "2"], env=environment, text=True, capture_output=True,
                             preexec_fn=lambda: os.sched_setaffinity(0, two))
    expect("more threads than processors", crowded.stderr.count(
        f"warning: threads: 2 processes of 2 on {len(two)} processor"), 1)
    code, lines = end(start(3, "run", ROCK, "-o", root / "no", "--set", "lattice.spacing=-1"))
    expect("an invalid case", (code, len(lines), (root / "no").exists()), (2, 1, False))
    unknown = [VUG, "run", ROCK, "--nosuch"]
    late_first = ["-n", "1", "sh", "-c", 'sleep 1; exec "$@"', "sh", *unknown, ":", "-n", "2", *unknown]
    code, lines = end(subprocess.Popen([*MPIRUN, *late_first], env=ENVIRONMENT, text=True, stderr=subprocess.PIPE,
                                       stdout=subprocess.PIPE))
    expect("an unknown option, to a first rank that comes late", (code, len(lines)), (2, 1))
    too_much = ["--quiet", "--set", "boundary.injection.flow.pressure=3e9"]
    code, lines = end(start(3, "run", ROCK, "-o", root / "diverged", *too_much))
    expect("a run that diverges", (code, len(lines)), (3, 1))

    stopped = start(2, "run", ROCK, "-o", root / "stopped", *LONG)
    wait_for_checkpoint(root / "stopped")
    stopped.send_signal(signal.SIGTERM)
    code, lines = end(stopped)
    expect("stopped by a signal", (code != 0, len(lines) <= 1), (True, True))

    preload = ["--set", "rock.element_size=1e-3", "--set", "mechanics.preload=\"dynamic\"",
               "--set", "mechanics.preload_time=2e-2"]
    ramped = start(2, "run", ROCK, "-o", root / "ramped", "--quiet", "--threads", "1", *preload)
    while not (root / "ramped/run.json").exists():
        time.sleep(0.05)
    time.sleep(0.5)
    os.kill(ranks_below(ramped.pid)[1], signal.SIGUSR1)
    code, lines = end(ramped, within=20)
    expect("one rank asked to stop during the preload", (code, lines),
           (130, ["vug: interrupted by SIGUSR1; there is no checkpoint yet"]))

    killed = start(3, "run", ROCK, "-o", root / "killed", *LONG)
    wait_for_checkpoint(root / "killed")
    os.kill(ranks_below(killed.pid)[1], signal.SIGKILL)
    begun = time.monotonic()
    code, lines = end(killed)
    expect("one rank killed", (code != 0, time.monotonic() - begun < 10), (True, True))

    for name in ("stopped", "killed"):
        code, lines = end(start(2, "run", ROCK, "-o", root / name, *LONG, "--resume", "--steps", "60"), within=300)
        expect(f"resumed where it was {name}", (code, lines), (0, []))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        main(pathlib.Path(folder))
