"""Messages from the simulation to the viewer. No reading is lost, because both are events of MuJoCo's Studio."""

from __future__ import annotations

import dataclasses

import numpy as np
from mujoco.studio import messages

from taxel.studio.scene import Scene
from taxel.studio.surface import Surface


@dataclasses.dataclass(frozen=True, eq=False)
class SceneEvent(messages.Event):
    """The viewer shows this scene from now on."""

    scene: Scene


@dataclasses.dataclass(frozen=True, eq=False)
class ReadingsEvent(messages.Event):
    """Readings and contact surfaces of the full model after a step. Nobody changes the arrays afterwards."""

    time: float
    """Time of the simulation [s]."""
    sensordata: np.ndarray
    """All values of `sensordata`."""
    surface: Surface
    """The contact surfaces of all sensors."""
