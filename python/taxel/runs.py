"""Scenarios around a layout: the sweep of the paper, and all other kinds."""

from __future__ import annotations

import os
import pathlib
import tempfile
import typing

from taxel import FINGERTIP, _core, json_text, programs
from taxel import mcap as mcap_files
from taxel.errors import Error

Path = typing.Union[str, "os.PathLike[str]"]
Scenario = typing.Union[Path, typing.Mapping[str, typing.Any]]


def sweep(
    layout: _core.Layout | Path | None = None,
    out: Path | None = None,
    *,
    threads: int | None = None,
    mcap: bool = False,
    **options: typing.Any,
) -> _core.Recording:
    """Slides a finger over an edge that points up, as `taxel sweep` does, and returns the recorded rows.

    `layout` is a Layout or its file; the built-in fingertip by default. `out` is a folder that receives the files of
    `taxel sweep`. `options` are the options of the program with underscores, in SI units and degrees: depth, speed,
    before, past, tilt, record_every, timestep, mass, box, edge_radius, object, density, seed, aggregate, scenario,
    as_in_the_paper. `mcap` also writes readings.mcap into `out`, as taxel.mcap.write() does. The result has one sensor.
    Python's lock is released meanwhile. Raises Error.

        run = taxel.sweep(depth=0.001)
        run.sensors[0].readings.max(axis=0)   # the peak of each taxel [Pa]
    """
    return _record(["sweep"], {}, layout, out, threads, mcap, options)


def play(
    scenario: Scenario,
    layout: _core.Layout | Path | None = None,
    out: Path | None = None,
    *,
    threads: int | None = None,
    mcap: bool = False,
    **options: typing.Any,
) -> _core.Recording:
    """Plays a scenario around a layout, as `taxel play` does, and returns the recorded rows.

    `scenario` is a scenario file (docs/project_format.md), or a dict with its values, whose relative paths are in the
    working directory: {"kind": "press", "depth": 0.001}. `layout`, `out`, `threads` and `mcap` as in sweep(); `options`
    are density, seed and aggregate. Raises Error.
    """
    with tempfile.TemporaryDirectory(prefix="taxel") as folder:
        file = pathlib.Path(folder) / "scenario.json"
        name, text = _read_scenario(scenario)
        file.write_text(_core.scenario_text(text, name), encoding="utf-8")
        return _record(["play", str(file)], {str(file): name}, layout, out, threads, mcap, options)


def _read_scenario(scenario: Scenario) -> tuple[str, str]:
    """Returns the file's name, or an empty text, and the JSON text of a scenario."""
    if isinstance(scenario, typing.Mapping):
        return "", json_text.dump(scenario)
    name = os.fspath(scenario)
    try:
        return name, pathlib.Path(name).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise Error(name, "", f"cannot be read: {error}") from error


def _record(
    arguments: list[str],
    files: dict[str, str],
    layout: _core.Layout | Path | None,
    out: Path | None,
    threads: int | None,
    mcap: bool,
    options: typing.Mapping[str, typing.Any],
) -> _core.Recording:
    if mcap and out is None:
        raise Error("", "mcap", "needs out, the folder for readings.mcap")
    if mcap:
        mcap_files.check_library()  # before a run that may take long
    layout_name = str(FINGERTIP)
    with tempfile.TemporaryDirectory(prefix="taxel") as folder:
        if layout is not None:
            path, layout_name = layout_file(layout, pathlib.Path(folder))
            files = {**files, path: layout_name}
            arguments = [*arguments, "--layout", path]
        results = pathlib.Path(folder) / "run" if out is None else pathlib.Path(out)
        arguments = [*arguments, "--out", str(results), *_options(options)]
        if threads is not None:
            arguments += ["--threads", str(threads)]
        programs.run(arguments, files)
        if mcap:
            mcap_files.write(results, results / "readings.mcap")
        # The meshes of a run without a folder of its own are those of its layout.
        return _core.Recording.read(results, layout_file="" if out is not None else layout_name)


def layout_file(layout: _core.Layout | Path, folder: pathlib.Path) -> tuple[str, str]:
    """Returns the path of a layout's file and its name in messages. A layout in memory is written into `folder`."""
    if not isinstance(layout, _core.Layout):
        path = os.fspath(layout)
        return path, path
    for problem in layout.check(mesh=False):
        if problem.severity == "error":
            raise Error(problem.file, problem.pointer, problem.message)
    path = str(folder / "layout.taxels.json")
    layout.absolute().write(path)
    return path, layout.file


def _options(options: typing.Mapping[str, typing.Any]) -> list[str]:
    """Returns the options of the program: as_in_the_paper=True is --as-in-the-paper, depth=0.001 is --depth 0.001."""
    arguments = []
    for name, value in options.items():
        flag = "--" + name.replace("_", "-")
        if value is True:
            arguments.append(flag)
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            arguments += [flag, repr(value)]
        elif value is not None and value is not False:
            arguments += [flag, os.fspath(value) if isinstance(value, os.PathLike) else str(value)]
    return arguments
