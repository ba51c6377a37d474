"""Pictures of what runs may hold: openings, gauge pressure alone, rock alone, nothing on the lattice, sampled studies."""
import importlib.machinery
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

root = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "python"))
os.chdir(root)

import h5py
import matplotlib

matplotlib.use("Agg")
import numpy as np
import vug
import vug.plot
from matplotlib import pyplot as plt
from vug.plot import laboratory

SMALL_ROCK = "tests/cases/coupled/small_rock.toml"


def snapshot_of(fields):
    """A snapshot that holds these fields of the lattice, and no rock."""
    group = h5py.File("made-up", "w", driver="core", backing_store=False).create_group("step_0")
    group.attrs.update(time=0.5, step=1)
    for name, values in fields.items():
        group.create_dataset(name, data=np.asarray(values, dtype=float)).attrs.update(units=b"1", time=0.5, dx=1e-3, origin=[0, 0])
    return vug.Snapshot(group, None)


class Pictures(unittest.TestCase):
    def test_a_picture_that_cannot_be_written_leaves_the_one_before(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.png"
            path.write_text("before", encoding="utf-8")
            figure = plt.figure()
            with unittest.mock.patch.object(figure, "savefig", side_effect=OSError(28, "No space left on device")):
                with self.assertRaisesRegex(vug.VugError, f"{path}: No space left on device"):
                    vug.plot.style.save(figure, path)
            self.assertEqual([entry.name for entry in path.parent.iterdir()], ["a.png"])
            self.assertEqual(path.read_text(encoding="utf-8"), "before")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_rock(self, fields):
        run = vug.run(SMALL_ROCK, self.folder / "run", {"output.fields": fields, "output.interval": 2.5e-5}, steps=20)
        self.addCleanup(run.close)
        return run

    def plot(self, *options):
        return subprocess.run([sys.executable, "scripts/plot", self.folder / "run", *options], capture_output=True, text=True)

    def pictures(self):
        return {path.name for path in (self.folder / "run/figures").iterdir()}

    def test_openings_are_no_rock_and_hold_no_fluid(self):
        snapshot = snapshot_of({"node_type": [[0, 1, 2]], "pressure": [[1, 2, 3]]})
        panels = {panel.name: panel for panel in vug.plot.panels_of(snapshot)}
        self.assertEqual(panels["rock"].values.tolist(), [[0, 1, 0]])
        self.assertEqual(panels["pressure"].values.mask.tolist(), [[False, True, True]])

    def test_openings_have_no_temperature(self):
        """There the field has what it began with, hotter here than a cold well has left any rock."""
        snapshot = snapshot_of({"node_type": [[1, 0, 2]], "temperature": [[340, 350, 400]], "solid_fraction": [[1, 0, 1]]})
        for panel in vug.plot.panels_of(snapshot):
            self.assertEqual(panel.values.mask.tolist(), [[False, False, True]], panel.name)
        self.assertEqual({panel.name: panel.high for panel in vug.plot.panels_of(snapshot)}["temperature"], 350)

    def test_a_bar_that_ends_below_the_largest_value_says_so(self):
        speeds = np.zeros((100, 100, 3))
        speeds[..., 0], speeds[0, 0, 0] = 1, 3
        snapshot = snapshot_of({"velocity": speeds, "pressure": np.arange(1e4).reshape(100, 100)})
        figure, axes = plt.subplots()
        for panel, extend, label in zip(vug.plot.panels_of(snapshot), ("neither", "max"), ("", ", up to 3")):
            bar = vug.plot.draw_panel(axes, panel, vug.plot.Frame(snapshot)).colorbar
            self.assertEqual((bar.extend, bar.ax.get_ylabel()), (extend, label))
        plt.close(figure)

    def test_cracks_lie_where_the_rock_of_the_lattice_is(self):
        """Also when the fragments have flown away; on triangles they lie where these are."""
        run = vug.run(SMALL_ROCK, self.folder / "run")
        self.addCleanup(run.close)
        frame = vug.plot.Frame(run[-1])
        _, width, _, height = frame.extent
        first = run[0].rock.bonds["vertices"].values[:, :2]
        np.testing.assert_array_equal(run[-1].rock.first_bond_ends[:, :2], first)
        for moved in (False, True):
            kinds = {label: lines for label, _, _, lines in vug.plot.cracks.segments_of(run[-1].rock, frame.scale, moved)}
            inside = (np.abs(kinds["bond failed"] - [width / 2, height / 2]) < [0.51 * width, 0.51 * height]).all()
            self.assertEqual((len(kinds["bond failed"]), inside), (6, not moved))
        panel = vug.plot.panels_of(run[-1])[0]
        lines = {label: lines for label, _, _, lines in vug.plot.fields.segments_on(panel, run[-1], frame)}
        self.assertLess(lines["bond failed"].max(), 2.1)

    def test_pictures_of_a_run_that_was_replaced_go(self):
        self.run_rock(["temperature", "pressure"]).close()
        self.plot("--all")
        mine = self.folder / "run/figures/mine.png"
        mine.touch()
        before = self.pictures()
        fields = {"output.fields": ["temperature", "pressure"], "output.interval": 2.5e-5}
        vug.run(SMALL_ROCK, self.folder / "run", fields, steps=30, resume=True).close()
        self.plot()
        self.assertEqual(self.pictures(), before)  # still of this run
        vug.run(SMALL_ROCK, self.folder / "run", {"output.fields": ["pressure"]}, steps=20, overwrite=True).close()
        done = self.plot()
        drawn = {pathlib.Path(line).name for line in done.stdout.split()}
        self.assertEqual(drawn | {"mine.png", "drawn.json"}, self.pictures())
        self.assertNotIn("temperature.png", self.pictures())

    def test_gauge_pressure_alone_is_drawn(self):
        snapshot = snapshot_of({"gauge_pressure": [[1, 2, 4]]})
        panel, = vug.plot.panels_of(snapshot)
        self.assertEqual((panel.name, panel.title, panel.high), ("gauge_pressure", "gauge pressure", 4))
        self.assertGreater(vug.plot.overview(snapshot, self.folder / "overview.png").stat().st_size, 5000)

    def test_rock_alone_shows_its_triangles(self):
        run = self.run_rock(["displacement", "stress_xx"])
        last = run[-1]
        moved, stress = vug.plot.panels_of(last)
        self.assertEqual((moved.name, stress.name), ("displacement", "stress_xx"))
        np.testing.assert_allclose(moved.values, np.linalg.norm(last.rock.triangles["displacement"].values, axis=1))
        self.assertEqual(stress.low, -stress.high)
        figure, axes = plt.subplots()
        frame = vug.plot.Frame(last)
        drawn = vug.plot.draw_panel(axes, stress, frame)
        self.assertEqual(len(drawn.get_paths()), last.rock.triangles["stress_xx"].shape[0])
        corners = frame.scale * last.rock.triangles["vertices"].values[:3, :2]
        np.testing.assert_allclose(drawn.get_paths()[0].vertices[:3], corners)
        plt.close(figure)
        with unittest.mock.patch.dict(os.environ, {"PATH": ""}), self.assertRaisesRegex(vug.VugError, r"movie.mp4: needs the program ffmpeg"):
            vug.plot.movie(run, self.folder / "movie.mp4")
        done = self.plot("--movie")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertLessEqual({"displacement.png", "stress_xx.png", "overview.png", "movie.gif", "history_heat.png"}, self.pictures())

    def test_histories_are_drawn_where_no_field_can_be(self):
        run = self.run_rock(["rotation"])
        for draw, to in ((vug.plot.overview, run[-1]), (vug.plot.movie, run)):
            with self.assertRaisesRegex(vug.VugError, r"\A[^\n]*no field that could be drawn[^\n]*\Z"):
                draw(to, self.folder / "picture.gif")
        with self.assertRaisesRegex(vug.VugError, "no field 'speed'"):
            vug.plot.movie(run, self.folder / "picture.gif", names=["speed"])
        done = self.plot("--movie")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"\Aplot: .*no field that could be drawn.*\n\Z")
        self.assertIn("history_heat.png", self.pictures())

    def test_curves_of_acid_and_heat_add_up(self):
        """To what is stored, in rock that opens and with a well and a vent."""
        for case, labels in ((SMALL_ROCK, {"new pores, advective form", "made by reaction"}),
                             ("tests/cases/coupled/warm_well.toml", {"through well", "through the sides"})):
            with vug.run(case, self.folder / pathlib.Path(case).stem) as run:
                shown = vug.plot.topics_of(run.history)
            found = set()
            for _, unit, curves in shown.get("acid", []) + shown["heat"][:1]:
                *parts, stored = curves
                self.assertIn(stored.label, ("in the pores", "stored"))
                total = sum(-part.values if part.label in ("spent on rock", "flowed out") else part.values for part in parts)
                largest = max(np.abs(curve.values).max() for curve in curves)
                np.testing.assert_allclose(total, stored.values, atol=1e-6 * largest)
                found |= {part.label for part in parts}
            self.assertLessEqual(labels, found)

    def test_acid_of_a_slow_scene_says_what_time_it_is_of(self):
        gains = {"A_gain_injected": np.array([0.0, 2.0]), "A_gain_reaction": np.array([0.0, -1.0])}
        for factor, title in (((1.0, 1.0), "A"), ((1.0, 20.0), "A, of the lattice steps taken")):
            (drawn, _, _), = vug.plot.topics_of({**gains, "dissolution_factor": np.array(factor)})["acid"]
            self.assertEqual(drawn, title)

    def test_seeds_are_no_axis_and_means_are_told(self):
        """Of two pressures, one or two rates and four seeds; of seven results the first six are drawn."""
        def study(name, rates):
            folder = self.folder / name
            folder.mkdir()
            results = ",".join(f"result{k}_m" for k in range(7))
            (folder / "table.csv").write_text(f"run,rock.seed,flow.pressure,reaction.rate,{results}\n" + "".join(
                f"{seed}{p}{rate},{seed},{p},{rate}," + ",".join(str(p + rate + k * seed) for k in range(7)) + "\n"
                for seed in range(4) for p in (1, 2) for rate in rates))
            return vug.Study(folder)

        title = {}
        for name, rates in (("both", (1, 2)), ("one", (1,))):
            with unittest.mock.patch.object(plt.Figure, "suptitle", lambda _, text, **__: title.update({name: text})):
                vug.plot.regime_map(study(name, rates), self.folder / "map.png")
        self.assertEqual(title["both"], "both: 16 runs; 6 of 7 results; means over rock.seed")
        self.assertEqual(title["one"], "one: 8 runs; 6 of 7 results; means over rock.seed")
        figure, axes = plt.subplots()
        vug.plot.draw_result(axes, vug.Study(self.folder / "both"), "result1_m")
        self.assertEqual({axes.get_xlabel(), axes.get_ylabel()}, {"flow.pressure", "reaction.rate"})
        axes.clear()
        vug.plot.draw_result(axes, vug.Study(self.folder / "one"), "result1_m")
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("flow.pressure", "result1_m"))
        plt.close(figure)

    def test_the_heading_is_the_name_of_the_case_or_that_of_its_file(self):
        loader = importlib.machinery.SourceFileLoader("plot", "scripts/plot")
        plot = importlib.util.module_from_spec(importlib.util.spec_from_loader("plot", loader))
        loader.exec_module(plot)
        for text, heading in (('[case]\nname = "sine"\n', "sine: "), ('[case]\nname = ""\n', "f1: "), ("[time]\n", "f1: ")):
            self.assertEqual(plot.heading_of({"case_path": "cases/f1.toml", "case_text": text}), heading)
        self.assertEqual(plot.heading_of({"case_text": "[case"}), "")
        self.assertEqual(plot.heading_of({}), "")

    def draw_study(self, table, failures="", result="volume_m3"):
        """Axes with a study of this table."""
        (self.folder / "table.csv").write_text(table)
        (self.folder / "failures.csv").write_text(failures)
        figure, axes = plt.subplots()
        self.addCleanup(plt.close, figure)
        vug.plot.draw_result(axes, vug.Study(self.folder), result)
        return axes

    def labels(self, axis):
        return [label.get_text() for label in axis.get_ticklabels()]

    def test_a_key_may_be_infinite(self):
        rows = "".join(f"{x}{y},{x},{y},{len(x)}\n" for x in ("0.1", "inf", "10") for y in (1, 2))
        axes = self.draw_study("run,reaction.equilibrium_constant,flow.density,volume_m3\n" + rows)
        self.assertEqual(self.labels(axes.xaxis), ["0.1", "10", "inf"])
        self.assertEqual(axes.collections[0].get_array().ravel().tolist(), [3, 2, 3] * 2)

    def test_labels_tell_values_apart(self):
        rows = "".join(f"{x}{y},{x},{y},{y}\n" for x in (100000.2, 100000.4, 100000.8) for y in (1e-7, 1.0, 2.0))
        axes = self.draw_study("run,flow.pressure,flow.density,volume_m3\n" + rows)
        self.assertEqual(self.labels(axes.xaxis), ["100000.2", "100000.4", "100000.8"])

    def test_means_are_over_the_runs_that_have_the_result(self):
        rows = "".join(f"{x}{y}{s},{x},{y},{s},{x + y if s == 1 else ''}\n" for x in (1, 2) for y in (1, 2) for s in (1, 2))
        axes = self.draw_study("run,flow.pressure,flow.density,rock.seed,volume_m3\n" + rows)
        self.assertEqual(axes.collections[0].get_array().ravel().tolist(), [2, 3, 3, 4])

    def test_text_stands_in_the_order_of_the_study_where_runs_have_failed(self):
        header = "run,flow.viscosity,flow.density,volume_m3"
        runs = [(f"{1 + 3 * k + i:04}", name, i) for k, name in enumerate(("1 Pas", "2 Pas", "3 Pas")) for i in range(3)]
        rows = "".join(f"{run},{name},{i},{i}\n" for run, name, i in runs if name != "1 Pas" or i == 2)
        failed = "".join(f"{run},{name},{i},diverged,\n" for run, name, i in runs if name == "1 Pas" and i < 2)
        axes = self.draw_study(header + "\n" + "".join(sorted(rows.splitlines(True), reverse=True)),
                               "run,flow.viscosity,flow.density,state,last line\n" + failed)
        self.assertEqual(self.labels(axes.xaxis), ["1 Pas", "2 Pas", "3 Pas"])

    def test_results_may_begin_with_the_name_of_time(self):
        (self.folder / "failures.csv").write_text("run,flow.density,state,last line\n3,3,diverged,\n")
        (self.folder / "table.csv").write_text("run,flow.density,time_s,step_1,step_edge_m,a_m\n1,1,1,7,2,1\n2,2,2,8,3,1\n")
        study = vug.Study(self.folder)
        self.assertEqual(vug.plot.studies.results_of(study), ["step_edge_m"])
        (self.folder / "table.csv").write_text("run,flow.density,time_s,step_1\n1,1,1,7\n2,2,1,8\n")
        self.assertEqual(vug.plot.studies.results_of(vug.Study(self.folder)), ["step_1"])
        with unittest.mock.patch.object(plt.Figure, "suptitle") as title:
            vug.plot.regime_map(study, self.folder / "map.png")
        self.assertEqual(title.call_args.args[0], f"{study.name}: 2 of 3 runs done")

    def test_pictures_say_where_rock_is_not_told_from_fluid(self):
        for fields, said in ((["pressure"], "plot: without node_type"), (["pressure", "node_type"], "")):
            self.run_rock(fields)
            self.assertEqual(self.plot().stderr.split(" among")[0], said)
            shutil.rmtree(self.folder / "run")

    def test_labels_of_a_few_samples_do_not_overlap(self):
        samples = "".join(f"{k:04},{x},{y},{k}\n" for k, (x, y) in enumerate([(1.0123456, 1), (1.0223456, 5), (1.03, 3), (1.9, 2)]))
        (self.folder / "table.csv").write_text("run,flow.density,flow.viscosity,volume_m3\n" + samples)
        figure, axes = plt.subplots(figsize=(4.8, 3.8))
        vug.plot.draw_result(axes, vug.Study(self.folder), "volume_m3")
        figure.canvas.draw()
        boxes = [label.get_window_extent() for label in axes.get_xticklabels() if label.get_text()]
        self.assertGreater(len(boxes), 2)
        for left, right in zip(boxes, boxes[1:]):
            self.assertLess(left.x1, right.x0)
        plt.close(figure)

    def test_the_legend_of_a_flat_specimen_lies_below_the_label_of_its_axis(self):
        for height in (0.003, 0.015, 0.2):
            particles = h5py.File(f"specimen {height}", "w", driver="core", backing_store=False)
            particles["rock/triangle_vertex_numbers"] = [[0, 1, 2], [1, 3, 2]]
            step = particles.create_group("step_0")
            step.attrs["time"] = 1e-3
            step["triangles/vertices"] = [[0, 0, 0], [0.06, 0, 0], [0, height, 0], [0.06, 0, 0], [0.06, height, 0], [0, height, 0]]
            step["bonds/vertices"] = [[0.06, 0, 0], [0, height, 0]] * 2
            step["bonds/state"] = [1, 3]
            with unittest.mock.patch("vug.plot.laboratory.save", lambda figure, path: figure):
                figure = laboratory.plot_cracks(particles, "step_0", self.folder, "", "")
            figure.canvas.draw()
            axes = figure.axes[0]
            legend = axes.get_legend().get_window_extent()
            self.assertLess(legend.y1, axes.xaxis.label.get_window_extent().y0, height)
            self.assertGreater(legend.y0, 0)
            plt.close(figure)


if __name__ == "__main__":
    unittest.main(verbosity=1)
