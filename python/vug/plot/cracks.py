"""Bonds that are damaged or broken, as lines."""
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from .style import BLACK, ORANGE, SKY, VERMILION

# what a state looks like in every picture; failure in tension and in shear, where they are told apart, have their own
DAMAGED, START, DISSOLVED, FAILED, TENSION, SHEAR = SKY, BLACK, ORANGE, VERMILION, "#2166ac", "#d6181f"
# states of a bond (src/dem/bonds.hpp) as they are drawn: label, states, colour, line width; later ones lie on top
KINDS = [
    ("bond damaged", (1, 2), DAMAGED, 0.7),
    ("fracture from the start", (6,), START, 1.4),
    ("bond failed by dissolution", (5,), DISSOLVED, 1.2),
    ("bond failed", (3, 4), FAILED, 1.3),
]


def segments_of(rock, scale=1, moved=False):
    """[(label, colour, width, (n, 2, 2) in m times scale)] of every kind; empty without rock. Bonds between two triangles that
    have dissolved are left out. They lie where they were at the start, as the rock of the lattice does; `moved`: where
    they are."""
    if rock is None or "vertices" not in rock.bonds or not ("state" in rock.bonds or "d_m" in rock.bonds):
        return []
    ends = None if moved else rock.first_bond_ends
    if ends is None:
        ends = rock.bonds["vertices"].values
    ends = ends[:, :2].reshape(-1, 2, 2) * scale
    if "state" in rock.bonds:
        state = np.rint(rock.bonds["state"].values).astype(int)
    else:
        damage = rock.bonds["d_m"].values
        state = np.where(damage >= 1, 3, np.where(damage > 0, 1, 0))
    there = np.ones(len(state), dtype=bool)
    if "gone" in rock.triangles and rock.bond_triangles is not None:
        there = ~(rock.triangles["gone"].values > 0.5)[rock.bond_triangles].all(axis=1)
    return [(label, colour, width, ends[there & np.isin(state, states)]) for label, states, colour, width in KINDS]


def draw(axes, segments):
    """Adds the lines, each on a thin white one that sets it off from any colour below."""
    for _, colour, width, lines in segments:
        axes.add_collection(LineCollection(lines, colors="white", linewidths=width + 0.8, alpha=0.6, capstyle="round"))
        axes.add_collection(LineCollection(lines, colors=colour, linewidths=width, capstyle="round"))


def legend(figure, segments):
    """Below the figure, of the kinds that are there."""
    handles = [Line2D([], [], color=colour, linewidth=2, label=label)
               for label, colour, _, lines in reversed(segments) if len(lines)]
    if handles:
        figure.supxlabel(" ", fontsize=14)  # the layout leaves this line free
        figure.legend(handles=handles, loc="lower center", ncol=len(handles), frameon=False, fontsize=9)
