"""Odd settings of OpenMP and Kokkos: refused by one line, or a run with the same bits."""

SMALL, FULL = 4, 300
SETTINGS = {
    "OMP_NUM_THREADS": ["0", "-1", "1", "3", "1000", "abc", "", "2,3", "99999999999999999999"],
    "OMP_THREAD_LIMIT": ["1", "2", "0", "x"],
    "OMP_DYNAMIC": ["true", "false", "maybe"],
    "OMP_MAX_ACTIVE_LEVELS": ["0", "1", "-5"],
    "OMP_SCHEDULE": ["dynamic,1", "guided", "none"],
    "OMP_STACKSIZE": ["1k", "64M", "1x"],
    "OMP_PROC_BIND": ["true", "false", "spread", "odd"],
    "OMP_PLACES": ["cores", "{0}", "{99}", "}{"],
    "OMP_WAIT_POLICY": ["passive", "idle"],
    "OMP_NESTED": ["true"],
    "KOKKOS_NUM_THREADS": ["0", "1", "2", "abc", "4x", "-3", "99999999999"],
    "KOKKOS_DEVICE_ID": ["0", "-1", "7", "x"],
    "KOKKOS_DISABLE_WARNINGS": ["1", "perhaps"],
    "KOKKOS_MAP_DEVICE_ID_BY": ["random", "nothing", "\x1b[31m"],
    "KOKKOS_PRINT_CONFIGURATION": ["1", "x"],
    "KOKKOS_TOOLS_LIBS": ["/nonexistent.so"],
}


def campaign(site, count):
    site.whole()
    for _ in site.rounds(count):
        names = site.random.sample(sorted(SETTINGS), site.random.randint(1, 3))
        settings = {name: site.random.choice(SETTINGS[name]) for name in names}
        threads = site.random.choice([[], [], ["1"], ["2"], ["3"]])
        what = f"{settings} threads {threads}"
        site.remove("odd")
        arguments = site.rock("odd")
        at = arguments.index("--threads")
        arguments[at:at + 2] = ["--threads", *threads] if threads else []
        code, said = site.run(arguments, what, environment=site.environment(**settings))
        site.count("settings")
        if code == 0:
            site.require_same("odd", what)
        elif code == 2:
            site.count("refused")
            if sum(line.startswith("vug: ") for line in said.splitlines()) != 1:
                site.find(f"{what}: not one line: {said[:300]!r}")
        elif code is not None:
            site.find(f"{what}: exit code {code}: {said[-300:]}")
