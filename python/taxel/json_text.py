"""JSON texts of Python values, with arrays and numbers of NumPy."""

from __future__ import annotations

import json
import math
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


def document(value: typing.Any, indent: str = "") -> str:
    """Returns the JSON text of a value with one key on a line, and lists of plain values on one line.

    A number that JSON does not have, such as NaN, becomes null.
    """
    items = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    if not items:
        return _plain_text(value)
    is_nested = isinstance(value, dict) or any(isinstance(item, (dict, list)) for item in items)
    inner = indent + "  "
    texts = [document(item, inner) for item in items]
    if isinstance(value, dict):
        texts = [f"{_plain_text(str(key))}: {text}" for key, text in zip(value, texts)]
    begin, end = "{}" if isinstance(value, dict) else "[]"
    if not is_nested:
        return begin + ", ".join(texts) + end
    return f"{begin}\n{inner}" + f",\n{inner}".join(texts) + f"\n{indent}{end}"


def _plain_text(value: typing.Any) -> str:
    if isinstance(value, float) and not math.isfinite(value):
        return "null"
    return json.dumps(value, ensure_ascii=False, default=_plain)
