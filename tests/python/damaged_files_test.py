"""scripts/plot of what is damaged, lost or not there yet: one line and exit code 4."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

root = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(root / "python"))
os.chdir(root)

import h5py
import vug


class Plot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        vug.run("tests/cases/coupled/small_rock.toml", cls.folder / "whole", steps=10).close()

    def setUp(self):
        shutil.rmtree(self.folder / "run", ignore_errors=True)
        shutil.copytree(self.folder / "whole", self.folder / "run")

    def require(self, says):
        done = subprocess.run([sys.executable, "scripts/plot", self.folder / "run"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertRegex(done.stderr, f"\\Aplot: .*{says}.*\n\\Z")

    def snapshot(self, kind):
        return sorted((self.folder / "run" / kind).iterdir())[-1]

    def test_where_no_pictures_can_be_written(self):
        (self.folder / "run/figures").write_text("not a folder")
        self.require("/run/figures(/drawn.json)?: (File exists|Not a directory)")

    def test_snapshots(self):
        os.truncate(self.snapshot("particles"), 500)
        self.require("particles.h5: step_000000000010: ")
        self.snapshot("fields").unlink()
        self.require("fields.h5: step_000000000010: ")
        os.truncate(self.folder / "run/fields.h5", 300)
        self.require("fields.h5: ")

    def test_blocks_of_fields(self):
        with h5py.File(self.snapshot("fields")) as file:
            name = next(iter(file))
            group = file[name] if isinstance(file[name], h5py.Group) else file
            at = group["pressure"].id.get_chunk_info(0) if group["pressure"].chunks else None
        with open(self.snapshot("fields"), "r+b") as file:
            file.seek(at.byte_offset)
            file.write(bytes(at.size))
        self.require("/fields/step_[0-9]*.h5: .*pressure: ")
        with vug.open(self.folder / "run") as run:
            for read in (lambda: run[-1]["pressure"].values, lambda: run[-1]["pressure"][0, 0]):
                with self.assertRaisesRegex(vug.FileTrouble, r"\A[^\n]*fields/step_[0-9]*.h5: [^\n]*\Z"):
                    read()

    def test_python_names_the_file(self):
        def refused(what, read):
            with vug.open(self.folder / "run") as run, self.assertRaisesRegex(vug.FileTrouble, rf"\A[^\n]*{what}[^\n]*\Z"):
                read(run)

        record = self.folder / "run/run.json"
        for text, why in (("{", "is damaged"), ("[]", "is damaged: holds no table"), ("{}", "has no 'status'"), (b"\xff", "no UTF-8")):
            record.write_bytes(text if isinstance(text, bytes) else text.encode())
            refused(f"run.json: .*{why}", lambda run: run.status)
            refused("run.json: ", lambda run: run.case)
        record.write_text('{"case_text": "["}')
        refused("run.json: is damaged: case_text", lambda run: run.case)
        record.unlink()
        refused("run.json: No such file", lambda run: run.record)
        (self.folder / "run/history.csv").unlink()
        refused("history.csv: No such file", lambda run: run.history)

    def test_tables(self):
        (self.folder / "run/history.csv").write_text("")
        self.require("history.csv: has not even a header")
        (self.folder / "run/table.csv").write_text("")
        self.require("table.csv: has not even a header")
        (self.folder / "run/table.csv").write_text("run,flow.viscosity\n")
        self.require("none of its runs is done; failures.csv says why")
        (self.folder / "run/cracks.csv").write_text("depth_m,cracks_1\n")
        (self.folder / "run/particles.h5").unlink()
        self.require("cracks.csv holds no row yet")
        (self.folder / "run/stress_strain.csv").write_text("")
        self.require("stress_strain.csv: has not even a header")
        (self.folder / "run/stress_strain.csv").write_text("time_s\n1\n")
        self.require("stress_strain.csv: no column 'seed_1'")


if __name__ == "__main__":
    unittest.main(verbosity=1)
