"""The MuJoCo model of a fingertip over objects, which all environments of one layout share."""

from __future__ import annotations

import os
import threading
import typing
import weakref

import numpy as np

import taxel
from taxel import model_plugins
from taxel.errors import Error
from taxel.gym.objects import SHAPES

if typing.TYPE_CHECKING:
    import mujoco

#: Largest speed of the fingertip's setpoint along one axis [m/s]: the meaning of an action of 1.
MAX_SPEED = 0.02
#: Largest distance of the fingertip's setpoint from the origin along one axis [m].
REACH = 0.015
#: Time step of the simulation [s].
TIME_STEP = 0.002
#: Number of time steps for one action.
STEPS_PER_ACTION = 10
#: Samples per m^2 of the layout unless density= says otherwise: a fifth of the layout's own, to be made in 0.3 s.
DENSITY = 2e6

# Angle by which the tip is lower than the base of the finger.
_PITCH = np.radians(15.0)
# The stiffness of the servo lets 1 mm of setpoint be 0.4 N. An object that is not used is far below.
_XML = """<mujoco model="taxel fingertip">
  <compiler angle="degree"/>
  <option timestep="{step}" integrator="implicitfast" gravity="0 0 0"/>
  <statistic center="0 0 0" extent="0.06"/>
  <visual><headlight ambient="0.3 0.3 0.3"/><global offwidth="640" offheight="640"/></visual>
  <asset>
    <mesh name="fingertip" file="{mesh}" scale="{scale}" inertia="shell"/>
    <mesh name="grip" file="{grip}"/>
  </asset>
  <default>
    <geom contype="0" conaffinity="0" friction="0.5" rgba="0.35 0.55 0.75 1"/>
    <intvelocity kp="400" dampratio="1" ctrlrange="-{speed} {speed}" actrange="-{reach} {reach}"/>
  </default>
  <worldbody>
    <light pos="-0.1 -0.2 0.4" dir="0.2 0.4 -1"/>
    <camera name="side" pos="0.13 -0.06 0.05" xyaxes="0.42 0.91 0 -0.3 0.14 0.94" fovy="35"/>
    <body name="finger">
      <joint name="x" type="slide" axis="1 0 0"/>
      <joint name="y" type="slide" axis="0 1 0"/>
      <joint name="z" type="slide" axis="0 0 1"/>
      <inertial mass="0.05" pos="0 0 0" diaginertia="5e-6 5e-6 5e-6"/>
      <geom name="fingertip" type="mesh" mesh="fingertip" rgba="0.86 0.7 0.6 1"/>
    </body>
    {objects}
  </worldbody>
  <actuator>
    <intvelocity name="x" joint="x"/>
    <intvelocity name="y" joint="y"/>
    <intvelocity name="z" joint="z"/>
  </actuator>
</mujoco>"""
_OBJECT = '<body name="{0.name}" mocap="true" pos="0 0 {1}"><geom name="{2}" {0.geom}/></body>'

_lock = threading.Lock()
_scenes: weakref.WeakValueDictionary[str, Scene] = weakref.WeakValueDictionary()


class Scene:
    """A compiled model with the columns of its sensor. It never changes, and is shared between environments."""

    def __init__(self, layout: taxel.Layout, name: str) -> None:
        import mujoco

        taxel.load_plugin()
        spec = _spec_of(layout, name)
        taxel.attach(spec, "fingertip", layout, others=[_geom_name(i) for i in range(len(SHAPES))],
                     output=["readings", "wrench", "area"])
        self.layout = layout
        self.model: mujoco.MjModel = spec.compile()
        self.keeper = mujoco.MjData(self.model)
        """Data that keep the compiled layout while no environment has data."""
        (sensor,) = model_plugins.sensors_of(self.model)
        self.sensor = sensor


