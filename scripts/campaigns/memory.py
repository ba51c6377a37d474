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


def least(works, low, high, tolerance):
    """About the least limit, bytes, with which works(limit) is true; it is with `high`."""
    while high - low > tolerance:
        limit = (low + high) // 2
        low, high = (low, limit) if works(limit) else (limit, high)
    return high


def enough(site):
    """About the least with which the run ends well."""
    return least(lambda limit: limited(site, limit, f"{limit} bytes of memory")[0] == 0, LEAST, MOST, 1 << 20)


def start_of_program(site, edge):
    """About the least with which vug prints a text that it holds. Above it there is a little memory, and then none."""
    def prints(limit):
        process = start(site, limit, TRIFLE)
        process.communicate()
        return process.returncode == 0
    return least(prints, LEAST, edge, 16 << 10)


def campaign(site, count):
    site.whole()
    require_trifle(site)
    edge = enough(site)
    begin = start_of_program(site, edge)
    for number in site.rounds(count):
        # two of three where something has been had and more is wanted: up to the edge, and when the program begins
        ranges = ((int(0.8 * edge), int(1.05 * edge)), (begin, begin + (1 << 20)), (LEAST, MOST))
        limit = site.random.randrange(*ranges[number % 3])
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
