"""Starting vug from Python: interrupts, values in place of the case's, and what goes wrong."""
import os
import pathlib
import signal
import sys
import tempfile
import threading
import time
import unittest

root = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "python"))
os.chdir(root)

import vug

ENDLESS = {"time.steps": 10**9}


class Launch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name) / "run"

    def interrupt_under_way(self):
        """Ctrl-C for this process alone, as a kernel of Jupyter gets it, when the run has taken steps."""
        history = self.folder / "history.csv"
        for _ in range(600):
            if history.exists() and history.read_text().count("\n") > 2:
                break
            time.sleep(0.1)
        os.kill(os.getpid(), signal.SIGINT)

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
