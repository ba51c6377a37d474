"""kill -9 of one rank of several at random moments, then --resume on another number: the bits of one never killed."""
import os
import pathlib
import signal
import subprocess
import time

SMALL, FULL = 3, 50
RANKS = (2, 3, 4)
OPEN_MPI = ["--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-q"]  # what its mpirun needs here


def campaign(site, count):
    launcher = launcher_of(site.build)
    if not launcher:
        site.count("not done: built without MPI")
        return
    whole = time_of_whole(site, launcher)
    run = 0
    while site.counts["kills"] < count or not site.counts["runs that ended"]:
        if not any(True for _ in site.rounds(1)):
            return
        started = (site.folder / f"run{run}/run.json").exists()
        number = site.random.choice(RANKS)
        process = start(site, launcher, number, f"run{run}", *(["--resume"] if started else []))
        after, victim = site.random.uniform(0, 1.2 * whole), site.random.randrange(number)
        what = f"kill {site.counts['kills']}, rank {victim} of {number} after {after:.4f} s"
        time.sleep(after)
        ranks = ranks_of(site, process, number)
        if ranks and killed(site, process, ranks, victim, what):
            continue
        code, said = site.finish(process, what, 60)
        if code != 0:
            site.find(f"{what}: exit code {code}: {said[-300:]}")
        else:
            site.require_same(f"run{run}", f"after {site.counts['kills']} kills")
        site.count("runs that ended")
        site.remove(f"run{run}")
        run += 1


def killed(site, process, ranks, victim, what):
    """Kills one, and sees to it that all ranks end in time; whether that came before all had ended by themselves."""
    try:
        os.kill(ranks[victim], signal.SIGKILL)
    except ProcessLookupError:
        return False
    begun = time.monotonic()
    while any(runs(site, pid) for pid in ranks) and time.monotonic() - begun < site.patience:
        time.sleep(0.02)
    waited = time.monotonic() - begun
    left = [pid for pid in ranks if runs(site, pid)]
    if left:
        site.find(f"{what}: {len(left)} ranks were left behind after {site.patience:g} s")
    for pid in left:
        os.kill(pid, signal.SIGKILL)
    try:
        process.wait(timeout=site.patience)
    except subprocess.TimeoutExpired:
        if OPEN_MPI[0] in process.args:
            # mpirun of Open MPI 4.1 waits for itself in PMIx_server_finalize where a rank has died in MPI_Init; no rank does
            site.count("launchers that hung after their ranks had ended")
        else:
            site.find(f"{what}: the launcher has not ended after {site.patience:g} s")
        process.kill()
        process.wait()
    if process.returncode == 0:
        return False
    process.stdout.close()
    site.count("kills")
    site.counts["ms to the end at the most"] = max(site.counts["ms to the end at the most"], int(1e3 * waited))
    return True


def launcher_of(build):
    """How the build under attack starts ranks; none where it has no MPI."""
    found = {}
    if not (build / "CMakeCache.txt").exists():  # a build that was packed and sent
        return None
    for line in (build / "CMakeCache.txt").read_text(encoding="utf-8").splitlines():
        name, _, value = line.partition("=")
        found[name.partition(":")[0]] = value
    if found.get("VUG_MPI", "").upper() not in ("ON", "1", "TRUE"):
        return None
    program = found["MPIEXEC_EXECUTABLE"]
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout
    open_mpi = "Open MPI" in version or "OpenRTE" in version
    return [program] + (OPEN_MPI if open_mpi else [])


def start(site, launcher, number, name, *more):
    command = [*launcher, "-n", str(number), site.vug, *map(str, site.rock(name, *more))]
    return subprocess.Popen(command, cwd=site.root, env=site.environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, start_new_session=True)


def time_of_whole(site, launcher):
    """The run that is compared with, of one rank; and how long one of several takes, s."""
    site.whole()
    begun = time.monotonic()
    code, said = site.finish(start(site, launcher, RANKS[1], "timed"), "undisturbed run of several ranks", 120)
    if code != 0:
        raise SystemExit(f"campaign: the undisturbed run of several ranks failed: {said}")
    site.require_same("timed", "undisturbed run of several ranks")
    site.remove("timed")
    return time.monotonic() - begun


def runs(site, pid):
    try:
        return os.path.realpath(f"/proc/{pid}/exe") == site.vug and state(pid) != "Z"
    except OSError:
        return False


def state(pid):
    return pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[0]


def below(pid):
    try:
        children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="utf-8").split()
    except OSError:
        return []
    return [found for child in map(int, children) for found in [child, *below(child)]]


def ranks_of(site, process, number):
    """Their processes, once all have begun; none where the run has ended."""
    while process.poll() is None:
        found = [pid for pid in below(process.pid) if runs(site, pid)]
        if len(found) == number:
            return found
        time.sleep(0.002)
    return []
