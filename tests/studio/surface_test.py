"""Tests the contact surface: its triangles, its plane and its place in the plot."""
import unittest

import mujoco
import numpy as np

import taxel
from taxel.studio.panel import pack, to_pixels
from taxel.studio.scene import load_scene
from taxel.studio.surface import NO_SURFACE, Surface, SurfaceReader, footprint

PRESS = taxel.EXAMPLES / "scenes" / "press.xml"
HAND = taxel.EXAMPLES / "scenes" / "hand_grasps_ball.xml"


def areas(corners):
    """Returns the areas of triangles (n, 3, 2 or 3), shape (n,)."""
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    squares = (first**2).sum(axis=1) * (second**2).sum(axis=1) - (first * second).sum(axis=1) ** 2
    return 0.5 * np.sqrt(np.maximum(squares, 0))


def surface_of(corners):
    return Surface(np.array(corners, float), np.ones((len(corners), 4)), np.zeros((len(corners), 2), int))


class ReaderTest(unittest.TestCase):
    def test_surface_has_the_area_and_the_place_of_the_contact(self):
        model = load_scene(PRESS).full
        data = mujoco.MjData(model)
        reader = SurfaceReader(model)
        mujoco.mj_forward(model, data)
        for _ in range(300):
            mujoco.mj_step(model, data)
        surface = reader.read(data)
        area = float(data.sensordata[-1])
        self.assertGreater(len(surface), 100)
        self.assertGreater(area, 1e-5)
        self.assertAlmostEqual(areas(surface.corners).sum() / area, 1, delta=1e-4)  # single precision
        np.testing.assert_allclose(surface.corners[:, :, 2], 0.04, atol=2e-3)  # the upper face of the box
        self.assertEqual(set(surface.geoms[:, 0].tolist()), {model.geom("fingertip").id})
        center = surface.corners.mean(axis=(0, 1))
        near, far = surface.colors[np.argsort(np.linalg.norm(surface.corners.mean(axis=1) - center, axis=1))][[0, -1]]
        self.assertGreater(near[0] - near[2], 0.3)  # red in the middle, blue at the edge
        self.assertGreater(far[2] - far[0], 0.3)

    def test_each_finger_has_its_own_surface(self):
        scene = load_scene(HAND)
        data = mujoco.MjData(scene.full)
        for _ in range(100):
            mujoco.mj_step(scene.full, data)
        surface = SurfaceReader(scene.full).read(data)
        own = [surface.of(sensor.geom) for sensor in scene.sensors]
        self.assertEqual(sum(len(one) for one in own), len(surface))
        for sensor, one in zip(scene.sensors, own):
            distance = np.linalg.norm(one.corners.mean(axis=(0, 1)) - data.geom_xpos[sensor.geom])
            self.assertLess(distance, 0.03, sensor.name)

    def test_no_contact_is_no_surface(self):
        model = load_scene(PRESS).full
        data = mujoco.MjData(model)
        data.qpos[:] += 0.0
        data.qpos[model.nq - 1] += 0.05  # lifts the finger
        mujoco.mj_forward(model, data)
        self.assertEqual(len(SurfaceReader(model).read(data)), 0)


class FootprintTest(unittest.TestCase):
    def test_flat_surface_keeps_its_area_and_has_its_centroid_at_0(self):
        random = np.random.default_rng(1)
        flat = np.concatenate([random.random((50, 3, 2)) * 0.01, np.zeros((50, 3, 1))], axis=2)
        for _ in range(20):
            rotation = np.linalg.qr(random.normal(size=(3, 3)))[0]
            corners = flat @ rotation.T + random.normal(size=3)
            plane = footprint(surface_of(corners))
            np.testing.assert_allclose(areas(plane), 1e6 * areas(corners), rtol=1e-6)
            centroid = (plane.mean(axis=1) * areas(plane)[:, None]).sum(axis=0)
            np.testing.assert_allclose(centroid, 0, atol=1e-6)

    def test_horizontal_surface_is_seen_from_above_with_x_to_the_right(self):
        for corners in ([[0, 0, 1], [0.003, 0, 1], [0, 0.006, 1]], [[0, 0.006, 1], [0.003, 0, 1], [0, 0, 1]]):
            (plane,) = footprint(surface_of([corners]))
            by_x = plane[np.argsort(plane[:, 0])]
            np.testing.assert_allclose(by_x[2], [2, -2], atol=1e-9)
            np.testing.assert_allclose(by_x[:2, 0], -1, atol=1e-9)
            self.assertAlmostEqual(by_x[:2, 1].max(), 4)

    def test_two_faces_that_cancel_do_not_divide_by_zero(self):
        corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        plane = footprint(surface_of([corners, corners[::-1]]))
        self.assertTrue(np.isfinite(plane).all())
        self.assertEqual(footprint(NO_SURFACE).shape, (0, 3, 2))


class PixelTest(unittest.TestCase):
    def test_corners_of_the_plot(self):
        corners = np.array([[[-2.0, 1.0], [2.0, 1.0], [-2.0, -1.0]]])
        pixels = to_pixels(corners, (2, 1), (100, 50), (40, 20))
        self.assertEqual(sorted(map(tuple, pixels[0].tolist())), [(100, 50), (100, 70), (140, 50)])

    def test_corners_are_counter_clockwise_on_the_screen(self):
        triangles = np.random.default_rng(2).normal(size=(50, 3, 2))
        pixels = to_pixels(triangles, (3, 3), (0, 0), (100, 100))
        (a, b), (c, d) = (pixels[:, 1] - pixels[:, 0]).T, (pixels[:, 2] - pixels[:, 0]).T
        self.assertTrue(np.all(a * d - b * c <= 0))  # the y axis of the screen points down

    def test_colours_have_red_in_the_lowest_byte(self):
        self.assertEqual(pack(np.array([[1, 0.5, 0, 1], [0, 0, 2, -1]])), [0xFF0080FF, 0x00FF0000])


if __name__ == "__main__":
    unittest.main()
