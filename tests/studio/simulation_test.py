"""Tests that the companion simulates as a plain loop does, without a window."""
import contextlib
import time
import unittest

import mujoco
import numpy as np
from mujoco.studio import app, launch_thread, messages, sim, sim_history, viewer_handle

import taxel
from taxel.studio.messages import ReadingsEvent, SceneEvent
from taxel.studio.scene import load_scene
from taxel.studio.sim_plugin import TactileSim
from taxel.studio.simulation import Simulation, shared_state

PRESS = taxel.EXAMPLES / "scenes" / "press.xml"
HAND = taxel.EXAMPLES / "scenes" / "hand_grasps_ball.xml"


def plain_loop(scene, steps):
    """Returns the sensordata of all steps of MuJoCo alone."""
    data = mujoco.MjData(scene.full)
    rows = []
    for _ in range(steps):
        mujoco.mj_step(scene.full, data)
        rows.append(data.sensordata.copy())
    return np.array(rows)


def step(simulation):
    simulation.pull()
    mujoco.mj_step(simulation.scene.full, simulation.full_data)
    simulation.push()
    return simulation.full_data.sensordata.copy()


@contextlib.contextmanager
def running(scene):
    """Yields Studio's handle, with the companion and Studio's own plugins, and the other end of its channels."""
    viewer, simulation = launch_thread.make_thread_endpoints()
    plugins = [TactileSim(scene), *app.SIM_PLUGINS]
    handle = viewer_handle.ViewerHandle(simulation, sim_plugins=plugins)
    handle.dispatch(messages.LoadModelEvent(path=scene.path))
    yield handle, viewer
    handle.close()


def run_until(handle, viewer, enough):
    """Syncs until enough(rows) is true, and returns rows of time and sensordata."""
    rows = []
    end = time.monotonic() + 60
    while not enough(rows):
        handle.sync()
        rows += [(event.time, event.sensordata) for event in viewer.get_sim_events() if isinstance(event, ReadingsEvent)]
        if time.monotonic() > end:
            raise AssertionError(f"after a minute there are {len(rows)} rows")
    return rows


class SimulationTest(unittest.TestCase):
    def test_readings_are_those_of_a_plain_loop_to_the_last_bit(self):
        for file in (PRESS, HAND):
            scene = load_scene(file)
            simulation = Simulation(scene)
            rows = np.array([step(simulation) for _ in range(400)])
            self.assertGreater(rows.max(), 1000)
            self.assertEqual(rows.tobytes(), plain_loop(scene, 400).tobytes())

    def test_viewer_data_follow_the_full_data(self):
        simulation = Simulation(load_scene(PRESS))
        for _ in range(50):
            step(simulation)
        full, plain = simulation.full_data, simulation.plain_data
        for field in ("time", "qpos", "qvel", "act", "ctrl", "qacc_warmstart"):
            np.testing.assert_array_equal(getattr(plain, field), getattr(full, field))
        mujoco.mj_kinematics(simulation.scene.full, full)
        np.testing.assert_array_equal(plain.xpos, full.xpos)

    def test_changes_in_the_viewer_reach_the_full_data(self):
        simulation = Simulation(load_scene(PRESS))
        for _ in range(200):
            step(simulation)
        self.assertFalse(simulation.pull())
        simulation.plain_data.ctrl[0] = -0.01
        simulation.plain_data.xfrc_applied[1, 2] = 0.5
        simulation.plain_data.qpos[2] += 1e-3
        simulation.scene.plain.opt.gravity[2] = -5
        self.assertTrue(simulation.pull())
        full = simulation.full_data
        self.assertEqual((full.ctrl[0], full.xfrc_applied[1, 2], simulation.scene.full.opt.gravity[2]), (-0.01, 0.5, -5))
        self.assertEqual(full.qpos[2], simulation.plain_data.qpos[2])
        np.testing.assert_array_equal(full.qacc_warmstart, simulation.plain_data.qacc_warmstart)
        expected = mujoco.MjData(simulation.scene.full)
        mujoco.mj_setState(simulation.scene.full, expected, *self.whole_state(simulation))
        mujoco.mj_forward(simulation.scene.full, expected)
        np.testing.assert_array_equal(full.sensordata, expected.sensordata)  # readings of the changed state

    def whole_state(self, simulation):
        mask = int(mujoco.mjtState.mjSTATE_INTEGRATION)
        state = np.empty(mujoco.mj_stateSize(simulation.scene.full, mask))
        mujoco.mj_getState(simulation.scene.full, simulation.full_data, state, mask)
        return state, mask

    def test_going_back_in_time_repeats_the_run(self):
        simulation = Simulation(load_scene(PRESS))
        mask = shared_state(simulation.scene.full, simulation.scene.plain)
        for _ in range(150):
            step(simulation)
        state = np.empty(mujoco.mj_stateSize(simulation.scene.plain, mask))
        mujoco.mj_getState(simulation.scene.plain, simulation.plain_data, state, mask)
        expected = np.array([step(simulation) for _ in range(100)])
        mujoco.mj_setState(simulation.scene.plain, simulation.plain_data, state, mask)
        self.assertEqual(np.array([step(simulation) for _ in range(100)]).tobytes(), expected.tobytes())

    def test_reset_repeats_the_run(self):
        simulation = Simulation(load_scene(PRESS))
        expected = np.array([step(simulation) for _ in range(100)])
        simulation.reset()
        mujoco.mj_resetData(simulation.scene.plain, simulation.plain_data)  # as Studio does
        mujoco.mj_forward(simulation.scene.plain, simulation.plain_data)
        self.assertFalse(simulation.pull())
        self.assertEqual(np.array([step(simulation) for _ in range(100)]).tobytes(), expected.tobytes())


