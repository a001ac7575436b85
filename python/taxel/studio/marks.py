"""Marks in the viewer's scene: cylinders and ellipsoids along a line.

MuJoCo's Studio has a list of extra geoms for this purpose, which its page in the browser draws. The renderer of its
window (MuJoCo 4.0.0) crashes some frames after such geoms were replaced. In the window, marks are therefore geoms of the
viewer's model, which move, stretch and change their colour in each frame.
"""

from __future__ import annotations

import dataclasses

import mujoco
import numpy as np

_OBJECTS = 250  # most objects of a scene with its marks
_SIZE = 1e-3  # all sizes of the geom of a mark [m]
_HIDDEN = 1e-3  # scale of the geom of a hidden mark


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


@dataclasses.dataclass(frozen=True)
class MarkCounts:
    """Numbers of the marks in the viewer's model, which come in this order."""

    taxels: int
    """Number of taxels that are drawn at once."""
    forces: int
    """Number of sensors whose force is drawn, each with a shaft and a head."""

    @property
    def total(self) -> int:
        """Number of marks."""
        return self.taxels + 2 * self.forces

    def shapes(self) -> list[mujoco.mjtGeom]:
        """Returns the shape of each mark."""
        force = [mujoco.mjtGeom.mjGEOM_CYLINDER, mujoco.mjtGeom.mjGEOM_ELLIPSOID]
        return [mujoco.mjtGeom.mjGEOM_CYLINDER] * self.taxels + force * self.forces


def count_marks(model: mujoco.MjModel, taxels: int, forces: int) -> MarkCounts:
    """Returns the numbers of marks of `taxels` taxels and `forces` forces for which the renderer has room in `model`.

    A cylinder or a capsule is three objects for the renderer. MuJoCo 4.0.0 leaves out bodies and panels, or crashes, if
    there are more than 256 objects.
    """
    round_geoms = np.isin(model.geom_type, [int(mujoco.mjtGeom.mjGEOM_CYLINDER), int(mujoco.mjtGeom.mjGEOM_CAPSULE)])
    room = max(_OBJECTS - int(model.ngeom + 2 * round_geoms.sum()), 0)
    drawn_forces = min(forces, room // 4)
    return MarkCounts(min(taxels, (room - 4 * drawn_forces) // 3), drawn_forces)


def add_hidden_marks(spec: mujoco.MjSpec, counts: MarkCounts) -> None:
    """Adds one geom of the world for each mark. It touches nothing, has no mass and shines in its own colour.

    A mark that is not shown is tiny and stays opaque, so that the renderer never has to change its material.
    """
    material = spec.add_material(name="taxel marks", emission=0.5, specular=0, shininess=0, reflectance=0)
    for number, shape in enumerate(counts.shapes()):
        spec.worldbody.add_geom(
            name=f"taxel mark {number}",
            type=shape,
            size=[_SIZE] * 3,
            mass=0,
            contype=0,
            conaffinity=0,
            material=material.name,
            rgba=[0.2, 0.2, 0.2, 1],
        )


def show_in_model(marks: list[Mark | None], first: int, model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """Gives the geoms of the viewer's model from number `first` on the places of the marks. None hides a geom.

    The renderer of MuJoCo 4.0.0 draws a geom with the size of its first frame for ever, but with each new matrix. So the
    matrix stretches the geom.
    """
    for geom, mark in enumerate(marks, first):
        if mark is None:
            data.geom_xmat[geom] = (_HIDDEN * np.eye(3)).flatten()
            continue
        center, rotation = mark.pose()
        model.geom_rgba[geom] = mark.color
        data.geom_xpos[geom] = center
        half_axes = np.array([mark.radius, mark.radius, mark.half_length])
        data.geom_xmat[geom] = (rotation * half_axes / _SIZE).flatten()


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
