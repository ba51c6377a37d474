"""Disks that are full at any moment: exit code 4 and one line; with room again the run goes on with the same bits."""
import resource
import signal

SMALL, FULL = 3, 300


def campaign(site, count):
    site.whole()
    largest = max(path.stat().st_size for path in (site.folder / "whole").rglob("*") if path.is_file())
    for _ in site.rounds(count):
        limit = site.random.randrange(largest + 4096)

        def full():
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)  # vug's own affair
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))

        what = f"no file beyond {limit} bytes"
        site.remove("full")
        code, said = site.run(site.rock("full"), what, preexec_fn=full)
        site.count("full disks")
        if code == 4:
            site.require_one_line(said, what)
        elif code not in (0, None):
            site.find(f"{what}: exit code {code}: {said[-300:]}")
        started = (site.folder / "full/run.json").exists()
        code, said = site.run(site.rock("full", "--resume" if started else "--overwrite"), f"{what}, with room again")
        if code != 0:
            site.find(f"{what}, with room again: exit code {code}: {said[-300:]}")
        else:
            site.require_same("full", what)
