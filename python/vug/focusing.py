"""How a flow is shared out among the pores that it passes: evenly, or nearly all of it in few."""
import numpy as np

from .errors import VugError

FLUID = 0  # of node_type


def flow_focusing(snapshot, axis="x", around=None):
    """Flow-focusing profile f = 1 - 2 n/N of a snapshot (after Szawello and others, Geophys. Res. Lett. 51, 2024): 0 where
    all pores of a cross-section carry as much, towards 1 where few of many carry the flow.

    Of each cross-section N is the number of its pores, and n how many of them carry half of its flow, the strongest first and
    the last one in part. A pore is a stretch of fluid without rock in between; its flow is what passes it on the whole.

    The cross-sections are the columns of the lattice (`axis` "x"), or its rows ("y"); with `around`, two opposite corners of
    a rectangle in m (a well, a hole), the frames of nodes around it, as far as they lie on the lattice.

    Returns the places of the sections, m (with `around` their distances from the rectangle), and f, NaN where nothing flows.
    Needs the fields velocity and node_type. Pores that a periodic side divides count as two.
    """
    for name in ("velocity", "node_type"):
        if name not in snapshot:
            raise VugError(f"flow_focusing needs the field {name}, which the run has not written (output.fields)")
    velocity, fluid = snapshot["velocity"], np.rint(snapshot["node_type"].values) == FLUID
    u = velocity[:, :, :2]
    if around is not None:
        return _around(u, fluid, np.asarray(around, float), velocity)
    if axis not in ("x", "y"):
        raise ValueError(f'axis {axis!r} must be "x" or "y"')
    places, sections = (velocity.x, zip(fluid.T, u[..., 0].T)) if axis == "x" else (velocity.y, zip(fluid, u[..., 1]))
    return places, np.array([focusing(paths(*section)) for section in sections])


def focusing(flows):
    """1 - 2 n/N of N flows, of which n, the largest first and the last one in part, are half of all; NaN where none flows."""
    total = np.sum(flows)
    if not total > 0:
        return np.nan
    carried = np.concatenate([[0], np.cumsum(np.sort(flows)[::-1])])
    return float(1 - 2 * np.interp(total / 2, carried, np.arange(len(carried))) / len(flows))


def paths(fluid, across, closed=False):
    """Flow through each stretch of fluid nodes of a cross-section, without its sign; of a `closed` one the last node lies
    beside the first."""
    begins = np.flatnonzero(np.diff(fluid.astype(int), prepend=0) == 1)
    if not len(begins):
        return np.empty(0)
    flows = np.add.reduceat(np.where(fluid, across, 0.0), begins)
    if closed and len(flows) > 1 and fluid[0] and fluid[-1]:
        flows[0] += flows[-1]
        flows = flows[:-1]
    return np.abs(flows)


def frame(low, high):
    """Nodes of the frame from node `low` to node `high` (both (column, row), both on it), once around, and the outward
    normals there, in corners the mean of their two sides' (count, 2)."""
    (left, bottom), (right, top) = low, high
    width, height = right - left, top - bottom
    sides = np.repeat(np.arange(4), [width, height, width, height])  # bottom, right, top, left
    columns = np.concatenate([np.arange(left, right), np.full(height, right), np.arange(right, left, -1), np.full(height, left)])
    rows = np.concatenate([np.full(width, bottom), np.arange(bottom, top), np.full(width, top), np.arange(top, bottom, -1)])
    normals = np.array([[0, -1], [1, 0], [0, 1], [-1, 0]])[sides].astype(float)
    corners = [0, width, width + height, 2 * width + height]
    normals[corners] = 0.5 * (normals[corners] + normals[np.subtract(corners, 1)])
    return np.stack([columns, rows], axis=1), normals


def _around(u, fluid, rectangle, velocity):
    """Distances and profile over the frames around a rectangle."""
    edge = [velocity.x[0] - velocity.spacing / 2, velocity.y[0] - velocity.spacing / 2]
    nodes = np.rint((np.sort(rectangle, axis=0) - edge) / velocity.spacing).astype(int)
    low, high = nodes[0], nodes[1] - 1  # the rectangle's own nodes
    size = np.array([fluid.shape[1], fluid.shape[0]])
    if (low > high).any() or (low < 0).any() or (high >= size).any():
        raise ValueError(f"around {rectangle.tolist()} must be two opposite corners of a rectangle inside the lattice, in m")
    reach = max(low.max(), (size - 1 - high).max())
    profile = []
    for k in range(1, reach + 1):
        places, normals = frame(low - k, high + k)
        inside = ((places >= 0) & (places < size)).all(axis=1)
        columns, rows = np.where(inside[:, None], places, 0).T
        across = (u[rows, columns] * normals).sum(axis=1)
        profile.append(focusing(paths(inside & fluid[rows, columns], across, closed=True)))
    return (np.arange(reach) + 0.5) * velocity.spacing, np.array(profile)
