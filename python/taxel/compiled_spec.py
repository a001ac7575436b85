"""A scene as MuJoCo compiles it: which geoms can touch a sensor, and which lie within its skin."""

from __future__ import annotations

import typing

import numpy as np

from taxel import _core

if typing.TYPE_CHECKING:
    import mujoco

LEAST_SHARE = 0.5
"""Share of its surface by which a geom must lie within a skin to be its sister. `taxel run` has the same rule."""


class CompiledSpec:
    """A copy of a scene, compiled with all geoms that are only drawn. The scene itself is left as it is.

    Raises ValueError of MuJoCo if the scene cannot be compiled.
    """

    def __init__(self, spec: mujoco.MjSpec) -> None:
        copy = spec.copy()
        copy.compiler.discardvisual = False
        self._model = copy.compile()
        self._ids = {geom: twin.id for geom, twin in zip(spec.geoms, copy.geoms)}

    def can_move(self, a: mujoco.MjsGeom, b: mujoco.MjsGeom) -> bool:
        """Returns True if two geoms can move against each other and are not parent and child, as MuJoCo filters them."""
        import mujoco

        weld = [int(self._model.body_weldid[self._model.geom_bodyid[self._ids[geom]]]) for geom in (a, b)]
        parent = [int(self._model.body_weldid[self._model.body_parentid[body]]) for body in weld]
        if weld[0] == weld[1]:
            return False
        disabled = self._model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_FILTERPARENT
        return bool(disabled) or 0 in weld or (weld[0] != parent[1] and weld[1] != parent[0])

    def surface_of_skin(self, sensor: mujoco.MjsGeom) -> np.ndarray | None:
        """Returns the vertices of the geom's surface in the frame of its mesh file; None for planes and fields."""
        model, own = self._model, self._ids[sensor]
        surface = _surface(model, own)
        if surface is None:
            return None
        to_skin = np.linalg.inv(_pose_of_mesh_file(model, own))
        return surface[0] @ to_skin[:3, :3].T + to_skin[:3, 3]

    def sisters_of(self, sensor: mujoco.MjsGeom, layout: _core.Layout) -> list[mujoco.MjsGeom]:
        """Returns the geoms of the body of `sensor` that can collide and lie within the skin of `layout`."""
        model, own = self._model, self._ids[sensor]
        to_skin = np.linalg.inv(_pose_in_body(model, own) @ _pose_of_mesh_file(model, own))
        found = []
        for geom, one in self._ids.items():
            if one == own or model.geom_bodyid[one] != model.geom_bodyid[own]:
                continue
            surface = _surface(model, one) if model.geom_contype[one] or model.geom_conaffinity[one] else None
            if surface is None:
                continue
            pose = to_skin @ _pose_in_body(model, one)
            if _core.share_within_skin(layout, surface[0] @ pose[:3, :3].T + pose[:3, 3], surface[1]) >= LEAST_SHARE:
                found.append(geom)
        return found


def _transform(position: np.ndarray, quaternion: np.ndarray) -> np.ndarray:
    import mujoco

    rotation = np.zeros(9)
    mujoco.mju_quat2Mat(rotation, quaternion)
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation.reshape(3, 3), position
    return pose


def _pose_in_body(model: mujoco.MjModel, geom: int) -> np.ndarray:
    return _transform(model.geom_pos[geom], model.geom_quat[geom])


def _pose_of_mesh_file(model: mujoco.MjModel, geom: int) -> np.ndarray:
    """Returns the pose of the frame of the mesh file in the geom: MuJoCo moves meshes to their centre and axes."""
    mesh = model.geom_dataid[geom]
    return np.eye(4) if mesh < 0 else np.linalg.inv(_transform(model.mesh_pos[mesh], model.mesh_quat[mesh]))


def _surface(model: mujoco.MjModel, geom: int) -> tuple[np.ndarray, np.ndarray] | None:
    """Returns vertices and triangles of a geom in its frame; None for planes and fields."""
    import mujoco

    kinds = mujoco.mjtGeom
    kind = kinds(int(model.geom_type[geom]))
    if kind in (kinds.mjGEOM_MESH, kinds.mjGEOM_SDF):
        mesh = model.geom_dataid[geom]
        first, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        face, faces = model.mesh_faceadr[mesh], model.mesh_facenum[mesh]
        return model.mesh_vert[first : first + count].astype(float), model.mesh_face[face : face + faces]
    shapes = (kinds.mjGEOM_SPHERE, kinds.mjGEOM_CAPSULE, kinds.mjGEOM_CYLINDER, kinds.mjGEOM_ELLIPSOID, kinds.mjGEOM_BOX)
    if kind not in shapes:
        return None
    return _core.primitive(kind.name.removeprefix("mjGEOM_").lower(), model.geom_size[geom])
