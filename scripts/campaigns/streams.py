"""Standard streams closed, full or broken: the exit code that is due, and results that are whole."""
import os
import subprocess

SMALL, FULL = 5, 300
KINDS = ("open", "closed", "full", "broken")


def campaign(site, count):
    site.whole()
    for _ in site.rounds(count):
        kinds = [site.random.choice(KINDS[:2]), site.random.choice(KINDS), site.random.choice(KINDS)]
        what = f"streams {kinds}"
        site.remove("out")
        arguments, due = site.random.choice(
            [(site.rock("out"), 0), ([a for a in site.rock("out") if a != "--quiet"], 0),
             (["check", "tests/cases/coupled/small_rock.toml", "--threads", "1"], 0 if kinds[1] == "open" else 4),
             (["info"], 0 if kinds[1] == "open" else 4), (["check", "tests/cases/broken/unknown_key.toml"], 2),
             (["walk"], 2)])
        code = start(site, arguments, kinds, f"{what} {arguments[0]}")
        site.count("commands")
        if code is not None and code != due:
            site.find(f"{what}: {' '.join(map(str, arguments))}: exit code {code}, not {due}")
        if arguments[0] == "run" and code == 0:
            site.require_same("out", what)


def start(site, arguments, kinds, what):
    """The exit code of vug with its three streams as they are said to be."""
    opened = []
    for kind in kinds:
        if kind == "broken":
            reader, writer = os.pipe()
            os.close(reader)
            opened.append(writer)
        else:
            opened.append(os.open("/dev/full" if kind == "full" else "/dev/null", os.O_RDWR))

    def close():
        for number, kind in enumerate(kinds):
            if kind == "closed":
                os.close(number)

    process = site.start(arguments, stdin=opened[0], stdout=opened[1], stderr=opened[2], preexec_fn=close)
    for number in opened:
        os.close(number)
    return site.finish(process, what)[0]
