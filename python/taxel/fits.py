"""Fits of layouts and objects to recorded presses of a real sensor."""

from __future__ import annotations

import json
import os
import pathlib
import tempfile
import typing

from taxel import programs

Path = typing.Union[str, "os.PathLike[str]"]


def fit(
    recordings: Path | typing.Sequence[Path],
    *,
    layout: Path,
    case: Path,
    free: typing.Sequence[str] = ("x0", "z0", "gain"),
    start: typing.Mapping[str, float] | None = None,
    fixed: typing.Mapping[str, float] | None = None,
    hold_out: typing.Sequence[Path] = (),
    columns: Path | None = None,
    pose: str | None = None,
    press_axis: str = "z",
    loading_only: bool = True,
    share_gain: bool = False,
    out: Path | None = None,
) -> dict[str, typing.Any]:
    """Fits parameters to recorded presses, as `taxel fit` does, and returns the content of its fit.json.

    `recordings` are tables (CSV) of presses, `case` is a contact case with the object as `b`. `free` names what varies:
    radius, object.radius, thickness, x0, y0, z0 [m], k, gain; `start` and `fixed` give values in SI units. `hold_out`
    are tables to which only zeros and gains are fitted. `columns` is a mapping of the taxels' columns (*.recmap.json),
    `pose` the displacement of 1 in columns without a unit: "x=0.001 mm,z=depth*-1 um". `out` is a folder that also
    gets the points and the charts. Raises taxel.Error, which names file, line and column.

        taxel.fit("presses.csv", layout="strip.taxels.json", case="ball.json", free=["radius", "x0", "z0", "gain"])
    """
    tables = [recordings] if isinstance(recordings, (str, os.PathLike)) else list(recordings)
    arguments = ["fit", *(os.fspath(table) for table in tables), "--layout", os.fspath(layout), "--case", os.fspath(case)]
    arguments += ["--free", ",".join(free), "--press-axis", press_axis, "--part", "loading" if loading_only else "all"]
    for option, values in (("--start", start), ("--fix", fixed)):
        for name, value in (values or {}).items():
            arguments += [option, f"{name}={value!r}"]
    for table in hold_out:
        arguments += ["--hold-out", os.fspath(table)]
    if columns is not None:
        arguments += ["--map", os.fspath(columns)]
    if pose is not None:
        arguments += ["--pose", pose]
    if share_gain:
        arguments += ["--share", "gain"]
    with tempfile.TemporaryDirectory() as temporary:
        folder = os.fspath(out) if out is not None else temporary
        programs.run([*arguments, "--out", folder, "--quiet"], {})
        return json.loads((pathlib.Path(folder) / "fit.json").read_text(encoding="utf-8"))
