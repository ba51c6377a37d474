"""Which of the paper's three types of dissolution (Section 4.1) a run shows, from what it measured.

The paper tells the types by eye, "according to the dissolution morphology". Here they follow from two numbers:

  cavity share     the share of the dissolved volume that lies in cavities. A cavity is pore space in which a disc of
                   CAVITY has room (the morphological opening of the pores by that disc): rock that is gone wholesale. A
                   pathway that acid has widened a little, or rock that is eaten at everywhere and still stands, is none.
                   The disc is the same on every lattice, three pathways wide on the coarse one.
  fractured share  the share of the dissolved volume on failed bonds (within two and a half pathways' widths) and farther
                   from the hole than twice the distance to which the same volume would reach if it went evenly: what the
                   fractures carry into the rock.

  permeation         cavity share below 1/2: the rock dissolves where it still stands
  permeation-cavity  cavity share of 1/2 and more, but at least 1/20 of the volume dissolves on far fractures
  cavity             the rest
"""
import dataclasses
import math

import numpy as np

from .surface import true_area

CAVITY = 2.25e-3  # m: a pore in which a disc of this diameter has room; the hole is 4 mm wide
ACID_FRONT = 0.05  # of the inlet's concentration
TOUCHED = 1e-3  # of it: a node where acid touches the wall; where the wall is fast the acid beside it is thin
COOLED = 50  # K below the temperature at the start: a node that counts as cooled (Fig. 11)
PRESSED = 0.05  # of the injection's gauge pressure: a pore that counts as reached by it (Fig. 10)


@dataclasses.dataclass
class Morphology:
    """What is measured of one snapshot."""

    dissolved_volume: float  # m3 per m
    cavity_share: float  # of the dissolved volume, in cavities
    fractured_share: float  # of the dissolved volume, on failed bonds far from the hole
    even_distance: float  # m, to which the same volume would reach if it went evenly
    cavity_area: float  # m2, less what was wide before (the hole)
    mean_distance: float  # m, of the dissolved volume from the hole
    acid_reach: float  # m, farthest from the hole with ACID_FRONT of the inlet's concentration
    failed_bonds: int
    fracture_length: float  # m, of the failed bonds
    fracture_reach: float  # m, farthest failed bond from the hole

    @property
    def type(self):
        if not self.dissolved_volume > 0:
            return "none"
        if self.cavity_share < 0.5:
            return "permeation"
        return "permeation-cavity" if self.fractured_share >= 0.05 else "cavity"


def distance_to_rectangle(x, y, lower, upper):
    """Distance of points from an axis-parallel rectangle, 0 inside."""
    dx = np.maximum(np.maximum(lower[0] - x, x - upper[0]), 0)
    dy = np.maximum(np.maximum(lower[1] - y, y - upper[1]), 0)
    return np.hypot(dx, dy)


def near_segments(x, y, segments, reach):
    """True for the points (arrays of the same shape) within `reach` of any segment, (n, 2, 2)."""
    found = np.zeros(x.shape, bool)
    for a, b in segments:
        along = b - a
        length2 = max(float(along @ along), 1e-300)
        t = np.clip(((x - a[0]) * along[0] + (y - a[1]) * along[1]) / length2, 0, 1)
        found |= np.hypot(x - a[0] - t * along[0], y - a[1] - t * along[1]) <= reach
    return found


def dilate(mask, radius):
    """True within `radius` nodes of a True node; nothing comes from beyond the edges of the array."""
    ny, nx = mask.shape
    reach = int(radius)
    before = np.zeros((ny, nx + 2 * reach + 1), np.int32)  # how many of a row lie before a place
    np.cumsum(np.pad(mask, ((0, 0), (reach, reach))), axis=1, out=before[:, 1:])
    found = np.zeros_like(mask)
    for dy in range(-reach, reach + 1):
        half = math.isqrt(math.floor(radius * radius - dy * dy))  # of the disc's width at this height
        some = before[:, reach + half + 1:reach + half + 1 + nx] > before[:, reach - half:reach - half + nx]
        to, of = (slice(max(-dy, 0), ny + min(-dy, 0)), slice(max(dy, 0), ny + min(dy, 0)))
        found[to] |= some[of]
    return found


def cavities(solid, diameter):
    """The pores in which a disc of that many nodes has room (it may stick out of the lattice)."""
    return dilate(~dilate(solid, diameter / 2), diameter / 2) & ~solid


def share_in_pores(solid, dissolved, diameter):
    """Of what has dissolved the share that lies in cavities() of that diameter."""
    total = float(dissolved.sum())
    return float(dissolved[cavities(solid, diameter)].sum()) / total if total > 0 else 0.0


