"""Spaces and metadata that the environments share."""

from __future__ import annotations

import typing

import gymnasium
import numpy as np

from taxel.gym.channels import Channel
from taxel.gym.scene import MAX_SPEED, STEPS_PER_ACTION, TIME_STEP

#: The action: the velocity of the servo's setpoint along the axes of the world.
ACTIONS = [Channel(f"velocity {axis}", "m/s", MAX_SPEED) for axis in "xyz"]
#: Actions a second of simulated time.
RATE = round(1 / (TIME_STEP * STEPS_PER_ACTION))


def box_of(channels: typing.Sequence[Channel]) -> gymnasium.spaces.Box:
    """Returns the space of normalised channels, with their names, units and scales as the attribute `metadata`."""
    low = np.array([channel.low for channel in channels], dtype=np.float32)
    space = gymnasium.spaces.Box(low, np.ones(len(channels), dtype=np.float32))
    space.metadata = [channel.as_dict() for channel in channels]
    return space


def metadata_of(observation: typing.Sequence[Channel]) -> dict[str, typing.Any]:
    """Returns the metadata of an environment: lists of names, units and scales, and the rate of frames."""
    return {
        "render_modes": ["rgb_array"],
        "render_fps": RATE,
        "observation": [channel.as_dict() for channel in observation],
        "action": [channel.as_dict() for channel in ACTIONS],
    }
