"""Sensors in scenes of MuJoCo: attach layouts to an MjSpec, and read running simulations."""

from __future__ import annotations

import dataclasses
import itertools
import os
import pathlib
import typing
import warnings

from taxel import _core, json_text, model_plugins
from taxel.compiled_spec import CompiledSpec
from taxel.errors import Error
from taxel.plugin import load_plugin

if typing.TYPE_CHECKING:
    import mujoco
    import numpy as np

_WORDS = ("readings", "wrench", "elastic_wrench", "area", "slip")


def attach(
    spec: mujoco.MjSpec,
    geom: str,
    layout: _core.Layout | str | os.PathLike[str],
    prefix: str = "",
    *,
    others: typing.Sequence[str] | None = None,
    materials: typing.Mapping[str, typing.Any] | None = None,
    force: str = "apply",
    output: typing.Sequence[str] = ("readings",),
    tangential_stiffness: float | None = None,
    bristles: int | None = None,
    sisters: str = "replace",
) -> mujoco.MjsSensor:
    """Adds a tactile sensor to a scene: an instance of the plugin `taxel.sensor` on a geom, and its MuJoCo sensor.

    `geom` is the name of the geom that has the mesh of `layout`, a Layout or its file. `prefix` is put before `geom` and
    is part of the names of the instance and the sensor, so that several fingers of one kind have their own names.
    `others` names the geoms that the sensor touches; by default all geoms of other bodies that MuJoCo lets collide with a
    geom of the sensor's body, or all that can collide if this body is only drawn. Those without a name get one. `materials`, `force` and `output` are the keys of docs/plugin.md; `materials` has its values by geom name.
    `tangential_stiffness` [Pa/m] makes friction stick, remembered by `bristles` points of the skin; without it the
    material of the layout counts.

    With force="apply", the contact type of the geom is set to 0, because MuJoCo's own contact would count twice. So is that
    of the geoms of its body that lie within the skin, which would carry its load, if the sensor touches all that they can
    touch; a Python warning names them. sisters="keep" leaves them.

    The sensor is named "<prefix><geom> taxels". Returns the MuJoCo sensor. Raises Error.
    """
    import mujoco

    load_plugin()
    name = prefix + geom
    touching = _find_geom(spec, name)
    _expect_no_reference_pose(spec, touching)
    if sisters not in ("replace", "keep"):
        raise Error("", "sisters", f'must be "replace" or "keep", is "{sisters}"')
    layout_text = _layout_text(layout)
    config = {"layout": layout_text, "geom": name, "output": " ".join(_checked_output(output))}
    if force not in ("apply", "sense"):
        raise Error("", "force", f'must be "apply" or "sense", is "{force}"')
    config["force"] = force
    may_replace = force == "apply" and sisters == "replace" and _has_sisters(spec, touching)
    compiled = _compiled(spec) if others is None or may_replace else None
    touched = _checked_others(spec, touching, others, compiled)
    within: list[mujoco.MjsGeom] = []
    if compiled is not None and may_replace:
        within = compiled.sisters_of(touching, _core.Layout.parse(layout_text))
    if others is None:
        touched += _sensors_touching(spec, {name, *(_name_of(spec, sister) for sister in within)}, touched)
    config["others"] = " ".join(touched)
    if materials is not None:
        config["materials"] = json_text.dump(materials)
    config.update(_friction_keys(tangential_stiffness, bristles))
    if any(plugin.name == name for plugin in spec.plugins):
        raise Error("", "prefix", f'an instance "{name}" is in the scene already: choose another prefix')
    if all(plugin.plugin_name != model_plugins.SENSOR for plugin in spec.plugins):
        spec.activate_plugin(model_plugins.SENSOR)
    plugin = spec.add_plugin(name=name, plugin_name=model_plugins.SENSOR, active=True)
    plugin.config = config
    if force == "apply":
        _replace_sisters(spec, touching, within, touched, compiled)
        touching.contype = touching.conaffinity = 0
    sensor = spec.add_sensor(
        name=f"{name} taxels",
        type=mujoco.mjtSensor.mjSENS_PLUGIN,
        objtype=mujoco.mjtObj.mjOBJ_GEOM,
        objname=name,
    )
    sensor.plugin = plugin
    sensor.plugin.name = name
    sensor.plugin.active = True
    return sensor


