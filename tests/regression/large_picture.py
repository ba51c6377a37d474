"""The memory that a crop of a 20 000 x 14 000 picture takes, by format: large_picture.py EXECUTABLE.

It must be that of the lattice and of a few rows, whatever the size of the picture. Prints the peak of each (ru_maxrss).
"""
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

WIDTH, HEIGHT = 20000, 14000
BOUND = 64  # MiB; the picture has 267 or 534
CASE = """
[lattice]
size = [{}e-6, {}e-6]
spacing = {}e-6
time_step = 1e-7
[time]
steps = 2
[geometry]
type = "image"
pixel_size = 1e-6
[flow]
viscosity = 1e-6
"""


def raw(path):
    """16 bits, and no more on the disk than its last byte."""
    with open(path, "wb") as file:
        file.truncate(2 * WIDTH * HEIGHT)


def compressed(row):
    packer = zlib.compressobj(1)
    return b"".join(packer.compress(row) for _ in range(HEIGHT)) + packer.flush()


def png(path):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 0, 0, 0, 0)) +
                   chunk(b"IDAT", compressed(bytes(WIDTH + 1))) + chunk(b"IEND", b""))


def tiff(path):
    """One strip, compressed: the least convenient there is."""
    data = compressed(bytes(WIDTH))
    fields = [(256, WIDTH), (257, HEIGHT), (258, 8), (259, 8), (262, 1), (273, 8), (277, 1), (278, HEIGHT), (279, len(data))]
    with open(path, "wb") as file:
        file.write(struct.pack("<2sHI", b"II", 42, 8 + len(data)) + data + struct.pack("<H", len(fields)))
        file.write(b"".join(struct.pack("<HHII", tag, 4, 1, value) for tag, value in fields) + bytes(4))


def peak_of(words):
    """MiB that the command takes at most."""
    child = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    said = child.stdout.read()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: ended with {child.returncode}: {said}")
    return usage.ru_maxrss / 1024


def main(executable):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "crop.toml").write_text(CASE.format(200, 140, 1))
        (folder / "whole.toml").write_text(CASE.format(WIDTH, HEIGHT, 50))
        crop = ["crop_from=[19000,13000]", "crop_size=[200,140]"]
        for name, write, more in (("a.raw", raw, [f"raw_size=[{WIDTH},{HEIGHT}]", "raw_type=uint16"]), ("a.png", png, []),
                                  ("a.tif", tiff, [])):
            write(folder / name)
            for case, keys in (("crop", crop), ("whole", ["coarsen=50"])):
                keys = [f"file={name}", "grey_range=[0,255]", "invert=true", *more, *keys]
                words = [executable, "check", folder / f"{case}.toml", *(f"--set=geometry.{key}" for key in keys)]
                peak = peak_of(words)
                print(f"{name}, {case}: {peak:.0f} MiB")
                if peak > BOUND:
                    sys.exit(f"{name}, {case}: {peak:.0f} MiB; at most {BOUND} MiB were expected")
            (folder / name).unlink()


main(*sys.argv[1:])
