#!/usr/bin/env python3
"""Tests scenes of `taxel attach` in this MuJoCo: patched.py LIBRARY TAXEL RECORDED

Each scene of tests/fixtures/scenes_to_patch is patched, loaded by MuJoCo itself and compared with the run of the program
TAXEL, which has MuJoCo RECORDED.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import mujoco
import numpy as np

from stepping import sensor_rows

PLUGIN, TAXEL, RECORDED = sys.argv[1:4]
ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "tests" / "fixtures" / "scenes_to_patch"
STEPS = 20


def prepared(folder):
    """Copies the scenes, the fingertip and a quick layout of it."""
    shutil.copytree(SCENES, folder, dirs_exist_ok=True)
    (folder / "meshes").mkdir()
    for place in (folder, folder / "meshes"):
        shutil.copy(ROOT / "assets" / "meshes" / "fingertip.obj", place)
    layout = json.loads((ROOT / "assets" / "layouts" / "fingertip.taxels.json").read_text())
    layout["mesh"]["file"] = "fingertip.obj"
    layout["sampling"]["density"] = 2e5
    (folder / "tip.taxels.json").write_text(json.dumps(layout))


class PatchedTest(unittest.TestCase):
    def test_saved_scenes_load_and_read_as_the_program(self):
        rows = [line.split() for line in (SCENES / "scenes.txt").read_text().splitlines() if not line.startswith("#")]
        self.assertGreaterEqual(len(rows), 10)
        self.addCleanup(os.chdir, os.getcwd())
        for number, (file, *places) in enumerate(rows):
            out = ("saved.xml", "elsewhere/saved.xml")[number % 2]
            with self.subTest(scene=file, out=out), tempfile.TemporaryDirectory() as name:
                self.compare(pathlib.Path(name), file, out, places)

    def compare(self, folder, file, out, places):
        prepared(folder)
        subprocess.run([TAXEL, "attach", file, "--layout", "tip.taxels.json", *places, "--quiet", "--out", out],
                       cwd=folder, check=True, stdout=subprocess.DEVNULL)
        os.chdir((folder / out).parent)  # MuJoCo before 3.17 does not say where its files are
        model = mujoco.MjModel.from_xml_path("saved.xml")
        seconds = repr((STEPS + 0.1) * model.opt.timestep)
        subprocess.run([TAXEL, "run", "saved.xml", "--quiet", "--seconds", seconds, "--out", "run"], check=True,
                       stdout=subprocess.DEVNULL)
        recorded = np.load("run/readings.npz")
        expected = np.concatenate([recorded[key].reshape(STEPS, -1) for key in sorted(recorded.files)
                                   if key == "readings" or key.endswith("/readings")], axis=1)
        addresses = [range(model.sensor_adr[i], model.sensor_adr[i] + model.sensor_dim[i])
                     for i in range(model.nsensor) if model.sensor_type[i] == mujoco.mjtSensor.mjSENS_PLUGIN]
        found = sensor_rows(model, mujoco.MjData(model), STEPS)[:, [i for one in addresses for i in one]]
        self.assertEqual(found.shape, expected.shape)
        self.assertGreater(expected.max(), 0)
        if mujoco.__version__ == RECORDED:
            np.testing.assert_array_equal(np.sort(found, axis=1), np.sort(expected, axis=1))
        else:  # after the first touch, versions differ in their integrators
            rows = slice(0, 1 + int(np.argmax(expected.any(axis=1))))
            np.testing.assert_allclose(np.sort(found[rows], axis=1), np.sort(expected[rows], axis=1), rtol=0,
                                       atol=1e-4 * expected[rows].max())


if __name__ == "__main__":
    mujoco.mj_loadPluginLibrary(PLUGIN)
    unittest.main(argv=sys.argv[:1])
