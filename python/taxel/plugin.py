"""The MuJoCo plugin: one library for each version of MuJoCo, in lib/taxel/mujoco-VERSION."""

from __future__ import annotations

import os
import pathlib
import platform
import types
import typing

from taxel.errors import Error

if typing.TYPE_CHECKING:
    import mujoco

_loaded: pathlib.Path | None = None


def _libraries() -> dict[str, pathlib.Path]:
    folder = pathlib.Path(__file__).parent / "lib" / "taxel"
    libraries = {file.parent.name.removeprefix("mujoco-"): file for file in folder.glob("mujoco-*/libtaxel_plugin.so")}
    newest_first = sorted(libraries, key=lambda version: [int(part) for part in version.split(".")], reverse=True)
    return {version: libraries[version] for version in newest_first}


def plugin_versions() -> list[str]:
    """Returns the versions of MuJoCo for which this package has a plugin, the newest first."""
    return list(_libraries())


def load_plugin() -> pathlib.Path:
    """Loads the plugins `taxel.sensor` and `taxel.contact` into the installed MuJoCo, and returns the library's path.

    MuJoCo 4.0 and later call this function themselves on `import mujoco`. A second call does nothing. Raises Error if the
    package has no library for the installed version of MuJoCo or the library cannot be loaded, and ImportError if MuJoCo
    is not installed.
    """
    global _loaded
    if _loaded is None:
        import mujoco

        library = _library_for(mujoco)
        try:
            mujoco.mj_loadPluginLibrary(str(library))
        except mujoco.FatalError as error:
            raise Error(str(library), "", f"cannot be loaded into MuJoCo {mujoco.mj_versionString()} on a processor of "
                                          f"the type {platform.machine()}: {error}") from error
        _loaded = library
    return _loaded


def load_model(scene: str | os.PathLike[str]) -> mujoco.MjModel:
    """Loads the plugins as load_plugin() does, and the model of a scene (XML, URDF, MJB). Works in any working directory.

    In MuJoCo 3.17 and later this is `mujoco.MjModel.from_xml_path`. Earlier models do not say in which folder their files
    are, so there the layouts of the sensors get absolute paths first. Raises Error, and ValueError of MuJoCo.
    """
    import mujoco

    load_plugin()
    file = os.fspath(scene)
    if file.lower().endswith(".mjb"):
        return mujoco.MjModel.from_binary_path(file)
    if [int(part) for part in mujoco.mj_versionString().split(".")[:2]] >= [3, 17]:
        return mujoco.MjModel.from_xml_path(file)
    from taxel.scenes import make_layouts_absolute

    spec = mujoco.MjSpec.from_file(file)
    make_layouts_absolute(spec, pathlib.Path(file).absolute().parent)
    return spec.compile()


def _library_for(mujoco: types.ModuleType) -> pathlib.Path:
    version = mujoco.mj_versionString()
    libraries = _libraries()
    if version not in libraries:
        versions = ", ".join(libraries) or "no version"
        raise Error("", "", f"MuJoCo {version} is installed, but this package has plugins for {versions} only: "
                            "install one of these versions")
    return libraries[version]
