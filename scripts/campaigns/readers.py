"""Damaged inputs to every reader, in one process: each is accepted or refused by one line."""
import json
import os
import signal
import struct
import subprocess

SMALL, FULL = 30_000, 10_000_000
# share of the inputs: readers of text take longer
SHARES = {"png": 0.2, "raw": 0.2, "mesh": 0.35, "repaired": 0.1, "checkpoint": 0.1, "case": 0.04, "set": 0.01}
PIECE = 200_000


def campaign(site, count):
    for reader, share in SHARES.items():
        findings = site.kept / reader
        findings.mkdir(parents=True, exist_ok=True)
        first, last, ends = 0, round(share * count), 0
        while first < last and ends < 10 and any(True for _ in site.rounds(1)):
            first, ended = read(site, reader, first, min(PIECE, last - first), findings)
            ends += ended


def read(site, reader, first, count, findings):
    """Reads `count` inputs; the number of the next one, and whether an input has ended the process."""
    environment = site.environment(ASAN_OPTIONS="allocator_may_return_null=0")
    if os.access("/dev/shm", os.W_OK):
        environment["TMPDIR"] = "/dev/shm"  # images and checkpoints are files
    done = subprocess.run([site.build / "tests/vug_fuzz_readers", reader, str(site.seed), str(first), str(count), findings],
                          cwd=site.root, env=environment, capture_output=True, text=True, errors="replace", check=False)
    for line in done.stderr.splitlines():
        if line.startswith(f"{reader}-{site.seed}-"):
            site.find(f"{findings}/{line}")
    if done.returncode == 0:
        counted = json.loads(done.stdout)
        site.count("inputs", count)
        site.count("accepted", counted["accepted"])
        return first + count, False
    at = struct.unpack("=Q", (findings / "at").read_bytes())[0]
    how = "takes more than 10 s" if done.returncode == -signal.SIGALRM else f"ends the process ({done.returncode})"
    site.find(f"vug_fuzz_readers {reader} {site.seed} {at} 1 {findings} {how}: {done.stderr[-600:]}")
    site.count("inputs", at + 1 - first)
    return at + 1, True
