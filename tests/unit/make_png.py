"""Writes a PNG of 3 x 2 pixels with the values 0, 0.2, ... 1: make_png.py FILE KIND."""
import struct
import sys
import zlib


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(depth, colour_type, rows, palette=b""):
    raw = b"".join(b"\0" + row for row in rows)
    header = struct.pack(">IIBBBBB", 3, 2, depth, colour_type, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + (chunk(b"PLTE", palette) if palette else b"")
            + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def picture(kind):
    def rows(pixel):
        return [b"".join(pixel(3 * y + x) for x in range(3)) for y in range(2)]

    def b8(i):
        return bytes([51 * i])

    def b16(i):
        return struct.pack(">H", 13107 * i)

    if kind == "grey8":
        return png(8, 0, rows(b8))
    if kind == "grey16":
        return png(16, 0, rows(b16))
    if kind == "grey4":  # two pixels a byte
        return png(4, 0, [bytes([0x03, 0x60]), bytes([0x9C, 0xF0])])
    if kind == "rgb8":
        return png(8, 2, rows(lambda i: 3 * b8(i)))
    if kind == "rgb16":
        return png(16, 2, rows(lambda i: 3 * b16(i)))
    if kind == "rgba8":
        return png(8, 6, rows(lambda i: 3 * b8(i) + b"\xff"))
    if kind == "transparent":
        return png(8, 6, rows(lambda i: 3 * b8(i) + b"\0"))
    if kind == "greyalpha16":
        return png(16, 4, rows(lambda i: b16(i) + b"\xff\xff"))
    if kind == "palette8":
        return png(8, 3, rows(lambda i: bytes([5 - i])), b"".join(3 * b8(5 - i) for i in range(6)))
    raise SystemExit(f"unknown kind {kind}")


with open(sys.argv[1], "wb") as file:
    file.write(picture(sys.argv[2]))
