"""Single contacts between two bodies."""

from __future__ import annotations

import os
import pathlib
import typing

from taxel import _core, json_text
from taxel.errors import Error

Case = typing.Union[str, "os.PathLike[str]", typing.Mapping[str, typing.Any]]


def contact(case: Case, model: _core.SensorModel | None = None) -> _core.Contact:
    """Computes the contact of two bodies at given poses.

    `case` is a contact case (docs of `taxel contact`): a file, or a dict with the bodies "a" and "b", whose relative
    paths are in the working directory. With `model`, body a is the model, and `case["a"]` has only its pose and
    velocities; the result then has readings. Python's lock is released meanwhile. Raises Error.

        sphere = {"shape": {"type": "sphere", "size": [0.01]}, "material": {"modulus": 5e4}, "pos": [0, 0, 0.009]}
        taxel.contact({"a": sphere, "b": {"shape": {"type": "plane"}}}).force
    """
    if isinstance(case, (str, os.PathLike)):
        file = os.fspath(case)
        try:
            text = pathlib.Path(file).read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise Error(file, "", f"cannot be read: {error}") from error
        return _core.contact(text, file, model)
    whole = {"format": "contact-case", "version": 1, **case}
    return _core.contact(json_text.dump(whole), "", model)