def scene_of(layout: taxel.Layout | str | os.PathLike[str] | None, density: float | None) -> Scene:
    """Returns the scene of a layout, which is compiled once. Raises Error for a layout that cannot be used."""
    if not isinstance(layout, taxel.Layout):
        layout = taxel.Layout.read(taxel.FINGERTIP if layout is None else layout)
    layout = layout.absolute()
    layout.set_value("/sampling/density", DENSITY if density is None else density)
    if layout.unit not in ("Pa", "N"):
        raise Error(layout.file, "/readout/aggregate", f"must give readings in Pa or N for an environment, gives {layout.unit}")
    with _lock:
        text = layout.to_json()
        scene = _scenes.get(text)
        if scene is None:
            scene = Scene(layout, layout.file)
            _scenes[text] = scene
        return scene


def _geom_name(index: int) -> str:
    return f"object_{index}"


def _spec_of(layout: taxel.Layout, name: str) -> mujoco.MjSpec:
    """Returns the scene without its sensor. The lowest point of the fingertip is at the origin where all joints are 0."""
    import mujoco

    scale = " ".join(repr(float(x)) for x in layout.value("/mesh/scale"))
    objects = "\n    ".join(_OBJECT.format(shape, -1 - 0.2 * i, _geom_name(i)) for i, shape in enumerate(SHAPES))
    # A file's name may have characters that XML gives a meaning: it is set in the MjSpec.
    xml = _XML.format(step=TIME_STEP, speed=MAX_SPEED, reach=REACH, mesh="", grip="", scale=scale, objects=objects)
    spec = mujoco.MjSpec.from_string(xml)
    spec.mesh("fingertip").file = layout.mesh_file
    spec.mesh("grip").file = str(taxel.EXAMPLES / "meshes" / "grip.obj")
    finger = spec.geom("fingertip")
    rotation = _rotation_of(layout)
    try:
        vertices = _vertices_of(spec, mujoco)
    except ValueError as error:
        raise Error(name, "/mesh/file", f"MuJoCo cannot read the mesh: {error}") from error
    rotated = vertices @ rotation.T
    lowest = rotated[rotated[:, 2] < rotated[:, 2].min() + 2e-4]  # the vertices within 0.2 mm of the lowest one
    middle = lowest.mean(axis=0)
    finger.pos = [-middle[0], -middle[1], -rotated[:, 2].min()]
    quaternion = np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, rotation.reshape(9))
    finger.quat = quaternion
    return spec


def _rotation_of(layout: taxel.Layout) -> np.ndarray:
    """Returns the rotation that turns the mesh file's frame so that the pad points down and the tip is lower."""
    pad, distal = (np.asarray(layout.value(f"/frame/{word}"), dtype=float) for word in ("pad", "distal"))
    distal = distal / np.linalg.norm(distal)
    pad = pad - distal * (pad @ distal)
    if np.linalg.norm(pad) < 1e-6:
        raise Error(layout.file, "/frame/pad", "must not be parallel to the distal direction")
    pad = pad / np.linalg.norm(pad)
    source = np.stack([distal, pad, np.cross(distal, pad)], axis=1)
    sine, cosine = np.sin(_PITCH), np.cos(_PITCH)
    new_distal, new_pad = np.array([0, -cosine, -sine]), np.array([0, sine, -cosine])
    return np.stack([new_distal, new_pad, np.cross(new_distal, new_pad)], axis=1) @ source.T


def _vertices_of(spec: mujoco.MjSpec, mujoco: typing.Any) -> np.ndarray:
    """Returns the vertices of the fingertip in the frame of its mesh file [m], shape (n, 3)."""
    model = spec.compile()
    mesh = model.mesh("fingertip")
    rotation = np.zeros(9)
    mujoco.mju_quat2Mat(rotation, model.mesh_quat[mesh.id])
    first, count = int(model.mesh_vertadr[mesh.id]), int(model.mesh_vertnum[mesh.id])
    return model.mesh_vert[first : first + count] @ rotation.reshape(3, 3).T + model.mesh_pos[mesh.id]
