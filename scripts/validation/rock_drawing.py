"""What the figures of rock mechanics share."""
import pathlib
import sys

import numpy as np
from matplotlib.collections import LineCollection

from PIL import Image

from .records import save as save_full

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from vug.plot.cracks import SHEAR, TENSION

BLUE, RED, GREY, ORANGE, GREEN = "#2166ac", "#d6181f", "#555555", "#e08214", "#1b7837"
MPA, GPA = 1e6, 1e9


def save(figure, path):
    """With 48 colours, which halves pictures of many thin lines."""
    save_full(figure, path)
    Image.open(path).convert("RGB").quantize(48, dither=Image.Dither.NONE).save(path, optimize=True)


def column(rows, key):
    return np.array([row[key] for row in rows])


def groups(rows, key):
    """Rows by the value of a key, in the order of first appearance."""
    found = {}
    for row in rows:
        found.setdefault(row[key], []).append(row)
    return found


def cracks(axes, rows):
    """Failed bonds, in cm: tension blue, shear red."""
    for shear, colour, label in ((0, TENSION, "tension"), (1, SHEAR, "shear")):
        lines = [[(100 * r["x0"], 100 * r["y0"]), (100 * r["x1"], 100 * r["y1"])] for r in rows
                 if r.get("shear", 0) == shear]
        axes.add_collection(LineCollection(lines, colors=colour, linewidths=1.2, label=label))
    axes.set_aspect("equal")
    axes.set_xlabel("x / cm")
