"""Too little address space: exit code 5 and one line, or a run that is whole."""
import resource

SMALL, FULL = 6, 300
LEAST, MOST = 24 << 20, 320 << 20  # bytes


def limited(site, limit, what):
    site.remove("tight")
    process = site.start(site.rock("tight"), preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
    before = len(site.findings)
    code, said = site.finish(process, what)
    if code == 127 or code == 1 and "vug: " not in said:  # the loader, or a library that starts before vug
        del site.findings[before:]
        code = 127
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
        elif code == 127:
            site.count("before the program")
        elif code is not None:
            site.find(f"{what}: exit code {code}: {said[-300:]}")
