"""Fields of a snapshot: one to a picture, and all of them in an overview."""
import numpy as np
from matplotlib import pyplot as plt

from . import cracks
from .style import PORE, ROCK, Scale, length_unit, readable, save

SPECIES_MAPS = ["viridis", "cividis", "plasma", "magma"]  # all of them grow evenly in lightness


class Panel:
    """One field of one snapshot in SI, ready to be drawn. Scales may be given, to keep them over the frames of a movie.
    With `kinds`, names, the values are numbers of these from 0, a colour each, and what is masked is pore."""

    def __init__(self, name, title, unit, values, colours, low=None, high=None, kinds=None):
        self.name, self.title, self.unit, self.values, self.colours = name, title, unit, values, colours
        self.kinds, self.missing = kinds, PORE if kinds else ROCK
        if kinds:
            low, high = -0.5, len(kinds) - 0.5
        finite = np.ma.masked_invalid(values).compressed()
        self.low = low if low is not None else (finite.min() if finite.size else 0)
        self.high = high if high is not None else (finite.max() if finite.size else 1)
        self.uniform = not self.high > self.low
        if self.uniform:  # a narrow scale around it, not an empty one
            self.low, self.high = self.low - 0.5e-3 * abs(self.low), self.high + (0.5e-3 * abs(self.high) or 1)


def solid_mask(snapshot):
    """True where a node is rock, (ny, nx); None when the run has no fields that tell."""
    if "node_type" in snapshot:
        return snapshot["node_type"].values > 0.5
    if "solid_fraction" in snapshot:
        return snapshot["solid_fraction"].values > 0
    return None


def in_fluid(values, solid):
    """Fields of the fluid mean nothing in rock."""
    return np.ma.masked_where(solid, values) if solid is not None and not solid.all() else np.ma.asarray(values)


def _creeps(snapshot):
    """Whether the pressures differ by less than what the seven digits of an absolute pressure resolve well."""
    values = snapshot["pressure"].values
    return "gauge_pressure" in snapshot and np.ptp(values) < 0.01 * np.abs(values).max()


def panels_of(snapshot, creeping=None):
    """What can be drawn of a snapshot, in the order of the overview; of a `creeping` flow the gauge pressure."""
    solid = solid_mask(snapshot)
    panels = []
    if "pressure" in snapshot:
        title = "gauge pressure" if (_creeps(snapshot) if creeping is None else creeping) else "pressure"
        values = in_fluid(snapshot[title.replace(" ", "_")].values, solid)
        panels.append(Panel("pressure", title, snapshot["pressure"].units, values, "viridis"))
    if "velocity" in snapshot:
        speed = in_fluid(np.linalg.norm(snapshot["velocity"].values, axis=-1), solid)
        high = float(np.percentile(speed.compressed(), 99.5)) if speed.count() else None
        panels.append(Panel("speed", "speed", snapshot["velocity"].units, speed, "magma", 0, high))
    if "temperature" in snapshot:
        panels.append(Panel("temperature", "temperature", snapshot["temperature"].units,
                            np.ma.asarray(snapshot["temperature"].values), "inferno"))
    species = [name for name in snapshot if name.startswith("concentration")]
    for k, name in enumerate(species):
        values = in_fluid(snapshot[name].values, solid)
        panels.append(Panel(name, name.replace("concentration_", "concentration of "), snapshot[name].units, values,
                            SPECIES_MAPS[k % len(SPECIES_MAPS)], low=min(0, float(values.min())) if values.count() else 0))
    if "solid_fraction" in snapshot and (solid.any() or "dissolved_fraction" in snapshot or not panels):
        panels.append(Panel("solid_fraction", "solid volume fraction", "1",
                            np.ma.asarray(snapshot["solid_fraction"].values), "bone", 0, 1))
    elif solid is not None and "solid_fraction" not in snapshot and (solid.any() or not panels):
        panels.append(Panel("rock", "rock", "1", np.ma.asarray(solid.astype(float)), "bone", 0, 1))
    if "mineral" in snapshot:
        numbers = np.ma.masked_less(snapshot["mineral"].values, 0)
        names, most = list(snapshot.minerals), int(numbers.max()) if numbers.count() else 0
        names += [str(number) for number in range(len(names), most + 1)]
        panels.append(Panel("mineral", "mineral", "1", numbers, "cividis", kinds=names))
    known = {"mineral", "pressure", "gauge_pressure", "velocity", "temperature", "solid_fraction", "node_type", *species}
    for name in snapshot:
        if name not in known and len(snapshot[name].shape) == 2:
            panels.append(Panel(name, name.replace("_", " "), snapshot[name].units,
                                np.ma.asarray(snapshot[name].values), "cividis"))
    return panels


