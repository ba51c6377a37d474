"""Which of the paper's three types of dissolution (Section 4.1) a run shows, from what it measured.

The paper tells the types by eye. Here they follow from two numbers:

  near share         the share of the dissolved volume that lies within 1 cm of the injection hole. A cavity is all of it;
                     acid that permeates the rock dissolves it all over.
  fractured share    the share of the dissolved volume beyond that distance which lies on failed bonds (within one
                     pathway's width): dissolution that the new fractures carry into the rock.

  permeation         near share below 1/2: most of the rock dissolves away from the hole
  permeation-cavity  near share above 1/2, but at least 1/20 of the volume dissolves beyond, most of that on fractures
  cavity             the rest
"""
import dataclasses

import numpy as np

CAVITY_REACH = 0.01  # m: from the edge of the hole; a third of the way to the nearest outlet
ACID_FRONT = 0.05  # of the inlet's concentration


@dataclasses.dataclass
class Morphology:
    """What is measured of one snapshot."""

    dissolved_volume: float  # m3 per m
    near_share: float  # of the dissolved volume, within CAVITY_REACH of the hole
    fractured_share: float  # of the dissolved volume beyond, on failed bonds
    mean_distance: float  # m, of the dissolved volume from the hole
    acid_reach: float  # m, farthest from the hole with ACID_FRONT of the inlet's concentration
    failed_bonds: int
    fracture_length: float  # m, of the failed bonds
    fracture_reach: float  # m, farthest failed bond from the hole

    @property
    def type(self):
        if not self.dissolved_volume > 0:
            return "none"
        if self.near_share < 0.5:
            return "permeation"
        if 1 - self.near_share >= 0.05 and self.fractured_share > 0.5:
            return "permeation-cavity"
        return "cavity"


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


def measure(x, y, dissolved, acid, failed, hole, dx):
    """Morphology of arrays over the nodes: dissolved (share of a pixel that was rock), acid (of the inlet's
    concentration); failed: ends of the failed bonds, (n, 2, 2) m; hole: its two corners, m; dx: spacing, m."""
    distance = distance_to_rectangle(x, y, *hole)
    total = float(dissolved.sum())
    far = distance > CAVITY_REACH
    far_total = float(dissolved[far].sum())
    on_fracture = near_segments(x, y, failed, 4 * dx) & far  # half a pathway of three nodes, and what it has dissolved
    reached = distance[acid > ACID_FRONT]
    middle = failed.mean(axis=1) if len(failed) else np.empty((0, 2))
    return Morphology(
        dissolved_volume=total * dx**2,
        near_share=1 - far_total / total if total > 0 else 0.0,
        fractured_share=float(dissolved[on_fracture].sum()) / far_total if far_total > 0 else 0.0,
        mean_distance=float((dissolved * distance).sum()) / total if total > 0 else 0.0,
        acid_reach=float(reached.max()) if reached.size else 0.0,
        failed_bonds=len(failed),
        fracture_length=float(np.linalg.norm(failed[:, 1] - failed[:, 0], axis=1).sum()) if len(failed) else 0.0,
        fracture_reach=float(distance_to_rectangle(middle[:, 0], middle[:, 1], *hole).max()) if len(failed) else 0.0,
    )


def measure_snapshot(snapshot, hole, inlet_concentration, failed_states):
    """Morphology of a snapshot of a run."""
    x, y = snapshot.nodes()
    dissolved = np.clip(np.nan_to_num(snapshot.field["dissolved_fraction"]), 0, 1)
    acid = np.where(snapshot.solid, 0, np.nan_to_num(snapshot.field["concentration_L1"])) / inlet_concentration
    return measure(x, y, dissolved, acid, snapshot.bonds(failed_states), hole, snapshot.dx)
