"""Tests the two models of a scene: the full one, and the one without engine plugins."""
import pathlib
import tempfile
import unittest

import mujoco
import numpy as np

import taxel
from taxel.studio.scene import load_scene
from taxel.studio.stripping import strip_plugins

SCENES = taxel.EXAMPLES / "scenes"
TORUS = """<mujoco><extension><plugin plugin="mujoco.sdf.torus"><instance name="torus"><config key="radius1" value="0.3"/>
  <config key="radius2" value="0.1"/></instance></plugin></extension>
  <asset><mesh name="torus"><plugin instance="torus"/></mesh></asset>
  <worldbody><body pos="0 0 1" euler="30 20 0"><freejoint/>
    <geom type="sdf" name="torus" mesh="torus" pos="0.1 0 0"><plugin instance="torus"/></geom></body></worldbody></mujoco>"""


class SceneTest(unittest.TestCase):
    def test_viewer_model_has_no_plugin_and_the_same_kinematics(self):
        for name in ("press", "hand_grasps_ball"):
            scene = load_scene(SCENES / f"{name}.xml")
            full, plain = scene.full, scene.plain
            with self.subTest(scene=name):
                self.assertGreater(full.nplugin, 0)
                self.assertEqual((plain.nplugin, plain.nsensordata), (0, full.nsensordata - sum(full.sensor_dim)))
                own = [scene.plain_geom(geom) for geom in range(full.ngeom)]
                self.assertEqual(plain.ngeom, full.ngeom + scene.marks.total)
                for field in ("geom_type", "geom_bodyid", "geom_size"):
                    np.testing.assert_array_equal(getattr(plain, field)[own], getattr(full, field))
                for field in ("body_mass", "body_inertia", "body_parentid", "jnt_type", "dof_damping", "qpos0", "key_qpos"):
                    np.testing.assert_array_equal(getattr(plain, field), getattr(full, field))
                self.check_poses(full, plain, own)

    def check_poses(self, full, plain, own):
        """Compares poses at random positions of the joints."""
        random = np.random.default_rng(3)
        a, b = mujoco.MjData(full), mujoco.MjData(plain)
        for _ in range(20):
            velocity = random.normal(size=full.nv)
            mujoco.mj_integratePos(full, a.qpos, velocity, 0.5)
            b.qpos[:] = a.qpos
            mujoco.mj_kinematics(full, a)
            mujoco.mj_kinematics(plain, b)
            for field in ("xpos", "xquat", "xipos"):
                np.testing.assert_array_equal(getattr(b, field), getattr(a, field))
            for field in ("geom_xpos", "geom_xmat"):
                np.testing.assert_array_equal(getattr(b, field)[own], getattr(a, field))

    def test_viewer_model_is_framed_as_the_full_one(self):
        scene = load_scene(SCENES / "press.xml")
        self.assertEqual(scene.plain.stat.extent, scene.full.stat.extent)
        np.testing.assert_array_equal(scene.plain.stat.center, scene.full.stat.center)

    def test_meshes_of_plugins_become_triangles(self):
        spec = mujoco.MjSpec.from_string(TORUS)
        full = spec.compile()
        strip_plugins(spec, full)
        plain = spec.compile()
        self.assertEqual((full.nplugin, plain.nplugin), (1, 0))
        self.assertEqual(plain.geom_type[0], mujoco.mjtGeom.mjGEOM_MESH)
        np.testing.assert_array_equal(plain.mesh_face, full.mesh_face)
        np.testing.assert_allclose(plain.mesh_vert, full.mesh_vert, atol=1e-6)
        np.testing.assert_allclose(plain.body_mass, full.body_mass, rtol=1e-5)
        a, b = mujoco.MjData(full), mujoco.MjData(plain)
        mujoco.mj_kinematics(full, a)
        mujoco.mj_kinematics(plain, b)
        np.testing.assert_allclose(b.geom_xpos, a.geom_xpos, atol=1e-6)

    def test_taxels_are_on_the_mesh_of_the_geom(self):
        scene = load_scene(SCENES / "press.xml")
        (sensor,) = scene.sensors
        mesh = int(scene.full.geom_dataid[sensor.geom])
        first = scene.full.mesh_vertadr[mesh]
        vertices = scene.full.mesh_vert[first : first + scene.full.mesh_vertnum[mesh]]
        distances = np.linalg.norm(sensor.centers[:, None] - vertices[None], axis=2).min(axis=1)
        self.assertLess(distances.max(), 1.5e-3)  # the mesh has edges of about 1 mm
        np.testing.assert_allclose(np.linalg.norm(sensor.normals, axis=1), 1)

    def test_bad_files_are_errors_with_a_remedy(self):
        with tempfile.TemporaryDirectory() as folder:
            files = {"empty.xml": "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>", "broken.xml": "<mujoco>",
                     "binary.mjb": "", "torus.xml": TORUS}
            for name, text in files.items():
                (pathlib.Path(folder) / name).write_text(text)
            cases = [("absent.xml", "not found"), (".", "not a file"), ("empty.xml", "taxel.attach"), ("broken.xml", "XML"),
                     ("binary.mjb", "open its XML"), ("torus.xml", "no sensor of the plugin taxel.sensor")]
            for name, words in cases:
                with self.subTest(name=name), self.assertRaisesRegex(taxel.Error, words) as caught:
                    load_scene(pathlib.Path(folder) / name)
                self.assertTrue(caught.exception.file.startswith(folder))


if __name__ == "__main__":
    unittest.main()
