"""Starting vug from Python: interrupts, values in place of the case's, and what goes wrong."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from unittest import mock

root = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "python"))
os.chdir(root)

import numpy as np
import vug

ENDLESS = {"time.steps": 10**9}


class Launch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name) / "run"

    def test_overrides_may_be_any_value(self):
        overrides = {"boundary.left.flow": {"type": "pressure", "pressure": "100.000001 kPa"},
                     "boundary.right.flow": {"type": "outflow"},
                     "solute.species": [{"name": "A", "diffusivity": np.float32(1e-9)}, {"name": "B+", "diffusivity": 2e-9}],
                     "boundary.left.solute": {"type": "concentration", "concentration": {"A": np.array([[0, 1], [1, 2.5]]), "B+": 1}},
                     "case.description": 'a "rock" 𝄞 of\x7f two\nlines',
                     "output.compress": np.bool_(False), "output.interval_steps": np.int64(1), "time.steps": 2}
        with vug.run("cases/poiseuille.toml", self.folder, overrides) as run:
            self.assertEqual(run.status, "done")
            self.assertIn("concentration_B+", run[-1])
        for endless in (float("inf"), np.float32("inf"), np.float64("nan")):
            with self.assertRaisesRegex(vug.CaseError, "flow.viscosity = (inf|nan) must be"):
                vug.check("cases/poiseuille.toml", {"flow.viscosity": endless})
        for wrong in (None, {"a": object()}, "\ud800"):
            with self.assertRaisesRegex(vug.CaseError, "is no (value|text)"):
                vug.check("cases/poiseuille.toml", {"case.name": wrong})

    def test_a_run_has_error_bars_where_they_are_asked_for(self):
        vug.run("cases/tutorial/channel.toml", self.folder, {"time.steps": 200, "output.interval": 0.0125}, error_bars=True)
        bars = vug.History(self.folder / "error_bars.csv")
        self.assertIn("bar_of_fluid_mass_stored", bars)
        self.assertEqual(len(bars["bar_of_fluid_mass_stored"]), 3)

    def test_overrides_may_be_whole_tables(self):
        minerals = vug.check("cases/minerals.toml", {"mineral": [], "time": {"steps": 7}, "output": {}})
        self.assertEqual(minerals["steps"], 7)
        heat = {"fluid_diffusivity": 1e-6, "solid_diffusivity": 1e-6}
        self.assertIn("heat", {limit["module"] for limit in vug.check("cases/poiseuille.toml", {"heat": heat})["limits"]})
        with vug.run("cases/minerals.toml", self.folder, {"mineral": [{"name": "salt", "shapes": [
                {"type": "rectangle", "from": [0, 0], "to": [1e-3, 1e-3]}]}]}, steps=1) as run:
            self.assertIn("salt_volume_stored", run.history)
        for wrong in (1, "fast", [1, 2], [heat, 1]):
            with self.assertRaisesRegex(vug.CaseError, r"--set heat=.*: expected table.key=value, or for a whole table table="):
                vug.check("cases/poiseuille.toml", {"heat": wrong})
        with self.assertRaisesRegex(vug.CaseError, 'unknown (key|table) "haet"'):
            vug.check("cases/poiseuille.toml", {"haet": heat})

    def test_text_is_utf_8_whatever_the_locale(self):
        """The name of a key that vug repeats, in a locale that has no such letter."""
        code = ("import vug\ntry: vug.check('cases/poiseuille.toml', {'flow': {'vi\\u015bcosity': 1}})\n"
                "except vug.CaseError as error: print(ascii(str(error)))")
        for locale in ("C", "C.UTF-8"):
            environment = {"LC_ALL": locale, "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0", "PYTHONPATH": str(root / "python")}
            done = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True, env=os.environ | environment)
            self.assertIn("unknown key \"flow.vi\\u015bcosity\"", done.stdout, done.stderr)

    def test_a_program_that_is_none_is_one_line(self):
        for place in ("/nonexistent/vug", "/tmp"):
            with mock.patch.dict(os.environ, VUG=place), \
                    self.assertRaisesRegex(vug.VugError, f"^{place}: cannot be run as vug: "):
                vug.check("cases/poiseuille.toml")

    def wait_for_steps(self):
        history = self.folder / "history.csv"
        for _ in range(600):
            if history.exists() and history.read_text().count("\n") > 2:
                break
            time.sleep(0.1)

    def interrupt_under_way(self, number=signal.SIGINT):
        """A signal for this process alone, as a kernel of Jupyter gets its Ctrl-C, when the run has taken steps."""
        self.wait_for_steps()
        os.kill(os.getpid(), number)

    def test_an_exception_of_another_signal_stops_the_run_in_order(self):
        before = signal.signal(signal.SIGTERM, lambda *_: sys.exit(7))
        self.addCleanup(signal.signal, signal.SIGTERM, before)
        threading.Thread(target=self.interrupt_under_way, args=[signal.SIGTERM]).start()
        with self.assertRaises(SystemExit) as caught:
            vug.run("cases/poiseuille.toml", self.folder, ENDLESS)
        self.assertEqual(caught.exception.code, 7)
        with vug.open(self.folder) as run:
            self.assertEqual(run.status, "interrupted")

    def test_a_run_stops_in_order_when_python_is_killed(self):
        call = f"import vug; vug.run('cases/poiseuille.toml', {str(self.folder)!r}, {ENDLESS})"
        python = subprocess.Popen([sys.executable, "-c", call], env=os.environ | {"PYTHONPATH": str(root / "python")})
        self.wait_for_steps()
        python.kill()
        python.wait()
        for _ in range(300):
            with vug.open(self.folder) as run:
                status, reason = run.status, run.record["exit_reason"]
            if status != "running":
                break
            time.sleep(0.1)
        self.assertEqual(status, "interrupted")
        self.assertIn("interrupted by SIGTERM", reason)

    def test_an_interrupt_stops_the_run_in_order(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored where a shell has put us aside
        self.addCleanup(signal.signal, signal.SIGINT, before)
        threading.Thread(target=self.interrupt_under_way).start()
        with self.assertRaisesRegex(vug.Interrupted, "interrupted by SIGINT") as caught:
            vug.run("cases/poiseuille.toml", self.folder, ENDLESS)
        self.assertEqual(caught.exception.exit_code, 130)
        with vug.open(self.folder) as run:
            self.assertEqual(run.status, "interrupted")
            steps = run.record["steps"]
        self.assertGreater(steps, 0)
        with vug.run("cases/poiseuille.toml", self.folder, ENDLESS, steps=steps + 1, resume=True) as run:
            self.assertEqual((run.status, run.record["steps"]), ("done", steps + 1))


if __name__ == "__main__":
    unittest.main(verbosity=1)
