"""One field of a snapshot on a pair of axes."""
import numpy as np
from matplotlib import pyplot as plt
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from ..errors import VugError
from . import cracks, triangles
from .style import PORE, ROCK, Scale, length_unit


class Panel:
    """One field of one snapshot in SI, ready to be drawn. Scales may be given, to keep them over the frames of a movie.
    With `kinds`, names, the values are numbers of these from 0, a colour each, and what is masked is pore. With `corners`,
    (count, 3, 2) m, they are those of triangles."""

    def __init__(self, name, title, unit, values, colours, low=None, high=None, kinds=None, corners=None):
        self.name, self.title, self.unit, self.values, self.colours = name, title, unit, values, colours
        self.kinds, self.corners, self.missing = kinds, corners, PORE if kinds else ROCK
        if kinds:
            low, high = -0.5, len(kinds) - 0.5
        finite = np.ma.masked_invalid(values).compressed()
        self.low = low if low is not None else (finite.min() if finite.size else 0)
        self.high = high if high is not None else (finite.max() if finite.size else 1)
        self.uniform = not self.high > self.low
        if self.uniform:  # a narrow scale around it, not an empty one
            self.low, self.high = self.low - 0.5e-3 * abs(self.low), self.high + (0.5e-3 * abs(self.high) or 1)


class Frame:
    """Where the lattice lies: `extent` (left, right, bottom, top) in `unit`, which is `scale` to the metre; of a snapshot
    without a field on the lattice where its triangles lie. Raises VugError of one with neither."""

    def __init__(self, snapshot):
        left, right, bottom, top = _place_of(snapshot)
        self.scale, self.unit = length_unit(max(right - left, top - bottom))
        self.extent = tuple(self.scale * place for place in (left, right, bottom, top))
        self.shape = (top - bottom) / (right - left)


def _place_of(snapshot):
    """(left, right, bottom, top), m."""
    for name in snapshot:
        ny, nx = snapshot[name].shape[:2]
        return 0, nx * snapshot[name].spacing, 0, ny * snapshot[name].spacing
    corners = triangles.corners_of(snapshot.rock)
    if corners is None:
        raise VugError(f"the snapshot at t = {snapshot.time:g} s holds no field that could be drawn; output.fields of its case "
                       "says what is stored")
    low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
    return low[0], high[0], low[1], high[1]


def _beyond(panel, scale):
    """On which ends of the colour bar values lie beyond it, as Matplotlib says it, and in words how far they go."""
    finite = np.ma.masked_invalid(panel.values).compressed()
    least, largest = (finite.min(), finite.max()) if finite.size else (panel.low, panel.high)
    below, above = least < panel.low, largest > panel.high
    if below and above:
        return "both", f", {scale(least):.3g} to {scale(largest):.3g}"
    if above:
        return "max", f", up to {scale(largest):.3g}"
    return ("min", f", down to {scale(least):.3g}") if below else ("neither", "")


def draw_panel(axes, panel, frame, segments=(), title=None):
    """Draws a field with the cracks on it and a colour bar as high as the picture; returns the image."""
    extent, scale = frame.extent, Scale(panel.unit, panel.low, panel.high)
    extend, beyond = _beyond(panel, scale)
    colours = plt.get_cmap(panel.colours, len(panel.kinds) if panel.kinds else None).copy()
    colours.set_bad(panel.missing)
    limits = {"cmap": colours, "norm": Normalize(scale(panel.low), scale(panel.high))}
    if panel.corners is None:
        image = axes.imshow(scale(panel.values), origin="lower", extent=extent, interpolation="nearest", **limits)
    else:
        image = axes.add_collection(PolyCollection(frame.scale * panel.corners, array=scale(panel.values), edgecolors="face",
                                                   linewidths=0.2, **limits))
    axes.set_aspect("equal")
    cracks.draw(axes, segments)
    axes.set_xlim(extent[0], extent[1])
    axes.set_ylim(extent[2], extent[3])
    axes.set_xlabel(f"x / {frame.unit}")
    axes.set_ylabel(f"y / {frame.unit}")
    axes.set_title(title if title is not None else panel.title, fontsize=10)
    if frame.shape < 1 / 3:  # a strip: the bar lies below it
        bar = axes.figure.colorbar(image, ax=axes, orientation="horizontal", fraction=0.12, aspect=40, pad=0.02,
                                   extend=extend)
    else:
        bar = axes.figure.colorbar(image, cax=axes.inset_axes([1.02, 0, 0.03, 1]), extend=extend)
    bar.set_label(scale.label + beyond)
    bar.outline.set_visible(False)
    if panel.kinds:
        bar.set_ticks(range(len(panel.kinds)), labels=panel.kinds)
        return image
    bar.formatter.set_powerlimits((-3, 4))
    bar.update_ticks()
    return image


def panel_size(shape, width):
    """Inches of one panel with its labels and its bar, whatever the aspect of the lattice."""
    if shape > 2:  # tall: keep the height
        return max(2.6, 1.7 + 1.8 * width / shape), 1.8 * width
    if shape < 1 / 3:  # a strip: its bar lies below it
        return width, 0.88 * width * shape + 1.6
    return width, max(1.9, 0.72 * width * shape + 0.6)
