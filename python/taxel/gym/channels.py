"""The numbers of an observation: their names, units and scales."""

from __future__ import annotations

import dataclasses
import typing

import numpy as np


@dataclasses.dataclass(frozen=True)
class Channel:
    """One number of an observation, which is the quantity divided by `scale`, cut off at `low` and 1."""

    name: str
    unit: str
    scale: float
    low: float = -1.0
    """-1, or 0 for a quantity that is never negative."""

    def as_dict(self) -> dict[str, typing.Any]:
        """Returns name, unit and scale, as they are in the metadata of an environment."""
        return {"name": self.name, "unit": self.unit, "scale": self.scale}


def of_axes(name: str, unit: str, scale: float) -> list[Channel]:
    """Returns one channel for each axis of the world."""
    return [Channel(f"{name} {axis}", unit, scale) for axis in "xyz"]


def normalise(channels: typing.Sequence[Channel], values: np.ndarray) -> np.ndarray:
    """Returns float32 observations of quantities in their units. Both are of the shape (environments, channels)."""
    scales = np.array([channel.scale for channel in channels])
    lows = np.array([channel.low for channel in channels])
    return np.clip(values / scales, lows, 1.0).astype(np.float32)
