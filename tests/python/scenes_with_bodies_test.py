"""Tests taxel.attach by bodies: scenes whose geoms have no names, and the hands of MuJoCo Menagerie as they come."""
import json
import os
import pathlib
import tempfile
import unittest
import warnings

import mujoco
import numpy as np

import taxel

HANDS = pathlib.Path(os.environ.get("TAXEL_GOLDEN", "")).resolve().parents[2].parent / "shared" / "real" / "hands"
MESH = taxel.Layout.read(taxel.FINGERTIP).mesh_file
HAND = f"""<mujoco><default><default class="visual"><geom type="mesh" contype="0" conaffinity="0"/></default>
  <default class="collision"><geom type="capsule" size="0.006 0.006" pos="0 0 0.015"/></default></default>
  <asset><mesh name="tip" file="{MESH}"/></asset><worldbody>
  <body name="index" euler="-90 0 0" pos="0 0 0"><geom class="visual" mesh="tip"/><geom class="collision"/></body>
  <body name="two"><geom class="visual" mesh="tip" pos="1 0 0"/><geom type="box" size=".01 .01 .01" pos="2 0 0"/></body>
  <body name="bare"/><body name="boxes"><geom type="box" size=".01 .01 .01" pos="3 0 0"/></body></worldbody></mujoco>"""


def ball_over(spec, place, up=(0, 0, 1), mass=0.02, radius=0.008):
    """Adds a ball that gravity moves along a line through a place of the world, onto the place. Returns its weight."""
    up = np.array(up, float)
    spec.option.gravity = -9.81 * up
    body = spec.worldbody.add_body(name="ball", pos=np.array(place) + (radius - 0.0003) * up)
    joint = body.add_joint(name="fall", type=mujoco.mjtJoint.mjJNT_SLIDE, axis=up)
    joint.damping = [0.5, 0, 0] if hasattr(joint.damping, "__len__") else 0.5  # MuJoCo 4 has polynomials
    body.add_geom(name="ball", type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[radius, 0, 0], mass=mass)
    return mass * 9.81


def quiet_attach(spec, **arguments):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return taxel.attach(spec, **arguments)


def settled(model, key, seconds, up=(0, 0, 1), start=()):
    """Returns the force on a sensor against `up`, averaged over the end of a run from the coordinates `start`."""
    data = mujoco.MjData(model)
    data.qpos[: len(start)] = start
    sensor = taxel.readings(model, data)[key]
    steps, last = int(seconds / model.opt.timestep), int(0.1 * seconds / model.opt.timestep)
    mujoco.mj_step(model, data, nstep=steps - last)
    sum_up = 0.0
    for _ in range(last):
        mujoco.mj_step(model, data)
        sum_up += sensor.force @ np.array(up)
    return -sum_up / last


class BodiesTest(unittest.TestCase):
    def test_the_only_drawn_mesh_of_a_body_gets_the_skin_and_a_name(self):
        spec = mujoco.MjSpec.from_string(HAND)
        with self.assertWarnsRegex(UserWarning, 'skin on "index" replaces .*: of body "index"'):
            sensor = taxel.attach(spec, body="index", layout=taxel.FINGERTIP, output=["wrench"])
        self.assertEqual(sensor.name, "index taxels")
        self.assertEqual([geom.name for geom in spec.geoms if geom.name], ["index"])
        self.assertEqual([geom.contype for geom in spec.geoms], [0, 0, 0, 1, 1])
        weight = ball_over(spec, (0, -0.001, 0.0075))
        self.assertAlmostEqual(settled(spec.compile(), "index taxels", 1.0), weight, delta=0.01 * weight)

    def test_objects_of_the_scene_are_places_too(self):
        for place in ("geom", "body"):
            spec = mujoco.MjSpec.from_string(HAND)
            body = next(one for one in spec.bodies if one.name == "index")
            sensor = quiet_attach(spec, **{place: body if place == "body" else body.geoms[0]}, layout=taxel.FINGERTIP)
            self.assertEqual(sensor.name, "index taxels")

    def test_prefixes_and_suffixes_before_and_after(self):
        found = []
        for order in ("before", "after"):
            child = mujoco.MjSpec.from_string(HAND)
            if order == "after":
                quiet_attach(child, body="index", layout=taxel.FINGERTIP, output=["wrench"])
            parent = mujoco.MjSpec()
            parent.attach(child, prefix="left/", suffix="_l", frame=parent.worldbody.add_frame())
            if order == "before":
                quiet_attach(parent, body="index_l", prefix="left/", layout=taxel.FINGERTIP, output=["wrench"])
            weight = ball_over(parent, (0, -0.001, 0.0075))  # joins the scene after the sensor
            model = parent.compile()
            (key,) = taxel.readings(model, mujoco.MjData(model))
            found.append(settled(model, key, 1.0))
            self.assertAlmostEqual(found[-1], weight, delta=0.01 * weight)
        self.assertEqual(found[0], found[1])

    def test_the_mesh_of_the_geom_takes_the_place_of_a_missing_one(self):
        with tempfile.TemporaryDirectory() as name:
            layout = json.loads(taxel.FINGERTIP.read_text())
            layout["mesh"] = {"file": "gone.obj"}
            file = pathlib.Path(name) / "tip.taxels.json"
            file.write_text(json.dumps(layout))
            spec = mujoco.MjSpec.from_string(HAND)
            quiet_attach(spec, body="index", layout=file)
            (plugin,) = (one for one in spec.plugins if one.name)
            self.assertEqual(json.loads(plugin.config["layout"])["mesh"]["file"], MESH)

    def test_mistakes_are_named(self):
        far = taxel.Layout.read(taxel.FINGERTIP)
        far.centers = far.centers + [0.05, 0, 0]
        cases = [({"body": "bare"}, 'body "bare" has no geoms'), ({"body": "boxes"}, 'body "boxes" has no geom with a mesh'),
                 ({"body": "thumb"}, 'no body is named "thumb"; the scene has .*"index"'), ({}, "give either geom or body"),
                 ({"body": "index", "geom": "x"}, "give either geom or body"), ({"geom": "x"}, 'no geom is named "x"'),
                 ({"body": "index", "layout": None}, "layout: is missing"),
                 ({"body": "index", "layout": far}, 'lies elsewhere: its taxels are up to .* mm from the geom "index"')]
        for arguments, words in cases:
            spec = mujoco.MjSpec.from_string(HAND)
            with self.subTest(words=words), self.assertRaisesRegex(taxel.Error, words):
                taxel.attach(spec, **{"layout": taxel.FINGERTIP, **arguments})
            self.assertEqual([(geom.name, geom.contype) for geom in spec.geoms], [("", 0), ("", 1), ("", 0), ("", 1), ("", 1)])
            self.assertEqual((len(spec.plugins), len(spec.sensors)), (0, 0))
        spec = mujoco.MjSpec.from_string("<mujoco><worldbody><geom name='floor' type='plane' size='1 1 1'/></worldbody></mujoco>")
        with self.assertRaisesRegex(taxel.Error, 'geom "floor" is a plane, which takes no skin'):
            taxel.attach(spec, "floor", taxel.FINGERTIP)


