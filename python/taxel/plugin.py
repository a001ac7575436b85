"""The MuJoCo plugin: one library for each version of MuJoCo, in lib/taxel/mujoco-VERSION."""

from __future__ import annotations

import pathlib
import platform
import types

from taxel.errors import Error

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


def _library_for(mujoco: types.ModuleType) -> pathlib.Path:
    version = mujoco.mj_versionString()
    libraries = _libraries()
    if version not in libraries:
        known = ", ".join(libraries) or "no version"
        raise Error("", "", f"MuJoCo {version} is installed, but this package has plugins for {known} only: "
                            "install one of these versions")
    return libraries[version]
