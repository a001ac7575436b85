"""JSON texts of Python values, with arrays and numbers of NumPy."""

from __future__ import annotations

import json
import typing


def dump(value: typing.Any) -> str:
    """Returns the JSON text of a value. Raises TypeError for a value that JSON cannot hold, ValueError for NaN."""
    try:
        return json.dumps(value, default=_plain, allow_nan=False)
    except ValueError as error:
        raise ValueError(f"a number must be finite: {error}") from error


def _plain(value: typing.Any) -> typing.Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a value of the type {type(value).__name__} cannot be written as JSON")
