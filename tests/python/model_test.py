"""Tests taxel.SensorModel and taxel.contact."""
import gc
import json
import pathlib
import signal
import tempfile
import threading
import time
import unittest

import numpy as np

import taxel

SPHERE = {"shape": {"type": "sphere", "size": [0.05]}, "material": {"modulus": 5e4}, "pos": [0, 0, 0.0475]}
PLANE = {"shape": {"type": "plane"}}


class SensorModelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.layout = taxel.Layout.read(taxel.FINGERTIP)
        cls.model = taxel.SensorModel(cls.layout)

    def test_samples_cover_the_skin(self):
        model = self.model
        count = len(model.sample_positions)
        self.assertEqual(model.sample_normals.shape, (count, 3))
        np.testing.assert_allclose(np.linalg.norm(model.sample_normals, axis=1), 1, rtol=1e-9)
        self.assertAlmostEqual(model.sample_areas.sum(), model.sampled_area, delta=1e-9 * model.sampled_area)
        triangles = model.vertices[model.faces]
        edges = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        area = 0.5 * np.linalg.norm(edges, axis=1).sum()
        self.assertAlmostEqual(area, model.sampled_area, delta=1e-9 * area)

    def test_fields_have_the_weights_of_the_paper(self):
        model = self.model
        self.assertEqual((len(model), model.field_offsets[0]), (12, 0))
        for k, (first, last) in enumerate(zip(model.field_offsets, model.field_offsets[1:])):
            samples = model.sample_positions[model.field_samples[first:last]]
            distances = np.linalg.norm(samples - model.layout.centers[k], axis=1)
            np.testing.assert_allclose(distances, model.field_distances[first:last], atol=1e-12)
            # The weight of a sample is (r - d)^2.
            np.testing.assert_allclose(
                (model.layout.radii[k] - distances) ** 2, model.field_weights[first:last], rtol=1e-9, atol=1e-15)

    def test_arrays_outlive_the_model(self):
        model = taxel.SensorModel(self.layout, "preview")
        arrays = [getattr(model, name) for name in dir(model) if isinstance(getattr(model, name), np.ndarray)]
        self.assertEqual(len(arrays), 9)
        copies = [array.copy() for array in arrays]
        del model
        gc.collect()
        for array, expected in zip(arrays, copies):
            self.assertFalse(array.flags.writeable)
            np.testing.assert_array_equal(array, expected)

    def test_broken_layouts_raise_errors(self):
        layout = self.layout.copy()
        layout.set_value("/mesh/file", "absent.obj")
        with self.assertRaisesRegex(taxel.Error, "absent.obj"):
            taxel.SensorModel(layout)
        with self.assertRaisesRegex(ValueError, "quality"):
            taxel.SensorModel(self.layout, "best")

    def test_building_releases_the_lock_of_python(self):
        finished = threading.Event()

        def build():
            taxel.SensorModel(self.layout)
            finished.set()

        thread = threading.Thread(target=build)
        thread.start()
        turns = 0
        while not finished.is_set():
            turns += 1
            time.sleep(0.001)
        thread.join()
        self.assertGreater(turns, 10)

    def test_ctrl_c_ends_building(self):
        layout = self.layout.copy()
        layout.set_value("/sampling/density", 1e9)  # minutes
        timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
        timer.start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            taxel.SensorModel(layout)
        self.assertLess(time.monotonic() - start, 120)  # also on a busy machine; building takes minutes
        timer.join()


