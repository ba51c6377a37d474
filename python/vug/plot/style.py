"""What all pictures share: colours that people with any colour vision tell apart, tidy axes, one way to save."""
import contextlib
import pathlib

from matplotlib import pyplot as plt

from ..errors import FileTrouble

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


# SI unit as files name it: units to read it in, and how large each is
READABLE = {
    "Pa": [(1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa"), (1, "Pa")],
    "m/s": [(1, "m/s"), (1e-3, "mm/s"), (1e-6, "µm/s"), (1e-9, "nm/s")],
    "m": [(1, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm")],
    "m²": [(1, "m²"), (1e-6, "mm²"), (1e-12, "µm²")],
    "J/m": [(1e6, "MJ/m"), (1e3, "kJ/m"), (1, "J/m"), (1e-3, "mJ/m")],
    "mol/m": [(1, "mol/m"), (1e-3, "mmol/m"), (1e-6, "µmol/m"), (1e-9, "nmol/m")],
    "s": [(1, "s"), (1e-3, "ms"), (1e-6, "µs")],
}


def readable(unit, largest):
    """(per SI unit, name) of the unit that numbers up to `largest` are best read in."""
    for size, name in READABLE.get(unit, ()):
        if largest >= size * (1 if size > 1 else 0.01 if unit == "m²" else 0.1):
            return 1 / size, name
    return 1, unit


class Scale:
    """How values between `low` and `high` in `unit` are written: (value - offset) * factor, with `label`. Pressures and
    temperatures that hardly differ are counted from a round number."""

    def __init__(self, unit, low, high):
        self.offset = 0
        largest = max(abs(low), abs(high))
        if unit in ("Pa", "K") and high - low < 0.01 * largest:
            self.offset = float(f"{low:.3g}")
        factor, name = readable(unit, max(abs(low - self.offset), abs(high - self.offset)))
        self.factor, self.label = factor, name.replace("m3", "m³").replace("m2", "m²") if unit != "1" else ""
        if self.offset:
            base_factor, base_name = readable(unit, abs(self.offset))
            self.label = f"{name} above {self.offset * base_factor:g} {base_name}"

    def __call__(self, values):
        return (values - self.offset) * self.factor


def tidy(axes):
    """A light grid, and no frame where nothing is written."""
    axes.grid(alpha=0.25)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


@contextlib.contextmanager
def complete(path):
    """The place at which a picture is written; it gets its own name, in the place of an older one, once it is whole."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_name("." + path.name)
    try:
        yield unfinished
        unfinished.replace(path)
    except OSError as error:
        raise FileTrouble(f"{path}: {error.strerror or error}") from None
    finally:
        unfinished.unlink(missing_ok=True)


def save(figure, path):
    """Writes the figure as a PNG, closes it, and returns the path. Raises FileTrouble where it cannot be written."""
    path = pathlib.Path(path)
    try:
        with complete(path) as place:
            figure.savefig(place, dpi=150, facecolor="white")
    finally:
        plt.close(figure)
    return path
