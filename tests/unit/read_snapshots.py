"""Reads a folder of snapshots as a user would and checks every number and every reference.

Usage: read_snapshots.py [--uncompressed] FOLDER STEP...   (fails with an assertion)
"""
import os
import sys
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np

NX, NY, SPACING = 7, 5, 1e-3


def check_lattice(folder, steps, compressed):
    with h5py.File(os.path.join(folder, "fields.h5"), "r") as file:
        assert sorted(file) == [f"step_{s:012d}" for s in steps], list(file)
        for step in steps:
            group = file[f"step_{step:012d}"]
            pressure = group["pressure"]
            assert pressure.shape == (NY, NX) and pressure.dtype == np.float32
            assert (pressure.compression is not None) == compressed
            assert np.array_equal(pressure[:], 1e5 + np.arange(NX * NY).reshape(NY, NX))
            velocity = group["velocity"][:]
            assert velocity.shape == (NY, NX, 3)
            assert np.array_equal(velocity[..., :2], 0.5 * np.arange(2 * NX * NY).reshape(NY, NX, 2))
            assert not velocity[..., 2].any()
            attributes = pressure.attrs
            assert attributes["units"] in ("Pa", b"Pa")
            assert attributes["step"] == step and attributes["time"] == 1e-7 * step
            assert attributes["dx"] == SPACING and list(attributes["origin"]) == [0, 0]


def check_particles(folder, steps):
    with h5py.File(os.path.join(folder, "particles.h5"), "r") as file:
        assert np.array_equal(file["rock/triangles"], [[0, 1, 2], [3, 4, 5]])
        assert np.array_equal(file["rock/triangle_vertex_numbers"], [[0, 1, 2], [0, 2, 3]])
        assert np.array_equal(file["rock/bond_triangles"], [[0, 1]])
        assert file["rock/triangles"].dtype == np.int32
        for step in steps:
            group = file[f"step_{step:012d}"]
            # a quarter turn about the centroids (2, 1) and (1, 2), then 0.25 to the right
            expected = [[3.25, -1], [3.25, 2], [0.25, 2], [3.25, 1], [0.25, 4], [0.25, 1]]
            vertices = group["triangles/vertices"]
            assert vertices.dtype == np.float32
            assert np.allclose(vertices[:, :2], expected, atol=1e-6)
            # the bond joins vertices 0 and 2: midway between where the two triangles took them
            assert np.allclose(group["bonds/vertices"][:, :2], [[3.25, 0], [0.25, 3]], atol=1e-6)
            assert np.array_equal(group["triangles/temperature"], [300, 301])
            assert np.array_equal(group["bonds/stress"], [[0, 1, 0]])


def check_xdmf(folder, stem, steps):
    tree = ElementTree.parse(os.path.join(folder, stem + ".xdmf"))
    times = [float(t.get("Value")) for t in tree.iter("Time")]
    assert np.allclose(times, [1e-7 * s for s in steps], rtol=1e-12), times
    items = [i for i in tree.iter("DataItem") if i.get("Format") == "HDF"]
    assert items
    for item in items:
        path, name = item.text.strip().split(":")
        assert not os.path.isabs(path)
        with h5py.File(os.path.join(folder, path), "r") as file:
            data = file[name]
            shape = [int(n) for n in item.get("Dimensions").split()]
            if stem == "fields":  # one plane of a three-dimensional image
                assert shape.pop(0) == 1
            assert list(data.shape) == shape, (name, data.shape)
            assert data.dtype.itemsize == int(item.get("Precision"))
            assert (data.dtype.kind == "i") == (item.get("NumberType") == "Int")
    for topology in tree.iter("Topology"):
        if topology.get("TopologyType") == "3DCoRectMesh":
            assert topology.get("Dimensions") == f"1 {NY} {NX}"
        else:
            item = topology.find("DataItem")
            assert int(item.get("Dimensions").split()[0]) == int(topology.get("NumberOfElements"))


def main():
    arguments = [a for a in sys.argv[1:] if a != "--uncompressed"]
    folder, steps = arguments[0], [int(s) for s in arguments[1:]]
    check_lattice(folder, steps, compressed="--uncompressed" not in sys.argv)
    check_particles(folder, steps)
    for stem in ("fields", "particles"):
        check_xdmf(folder, stem, steps)


main()
