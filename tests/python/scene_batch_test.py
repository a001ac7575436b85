"""Tests batches of scenes from Python: rows by the names of sensors and bodies, data sets, and policies."""
import importlib.util
import json
import pathlib
import tempfile
import unittest

import numpy as np

import taxel
import taxel.data_set
from taxel.batch_folder import BatchFolder

SCENE = taxel.EXAMPLES / "scenes" / "press.xml"
TABLE = {"time": [0, 0.1], "actuator 0": [0, -0.02]}


def jobs_of(**keys):
    """Returns three presses of a fingertip on a box at random places."""
    scene = {"file": SCENE, "seconds": 0.2, **keys}
    return [{"scene": scene, "set": {"/scene/moves/box/x": {"uniform": [-0.004, 0.004]}}, "repeat": 3}]


class SceneBatchTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_batch(self, jobs, name="out", **options):
        return taxel.batch(jobs, self.folder / name, data_set=False, **options)

    def test_rows_have_the_names_of_sensors_and_bodies(self):
        result = self.run_batch(jobs_of(controls=TABLE))
        self.assertEqual((result.episodes, result.frames, result.failed), (3, 63, ()))
        batch = BatchFolder(result.folder)
        self.assertTrue(batch.of_scenes)
        (scene,) = batch.scenes
        self.assertEqual(list(scene.sensors), ["fingertip"])
        self.assertEqual((scene.state, scene.state_unit, scene.action), (["slide"], "m", ["actuator 0"]))
        episodes = list(batch.episodes())
        places = set()
        for episode in episodes:
            rows = batch.read_rows(episode)
            self.assertEqual(rows["observation.tactile.fingertip"].shape, (21, 12))
            self.assertGreater(rows["observation.tactile.fingertip"].max(), 100)
            self.assertEqual(episode.peak_sensor, "fingertip")
            self.assertAlmostEqual(episode.peak, rows["observation.tactile.fingertip"].max(), delta=1e-3 * episode.peak)
            x = json.loads(episode.changes)["/scene/moves/box/x"]
            self.assertAlmostEqual(rows["observation.pose.box"][0, 0], x, places=8)
            places.add(x)
        self.assertEqual(len(places), 3)

    @unittest.skipUnless(importlib.util.find_spec("pyarrow"), "needs pyarrow")
    def test_data_set_has_a_column_for_each_sensor(self):
        import pyarrow.parquet as pq

        result = taxel.batch(jobs_of(controls=TABLE), self.folder / "out")
        info = json.loads((result.folder / "meta/info.json").read_text())
        self.assertEqual(info["fps"], 100)
        feature = info["features"]["observation.tactile.fingertip"]
        self.assertEqual((feature["shape"], feature["unit"]), ([12], "Pa"))
        self.assertEqual(feature["names"], taxel.Layout.read(taxel.FINGERTIP).names)
        self.assertEqual(info["features"]["action"]["names"], ["actuator 0"])
        self.assertEqual(info["features"]["observation.pose.box"]["names"], ["x", "y", "z", "qw", "qx", "qy", "qz"])
        rows = pq.read_table(result.folder / "data").to_pylist()
        batch = BatchFolder(result.folder)
        for episode in batch.episodes():
            expected = batch.read_rows(episode)
            own = [row for row in rows if row["episode_index"] == episode.episode]
            for name, values in expected.items():
                self.assertTrue((np.array([row[name] for row in own]) == values).all(), name)
        episodes = pq.read_table(result.folder / "meta/episodes").to_pylist()
        self.assertEqual(json.loads(episodes[0]["taxel/scene"])["controls"], TABLE)
        scenes = pq.read_table(result.folder / "meta/scenes.parquet").to_pylist()
        self.assertEqual(scenes[0]["sensors"], ["fingertip"])
        taxel.batch(jobs_of(controls=TABLE), self.folder / "out")  # complete: nothing is written again

    def test_policy_acts_on_each_row_and_gives_the_same_bytes_again(self):
        seen = []

        def policy(observation):
            seen.append(observation)
            return [-0.004 - 1e-7 * observation.row["observation.tactile.fingertip"].max()]

        first = self.run_batch(jobs_of(policy="by feeling"), policy=policy, workers=2)
        self.assertEqual(first.failed, ())
        self.assertEqual(sum(one.is_first for one in seen), 3)
        self.assertEqual({one.policy for one in seen}, {"by feeling"})
        batch = BatchFolder(first.folder)
        for episode in batch.episodes():
            rows, own = batch.read_rows(episode), [one for one in seen if one.job == episode.job]
            self.assertEqual(len(own), episode.rows)
            observed = np.array([one.row["observation.tactile.fingertip"] for one in own]).astype(np.float32)
            self.assertEqual(observed.tobytes(), rows["observation.tactile.fingertip"].tobytes())
            expected = [-0.004 - 1e-7 * one.row["observation.tactile.fingertip"].max() for one in own]
            self.assertEqual(rows["action"].ravel().tolist(), np.array(expected, np.float32).tolist())
            self.assertGreater(len(set(expected)), 5)
        second = self.run_batch(jobs_of(policy="by feeling"), "again", policy=policy, workers=1)
        for file in sorted(first.folder.rglob("*")):
            if file.is_file() and ".batch" not in file.parts:
                self.assertEqual(file.read_bytes(), (second.folder / file.relative_to(first.folder)).read_bytes(), file)

    def test_batch_that_a_policy_has_left_continues(self):
        calls = []

        def policy(observation):
            calls.append(observation.job)
            if len(set(calls)) == 3:
                raise RuntimeError("enough")
            return [0.01]

        with self.assertRaisesRegex(RuntimeError, "enough"):
            self.run_batch(jobs_of(policy="p"), policy=policy, workers=1, group=1)
        result = self.run_batch(jobs_of(policy="p"), policy=lambda observation: [0.01], workers=1, group=1)
        self.assertEqual((result.episodes, result.resumed), (3, 2))

    def test_bad_input_is_named(self):
        with self.assertRaisesRegex(taxel.Error, '/scene/policy: "p" is a function of Python'):
            self.run_batch(jobs_of(policy="p"))
        with self.assertRaisesRegex(taxel.Error, "policy: must be a function"):
            self.run_batch(jobs_of(policy="p"), policy="p")
        with self.assertRaisesRegex(taxel.Error, "--fps: is for scenarios"):
            self.run_batch(jobs_of(controls=TABLE), fps=50)
        with self.assertRaisesRegex(taxel.Error, "/scene/keyframe: has no keyframe"):
            self.run_batch(jobs_of(controls=TABLE, keyframe="open"))
        result = self.run_batch(jobs_of(policy="p"), policy=lambda observation: [0, 1])
        self.assertEqual({job.error for job in result.failed}, {"the policy gave 2 numbers, and the scene has 1 actuators"})
        with self.assertRaisesRegex(taxel.Error, "only episodes of scenarios are played again"):
            self.run_batch(jobs_of(controls=TABLE), "done")
            taxel.data_set.write_run(self.folder / "done", 0, self.folder / "run")


if __name__ == "__main__":
    unittest.main()