def layout_on(mesh, scale, center, normal):
    """Returns a layout of one taxel on a mesh of a hand."""
    layout = json.loads(taxel.FINGERTIP.read_text())
    layout["mesh"] = {"file": str(mesh), "scale": [scale] * 3}
    layout["sampling"]["density"] = 2e5
    layout["taxels"] = [{"id": 0, "center": list(map(float, center)), "normal": normal, "radius": 0.005}]
    return taxel.Layout.parse(json.dumps(layout))


HANDS_OF_MENAGERIE = [
    ("shadow_hand", [f"rh_{name}distal" for name in ("ff", "mf", "rf", "lf", "th")], 0.001, [0.0, -1.0, 0.0]),
    ("wonik_allegro", ["ff_tip", "mf_tip", "rf_tip", "th_tip"], 1, [1.0, 0.0, 0.0])]


@unittest.skipUnless(HANDS.is_dir(), f"{HANDS} is absent")
class HandsTest(unittest.TestCase):
    """The weight of a ball on each fingertip of hands whose files stay as they are."""

    def weigh(self, name, tip, scale, normal):
        spec = mujoco.MjSpec.from_file(str(HANDS / name / "right_hand.xml"))
        for body in spec.bodies:
            body.gravcomp = 1
        model = spec.compile()
        data = mujoco.MjData(model)
        mujoco.mj_step(model, data, nstep=500)  # some joints start beyond their limits
        data.qvel[:] = 0
        mujoco.mj_forward(model, data)
        own = model.body(tip).geomadr.item()
        mesh = int(model.geom_dataid[own])
        first, turn = model.mesh_vertadr[mesh], np.zeros(9)
        compiled = model.mesh_vert[first : first + model.mesh_vertnum[mesh]].astype(float)
        mujoco.mju_quat2Mat(turn, model.mesh_quat[mesh])
        vertices = compiled @ turn.reshape(3, 3).T + model.mesh_pos[mesh]  # as in the file
        end = np.flatnonzero(vertices[:, 2] > vertices[:, 2].mean())
        lowest = end[np.argmax(vertices[end] @ np.array(normal))]
        to_world = data.geom_xmat[own].reshape(3, 3)
        file = HANDS / name / "assets" / spec.meshes[mesh].file
        sensor = quiet_attach(spec, body=tip, layout=layout_on(file, scale, vertices[lowest], normal), output=["wrench"])
        self.assertEqual(sensor.name, f"{tip} taxels")
        self.assertEqual([one.name for one in spec.geoms if one.name], [tip])
        up = to_world @ turn.reshape(3, 3).T @ np.array(normal)
        weight = ball_over(spec, data.geom_xpos[own] + to_world @ compiled[lowest], up)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # the mesh of a touched link is repaired
                model = spec.compile()
        except ValueError as error:
            if mujoco.__version__.startswith("3.3.") and "repaired" in str(error):
                self.skipTest("MjSpec.compile() of MuJoCo 3.3 takes a warning for an error: the palm has been repaired")
            raise
        self.assertAlmostEqual(settled(model, sensor.name, 1.0, up, data.qpos) / weight, 1, delta=0.01)

    def test_each_fingertip_carries_a_ball(self):
        for name, tips, scale, normal in HANDS_OF_MENAGERIE:
            for tip in tips:
                with self.subTest(tip=tip):
                    self.weigh(name, tip, scale, normal)


if __name__ == "__main__":
    unittest.main()
