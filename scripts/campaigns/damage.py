"""A run stopped half-way, one of its files damaged, then --resume: the same bits, or the damage is told."""
from campaigns.site import Site

HALF = 100  # of the brief run's 160 steps


def prepare(site: Site):
    site.whole()
    code, said = site.run(site.rock("half", "--steps", str(HALF)), "half a run", 60)
    if code != 0:
        raise SystemExit(f"campaign: half a run failed: {said}")


def files(site, *patterns):
    return sorted(path.relative_to(site.folder / "half") for pattern in patterns for path in (site.folder / "half").glob(pattern))


def resume(site, path, what):
    """Goes on from the damaged folder and judges."""
    arguments = [argument for argument in site.rock("damaged", "--resume") if argument != "--quiet"]
    code, said = site.run(arguments, what)
    if code is None:
        return
    if code != 0:
        site.count("refused")
        last = [line for line in said.splitlines() if line.startswith("vug: ")]
        if len(last) != 1 or code not in (2, 4):
            site.find(f"{what}: exit code {code}: {said[-300:]!r}")
        return
    difference = site.difference("damaged")
    told = path.name in said or difference.startswith("unreadable")
    if not difference:
        site.count("gone on with the same bits")
        newest = f"step_{HALF:012}.checkpoint"  # nobody looks at the other while this one is sound
        if path.name == newest and newest not in said:
            site.find(f"{what}: nothing was said of the damaged checkpoint")
    elif told:
        site.count("told")
    else:
        site.count("silent")
        site.find(f"{what}: silent: {difference}")