def make_layouts_absolute(spec: mujoco.MjSpec, folder: pathlib.Path) -> None:
    """Gives the layouts of all sensors absolute paths. `folder` is that of the scene.

    The plugin searches a layout in the folders of the meshes (docs/plugin.md), which MuJoCo before 3.17 does not tell it.
    """
    meshes = [folder / spec.meshdir / mesh.file for mesh in spec.meshes if mesh.file]
    folders = list(dict.fromkeys([*(mesh.parent for mesh in meshes), folder]))
    for plugin in _sensor_plugins(spec):
        config = dict(plugin.config)
        found = _find_layout(config.get("layout", ""), folders)
        if found is not None:
            plugin.config = {**config, "layout": found}


def _sensor_plugins(spec: mujoco.MjSpec) -> list[mujoco.MjsPlugin]:
    """Returns the instances of the plugin, and the sensors with a configuration of their own.

    MuJoCo 3 crashes if the configuration of a sensor is read that refers to an instance.
    """
    own = (sensor.plugin for sensor in spec.sensors if sensor.plugin.plugin_name == model_plugins.SENSOR)
    named = [plugin for plugin in spec.plugins if plugin.plugin_name == model_plugins.SENSOR]
    return [*named, *(plugin for plugin in own if not plugin.name)]


def _find_layout(value: str, folders: list[pathlib.Path]) -> str | None:
    """Returns the value of the key `layout` with an absolute path; None for an absolute one, or if no folder has it."""
    for folder in folders:
        if value.lstrip().startswith("{"):
            layout = _core.Layout.parse(value, folder / "layout in the scene")
            if pathlib.Path(layout.mesh_file).is_file():
                return layout.absolute().to_json()
        elif value and (folder / value).is_file():
            return os.path.normpath(folder / value)
    return None


def _find_geom(spec: mujoco.MjSpec, name: str) -> mujoco.MjsGeom:
    for geom in spec.geoms:
        if geom.name == name:
            return geom
    names = ", ".join(f'"{geom.name}"' for geom in spec.geoms if geom.name) or "no geom with a name"
    raise Error("", "geom", f'no geom is named "{name}"; the scene has {names}')


def _expect_no_reference_pose(spec: mujoco.MjSpec, geom: mujoco.MjsGeom) -> None:
    """Raises Error if the mesh of the geom is moved by the asset itself, which a compiled model does not keep."""
    for mesh in spec.meshes:
        name = mesh.name or pathlib.PurePath(mesh.file).stem
        if name == geom.meshname and (any(mesh.refpos) or tuple(mesh.refquat) != (1, 0, 0, 0)):
            raise Error("", "geom", f'the mesh "{name}" of geom "{geom.name}" has refpos or refquat, which a compiled '
                                    "model does not keep: leave both out, and move the geom by its pos and quat instead")


def _has_sisters(spec: mujoco.MjSpec, sensor: mujoco.MjsGeom) -> bool:
    """Returns True if another geom of the sensor's body can collide."""
    return any(geom.parent == sensor.parent and geom.name != sensor.name and (geom.contype or geom.conaffinity)
               for geom in spec.geoms)


def _layout_text(layout: _core.Layout | str | os.PathLike[str]) -> str:
    """Returns the layout as JSON text, with an absolute mesh file. Raises Error for the first broken rule."""
    if not isinstance(layout, _core.Layout):
        layout = _core.Layout.read(layout)
    for problem in layout.check(mesh=False):
        if problem.severity == "error":
            raise Error(problem.file, problem.pointer, problem.message)
    return layout.absolute().to_json()


def _friction_keys(tangential_stiffness: float | None, bristles: int | None) -> dict[str, str]:
    """Returns the keys of friction that sticks. The plugin checks their values."""
    if tangential_stiffness is None:
        if bristles is not None:
            raise Error("", "bristles", "is only for friction that sticks: give tangential_stiffness as well")
        return {}
    keys = {"tangential_stiffness": repr(float(tangential_stiffness))}
    if bristles is not None:
        keys["bristles"] = str(bristles)
    return keys


