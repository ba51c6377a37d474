"""Single bits flipped in the files of a run: none is silent."""
from campaigns import damage

SMALL, FULL = 6, 1000


def campaign(site, count):
    damage.prepare(site)
    checkpoints, record = damage.files(site, "checkpoint/*.checkpoint"), damage.files(site, "run.json")
    for _ in site.rounds(count):
        path = site.random.choice(site.random.choice([checkpoints, checkpoints, record]))
        site.renew("damaged", "half")
        data = bytearray((site.folder / "damaged" / path).read_bytes())
        bit = site.random.randrange(8 * len(data))
        data[bit // 8] ^= 1 << bit % 8
        (site.folder / "damaged" / path).write_bytes(data)
        site.count(f"flips in {path.parts[0]}")
        damage.resume(site, path, f"bit {bit} of {path} flipped")
