"""What a finished run of the acid-fracturing rock left behind, as arrays."""
import csv
import json
import os
import pathlib

import h5py
import numpy as np

os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")
FAILED = (3, 4, 5)  # states of a bond (src/dem/bonds.hpp): in tension, in shear, by dissolution
DAMAGED = (1, 2)
NOTCH = 6


class Snapshot:
    """One moment: arrays over the lattice (row = y), and the bonds' ends in m with their states."""

    def __init__(self, group, bonds):
        self.time = float(group.attrs["time"])
        some = group["node_type"]
        self.dx = float(some.attrs["dx"])
        self.solid = some[:] > 0.5
        self.field = {name: group[name][:] for name in group}
        self.bond_ends = bonds["vertices"][:, :2].reshape(-1, 2, 2) if bonds is not None else np.empty((0, 2, 2))
        self.bond_state = np.rint(bonds["state"][:]).astype(int) if bonds is not None else np.empty(0, int)

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
    """A run directory."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)

    @property
    def status(self):
        """"done", "interrupted", "diverged", "running", or "" where there is no run."""
        try:
            return json.loads((self.directory / "run.json").read_text()).get("status", "")
        except (OSError, ValueError):
            return ""

    @property
    def steps(self):
        with h5py.File(self.directory / "fields.h5", "r") as fields:
            return sorted(name for name in fields if name.startswith("step_"))

    def snapshot(self, name):
        with h5py.File(self.directory / "fields.h5", "r") as fields:
            try:
                particles = h5py.File(self.directory / "particles.h5", "r")
            except OSError:
                return Snapshot(fields[name], None)
            with particles:
                bonds = particles[name]["bonds"] if name in particles else None
                if bonds is not None and "state" not in bonds:  # or every bond would count as intact
                    raise SystemExit(f"{self.directory}: its snapshots lack the state of the bonds, which output.fields left out")
                return Snapshot(fields[name], bonds)

    def snapshot_at(self, time):
        """The newest snapshot that is not later than `time` in s."""
        with h5py.File(self.directory / "fields.h5", "r") as fields:
            known = [name for name in fields if name.startswith("step_") and fields[name].attrs["time"] <= time * (1 + 1e-9)]
        return self.snapshot(max(known))

    def history(self):
        """Columns of history.csv as arrays."""
        with open(self.directory / "history.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]} if rows else {}
