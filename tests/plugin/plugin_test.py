#!/usr/bin/env python3
"""Tests the module in Python: plugin_test.py libtaxel_plugin.so FOLDER... (folders written by `taxel sweep`).

The first, quick to load, serves the quick tests; the others are replayed.
"""
import concurrent.futures
import copy
import pickle
import pathlib
import sys
import threading
import unittest

import mujoco
import numpy as np

import replay

PLUGIN, FOLDERS = sys.argv[1], [pathlib.Path(folder) for folder in sys.argv[2:]]


def over_the_box(model):
    """Returns a state in contact: the finger and its mocap body are moved by 13 mm."""
    data = mujoco.MjData(model)
    data.mocap_pos[0, 0] += 0.013
    data.qpos[0] += 0.013
    return data


def run(model, data, steps):
    rows = []
    for _ in range(steps):
        data.mocap_pos[0, 0] += 1e-5
        mujoco.mj_step(model, data)
        rows.append(data.sensordata.copy())
    return np.array(rows)


class PluginTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = FOLDERS[0] / "scene.xml"
        cls.model = mujoco.MjModel.from_xml_path(str(cls.scene))

    def test_repeats_recorded_sweeps_to_the_last_digit(self):
        self.assertGreaterEqual(len(FOLDERS), 2)
        with concurrent.futures.ThreadPoolExecutor() as pool:  # MuJoCo releases Python's lock during a step
            replays = list(pool.map(replay.replay, FOLDERS[1:]))
        for folder, (recorded, replayed) in zip(FOLDERS[1:], replays):
            with self.subTest(folder=folder.name):
                self.assertEqual(len(recorded), {"box": 241, "paper": 1001}.get(folder.name, 501))
                self.assertGreater(recorded.max(), 1000)
                np.testing.assert_array_equal(replayed, recorded)

    def test_copies_continue_like_the_original(self):
        data = over_the_box(self.model)
        self.assertGreater(run(self.model, data, 20).max(), 0)
        twin = copy.copy(data)
        np.testing.assert_array_equal(run(self.model, data, 20), run(self.model, twin, 20))
        del data
        run(self.model, twin, 5)

    def test_pickled_data_works_together_with_the_original(self):
        data = over_the_box(self.model)
        run(self.model, data, 20)
        text = pickle.dumps(data)
        other = pickle.loads(text)
        readings = run(self.model, other, 5)
        self.assertGreater(readings.max(), 0)
        np.testing.assert_array_equal(run(self.model, data, 5), readings)
        del data
        run(self.model, other, 5)
        del other

    def test_runs_in_several_threads_at_once(self):
        expected = run(self.model, over_the_box(self.model), 30)
        results = [None] * 3

        def work(i):
            results[i] = run(self.model, over_the_box(self.model), 30)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result in results:
            np.testing.assert_array_equal(result, expected)

    def test_mistakes_raise_python_errors_that_name_them(self):
        text = self.scene.read_text()
        cases = [('value="finger.taxels.json"', 'value="absent.taxels.json"', "absent.taxels.json"),
                 ('key="geom" value="finger"', 'key="geom" value="thumb"', '"thumb"'),
                 ('key="others"', 'key="other"', "other")]
        for before, after, word in cases:
            with self.subTest(word=word):
                self.assertIn(before, text)
                wrong = self.scene.with_name("wrong.xml")
                wrong.write_text(text.replace(before, after))
                with self.assertRaises(ValueError) as caught:
                    mujoco.MjModel.from_xml_path(str(wrong))
                wrong.unlink()
                self.assertIn(word, str(caught.exception))

    def test_computes_energy_and_derivatives_on_request(self):
        data = over_the_box(self.model)
        run(self.model, data, 50)
        nv = self.model.nv
        a = np.zeros((2 * nv, 2 * nv))
        before = data.sensordata.copy()
        mujoco.mjd_transitionFD(self.model, data, 1e-6, False, a, None, None, None)
        self.assertTrue(np.isfinite(a).all())
        np.testing.assert_array_equal(data.sensordata, before)


BALLS = """
<mujoco>
  <option timestep="0.001"/>
  <extension>
    <plugin plugin="taxel.contact">
      <instance name="soft">
        <config key="materials" value='{"a": {"modulus": 1e5, "dissipation": 3}, "b": {"modulus": 2e5}}'/>
        <config key="pairs" value="a floor, a b"/>
      </instance>
    </plugin>
  </extension>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1"/>
    <body pos="0 0 0.0198">
      <freejoint/><geom name="a" type="sphere" size="0.02" mass="0.05" contype="0" conaffinity="0"/>
    </body>
    <body pos="0 0 0.0596">
      <freejoint/><geom name="b" type="sphere" size="0.02" mass="0.05" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
  <sensor><plugin plugin="taxel.contact" instance="soft"/></sensor>
</mujoco>
"""


class ContactPluginTest(unittest.TestCase):
    """Tests soft geoms without taxels: two balls, one on the other, on a rigid floor."""

    def setUp(self):
        self.model = mujoco.MjModel.from_xml_string(BALLS)
        self.data = mujoco.MjData(self.model)

    def step(self, data):
        mujoco.mj_step(self.model, data)
        return data.sensordata.reshape(2, 6).copy()  # force and torque of each ball

    def test_recorded_forces_move_the_balls(self):
        mass, gravity, timestep = 0.05, 9.81, 0.001
        largest = 0
        for _ in range(100):
            before = self.data.qvel[[2, 8]].copy()
            force = self.step(self.data)[:, 2]
            change = mass * (self.data.qvel[[2, 8]] - before)
            np.testing.assert_allclose(change, timestep * (force - mass * gravity), rtol=0, atol=1e-9)
            largest = max(largest, force[1])
        self.assertGreater(largest, mass * gravity)  # the upper ball is carried

    def test_copies_continue_like_the_original(self):
        for _ in range(20):
            self.step(self.data)
        twin = copy.copy(self.data)
        other = pickle.loads(pickle.dumps(self.data))
        for _ in range(20):
            expected = self.step(self.data)
            self.assertGreater(abs(expected).max(), 0)
            np.testing.assert_array_equal(self.step(twin), expected)
            np.testing.assert_array_equal(self.step(other), expected)

    def test_mistakes_raise_python_errors_that_name_them(self):
        cases = [('"modulus": 1e5', '"modulus": "soft"', "modulus"), ("a floor, a b", "a floor, a c", '"c"'),
                 ('key="pairs"', 'key="pair"', "pair"), ('{"a": {', '{"c": {', '"c"')]
        for before, after, word in cases:
            with self.subTest(word=word):
                self.assertIn(before, BALLS)
                with self.assertRaises(ValueError) as caught:
                    mujoco.MjModel.from_xml_string(BALLS.replace(before, after))
                self.assertIn(word, str(caught.exception))


if __name__ == "__main__":
    mujoco.mj_loadPluginLibrary(PLUGIN)
    unittest.main(argv=sys.argv[:1], verbosity=1)
