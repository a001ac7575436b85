"""Tests the content of the window as pure functions: history, marks and numbers."""
import dataclasses
import types
import unittest

import mujoco
import numpy as np
from mujoco.studio import messages

import taxel
from taxel.studio import decor
from taxel.studio.history import History
from taxel.studio.marks import Mark, MarkCounts, as_extra_geoms, count_marks, show_in_model
from taxel.studio.messages import ReadingsEvent, SceneEvent
from taxel.studio.panel import curves_to_draw, describe
from taxel.studio.scene import load_scene
from taxel.studio.surface import NO_SURFACE
from taxel.studio.simulation import Simulation
from taxel.studio.view_state import ViewState
from taxel.studio.viewer_plugin import TactileView

PRESS = taxel.EXAMPLES / "scenes" / "press.xml"


class ViewerPluginTest(unittest.TestCase):
    def test_new_model_has_no_marks_before_its_scene_comes(self):
        scene = load_scene(PRESS)
        view = TactileView()
        view.viewer = types.SimpleNamespace(model=scene.plain, data=mujoco.MjData(scene.plain), extra_geoms=[])
        view.on_scene(SceneEvent(scene))
        mujoco.mj_forward(scene.plain, view.viewer.data)
        view.on_update(messages.UpdateEvent())
        self.assertNotEqual(view.viewer.data.geom_xmat[scene.first_mark].tolist(), np.eye(3).flatten().tolist())
        smaller = mujoco.MjModel.from_xml_string("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
        view.viewer.model, view.viewer.data = smaller, mujoco.MjData(smaller)
        view.on_post_model(messages.PostModelEvent(model=smaller, data=view.viewer.data))
        view.on_update(messages.UpdateEvent())
        view.on_readings(ReadingsEvent(0.1, np.zeros(scene.full.nsensordata), NO_SURFACE))

    def test_page_in_the_browser_gets_extra_geoms(self):
        scene = load_scene(PRESS)
        view = TactileView(in_browser=True)
        view.viewer = types.SimpleNamespace(model=scene.plain, data=mujoco.MjData(scene.plain), extra_geoms=[])
        mujoco.mj_forward(scene.plain, view.viewer.data)
        view.on_scene(SceneEvent(scene))
        for _ in range(2):
            view.on_update(messages.UpdateEvent())
            self.assertEqual(len(view.viewer.extra_geoms), 12)  # all taxels, and no force yet
        np.testing.assert_array_equal(view.viewer.data.geom_xmat[scene.first_mark], np.eye(3).flatten())  # not a mark


class HistoryTest(unittest.TestCase):
    def test_keeps_the_newest_rows_in_order(self):
        history = History(3000)
        self.assertEqual(len(history.curves(1.0, 10)[0]), 0)
        for i in range(5000):
            history.append(0.001 * i, np.full(3000, i))
        self.assertEqual(len(history), 1333)
        np.testing.assert_allclose(history.times, 0.001 * np.arange(3667, 5000))
        np.testing.assert_array_equal(history.rows[:, 7], np.arange(3667, 5000))

    def test_forgets_what_came_after_the_time_to_which_the_user_goes_back(self):
        history = History(1)
        for i in range(100):
            history.append(0.01 * i, np.array([i]))
        history.append(0.5, np.array([-1]))
        np.testing.assert_allclose(history.times, [*(0.01 * np.arange(50)), 0.5])
        self.assertEqual(history.rows[-1, 0], -1)

    def test_curves_have_few_points_and_all_peaks(self):
        random = np.random.default_rng(1)
        history = History(2)
        rows = random.random((8000, 2))
        for i, row in enumerate(rows):
            history.append(0.001 * i, row)
        for seconds in (0.01, 0.5, 2.0, 5.0, 100.0):
            times, curves = history.curves(seconds, 100)
            with self.subTest(seconds=seconds):
                self.assertLessEqual(len(times), 101)
                self.assertEqual(len(times), len(curves))
                self.assertTrue(np.all(np.diff(times) > 0))
                wanted = rows[max(0, len(rows) - round(1000 * seconds) - 1) :].astype(np.float32)
                np.testing.assert_array_equal(curves.max(axis=0), wanted.max(axis=0))

    def test_groups_of_a_curve_stay_while_time_goes_on(self):
        history = History(1)
        for i in range(4000):
            history.append(float(i), np.array([i % 37]))
        before = dict(zip(*[array.tolist() for array in history.curves(3000, 100)]))
        history.append(4000.0, np.array([0]))
        after = dict(zip(*[array.tolist() for array in history.curves(3000, 100)]))
        self.assertGreater(len(set(before) & set(after)), 95)


class MarkTest(unittest.TestCase):
    def test_mark_lies_between_its_ends(self):
        start, end = np.array([0.1, 0.2, 0.3]), np.array([0.1, 0.5, -0.1])
        mark = Mark(start, end, 0.01, np.array([1, 0, 0, 1]))
        center, rotation = mark.pose()
        np.testing.assert_allclose(center - mark.half_length * rotation[:, 2], start, atol=1e-12)
        np.testing.assert_allclose(center + mark.half_length * rotation[:, 2], end, atol=1e-12)
        (geom,) = as_extra_geoms([None, mark])
        np.testing.assert_allclose(geom.size, [0.01, 0.01, 0.25], rtol=1e-6)
        np.testing.assert_allclose(geom.pos, center, rtol=1e-6)
        self.assertEqual(geom.type, mujoco.mjtGeom.mjGEOM_CYLINDER)

    def test_colours_go_from_the_first_to_the_last(self):
        np.testing.assert_array_equal(decor.color_of(-1)[:3], decor.COLORS[0])
        np.testing.assert_array_equal(decor.color_of(2)[:3], decor.COLORS[-1])
        np.testing.assert_allclose(decor.color_of(0.125)[:3], 0.5 * (decor.COLORS[0] + decor.COLORS[1]))


class ViewTest(unittest.TestCase):
    """The view of a finger that presses on a box."""

    def setUp(self):
        self.scene = load_scene(PRESS)
        self.simulation = Simulation(self.scene)
        self.state = ViewState(self.scene)

    def press(self, steps=200):
        for _ in range(steps):
            self.simulation.pull()
            mujoco.mj_step(self.scene.full, self.simulation.full_data)
            self.simulation.push()
            full = self.simulation.full_data
            self.state.take(float(full.time), full.sensordata.copy(), NO_SURFACE)

    def test_marks_before_the_first_reading_are_flat_and_have_no_force(self):
        mujoco.mj_forward(self.scene.plain, self.simulation.plain_data)
        marks = self.state.marks(self.simulation.plain_data)
        self.assertEqual(len(marks), self.scene.marks.total)
        self.assertEqual(marks[-2:], [None, None])
        for mark in marks[:-2]:
            self.assertAlmostEqual(2 * mark.half_length, decor.THICKNESS)

    def test_bars_have_the_lengths_and_colours_of_the_readings(self):
        self.press()
        (sensor,) = self.state.sensors
        marks = self.state.marks(self.simulation.plain_data)
        self.assertEqual(len(marks), self.scene.marks.total)
        largest = int(np.argmax(sensor.values))
        fractions = sensor.values / sensor.largest
        self.assertGreater(fractions[largest], 0.5)
        for mark, fraction in zip(marks, fractions):
            self.assertAlmostEqual(2 * mark.half_length, max(fraction * self.state.bar, decor.THICKNESS))
            np.testing.assert_array_equal(mark.color, decor.color_of(fraction))
        self.state.full_scale = 10 * sensor.largest
        smaller = self.state.marks(self.simulation.plain_data)[largest]
        self.assertAlmostEqual(10 * smaller.half_length, marks[largest].half_length)
        self.state.draws_bars = False
        self.assertAlmostEqual(2 * self.state.marks(self.simulation.plain_data)[largest].half_length, decor.THICKNESS)

    def test_bars_stand_on_the_pressed_side(self):
        self.press()
        marks = self.state.marks(self.simulation.plain_data)
        (sensor,) = self.state.sensors
        pressed = marks[int(np.argmax(sensor.values))]
        self.assertLess(pressed.end[2], pressed.start[2])  # the finger presses down on the box
        self.assertAlmostEqual(pressed.start[2], 0.04, delta=2e-3)  # the upper face of the box

    def test_arrow_of_the_force_points_up_to_the_contact(self):
        self.press()
        shaft, head = self.state.marks(self.simulation.plain_data)[-2:]
        direction = (head.end - shaft.start) / np.linalg.norm(head.end - shaft.start)
        (sensor,) = self.state.sensors
        np.testing.assert_allclose(direction, sensor.force / np.linalg.norm(sensor.force), atol=1e-9)
        self.assertGreater(direction[2], 0.9)
        geom = self.scene.plain_geom(sensor.shown.geom)
        data = self.simulation.plain_data
        origin = data.geom_xmat[geom].reshape(3, 3) @ sensor.shown.origin + data.geom_xpos[geom]
        across = sensor.torque - direction * (direction @ sensor.torque)
        self.assertGreater(np.linalg.norm(across), 1e-3)
        np.testing.assert_allclose(np.cross(head.end - origin, sensor.force), across, atol=1e-9)
        self.assertAlmostEqual(head.end[2], 0.04, delta=3e-3)
        self.state.draws_forces = False
        self.assertEqual(self.state.marks(self.simulation.plain_data)[-2:], [None, None])

    def test_geoms_of_the_viewer_show_the_marks(self):
        self.press()
        model, data = self.scene.plain, self.simulation.plain_data
        marks = self.state.marks(data)
        self.state.draws_forces = False
        hidden = self.state.marks(data)
        first = self.scene.first_mark
        show_in_model(marks, first, model, data)
        for geom, mark in enumerate(marks, first):
            np.testing.assert_allclose(data.geom_xpos[geom], 0.5 * (mark.start + mark.end), atol=1e-12)
            np.testing.assert_array_equal(model.geom_rgba[geom], mark.color.astype(np.float32))
        show_in_model(hidden, first, model, data)
        sizes = model.geom_size[first] * np.linalg.norm(data.geom_xmat[first].reshape(3, 3), axis=0)
        np.testing.assert_allclose(sizes, [marks[0].radius, marks[0].radius, marks[0].half_length], rtol=1e-9)
        self.assertLess(np.abs(data.geom_xmat[first + len(marks) - 2 : first + len(marks)]).max(), 1e-2)
        np.testing.assert_array_equal(model.geom_rgba[first : first + len(marks), 3], 1)

    def test_most_pressed_taxels_are_drawn_if_there_is_no_room_for_all(self):
        self.press()
        marks = self.state.marks(self.simulation.plain_data)
        self.state.scene = dataclasses.replace(self.scene, marks=MarkCounts(taxels=2, forces=1))
        fewer = self.state.marks(self.simulation.plain_data)
        self.assertEqual(len(fewer), 4)
        lengths = sorted(mark.half_length for mark in marks[:-2])
        np.testing.assert_allclose(sorted(mark.half_length for mark in fewer[:2]), lengths[-2:])
        self.assertGreater(lengths[-2], 5 * lengths[-3])

    def test_marks_leave_the_renderer_room_for_the_scene(self):
        model = mujoco.MjModel.from_xml_string("<mujoco><worldbody>" + "<geom type='capsule' size='1 1'/>" * 20 +
                                               "<geom size='1'/>" * 40 + "</worldbody></mujoco>")
        self.assertEqual(count_marks(model, 12, 3), MarkCounts(12, 3))
        counts = count_marks(model, 256, 3)
        self.assertEqual((counts.forces, counts.total), (3, len(counts.shapes())))
        objects = sum(3 if shape == mujoco.mjtGeom.mjGEOM_CYLINDER else 1 for shape in counts.shapes())
        self.assertLessEqual(100 + objects, 256)
        self.assertGreater(100 + objects, 245)
        crowded = mujoco.MjModel.from_xml_string("<mujoco><worldbody>" + "<geom size='1'/>" * 300 + "</worldbody></mujoco>")
        self.assertEqual(count_marks(crowded, 12, 3), MarkCounts(0, 0))

    def test_numbers_that_are_not_finite_are_not_drawn(self):
        self.press(5)
        row = np.full(self.scene.full.nsensordata, np.nan)
        self.state.take(1.0, row, NO_SURFACE)
        for mark in self.state.marks(self.simulation.plain_data)[:-2]:
            self.assertTrue(np.isfinite(mark.end).all())
        describe(self.state.sensors[0])

    def test_panel_names_the_largest_reading_with_its_unit(self):
        self.press()
        text = describe(self.state.sensors[0])
        self.assertRegex(text, r"Pa at (right|left) pad mid   largest so far [\d.]+ Pa   force [\d.]+ N   area [\d.]+ mm2")

    def test_plot_has_the_twelve_largest_curves(self):
        rows = np.zeros((3, 40))
        rows[1, 5:25] = np.arange(1, 21)
        self.assertEqual(curves_to_draw(rows), list(range(13, 25)))
        self.assertEqual(curves_to_draw(np.zeros((0, 4))), [])


if __name__ == "__main__":
    unittest.main()
