"""kill -9 at random moments, then --resume: the bits of a run never killed."""
import time

SMALL, FULL = 4, 1000


def campaign(site, count):
    whole = site.whole()
    run = 0
    while site.counts["kills"] < count or not site.counts["runs that ended"]:
        if not any(True for _ in site.rounds(1)):
            return
        started = (site.folder / f"run{run}/run.json").exists()
        process = site.start(site.rock(f"run{run}", *(["--resume"] if started else [])))
        after = site.random.uniform(0, 1.2 * whole)
        time.sleep(after)
        process.kill()
        code, said = site.finish(process, f"kill {site.counts['kills']} after {after:.4f} s")
        if code == -9:
            site.count("kills")
            continue
        if code != 0:
            site.find(f"after {site.counts['kills']} kills: exit code {code}: {said[-300:]}")
        else:
            site.require_same(f"run{run}", f"after {site.counts['kills']} kills")
        site.count("runs that ended")
        site.remove(f"run{run}")
        run += 1
