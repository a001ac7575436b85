"""A copy of a scene without engine plugins, which MuJoCo's Studio can draw."""

from __future__ import annotations

import typing

import mujoco
import numpy as np

from taxel.errors import Error


def strip_plugins(spec: mujoco.MjSpec, full: mujoco.MjModel) -> None:
    """Removes all engine plugins from a scene whose compiled model is `full`.

    Bodies, joints, geoms, actuators and their order stay, and so do the sizes of qpos, qvel, act and ctrl. Sensors of
    plugins are deleted. A mesh that a plugin makes, as for signed distance functions, becomes its triangles in `full`.
    An actuator of a plugin stays without force and with the activations that it has in `full`.
    """
    for sensor in list(spec.sensors):
        if sensor.type == mujoco.mjtSensor.mjSENS_PLUGIN:
            spec.delete(sensor)
    for mesh in spec.meshes:
        if mesh.plugin.active:
            _keep_triangles(mesh, full)
    for geom in spec.geoms:
        if geom.plugin.active:
            _deactivate(geom)
        if geom.type == mujoco.mjtGeom.mjGEOM_SDF:
            geom.type = mujoco.mjtGeom.mjGEOM_MESH
    for number, actuator in enumerate(spec.actuators):
        if actuator.plugin.active:
            _keep_activations(actuator, full, number)
    for body in spec.bodies:
        if body.plugin.active:
            _deactivate(body)
    for plugin in list(spec.plugins):
        spec.delete(plugin)


def check_same_scene(plain: mujoco.MjModel, full: mujoco.MjModel, first: int, added: int) -> None:
    """Raises Error unless both models have the same bodies, joints, geoms and actuators.

    `plain` has `added` more geoms from number `first` on.
    """
    if plain.nplugin:
        raise Error("", "", f"the scene for the viewer still has {plain.nplugin} engine plugins")
    for size in ("nbody", "njnt", "nq", "nv", "na", "nu", "nmocap"):
        with_plugins, without = getattr(full, size), getattr(plain, size)
        if with_plugins != without:
            raise Error("", "", f"the scene without engine plugins has {size} = {without}, and {with_plugins} with them: "
                                "it cannot be shown in the viewer")
    bodies = np.delete(plain.geom_bodyid, np.arange(first, first + added))
    if not np.array_equal(bodies, full.geom_bodyid):
        raise Error("", "", "the scene without engine plugins has other geoms: it cannot be shown in the viewer")


def _deactivate(element: typing.Any) -> None:
    element.plugin.active = False
    element.plugin.plugin_name = ""
    element.plugin.name = ""


def _keep_triangles(mesh: mujoco.MjsMesh, full: mujoco.MjModel) -> None:
    number = full.mesh(mesh.name).id
    vertices = slice(full.mesh_vertadr[number], full.mesh_vertadr[number] + full.mesh_vertnum[number])
    faces = slice(full.mesh_faceadr[number], full.mesh_faceadr[number] + full.mesh_facenum[number])
    _deactivate(mesh)
    mesh.uservert = full.mesh_vert[vertices].flatten()
    mesh.userface = full.mesh_face[faces].flatten()


def _keep_activations(actuator: mujoco.MjsActuator, full: mujoco.MjModel, number: int) -> None:
    _deactivate(actuator)
    actuator.set_to_motor()
    actuator.gainprm[0] = 0
    if full.actuator_actnum[number] > 0:
        actuator.dyntype = mujoco.mjtDyn.mjDYN_USER
        actuator.actdim = int(full.actuator_actnum[number])
