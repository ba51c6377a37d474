"""Runs every command of docs/tutorial.md, in its order, in an empty folder: tutorial.py EXECUTABLE [PAGE]."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# what the page says that its commands leave
PROMISED = {"docs/tutorial.md": ["runs/channel/figures/speed.png", "runs/reactive_channel/figures/history_acid.png",
                                 "runs/reactive_channel/figures/history_balances.png",
                                 "runs/reactive_channel/figures/movie.gif", "runs/study/table.csv",
                                 "runs/study/figures/map.png", "runs/rock/figures/history_cracks.png",
                                 "runs/fracture/figures/overview.png", "preview.png", "runs/ct_slice/figures/overview.png"]}


def main(executable, page="docs/tutorial.md"):
    text = (ROOT / page).read_text(encoding="utf-8")
    blocks = re.findall(r"^```sh\n(.*?)^```", text, re.S | re.M)
    # the page's own preparation in the checkout, but for its folder; then the vug of this build
    preparation = re.search(r"^```\n(.*?)^```", text, re.S | re.M)[1].replace("mkdir ~/first-steps && cd ~/first-steps\n", "")
    programs = pathlib.Path(executable).resolve().parent
    environment = os.environ | {"OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false"}
    with tempfile.TemporaryDirectory() as folder:
        for block in blocks:
            commands = f"cd '{ROOT}'\n{preparation}PATH='{programs}':$PATH\ncd '{folder}'\n{block}"
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=folder, env=environment,
                                  capture_output=True, text=True, check=False)
            if done.returncode != 0:
                sys.exit(f"{page}: ended with {done.returncode}:\n{block}\n{done.stdout}{done.stderr}")
        missing = [name for name in PROMISED[page] if not (pathlib.Path(folder) / name).exists()]
        if missing:
            sys.exit(f"{page}: promises what is not there: {', '.join(missing)}")
        keep = os.environ.get("VUG_KEEP_PLOTS")
        if keep:
            subprocess.run(["cp", "-r", f"{folder}/.", keep], check=True)
    print(f"{page}: {len(blocks)} blocks of commands")


main(*sys.argv[1:])
