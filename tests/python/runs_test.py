"""Tests taxel.sweep and taxel.play through the program of the package."""
import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import taxel

GOLDEN = json.loads(pathlib.Path(os.environ["TAXEL_GOLDEN"]).read_text())
COARSE = {"density": 1e5, "past": 0, "object": "box"}


class SweepTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.run_of_paper = taxel.sweep(threads=1)

    def test_peaks_are_the_golden_ones(self):
        (sensor,) = self.run_of_paper.sensors
        self.assertEqual((len(self.run_of_paper), sensor.unit, sensor.geom), (501, "Pa", "finger"))
        peaks = dict(zip(map(str, sensor.ids.tolist()), sensor.readings.max(axis=0)))
        self.assertEqual(set(peaks), set(GOLDEN))
        for taxel_id, peak in GOLDEN.items():
            self.assertAlmostEqual(peaks[taxel_id], peak, delta=1e-6 * (peak + 1))

    def test_all_columns_have_their_shapes(self):
        run = self.run_of_paper
        (sensor,) = run.sensors
        rows = len(run)
        self.assertEqual((run.time.shape, run.travel.shape), ((rows,), (rows,)))
        self.assertEqual((sensor.force.shape, sensor.pos.shape, sensor.quat.shape), ((rows, 3), (rows, 3), (rows, 4)))
        self.assertEqual((sensor.readings.shape, sensor.area.shape), ((rows, 12), (rows,)))
        self.assertEqual(sensor.elastic_force.shape, (rows, 3))
        largest = np.abs(sensor.force).max()
        self.assertGreater(np.abs(sensor.force - sensor.elastic_force).max(), 1e-3 * largest, "friction is in one only")
        self.assertEqual((run.travel[0], run.timestep), (0, 0.001))
        np.testing.assert_allclose(np.linalg.norm(sensor.quat, axis=1), 1, rtol=1e-12)
        self.assertIsNone(sensor.calibrated)
        self.assertEqual(sensor.layout.names, sensor.names)

    def test_layouts_in_memory_and_files_give_the_same_rows(self):
        layout = taxel.Layout.read(taxel.FINGERTIP)
        by_file = taxel.sweep(taxel.FINGERTIP, **COARSE).sensors[0].readings
        np.testing.assert_array_equal(taxel.sweep(layout, **COARSE).sensors[0].readings, by_file)
        layout.delete_taxels([0])
        self.assertEqual(taxel.sweep(layout, **COARSE).sensors[0].readings.shape[1], 11)

    def test_folder_receives_the_files(self):
        with tempfile.TemporaryDirectory() as folder:
            run = taxel.sweep(out=pathlib.Path(folder) / "run", **COARSE)
            again = taxel.Recording.read(pathlib.Path(folder) / "run")
            np.testing.assert_array_equal(again.sensors[0].readings, run.sensors[0].readings)
            np.testing.assert_array_equal(again.sensors[0].elastic_force, run.sensors[0].elastic_force)
            self.assertTrue((pathlib.Path(folder) / "run" / "scene.xml").exists())

    def test_layout_of_a_run_names_a_mesh_that_is_there(self):
        mesh = pathlib.Path(taxel.Layout.read(taxel.FINGERTIP).mesh_file)
        own = taxel.Layout.read(taxel.FINGERTIP)
        for layout in (None, taxel.FINGERTIP, own):
            found = taxel.sweep(layout, **COARSE).sensors[0].layout
            self.assertTrue(pathlib.Path(found.mesh_file).samefile(mesh))
            self.assertFalse([problem for problem in found.check() if problem.severity == "error"])
        with tempfile.TemporaryDirectory() as folder:
            taxel.sweep(out=pathlib.Path(folder) / "run", **COARSE)
            (pathlib.Path(folder) / "run").rename(pathlib.Path(folder) / "moved")
            found = taxel.Recording.read(pathlib.Path(folder) / "moved").sensors[0].layout
            self.assertEqual(pathlib.Path(found.mesh_file), pathlib.Path(folder) / "moved" / "finger.obj")
            self.assertEqual(pathlib.Path(found.mesh_file).read_bytes(), mesh.read_bytes())
            self.assertFalse([problem for problem in found.check() if problem.severity == "error"])

    def test_recorded_numbers_beyond_every_simulation_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            taxel.sweep(out=folder, **COARSE)
            file = pathlib.Path(folder) / "readings.npz"
            whole = dict(np.load(file))
            for name, limit in (("force", "1e+30"), ("readings", "1e+30"), ("sensor_pos", "1e+10"), ("mocap_pos", "1e+10")):
                broken = whole[name].copy()
                broken.flat[4] = -1e300
                np.savez(file, **{**whole, name: broken})
                with self.subTest(name=name), self.assertRaises(taxel.Error) as caught:
                    taxel.Recording.read(folder)
                self.assertEqual(caught.exception.pointer, name)
                self.assertIn(f"value 4 must be at most {limit}, is -1e+300", caught.exception.message)

    def test_bad_options_and_files_raise_errors(self):
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.set_value("/mesh/file", "absent.obj")
        cases = [("", "--depth", lambda: taxel.sweep(depth=-1)), ("", "", lambda: taxel.sweep(dpeth=1)),
                 ("absent.json", "", lambda: taxel.sweep("absent.json"))]
        for file, pointer, call in cases:
            with self.subTest(file=file, pointer=pointer), self.assertRaises(taxel.Error) as caught:
                call()
            self.assertEqual((caught.exception.file, caught.exception.pointer), (file, pointer))
        with self.assertRaisesRegex(taxel.Error, "absent.obj"):
            taxel.sweep(layout)


