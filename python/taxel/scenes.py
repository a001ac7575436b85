"""Sensors in scenes of MuJoCo: attach layouts to an MjSpec, and read running simulations."""

from __future__ import annotations

import copy
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

_WORDS = ("readings", "wrench", "elastic_wrench", "area", "slip", "calibrated")


def attach(
    spec: mujoco.MjSpec,
    geom: mujoco.MjsGeom | str | None = None,
    layout: _core.Layout | str | os.PathLike[str] | None = None,
    prefix: str = "",
    *,
    body: mujoco.MjsBody | str | None = None,
    others: typing.Sequence[str] | None = None,
    materials: typing.Mapping[str, typing.Any] | None = None,
    force: str = "apply",
    output: typing.Sequence[str] = ("readings",),
    tangential_stiffness: float | None = None,
    bristles: int | None = None,
    sisters: str = "replace",
) -> mujoco.MjsSensor:
    """Adds a tactile sensor to a scene: an instance of the plugin `taxel.sensor` on a geom, and its MuJoCo sensor.

    The geom is that of `geom`, or the only mesh of `body` that is drawn; both may be names or objects of the scene. A geom
    without a name gets that of its body. `layout` is a Layout or its file, on the mesh of the geom; if its own mesh file
    is missing, mesh and scale are those of the geom. `prefix` is put before the name of the geom or body and is part of
    the names of the instance and the sensor, so that several fingers of one kind have their own names.
    `others` names the geoms that the sensor touches; by default all geoms of other bodies that MuJoCo lets collide with a
    geom of the sensor's body, or all that can collide if this body is only drawn, also geoms that are added later.
    `materials`, `force` and `output` are the keys of docs/plugin.md; `materials` has its values by geom name.
    `tangential_stiffness` [Pa/m] makes friction stick, remembered by `bristles` points of the skin; without it the
    material of the layout counts.

    With force="apply", the contact type of the geom is set to 0, because MuJoCo's own contact would count twice. So is that
    of the geoms of its body that lie within the skin, which would carry its load, if the sensor touches all that they can
    touch; a Python warning names them. sisters="keep" leaves them. Without `others`, the instance gets these contact types.

    The sensor is named "<geom> taxels". Returns the MuJoCo sensor. Raises Error; the scene is then as before.
    """
    import mujoco

    load_plugin()
    touching = _find_place(spec, geom, body, prefix)
    if sisters not in ("replace", "keep"):
        raise Error("", "sisters", f'must be "replace" or "keep", is "{sisters}"')
    _expect_surface(touching)
    _expect_no_reference_pose(spec, touching)
    if layout is None:
        raise Error("", "layout", "is missing: a Layout or its file")
    layout_text = _layout_text(spec, touching, layout)
    name = touching.name or _name_after_body(spec, touching)
    config = {"layout": layout_text, "geom": name, "output": " ".join(_checked_output(output))}
    if force not in ("apply", "sense"):
        raise Error("", "force", f'must be "apply" or "sense", is "{force}"')
    config["force"] = force
    may_replace = force == "apply" and sisters == "replace" and _has_sisters(spec, touching)
    compiled = _compiled(spec) if others is None or may_replace else None
    if compiled is not None:
        _expect_layout_on_geom(compiled, touching, name, _core.Layout.parse(layout_text))
    touched = _checked_others(spec, touching, others, compiled)
    if others is not None:
        config["others"] = " ".join(others.split() if isinstance(others, str) else others)
    if materials is not None:
        config["materials"] = json_text.dump(materials)
    config.update(_friction_keys(tangential_stiffness, bristles))
    if any(plugin.name == name for plugin in spec.plugins):
        raise Error("", "prefix", f'an instance "{name}" is in the scene already: choose another prefix')
    within: list[mujoco.MjsGeom] = []
    if compiled is not None and may_replace:
        within = compiled.sisters_of(touching, _core.Layout.parse(layout_text))
    touching.name = name
    if force == "apply":
        replaced = _replaceable(spec, touching, within, touched, compiled)
        if others is None:
            config.update(_bits_keys([touching, *replaced]))
        _replace_contacts(spec, touching, replaced)
    if all(plugin.plugin_name != model_plugins.SENSOR for plugin in spec.plugins):
        spec.activate_plugin(model_plugins.SENSOR)
    plugin = spec.add_plugin(name=name, plugin_name=model_plugins.SENSOR, active=True)
    plugin.config = config
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


