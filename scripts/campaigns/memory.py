"""Too little address space: exit code 5 and one line, or a run that is whole."""
import resource

SMALL, FULL = 6, 300
LEAST, MOST = 24 << 20, 320 << 20  # bytes


def start(site, limit, arguments):
    return site.start(arguments, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))


TRIFLE = ["--cite"]  # a command that needs no memory of its own


def require_trifle(site):
    """It works where there is memory: else every crash would count as one before the program."""
    code, said = site.finish(site.start(TRIFLE), "vug " + " ".join(TRIFLE))
    if code != 0:
        raise SystemExit(f"campaign: `vug {' '.join(TRIFLE)}` failed with all memory there is, exit code {code}: {said[-300:]}")


def limited(site, limit, what):
    """(exit code, what it said) of the run; no exit code where vug cannot even print a text that it holds: libraries that
    start before it, or it itself before its first line, have found no memory."""
    site.remove("tight")
    before = len(site.findings)
    code, said = site.finish(start(site, limit, site.rock("tight")), what)
    if code not in (0, 5):
        kept = site.findings[:]
        if site.finish(start(site, limit, TRIFLE), what)[0] != 0:
            kept = kept[:before]
            code = "before the program"
        site.findings[:] = kept
    return code, said


def enough(site):
    """About the least with which the run ends well."""
    low, high = LEAST, MOST
    while high - low > 1 << 20:
        limit = (low + high) // 2
        low, high = (low, limit) if limited(site, limit, f"{limit} bytes of memory")[0] == 0 else (limit, high)
    return high


def campaign(site, count):
    site.whole()
    require_trifle(site)
    edge = enough(site)
    for number in site.rounds(count):
        # every second one near the edge, where something has been had and more is wanted
        limit = site.random.randrange(*((LEAST, MOST) if number % 2 else (int(0.8 * edge), int(1.05 * edge))))
        what = f"{limit} bytes of memory"
        code, said = limited(site, limit, what)
        site.count("limits")
        if code == 5:
            site.count("refused")
            site.require_one_line(said, what)
        elif code == 0:
            site.require_same("tight", what)
        elif code == "before the program":
            site.count(code)
        elif code is not None:
            site.find(f"{what}: exit code {code}: {said[-300:]}")
