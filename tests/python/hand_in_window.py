"""Plays a new user's way through the window with the Shadow hand of MuJoCo Menagerie, and runs the files that it saves.

hand_in_window.jsonl has the inputs: a layout on the tip of the index finger, twelve taxels by a pattern, a hand that
closes, an edit meanwhile, the layout on all fingers, saved. Its pictures and states are in the folder `film` next to the
working folder, and film.mp4 if there is ffmpeg.
"""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import mujoco
import mujoco.rollout
import numpy as np

import taxel

HERE = pathlib.Path(__file__).resolve().parent
HAND = HERE.parents[2] / "shared" / "real" / "hands" / "shadow_hand"
SCRIPT = HERE / "hand_in_window.jsonl"
PROGRAMS = pathlib.Path(taxel.__file__).parent / "bin"
FILM = pathlib.Path.cwd().parent / "film"
EDITED = 10  # row of the taxel whose radius is edited
GEOMS = ["rh_ffdistal", "rh_mfdistal", "rh_rfdistal", "rh_lfdistal"]
IS_OUR_MUJOCO = mujoco.mj_versionString() == taxel.plugin_versions()[0]


def state(name):
    return json.loads((FILM / f"{name}.json").read_text())


def readings(name):
    """Returns the readings of all sensors in a state of the window."""
    return np.concatenate([sensor["readings"] for sensor in state(name)["simulation"]["sensors"]])


def play(scene):
    """Plays the script in the window, whose files are written into FILM."""
    shutil.rmtree(FILM, ignore_errors=True)
    FILM.mkdir(parents=True)
    command = [PROGRAMS / "taxelstudio", "--headless", "--draw-saved", "--size", "1600x1200",
               "--state-dir", scene.parents[1] / "state", "--script", SCRIPT, scene]
    subprocess.run(command, cwd=FILM, check=True)
    if shutil.which("ffmpeg"):
        subprocess.run(["ffmpeg", "-loglevel", "error", "-framerate", "10", "-i", "%03d.png", "-pix_fmt", "yuv420p", "film.mp4"],
                       cwd=FILM, check=True)


@unittest.skipUnless(HAND.exists(), f"{HAND} is absent")
class HandInWindowTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        hand = pathlib.Path(cls.folder.name).resolve() / "hand"
        shutil.copytree(HAND, hand, copy_function=shutil.copyfile)
        hand.chmod(0o755)
        play(hand / "scene_right.xml")
        cls.saved = hand / "scene_right_taxels.xml"
        cls.steps = state("closed")["simulation"]["step"]
        cls.expected = readings("closed")
        cls.controls = {one["name"]: one["value"] for one in state("closed")["scene"]["actuators"]}
        os.chdir(hand)  # MuJoCo before 3.17 does not say where its files are
        mujoco.set_mju_user_warning(lambda text: None)  # of the meshes of the hand that need a repair
        cls.addClassCleanup(mujoco.set_mju_user_warning, None)

    def model(self):
        model = taxel.load_model(self.saved)
        self.assertEqual([model.actuator(i).name for i in range(model.nu)], list(self.controls))
        return model

    def compare(self, rows):
        """Compares the readings in each step with those of the window in its last step."""
        self.assertEqual(rows.shape, (self.steps, 12 * len(GEOMS)))
        if IS_OUR_MUJOCO:
            np.testing.assert_array_equal(rows[-1], self.expected)
        else:  # other versions turn the frames of meshes, so that the last digits of all poses differ
            np.testing.assert_allclose(rows[-1], self.expected, rtol=0, atol=1e-4 * self.expected.max())

    def test_takes_25_inputs_with_the_opening_of_the_file(self):
        lines = [json.loads(line) for line in SCRIPT.read_text().splitlines()]
        of_a_drag = ("mouse_move", "mouse_up")  # a drag is one input
        self.assertLessEqual(1 + sum(line.get("event", "mouse_move") not in of_a_drag for line in lines), 25)

    def test_window_makes_twelve_taxels_on_the_tip_and_attaches_them_to_all_fingers(self):
        self.assertEqual(state("chosen")["scene"]["body"], "rh_ffdistal")
        self.assertEqual(len(state("made")["document"]["layout"]["taxels"]), 12)
        self.assertEqual(state("attached")["scene_layout"]["geoms"], GEOMS)
        attached = {one["name"]: one["value"] for one in state("attached")["scene"]["actuators"]}
        self.assertEqual(attached, self.controls, "the hand stays closed")
        self.assertEqual(sum(value != 0 for value in attached.values()), 5)
        self.assertEqual([one for one in state("closed")["messages"] if one["severity"] == "error"], [])
        self.assertFalse(state("closed")["history"]["dirty"])

    def test_edit_while_the_hand_closes_reaches_the_bar_of_the_next_step(self):
        before = readings("before")
        self.assertTrue(state("before")["simulation"]["playing"])
        self.assertGreater(before[EDITED], 1000)
        changes = []
        for name in ("edited_1", "edited_2", "edited_3"):
            after = state(name)
            self.assertTrue(after["simulation"]["playing"], "the run goes on")
            self.assertGreaterEqual(after["simulation"]["step"], state("before")["simulation"]["step"])
            np.testing.assert_array_equal([bar["value"] for bar in after["bars"]], readings(name))
            changes.append(abs(readings(name) - before) / before.max())
        self.assertGreater(max(change[EDITED] for change in changes), 0.1)
        self.assertLess(max(np.delete(change, EDITED).max() for change in changes), 0.08, "the others go on as before")

    def test_saved_files_run_in_taxel_run(self):
        table = ",".join(["time", *self.controls]) + "\n0," + ",".join(map(repr, self.controls.values())) + "\n"
        pathlib.Path("controls.csv").write_text(table)
        seconds = (self.steps + 0.1) * state("closed")["scene"]["timestep"]
        subprocess.run([PROGRAMS / "taxel", "run", self.saved, "--ctrl", "controls.csv", "--seconds", repr(seconds), "--quiet",
                        "--out", "run"], check=True, stdout=subprocess.DEVNULL)
        recorded = np.load("run/readings.npz")
        rows = np.concatenate([recorded[f"{geom}/readings"].reshape(self.steps, 12) for geom in GEOMS], axis=1)
        np.testing.assert_array_equal(rows[-1], self.expected)

    def test_saved_files_run_in_plain_mujoco(self):
        model = self.model()
        data = mujoco.MjData(model)
        data.ctrl[:] = list(self.controls.values())
        rows = []
        for _ in range(self.steps):
            mujoco.mj_step(model, data)
            rows.append(np.concatenate([sensor.values for sensor in taxel.readings(model, data).values()]))
        self.compare(np.array(rows))

    def test_saved_files_run_in_rollout(self):
        model = self.model()
        data = [mujoco.MjData(model) for _ in range(2)]
        start = np.zeros(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
        mujoco.mj_getState(model, data[0], start, mujoco.mjtState.mjSTATE_FULLPHYSICS)
        controls = np.tile(list(self.controls.values()), (2, self.steps, 1))
        _, rows = mujoco.rollout.rollout(model, data, np.tile(start, (2, 1)), controls)
        for run in np.asarray(rows):
            self.compare(run)


if __name__ == "__main__":
    unittest.main()