class HandleTest(unittest.TestCase):
    """The companion inside Studio's own loop."""

    def test_viewer_gets_the_model_without_plugins(self):
        scene = load_scene(PRESS)
        with running(scene) as (handle, viewer):
            model, shown = viewer.get_sim_events()
        self.assertIsInstance(model, messages.ModelEvent)
        self.assertEqual((model.model.nplugin, model.path), (0, scene.path))
        self.assertIsInstance(shown, SceneEvent)

    def test_readings_in_studio_are_those_of_a_plain_loop_to_the_last_bit(self):
        for file in (PRESS, HAND):
            scene = load_scene(file)
            with running(scene) as (handle, viewer):
                rows = run_until(handle, viewer, lambda rows: rows and rows[-1][0] > 0.3)
            steps = [round(at / scene.full.opt.timestep) for at, _ in rows]
            expected = plain_loop(scene, steps[-1])
            self.assertGreater(len(rows), 5)
            self.assertGreater(expected.max(), 100)
            for number, (_, row) in zip(steps, rows):
                if number > 0:
                    self.assertEqual(row.tobytes(), expected[number - 1].tobytes())

    def test_pause_history_and_reset_work(self):
        scene = load_scene(PRESS)
        with running(scene) as (handle, viewer):
            rows = run_until(handle, viewer, lambda rows: rows and rows[-1][0] > 0.2)
            handle.dispatch(sim_history.SimHistorySnapshot(index=-20))
            handle.sync()
            back = [event for event in viewer.get_sim_events() if isinstance(event, ReadingsEvent)]
            self.assertLess(back[-1].time, rows[-1][0])  # the readings of the frame to which the user went back
            self.assertEqual(handle.data.time, back[-1].time)
            for _ in range(5):
                handle.sync()
            self.assertEqual(handle.data.time, back[-1].time)  # paused
            handle.dispatch(messages.RequestPauseEvent(pause_state=sim.PauseState.UNPAUSED))
            handle.dispatch(messages.ResetEvent(key=-1))
            again = run_until(handle, viewer, lambda rows: rows and rows[-1][0] > 0.1)
        expected = plain_loop(scene, 1000)
        self.assertLess(again[0][0], 0.1)
        for at, row in again:
            number = round(at / scene.full.opt.timestep)
            if number > 0:
                self.assertEqual(row.tobytes(), expected[number - 1].tobytes())

    def test_scene_that_cannot_be_loaded_leaves_the_present_one(self):
        with running(load_scene(PRESS)) as (handle, viewer):
            before = handle.model
            with self.assertLogs("taxel.studio", "ERROR") as logs:
                handle.dispatch(messages.LoadModelEvent(path="absent.xml"))
            self.assertIn("absent.xml", logs.output[0])
            self.assertIs(handle.model, before)
            handle.dispatch(messages.LoadModelEvent(path=str(HAND)))
            self.assertEqual(handle.model_path, str(HAND))
            handle.dispatch(messages.LoadModelEvent(path=handle.model_path))  # the button Reload
            run_until(handle, viewer, lambda rows: len(rows) > 5)


    def test_window_keeps_its_scene_and_says_why(self):
        scene = load_scene(PRESS)
        viewer, simulation = launch_thread.make_thread_endpoints()
        handle = viewer_handle.ViewerHandle(simulation, sim_plugins=[TactileSim(scene, takes_more_scenes=False)])
        handle.dispatch(messages.LoadModelEvent(path=scene.path))
        self.assertEqual(len(viewer.get_sim_events()), 2)
        with self.assertLogs("taxel.studio", "ERROR") as logs:
            handle.dispatch(messages.LoadModelEvent(path=scene.path))
        self.assertIn("open the scene again", logs.output[0])
        self.assertEqual(viewer.get_sim_events(), [])
        handle.close()


if __name__ == "__main__":
    unittest.main()
