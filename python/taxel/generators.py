"""Layouts by patterns of taxels, as the window's Generate panel and `taxel generate` make them."""

from __future__ import annotations

import os
import pathlib
import typing
import warnings

from taxel import _core
from taxel.errors import Error

if typing.TYPE_CHECKING:
    import mujoco
    import numpy.typing


def generate(
    source: str | os.PathLike[str] | mujoco.MjSpec,
    pattern: str = "hexagonal",
    *,
    body: str | None = None,
    region: str = "",
    pad: numpy.typing.ArrayLike | None = None,
    distal: numpy.typing.ArrayLike | None = None,
    at: numpy.typing.ArrayLike | None = None,
    scale: float | numpy.typing.ArrayLike | None = None,
    table: str | os.PathLike[str] = "",
    image: str | os.PathLike[str] = "",
    **values: float | int | bool | str,
) -> _core.Layout:
    """Makes a layout by a pattern of taxels on a mesh.

    `source` is a mesh file, or the scene of the mesh of `body`: its only mesh that touches nothing, otherwise its only
    mesh. `values` are the values of the pattern, such as pitch=0.004 or count=24: the options of `taxel generate` with
    `_` in place of `-`, in metres and degrees, or texts with a unit ("4 mm"). `region` limits hexagonal and spread to
    faces, such as "z > 5 mm, ny < -0.3". `pad` and `distal` (3,) are the directions of the touching side and of the tip
    in the frame of the mesh file, and `at` (3,) [m] is the middle of the pattern; by default the shape decides. `scale`
    takes the mesh file to metres; by default its size decides, or the scene. A Python warning names each guess.

    The material is that of the built-in fingertip, a pad of 2 mm with 50 kPa. Raises Error.
    """
    if isinstance(source, (str, os.PathLike)):
        if body is not None:
            raise Error("generate", "body", "needs a scene as source, not a mesh file")
        mesh, factors = pathlib.Path(source), scale
    else:
        if scale is not None:
            raise Error("generate", "scale", "is for a mesh file: a scene gives the scale of its meshes")
        mesh, factors = _mesh_of(source, body)
    if factors is not None and not hasattr(factors, "__len__"):
        factors = (factors,) * 3
    texts = [(_key_of(name), _text_of(value)) for name, value in values.items()]
    layout, _, notes = _core.generate(
        os.fspath(mesh), pattern, texts, region, pad, distal, at, factors, os.fspath(table), os.fspath(image)
    )
    for note in notes:
        warnings.warn(f"{mesh}: {note}", stacklevel=2)
    return layout


def _key_of(name: str) -> str:
    """Returns the key of a field: the angles turn and max_slope may be written without their unit."""
    return f"{name}_deg" if name in ("turn", "max_slope") else name


def _text_of(value: float | int | bool | str) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(float(value)) if isinstance(value, float) else str(value)


def _mesh_of(spec: mujoco.MjSpec, body: str | None) -> tuple[pathlib.Path, tuple[float, ...]]:
    """Returns the mesh file of a body and its scale."""
    if body is None:
        raise Error("generate", "body", "is needed: the scene has several meshes")
    found = next((one for one in spec.bodies if one.name == body), None)
    if found is None:
        names = ", ".join(f'"{one.name}"' for one in spec.bodies if one.name and one.name != "world")
        raise Error("generate", "body", f'no body is named "{body}"; the scene has {names}')
    geoms = [geom for geom in found.geoms if geom.meshname]
    drawn = [geom for geom in geoms if not (geom.contype or geom.conaffinity)]
    names = list(dict.fromkeys(geom.meshname for geom in drawn or geoms))
    if len(names) != 1:
        said = f"has the meshes {', '.join(names)}: give the file of one" if names else "has no geom with a mesh"
        raise Error("generate", "body", f'body "{body}" {said}')
    mesh = spec.mesh(names[0])
    if not mesh.file:
        raise Error("generate", "body", f'the mesh "{names[0]}" of body "{body}" has no file')
    folder = pathlib.Path(getattr(spec, "modelfiledir", "") or "")
    return folder / (spec.meshdir or "") / mesh.file, tuple(float(factor) for factor in mesh.scale)