def _checked_output(output: typing.Sequence[str]) -> list[str]:
    words = output.split() if isinstance(output, str) else list(output)
    for word in words:
        if word not in _WORDS:
            raise Error("", "output", f'must have words of {", ".join(_WORDS)}, has "{word}"')
    if not words:
        raise Error("", "output", f"must have at least one word of {', '.join(_WORDS)}")
    return words


def _checked_others(
    spec: mujoco.MjSpec,
    sensor: mujoco.MjsGeom,
    others: typing.Sequence[str] | None,
    compiled: CompiledSpec | None,
) -> list[str]:
    """Returns the names of the touched geoms. Raises Error for a name with a space, and for geoms without a name."""
    if others is None:
        return _default_others(spec, sensor, compiled)
    names = [others] if isinstance(others, str) else list(others)
    if not names:
        raise Error("", "others", "must name a geom: leave it out for all geoms that collide with the sensor's")
    for name in names:
        if not name or any(character in name for character in " ,\t\n"):
            raise Error("", "others", f'a name must not be empty, and has no space and no comma: "{name}"')
    return names


def _compiled(spec: mujoco.MjSpec) -> CompiledSpec | None:
    """Returns None for a scene that cannot be compiled: the user may complete it later, and compiling says what is wrong."""
    try:
        return CompiledSpec(spec)
    except ValueError:
        return None


def _default_others(spec: mujoco.MjSpec, sensor: mujoco.MjsGeom, compiled: CompiledSpec | None) -> list[str]:
    """Returns the names of the geoms of other bodies that MuJoCo lets collide with a geom of the sensor's body. A body that
    is only drawn touches all geoms that can collide. Geoms without a name get one."""
    own = [geom for geom in spec.geoms if geom.parent == sensor.parent]
    others = [geom for geom in spec.geoms if geom.parent != sensor.parent]
    others = [geom for geom in others if compiled is None or compiled.can_move(sensor, geom)]
    touched = [geom for geom in others if any(_collide(geom, one) for one in own)]
    if not any(one.contype or one.conaffinity for one in own):
        touched = [geom for geom in others if geom.contype or geom.conaffinity]
    if not touched:
        raise Error("", "others", f'no geom can touch the geoms of body "{sensor.parent.name}": list the geoms that the '
                                  "sensor touches")
    return [_name_of(spec, geom) for geom in touched]


def _sensors_touching(spec: mujoco.MjSpec, geoms: set[str], listed: list[str]) -> list[str]:
    """Returns the geoms of sensors that touch one of `geoms` by their configuration, except `listed` ones."""
    found = []
    for plugin in spec.plugins:
        if plugin.plugin_name == model_plugins.SENSOR and geoms & set(dict(plugin.config).get("others", "").split()):
            found.append(dict(plugin.config).get("geom", ""))
    return [one for one in dict.fromkeys(found) if one and one not in listed]


def _replace_sisters(
    spec: mujoco.MjSpec,
    sensor: mujoco.MjsGeom,
    sisters: list[mujoco.MjsGeom],
    touched: list[str],
    compiled: CompiledSpec | None,
) -> None:
    """Takes the contacts of sister geoms away, and lets other sensors touch the sensor in their place."""
    replaced = []
    for sister in sisters:
        partners = {geom.name for geom in spec.geoms
                    if _collide(geom, sister) and (compiled is None or compiled.can_move(sister, geom))}
        if not partners <= set(touched):
            warnings.warn(f'geom "{sister.name}" lies within the skin on "{sensor.name}" and keeps MuJoCo\'s own contacts: '
                          "it can touch geoms that the skin does not touch", stacklevel=3)
            continue
        sister.contype = sister.conaffinity = 0
        replaced.append(sister.name)
    if not replaced:
        return
    names = ", ".join(f'"{one}"' for one in replaced)
    warnings.warn(f'the skin on "{sensor.name}" replaces the contacts of what lies within it: {names}', stacklevel=3)
    for plugin in spec.plugins:
        config = dict(plugin.config) if plugin.plugin_name == model_plugins.SENSOR else {}
        others = config.get("others", "").split()
        if set(replaced) & set(others):
            renamed = dict.fromkeys(sensor.name if other in replaced else other for other in others)
            plugin.config = {**config, "others": " ".join(renamed)}


