#!/usr/bin/env python3
"""Tests sensors that MjSpec.attach() renames, and scenes in memory: attached.py LIBRARY FOLDER

FOLDER was written by `taxel sweep` over a box.
"""
import os
import pathlib
import sys
import tempfile
import unittest
import warnings
import xml.sax.saxutils

import mujoco
import numpy as np

from stepping import sensor_rows

PLUGIN, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
LAYOUT = (FOLDER / "finger.taxels.json").read_text()
ASSETS = {"finger.obj": (FOLDER / "finger.obj").read_bytes()}

# A finger and a small block that moves with its base, as a child that knows nothing of a prefix. {0} is the prefix of
# names, {1} of names in the text of the configuration, {2} the key `geom`, {3} the layout, {4} the reference.
EXTENSION = """
<instance name="{0}tip">
  <config key="layout" value={3}/>{2}
  <config key="others" value="{1}block box"/>
  <config key="materials" value='{{"{1}block": {{"friction": 0.7}}, "*": {{"friction": 0.2}}}}'/>
  <config key="output" value="readings wrench"/>
</instance>"""
SENSOR = """<plugin name="{0}taxels" plugin="taxel.sensor" instance="{0}tip"{4}/>"""
BODIES = """
<body name="{0}block"><geom name="{0}block" type="box" size="0.004 0.004 0.002" pos="0 0.006 0.03" contype="0" conaffinity="0"/></body>
<body name="{0}finger" euler="180 0 0"><joint name="{0}slide" type="slide" axis="0 0 1" damping="5"/>
  <geom name="{0}finger" type="mesh" mesh="{0}finger" mass="0.02" contype="0" conaffinity="0"/></body>"""
MESH = """<mesh name="{0}finger" file="finger.obj" inertia="shell"/>"""
BOX = """<geom name="box" type="box" size="0.2 0.2 0.05" pos="0 0 -0.0765" contype="0" conaffinity="0"/>"""
# The same box as a mesh, of which one triangle faces inwards.
TURNED_BOX = BOX.replace('type="box" size="0.2 0.2 0.05"', 'type="mesh" mesh="box"')
TURNED_MESH = """v -.2 -.2 -.05\nv .2 -.2 -.05\nv .2 .2 -.05\nv -.2 .2 -.05\nv -.2 -.2 .05\nv .2 -.2 .05\nv .2 .2 .05\nv -.2 .2 .05
f 1 2 3\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8
"""
PLACES = {"left_": "0 0.05 0", "right_": "0 -0.05 0.0002"}
REFERENCE = ' objtype="geom" objname="{0}finger"'


def scene(extension, asset, world, sensor):
    return (f'<mujoco><option timestep="0.001"/><extension><plugin plugin="taxel.sensor">{extension}</plugin></extension>'
            f'<asset>{asset}</asset><worldbody>{world}</worldbody><sensor>{sensor}</sensor></mujoco>')


def parts(name, text, key, reference, layout=LAYOUT):
    """Returns extension, asset, bodies and sensor of a finger with a prefix in names and one in the text."""
    values = (name, text, f'<config key="geom" value="{key}"/>' if key else "", xml.sax.saxutils.quoteattr(layout),
              reference.format(name))
    return [piece.format(*values) for piece in (EXTENSION, MESH, BODIES, SENSOR)]


def attached(key, reference):
    """Returns a model with two fingers of one child, each with its prefix."""
    parent = mujoco.MjSpec.from_string(f'<mujoco><option timestep="0.001"/><worldbody>{BOX}</worldbody></mujoco>')
    for prefix, place in PLACES.items():
        child = mujoco.MjSpec.from_string(scene(*parts("", "", key, reference)), assets=ASSETS)
        frame = parent.worldbody.add_frame(pos=[float(x) for x in place.split()])
        parent.attach(child, prefix=prefix, frame=frame)
    parent.assets = {**ASSETS, **parent.assets}
    return parent.compile()


def by_hand(layout=LAYOUT):
    """Returns the text of the same scene, in which each name is written with its prefix."""
    written = [parts(prefix, prefix, prefix + "finger", "", layout) for prefix in PLACES]
    bodies = "".join(f'<frame pos="{place}">{part[2]}</frame>' for part, place in zip(written, PLACES.values()))
    extension, asset, sensor = ("".join(part[i] for part in written) for i in (0, 1, 3))
    return scene(extension, asset, BOX + bodies, sensor)


def run(model, steps=60):
    return sensor_rows(model, mujoco.MjData(model), steps)


class AttachedTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        os.chdir("/")
        cls.expected = run(mujoco.MjModel.from_xml_string(by_hand(), ASSETS))

    def test_the_scene_written_by_hand_is_in_contact(self):
        taxels = self.expected[-1, :12], self.expected[-1, 18:30]
        for readings in taxels:
            self.assertGreater(readings.max(), 500)
        self.assertTrue((taxels[0] != taxels[1]).any())

    def test_two_prefixed_fingers_read_what_the_scene_written_by_hand_reads(self):
        for key, reference in (("finger", ""), ("finger", REFERENCE), ("", REFERENCE)):
            with self.subTest(key=key, reference=reference):
                np.testing.assert_array_equal(run(attached(key, reference)), self.expected)

    def test_a_binary_model_of_a_scene_in_memory_loads_in_another_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "scene.mjb")
            mujoco.mj_saveModel(mujoco.MjModel.from_xml_string(by_hand(), ASSETS), file, None)
            np.testing.assert_array_equal(run(mujoco.MjModel.from_binary_path(file)), self.expected)

    def test_meshes_in_memory_read_nearly_what_their_files_read(self):
        os.chdir(FOLDER)
        from_files = run(mujoco.MjModel.from_xml_string(by_hand("finger.taxels.json"), ASSETS))
        os.chdir("/")
        np.testing.assert_allclose(self.expected, from_files, rtol=0, atol=1e-5 * abs(from_files).max())

    def test_the_repair_of_a_touched_mesh_is_no_error_of_a_compilation(self):
        """MjSpec.compile() of MuJoCo 3.3.7 and 3.8.1 raises an error for each warning: the new mjData has to give it."""
        text = by_hand().replace(BOX, TURNED_BOX).replace("<asset>", '<asset><mesh name="box" file="box.obj" inertia="shell"/>')
        spec = mujoco.MjSpec.from_string(text, assets={**ASSETS, "box.obj": TURNED_MESH.encode()})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # later versions give the warning of a compilation to Python
            model = spec.compile()
        complaints = []
        mujoco.set_mju_user_warning(complaints.append)
        try:
            mujoco.MjData(model)
        finally:
            mujoco.set_mju_user_warning(None)
        self.assertTrue(any('"box": repaired: ' in complaint for complaint in complaints), complaints)

    def test_an_entry_that_contradicts_the_key_is_an_error(self):
        with self.assertRaises(ValueError) as caught:
            attached("thumb", REFERENCE)
        self.assertIn('"thumb"', str(caught.exception))
        self.assertIn('"left_finger"', str(caught.exception))

    def test_a_renamed_geom_is_an_error_that_names_it(self):
        spec = mujoco.MjSpec.from_string(by_hand(), assets=ASSETS)
        geom = next(geom for geom in spec.geoms if geom.name == "left_finger")
        geom.name = "renamed"
        with self.assertRaises(ValueError) as caught:
            spec.compile()
        self.assertIn('no geom named "left_finger"', str(caught.exception))


if __name__ == "__main__":
    mujoco.mj_loadPluginLibrary(PLUGIN)
    unittest.main(argv=sys.argv[:1], verbosity=1)
