"""Every example at reduced size with the build given by --build, meant for the debug preset with its sanitizers."""
import subprocess
import sys

SMALL, FULL = 0, 1000  # at most


def campaign(site, count):
    examples = [sys.executable, site.root / "tests/regression/examples.py"]
    names = subprocess.run([*examples, "--list"], cwd=site.root, capture_output=True, text=True, check=True).stdout.split()
    for number in site.rounds(min(count, len(names))):
        # numbers may differ from the recorded ones between builds; a sanitizer's word is what is looked for
        done = subprocess.run([*examples, "--vug", site.vug, names[number]], cwd=site.root, env=site.environment(),
                              capture_output=True, text=True, errors="replace", check=False)
        said = done.stdout + done.stderr
        site.count("examples")
        site.count("with other numbers than those recorded", done.returncode != 0)
        if "Sanitizer" in said or "runtime error" in said or "Kokkos" in said:
            site.find(f"{names[number]}: {said[-1000:]}")