class PlayTest(unittest.TestCase):
    def test_scenarios_are_dicts_or_files(self):
        press = {"kind": "press", "depth": 0.001}
        messages = io.StringIO()
        with contextlib.redirect_stderr(messages):
            run = taxel.play(press, taxel.FINGERTIP, density=1e6)
        self.assertGreater(run.sensors[0].readings.max(), 0)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "press.json"
            file.write_text(json.dumps({"format": "taxel-scenario", "version": 1, "scenario": press}))
            again = taxel.play(file, taxel.FINGERTIP, density=1e6)
        np.testing.assert_array_equal(again.sensors[0].readings, run.sensors[0].readings)

    def test_broken_scenarios_raise_errors_with_json_pointers(self):
        with self.assertRaises(taxel.Error) as caught:
            taxel.play({"kind": "press", "depht": 0.001})
        self.assertEqual(caught.exception.pointer, "/depht")
        with self.assertRaises(taxel.Error) as caught:
            taxel.play("absent.json")
        self.assertEqual(caught.exception.file, "absent.json")


class PackageTest(unittest.TestCase):
    def run_python(self, text):
        result = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def test_import_loads_neither_numpy_nor_the_module(self):
        text = "import sys, taxel; print([m for m in ('numpy', 'taxel._core', 'mujoco') if m in sys.modules])"
        self.assertEqual(self.run_python(text).strip(), "[]")

    def test_module_may_be_imported_again(self):
        text = ("import sys, taxel; a = taxel.Layout.read(taxel.FINGERTIP)\n"
                "for name in [m for m in sys.modules if m.startswith('taxel') and m != 'taxel._core']:\n"
                "    del sys.modules[name]\n"
                "import taxel as again; print(again.Layout.read(again.FINGERTIP) == a, again is taxel)")
        self.assertEqual(self.run_python(text).strip(), "True False")

    def test_program_runs_by_its_entry_point(self):
        text = "import sys; sys.argv = ['taxel', '--version']; from taxel.programs import taxel; taxel()"
        self.assertIn("MuJoCo", self.run_python(text))

    def test_every_public_name_has_a_docstring(self):
        for name in taxel.__all__:
            self.assertTrue(getattr(taxel, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
