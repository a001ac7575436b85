"""Tests sensors on geoms that MuJoCo copies, renames, moves or removes while it compiles a scene."""
import unittest
from unittest import mock

import mujoco
import numpy as np

import taxel
import taxel.scenes

PRESS = taxel.EXAMPLES / "scenes" / "press.xml"
MESH = taxel.EXAMPLES / "meshes" / "fingertip.obj"
FINGER = """<body name="finger" pos="0 0.022 0.0515" euler="105 0 0"><geom name="tip" type="mesh" mesh="tip" contype="0"
    conaffinity="0"/><geom name="core" type="sphere" size="0.001" pos="0 0 -0.05"/></body>"""


def scene(finger=FINGER, mesh="", compiler=""):
    """Returns a scene with a finger whose pad presses on a box. It has no sensor."""
    return mujoco.MjSpec.from_string(
        f'<mujoco>{compiler}<option gravity="0 0 0"/><asset><mesh name="tip" file="{MESH}" inertia="shell" {mesh}/></asset>'
        f'<worldbody><body name="box" pos="0 0 0.0205"><freejoint/><geom name="box" type="box" size="0.3 0.02 0.02"/></body>'
        f"{finger}</worldbody></mujoco>")


def force_of(spec, name="tip taxels"):
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return taxel.readings(model, data)[name].elastic_force


class CompiledGeomsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        taxel.load_plugin()
        spec = scene()
        taxel.attach(spec, "tip", taxel.FINGERTIP, others=["box"], output=["readings", "elastic_wrench"])
        cls.force = force_of(spec)

    def test_the_box_presses_on_the_finger(self):
        self.assertGreater(self.force[2], 0.1)

    def test_a_child_keeps_its_sensor_under_a_prefix_and_a_suffix(self):
        for prefix, suffix in (("", "_l"), ("a/", "_l"), ("a/", "")):
            with self.subTest(prefix=prefix, suffix=suffix):
                child = scene()
                taxel.attach(child, "tip", taxel.FINGERTIP, others=["box"], output=["readings", "elastic_wrench"])
                parent = mujoco.MjSpec()
                parent.option.gravity = [0, 0, 0]
                parent.attach(child, prefix=prefix, suffix=suffix, frame=parent.worldbody.add_frame())
                name = f"{prefix}tip taxels{suffix}"
                np.testing.assert_array_equal(force_of(parent, name), self.force)
                model = parent.compile()
                found = taxel.readings(model, mujoco.MjData(model))[name]
                self.assertEqual(found.geom, f"{prefix}tip{suffix}")

    def test_a_suffix_is_found_without_a_reference_of_the_sensor(self):
        child = scene()
        config = {"layout": str(taxel.FINGERTIP), "geom": "tip", "others": "box", "output": "readings elastic_wrench"}
        child.activate_plugin("taxel.sensor")
        child.add_plugin(name="skin", plugin_name="taxel.sensor", active=True).config = config
        sensor = child.add_sensor(name="taxels", type=mujoco.mjtSensor.mjSENS_PLUGIN)
        sensor.plugin.name, sensor.plugin.plugin_name, sensor.plugin.active = "skin", "taxel.sensor", True
        parent = mujoco.MjSpec()
        parent.option.gravity = [0, 0, 0]
        parent.attach(child, prefix="a/", suffix="_l", frame=parent.worldbody.add_frame())
        np.testing.assert_array_equal(force_of(parent, "a/taxels_l"), self.force)
        model = parent.compile()
        self.assertEqual(taxel.readings(model, mujoco.MjData(model))["a/taxels_l"].geom, "a/tip_l")

    def test_replicated_fingers_take_sensors(self):
        spec = scene(f'<replicate count="2" offset="0.05 0 0">{FINGER}</replicate>')
        for name in ("tip0", "tip1"):
            taxel.attach(spec, name, taxel.FINGERTIP, others=["box"], output=["readings", "elastic_wrench"])
        for name in ("tip0", "tip1"):
            np.testing.assert_allclose(force_of(spec, f"{name} taxels"), self.force, rtol=1e-9, atol=1e-12)

    def test_a_reference_pose_is_refused_by_name(self):
        for mesh in ('refpos="0 0 0.01"', 'refquat="0 1 0 0"'):
            spec = scene(mesh=mesh)
            with self.assertRaisesRegex(taxel.Error, 'mesh "tip" of geom "tip" has refpos or refquat'):
                taxel.attach(spec, "tip", taxel.FINGERTIP)
            self.assertEqual((len(spec.plugins), len(spec.sensors)), (0, 0))

    def test_discarded_geoms_are_kept_by_their_sensors(self):
        spec = scene(FINGER.replace("0 0 -0.05", "0 0 0.015"), compiler='<compiler discardvisual="true"/>')
        with self.assertWarnsRegex(UserWarning, 'replaces the contacts of what lies within it: "core"'):
            taxel.attach(spec, "tip", taxel.FINGERTIP, output=["readings", "elastic_wrench"])
        self.assertNotIn("others", spec.plugins[-1].config)
        np.testing.assert_allclose(force_of(spec), self.force, rtol=1e-9, atol=1e-12)

    def test_scenes_are_compiled_only_where_it_is_needed(self):
        far = FINGER[: FINGER.index('<geom name="core"')] + "</body>"
        cases = [(0, FINGER, {"others": ["box"], "force": "sense"}), (0, FINGER, {"others": ["box"], "sisters": "keep"}),
                 (0, far, {"others": ["box"]}), (1, FINGER, {"others": ["box"]}), (1, FINGER, {"force": "sense"})]
        for count, finger, arguments in cases:
            with self.subTest(count=count, **arguments), mock.patch.object(
                    taxel.scenes, "CompiledSpec", wraps=taxel.scenes.CompiledSpec) as compiled:
                taxel.attach(scene(finger), "tip", taxel.FINGERTIP, **arguments)
                self.assertEqual(compiled.call_count, count)


if __name__ == "__main__":
    unittest.main()
