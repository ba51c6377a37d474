"""One quantity of one snapshot."""
import numpy as np

from .errors import FileTrouble


def values_of(dataset, key=...):
    """Of a dataset, or of a part of it. Raises FileTrouble where a block of it is lost or damaged."""
    try:
        return dataset[key]
    except OSError as error:
        raise FileTrouble(f"{dataset.file.filename}: {dataset.name}: {error}") from None


def attribute_of(place, name):
    """Of a group or a dataset. Raises FileTrouble where it is not there."""
    try:
        return place.attrs[name]
    except (KeyError, OSError) as error:
        raise FileTrouble(f"{place.file.filename}: {place.name}: {error.args[0]}") from None


class Field:
    """An array on disk with its unit and its place; read when it is used, `field[rows, columns]` in parts.

    On the lattice: `values` (ny, nx), row 0 at the bottom, or (ny, nx, 3) of a vector, and `x`, `y` of the nodes'
    centres in m. Of triangles and bonds: (count,) or (count, 3), and no `x`, `y`.
    """

    def __init__(self, name, dataset):
        self.name = name
        self._dataset = dataset
        unit = dataset.attrs.get("units", b"")
        self.units = unit.decode() if isinstance(unit, bytes) else str(unit)
        self.time = float(attribute_of(dataset, "time"))
        self.spacing = float(dataset.attrs["dx"]) if "dx" in dataset.attrs else None

    @property
    def shape(self):
        return self._dataset.shape

    @property
    def values(self):
        return self[...]

    def _centres(self, axis):
        if self.spacing is None:
            raise AttributeError(f"{self.name} does not lie on the lattice")
        count = self.shape[1 - axis]
        return float(attribute_of(self._dataset, "origin")[axis]) + (np.arange(count) + 0.5) * self.spacing

    @property
    def x(self):
        """(nx) m."""
        return self._centres(0)

    @property
    def y(self):
        """(ny) m."""
        return self._centres(1)

    def __getitem__(self, key):
        return values_of(self._dataset, key)

    def __array__(self, dtype=None, copy=None):
        if copy is False:
            raise ValueError(f"{self.name} lies on disk: there are no values of it without a copy")
        values = self.values
        return values if dtype is None else values.astype(dtype, copy=False)

    def to_xarray(self):
        """A DataArray with coordinates and units, where xarray is installed."""
        import xarray

        if self.spacing is None:
            dims, coords = (self.name + "_index", "axis")[:len(self.shape)], {}
        else:
            dims, coords = ("y", "x", "axis")[:len(self.shape)], {"y": self.y, "x": self.x}
        return xarray.DataArray(self.values, dims=dims, coords={**coords, "time": self.time}, name=self.name,
                                attrs={"units": self.units})

    def __repr__(self):
        return f"<vug.Field {self.name} {self.shape} {self.units}, t = {self.time:g} s>"
