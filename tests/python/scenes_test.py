"""Tests taxel.attach, taxel.readings and taxel.load_plugin with the installed MuJoCo."""
import os
import pathlib
import shutil
import tempfile
import unittest
import xml.sax.saxutils
from unittest import mock

import mujoco
import numpy as np

import taxel
import taxel.plugin

PRESS = taxel.EXAMPLES / "scenes" / "press.xml"


def spec_without_sensor():
    spec = mujoco.MjSpec.from_file(str(PRESS))
    spec.delete(spec.sensors[0])
    for plugin in list(spec.plugins):
        spec.delete(plugin)
    return spec


def bits_of(spec):
    """Returns contype and conaffinity of the instances that have them."""
    configs = {plugin.name: dict(plugin.config) for plugin in spec.plugins if plugin.name}
    return {name: (config["contype"], config["conaffinity"]) for name, config in configs.items() if config.get("contype")}


def simulate(scene, steps=200):
    """Simulates a specification or a model."""
    model = scene if isinstance(scene, mujoco.MjModel) else scene.compile()
    data = mujoco.MjData(model)
    for _ in range(steps):
        mujoco.mj_step(model, data)
    return model, data


class SceneTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        taxel.load_plugin()

    def test_readings_have_names_units_and_shapes(self):
        model, data = simulate(taxel.load_model(PRESS))
        found = taxel.readings(model, data)
        self.assertEqual(list(found), ["fingertip taxels"])
        sensor = found["fingertip taxels"]
        self.assertEqual((sensor.geom, sensor.unit, sensor.names[4]), ("fingertip", "Pa", "right tip"))
        self.assertEqual((sensor.values.shape, sensor.force.shape, sensor.torque.shape), ((12,), (3,), (3,)))
        np.testing.assert_array_equal(sensor.values, data.sensordata[:12])
        self.assertGreater(sensor.values.max(), 0)
        self.assertEqual(sensor.area, data.sensordata[18])
        mujoco.mj_step(model, data)
        np.testing.assert_array_equal(sensor.values, data.sensordata[:12])  # a view

    def test_attached_sensor_reads_as_the_one_of_the_file(self):
        _, expected = simulate(taxel.load_model(PRESS))
        spec = spec_without_sensor()
        taxel.attach(spec, "fingertip", taxel.FINGERTIP, others=["box"], output=["readings", "wrench", "area"])
        model, data = simulate(spec)
        np.testing.assert_array_equal(data.sensordata, expected.sensordata)
        self.assertGreater(taxel.readings(model, data)["fingertip taxels"].force[2], 0)

    def test_the_elastic_wrench_is_that_of_the_pressure_alone(self):
        spec = spec_without_sensor()
        words = ["wrench", "elastic_wrench", "readings"]
        taxel.attach(spec, "fingertip", taxel.FINGERTIP, others=["box"], output=words)
        model, data = simulate(spec)
        sensor = taxel.readings(model, data)["fingertip taxels"]
        np.testing.assert_array_equal(sensor.force, data.sensordata[:3])
        np.testing.assert_array_equal(sensor.elastic_force, data.sensordata[6:9])
        np.testing.assert_array_equal(sensor.elastic_torque, data.sensordata[9:12])
        np.testing.assert_array_equal(sensor.values, data.sensordata[12:])
        data.qvel[:] = 0
        data.qvel[2] = -0.05  # towards the box: the damping pushes, the elastic pressure does not know
        before = sensor.elastic_force.copy()
        mujoco.mj_forward(model, data)
        np.testing.assert_allclose(sensor.elastic_force, before, rtol=0.02)
        self.assertIsNone(sensor.area)

    def test_calibrated_values_are_those_of_the_chain_in_restored_states_too(self):
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.set_value("/calibration", {"relaxation": [{"amplitude": 0.2, "time": 0.05}], "noise": 5, "latency": 0.004})
        spec = spec_without_sensor()
        taxel.attach(spec, "fingertip", layout, others=["box"], output=["readings", "calibrated"])
        model = spec.compile()
        data, size = mujoco.MjData(model), mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_INTEGRATION)
        device = taxel.Calibrator(layout, model.opt.timestep)
        states, rows = [], []
        for _ in range(60):
            states.append(np.empty(size))
            mujoco.mj_getState(model, data, states[-1], mujoco.mjtState.mjSTATE_INTEGRATION)
            before = data.time
            mujoco.mj_step(model, data)
            sensor = taxel.readings(model, data)["fingertip taxels"]
            np.testing.assert_array_equal(sensor.calibrated, device.advance(before, sensor.values))
            rows.append(data.sensordata.copy())
        self.assertGreater(rows[-1].max(), 100)
        for step in (31, 7, 55):
            mujoco.mj_setState(model, data, states[step], mujoco.mjtState.mjSTATE_INTEGRATION)
            mujoco.mj_step(model, data)
            np.testing.assert_array_equal(data.sensordata, rows[step])

    def test_friction_sticks_by_the_arguments_and_by_the_layout(self):
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.set_value("/material/tangential_stiffness", 2e8)
        layout.set_value("/material/bristles", 300)
        found = []
        for file, keys in [(taxel.FINGERTIP, {"tangential_stiffness": 2e8, "bristles": 300}), (layout, {})]:
            spec = spec_without_sensor()
            taxel.attach(spec, "fingertip", file, others=["box"], output=["readings", "slip"], **keys)
            model, data = simulate(spec)
            self.assertGreaterEqual(model.npluginstate, 5 * 300)
            found.append(taxel.readings(model, data)["fingertip taxels"])
            self.assertEqual(found[-1].slip.shape, (12,))
        np.testing.assert_array_equal(found[0].slip, found[1].slip)
        np.testing.assert_array_equal(found[0].values, found[1].values)
        self.assertGreaterEqual(found[0].slip.min(), 0)
        self.assertLessEqual(found[0].slip.max(), 1)
        with self.assertRaisesRegex(taxel.Error, "tangential_stiffness"):
            taxel.attach(spec_without_sensor(), "fingertip", taxel.FINGERTIP, others=["box"], bristles=300)

    def test_the_skin_replaces_what_lies_within_it(self):
        mesh = taxel.Layout.read(taxel.FINGERTIP).mesh_file
        finger = (f'<body name="BODY" pos="X 0 0"><geom name="NAME" type="mesh" mesh="tip" contype="0" conaffinity="0"/>'
                  '<geom name="NAME_capsule" type="capsule" size="0.006 0.006" pos="0 0 0.015"/>'
                  '<geom name="NAME_far" type="sphere" size="0.005" pos="0 0 -0.02"/></body>')
        fingers = (finger.replace("NAME", name).replace("BODY", f"finger {name}").replace("X", x)
                   for name, x in (("a", "-0.0085"), ("b", "0.0085")))
        movable = [one.replace('<geom name="', '<joint type="slide" axis="1 0 0"/><inertial mass="0.1" pos="0 0 0" '
                               'diaginertia="1e-4 1e-4 1e-4"/><geom name="', 1) for one in fingers]
        spec = mujoco.MjSpec.from_string(
            f'<mujoco><option gravity="0 0 0"/><asset><mesh name="tip" file="{mesh}"/></asset><worldbody>'
            f'<geom name="floor" type="plane" size="1 1 1" pos="0 0 -1"/>{"".join(movable)}</worldbody></mujoco>')
        output = ["elastic_wrench", "area"]
        with self.assertWarnsRegex(UserWarning, 'skin on "a" replaces the contacts .*: "a_capsule"$'):
            taxel.attach(spec, "a", taxel.FINGERTIP, output=output)
        self.assertEqual(bits_of(spec), {"a": ("1", "1")})
        with self.assertWarnsRegex(UserWarning, '"b_capsule"'):
            taxel.attach(spec, "b", taxel.FINGERTIP, output=output)
        self.assertEqual(bits_of(spec), {"a": ("1", "1"), "b": ("1", "1")})
        by_name = {geom.name: geom.contype for geom in spec.geoms}
        self.assertEqual([by_name[name] for name in ("a_capsule", "a_far", "b_capsule", "b_far")], [0, 1, 0, 1])
        found = taxel.readings(*simulate(spec, 1))
        a, b = found["a taxels"], found["b taxels"]
        self.assertGreater(abs(a.elastic_force[0]), 0.01)
        np.testing.assert_allclose(a.elastic_force, -b.elastic_force, atol=1e-9)
        with self.assertRaisesRegex(taxel.Error, "sisters: must be"):
            taxel.attach(spec, "floor", taxel.FINGERTIP, sisters="both")

    def test_sisters_are_kept_by_request_and_where_they_touch_more(self):
        def hand():
            spec = spec_without_sensor()
            geom = next(g for g in spec.geoms if g.name == "fingertip")
            geom.parent.add_geom(name="core", type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.004, 0, 0], pos=[0, 0, 0.015])
            return spec

        contype = lambda spec: next(g for g in spec.geoms if g.name == "core").contype
        spec = hand()
        taxel.attach(spec, "fingertip", taxel.FINGERTIP, sisters="keep")
        self.assertEqual(contype(spec), 1)
        spec = hand()
        with self.assertWarnsRegex(UserWarning, 'geom "core" .* keeps MuJoCo\'s own contacts'):
            taxel.attach(spec, "fingertip", taxel.FINGERTIP, others=["box"])
        self.assertEqual(contype(spec), 1)
        spec = hand()
        with self.assertWarnsRegex(UserWarning, 'replaces the contacts of what lies within it: "core"'):
            taxel.attach(spec, "fingertip", taxel.FINGERTIP)
        self.assertEqual(contype(spec), 0)

    def test_default_others_collide_with_the_sensor(self):
        spec = spec_without_sensor()
        geom = next(g for g in spec.geoms if g.name == "fingertip")
        geom.contype = geom.conaffinity = 1
        taxel.attach(spec, "fingertip", taxel.FINGERTIP)
        self.assertEqual(bits_of(spec), {"fingertip": ("1", "1")})
        self.assertEqual((geom.contype, geom.conaffinity), (0, 0))
        model, data = simulate(spec)
        self.assertGreater(taxel.readings(model, data)["fingertip taxels"].values.max(), 0)

    def test_a_body_that_is_only_drawn_touches_what_can_collide(self):
        spec = spec_without_sensor()
        taxel.attach(spec, "fingertip", taxel.FINGERTIP)  # contype and conaffinity are 0 in the scene
        self.assertEqual(bits_of(spec), {})
        self.assertGreater(taxel.readings(*simulate(spec))["fingertip taxels"].values.max(), 0)
        spec = spec_without_sensor()
        for geom in spec.geoms:
            geom.contype = geom.conaffinity = 0
        with self.assertRaisesRegex(taxel.Error, "others: no geom can touch the geoms of body"):
            taxel.attach(spec, "fingertip", taxel.FINGERTIP)

    def test_other_geoms_of_the_body_decide_what_is_touched(self):
        spec = spec_without_sensor()
        finger = next(g for g in spec.geoms if g.name == "fingertip").parent
        finger.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.001, 0, 0], contype=2, conaffinity=2)
        for geom in spec.geoms:
            if geom.name == "box":
                geom.name, geom.contype, geom.conaffinity = "", 2, 2
        with self.assertWarnsRegex(UserWarning, "replaces the contacts of what lies within it: of body"):
            taxel.attach(spec, "fingertip", taxel.FINGERTIP)
        self.assertIn("", [geom.name for geom in spec.geoms])
        self.assertEqual(bits_of(spec), {"fingertip": ("2", "2")})
        for geom in spec.geoms:
            if geom.contype == 2 and geom.parent != finger:
                geom.contype = geom.conaffinity = 4
        with self.assertRaisesRegex(taxel.Error, "others: no geom can touch"):
            taxel.attach(spec, "fingertip", taxel.FINGERTIP, prefix="")

    def test_prefix_names_fingers_of_one_kind(self):
        spec = spec_without_sensor()
        next(g for g in spec.geoms if g.name == "fingertip").name = "left_fingertip"
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.delete_taxels([0, 1])
        sensor = taxel.attach(spec, "fingertip", layout, "left_", others=["box"])
        self.assertEqual(sensor.name, "left_fingertip taxels")
        model, data = simulate(spec)
        found = taxel.readings(model, data)["left_fingertip taxels"]
        self.assertEqual(found.ids.tolist(), list(range(2, 12)))
        self.assertEqual(found.geom, "left_fingertip")
        with self.assertRaisesRegex(taxel.Error, "prefix"):
            taxel.attach(spec, "fingertip", layout, "left_", others=["box"])

    def test_mistakes_raise_errors_and_change_nothing(self):
        broken = taxel.Layout.read(taxel.FINGERTIP).to_json().replace('"radius": 0.006', '"radius": -1', 1)
        cases = [("fingertip", {"geom": "thumb"}), ("force", {"force": "push"}), ("output", {"output": ["force"]}),
                 ("others", {"others": ["a b"]}), ("others", {"others": []}),
                 ("/taxels/0/radius", {"layout": taxel.Layout.parse(broken)}), ("absent", {"layout": "absent.taxels.json"})]
        for words, change in cases:
            spec = spec_without_sensor()
            arguments = {"geom": "fingertip", "layout": taxel.FINGERTIP, "others": ["box"], **change}
            with self.subTest(words=words), self.assertRaisesRegex(taxel.Error, words):
                taxel.attach(spec, **arguments)
            self.assertEqual((len(spec.plugins), len(spec.sensors)), (0, 0))

    def test_readings_find_a_geom_that_was_renamed_by_attaching(self):
        """The child names its geom by the key `geom`, and its sensor does not refer to the geom. PyMJCF's prefixes end in /."""
        for prefix in ("left_", "left/"):
            child = spec_without_sensor()
            config = {"layout": str(taxel.FINGERTIP), "geom": "fingertip", "others": "box"}
            child.activate_plugin("taxel.sensor")
            child.add_plugin(name="tip", plugin_name="taxel.sensor", active=True).config = config
            sensor = child.add_sensor(name="taxels", type=mujoco.mjtSensor.mjSENS_PLUGIN)
            sensor.plugin.name, sensor.plugin.plugin_name, sensor.plugin.active = "tip", "taxel.sensor", True
            child.delete(child.actuators[0])
            parent = mujoco.MjSpec()
            parent.option.timestep, parent.option.integrator = child.option.timestep, child.option.integrator
            parent.attach(child, prefix=prefix, frame=parent.worldbody.add_frame())
            model = parent.compile()
            found = taxel.readings(model, mujoco.MjData(model))[f"{prefix}taxels"]
            self.assertEqual((found.geom, len(found.values)), (f"{prefix}fingertip", 12))

    def test_scenes_load_in_any_working_directory(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir("/")
        text = PRESS.read_text()
        instance = text[text.index("<instance") : text.index("</instance>")]
        config = instance.partition(">")[2]
        own = text.replace(f"{instance}</instance>", "").replace(' instance="fingertip"/>', f">{config}</plugin>")
        layout = taxel.FINGERTIP.read_text()
        inside = text.replace("../layouts/fingertip.taxels.json", xml.sax.saxutils.escape(layout, {'"': "&quot;"}))
        peaks = []
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(taxel.EXAMPLES, folder, dirs_exist_ok=True)
            for scene in (text, own, inside):
                file = pathlib.Path(folder) / "scenes" / "other.xml"
                file.write_text(scene)
                model = taxel.load_model(file)
                data = mujoco.MjData(model)
                mujoco.mj_step(model, data, nstep=200)
                peaks.append(taxel.readings(model, data)["fingertip taxels"].values.max())
        self.assertGreater(peaks[0], 1000)
        self.assertEqual(peaks, peaks[:1] * 3)

    def test_plugins_say_their_errors_once(self):
        text = PRESS.read_text().replace('value="box"', 'value="bix"')
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(taxel.EXAMPLES, folder, dirs_exist_ok=True)
            file = pathlib.Path(folder) / "scenes" / "other.xml"
            file.write_text(text)
            with self.assertRaises(ValueError) as caught:
                taxel.load_model(file)
        self.assertEqual(str(caught.exception).count('there is no geom named "bix"'), 1, caught.exception)
        self.assertIn('taxel.sensor "fingertip": others: there', str(caught.exception))

    def test_scenes_without_sensors_have_no_readings(self):
        model = mujoco.MjModel.from_xml_string("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
        self.assertEqual(taxel.readings(model, mujoco.MjData(model)), {})

    def test_process_has_one_mujoco(self):
        taxel.sweep(density=1e5, past=0)
        with open("/proc/self/maps", encoding="utf-8") as maps:
            libraries = {line.split()[-1] for line in maps if "libmujoco.so" in line}
        self.assertEqual(len(libraries), 1)


class LoadPluginTest(unittest.TestCase):
    def test_second_call_does_nothing(self):
        self.assertEqual(taxel.load_plugin(), taxel.load_plugin())

    def test_versions_are_those_of_the_package(self):
        self.assertIn(mujoco.mj_versionString(), taxel.plugin_versions())

    def test_version_without_a_library_is_an_error_with_all_versions(self):
        with mock.patch.object(mujoco, "mj_versionString", lambda: "2.3.7"), mock.patch.object(taxel.plugin, "_loaded", None):
            with self.assertRaises(taxel.Error) as caught:
                taxel.load_plugin()
        for version in ["2.3.7", *taxel.plugin_versions()]:
            self.assertIn(version, str(caught.exception))

    def test_library_that_cannot_be_loaded_is_an_error_with_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "libtaxel_plugin.so"
            whole = bytearray(taxel.load_plugin().read_bytes())
            whole[18:20] = b"\xb7\x00"  # the processor in the header of the file: 64-bit ARM
            file.write_bytes(whole)
            with mock.patch.object(taxel.plugin, "_library_for", lambda _: file), mock.patch.object(taxel.plugin, "_loaded", None):
                with self.assertRaises(taxel.Error) as caught:
                    taxel.load_plugin()
                self.assertIsNone(taxel.plugin._loaded)
        self.assertEqual(caught.exception.file, str(file))
        self.assertIn("processor", caught.exception.message)


if __name__ == "__main__":
    unittest.main()
