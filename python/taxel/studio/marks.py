"""Marks in the viewer's scene: cylinders and ellipsoids along a line.

MuJoCo's Studio has a list of extra geoms for this purpose, which its page in the browser draws. The renderer of its
window (MuJoCo 4.0.0) crashes some frames after such geoms were replaced. In the window, marks are therefore geoms of the
viewer's model, which move, stretch and change their colour in each frame.
"""

from __future__ import annotations

import dataclasses

import mujoco
import numpy as np

from taxel import model_plugins

_HIDDEN = 1e-6  # size of a hidden mark [m]


@dataclasses.dataclass(frozen=True)
class Mark:
    """A solid whose axis is the line from `start` to `end` [m], in the world."""

    start: np.ndarray
    end: np.ndarray
    radius: float
    """Radius across the axis [m]."""
    color: np.ndarray
    """Red, green, blue and opacity from 0 to 1, shape (4,)."""
    shape: mujoco.mjtGeom = mujoco.mjtGeom.mjGEOM_CYLINDER
    """A cylinder or an ellipsoid."""

    @property
    def half_length(self) -> float:
        """Half of the length of the axis [m]."""
        return 0.5 * float(np.linalg.norm(self.end - self.start))

    def pose(self) -> tuple[np.ndarray, np.ndarray]:
        """Returns the centre (3,) [m] and the rotation (3, 3) whose last column is the direction of the axis."""
        axis = self.end - self.start
        quaternion, rotation = np.empty(4), np.empty(9)
        mujoco.mju_quatZ2Vec(quaternion, axis)
        mujoco.mju_quat2Mat(rotation, quaternion)
        return 0.5 * (self.start + self.end), rotation.reshape(3, 3)


def shapes_of(sensor: model_plugins.ModelSensor) -> list[mujoco.mjtGeom]:
    """Returns the shapes of the marks of a sensor: a cylinder for each taxel, and the shaft and head of its force."""
    taxels = len(sensor.names) if "readings" in sensor.output else 0
    force = [mujoco.mjtGeom.mjGEOM_CYLINDER, mujoco.mjtGeom.mjGEOM_ELLIPSOID] if "wrench" in sensor.output else []
    return [mujoco.mjtGeom.mjGEOM_CYLINDER] * taxels + force


def add_hidden_marks(spec: mujoco.MjSpec, shapes: list[mujoco.mjtGeom]) -> None:
    """Adds one geom of the world for each mark. It touches nothing, has no mass and shines in its own colour.

    A mark that is not shown is tiny and stays opaque, so that the renderer never has to change its material.
    """
    material = spec.add_material(name="taxel marks", emission=0.5, specular=0, shininess=0, reflectance=0)
    for number, shape in enumerate(shapes):
        spec.worldbody.add_geom(
            name=f"taxel mark {number}",
            type=shape,
            size=[_HIDDEN] * 3,
            mass=0,
            contype=0,
            conaffinity=0,
            material=material.name,
            rgba=[0.2, 0.2, 0.2, 1],
        )


def show_in_model(marks: list[Mark | None], first: int, model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Gives the geoms of the viewer's model from number `first` on the places of the marks. None hides a geom."""
    for geom, mark in enumerate(marks, first):
        if mark is None:
            model.geom_size[geom] = _HIDDEN
            continue
        center, rotation = mark.pose()
        model.geom_rgba[geom] = mark.color
        model.geom_size[geom] = _sizes(mark, model.geom_type[geom])
        data.geom_xpos[geom] = center
        data.geom_xmat[geom] = rotation.flatten()


def as_extra_geoms(marks: list[Mark | None]) -> list[mujoco.MjvGeom]:
    """Returns the marks as decorative geoms of MuJoCo's visualizer."""
    geoms = []
    for mark in marks:
        if mark is None:
            continue
        center, rotation = mark.pose()
        geom = mujoco.MjvGeom()
        mujoco.mjv_initGeom(
            geom, int(mark.shape), _sizes(mark, mark.shape), center, rotation.flatten(), mark.color.astype(np.float32)
        )
        geom.emission = 0.5
        geom.category = int(mujoco.mjtCatBit.mjCAT_DECOR)
        geoms.append(geom)
    return geoms


def _sizes(mark: Mark, shape: int) -> np.ndarray:
    """Returns geom_size: radius and half length of a cylinder, or the three half axes of an ellipsoid."""
    if shape == mujoco.mjtGeom.mjGEOM_CYLINDER:
        return np.array([mark.radius, mark.half_length, 0])
    return np.array([mark.radius, mark.radius, mark.half_length])
