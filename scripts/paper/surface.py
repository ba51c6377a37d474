"""The true area of a surface of pixels, as the solver has it (src/kernels/reaction/surface_normal.cpp, link_area.hpp).

A quadratic fitted to what is left of the rock over 5 x 5 nodes gives each solid node a normal n and a curvature; a face
between it and the fluid along the axis c counts with |n.c|, so that the faces of a staircase add up to the length of the
wall that they stand for.
"""
import numpy as np

DISTANCE = np.arange(-2, 3)
WEIGHT = np.exp(-DISTANCE**2 / 4)  # of each axis; those of the fit are a product
M0, M2, M4 = (float((WEIGHT * DISTANCE**power).sum()) for power in (0, 2, 4))
SPREAD = M2 / M0
LEAST_GRADIENT = 0.1  # below it there is no normal: a wall of a single pixel
UNDEFINED = np.pi / 4  # the mean share of a face, where there is no normal


def along(field, axis, factors):
    """Sums of five neighbours along an axis times factors; beyond the edges lies what lies at them."""
    padded = np.pad(field, [(2, 2) if a == axis else (0, 0) for a in (0, 1)], mode="edge")
    size = field.shape[axis]
    return sum(f * np.take(padded, range(k, k + size), axis) for k, f in enumerate(factors))


def normals(left):
    """(x, y) of the normals out of the rock, of the share that is `left` of each node (row = y); 0 where there is none."""
    level, slope, bend = WEIGHT, WEIGHT * DISTANCE, WEIGHT * (DISTANCE**2 - SPREAD)
    variance = M0 * (M4 - M2 * SPREAD)
    up = {name: along(left, 0, factors) for name, factors in (("level", level), ("slope", slope), ("bend", bend))}
    x, y = along(up["level"], 1, slope) / (M0 * M2), along(up["slope"], 1, level) / (M0 * M2)
    xx, yy = 2 * along(up["level"], 1, bend) / variance, 2 * along(up["bend"], 1, level) / variance
    xy = along(up["slope"], 1, slope) / M2**2
    length = np.hypot(x, y)
    defined = length > LEAST_GRADIENT
    over = 1 / np.where(defined, length, 1)
    x, y = x * over, y * over
    curvature = np.clip(-(xx * y**2 - 2 * xy * x * y + yy * x**2) * over, -0.5, 0.5)
    # the outline of the pixels lies outside the true surface by half the depth of what has gone
    share = np.where(defined, 1 - 0.4 * (1 - left) * curvature, 0)
    return -x * share, -y * share


def true_area(solid, left, wet):
    """Area of the faces between solid nodes and `wet` ones (arrays over the nodes), in node spacings per unit depth."""
    rows, columns = np.nonzero(wet)
    if not rows.size:
        return 0.0
    margin = 4  # of a fit around a neighbour, and one more
    some = (slice(max(rows.min() - margin, 0), rows.max() + margin + 1), slice(max(columns.min() - margin, 0), columns.max() + margin + 1))
    solid, left, wet = solid[some], np.where(solid, left, 0)[some], wet[some]
    nx, ny = normals(left)
    undefined = (nx == 0) & (ny == 0)
    area = 0.0
    for axis, n in ((1, nx), (0, ny)):
        share = np.where(undefined, UNDEFINED, np.abs(n))
        low, high = [slice(None)] * 2, [slice(None)] * 2
        low[axis], high[axis] = slice(None, -1), slice(1, None)
        low, high = tuple(low), tuple(high)
        area += float(share[low][solid[low] & wet[high]].sum() + share[high][wet[low] & solid[high]].sum())
    return area
