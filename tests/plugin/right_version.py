#!/usr/bin/env python3
"""Tests the plugin that is built for this MuJoCo: right_version.py LIBRARY FOLDER VERSION

FOLDER was written by `taxel sweep`, with MuJoCo VERSION.
"""
import copy
import os
import pathlib
import pickle
import sys
import unittest

import mujoco
import mujoco.rollout
import numpy as np

import drawing
import replay
from loaded import loaded_mujocos

PLUGIN, FOLDER, RECORDED = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]


class RightVersionTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        os.chdir(FOLDER)  # before 3.17 a model does not say from which folder its meshes are
        cls.recorded = np.load("readings.npz")
        cls.model = mujoco.MjModel.from_xml_path("scene.xml")
        cls.largest = cls.recorded["readings"].max()

    def test_reads_the_recorded_poses_within_1e_12(self):
        data = mujoco.MjData(self.model)
        readings = []
        for pos, quat in zip(self.recorded["sensor_pos"], self.recorded["sensor_quat"]):
            data.qpos[:] = np.concatenate([pos, quat])
            mujoco.mj_forward(self.model, data)
            readings.append(data.sensordata.copy())
        self.assertGreater(self.largest, 1000)
        np.testing.assert_allclose(np.array(readings), self.recorded["readings"], rtol=0, atol=1e-12 * self.largest)

    def test_replays_the_sweep(self):
        recorded, replayed = replay.replay(".")
        if mujoco.__version__ == RECORDED:
            np.testing.assert_array_equal(replayed, recorded)
        else:  # other last digits can cost or save an iteration of friction (docs/plugin.md)
            np.testing.assert_allclose(replayed, recorded, rtol=0, atol=1e-8 * self.largest)

    def test_draws_the_contact_surface_and_its_force_in_any_viewer(self):
        data = mujoco.MjData(self.model)
        row = int(np.argmax(self.recorded["readings"].sum(axis=1)))
        data.qpos[:] = np.concatenate([self.recorded["sensor_pos"][row], self.recorded["sensor_quat"][row]])
        mujoco.mj_forward(self.model, data)
        shown = [drawing.contact_geoms(self.model, one) for one in (data, copy.copy(data), pickle.loads(pickle.dumps(data)))]
        triangles, arrows = shown[0]
        self.assertGreater(len(triangles), 50)
        self.assertEqual(len(arrows), 1)
        for geoms in shown[1:]:
            np.testing.assert_array_equal(geoms[0], triangles)
        self.assertEqual(drawing.contact_geoms(self.model, data, flags=()), ([], []))

    def test_rollout_with_two_threads_gives_the_bytes_of_a_loop(self):
        rows, steps = 6, 40
        spec = mujoco.mjtState.mjSTATE_MOCAP_POS
        full = mujoco.mjtState.mjSTATE_FULLPHYSICS
        states, moves = [], np.zeros((rows, steps, 3))
        for row in range(rows):
            data = mujoco.MjData(self.model)
            data.mocap_pos[0, 0] += 0.012 + 0.0005 * row  # over the box
            data.qpos[0] += 0.012 + 0.0005 * row
            moves[row] = data.mocap_pos[0] + np.outer(np.arange(steps), [1e-5, 0, 0])
            state = np.zeros(mujoco.mj_stateSize(self.model, full))
            mujoco.mj_getState(self.model, data, state, full)
            states.append(state)
        expected = []
        for state, move in zip(states, moves):
            data = mujoco.MjData(self.model)
            mujoco.mj_setState(self.model, data, state, full)
            values = []
            for position in move:
                data.mocap_pos[0] = position
                mujoco.mj_step(self.model, data)
                values.append(data.sensordata.copy())
            expected.append(values)
        expected = np.array(expected)
        two = [mujoco.MjData(self.model) for _ in range(2)]
        _, sensed = mujoco.rollout.rollout(self.model, two, np.array(states), moves, control_spec=int(spec))
        self.assertGreater(expected.max(), 1000)
        self.assertEqual(sensed.tobytes(), expected.tobytes())

    def test_the_process_has_one_mujoco(self):
        self.assertEqual(len(loaded_mujocos()), 1)


if __name__ == "__main__":
    mujoco.mj_loadPluginLibrary(PLUGIN)
    unittest.main(argv=sys.argv[:1], verbosity=1)
