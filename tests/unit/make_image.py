"""Writes a picture of 4 x 3 pixels with the values 0, 1, ... 11 times a step: make_image.py FILE KIND.

TIFF by Pillow or by hand, NPY by numpy, NRRD and raw by hand: nothing is shared with the reader.
"""
import gzip
import struct
import sys

import numpy as np

WIDTH, HEIGHT = 4, 3


def values(dtype, step):
    return (np.arange(WIDTH * HEIGHT).reshape(HEIGHT, WIDTH) * step).astype(dtype)


def tiff_by_hand(order, array, tags=(), photometric=1, sample_format=1):
    """An uncompressed strip per row, values first and the directory last."""
    data = array.astype(array.dtype.newbyteorder(order)).tobytes()
    row = len(data) // HEIGHT
    words = {256: WIDTH, 257: HEIGHT, 258: 8 * array.dtype.itemsize, 259: 1, 262: photometric, 277: 1, 278: 1,
             339: sample_format}
    strips = struct.pack(f"{order}3I3I", *(8 + row * y for y in range(HEIGHT)), *(row,) * HEIGHT)
    extra = 8 + len(data) + len(strips)
    entries = [struct.pack(f"{order}HHIHH", tag, 3, 1, value, 0) for tag, value in words.items()]
    entries += [struct.pack(f"{order}HHII", 273, 4, 3, 8 + len(data)), struct.pack(f"{order}HHII", 279, 4, 3, 8 + len(data) + 12)]
    tail = b""
    for tag, kind, content in tags:
        count = 1 if kind == 5 else len(content)
        if kind == 3:
            entries.append(struct.pack(f"{order}HHIHH", tag, 3, 1, content[0], 0))
            continue
        entries.append(struct.pack(f"{order}HHII", tag, kind, count, extra + len(tail)))
        tail += content
    entries.sort(key=lambda entry: struct.unpack(f"{order}H", entry[:2]))
    at = extra + len(tail)
    mark = b"II*\0" if order == "<" else b"MM\0*"
    return (mark + struct.pack(f"{order}I", at) + data + strips + tail
            + struct.pack(f"{order}H", len(entries)) + b"".join(entries) + struct.pack(f"{order}I", 0))


def rational(order, value):
    return struct.pack(f"{order}II", int(value), 1)


def nrrd(array, kind, encoding, endian="little", more=""):
    data = array.astype(array.dtype.newbyteorder("<" if endian == "little" else ">")).tobytes()
    sizes = " ".join(str(n) for n in reversed(array.shape))
    header = (f"NRRD0004\n# a comment: with a colon\ntype: {kind}\ndimension: {array.ndim}\nsizes: {sizes}\n"
              f"encoding: {encoding}\nendian: {endian}\n{more}key:=value\n\n")
    return header.encode() + (gzip.compress(data) if encoding == "gzip" else data)


def by_pillow(path, arrays, **options):
    from PIL import Image

    first, *others = [Image.fromarray(array) for array in arrays]
    first.save(path, format="TIFF", save_all=True, append_images=others, **options)


def main(path, kind):
    grey16 = values("u2", 5957)
    if kind.startswith("pillow_"):
        what, compression = kind.split("_", 2)[1:]
        array = {"u1": values("u1", 23), "u2": grey16, "i4": values("i4", 100000), "f4": values("f4", 0.25)}[what]
        return by_pillow(path, [array], compression=compression)
    if kind == "stack":
        return by_pillow(path, [values("u1", 1), values("u1", 23)], compression="tiff_lzw")
    if kind == "rgb":
        return by_pillow(path, [np.repeat(values("u1", 23)[..., None], 3, axis=2)], compression="tiff_deflate")
    content = {
        "little": lambda: tiff_by_hand("<", grey16),
        "big": lambda: tiff_by_hand(">", grey16),
        "fill_order_2": lambda: tiff_by_hand("<", np.array([[int(f"{v:08b}"[::-1], 2) for v in row] for row in values("u1", 23)],
                                                           dtype="u1"), [(266, 3, [2])]),
        "white_is_zero": lambda: tiff_by_hand(">", grey16, photometric=0),
        "dark": lambda: tiff_by_hand("<", values("u2", 23)),
        "inch": lambda: tiff_by_hand("<", grey16, [(282, 5, rational("<", 25400)), (283, 5, rational("<", 25400)), (296, 3, [2])]),
        "imagej": lambda: tiff_by_hand("<", grey16, [(270, 2, b"ImageJ=1.53\nunit=micron\n\0"), (282, 5, rational("<", 2)),
                                                      (283, 5, rational("<", 2)), (296, 3, [1])]),
        "oblong": lambda: tiff_by_hand("<", grey16, [(282, 5, rational("<", 100)), (283, 5, rational("<", 200)), (296, 3, [3])]),
        "nrrd_raw": lambda: nrrd(grey16, "uint16", "raw", more='space directions: (0.005,0) (0,0.005)\nspace units: "mm" "mm"\n'),
        "nrrd_gzip": lambda: nrrd(grey16, "unsigned short", "gzip", more='spacings: 5 5\nunits: "um" "um"\n'),
        "nrrd_big": lambda: nrrd(grey16, "ushort", "raw", "big"),
        "nrrd_stack": lambda: nrrd(np.stack([values("u1", 1), values("u1", 23)]), "uchar", "gzip"),
        "nrrd_bzip2": lambda: nrrd(grey16, "uint16", "bzip2"),
        "raw_i2": lambda: values(">i2", 1).tobytes(),
        "raw_nan": lambda: np.where(values("f4", 1) == 6, np.nan, values("f4", 1)).astype("<f4").tobytes(),
    }
    if kind in content:
        with open(path, "wb") as file:
            file.write(content[kind]())
    elif kind == "npy_fortran":
        np.save(path, np.asfortranarray(grey16))
    elif kind == "npy_stack":
        np.save(path, np.stack([values("i8", 1), values("i8", 1) + 100]))
    elif kind == "npy_rgb":
        np.save(path, np.zeros((8, 6, 3), "u1"))
    elif kind.startswith("npy_"):
        np.save(path, values(kind[4:], 1) % 2 if kind == "npy_?" else values(kind[4:], 1))
    else:
        raise SystemExit(f"unknown kind {kind}")


main(sys.argv[1], sys.argv[2])
