"""history.csv as columns."""
import re
from collections import Counter

import numpy as np

from .errors import FileTrouble, text_of

_ONE = "(?:s|1|m|m2|m3|kg|mol|J|K|Pa|N|W|MPa)"
# How names of columns end: "kinetic_energy_J_per_m", "left_mass_flow_kg_per_m_s", "time_s"; of probes "p_velocity_x_m/s". One
# word and no more: "p_concentration_K_mol/m3" is of a species that is called K.
_ENDING = re.compile(f"(.+?)_((?:N_s|{_ONE})_per_{_ONE}(?:_s)?|{_ONE}|[^_]*/[^_]*)")


def name_and_unit(column):
    """("kinetic_energy", "J/m") of "kinetic_energy_J_per_m"; the unit is "" where the column names none."""
    found = _ENDING.fullmatch(column)
    if not found:
        return column, ""
    above, per, below = found[2].replace("_", " ").partition(" per ")
    unit = f"{above}/({below})" if " " in below else f"{above}/{below}" if per else above
    return found[1], unit


def _names_of(header):
    """{column: (name, unit)} of all columns. Where a name without its unit could be two columns, both keep their whole names."""
    names = {column: name_and_unit(column) for column in header}
    shared = Counter(name for name, _ in names.values())
    return {column: (column if shared[name] > 1 or name in names else name, unit) for column, (name, unit) in names.items()}


def _numbers(where, line, header):
    """Of a row."""
    cells = line.split(",")
    if len(cells) != len(header):
        raise FileTrouble(f"{where}: has {len(cells)} cells, the header has {len(header)}")
    try:  # a bar of error_bars.csv may be empty: nothing is known
        return [float(cell or ("nan" if name.startswith("bar_of_") else "")) for cell, name in zip(cells, header)]
    except ValueError as error:
        raise FileTrouble(f"{where}: {error}; every cell must be a number") from None


class _Units(dict):
    """Units of names; a whole name has that of its own end."""

    def __missing__(self, column):
        name, unit = name_and_unit(column)
        if self.get(name) != unit:
            raise KeyError(column)
        return unit


class History:
    """Numbers over time: a mapping of names to arrays, all as long as the history; SI.

    `history["dissolved_volume"]` and `history["dissolved_volume_m3_per_m"]` are the same column; where two columns differ
    only in their units ("a_m", "a_N_per_m"), `history["a"]` raises KeyError and the whole names stand. `units` has the
    unit of every name, whole or not. A last line that a running simulation has not finished writing is left out; any other that is not one
    number per column raises FileTrouble, but for empty bars of error_bars.csv, which are NaN.
    """

    def __init__(self, path):
        lines = text_of(path, newline="", errors="replace").split("\n")[:-1]  # what follows the last line's end is unfinished
        if not lines:
            raise FileTrouble(f"{path}: has not even a header")
        header = lines[0].split(",")
        if twice := [column for column, count in Counter(header).items() if count > 1]:
            raise FileTrouble(f"{path}: has two columns {twice[0]}")
        data = np.array([_numbers(f"{path}:{n}", line, header) for n, line in enumerate(lines[1:], 2)], dtype=float)
        data = data.reshape(-1, len(header))
        self._column = {}
        self.units = _Units()
        for k, (column, (name, unit)) in enumerate(_names_of(header).items()):
            self._column[name] = self._column[column] = data[:, k]
            self.units[name] = unit
        self._length = len(data)

    def __getitem__(self, name):
        try:
            return self._column[name]
        except KeyError:
            meant = [column for column in self._column if name_and_unit(column)[0] == name]
            problem = f"{name!r} may be {' or '.join(meant)}" if meant else f"no column {name!r}; there are {', '.join(self)}"
            raise KeyError(problem) from None

    def __contains__(self, name):
        return name in self._column

    def __iter__(self):
        return iter(self.units)

    def __len__(self):
        """Number of rows."""
        return self._length

    def get(self, name, default=None):
        return self._column.get(name, default)

    def keys(self):
        """Names without units, in the order of the file."""
        return self.units.keys()

    def items(self):
        """Names without units, and their columns."""
        return {name: self[name] for name in self}.items()

    def values(self):
        """The columns in the order of the file."""
        return dict(self.items()).values()

    def __repr__(self):
        return f"<vug.History: {len(self.units)} columns, {self._length} rows>"
