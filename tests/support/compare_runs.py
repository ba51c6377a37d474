"""Bitwise comparison of two run directories: every dataset of both HDF5 files, and history.csv as text."""
import pathlib
import sys

import h5py
import numpy


def datasets(path):
    found = {}
    with h5py.File(path, "r") as file:
        file.visititems(lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    return found


def main(first, second):
    differences = []
    for name in ("fields.h5", "particles.h5"):
        if name == "particles.h5" and not (first / name).exists() and not (second / name).exists():
            continue  # a case without mechanics
        a, b = datasets(first / name), datasets(second / name)
        if not a or sorted(a) != sorted(b):
            differences.append(f"{name}: not the same datasets")
            continue
        differences += [f"{name}:{key}" for key in a if numpy.asarray(a[key]).tobytes() != numpy.asarray(b[key]).tobytes()]
    if (first / "history.csv").read_text() != (second / "history.csv").read_text():
        differences.append("history.csv")
    print("\n".join(differences))
    return 1 if differences else 0


sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
