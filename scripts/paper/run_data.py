"""What a run of the acid-fracturing rock left behind, as arrays."""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
import vug

FAILED = (3, 4, 5)  # states of a bond (src/dem/bonds.hpp): in tension, in shear, by dissolution
DAMAGED = (1, 2)
NOTCH = 6


class Snapshot:
    """One moment: arrays over the lattice (row = y), and the bonds' ends in m with their states. The ends are those at the
    start, since the rock of the lattice does not move with fragments."""

    def __init__(self, snapshot):
        self.time = snapshot.time
        self.dx = snapshot["node_type"].spacing
        self.solid = np.rint(snapshot["node_type"].values) == 1
        self.field = {name: field.values for name, field in snapshot.items()}
        bonds = snapshot.rock.bonds if snapshot.rock else {}
        ends = snapshot.rock.first_bond_ends if bonds else np.empty((0, 3))
        self.bond_ends = (bonds["vertices"].values if ends is None else ends)[:, :2].reshape(-1, 2, 2)
        self.bond_state = np.rint(bonds["state"].values).astype(int) if bonds else np.empty(0, int)

    def bonds(self, states):
        """Ends of the bonds in any of the states, (n, 2, 2) m."""
        return self.bond_ends[np.isin(self.bond_state, states)]

    @property
    def extent(self):
        ny, nx = self.solid.shape
        return (0, nx * self.dx, 0, ny * self.dx)

    def nodes(self):
        """x and y of every node, m."""
        ny, nx = self.solid.shape
        return np.meshgrid((np.arange(nx) + 0.5) * self.dx, (np.arange(ny) + 0.5) * self.dx)


class Run:
    """A run directory, which may not be there yet; its files are open only while a snapshot is read."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)

    @property
    def record(self):
        """run.json, or {} where there is no run."""
        try:
            return vug.run_folder.record_of(self.directory)
        except vug.FileTrouble:
            return {}

    @property
    def status(self):
        """"done", "interrupted", "diverged", "running", or "" where there is no run."""
        return self.record.get("status", "")

    @property
    def steps(self):
        """Numbers of the snapshots; none where the run has ended before it wrote one."""
        if not (self.directory / "fields.h5").exists():
            return range(0)
        with vug.open(self.directory) as run:
            return range(len(run))

    def snapshot(self, number):
        with vug.open(self.directory) as run:
            snapshot = run[number]
            bonds = snapshot.rock.bonds if snapshot.rock else {}
            if bonds and "state" not in bonds:  # or every bond would count as intact
                raise SystemExit(f"{self.directory}: its snapshots lack the state of the bonds, which output.fields left "
                                 "out")
            return Snapshot(snapshot)

    def snapshot_at(self, time):
        """The newest snapshot that is not later than `time` in s."""
        with vug.open(self.directory) as run:
            return self.snapshot(max(k for k, of_snapshot in enumerate(run.times) if of_snapshot <= time * (1 + 1e-9)))

    def history(self):
        """Columns of history.csv as arrays."""
        return vug.History(self.directory / "history.csv")