def _find_place(
    spec: mujoco.MjSpec, geom: mujoco.MjsGeom | str | None, body: mujoco.MjsBody | str | None, prefix: str
) -> mujoco.MjsGeom:
    """Returns the geom of the sensor."""
    if (geom is None) == (body is None):
        raise Error("", "geom", "give either geom or body")
    if geom is not None:
        return _find_geom(spec, prefix + geom) if isinstance(geom, str) else geom
    if isinstance(body, str):
        found = next((one for one in spec.bodies if one.name == prefix + body), None)
        if found is None:
            names = ", ".join(f'"{one.name}"' for one in spec.bodies if one.name)
            raise Error("", "body", f'no body is named "{prefix + body}"; the scene has {names}')
        body = found
    return _mesh_geom_of(body)


def _mesh_geom_of(body: mujoco.MjsBody) -> mujoco.MjsGeom:
    """Returns the only geom of a body with a mesh that is only drawn, otherwise the only one with a mesh."""
    import mujoco

    if not body.geoms:
        raise Error("", "body", f'body "{body.name}" has no geoms, and taxels need one with a mesh')
    first: dict[str, mujoco.MjsGeom] = {}
    drawn: dict[str, mujoco.MjsGeom] = {}
    for geom in body.geoms:
        if geom.type == mujoco.mjtGeom.mjGEOM_MESH:
            first.setdefault(geom.meshname, geom)
            if not (geom.contype or geom.conaffinity):
                drawn.setdefault(geom.meshname, geom)
    for found in (drawn, first):
        if len(found) == 1:
            return next(iter(found.values()))
    if not first:
        raise Error("", "body", f'body "{body.name}" has no geom with a mesh: give one of its geoms as geom')
    raise Error("", "body", f'body "{body.name}" has the meshes {", ".join(first)}: give one of its geoms as geom')


def _name_after_body(spec: mujoco.MjSpec, geom: mujoco.MjsGeom) -> str:
    """Returns a free name for a geom without one: that of its body, with a number if another geom has it."""
    taken = {one.name for one in spec.geoms}
    start = (geom.parent.name or "body").replace(" ", "_").replace(",", "_")
    free = (start if number == 1 else f"{start}_{number}" for number in itertools.count(1))
    return next(name for name in free if name not in taken)


def _expect_surface(geom: mujoco.MjsGeom) -> None:
    """Raises Error for a geom that cannot have a skin."""
    import mujoco

    kinds = {mujoco.mjtGeom.mjGEOM_PLANE: "a plane", mujoco.mjtGeom.mjGEOM_HFIELD: "a height field",
             mujoco.mjtGeom.mjGEOM_SDF: "a signed distance function"}
    if geom.type in kinds:
        raise Error("", "geom", f"geom {_shown(geom)} is {kinds[geom.type]}, which takes no skin: choose a geom with a "
                                "mesh, a box, a sphere, a capsule, a cylinder or an ellipsoid")


def _expect_layout_on_geom(compiled: CompiledSpec, geom: mujoco.MjsGeom, name: str, layout: _core.Layout) -> None:
    """Raises Error if a taxel is farther from the bounds of the geom than a quarter of their diagonal."""
    surface = compiled.surface_of_skin(geom)
    if surface is None or not len(layout):
        return
    low, high = surface.min(axis=0), surface.max(axis=0)
    extent = float(((high - low) ** 2).sum() ** 0.5)
    if not extent > 0:
        raise Error("", "geom", f'geom "{name}" has a surface without area')
    centers = layout.centers
    distance = ((centers - centers.clip(low, high)) ** 2).sum(axis=1) ** 0.5
    if distance.max() > 0.25 * extent:
        raise Error(layout.file, "", f"lies elsewhere: its taxels are up to {1e3 * distance.max():.3g} mm from the geom "
                                     f'"{name}", which is {1e3 * extent:.3g} mm large: it is the layout of another mesh '
                                     "or scale")


def _shown(geom: mujoco.MjsGeom) -> str:
    return f'"{geom.name}"' if geom.name else f'of body "{geom.parent.name}"'