class CalibratorTest(unittest.TestCase):
    def calibrator(self, calibration, timestep=0.0):
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.set_value("/calibration", calibration)
        return taxel.Calibrator(layout, timestep)

    def test_a_step_relaxes_by_two_exponentials(self):
        arms = [(0.12, 0.8), (0.17, 5.5)]
        device = self.calibrator({"relaxation": [{"amplitude": a, "time": t} for a, t in arms]})
        load = np.arange(12.0)
        for time_of_step in np.linspace(0, 20, 301):
            left = 1 - sum(a * (1 - np.exp(-time_of_step / t)) for a, t in arms)
            np.testing.assert_allclose(device.advance(time_of_step, load), load * left, rtol=1e-12)

    def test_a_restored_state_gives_the_same_bits(self):
        device = self.calibrator({"low_pass": {"time": 0.01}, "noise": 2, "latency": 0.003,
                                  "hysteresis": {"width": 10, "plays": [{"width": 4, "fraction": 0}]}}, 0.001)
        loads = np.random.default_rng(1).uniform(0, 100, (1000, 12))
        states, values = [], []
        for step, load in enumerate(loads):
            states.append(device.state)
            values.append(device.advance(0.001 * step, load))
        for step in np.random.default_rng(2).permutation(1000):
            device.state = states[step]
            np.testing.assert_array_equal(device.advance(0.001 * step, loads[step]), values[step])
        device.reset()
        np.testing.assert_array_equal(device.state, states[0])
        self.assertFalse(states[0].any())

    def test_mistakes_are_named(self):
        with self.assertRaisesRegex(taxel.Error, "/calibration: is missing"):
            taxel.Calibrator(taxel.Layout.read(taxel.FINGERTIP))
        with self.assertRaisesRegex(taxel.Error, "/calibration/relaxation/0/time: must be greater than 0, is -1"):
            self.calibrator({"relaxation": [{"amplitude": 0.1, "time": -1}]})
        with self.assertRaisesRegex(taxel.Error, "latency of 0.01 s needs the time between two readings"):
            self.calibrator({"latency": 0.01})
        device = self.calibrator({"noise": 1})
        with self.assertRaisesRegex(taxel.Error, "11 readings for 12 taxels"):
            device.advance(0, np.zeros(11))
        with self.assertRaisesRegex(taxel.Error, "a state of 2 numbers"):
            device.state = [0, 0]


