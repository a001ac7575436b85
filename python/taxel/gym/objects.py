"""The rigid objects that the fingertip touches, one body in the scene for each shape and size."""

from __future__ import annotations

import dataclasses
import typing

#: Rise of the grip's mesh above its origin [m].
_GRIP_RISE = 0.015
#: Half an edge of the square section of the box, of which one edge points up [m].
_EDGE_HALF = 0.015


@dataclasses.dataclass(frozen=True)
class Shape:
    """One object of one size. The origin of its body is its highest point, and its length is along y."""

    name: str
    kind: str
    geom: str
    """Attributes of the geom in MJCF."""


def _round(kind: str, radius: float) -> Shape:
    """Returns a sphere, or a cylinder that lies along y."""
    size, turn = (f"{radius}", "") if kind == "sphere" else (f"{radius} 0.03", ' euler="90 0 0"')
    return Shape(f"{kind} {1000 * radius:.0f} mm", kind, f'type="{kind}" size="{size}" pos="0 0 {-radius}"{turn}')


SHAPES: tuple[Shape, ...] = (
    *(_round("sphere", radius) for radius in (0.008, 0.012, 0.02)),
    *(_round("cylinder", radius) for radius in (0.006, 0.01, 0.015)),
    Shape("edge", "edge", f'type="box" size="{_EDGE_HALF} 0.03 {_EDGE_HALF}" pos="0 0 {-_EDGE_HALF * 2**0.5}" '
                          'euler="0 45 0"'),
    Shape("grip", "grip", f'type="mesh" mesh="grip" pos="0 0 {-_GRIP_RISE}" euler="0 0 90"'),
)
#: Words for groups of shapes, which objects= and options accept as well as the names of shapes.
KINDS: tuple[str, ...] = tuple(dict.fromkeys(shape.kind for shape in SHAPES))


def choose_shapes(objects: str | typing.Iterable[str] | None, argument: str) -> list[int]:
    """Returns the indices in SHAPES of the objects that these words name, all of them for None.

    Raises ValueError for an unknown word and for no word, TypeError for other values. Both name `argument`.
    """
    if objects is None:
        return list(range(len(SHAPES)))
    words = [objects] if isinstance(objects, str) or not isinstance(objects, typing.Iterable) else list(objects)
    if not all(isinstance(word, str) for word in words):
        raise TypeError(f"{argument} must be a name or names, is {objects!r}")
    names = [*KINDS, *(shape.name for shape in SHAPES if shape.name not in KINDS)]
    for word in words:
        if word not in names:
            raise ValueError(f"{argument}: {word!r} is unknown; the objects are {', '.join(names)}")
    if not words:
        raise ValueError(f"{argument} must name at least one object of {', '.join(names)}")
    return [i for i, shape in enumerate(SHAPES) if shape.kind in words or shape.name in words]