def _find_geom(spec: mujoco.MjSpec, name: str) -> mujoco.MjsGeom:
    for geom in spec.geoms:
        if geom.name == name:
            return geom
    names = ", ".join(f'"{geom.name}"' for geom in spec.geoms if geom.name) or "no geom with a name: give body instead"
    raise Error("", "geom", f'no geom is named "{name}"; the scene has {names}')


def _expect_no_reference_pose(spec: mujoco.MjSpec, geom: mujoco.MjsGeom) -> None:
    """Raises Error if the mesh of the geom is moved by the asset itself, which a compiled model does not keep."""
    for mesh in spec.meshes:
        name = mesh.name or pathlib.PurePath(mesh.file).stem
        if name == geom.meshname and (any(mesh.refpos) or tuple(mesh.refquat) != (1, 0, 0, 0)):
            raise Error("", "geom", f'the mesh "{name}" of geom {_shown(geom)} has refpos or refquat, which a compiled '
                                    "model does not keep: leave both out, and move the geom by its pos and quat instead")


def _has_sisters(spec: mujoco.MjSpec, sensor: mujoco.MjsGeom) -> bool:
    """Returns True if another geom of the sensor's body can collide."""
    return any(geom.parent == sensor.parent and geom != sensor and (geom.contype or geom.conaffinity)
               for geom in spec.geoms)


def _layout_text(
    spec: mujoco.MjSpec, geom: mujoco.MjsGeom, layout: _core.Layout | str | os.PathLike[str]
) -> str:
    """Returns the layout as JSON text, with an absolute mesh file. Raises Error for the first broken rule."""
    if not isinstance(layout, _core.Layout):
        layout = _core.Layout.read(layout)
    mesh = next((one for one in spec.meshes if (one.name or pathlib.PurePath(one.file).stem) == geom.meshname), None)
    if mesh is not None and mesh.file and not pathlib.Path(layout.mesh_file).is_file():
        file = pathlib.Path(spec.modelfiledir) / spec.meshdir / mesh.file
        if file.is_file():
            layout = copy.copy(layout)
            layout.set_value("/mesh/file", str(file.absolute()))
            layout.set_value("/mesh/scale", [float(x) for x in mesh.scale])
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
) -> list[mujoco.MjsGeom]:
    """Returns the touched geoms. Raises Error for a name with a space, and if there are none."""
    if others is None:
        return _default_others(spec, sensor, compiled)
    names = others.split() if isinstance(others, str) else list(others)
    if not names:
        raise Error("", "others", "must name a geom: leave it out for all geoms that collide with the sensor's")
    for name in names:
        if not name or any(character in name for character in " ,\t\n"):
            raise Error("", "others", f'a name must not be empty, and has no space and no comma: "{name}"')
    return [geom for geom in spec.geoms if geom.name in names]


def _compiled(spec: mujoco.MjSpec) -> CompiledSpec | None:
    """Returns None for a scene that cannot be compiled: the user may complete it later, and compiling says what is wrong."""
    try:
        return CompiledSpec(spec)
    except ValueError:
        return None


def _default_others(
    spec: mujoco.MjSpec, sensor: mujoco.MjsGeom, compiled: CompiledSpec | None
) -> list[mujoco.MjsGeom]:
    """Returns the geoms of other bodies that MuJoCo lets collide with a geom of the sensor's body. A body that is only drawn
    touches all geoms that can collide. Skins have the bits of their instances."""
    skins = _bits_of_skins(spec)
    own = [geom for geom in spec.geoms if geom.parent == sensor.parent]
    others = [geom for geom in spec.geoms if geom.parent != sensor.parent]
    others = [geom for geom in others if compiled is None or compiled.can_move(sensor, geom)]
    touched = [geom for geom in others if any(_match(_bits(geom, skins), _bits(one, skins)) for one in own)]
    if not any(any(_bits(one, skins)) for one in own):
        touched = [geom for geom in others if any(_bits(geom, skins))]
    if others and not touched:  # without others, they join the scene later
        raise Error("", "others", f'no geom can touch the geoms of body "{sensor.parent.name}": list the geoms that the '
                                  "sensor touches")
    return touched


