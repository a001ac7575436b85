"""The contact surfaces of the full model, as triangles in the world."""

from __future__ import annotations

import dataclasses

import mujoco
import numpy as np

MOST_TRIANGLES = 10000
"""Most triangles that are read."""


@dataclasses.dataclass(frozen=True, eq=False)
class Surface:
    """The triangles of contact surfaces."""

    corners: np.ndarray
    """Corners in the world [m], shape (n, 3, 3)."""
    colors: np.ndarray
    """Colours of the pressure: red, green, blue and opacity from 0 to 1, shape (n, 4)."""
    geoms: np.ndarray
    """Numbers of the two geoms in contact, in the full model, shape (n, 2)."""
    is_cut: bool = False
    """True if there were more triangles than the reader reads."""

    def __len__(self) -> int:
        return len(self.colors)

    def of(self, geom: int) -> Surface:
        """Returns the surfaces of one geom with all others."""
        own = (self.geoms == geom).any(axis=1)
        return Surface(self.corners[own], self.colors[own], self.geoms[own], self.is_cut)


NO_SURFACE = Surface(np.empty((0, 3, 3)), np.empty((0, 4)), np.empty((0, 2), int))


class SurfaceReader:
    """Reads the contact surfaces that the plugin draws in MuJoCo's visualizer, see docs/plugin.md."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self.model = model
        self._scene = mujoco.MjvScene(model, MOST_TRIANGLES)
        self._camera = mujoco.MjvCamera()
        self._option = mujoco.MjvOption()
        for groups in ("geomgroup", "sitegroup", "jointgroup", "tendongroup", "actuatorgroup", "flexgroup", "skingroup"):
            getattr(self._option, groups)[:] = 0
        self._option.flags[:] = 0
        self._option.flags[mujoco.mjtVisFlag.mjVIS_CONTACTPOINT] = 1

    def read(self, data: mujoco.MjData) -> Surface:
        """Returns the surfaces of the last computed state of `data`."""
        decor = int(mujoco.mjtCatBit.mjCAT_DECOR)
        mujoco.mjv_updateScene(self.model, data, self._option, None, self._camera, decor, self._scene)
        geoms = self._scene.geoms[: self._scene.ngeom]
        shown = [geom for geom in geoms if geom.type == mujoco.mjtGeom.mjGEOM_TRIANGLE]
        if not shown:
            return NO_SURFACE
        first = np.array([geom.pos for geom in shown], float)
        sides = np.array([geom.mat for geom in shown], float)[:, :, :2] * np.array([geom.size for geom in shown])[:, None, :2]
        corners = np.stack([first, first + sides[:, :, 0], first + sides[:, :, 1]], axis=1)
        colors = np.array([geom.rgba for geom in shown], float)
        geoms = np.array([[geom.objid, geom.dataid] for geom in shown])
        return Surface(corners, colors, geoms, is_cut=self._scene.status == 1)


def footprint(surface: Surface) -> np.ndarray:
    """Returns the corners of the triangles from above, shape (n, 3, 2), in mm from the centroid of the surface.

    The plane has the mean normal of the surface. Its first axis is the world's x axis, projected, or the y axis if the
    normal is close to x.
    """
    if len(surface) == 0:
        return np.empty((0, 3, 2))
    a, b, c = surface.corners[:, 0], surface.corners[:, 1], surface.corners[:, 2]
    normals = np.cross(b - a, c - a)
    areas = np.linalg.norm(normals, axis=1)
    total = normals.sum(axis=0)
    size = np.linalg.norm(total)
    normal = total / size if size > 1e-9 * areas.sum() else np.array([0.0, 0.0, 1.0])
    normal *= np.copysign(1, normal[np.argmax(np.abs(normal))])
    axis = np.array([0.0, 1.0, 0.0] if abs(normal[0]) > 0.9 else [1.0, 0.0, 0.0])
    first = axis - normal * (axis @ normal)
    first /= np.linalg.norm(first)
    centroid = (surface.corners.mean(axis=1) * areas[:, None]).sum(axis=0) / areas.sum()
    return 1000 * (surface.corners - centroid) @ np.stack([first, np.cross(normal, first)], axis=1)
