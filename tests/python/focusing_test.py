"""The flow-focusing profile: of flows whose shares are known, and of a run against the cubic law."""
import os
import pathlib
import sys
import tempfile
import types
import unittest

root = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "python"))
os.chdir(root)

import numpy as np
import vug
from vug.focusing import focusing, frame, paths


class Field:
    """As of a snapshot, with nodes of 0.1 m and a lattice that begins at (1, 2) m."""

    spacing = 0.1

    def __init__(self, values):
        self.values = values
        self.x = 1 + (np.arange(values.shape[1]) + 0.5) * self.spacing
        self.y = 2 + (np.arange(values.shape[0]) + 0.5) * self.spacing

    def __getitem__(self, key):
        return self.values[key]


def snapshot_of(node_type, u, v):
    return {"node_type": Field(node_type), "velocity": Field(np.stack([u, v, np.zeros_like(u)], axis=-1))}


class Shares(unittest.TestCase):
    def test_even_flows_are_not_focused(self):
        for count in (1, 2, 7):
            self.assertAlmostEqual(focusing(np.full(count, 3.0)), 0, places=14)

    def test_one_of_many_is_focused(self):
        self.assertAlmostEqual(focusing(np.array([1.0] + [0.0] * 9)), 1 - 2 * 0.5 / 10, places=14)

    def test_flows_that_grow_evenly(self):  # 1, 2, 3, 4: 4 and a third of 3 are half of 10
        self.assertAlmostEqual(focusing(np.array([3.0, 1.0, 4.0, 2.0])), 1 - 2 * (4 / 3) / 4, places=14)

    def test_nothing_that_flows_has_no_profile(self):
        self.assertTrue(np.isnan(focusing(np.zeros(3))) and np.isnan(focusing(np.empty(0))))

    def test_a_pore_has_what_passes_it_on_the_whole(self):
        fluid = np.array([1, 1, 0, 1, 0, 0, 1, 1], bool)
        across = np.array([3.0, -1.0, 9.0, -5.0, 9.0, 9.0, 2.0, 2.0])
        np.testing.assert_array_equal(paths(fluid, across), [2, 5, 4])
        np.testing.assert_array_equal(paths(fluid, across, closed=True), [6, 5])


class Sections(unittest.TestCase):
    def test_rows_and_columns(self):
        rock = np.zeros((4, 5))
        rock[1, :] = 1  # two pores of 1 and 2 nodes in every column, one in every row but the second
        u = np.full((4, 5), 6.0)
        x, along = vug.flow_focusing(snapshot_of(rock, u, 0 * u))
        np.testing.assert_allclose(x, [1.05, 1.15, 1.25, 1.35, 1.45])
        np.testing.assert_allclose(along, 1 - 2 * 0.75 / 2)  # 3/4 of the larger of 6 and 12
        y, across = vug.flow_focusing(snapshot_of(rock, 0 * u, u), "y")
        np.testing.assert_allclose(y, [2.05, 2.15, 2.25, 2.35])
        np.testing.assert_array_equal(np.isnan(across), [False, True, False, False])

    def test_frames_around_a_hole(self):
        """A source: what leaves by the four pathways along the axes, two of them twice as fast, in every frame."""
        rock, u, v = np.ones((11, 13)), np.zeros((11, 13)), np.zeros((11, 13))
        rock[4:7, 4:7] = 0  # the hole, 3 nodes from the left, 4 from the bottom
        rock[5, :], rock[:, 5] = 0, 0
        u[5, :5], u[5, 6:], v[:5, 5], v[6:, 5] = -2, 2, -1, 1
        distance, profile = vug.flow_focusing(snapshot_of(rock, u, v), around=((1.7, 2.7), (1.4, 2.4)))
        np.testing.assert_allclose(distance, 0.05 + 0.1 * np.arange(6))
        np.testing.assert_allclose(profile[:4], 1 - 2 * 1.5 / 4)
        np.testing.assert_allclose(profile[4:], 0)  # beyond the left, the bottom and the top side: one pathway is left
        v[6:, 5] = -1  # and a sink above: flows count without their signs
        np.testing.assert_allclose(vug.flow_focusing(snapshot_of(rock, u, v), around=((1.4, 2.4), (1.7, 2.7)))[1], profile)

    def test_what_passes_a_frame_is_its_divergence(self):
        """The flow (x, y) makes 2 per area: corners count half for each of their sides."""
        nodes, normals = frame((3, 5), (7, 11))
        self.assertEqual(len(np.unique(nodes, axis=0)), 2 * (4 + 6))
        self.assertAlmostEqual((nodes * normals).sum(), 2 * 4 * 6, places=12)

    def test_what_is_missing_is_told(self):
        u = np.ones((3, 3))
        with self.assertRaisesRegex(vug.VugError, "node_type"):
            vug.flow_focusing({"velocity": Field(np.ones((3, 3, 3)))})
        with self.assertRaisesRegex(ValueError, "inside the lattice"):
            vug.flow_focusing(snapshot_of(0 * u, u, u), around=((0.0, 0.0), (9.0, 9.0)))
        with self.assertRaisesRegex(ValueError, '"x" or "y"'):
            vug.flow_focusing(snapshot_of(0 * u, u, u), "z")


class CubicLaw(unittest.TestCase):
    def test_slits_side_by_side_carry_the_cubes_of_their_widths(self):
        """Slits of 10 and 20 nodes between plates: 1 to 8, of which the wider one carries half with 9/16 of itself."""
        with tempfile.TemporaryDirectory() as folder:
            run = vug.run("cases/poiseuille.toml", pathlib.Path(folder) / "run", {
                "lattice.size": [1e-3, 3.4e-3], "time.steps": 6000, "geometry.type": "shapes",
                "geometry.shapes": [{"type": "rectangle", "from": [0.0, 1e-3], "to": [1e-3, 1.4e-3]}]})
            places, profile = vug.flow_focusing(run[-1])
            run.close()
        self.assertEqual(len(places), 10)
        np.testing.assert_allclose(profile, 1 - 2 * (9 / 16) / 2, atol=5e-3)


if __name__ == "__main__":
    unittest.main()
