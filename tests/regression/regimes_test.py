"""The regime classifier on rock drawn by hand: each type is told, wherever the noise falls."""
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
sys.dont_write_bytecode = True
from paper.regimes import measure  # noqa: E402

DX = 2.5e-4
HOLE = ((0.0, 0.033), (0.004, 0.037))
X, Y = np.meshgrid((np.arange(400) + 0.5) * DX, (np.arange(280) + 0.5) * DX)
NOTHING = np.empty((0, 2, 2))


def half_disc(radius):
    return (np.hypot(X - 0.004, Y - 0.035) < radius).astype(float)


def branches(seed, count=6):
    """Cracks from the hole into the rock: their segments, and the dissolved nodes along them."""
    random = np.random.default_rng(seed)
    ends = np.array([0.02, 0.035]) + random.uniform([0.01, -0.02], [0.06, 0.02], (count, 2))
    segments = np.array([[[0.012, 0.035], end] for end in ends])
    dissolved = np.zeros_like(X)
    for a, b in segments:
        for t in np.linspace(0, 1, 400):
            p = a + t * (b - a)
            dissolved[int(p[1] / DX), int(p[0] / DX)] = 0.5
    return segments, dissolved


class Regimes(unittest.TestCase):
    def test_a_cavity_round_the_hole(self):
        for radius in (0.002, 0.004, 0.008):
            for seed in range(5):
                specks = (np.random.default_rng(seed).random(X.shape) < 1e-4) * 0.1
                found = measure(X, Y, np.maximum(half_disc(radius), specks), half_disc(radius), NOTHING, HOLE, DX)
                self.assertEqual(found.type, "cavity")

    def test_dissolution_all_over(self):
        for seed in range(5):
            everywhere = np.random.default_rng(seed).random(X.shape) < 0.05
            self.assertEqual(measure(X, Y, everywhere * 0.02, everywhere * 0.5, NOTHING, HOLE, DX).type, "permeation")

    def test_a_cavity_with_dissolving_fractures(self):
        for seed in range(5):
            segments, along = branches(seed)
            found = measure(X, Y, np.maximum(half_disc(0.006), along), half_disc(0.006), segments, HOLE, DX)
            self.assertEqual(found.type, "permeation-cavity")
            self.assertEqual(found.failed_bonds, len(segments))

    def test_fractures_that_carry_nothing_leave_a_cavity(self):
        segments, _ = branches(1)
        self.assertEqual(measure(X, Y, half_disc(0.006), half_disc(0.006), segments, HOLE, DX).type, "cavity")

    def test_rock_that_does_not_dissolve_has_no_type(self):
        self.assertEqual(measure(X, Y, 0 * X, 0 * X, NOTHING, HOLE, DX).type, "none")

    def test_numbers_of_a_disc(self):
        found = measure(X, Y, half_disc(0.003), half_disc(0.003), NOTHING, HOLE, DX)
        # the disc of radius 3 mm round the middle of the hole's end, its part within the domain
        self.assertAlmostEqual(found.dissolved_volume, np.pi * 0.003**2, delta=0.02 * np.pi * 0.003**2)
        self.assertAlmostEqual(found.acid_reach, 0.003, delta=2 * DX)
        self.assertEqual(found.near_share, 1)


if __name__ == "__main__":
    unittest.main()
