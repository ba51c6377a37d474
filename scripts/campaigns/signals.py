"""Signals at random moments: answered in time, the state kept, and --resume goes on with the same bits."""
import signal
import time

SMALL, FULL = 4, 1000
STOPS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU, signal.SIGUSR1]
OTHERS = [signal.SIGPIPE, signal.SIGXFSZ, signal.SIGWINCH, signal.SIGCHLD, signal.SIGCONT]


def campaign(site, count):
    whole = site.whole()
    run = 0
    for number in site.rounds(count):
        started = (site.folder / f"run{run}/run.json").exists()
        process = site.start(site.rock(f"run{run}", *(["--resume"] if started else [])))
        sent = site.random.choice(STOPS + OTHERS[:1 + number % len(OTHERS)])
        after = site.random.uniform(0.02, 0.8 * whole)
        time.sleep(after)
        process.send_signal(sent)
        what = f"{sent.name} after {after:.4f} s"
        code, said = finish(site, process, what, sent)
        site.count("signals")
        if code == 130:
            site.count("stopped")
            if sent not in STOPS:
                site.find(f"{what} stopped the run")
        elif code == 0:
            site.count("runs that ended")
            site.require_same(f"run{run}", what)
            site.remove(f"run{run}")
            run += 1
        elif code is not None and code != -sent:
            site.find(f"{what}: exit code {code}: {said[-300:]}")


def finish(site, process, what, sent):
    """As Site.finish; the system itself ends a program that has not begun to listen."""
    before = len(site.findings)
    code, said = site.finish(process, what)
    if code == -sent:
        del site.findings[before:]
        site.count("before the program listened")
    return code, said