def _collide(a: mujoco.MjsGeom, b: mujoco.MjsGeom) -> bool:
    return bool(a.contype & b.conaffinity or b.contype & a.conaffinity)


def _name_of(spec: mujoco.MjSpec, geom: mujoco.MjsGeom) -> str:
    """Returns the name of a geom. One without a name gets the first free one of its body: "palm_geom", "palm_geom_2"."""
    taken = {one.name for one in spec.geoms}
    start = f"{geom.parent.name or 'body'}_geom".replace(" ", "_").replace(",", "_")
    free = (start if number == 1 else f"{start}_{number}" for number in itertools.count(1))
    geom.name = geom.name or next(name for name in free if name not in taken)
    return geom.name


@dataclasses.dataclass(frozen=True)
class SensorReadings:
    """The values of one sensor in a running simulation. Arrays are views of `data.sensordata`, which change with it.

    What the sensor's output lacks is None. The types say Any, so that type checkers allow `sensor.values.max()`.
    """

    geom: str
    """Name of the sensor's geom."""
    ids: np.ndarray
    """Ids of the taxels, shape (n,)."""
    names: list[str]
    """Names of the taxels."""
    unit: str
    """Unit of `values`: Pa, Pa m^2 or N."""
    values: np.ndarray | typing.Any
    """Readings in the order of `ids`, shape (n,); None without "readings" in the sensor's output."""
    force: np.ndarray | typing.Any
    """Force on the sensor [N], world axes, shape (3,); None without "wrench"."""
    torque: np.ndarray | typing.Any
    """Torque about the origin of the mesh file's frame [N m], world axes, shape (3,); None without "wrench"."""
    area: float | typing.Any
    """Area of the contact surfaces [m^2]; None without "area"."""
    slip: np.ndarray | typing.Any = None
    """Share of each taxel's touched field that slips, from 0 to 1, in the order of `ids`, shape (n,); None without "slip"."""
    elastic_force: np.ndarray | typing.Any = None
    """Force of the elastic pressure alone [N], without damping and friction, shape (3,); None without "elastic_wrench"."""
    elastic_torque: np.ndarray | typing.Any = None
    """Torque of the elastic pressure alone [N m], like `torque`, shape (3,); None without "elastic_wrench"."""


def readings(model: mujoco.MjModel, data: mujoco.MjData) -> dict[str, SensorReadings]:
    """Returns the values of all `taxel.sensor` sensors of a simulation, by the names of the MuJoCo sensors.

    Raises Error if the layout of a sensor cannot be found, or its number of taxels has changed since the model was
    compiled.
    """
    return {sensor.name: read_sensor(sensor, data.sensordata) for sensor in model_plugins.sensors_of(model)}


def read_sensor(sensor: model_plugins.ModelSensor, sensordata: np.ndarray) -> SensorReadings:
    values = force = torque = area = slip = elastic_force = elastic_torque = None
    at = sensor.address
    for word in sensor.output:
        if word == "readings":
            values = sensordata[at : at + len(sensor.names)]
            at += len(sensor.names)
        elif word == "wrench":
            force, torque = sensordata[at : at + 3], sensordata[at + 3 : at + 6]
            at += 6
        elif word == "elastic_wrench":
            elastic_force, elastic_torque = sensordata[at : at + 3], sensordata[at + 3 : at + 6]
            at += 6
        elif word == "area":
            area = float(sensordata[at])
            at += 1
        elif word == "slip":
            slip = sensordata[at : at + len(sensor.names)]
            at += len(sensor.names)
    return SensorReadings(sensor.geom, sensor.ids, sensor.names, sensor.unit, values, force, torque, area, slip,
                          elastic_force, elastic_torque)