class PoseReadingsTest(unittest.TestCase):
    BALL = {"shape": {"type": "sphere", "size": [0.004]}}

    @classmethod
    def setUpClass(cls):
        cls.model = taxel.SensorModel(taxel.Layout.read(taxel.FINGERTIP), "preview")
        layout = cls.model.layout
        cls.poses = np.zeros((24, 7))
        cls.poses[:, :3] = np.repeat(layout.centers + 0.0035 * layout.normals, 2, axis=0)
        cls.poses[:, 3:] = [0.6, 0, 0.8, 0]

    def test_rows_have_the_bits_of_single_contacts(self):
        result = self.model.read(taxel.Object(self.BALL), self.poses, threads=1)
        self.assertEqual((result.readings.shape, result.wrench.shape, result.area.shape), ((24, 12), (24, 6), (24,)))
        self.assertEqual((len(result), result.unit), (24, "Pa"))
        self.assertGreater(result.area.min(), 0)
        for row, pose in list(enumerate(self.poses))[::7]:
            ball = {**self.BALL, "pos": pose[:3].tolist(), "quat": pose[3:].tolist()}
            single = taxel.contact({"a": {}, "b": ball}, self.model)
            np.testing.assert_array_equal(result.readings[row], single.readings)
            np.testing.assert_array_equal(result.wrench[row], [*single.force, *single.torque])
            self.assertEqual(result.area[row], single.area)
        other = self.model.read(taxel.Object(self.BALL), self.poses, threads=2)
        np.testing.assert_array_equal(other.readings, result.readings)
        self.assertFalse(result.readings.flags.writeable)

    def test_method_and_aggregate_replace_those_of_the_layout(self):
        ball = taxel.Object(self.BALL)
        default = self.model.read(ball, self.poses)
        samples = self.model.read(ball, self.poses, method="samples")
        exact = self.model.read(ball, self.poses, method="exact")
        forces = self.model.read(ball, self.poses, aggregate="force")
        peak = exact.readings.max()
        np.testing.assert_allclose(samples.readings, exact.readings, atol=0.1 * peak)
        self.assertTrue((samples.readings != exact.readings).any())
        self.assertIn(default.readings.tolist(), (samples.readings.tolist(), exact.readings.tolist()))
        self.assertEqual((forces.unit, exact.unit), ("N", "Pa"))
        with self.assertRaisesRegex(ValueError, "method: must be one of"):
            self.model.read(ball, self.poses, method="best")
        with self.assertRaisesRegex(taxel.Error, "max"):
            self.model.read(ball, self.poses, method="exact", aggregate="max")

    def test_wrong_poses_raise_errors(self):
        ball = taxel.Object(self.BALL)
        self.assertEqual(len(self.model.read(ball, np.zeros((0, 7)))), 0)
        with self.assertRaisesRegex(ValueError, "poses: must have the shape"):
            self.model.read(ball, np.zeros((3, 6)))
        wrong = self.poses.copy()
        wrong[5, 1] = np.nan
        with self.assertRaisesRegex(ValueError, "poses: must be finite, row 5"):
            self.model.read(ball, wrong)
        wrong = self.poses.copy()
        wrong[4, 3:] = 0
        with self.assertRaisesRegex(taxel.Error, "/poses/4: the quaternion w x y z must have length 1, has 0"):
            self.model.read(ball, wrong)
        with self.assertRaisesRegex(ValueError, "threads: must not be negative, is -1"):
            self.model.read(ball, self.poses, threads=-1)

    def test_objects_are_bodies_of_cases(self):
        with self.assertRaisesRegex(taxel.Error, "/shape"):
            taxel.Object({"material": {}})
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "case.json"
            case.write_text(json.dumps({"format": "contact-case", "version": 1, "a": {}, "b": self.BALL}))
            of_file = self.model.read(taxel.Object(case), self.poses)
        np.testing.assert_array_equal(of_file.readings, self.model.read(taxel.Object(self.BALL), self.poses).readings)
        self.assertTrue(taxel.Object({**self.BALL, "material": {"modulus": 1e5}}).soft)
        self.assertFalse(taxel.Object(self.BALL).soft)

    def test_reading_releases_the_lock_of_python_and_ctrl_c_ends_it(self):
        many = np.tile(self.poses, (100000, 1))  # minutes
        timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
        timer.start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            self.model.read(taxel.Object(self.BALL), many)
        self.assertLess(time.monotonic() - start, 60)
        timer.join()


class MaterialTest(unittest.TestCase):
    def test_thin_layers_have_their_closed_forms(self):
        sheet = taxel.material(youngs=6e4, poisson=0.49, thickness=0.002)
        self.assertAlmostEqual(sheet["modulus"], 6e4 / (1 - 0.49**2), places=6)
        self.assertIsNone(sheet["poisson_limit"])
        glued = taxel.material(youngs=6e4, poisson=0.49, thickness=0.002, bonded=True)
        self.assertAlmostEqual(glued["modulus"], 6e4 * 0.51 / (1.49 * 0.02), places=6)
        self.assertIsNone(glued["holds_from"])

    def test_elastomers_are_known_by_their_words(self):
        sheet = taxel.material("ecoflex-00-30", thickness=0.002, bonded=True, contact_radius=0.003)
        self.assertAlmostEqual(sheet["modulus"], 353833, delta=1)
        self.assertLess(sheet["holds_from"], 0.003)

    def test_bad_values_raise_errors(self):
        for arguments, message in (
            ({"youngs": 1.0, "poisson": 0.5}, "material: poisson: must be at least 0 and less than 0.5"),
            ({"youngs": 1.0}, "material: poisson: is missing"),
            ({"youngs": 1e300, "poisson": 0.3}, "material: youngs: must be at most 1e15 Pa, is 1e+300"),
            ({"preset": "rubber"}, "material: preset: rubber is unknown, there are ecoflex-00-10"),
            ({"preset": "solaris", "youngs": 1.0}, "material: youngs: excludes the elastomer"),
        ):
            with self.assertRaises(taxel.Error) as raised:
                taxel.material(thickness=0.002, **arguments)
            self.assertIn(message, str(raised.exception))


