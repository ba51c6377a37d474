"""What all pictures share: colours that people with any colour vision tell apart, tidy axes, one way to save."""
import pathlib

from matplotlib import pyplot as plt

ROCK = "#d9d5cc"
PORE = "#ffffff"
# Okabe & Ito (2008)
BLACK, ORANGE, SKY, GREEN, YELLOW, BLUE, VERMILION, PURPLE = (
    "#000000", "#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7")
LINES = [BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, BLACK]
DASHES = ["-", "--", "-.", ":"]


def length_unit(length):
    """(per metre, name) of the unit that a length in m is best read in."""
    return (100, "cm") if length >= 0.02 else (1e3, "mm") if length >= 2e-4 else (1e6, "µm")


def tidy(axes):
    """A light grid, and no frame where nothing is written."""
    axes.grid(alpha=0.25)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def save(figure, path):
    """Writes the figure as a PNG, closes it, and returns the path."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=150, facecolor="white")
    plt.close(figure)
    return path
