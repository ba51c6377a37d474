"""Too little address space: exit code 5 and one line, or a run that is whole."""
import resource

SMALL, FULL = 4, 300


def campaign(site, count):
    site.whole()
    for _ in site.rounds(count):
        limit = site.random.randrange(24 << 20, 320 << 20)
        what = f"{limit} bytes of memory"
        site.remove("tight")
        code, said = site.run(site.rock("tight"), what,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
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