class ContactTest(unittest.TestCase):
    def test_soft_sphere_on_plane_has_the_force_of_its_surface(self):
        contact = taxel.contact({"a": SPHERE, "b": PLANE})
        self.assertEqual(len(contact.offsets), len(contact.areas) + 1)
        self.assertEqual(contact.offsets[-1], len(contact.vertices))
        self.assertEqual(len(contact.pressures), len(contact.vertices))
        np.testing.assert_allclose(contact.normals, np.tile([0, 0, 1], (len(contact.areas), 1)), atol=1e-9)
        np.testing.assert_allclose(contact.vertices[:, 2], 0, atol=1e-12)
        self.assertAlmostEqual(contact.areas.sum(), contact.area, delta=1e-12)
        self.assertEqual(contact.pressures.max(), contact.max_pressure)
        # The field is E depth / R; the cap of depth 2.5 mm has the radius sqrt(R^2 - (R - depth)^2).
        self.assertAlmostEqual(contact.area, np.pi * (0.05**2 - 0.0475**2), delta=0.05 * contact.area)
        self.assertGreater(contact.force[2], 0)
        self.assertIsNone(contact.readings)

    def test_model_reads_the_contact(self):
        layout = taxel.Layout.read(taxel.FINGERTIP)
        model = taxel.SensorModel(layout)
        box = {"shape": {"type": "box", "size": [0.02, 0.02, 0.02]}, "pos": [0, -0.0265, 0.012]}
        contact = taxel.contact({"a": {}, "b": box}, model)
        self.assertEqual(contact.readings.shape, (12,))
        self.assertGreater(contact.readings.max(), 1000)
        named = taxel.contact({"a": {"layout": str(taxel.FINGERTIP)}, "b": box})
        np.testing.assert_array_equal(named.readings, contact.readings)
        away = taxel.contact({"a": {"pos": [0, 1, 0]}, "b": box}, model)
        self.assertEqual((away.area, away.readings.max()), (0, 0))
        self.assertEqual(away.vertices.shape, (0, 3))

    def test_files_and_their_errors_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "case.json"
            file.write_text(json.dumps({"format": "contact-case", "version": 1, "a": SPHERE, "b": PLANE}))
            self.assertGreater(taxel.contact(file).area, 0)
            file.write_text(file.read_text().replace("0.05]", "-1]"))
            with self.assertRaises(taxel.Error) as caught:
                taxel.contact(file)
        self.assertEqual((caught.exception.file, caught.exception.pointer), (str(file), "/a/shape/size/0"))

    def test_bad_cases_raise_errors(self):
        rigid = {"shape": {"type": "sphere", "size": [0.05]}}
        cases = [("/b", {"a": SPHERE}), ("/a", {"a": {}, "b": PLANE}), ("", {"a": rigid, "b": PLANE})]
        for pointer, case in cases:
            with self.subTest(case=case), self.assertRaises(taxel.Error) as caught:
                taxel.contact(case)
            self.assertEqual(caught.exception.pointer, pointer)
        wide = {"shape": {"type": "sphere", "size": [1e300]}}
        for pointer, change in (("/a/pos/2", {"pos": [0, 0, 1e300]}), ("/a/shape/size/0", wide),
                                ("/a/material/modulus", {"material": {"modulus": 1e300}})):
            with self.subTest(pointer=pointer), self.assertRaises(taxel.Error) as caught:
                taxel.contact({"a": {**SPHERE, **change}, "b": PLANE})
            self.assertEqual(caught.exception.pointer, pointer)
        with self.assertRaisesRegex(ValueError, "finite"):
            taxel.contact({"a": {**SPHERE, "pos": [0, 0, float("nan")]}, "b": PLANE})


if __name__ == "__main__":
    unittest.main()