def even_reach(distances, volume):
    """Distance within which there are `volume` nodes, from the distances of all."""
    number = min(round(volume), len(distances)) - 1
    return float(np.partition(distances, number)[number]) if number >= 0 else 0.0


def reached_area(solid, dissolved, acid, dx):
    """True surface of the rock that acid has reached, m2 per m: where solid nodes have a face with a TOUCHED one."""
    return true_area(solid, 1 - dissolved, ~solid & (acid > TOUCHED)) * dx


def thirds(time, area):
    """How much of its growth a curve does in each third of its time."""
    marks = np.interp(np.linspace(time[0], time[-1], 4), time, area)
    growth = marks[3] - marks[0]
    return np.diff(marks) / growth if growth != 0 else np.zeros(3)


def measure(solid, dissolved, acid, failed, hole, dx, pathway):
    """Morphology of arrays over the nodes: solid (bool), dissolved (share of a pixel that was rock), acid (of the inlet's
    concentration); failed: ends of the failed bonds, (n, 2, 2) m; hole: its two corners, m; dx: spacing, m; pathway: its
    width in nodes."""
    ny, nx = solid.shape
    x, y = np.meshgrid((np.arange(nx) + 0.5) * dx, (np.arange(ny) + 0.5) * dx)
    distance = distance_to_rectangle(x, y, *hole)
    total = float(dissolved.sum())

    def share(where):
        return float(dissolved[where].sum()) / total if total > 0 else 0.0

    wide = cavities(solid, CAVITY / dx)
    even_distance = even_reach(distance[distance > 0], total)
    on_fracture = near_segments(x, y, failed, 2.5 * pathway * dx) & (distance > 2 * even_distance)
    reached = distance[acid > ACID_FRONT]
    middle = failed.mean(axis=1) if len(failed) else np.empty((0, 2))
    return Morphology(
        dissolved_volume=total * dx**2,
        cavity_share=share(wide),
        fractured_share=share(on_fracture),
        even_distance=even_distance,
        cavity_area=float((wide & (distance > 0)).sum()) * dx**2,
        mean_distance=float((dissolved * distance).sum()) / total if total > 0 else 0.0,
        acid_reach=float(reached.max()) if reached.size else 0.0,
        failed_bonds=len(failed),
        fracture_length=float(np.linalg.norm(failed[:, 1] - failed[:, 0], axis=1).sum()) if len(failed) else 0.0,
        fracture_reach=float(distance_to_rectangle(middle[:, 0], middle[:, 1], *hole).max()) if len(failed) else 0.0,
    )


def acid_of(snapshot, inlet_concentration):
    """Reactant of a snapshot, of the inlet's concentration."""
    return np.where(snapshot.solid, 0, np.nan_to_num(snapshot.field["concentration_L1"])) / inlet_concentration


def dissolved_of(snapshot):
    """What has dissolved of each node, 0 to 1."""
    return np.clip(np.nan_to_num(snapshot.field["dissolved_fraction"]), 0, 1)


def reached_in(snapshot, inlet_concentration):
    """reached_area() of a snapshot of a run."""
    return reached_area(snapshot.solid, dissolved_of(snapshot), acid_of(snapshot, inlet_concentration), snapshot.dx)


def measure_snapshot(snapshot, hole, inlet_concentration, failed_states, pathway):
    """Morphology of a snapshot of a run."""
    return measure(snapshot.solid, dissolved_of(snapshot), acid_of(snapshot, inlet_concentration), snapshot.bonds(failed_states), hole,
                   snapshot.dx, pathway)


def response(temperature, pressure, solid, start, initial_pressure, injected, dx):
    """Area in m2, rock and pores, that has COOLED from the temperature `start`, and the share of the pores in which the gauge
    pressure is PRESSED of that of the injection."""
    cooled = float((start - temperature >= COOLED).sum()) * dx**2
    pores = pressure[~solid]
    pressed = float((pores - initial_pressure >= PRESSED * (injected - initial_pressure)).mean()) if pores.size else 0.0
    return cooled, pressed


def response_of(snapshot, scene):
    """response() of a snapshot of a run; scene: its case."""
    flow = scene["flow"]
    return response(snapshot.field["temperature"], snapshot.field["pressure"], snapshot.solid, scene["heat"]["initial_temperature"],
                    flow["initial_pressure"], scene["boundary"]["injection"]["flow"]["pressure"], snapshot.dx)


def area_over_time(run, inlet_concentration, until=math.inf):
    """Times of a run's snapshots up to a moment (s) and the surface that acid has reached in each."""
    snapshots = [s for s in map(run.snapshot, run.steps) if s.time <= until * (1 + 1e-9)]
    return (np.array([s.time for s in snapshots]),
            np.array([reached_in(s, inlet_concentration) for s in snapshots]))
