"""The snapshots of a run one after another."""
from matplotlib import animation
from matplotlib import pyplot as plt

from ..errors import FileTrouble, VugError
from . import fields
from .style import complete, readable


def scales_of(run, names, creeping=None):
    """{name: (low, high)} over all snapshots in which it is not uniform, so that colours mean the same in every frame."""
    scales = {}
    for snapshot in run:
        for panel in fields.panels_of(snapshot, creeping):
            if panel.name in names and not panel.uniform:
                low, high = scales.get(panel.name, (panel.low, panel.high))
                scales[panel.name] = min(low, panel.low), max(high, panel.high)
    return scales


def _differ(first, last):
    """Of values of two snapshots; triangles may have dissolved in between."""
    return first.shape != last.shape or (first != last).any()


def movie(run, path, heading="", names=None, frames_per_second=8):
    """Writes an animation of the fields `names`, by default the last of the overview's first four that change: a GIF, or
    what ffmpeg makes of another ending where it is installed. Raises VugError where the snapshots hold no such field."""
    last = {panel.name: panel for panel in fields.panels_of(run[-1])}
    creeping = "pressure" in last and last["pressure"].title != "pressure"
    first = {panel.name: panel for panel in fields.panels_of(run[0], creeping)}
    if missing := [name for name in names or () if name not in last]:
        raise VugError(f"no field {missing[0]!r} in {run.directory}; there are {', '.join(last) or 'none'}")
    changing = [name for name in last if name not in first or _differ(first[name].values, last[name].values)] or list(last)
    names = names or changing[:4]
    if not names:
        raise VugError(f"{run.directory}: its snapshots hold no field that could be drawn")
    scales = scales_of(run, names, creeping)
    frame = fields.Frame(run[0])

    def draw(figure, snapshot):
        figure.clear()
        chosen = [panel for panel in fields.panels_of(snapshot, creeping) if panel.name in names]
        columns = min(2, len(names))
        grid = figure.subplots(-(-len(names) // columns), columns, squeeze=False)
        for axes in grid.flat[len(chosen):]:
            axes.set_visible(False)
        for axes, panel in zip(grid.flat, chosen):
            panel.low, panel.high = scales.get(panel.name, (panel.low, panel.high))
            fields.draw_panel(axes, panel, frame, fields.segments_on(panel, snapshot, frame))
        factor, unit = readable("s", run.times[-1])  # one unit for all frames
        figure.suptitle(f"{heading}t = {factor * snapshot.time:.4g} {unit}", fontsize=12)

    if not str(path).endswith(".gif") and not animation.FFMpegWriter.isAvailable():
        raise FileTrouble(f"{path}: needs the program ffmpeg; end the name in .gif to do without")
    columns = min(2, len(names))
    width, height = fields.panel_size(frame.shape, 4.8)
    figure = plt.figure(figsize=(width * columns, height * -(-len(names) // columns) + 0.6), layout="constrained")
    writer = animation.PillowWriter(fps=frames_per_second) if str(path).endswith(".gif") else \
        animation.FFMpegWriter(fps=frames_per_second)
    try:
        with complete(path) as place, writer.saving(figure, str(place), dpi=90):
            for snapshot in run:
                draw(figure, snapshot)
                writer.grab_frame(facecolor="white")
    finally:
        plt.close(figure)
    return path
