"""What `vug sweep` has left behind, opened."""
import csv
import io
import pathlib

import numpy as np

from .errors import FileTrouble, text_of
from .run_folder import Run


def _column(cells, empty=""):
    """Numbers where all of them are, else text; of an empty cell what `empty` says."""
    try:
        return np.array([float(cell or empty) for cell in cells])
    except ValueError:
        return np.array(cells)


class Study:
    """The table of a study: arrays by name, one value per run that is done, in the order of the study.

    `keys` is the list of the keys that differ, `results` that of the columns of the histories, NaN where a run has none;
    `dict(study.items())` has them all; `run(i)` opens the i-th of the table;
    `failures` has a dict for every run that is not done.
    """

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        self.name = self.directory.resolve().name
        path = self.directory / "table.csv"
        if not path.exists():
            raise FileTrouble(f"{path}: there is no such file; is {directory} the directory of a study?")
        lines = list(csv.reader(io.StringIO(text_of(path, newline=""))))
        if not lines:
            raise FileTrouble(f"{path}: has not even a header")
        header, *rows = lines
        if any(len(row) != len(header) for row in rows):
            raise FileTrouble(f"{path}: has a row that is not as long as its header")
        self._column = {name: _column([row[k] for row in rows], "" if "." in name else "nan")
                        for k, name in enumerate(header) if name != "run"}
        self.runs = [row[0] for row in rows]
        self.keys = [name for name in self._column if "." in name]
        self.results = [name for name in self._column if "." not in name]

    @property
    def failures(self):
        path = self.directory / "failures.csv"
        return list(csv.DictReader(io.StringIO(text_of(path, newline="")))) if path.exists() else []

    def run(self, index):
        """The run in that row."""
        return Run(self.directory / "runs" / self.runs[index])

    def __getitem__(self, name):
        return self._column[name]

    def items(self):
        """Names and columns, in the order of the table."""
        return self._column.items()

    def __iter__(self):
        return iter(self._column)

    def __contains__(self, name):
        return name in self._column

    def __len__(self):
        """Number of runs that are done."""
        return len(self.runs)

    def __repr__(self):
        return f"<vug.Study {str(self.directory)!r}: {len(self)} runs over {', '.join(self.keys)}>"
