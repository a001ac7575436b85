"""Messages from the simulation to the viewer. No reading is lost, because both are events of MuJoCo's Studio."""

from __future__ import annotations

import dataclasses

import numpy as np
from mujoco.studio import messages

from taxel.studio.scene import Scene


@dataclasses.dataclass(frozen=True, eq=False)
class SceneEvent(messages.Event):
    """The viewer shows this scene from now on."""

    scene: Scene


@dataclasses.dataclass(frozen=True, eq=False)
class ReadingsEvent(messages.Event):
    """All values of `sensordata` of the full model after a step. Nobody changes the array afterwards."""

    time: float
    """Time of the simulation [s]."""
    sensordata: np.ndarray
