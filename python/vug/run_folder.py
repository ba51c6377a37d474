"""What a run has left behind, opened."""
import functools
import json
import os
import pathlib
import tomllib

from .errors import FileTrouble, text_of
from .field import Field, attribute_of, values_of
from .history import History

os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")  # a run under way may be looked at


def open_file(path):
    """An HDF5 file, to be read. Raises FileTrouble."""
    import h5py

    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise FileTrouble(f"{path}: {error}") from None


def group_of(file, name):
    """A group or dataset of a file, or of a group, which may be a link to a file of its own: of one that is lost or damaged
    h5py says KeyError."""
    try:
        return file[name]
    except (KeyError, OSError) as error:
        raise FileTrouble(f"{file.file.filename}: {name}: {error.args[0]}") from None


class Fields:
    """Names to Field of one group of a file; follows the links of fields.h5 and particles.h5."""

    def __init__(self, group):
        self._group = group

    def __getitem__(self, name):
        if name not in self._group:
            raise KeyError(f"no field {name!r}; there are {', '.join(self._group)}")
        return Field(name, group_of(self._group, name))

    def __iter__(self):
        return iter(self._group)

    def __contains__(self, name):
        return name in self._group

    def __len__(self):
        return len(self._group)

    def keys(self):
        return list(self._group)

    def items(self):
        """Names and fields; nothing is read."""
        return {name: self[name] for name in self}.items()

    def values(self):
        return dict(self.items()).values()


class Rock:
    """Triangles and bonds of one snapshot, each a mapping of names to Field; bond_triangles (bonds, 2) are the triangles
    that each bond holds together, where the run says so."""

    def __init__(self, group, bond_triangles=None, first_bond_ends=lambda: None):
        self._bond_triangles, self._first_bond_ends = bond_triangles, first_bond_ends
        self.triangles = Fields(group_of(group, "triangles"))
        self.bonds = Fields(group_of(group, "bonds")) if "bonds" in group else {}

    @property
    def bond_triangles(self):
        return None if self._bond_triangles is None else values_of(self._bond_triangles)

    @property
    def first_bond_ends(self):
        """(2 bonds, 3) m: `bonds["vertices"]` of the run's first snapshot, where the rock of the lattice stays while the
        triangles move; None where it has none."""
        return self._first_bond_ends()


class Snapshot(Fields):
    """The fields on the lattice at one time, by name; `rock` where the run has any; `minerals`, names by the numbers of the
    field `mineral`."""

    def __init__(self, group, rock, minerals=()):
        super().__init__(group)
        self.minerals = minerals
        self.time = float(attribute_of(group, "time"))
        self.step = int(attribute_of(group, "step"))
        self.rock = rock

    def __repr__(self):
        return f"<vug.Snapshot t = {self.time:g} s: {', '.join(self)}>"


def record_of(directory):
    """run.json of a directory. Raises FileTrouble where it is lost, or is no JSON."""
    path = pathlib.Path(directory) / "run.json"
    try:
        record = json.loads(text_of(path))
    except ValueError as error:
        raise FileTrouble(f"{path}: is damaged: {error}") from None
    if not isinstance(record, dict):
        raise FileTrouble(f"{path}: is damaged: holds no table")
    return record


class Run:
    """A run directory: a sequence of snapshots, with a history and a record. Also a context, which closes its files.

    Opening reads nothing but the names; a run under way shows what it had written when it was opened.
    """

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        fields, rock = self.directory / "fields.h5", self.directory / "particles.h5"
        if not fields.exists():
            raise FileTrouble(f"{fields}: there is no such file; is {self.directory} a run directory?")
        self._fields = open_file(fields)
        self._rock = open_file(rock) if rock.exists() else None
        self._names = sorted(name for name in self._fields if name.startswith("step_"))

    def close(self):
        self._fields.close()
        if self._rock:
            self._rock.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    @property
    def record(self):
        """run.json: version, commit, compiler, how it ended, ..."""
        return record_of(self.directory)

    @property
    def status(self):
        """"done", "interrupted", "diverged", "failed" or "running"."""
        return self._recorded("status")

    def _recorded(self, name):
        """An entry of run.json. Raises FileTrouble where it has none."""
        try:
            return self.record[name]
        except KeyError:
            raise FileTrouble(f"{self.directory / 'run.json'}: is damaged: has no {name!r}") from None

    @property
    def case(self):
        """The tables of its case file, as they were read; what --set has changed is in record["overrides"]."""
        try:
            return tomllib.loads(self._recorded("case_text").removeprefix("\ufeff"))
        except (ValueError, TypeError, AttributeError) as error:
            raise FileTrouble(f"{self.directory / 'run.json'}: is damaged: case_text: {error}") from None

    @functools.cached_property
    def minerals(self):
        """Names by the numbers of the field `mineral`, of which 0 is rock of no mineral."""
        try:
            return ["rock"] + [table["name"] for table in self.case.get("mineral", [])]
        except (OSError, ValueError, KeyError, TypeError):  # no record, or one of another program
            return ["rock"]

    @property
    def history(self):
        return History(self.directory / "history.csv")

    @property
    def times(self):
        """Of the snapshots, s."""
        return [float(attribute_of(group_of(self._fields, name), "time")) for name in self._names]

    def __len__(self):
        return len(self._names)

    def __getitem__(self, index):
        """The snapshot of that number; -1 is the last. Of a slice a list of them."""
        if isinstance(index, slice):
            return [self._snapshot(name) for name in self._names[index]]
        return self._snapshot(self._names[index])

    def _snapshot(self, name):
        fields = group_of(self._fields, name)
        rock = group_of(self._rock, name) if self._rock is not None and name in self._rock else None
        if rock is None or "triangles" not in rock:
            return Snapshot(fields, None, self.minerals)
        pairs = self._rock["rock/bond_triangles"] if "rock/bond_triangles" in self._rock else None
        return Snapshot(fields, Rock(rock, pairs, lambda: self._first_bond_ends), self.minerals)

    @functools.cached_property
    def _first_bond_ends(self):
        try:
            return values_of(group_of(self._rock, f"{self._names[0]}/bonds/vertices"))
        except FileTrouble:
            return None

    def __repr__(self):
        return f"<vug.Run {str(self.directory)!r}: {len(self)} snapshots>"
