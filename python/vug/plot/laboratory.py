"""Pictures of a laboratory test: curves of all specimens, and where the bonds of the first one failed."""
import os

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import ScaledTranslation

from ..field import attribute_of, values_of
from ..history import History
from ..run_folder import group_of
from . import cracks
from .style import save, tidy

CM, MPA, PERCENT, MM = 100, 1e-6, 100, 1e3  # of m, Pa, 1, m
ROCK, OUTLINE = "#e6e2d9", "#8a8578"
# states of a bond (src/dem/bonds.hpp): label, states, colour, line width; later ones lie on top
KINDS = [
    ("damaged", (1, 2), cracks.DAMAGED, 0.6),
    ("cracked from the start", (6,), cracks.START, 1.6),
    ("failed by dissolution", (5,), cracks.DISSOLVED, 1.3),
    ("failed in tension", (3,), cracks.TENSION, 1.3),
    ("failed in shear", (4,), cracks.SHEAR, 1.3),
]


def passed_a_peak(stress, failed):
    """Whether a curve ends clearly below its largest stress, with bonds failed (None: not told), so that this is a strength."""
    return stress[-1] < 0.95 * max(stress) and failed != 0


def plot_curves(path, folder, heading):
    """Stress over strain of every seed, the peaks marked, their mean and scatter in the title. None where there is no row yet."""
    table = History(path)
    seeds = np.unique(table["seed_1"])
    if not len(seeds):
        return None
    figure, axes = plt.subplots(figsize=(6, 4.2), constrained_layout=True)
    failed = [table[name] for name in ("failed_in_tension_1", "failed_in_shear_1") if name in table]
    peaks, peaked = [], True
    for seed, colour in zip(seeds, plt.get_cmap("viridis")(np.linspace(0, 0.85, len(seeds)))):
        chosen = table["seed_1"] == seed
        strain, stress = PERCENT * table["strain_1"][chosen], MPA * table["stress_Pa"][chosen]
        top = int(np.argmax(stress))
        peaks.append(stress[top])
        peaked = peaked and passed_a_peak(stress, sum(column[chosen][-1] for column in failed) if failed else None)
        axes.plot(strain, stress, color=colour, linewidth=0.9, label=f"seed {seed:.0f}")
        axes.plot(strain[top], stress[top], "o", color=colour, markersize=4)
    mean = np.mean(peaks)
    axes.axhline(mean, color="#555555", linestyle="--", linewidth=0.8)
    spread = f" ± {np.std(peaks, ddof=1):.1f} MPa over {len(peaks)} specimens" if len(peaks) > 1 else " MPa"
    what = "strength" if peaked else "largest stress (not all passed a peak)"
    axes.set_title(f"{heading}{what} {mean:.1f}{spread}", fontsize=10)
    axes.set_xlabel("strain / %")
    axes.set_ylabel("stress / MPa")
    tidy(axes)
    if len(seeds) <= 12:
        axes.legend(fontsize=7, frameon=False)
    return save(figure, os.path.join(folder, "stress_strain.png"))


def plot_crack_count(path, folder, heading):
    """Of a quench: how many cracks reach a depth. None where there is no row yet."""
    table = History(path)
    if not len(table):
        return None
    figure, axes = plt.subplots(figsize=(6, 4.2), constrained_layout=True)
    axes.step(MM * table["depth_m"], table["cracks_1"], where="mid", color="#2166ac")
    axes.set_title(f"{heading}cracks that reach a depth", fontsize=10)
    axes.set_xlabel("depth below the cold face / mm")
    axes.set_ylabel("cracks")
    axes.set_ylim(0)
    axes.yaxis.set_major_locator(MaxNLocator(integer=True))
    tidy(axes)
    return save(figure, os.path.join(folder, "cracks_over_depth.png"))


def outline_of(numbers, places):
    """Segments of the edges that one triangle alone has; `numbers` (triangle, corner) are those of the vertices."""
    ends = [(k, (k + 1) % 3) for k in range(3)]
    edges = np.concatenate([np.sort(numbers[:, list(pair)], axis=1) for pair in ends])
    lines = np.concatenate([places[:, list(pair)] for pair in ends])
    _, first, uses = np.unique(edges, axis=0, return_index=True, return_counts=True)
    return lines[first[uses == 1]]


def plot_cracks(particles, step, folder, suffix, heading):
    """The specimen where it is now, its outline, and its bonds by what became of them."""
    group = group_of(particles, step)
    places = CM * values_of(group_of(group, "triangles/vertices"))[:, :2].reshape(-1, 3, 2)
    ends = CM * values_of(group_of(group, "bonds/vertices"))[:, :2].reshape(-1, 2, 2)
    state = np.rint(values_of(group_of(group, "bonds/state"))).astype(int)
    low, high = places.min(axis=(0, 1)), places.max(axis=(0, 1))
    width, height = high - low
    tall = 6.5 if height > width else 1.6 + 6 * height / width
    figure, axes = plt.subplots(figsize=(max(3.6, 1.2 + 5 * min(1, width / height)), tall), constrained_layout=True)
    axes.add_collection(PolyCollection(places, facecolors=ROCK, edgecolors=ROCK, linewidths=0.2))
    outline = outline_of(values_of(group_of(particles, "rock/triangle_vertex_numbers")), places)
    axes.add_collection(LineCollection(outline, colors=OUTLINE, linewidths=0.8))
    handles = []
    for label, states, colour, line_width in KINDS:
        chosen = ends[np.isin(state, states)]
        if not len(chosen):
            continue
        axes.add_collection(LineCollection(chosen, colors=colour, linewidths=line_width, capstyle="round"))
        handles.append(Line2D([], [], color=colour, linewidth=2, label=f"{label} ({len(chosen)})"))
    margin = 0.02 * max(width, height)
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.set_xlabel("x / cm")
    axes.set_ylabel("y / cm")
    axes.set_title(f"{heading}bonds at t = {1e3 * float(attribute_of(group, 'time')):.3g} ms", fontsize=10)
    if handles:
        # below the label of the axis, however flat the specimen
        below = axes.transAxes + ScaledTranslation(0, -0.5, figure.dpi_scale_trans)  # inches
        axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), bbox_transform=below, fontsize=7,
                    frameon=False, ncol=1 if height > width else len(handles))
    return save(figure, os.path.join(folder, f"crack_pattern{suffix}.png"))
