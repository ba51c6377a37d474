"""history.csv as columns."""
import numpy as np

from .errors import FileTrouble

# the words that units in the names of columns are made of: "kinetic_energy_J_per_m", "time_s"
UNITS = {"s", "1", "m", "m2", "m3", "kg", "mol", "J", "K", "Pa", "N", "W", "MPa"}


def name_and_unit(column):
    """("kinetic_energy", "J/m") of "kinetic_energy_J_per_m"; the unit is "" where the column names none."""
    words = column.split("_")
    for i in range(1, len(words)):
        if all(word == "per" or set(word.split("/")) <= UNITS for word in words[i:]):
            return "_".join(words[:i]), "_".join(words[i:]).replace("_per_", "/").replace("_", " ")
    return column, ""


def _numbers(where, line, header):
    """Of a row."""
    cells = line.split(",")
    if len(cells) != len(header):
        raise FileTrouble(f"{where}: has {len(cells)} cells, the header has {len(header)}")
    try:
        return [float(cell) for cell in cells]
    except ValueError as error:
        raise FileTrouble(f"{where}: {error}; every cell must be a number") from None


class History:
    """Numbers over time: a mapping of names to arrays, all as long as the history; SI.

    `history["dissolved_volume"]` and `history["dissolved_volume_m3_per_m"]` are the same column. `units` has the unit
    of every name. A last line that a running simulation has not finished writing is left out; any other that is not one
    number per column raises FileTrouble.
    """

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8", errors="replace") as file:
            lines = file.read().split("\n")[:-1]  # what follows the last end of a line is unfinished
        if not lines:
            raise FileTrouble(f"{path}: has not even a header")
        header = lines[0].split(",")
        data = np.array([_numbers(f"{path}:{n}", line, header) for n, line in enumerate(lines[1:], 2)], dtype=float)
        data = data.reshape(-1, len(header))
        self._column = {}
        self.units = {}
        for k, column in enumerate(header):
            name, unit = name_and_unit(column)
            self._column[name] = self._column[column] = data[:, k]
            self.units[name] = unit
        self._length = len(data)

    def __getitem__(self, name):
        try:
            return self._column[name]
        except KeyError:
            raise KeyError(f"no column {name!r}; there are {', '.join(self)}") from None

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

    def __repr__(self):
        return f"<vug.History: {len(self.units)} columns, {self._length} rows>"