class Frame:
    """Where the lattice lies: `extent` (left, right, bottom, top) in `unit`, which is `scale` to the metre."""

    def __init__(self, snapshot):
        field = snapshot[next(iter(snapshot))]
        ny, nx = field.shape[:2]
        self.scale, self.unit = length_unit(max(nx, ny) * field.spacing)
        self.extent = (0, nx * field.spacing * self.scale, 0, ny * field.spacing * self.scale)
        self.shape = ny / nx


def draw_panel(axes, panel, frame, segments=(), title=None):
    """Draws a field with the cracks on it and a colour bar as high as the picture; returns the image."""
    extent, scale = frame.extent, Scale(panel.unit, panel.low, panel.high)
    colours = plt.get_cmap(panel.colours, len(panel.kinds) if panel.kinds else None).copy()
    colours.set_bad(panel.missing)
    image = axes.imshow(scale(panel.values), origin="lower", extent=extent, cmap=colours, vmin=scale(panel.low),
                        vmax=scale(panel.high), interpolation="nearest", aspect="equal")
    cracks.draw(axes, segments)
    axes.set_xlim(extent[0], extent[1])
    axes.set_ylim(extent[2], extent[3])
    axes.set_xlabel(f"x / {frame.unit}")
    axes.set_ylabel(f"y / {frame.unit}")
    axes.set_title(title if title is not None else panel.title, fontsize=10)
    if frame.shape < 1 / 3:  # a strip: the bar lies below it
        bar = axes.figure.colorbar(image, ax=axes, orientation="horizontal", fraction=0.12, aspect=40, pad=0.02)
    else:
        bar = axes.figure.colorbar(image, cax=axes.inset_axes([1.02, 0, 0.03, 1]))
    bar.set_label(scale.label)
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


def time_of(snapshot):
    """"t = 2.5 ms"."""
    factor, unit = readable("s", snapshot.time)
    return f"t = {factor * snapshot.time:.4g} {unit}"


def field(snapshot, panel, path, heading=""):
    """One field of a snapshot, `panel` of panels_of(snapshot), with its cracks; writes a PNG."""
    frame = Frame(snapshot)
    segments = cracks.segments_of(snapshot.rock, frame.scale)
    figure, axes = plt.subplots(figsize=panel_size(frame.shape, 7.2), layout="constrained")
    draw_panel(axes, panel, frame, segments, f"{heading}{panel.title}, {time_of(snapshot)}")
    cracks.legend(figure, segments)
    return save(figure, path)


def overview_figure(snapshot, heading="", panels=None):
    """A figure with all fields of a snapshot."""
    panels = panels or panels_of(snapshot)
    frame = Frame(snapshot)
    segments, shape = cracks.segments_of(snapshot.rock, frame.scale), frame.shape
    width, height = panel_size(shape, 4.8)
    columns = 1 if shape < 1 / 3 else 2 if len(panels) in (2, 4) and shape < 2 else 3
    if shape >= 1 / 3 and (len(panels) in (7, 8) or shape > 1.5):
        columns = 4
    columns = min(len(panels), columns)
    if shape < 1 / 3:
        width, height = 9, panel_size(shape, 9)[1]
    rows = -(-len(panels) // columns)
    figure, grid = plt.subplots(rows, columns, squeeze=False, layout="constrained",
                                figsize=(width * columns, height * rows + 0.7))
    for axes, panel in zip(grid.flat, panels):
        draw_panel(axes, panel, frame, segments)
    for axes in grid.flat[len(panels):]:
        axes.set_visible(False)
    figure.suptitle(heading + time_of(snapshot), fontsize=13)
    cracks.legend(figure, segments)
    return figure


def overview(snapshot, path, heading=""):
    """All fields of a snapshot in one picture; writes a PNG."""
    return save(overview_figure(snapshot, heading), path)
