"""A small case for many steps: memory flat, balances closed."""
import csv
import pathlib
import time

SMALL, FULL = 1_000, 20_000_000  # steps
CLOSED = 1e-6  # of what is inside
# A coarse lattice of soft rock that never breaks, few sub-steps and slow acid: cheap steps, and something left of the
# rock after all of them.
LASTING = {"lattice.spacing": 5e-4, "mechanics.bond.normal_strength": 1e10, "mechanics.bond.cohesion": 1e10,
           "mechanics.young_modulus": 1e8, "mechanics.contact.normal_stiffness": 1e6,
           "mechanics.contact.tangential_stiffness": 4e5, "boundary.injection.flow.pressure": 2e5,
           "reaction.rate_constant": 1e-7}


def campaign(site, count):
    changes = [word for key, value in LASTING.items() for word in ("--set", f"{key}={value:g}")]
    arguments = site.rock("soak", *changes, "--set", f"time.steps={count}", "--set", f"output.interval={2.5e-6 * max(1, count // 40)}",
                          "--set", f"output.checkpoint_interval={2.5e-6 * max(1, count // 20)}")
    arguments = without(arguments, "time.steps=160", "output.interval=5e-5",
                        "output.checkpoint_interval=5e-5")
    process = site.start(arguments)
    memory, start = [], time.monotonic()
    while process.poll() is None and not (site.end and time.monotonic() > site.end):
        if (site.folder / "soak/history.csv").exists():  # before it the program sets up
            memory.append(resident(process.pid))
        time.sleep(0.02 if time.monotonic() - start < 60 else 10)
    if process.poll() is None:
        process.terminate()
    code, said = site.finish(process, "soak")
    if code not in (0, 130):
        site.find(f"exit code {code}: {said[-300:]}")
        return
    rows = list(csv.DictReader(open(site.folder / "soak/history.csv", encoding="utf-8")))
    site.count("steps", int(float(rows[-1]["step_1"])))
    memory = [kib for kib in memory if kib > 0]
    settled = memory[len(memory) // 4:] or [0]  # a run may be too short to be seen
    site.count("KiB of memory after a quarter", settled[0])
    site.count("KiB of memory at the most", max(settled))
    if max(settled) > 1.1 * settled[0] + 4096:
        site.find(f"the memory grew from {settled[0]} to {max(settled)} KiB")
    for name in rows[0]:
        worst = max(abs(float(row[name])) for row in rows)
        if "balance_error" in name and not worst < CLOSED:
            site.find(f"{name} reached {worst:g}")


def without(arguments, *overrides):
    kept = list(arguments)
    for override in overrides:
        at = kept.index(override)
        del kept[at - 1:at + 1]
    return kept


def resident(pid):
    """KiB in memory; 0 when the process has ended."""
    try:
        lines = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="utf-8").splitlines()
    except OSError:
        return 0
    return next((int(line.split()[1]) for line in lines if line.startswith("VmRSS:")), 0)
