"""Every example at reduced size with the build given by --build, meant for the debug preset with its sanitizers."""
import subprocess
import sys
import tomllib

SMALL, FULL = 0, 1000  # at most
STEPS = 20  # of an example whose numbers are not recorded
# those of acid_fracturing are the same cases once they are reduced
SAME = ("cases/acid_fracturing/coarse", "cases/acid_fracturing/medium")


def recorded(site):
    """Commands that reduce an example and compare its numbers."""
    tool = [sys.executable, site.root / "tests/regression/examples.py"]
    names = subprocess.run([*tool, "--list"], cwd=site.root, capture_output=True, text=True, check=True).stdout.split()
    return {f"cases/{name}": [*tool, "--vug", site.vug, name] for name in names}


def others(site, known):
    """Commands that check and run what is left of the examples, and the cases that have every key, for a few steps."""
    commands = {}
    for path in [*sorted(site.root.glob("cases/**/*.toml")), *sorted(site.root.glob("tests/cases/complete/*.toml"))]:
        name = str(path.relative_to(site.root).with_suffix(""))
        if name in known or name.startswith(SAME):
            continue
        commands[f"check {name}"] = [site.vug, "check", path, "--threads", "1"]
        laboratory = "laboratory" in tomllib.loads(path.read_text(encoding="utf-8"))
        commands[name] = [site.vug, *(["lab", path] if laboratory else ["run", path, "--steps", str(STEPS)]),
                          "--threads", "1", "--quiet", "--overwrite", "-o", site.folder / "example"]
    return commands


def campaign(site, count):
    known = recorded(site)
    commands = others(site, known) | known
    for name in sorted(commands, key=lambda name: "acid_fracturing" in name)[:count]:  # the long ones last
        if not any(True for _ in site.rounds(1)):
            return
        # numbers may differ from the recorded ones between builds; a sanitizer's word is what is looked for
        try:
            done = subprocess.run(list(map(str, commands[name])), cwd=site.root, env=site.environment(),
                                  capture_output=True, text=True, errors="replace", check=False, timeout=site.patience * 60)
        except subprocess.TimeoutExpired:
            site.count(f"not ended in time ({name})")
            continue
        said = done.stdout + done.stderr
        site.count("examples" if name in known else "commands beside them")
        if name in known:
            site.count("with other numbers than those recorded", done.returncode != 0)
        elif done.returncode not in (0, 3):
            site.find(f"{name}: exit code {done.returncode}: {said[-300:]}")
        if "Sanitizer" in said or "runtime error" in said or "Kokkos" in said:
            site.find(f"{name}: {said[-1000:]}")
