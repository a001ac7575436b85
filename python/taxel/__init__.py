"""Curved tactile sensors with hydroelastic contact for MuJoCo.

    import taxel
    layout = taxel.Layout.read(taxel.FINGERTIP)      # taxels on a mesh: read, check, edit, write
    layout = taxel.generate("finger.stl", pitch=0.004)   # a lattice of taxels on a mesh
    model = taxel.SensorModel(layout)                # samples and receptive fields
    model.read(taxel.Object(body), poses).readings   # readings at many poses of an object, in one call
    run = taxel.sweep(layout)                        # the sweep of `taxel sweep`, as arrays
    taxel.batch(jobs, "data")                        # thousands of runs as one data set
    taxel.attach(spec, "fingertip", layout)          # a sensor in a mujoco.MjSpec
    model = taxel.load_model("scene.xml")            # a scene with sensors, from any folder
    taxel.readings(model, data)                      # readings of a running simulation, by name, with units

All numbers are in SI units: lengths in metres, forces in newtons, pressures in pascals. Positions are in the frame of
the mesh file, unless a name says otherwise. Bad input raises `taxel.Error`, which names the file and the JSON pointer.

Each name is loaded at its first use, so that `import taxel` and `import mujoco` stay quick.
"""

from __future__ import annotations

import importlib
import pathlib
import typing

if typing.TYPE_CHECKING:
    from taxel._core import (
        Calibrator,
        Contact,
        Layout,
        Object,
        PoseReadings,
        Problem,
        Recording,
        SensorModel,
        SensorRecording,
    )
    from taxel.batches import BatchProgress, BatchResult, FailedJob, batch
    from taxel.contacts import contact
    from taxel.errors import Error
    from taxel.fits import fit
    from taxel.generators import generate
    from taxel.materials import material
    from taxel.plugin import load_model, load_plugin, plugin_versions
    from taxel.runs import play, sweep
    from taxel.scenes import SensorReadings, attach, readings

__all__ = [
    "EXAMPLES",
    "FINGERTIP",
    "BatchProgress",
    "BatchResult",
    "Calibrator",
    "Contact",
    "Error",
    "FailedJob",
    "Layout",
    "Object",
    "Observation",
    "PoseReadings",
    "Problem",
    "Recording",
    "SensorModel",
    "SensorReadings",
    "SensorRecording",
    "attach",
    "batch",
    "contact",
    "fit",
    "generate",
    "load_model",
    "load_plugin",
    "material",
    "play",
    "plugin_versions",
    "readings",
    "sweep",
]

#: Folder with the example layouts, meshes and scenes.
EXAMPLES: pathlib.Path = pathlib.Path(__file__).parent / "share" / "taxel"
#: Layout file of the fingertip with the twelve taxels of the paper.
FINGERTIP: pathlib.Path = EXAMPLES / "layouts" / "fingertip.taxels.json"

_MODULES = {
    "taxel._core": (
        "Calibrator",
        "Contact",
        "Layout",
        "Object",
        "PoseReadings",
        "Problem",
        "Recording",
        "SensorModel",
        "SensorRecording",
    ),
    "taxel.batches": ("BatchProgress", "BatchResult", "FailedJob", "Observation", "batch"),
    "taxel.contacts": ("contact",),
    "taxel.errors": ("Error",),
    "taxel.fits": ("fit",),
    "taxel.generators": ("generate",),
    "taxel.materials": ("material",),
    "taxel.plugin": ("load_model", "load_plugin", "plugin_versions"),
    "taxel.runs": ("play", "sweep"),
    "taxel.scenes": ("SensorReadings", "attach", "readings"),
}
_MODULE_OF = {name: module for module, names in _MODULES.items() for name in names}


def __getattr__(name: str) -> typing.Any:
    if name == "__version__":
        return importlib.import_module("taxel._core").__version__
    if name not in _MODULE_OF:
        raise AttributeError(f"module 'taxel' has no attribute {name!r}")
    value = getattr(importlib.import_module(_MODULE_OF[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
