"""Fields of a snapshot: one to a picture, and all of them in an overview."""
import numpy as np
from matplotlib import pyplot as plt

from ..errors import VugError
from . import cracks, triangles
from .panel import Frame, Panel, draw_panel, panel_size
from .style import readable, save

SPECIES_MAPS = ["viridis", "cividis", "plasma", "magma"]  # all of them grow evenly in lightness


OPENING = 2  # of node_type: inside an opening, where no fluid is computed


def solid_mask(snapshot):
    """True where a node is rock, (ny, nx), which an opening is not; None when the run has no fields that tell."""
    if "node_type" in snapshot:
        return np.rint(snapshot["node_type"].values) == 1
    if "solid_fraction" in snapshot:
        return snapshot["solid_fraction"].values > 0
    return None


def no_fluid_mask(snapshot):
    """True where fields of the fluid mean nothing, in rock and in openings; None as solid_mask."""
    solid = solid_mask(snapshot)
    return solid | (np.rint(snapshot["node_type"].values) == OPENING) if "node_type" in snapshot else solid


def outside_openings(snapshot, name):
    """A field that rock and fluid have, masked in openings, where nothing is computed."""
    values = snapshot[name].values
    if "node_type" not in snapshot or snapshot["node_type"].shape != values.shape:
        return np.ma.asarray(values)
    return np.ma.masked_where(np.rint(snapshot["node_type"].values) == OPENING, values)


def in_fluid(values, outside):
    """Values of the fluid, masked where there is none."""
    return np.ma.masked_where(outside, values) if outside is not None and not outside.all() else np.ma.asarray(values)


def _creeps(snapshot):
    """Whether the pressures differ by less than what the seven digits of an absolute pressure resolve well."""
    values = snapshot["pressure"].values
    return "gauge_pressure" in snapshot and np.ptp(values) < 0.01 * np.abs(values).max()


def panels_of(snapshot, creeping=None):
    """What can be drawn of a snapshot, in the order of the overview; of a `creeping` flow the gauge pressure. Where nothing flows,
    displacement and stress of the rock's triangles."""
    solid, outside = solid_mask(snapshot), no_fluid_mask(snapshot)
    species = [name for name in snapshot if name.startswith("concentration")]
    panels = []
    if not species and not any(name in snapshot for name in ("pressure", "gauge_pressure", "velocity")):
        panels += [Panel(corners=corners, **described) for described, corners in triangles.described(snapshot.rock)]
    of_rock = bool(panels)
    if "pressure" in snapshot:
        title = "gauge pressure" if (_creeps(snapshot) if creeping is None else creeping) else "pressure"
        values = in_fluid(snapshot[title.replace(" ", "_")].values, outside)
        panels.append(Panel("pressure", title, snapshot["pressure"].units, values, "viridis"))
    elif "gauge_pressure" in snapshot:
        values = in_fluid(snapshot["gauge_pressure"].values, outside)
        panels.append(Panel("gauge_pressure", "gauge pressure", snapshot["gauge_pressure"].units, values, "viridis"))
    if "velocity" in snapshot:
        speed = in_fluid(np.linalg.norm(snapshot["velocity"].values, axis=-1), outside)
        high = float(np.percentile(speed.compressed(), 99.5)) if speed.count() else None
        panels.append(Panel("speed", "speed", snapshot["velocity"].units, speed, "magma", 0, high))
    if "temperature" in snapshot:
        panels.append(Panel("temperature", "temperature", snapshot["temperature"].units,
                            outside_openings(snapshot, "temperature"), "inferno"))
    for k, name in enumerate(species):
        values = in_fluid(snapshot[name].values, outside)
        panels.append(Panel(name, name.replace("concentration_", "concentration of "), snapshot[name].units, values,
                            SPECIES_MAPS[k % len(SPECIES_MAPS)], low=min(0, float(values.min())) if values.count() else 0))
    if of_rock and solid is not None and solid.all():
        pass  # the triangles show it
    elif "solid_fraction" in snapshot and (solid.any() or "dissolved_fraction" in snapshot or not panels):
        panels.append(Panel("solid_fraction", "solid volume fraction", "1",
                            outside_openings(snapshot, "solid_fraction"), "bone", 0, 1))
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
                                outside_openings(snapshot, name), "cividis"))
    return panels


def time_of(snapshot):
    """"t = 2.5 ms"."""
    factor, unit = readable("s", snapshot.time)
    return f"t = {factor * snapshot.time:.4g} {unit}"


def segments_on(panel, snapshot, frame):
    """The cracks of a snapshot: on triangles where they are now, on the lattice where they were at the start."""
    return cracks.segments_of(snapshot.rock, frame.scale, moved=panel.corners is not None)


def field(snapshot, panel, path, heading=""):
    """One field of a snapshot, `panel` of panels_of(snapshot), with its cracks; writes a PNG."""
    frame = Frame(snapshot)
    segments = segments_on(panel, snapshot, frame)
    figure, axes = plt.subplots(figsize=panel_size(frame.shape, 7.2), layout="constrained")
    draw_panel(axes, panel, frame, segments, f"{heading}{panel.title}, {time_of(snapshot)}")
    cracks.legend(figure, segments)
    return save(figure, path)


def overview_figure(snapshot, heading="", panels=None):
    """A figure with all fields of a snapshot. Raises VugError where it has none."""
    frame = Frame(snapshot)
    panels = panels or panels_of(snapshot)
    if not panels:
        raise VugError(f"the snapshot at t = {snapshot.time:g} s holds no field that could be drawn")
    shape = frame.shape
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
        segments = segments_on(panel, snapshot, frame)
        draw_panel(axes, panel, frame, segments)
    for axes in grid.flat[len(panels):]:
        axes.set_visible(False)
    figure.suptitle(heading + time_of(snapshot), fontsize=13)
    cracks.legend(figure, segments)
    return figure


def overview(snapshot, path, heading=""):
    """All fields of a snapshot in one picture; writes a PNG. Raises VugError where it has none."""
    return save(overview_figure(snapshot, heading), path)
