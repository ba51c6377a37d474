"""Installs a build into a folder, moves that folder, and uses what is in it: install.py BUILD."""
import os
import pathlib
import subprocess
import sys
import tempfile


def call(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: ended with {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout


with tempfile.TemporaryDirectory() as folder:
    first, prefix, work = (pathlib.Path(folder) / name for name in ("first", "moved here", "work"))
    call("cmake", "--install", sys.argv[1], "--prefix", first)
    first.rename(prefix)
    work.mkdir()
    environment = {"PATH": f"{prefix / 'bin'}:/usr/bin:/bin", "HOME": folder, "OMP_NUM_THREADS": "1"}
    assert "vug" in call(prefix / "bin/vug", "info", env=environment)
    call("vug", "new", "channel", cwd=work, env=environment)
    call("vug", "run", "channel.toml", "--steps", "50", "--quiet", cwd=work, env=environment)
    call("vug", "check", prefix / "share/vug/cases/ct_slice/ct_slice.toml", cwd=work, env=environment)
    assert "speed.png" in call("vug-plot", "runs/channel", cwd=work, env=environment)
    assert (prefix / "share/man/man1/vug.1").read_text().startswith(".Dd")
    for name in ("share/vug/case.schema.json", "share/bash-completion/completions/vug", "share/doc/vug/docs/case-file.md",
                 "share/doc/vug/copyright"):
        assert (prefix / name).stat().st_size > 0, name
    for path in prefix.rglob("*"):  # nothing points back to where it was built
        if path.is_symlink():
            assert not os.path.isabs(os.readlink(path)), path
    print("installed, moved, used")
