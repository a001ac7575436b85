"""The plugin instances of a compiled MuJoCo model, with their layouts."""

from __future__ import annotations

import ctypes
import dataclasses
import os
import pathlib
import typing
import weakref

from taxel import _core
from taxel.errors import Error

if typing.TYPE_CHECKING:
    import mujoco
    import numpy as np

SENSOR = "taxel.sensor"


@dataclasses.dataclass(frozen=True)
class ModelSensor:
    """One MuJoCo sensor of the plugin `taxel.sensor`."""

    name: str
    address: int
    geom: str
    output: list[str]
    ids: np.ndarray
    names: list[str]
    unit: str
    layout: _core.Layout


class _Plugin(ctypes.Structure):
    """The first members of mjpPlugin, which are the same in all versions of MuJoCo."""

    _fields_ = [
        ("name", ctypes.c_char_p),
        ("nattribute", ctypes.c_int),
        ("attributes", ctypes.POINTER(ctypes.c_char_p)),
    ]


_sensors: weakref.WeakKeyDictionary[typing.Any, list[ModelSensor]] = weakref.WeakKeyDictionary()


def sensors_of(model: mujoco.MjModel) -> list[ModelSensor]:
    """Returns the sensors of a model, which are read once. Raises Error."""
    found = _sensors.get(model)
    if found is None:
        found = _find_sensors(model)
        _sensors[model] = found
    return found


def _find_sensors(model: mujoco.MjModel) -> list[ModelSensor]:
    import mujoco

    sensors = []
    for number in range(model.nsensor):
        instance = int(model.sensor_plugin[number])
        if model.sensor_type[number] != mujoco.mjtSensor.mjSENS_PLUGIN or instance < 0:
            continue
        plugin = _plugin_at(int(model.plugin[instance]))
        if plugin.name.decode() == SENSOR:
            sensors.append(_sensor_of(model, number, _config(model, instance, plugin)))
    return sensors


def _sensor_of(model: mujoco.MjModel, number: int, config: dict[str, str]) -> ModelSensor:
    import mujoco

    if model.sensor_objtype[number] == mujoco.mjtObj.mjOBJ_GEOM and model.sensor_objid[number] >= 0:
        geom = model.geom(int(model.sensor_objid[number])).name  # MuJoCo renames this reference on attaching
    else:
        geom = _geom_of_key(model, number, config.get("geom", ""))
    layout = _find_layout(model, geom, config["layout"])
    output = config["output"].replace(",", " ").split() or ["readings"]
    name = model.sensor(number).name
    sizes = {"readings": len(layout), "wrench": 6, "elastic_wrench": 6, "area": 1, "slip": len(layout),
             "calibrated": len(layout)}
    size = sum(sizes[word] for word in output)
    if size != model.sensor_dim[number]:
        raise Error(layout.file, "", f'the sensor "{name}" of the model has {model.sensor_dim[number]} values, with this '
                                     f"layout it would have {size}: the layout was changed")
    return ModelSensor(name, int(model.sensor_adr[number]), geom, output, layout.ids, layout.names, layout.unit, layout)


def _geom_of_key(model: mujoco.MjModel, sensor: int, name: str) -> str:
    """Returns the geom that the key `geom` names. Attaching puts a prefix before and a suffix behind the names of geoms and
    instances, but not of names in a configuration: the plugin searches a geom in the same way (docs/plugin.md).
    """
    geoms = {model.geom(number).name for number in range(model.ngeom)}
    own = bytes(model.names[model.name_pluginadr[int(model.sensor_plugin[sensor])] :]).split(b"\0")[0].decode()
    shared = len(os.path.commonprefix([own[::-1], (model.sensor(sensor).name or own)[::-1]]))  # a suffix ends both names
    lengths = range(len(own), 0, -1)
    affixes = [("", ""), *((own[:n], "") for n in lengths), *(("", own[-n:]) for n in range(shared, 0, -1))]
    affixes += [(own[:n], own[-after:]) for n in lengths for after in range(min(shared, len(own) - n), 0, -1)]
    found = (prefix + name + suffix for prefix, suffix in affixes)
    return next((one for one in found if one in geoms), name)


def _library() -> ctypes.CDLL:
    """Returns the libmujoco of this process, which `import mujoco` has loaded."""
    with open("/proc/self/maps", encoding="utf-8") as maps:
        for line in maps:
            path = line.split(maxsplit=5)[-1].strip()
            if os.path.basename(path).startswith("libmujoco.so"):
                return ctypes.CDLL(path)
    raise Error("", "", "no libmujoco is loaded in this process")


def _plugin_at(slot: int) -> _Plugin:
    find = _library().mjp_getPluginAtSlot
    find.restype = ctypes.POINTER(_Plugin)
    find.argtypes = [ctypes.c_int]
    return find(slot).contents


def _config(model: mujoco.MjModel, instance: int, plugin: _Plugin) -> dict[str, str]:
    """Returns the configuration of an instance: its values are behind each other in the order of the attributes."""
    values = bytes(model.plugin_attr[model.plugin_attradr[instance] :]).split(b"\0")
    return {plugin.attributes[i].decode(): values[i].decode() for i in range(plugin.nattribute)}


def _find_layout(model: mujoco.MjModel, geom: str, value: str) -> _core.Layout:
    """Returns the layout of a configuration, which is searched in the folders in which the plugin searches it."""
    if value.lstrip().startswith("{"):
        return _core.Layout.parse(value, "layout in the scene")
    folders = _mesh_folders(model, geom)
    for folder in folders:
        if (folder / value).is_file():
            return _core.Layout.read(folder / value)
    own = pathlib.Path(pathlib.PurePath(value).name)
    if own.is_file():  # MuJoCo before 3.17 does not say in which folder its meshes are
        return _core.Layout.read(own)
    tried = ", ".join(str(folder.absolute()) for folder in folders)
    raise Error(value, "", f"not found; folders tried: {tried}")


def _mesh_folders(model: mujoco.MjModel, geom: str) -> list[pathlib.Path]:
    """Returns the folders of the meshes, that of the geom's mesh first, and the working directory."""
    own = int(model.geom(geom).dataid.item())
    meshes = ([own] if own >= 0 else []) + list(range(model.nmesh))
    folders = []
    for mesh in meshes:
        address = int(model.mesh_pathadr[mesh])
        if address >= 0:
            path = bytes(model.paths[address:]).split(b"\0")[0].decode()
            folders.append(pathlib.Path(path).parent)
    return list(dict.fromkeys([*folders, pathlib.Path()]))
