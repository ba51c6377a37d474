"""cases/cluster/ranks.sbatch: what it does with the signals that Slurm sends, with stand-ins for srun and scontrol.

    cluster_script.py VUG
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

SCRIPT = pathlib.Path("cases/cluster/ranks.sbatch").resolve()
CASE = pathlib.Path("cases/poiseuille.toml").resolve()


def stopped_by(number, folder, vug):
    """Exit code of the script, what it has asked of scontrol, and what the run says of its end."""
    asked, stand_in, out = folder / "asked", folder / "scontrol", folder / "out"
    stand_in.write_text(f'#!/bin/sh\necho "$*" >>"{asked}"\n')
    stand_in.chmod(0o755)
    environment = os.environ | {"PATH": f"{folder}:{os.environ['PATH']}", "VUG": vug, "LAUNCHER": "env", "SLURM_JOB_ID": "77",
                                "OMP_PROC_BIND": "false"}
    job = subprocess.Popen(["bash", SCRIPT, CASE, out, "--set", "time.steps=1000000000"], env=environment, cwd=folder)
    for _ in range(1200):
        if (out / "fields.xdmf").exists():
            break
        time.sleep(0.05)
    job.send_signal(number)
    code = job.wait(timeout=60)
    return code, asked.read_text() if asked.exists() else "", "interrupted by SIGUSR1" in (out / "run.json").read_text()


if __name__ == "__main__":
    program = str(pathlib.Path(sys.argv[1]).resolve())
    # the time is up: on with it in the next turn; cancelled: the state is kept, and nothing more is asked for
    for number, wanted in ((signal.SIGUSR1, (130, "requeue 77\n", True)), (signal.SIGTERM, (130, "", True))):
        with tempfile.TemporaryDirectory() as place:
            found = stopped_by(number, pathlib.Path(place), program)
        print(f"{number.name}: {found}", flush=True)
        if found != wanted:
            sys.exit(f"{number.name}: expected {wanted}")
