"""A scene in two models: the full one for the simulation, and one without engine plugins for the viewer."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import pathlib

import mujoco
import numpy as np

from taxel import model_plugins
from taxel.errors import Error
from taxel.plugin import load_plugin
from taxel.studio.marks import MarkCounts, add_hidden_marks, count_marks
from taxel.studio.stripping import check_same_scene, strip_plugins


@dataclasses.dataclass(frozen=True)
class ShownSensor:
    """A tactile sensor of a scene, with the places of its taxels."""

    sensor: model_plugins.ModelSensor
    """Name, unit and place in `sensordata`."""
    geom: int
    """Number of the sensor's geom in the full model."""
    centers: np.ndarray
    """Centres of the taxels [m] in the geom's frame, shape (n, 3)."""
    normals: np.ndarray
    """Outward unit normals in the geom's frame, shape (n, 3)."""
    radii: np.ndarray
    """Radii of the receptive fields [m], shape (n,)."""
    origin: np.ndarray
    """Origin of the mesh file's frame [m] in the geom's frame, about which the torque acts, shape (3,)."""

    @property
    def name(self) -> str:
        """Name of the MuJoCo sensor."""
        return self.sensor.name


@dataclasses.dataclass(frozen=True)
class Scene:
    """A scene with tactile sensors. Both models have the same bodies, joints and geoms in the same order.

    The viewer's model also has the marks of the sensors, as the last geoms of the world body.
    """

    path: str
    """Absolute path of the scene's file."""
    full: mujoco.MjModel
    """The model of the simulation, with all engine plugins."""
    plain: mujoco.MjModel
    """The model of the viewer, without engine plugins and without their sensors."""
    sensors: list[ShownSensor]
    """The sensors of the plugin `taxel.sensor`, in the order of `sensordata`."""
    first_mark: int
    """Number of the first mark among the geoms of the viewer's model."""
    marks: MarkCounts
    """Numbers of marks."""

    def plain_geom(self, geom: int) -> int:
        """Returns the number that a geom of the full model has in the viewer's model."""
        return geom if geom < self.first_mark else geom + self.marks.total


def load_scene(path: str | os.PathLike[str]) -> Scene:
    """Loads a scene (XML, URDF or MJZ) in two models. Raises Error.

    It is an error if the file is missing or broken, is a binary model, or has no sensor of the plugin `taxel.sensor`.
    """
    load_plugin()
    file = pathlib.Path(path).absolute()
    if not file.is_file():
        raise Error(str(file), "", "not found" if not file.exists() else "is not a file")
    if file.suffix == ".mjb":
        raise Error(str(file), "", "is a binary model, from which MuJoCo cannot remove the engine plugins: open its XML")
    try:
        return _compile_both(file)
    except Error:
        raise
    except ValueError as error:
        raise Error(str(file), "", str(error)) from error


def _compile_both(file: pathlib.Path) -> Scene:
    with contextlib.ExitStack() as stack:
        options = {}
        if file.suffix in (".mjz", ".zip"):
            options["vfs"] = stack.enter_context(mujoco.MjVfs())
        spec = mujoco.MjSpec.from_file(str(file), **options)
        full = spec.compile(**options)
        sensors = [_shown_sensor(full, sensor) for sensor in model_plugins.sensors_of(full)]
        if not sensors:
            raise Error(str(file), "", f"has no sensor of the plugin {model_plugins.SENSOR}: add one with taxel.attach, "
                                       "or as docs/plugin.md describes")
        strip_plugins(spec, full)
        marks = count_marks(
            full,
            sum(len(sensor.radii) for sensor in sensors if "readings" in sensor.sensor.output),
            sum("wrench" in sensor.sensor.output for sensor in sensors),
        )
        add_hidden_marks(spec, marks)
        plain = spec.compile(**options)
    scene = Scene(str(file), full, plain, sensors, int(full.body_geomnum[0]), marks)
    check_same_scene(scene.plain, full, scene.first_mark, marks.total)
    plain.stat.extent, plain.stat.center[:] = full.stat.extent, full.stat.center
    plain.stat.meansize, plain.stat.meanmass = full.stat.meansize, full.stat.meanmass
    return scene


def _shown_sensor(model: mujoco.MjModel, sensor: model_plugins.ModelSensor) -> ShownSensor:
    """Moves the taxels from the frame M of the mesh file into the frame G of the compiled geom, see docs/plugin.md."""
    geom = int(model.geom(sensor.geom).id)
    mesh = int(model.geom_dataid[geom])
    R_MG, p_MG = np.eye(3), np.zeros(3)
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH and mesh >= 0:
        flat = np.empty(9)
        mujoco.mju_quat2Mat(flat, model.mesh_quat[mesh])
        R_MG, p_MG = flat.reshape(3, 3), model.mesh_pos[mesh]
    layout = sensor.layout
    normals = np.array(layout.normals)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    return ShownSensor(
        sensor, geom, (layout.centers - p_MG) @ R_MG, normals @ R_MG, np.array(layout.radii), -p_MG @ R_MG
    )