def _bits_of_skins(spec: mujoco.MjSpec) -> dict[str, tuple[int, int]]:
    """Returns contype and conaffinity of the instances of the plugin, by the names of their geoms."""
    configs = (dict(plugin.config) for plugin in spec.plugins if plugin.plugin_name == model_plugins.SENSOR)
    return {config.get("geom", ""): (int(config.get("contype") or 0), int(config.get("conaffinity") or 0))
            for config in configs}


def _bits(geom: mujoco.MjsGeom, skins: dict[str, tuple[int, int]]) -> tuple[int, int]:
    contype, conaffinity = skins.get(geom.name, (0, 0)) if geom.name else (0, 0)
    return geom.contype | contype, geom.conaffinity | conaffinity


def _match(a: tuple[int, int], b: tuple[int, int]) -> bool:
    return bool(a[0] & b[1] or b[0] & a[1])


def _bits_keys(geoms: list[mujoco.MjsGeom]) -> dict[str, str]:
    """Returns the keys of a skin that touches everything that the geoms can touch."""
    contype = conaffinity = 0
    for geom in geoms:
        contype, conaffinity = contype | geom.contype, conaffinity | geom.conaffinity
    return {"contype": str(contype), "conaffinity": str(conaffinity)} if contype or conaffinity else {}


def _replaceable(
    spec: mujoco.MjSpec,
    sensor: mujoco.MjsGeom,
    sisters: list[mujoco.MjsGeom],
    touched: list[mujoco.MjsGeom],
    compiled: CompiledSpec | None,
) -> list[mujoco.MjsGeom]:
    """Returns the sisters whose contacts the skin can replace; a warning names them, and another one the others."""
    replaced = []
    for sister in sisters:
        partners = [geom for geom in spec.geoms
                    if _collide(geom, sister) and (compiled is None or compiled.can_move(sister, geom))]
        if all(partner in touched for partner in partners):
            replaced.append(sister)
        else:
            warnings.warn(f'geom {_shown(sister)} lies within the skin on "{sensor.name}" and keeps MuJoCo\'s own '
                          "contacts: it can touch geoms that the skin does not touch", stacklevel=3)
    if replaced:
        names = ", ".join(_shown(one) for one in replaced)
        warnings.warn(f'the skin on "{sensor.name}" replaces the contacts of what lies within it: {names}', stacklevel=3)
    return replaced


def _replace_contacts(spec: mujoco.MjSpec, sensor: mujoco.MjsGeom, sisters: list[mujoco.MjsGeom]) -> None:
    """Takes the contacts of the sensor's geom and its sisters away. Sensors that name a sister touch the skin instead."""
    for geom in (sensor, *sisters):
        geom.contype = geom.conaffinity = 0
    names = {sister.name for sister in sisters if sister.name}
    for plugin in spec.plugins:
        config = dict(plugin.config) if plugin.plugin_name == model_plugins.SENSOR else {}
        listed = config.get("others", "").split()
        if names & set(listed):
            renamed = dict.fromkeys(sensor.name if other in names else other for other in listed)
            plugin.config = {**config, "others": " ".join(renamed)}


def _collide(a: mujoco.MjsGeom, b: mujoco.MjsGeom) -> bool:
    return bool(a.contype & b.conaffinity or b.contype & a.conaffinity)


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
    calibrated: np.ndarray | typing.Any = None
    """Values that a device with the layout's calibration reports, in the order of `ids`, shape (n,); None without
    "calibrated". `values` are the readings before that chain."""


def readings(model: mujoco.MjModel, data: mujoco.MjData) -> dict[str, SensorReadings]:
    """Returns the values of all `taxel.sensor` sensors of a simulation, by the names of the MuJoCo sensors.

    Raises Error if the layout of a sensor cannot be found, or its number of taxels has changed since the model was
    compiled.
    """
    return {sensor.name: read_sensor(sensor, data.sensordata) for sensor in model_plugins.sensors_of(model)}


def read_sensor(sensor: model_plugins.ModelSensor, sensordata: np.ndarray) -> SensorReadings:
    values = force = torque = area = slip = elastic_force = elastic_torque = calibrated = None
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
        elif word == "calibrated":
            calibrated = sensordata[at : at + len(sensor.names)]
            at += len(sensor.names)
    return SensorReadings(sensor.geom, sensor.ids, sensor.names, sensor.unit, values, force, torque, area, slip,
                          elastic_force, elastic_torque, calibrated)
