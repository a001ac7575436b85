"""Tests taxel.generate: layouts by patterns on meshes and on the bodies of scenes."""
import unittest
import warnings

import mujoco
import numpy as np

import taxel

FINGER = taxel.EXAMPLES / "meshes" / "fingertip.obj"
DIRECTIONS = {"pad": [0, -1, 0], "distal": [0, 0, 1]}


class GenerateTest(unittest.TestCase):
    def setUp(self):
        taxel.load_plugin()
        warnings.simplefilter("error")

    def test_lattice_has_its_pitch_and_faces_the_pad(self):
        layout = taxel.generate(FINGER, pitch=0.004, scale=1, **DIRECTIONS)
        self.assertGreater(len(layout), 15)
        self.assertLess(layout.normals[:, 1].max(), -0.49)
        seen = layout.centers[:, [0, 2]]
        distances = np.linalg.norm(seen[:, None] - seen[None], axis=2) + np.eye(len(layout))
        np.testing.assert_allclose(distances.min(axis=1), 0.004, atol=1e-6)
        np.testing.assert_allclose(layout.radii, 0.0032)
        self.assertEqual([one for one in layout.check() if one.severity == "error"], [])

    def test_values_are_those_of_the_pattern(self):
        layout = taxel.generate(FINGER, "ring", count=8, axis="Z", turn=30, scale=1, **DIRECTIONS)
        self.assertEqual(len(layout), 8)
        self.assertEqual(len(taxel.generate(FINGER, "spread", count=9, region="ny < -0.5", scale=1.0, **DIRECTIONS)), 9)
        text = taxel.generate(FINGER, pitch="4 mm", scale=1, **DIRECTIONS)
        self.assertEqual(text, taxel.generate(FINGER, pitch=0.004, scale=1, **DIRECTIONS))

    def test_each_guess_is_a_warning(self):
        with self.assertWarns(UserWarning) as caught:
            taxel.generate(FINGER)
        texts = [str(one.message) for one in caught.warnings]
        self.assertEqual(len(texts), 2)
        self.assertIn("unit of the mesh", texts[0])
        self.assertIn("directions from the shape", texts[1])

    def test_scene_gives_mesh_and_scale_of_a_body(self):
        spec = mujoco.MjSpec.from_file(str(taxel.EXAMPLES / "scenes" / "hand_grasps_ball.xml"))
        layout = taxel.generate(spec, body="thumb middle", pitch=0.005, **DIRECTIONS)
        self.assertTrue(layout.mesh_file.endswith("hand_middle.obj"), layout.mesh_file)
        np.testing.assert_allclose(layout.value("/mesh/scale")[0], 1.18)

    def test_bad_input_names_the_argument(self):
        spec = mujoco.MjSpec.from_file(str(taxel.EXAMPLES / "scenes" / "hand_grasps_ball.xml"))
        for call, text in (
            (lambda: taxel.generate(FINGER, "hexagon"), "hexagonal"),
            (lambda: taxel.generate(FINGER, rise=0.1), "rise"),
            (lambda: taxel.generate(FINGER, body="a"), "needs a scene"),
            (lambda: taxel.generate(spec), "body"),
            (lambda: taxel.generate(spec, body="tail"), 'no body is named "tail"'),
            (lambda: taxel.generate(spec, body="ball"), "has no geom with a mesh"),
            (lambda: taxel.generate("gone.stl"), "gone.stl"),
        ):
            with self.assertRaisesRegex(taxel.Error, text):
                call()


if __name__ == "__main__":
    unittest.main()
