"""The Python package on runs that the executable has just made."""
import os
import pathlib
import sys
import tempfile
import unittest

root = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "python"))
os.chdir(root)

import matplotlib

matplotlib.use("Agg")
import numpy as np
import vug
import vug.plot
from matplotlib import pyplot as plt


class OpenRuns(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_case(self, case, overrides=None, **options):
        run = vug.run(case, self.folder / "run", overrides, **options)
        self.addCleanup(run.close)
        return run

    def test_channel_has_its_profile_in_si(self):
        run = self.run_case("cases/poiseuille.toml")
        velocity = run[-1]["velocity"]
        self.assertEqual(velocity.units, "m/s")
        case = run.case
        height, spacing = case["lattice"]["size"][1], case["lattice"]["spacing"]
        force, viscosity = case["flow"]["body_force"][0], case["flow"]["viscosity"]
        self.assertEqual((velocity.x[0], velocity.y[0]), (spacing / 2, spacing / 2))
        np.testing.assert_allclose(velocity[:, 0, 0], force * velocity.y * (height - velocity.y) / (2 * viscosity),
                                   rtol=1e-6)

    def test_history_has_columns_with_units(self):
        run = self.run_case("tests/cases/coupled/small_rock.toml", steps=20)
        history = run.history
        self.assertEqual(history.units["time"], "s")
        self.assertEqual(history.units["kinetic_energy"], "J/m")
        self.assertEqual(len(history["time"]), len(history))
        np.testing.assert_array_equal(history["time"], history["time_s"])
        self.assertAlmostEqual(history["time"][-1], 20 * run.case["lattice"]["time_step"])
        with self.assertRaisesRegex(KeyError, "dissolved_volume"):
            history["disolved_volume"]

    def test_species_and_probes_may_be_called_as_units_are(self):
        names = ["K", "Pa", "m", "tracer_1"]
        run = self.run_case("cases/poiseuille.toml", {
            "solute": {"species": [{"name": name, "diffusivity": 1e-9, "initial": k + 1} for k, name in enumerate(names)]},
            "output.probes": [{"name": "at_N", "at": [1e-4, 1e-4]}]}, steps=2)
        history = run.history
        with open(run.directory / "history.csv") as file:
            header = file.readline().strip().split(",")
        self.assertEqual(len(history.units), len(header))
        for k, name in enumerate(names):
            np.testing.assert_allclose(history[f"at_N_concentration_{name}"], k + 1)
            self.assertEqual(history.units[f"at_N_concentration_{name}"], "mol/m3")
            np.testing.assert_array_equal(history[f"{name}_stored"], history[f"{name}_stored_mol_per_m"])
        self.assertEqual(history.units["at_N_velocity_x"], "m/s")

    def test_names_without_units_are_of_one_column(self):
        path = self.folder / "history.csv"
        path.write_text("time_s,right_flow_kg_per_m_s,p_x_N_s_per_m,a_m,a_N_per_m,b_m,b_m_m\n0,1,2,3,4,5,6\n")
        history = vug.History(path)
        self.assertEqual(history.units, {"time": "s", "right_flow": "kg/(m s)", "p_x": "N s/m", "a_m": "m", "a_N_per_m": "N/m",
                                         "b": "m", "b_m_m": "m"})
        self.assertEqual([history[name][0] for name in ("a_m", "a_N_per_m", "b", "b_m", "b_m_m")], [3, 4, 5, 5, 6])
        self.assertEqual([history.units[name] for name in ("time_s", "b_m", "right_flow_kg_per_m_s")], ["s", "m", "kg/(m s)"])
        for unknown in ("b_kg", "c_m"):
            with self.assertRaises(KeyError):
                history.units[unknown]
        with self.assertRaisesRegex(KeyError, "'a' may be a_m or a_N_per_m"):
            history["a"]
        self.assertEqual([(name, column[0]) for name, column in history.items()], list(zip(history.units, range(7))))
        self.assertEqual({name: column[0] for name, column in dict(history).items()}, dict(zip(history.units, range(7))))
        self.assertEqual(([column[0] for column in history.values()], len(history.values())), (list(range(7)), 7))
        path.write_text("time_s,a_m,a_m\n")
        with self.assertRaisesRegex(vug.FileTrouble, "history.csv: has two columns a_m"):
            vug.History(path)

    def test_bars_may_be_unknown(self):
        path = self.folder / "error_bars.csv"
        path.write_text("time_s,a_m,bar_of_a_m\n0,1,\n")
        self.assertTrue(np.isnan(vug.History(path)["bar_of_a"][0]))
        path.write_text("time_s,a_m,bar_of_a_m\n0,,1\n")
        with self.assertRaisesRegex(vug.FileTrouble, "error_bars.csv:2: .*must be a number"):
            vug.History(path)

    def test_a_run_is_a_sequence(self):
        run = self.run_case("cases/poiseuille.toml", {"output.interval_steps": 2}, steps=6)
        self.assertEqual([snapshot.step for snapshot in run[1:]], [2, 4, 6])
        self.assertEqual([snapshot.step for snapshot in run[::-2]], [6, 2])
        self.assertEqual(run[4:], [])
        with self.assertRaises(IndexError):
            run[4]

    def test_only_the_end_of_a_history_may_be_torn(self):
        path = self.folder / "history.csv"
        path.write_text("time_s,a_m\n0,1\n1,2\n2,")
        np.testing.assert_array_equal(vug.History(path)["a"], [1, 2])
        for line, problem in (("1", "has 1 cells, the header has 2"), ("1,2,3", "has 3 cells"), ("1,x", "'x'"), ("", "1 cells")):
            path.write_text(f"time_s,a_m\n0,1\n{line}\n2,3\n")
            with self.assertRaisesRegex(vug.FileTrouble, f"history.csv:3: .*{problem}"):
                vug.History(path)

    def test_fields_become_arrays_of_numpy(self):
        """As of numpy 2, to which a field says that it cannot do without a copy."""
        pressure = self.run_case("cases/poiseuille.toml", steps=20)[-1]["pressure"]
        np.testing.assert_array_equal(np.asarray(pressure), pressure.values)
        self.assertEqual(np.asarray(pressure, dtype=np.float32).dtype, np.float32)
        np.testing.assert_array_equal(pressure.__array__(copy=True), pressure.values)
        with self.assertRaisesRegex(ValueError, "pressure lies on disk"):
            pressure.__array__(copy=False)

    def test_fields_become_arrays_of_xarray(self):
        run = self.run_case("cases/poiseuille.toml", steps=2)
        try:
            import xarray
        except ImportError:
            with self.assertRaises(ImportError):
                run[-1]["velocity"].to_xarray()
            return
        velocity = run[-1]["velocity"].to_xarray()
        self.assertIsInstance(velocity, xarray.DataArray)
        self.assertEqual((velocity.name, velocity.attrs["units"]), ("velocity", "m/s"))
        self.assertEqual(velocity.dims[:2], ("y", "x"))
        np.testing.assert_array_equal(velocity.coords["x"], run[-1]["velocity"].x)
        np.testing.assert_array_equal(velocity.values, run[-1]["velocity"].values)

    def test_rock_follows_the_links(self):
        run = self.run_case("tests/cases/coupled/small_rock.toml", steps=20)
        last = run[-1]
        self.assertEqual(last.step, 20)
        bonds, triangles = last.rock.bonds, last.rock.triangles
        self.assertEqual(bonds["stress"].units, "Pa")
        self.assertEqual(bonds["stress"].shape, (bonds["state"].shape[0], 3))
        self.assertEqual(triangles["displacement"].shape[1], 3)
        with self.assertRaises(AttributeError):
            bonds["state"].x

    def test_overrides_reach_the_run(self):
        run = self.run_case("tests/cases/coupled/small_rock.toml",
                            {"output.fields": ["pressure"], "accuracy.precision": "single"}, steps=2)
        self.assertEqual(run.record["precision"], "single")
        self.assertEqual(run[-1].keys(), ["pressure"])
        self.assertEqual([(name, field.name) for name, field in run[-1].items()], [("pressure", "pressure")])
        self.assertEqual([field.units for field in run[-1].values()], [run[-1]["pressure"].units])

    def test_warnings_are_passed_on(self):
        with self.assertWarnsRegex(vug.VugWarning, "^flow: relaxation time tau_f = 3.5 is outside") as caught:
            self.run_case("cases/poiseuille.toml", {"flow.viscosity": 1e-5}, steps=2)
        self.assertEqual(pathlib.Path(caught.filename).name, "package_test.py")

    def test_a_picture_without_rock_is_warned_of(self):
        (self.folder / "a.raw").write_bytes(b"@" * 16)
        (self.folder / "case.toml").write_text(
            "[lattice]\nsize = [4, 4]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 1\n[flow]\nviscosity = 0.1\n"
            "[geometry]\ntype = 'image'\nfile = 'a.raw'\nraw_size = [4, 4]\ngrey_range = [0, 1]\n")
        with self.assertWarnsRegex(vug.VugWarning, "a.raw: has values 64 ... 64, and geometry.grey_range, .* no rock"):
            self.run_case(self.folder / "case.toml")

    def test_errors_have_types(self):
        with self.assertRaisesRegex(vug.CaseError, "viscosity.*must be") as caught:
            vug.run("cases/poiseuille.toml", self.folder / "bad", {"flow.viscosity": -1})
        self.assertEqual(caught.exception.exit_code, 2)
        self.assertFalse((self.folder / "bad").exists())
        with self.assertRaises(vug.FileTrouble):
            vug.open(self.folder)
        self.assertAlmostEqual(vug.check("cases/poiseuille.toml", {"flow.viscosity": 2e-6})["limits"][0]["value"], 1.1)

    def test_pictures_of_a_run(self):
        run = self.run_case("tests/cases/coupled/small_rock.toml", steps=200)
        self.assertEqual([panel.name for panel in vug.plot.panels_of(run[-1])][:3], ["pressure", "speed", "temperature"])
        self.assertGreater(vug.plot.overview(run[-1], self.folder / "overview.png").stat().st_size, 10000)
        topics = vug.plot.topics_of(run.history)
        self.assertEqual(list(topics), ["acid", "rock", "heat", "cracks", "balances"])
        with self.assertRaisesRegex(KeyError, "no 'rocks'; there are acid, rock, heat, cracks, balances"):
            vug.plot.topic(run.history, "rocks", "rocks.png")
        spent = {curve.label: curve.values for curve in topics["acid"][0][2]}["spent on rock"]
        np.testing.assert_array_equal(spent, -run.history["L1_gain_reaction"])
        figure, axes = plt.subplots()
        frame = vug.plot.Frame(run[-1])
        image = vug.plot.draw_panel(axes, vug.plot.panels_of(run[-1])[0], frame)
        np.testing.assert_allclose(image.get_extent(), [0, 2, 0, 1.4])
        self.assertEqual(frame.unit, "cm")
        plt.close(figure)

    def test_pictures_are_in_units_that_are_read(self):
        from vug.plot import style
        from vug.plot.movie import scales_of

        self.assertEqual(style.Scale("m/s", 0, 0.006).label, "mm/s")
        self.assertEqual(style.Scale("mol/m3", 0, 5).label, "mol/m³")
        self.assertAlmostEqual(style.Scale("m/s", 0, 0.006)(0.006), 6)
        self.assertEqual(style.Scale("Pa", 1e5, 2e7).label, "MPa")
        narrow = style.Scale("Pa", 100000.1, 100020)
        self.assertEqual((narrow.label, narrow(100020)), ("Pa above 100 kPa", 20))
        self.assertEqual(style.readable("m²", 7.2e-8), (1e6, "mm²"))
        self.assertEqual(style.Scale("1", 0, 1).label, "")
        run = self.run_case("cases/poiseuille.toml")
        panels = {panel.name: panel for panel in vug.plot.panels_of(run[-1])}
        self.assertEqual(panels["pressure"].title, "gauge pressure")
        self.assertTrue({panel.name: panel for panel in vug.plot.panels_of(run[0])}["speed"].uniform)
        largest = panels["speed"].values.max()  # that the fluid is at rest at first leaves the scale of the movie alone
        np.testing.assert_allclose(scales_of(run, ["speed"])["speed"], (0, largest), rtol=0.01)

    def test_minerals_have_their_names(self):
        run = self.run_case("cases/minerals.toml", steps=2)
        self.assertEqual(run[-1].minerals, ["rock", "calcite", "dolomite", "quartz"])
        text = run.record["case_text"]
        run._recorded = {"case_text": "\ufeff" + text}.get  # from an editor that marks UTF-8
        self.assertEqual([table["name"] for table in run.case["mineral"]], run[-1].minerals[1:])
        panel = {panel.name: panel for panel in vug.plot.panels_of(run[-1])}["mineral"]
        figure, axes = plt.subplots()
        vug.plot.draw_panel(axes, panel, vug.plot.Frame(run[-1]))
        figure.canvas.draw()
        bar = axes.child_axes[0]
        self.assertEqual([label.get_text() for label in bar.get_yticklabels()], run[-1].minerals)
        plt.close(figure)

    def test_what_two_acids_did_adds_up(self):
        second = {"solute.species.2.name": "HAc", "solute.species.2.diffusivity": 3e-9, "reaction.further.0.reactant": "HAc",
                  "reaction.further.0.product": "Ca", "reaction.further.0.rate_constant": 1e-4,
                  "boundary.left.solute.concentration.HAc": "0.5 mol/L"}
        history = self.run_case("cases/minerals.toml", second, steps=400).history
        drawn = {title: {curve.label: curve.values[-1] for curve in curves}
                 for title, _, curves in vug.plot.topics_of(history)["acid"]}
        self.assertGreater(drawn["HAc"]["spent on rock"], 0)
        for species, curves in drawn.items():
            kept = (curves["injected"] + curves.get("made by reaction", 0) - curves.get("spent on rock", 0)
                    - curves.get("flowed out", 0))
            small = history[f"{species}_gain_births"][-1] + history[f"{species}_gain_advective_form"][-1]
            np.testing.assert_allclose(kept + small, curves["in the pores"], rtol=1e-9)

    def test_a_study_and_its_map(self):
        case = root / "cases/poiseuille.toml"
        (self.folder / "study.toml").write_text(f"""
            [study]
            case = "{case}"
            set = ["time.steps=2000", "flow.speed_limit=0"]
            [[study.keys]]
            key = "flow.viscosity"
            values = [1e-6, 2e-6]
            [[study.keys]]
            key = "flow.body_force.0"
            values = [1e-3, 2e-3, 1e5]
            """)
        study = vug.sweep(self.folder / "study.toml", self.folder / "study", jobs=2)
        self.assertEqual((len(study), study.keys), (4, ["flow.viscosity", "flow.body_force.0"]))
        self.assertEqual([failure["state"] for failure in study.failures], ["diverged", "diverged"])
        np.testing.assert_array_equal(study["flow.viscosity"], [1e-6, 1e-6, 2e-6, 2e-6])
        force, speed = study["flow.body_force.0"], study["largest_mach_1"]
        self.assertAlmostEqual(speed[1] / speed[0], 2, places=6)  # the flow is as fast as what drives it
        self.assertEqual(force[1] / force[0], 2)
        self.assertTrue(vug.plot.regime_map(study, self.folder / "map.png").exists())
        figure, axes = plt.subplots()
        vug.plot.draw_result(axes, study, "largest_mach_1")  # two by two: cells around the values, which are the ticks
        np.testing.assert_allclose(axes.get_xticks(), [1e-6, 2e-6])
        np.testing.assert_allclose(axes.get_xlim(), [0.5e-6, 2.5e-6])
        plt.close(figure)
        self.assertEqual(study.run(1).record["status"], "done")

    def test_a_study_knows_no_number_where_a_cell_is_empty(self):
        (self.folder / "table.csv").write_text("run,reaction.rate,image.file,volume_m3\n0001,1,a.png,2.5\n0002,2,,\n")
        study = vug.Study(self.folder)
        np.testing.assert_array_equal(study["volume_m3"], [2.5, np.nan])
        np.testing.assert_array_equal(study["image.file"], ["a.png", ""])
        self.assertEqual(list(dict(study.items())), ["reaction.rate", "image.file", "volume_m3"])

    def test_a_map_over_quantities_with_units_in_which_a_run_failed(self):
        (self.folder / "table.csv").write_text("run,reaction.rate,flow.pressure,volume_m3\n"
                                               "0001,1e-6,2 kPa,1\n0002,1e-6,10 kPa,2\n0003,1e-3,2 kPa,3\n")
        figure, axes = plt.subplots()
        vug.plot.draw_result(axes, vug.Study(self.folder), "volume_m3")
        self.assertEqual([label.get_text() for label in axes.get_yticklabels()], ["2 kPa", "10 kPa"])
        cells = axes.collections[0].get_array().reshape(2, 2)
        self.assertEqual((cells[0, 0], cells[1, 0], cells[0, 1], cells.mask[1, 1]), (1, 2, 3, True))
        plt.close(figure)


if __name__ == "__main__":
    unittest.main(verbosity=1)
