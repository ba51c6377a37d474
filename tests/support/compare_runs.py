"""Bitwise comparison of two run directories: every dataset of both HDF5 files, and history.csv as text."""
import pathlib
import sys

import h5py
import numpy


def datasets(group, prefix=""):
    """Every dataset below `group`, with its path; through links to other files, which visititems() passes over."""
    found = {}
    for name, item in group.items():
        if item is None:
            raise OSError(f"{prefix}{name} leads to nothing that can be read")
        found |= {prefix + name: item[()]} if isinstance(item, h5py.Dataset) else datasets(item, f"{prefix}{name}/")
    return found


def read(path):
    with h5py.File(path, "r") as file:
        return datasets(file)


def differences_of(first, second):
    """What is not the same, one line each."""
    differences = []
    for name in ("fields.h5", "particles.h5"):
        if name == "particles.h5" and not (first / name).exists() and not (second / name).exists():
            continue  # a case without mechanics
        a, b = read(first / name), read(second / name)
        if not a or sorted(a) != sorted(b):
            differences.append(f"{name}: not the same datasets")
            continue
        differences += [f"{name}:{key}" for key in a if numpy.asarray(a[key]).tobytes() != numpy.asarray(b[key]).tobytes()]
    if (first / "history.csv").read_text() != (second / "history.csv").read_text():
        differences.append("history.csv")
    return differences


def main(first, second):
    differences = differences_of(first, second)
    print("\n".join(differences))
    return 1 if differences else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
