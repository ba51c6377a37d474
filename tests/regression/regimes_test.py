"""What is read from runs of the acid-fracturing rock: the classifier of regimes on rock drawn by hand, the true surface.

  regimes_test.py EXECUTABLE
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
from paper.members import PARTS  # noqa: E402
from paper.regimes import dissolved_of, measure, reached_area, response, thirds  # noqa: E402
from paper.run_data import FAILED, Run  # noqa: E402
from paper.surface import true_area  # noqa: E402

DX = 2.5e-4
HOLE = ((0.0, 0.033), (0.004, 0.037))
X, Y = np.meshgrid((np.arange(400) + 0.5) * DX, (np.arange(280) + 0.5) * DX)
NOTHING = np.empty((0, 2, 2))


def half_disc(radius):
    return (np.hypot(X - 0.004, Y - 0.035) < radius).astype(float)


def rock(dissolved):
    """What is solid: all but the hole and the nodes that are gone."""
    in_hole = (X < HOLE[1][0]) & (Y > HOLE[0][1]) & (Y < HOLE[1][1])
    return ~in_hole & (dissolved < 1)


def strip(a, b, half_width):
    """Nodes beside the segment from a to b."""
    along = np.subtract(b, a)
    t = np.clip(((X - a[0]) * along[0] + (Y - a[1]) * along[1]) / (along @ along), 0, 1)
    return np.hypot(X - a[0] - t * along[0], Y - a[1] - t * along[1]) < half_width * DX


def branches(seed, count=6):
    """Cracks from the hole into the rock: their segments, and the nodes along them."""
    random = np.random.default_rng(seed)
    ends = np.array([0.02, 0.035]) + random.uniform([0.01, -0.02], [0.06, 0.02], (count, 2))
    segments = np.array([[[0.012, 0.035], end] for end in ends])
    return segments, np.any([strip(a, b, 1.5) for a, b in segments], axis=0)


def type_of(dissolved, failed=NOTHING, solid=None):
    return measure(rock(dissolved) if solid is None else solid, dissolved, 0 * X, failed, HOLE, DX, 3).type


class Regimes(unittest.TestCase):
    def test_a_cavity_round_the_hole(self):
        for radius in (0.003, 0.004, 0.008):
            for seed in range(5):
                specks = (np.random.default_rng(seed).random(X.shape) < 1e-4) * 0.1
                self.assertEqual(type_of(np.maximum(half_disc(radius), specks)), "cavity")

    def test_rock_that_is_eaten_at_and_stands(self):
        for seed in range(5):
            everywhere = np.random.default_rng(seed).random(X.shape) < 0.05
            self.assertEqual(type_of(everywhere * 0.02), "permeation")
        self.assertEqual(type_of(half_disc(0.008) * 0.9), "permeation")

    def test_widened_pathways_are_no_cavity(self):
        for spacing in (20, 30, 50):
            def near(half_width):  # a network of crossing pathways
                return np.minimum((X / DX) % spacing, (Y / DX) % spacing) < 2 * half_width
            dissolved = (near(3) & ~near(1.5)).astype(float)
            self.assertEqual(type_of(dissolved, solid=rock(dissolved) & ~near(1.5)), "permeation")

    def test_a_cavity_with_dissolving_fractures(self):
        for seed in range(5):
            segments, along = branches(seed)
            self.assertEqual(type_of(np.maximum(half_disc(0.006), along * 0.2), segments), "permeation-cavity")

    def test_a_cavity_is_as_wide_on_any_lattice(self):
        """Pores of 1.2 and 6 mm in the middle of rock, with pathways of three nodes whatever their spacing."""
        for refined in (1, 3):
            dx = DX / refined
            x, y = np.meshgrid((np.arange(160 * refined) + 0.5) * dx, (np.arange(160 * refined) + 0.5) * dx)
            for radius, share in ((6e-4, 0), (3e-3, 1)):
                pore = np.hypot(x - 0.02, y - 0.02) < radius
                found = measure(~pore, 1.0 * pore, 0 * x, NOTHING, ((0, 0.018), (0.004, 0.022)), dx, 3)
                self.assertAlmostEqual(found.cavity_share, share, delta=0.1)

    def test_fractures_that_carry_nothing_leave_a_cavity(self):
        segments, _ = branches(1)
        self.assertEqual(type_of(half_disc(0.006), segments), "cavity")

    def test_rock_that_does_not_dissolve_has_no_type(self):
        self.assertEqual(type_of(0 * X), "none")

    def test_area_that_acid_has_reached(self):
        pore = np.hypot(X - 0.05, Y - 0.035) < 40.3 * DX
        for below, share in ((1, 1), (0.035, 0.5), (0, 0)):  # m: acid in all of it, in its lower half, nowhere
            acid = np.where(pore & (Y < below), 1.0, 0.0)
            area = reached_area(~pore, 0 * X, acid, DX)
            self.assertAlmostEqual(area, share * 2 * np.pi * 40.3 * DX, delta=0.015 * share * 2 * np.pi * 40.3 * DX)

    def test_thirds_of_a_growth(self):
        time = np.linspace(0, 9, 10)
        np.testing.assert_allclose(thirds(time, 2 + time), [1 / 3, 1 / 3, 1 / 3])
        np.testing.assert_allclose(thirds(time, time**2), [1 / 9, 3 / 9, 5 / 9])

    def test_what_has_cooled_and_what_is_pressed(self):
        pore = (X > 0.01) & (X < 0.05) & (Y > 0.03) & (Y < 0.04)
        temperature = np.where(Y < 0.035, 438.0, 438.3)  # the lower half has cooled by just over 50 K
        pressure = np.where(X < 0.02, 2e6, 1.09e6)  # of 20 MPa over 0.1 MPa 5 % are 0.995 MPa
        cooled, pressed = response(temperature, pressure, ~pore, 488.15, 1e5, 20e6, DX)
        self.assertAlmostEqual(cooled, 0.1 * 0.035)
        self.assertAlmostEqual(pressed, 0.25)

    def test_numbers_of_a_disc(self):
        disc = half_disc(0.003)
        segments, _ = branches(2)
        found = measure(rock(disc), disc, disc, segments, HOLE, DX, 3)
        # the disc of radius 3 mm round the middle of the hole's end, its part within the domain
        self.assertAlmostEqual(found.dissolved_volume, np.pi * 0.003**2, delta=0.02 * np.pi * 0.003**2)
        self.assertAlmostEqual(found.acid_reach, 0.003, delta=2 * DX)
        self.assertGreater(found.cavity_share, 0.95)
        # 12 mm of outline and two quarters of a disc: 12 mm d + pi d^2 / 2
        self.assertAlmostEqual(found.even_distance, 1.88e-3, delta=DX)
        beyond_the_hole = np.pi * 0.003**2 / 2 + 2 * (np.pi * 0.003**2 / 4 - 0.002 * 0.003 * 0.75)
        self.assertLess(found.cavity_area, np.pi * 0.003**2)
        self.assertGreater(found.cavity_area, 0.5 * beyond_the_hole)
        self.assertEqual(found.failed_bonds, len(segments))
        self.assertAlmostEqual(found.fracture_length, np.hypot(*(segments[:, 1] - segments[:, 0]).T).sum())


class TrueArea(unittest.TestCase):
    def test_walls_of_any_slope(self):
        for angle in np.linspace(0, np.pi / 2, 13):
            c, s = np.cos(angle), np.sin(angle)
            across, along = (X - 0.05) * c + (Y - 0.035) * s, (Y - 0.035) * c - (X - 0.05) * s
            wet = (across > 0) & (abs(along) < 100.2 * DX)
            area = true_area(across <= 0, np.where(across <= 0, 1.0, 0.0), wet)
            self.assertAlmostEqual(area / 200.4, 1, delta=0.02)  # of the staircase up to 1.41

    def test_discs_and_what_has_no_normal(self):
        for radius in (20, 40, 80):
            disc = np.hypot(X - 0.05, Y - 0.035) < radius * DX
            self.assertAlmostEqual(true_area(disc, 1.0 * disc, ~disc) / (2 * np.pi * radius), 1, delta=0.01)
        lone = (X == X[140, 200]) & (Y == Y[140, 200])
        self.assertAlmostEqual(true_area(lone, 1.0 * lone, ~lone), np.pi)

    def test_is_that_of_the_solver(self):
        """A rock that dissolves: pixels of all shares left."""
        with tempfile.TemporaryDirectory() as folder:
            settings = ["lattice.spacing=1e-3", "lattice.time_step=4e-5", "flow.pressure_scale=400", "rock.element_size=6e-3",
                        "boundary.injection.flow.ramp_time=4e-4", "mechanics.preload_time=2e-5", "accuracy.update_interval=1",
                        "reaction.molar_volume=1e-2", "reaction.damkohler=1.5", "time.end=0.024", "output.interval=8e-3",
                        "output.checkpoint_interval=8e-3"]
            subprocess.run([sys.argv[1], "run", ROOT / "cases/acid_fracturing/coarse/p20_da1.5e-3.toml", "-o", folder, "--quiet",
                            "--threads", "1", *(word for setting in settings for word in ("--set", setting))], check=True)
            run = Run(folder)
            history = run.history()
            for name in run.steps:
                snapshot = run.snapshot(name)
                row = np.argmin(np.abs(history["time_s"] - snapshot.time))
                area = true_area(snapshot.solid, 1 - dissolved_of(snapshot), ~snapshot.solid) * snapshot.dx
                self.assertAlmostEqual(area / history["reactive_area_m2_per_m"][row], 1, delta=1e-4)
            self.assertGreater(snapshot.field["dissolved_fraction"].sum(), 50)
            self.bonds_lie_where_they_were(run)

    def bonds_lie_where_they_were(self, run):
        """Of rock whose fragments have moved: on the same edges as at the start."""
        first, last = run.snapshot(0), run.snapshot(run.steps[-1])
        np.testing.assert_array_equal(last.bond_ends, first.bond_ends)
        with h5py.File(run.directory / "particles.h5") as particles:
            newest = max(name for name in particles if name.startswith("step_"))
            now = particles[newest]["bonds/vertices"][:, :2].reshape(-1, 2, 2)
        self.assertGreater(np.abs(now - first.bond_ends)[np.isin(last.bond_state, FAILED)].max(), 1e-4)


class Runs(unittest.TestCase):
    def written(self, folder, state):
        """A run of one snapshot of fluid, rock and an opening, with a failed bond whose state has been kept or left out."""
        with h5py.File(folder / "fields.h5", "w") as fields:
            snapshot = fields.create_group("step_0")
            snapshot.attrs.update(time=0.0, step=0)
            snapshot["node_type"] = np.array([[0.0, 1, 2]])
            snapshot["node_type"].attrs.update(dx=DX, time=0.0)
        with h5py.File(folder / "particles.h5", "w") as particles:
            rock = {"triangles/vertices": np.zeros((6, 3)), "bonds/vertices": np.array([[0, 0, 0], [DX, 0, 0.0]])}
            if state is not None:
                rock["bonds/state"] = np.array([float(state)])
            for name, values in rock.items():
                particles.create_dataset(f"step_0/{name}", data=values).attrs["time"] = 0.0
        return Run(folder)

    def test_failed_bonds_are_told_or_missed_aloud(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            self.assertEqual(len(self.written(folder, state=FAILED[0]).snapshot(0).bonds(FAILED)), 1)
            with self.assertRaisesRegex(SystemExit, "lack the state of the bonds"):
                self.written(folder, state=None).snapshot(0)

    def test_openings_are_no_rock(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.written(pathlib.Path(folder), FAILED[0]).snapshot(0).solid.tolist(), [[False, True, False]])


class Members(unittest.TestCase):
    def test_each_has_its_own_folder_and_keeps_its_rate_constant(self):
        members = {m for part in PARTS.values() for m in part}
        self.assertEqual(len({m.folder for m in members}), len(members))
        for m in members:
            last = dict(text.split("=", 1) for text in m.settings)
            diffusivity = float(last.get("solute.species.0.diffusivity", 5e-4))
            kept = 0.02 / 0.0083 * 2.075e-4 if diffusivity == 2.075e-4 else 5e-4
            self.assertAlmostEqual(float(last["reaction.damkohler"]) * diffusivity / (m.da * kept), 1, delta=1e-5)
            self.assertEqual(float(last["boundary.injection.flow.pressure"]), m.pressure * 1e6)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
