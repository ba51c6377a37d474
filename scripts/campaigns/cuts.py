"""Files of a run cut off anywhere, or emptied: none is silent."""
from campaigns import damage

SMALL, FULL = 5, 300


def campaign(site, count):
    damage.prepare(site)
    paths = damage.files(site, "checkpoint/*.checkpoint", "run.json", "history.csv", "fields/*.h5", "particles/*.h5", "*.xdmf", "*.h5")
    for _ in site.rounds(count):
        path = site.random.choice(paths)
        site.renew("damaged", "half")
        size = (site.folder / "damaged" / path).stat().st_size
        kept = site.random.choice([0, site.random.randrange(max(size, 1)), size - min(size, 1)])
        with open(site.folder / "damaged" / path, "r+b") as file:
            file.truncate(kept)
        site.count("cuts")
        damage.resume(site, path, f"{path} cut to {kept} of {size} bytes")
