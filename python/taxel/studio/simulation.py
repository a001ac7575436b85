"""Runs the full model next to the model of the viewer, and exchanges their states."""

from __future__ import annotations

import collections
import copy

import mujoco
import numpy as np

from taxel.studio.scene import Scene

_REMEMBERED = 4096  # states of plugins, for times to which the user goes back


def shared_state(full: mujoco.MjModel, plain: mujoco.MjModel) -> int:
    """Returns the mask of mjtState with all parts of the integration state that have the same size in both models."""
    mask = 0
    for bit in range(int(mujoco.mjtState.mjNSTATE)):
        part = 1 << bit
        size = mujoco.mj_stateSize(full, part)
        if size > 0 and part != int(mujoco.mjtState.mjSTATE_PLUGIN) and size == mujoco.mj_stateSize(plain, part):
            mask |= part
    return mask


class Simulation:
    """The full simulation of a scene, and a plain one of the viewer's model that follows it.

    The viewer, the mouse and the sliders change the plain data only. A step is `pull()`, a step of `full_data` by
    anybody, and `push()`. If nobody changes the plain data, the full data never change outside of the step, so that
    readings are those of a plain loop to the last bit.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.full_data = mujoco.MjData(scene.full)
        self.plain_data = mujoco.MjData(scene.plain)
        self._mask = shared_state(scene.full, scene.plain)
        self._pushed = np.empty(mujoco.mj_stateSize(scene.full, self._mask))
        self._options = copy.deepcopy(scene.plain.opt)
        self._plugin_states: collections.OrderedDict[float, np.ndarray] = collections.OrderedDict()
        #: The plain data do not have the state of the full data yet: the next step calls push().
        self.full_is_newer = True

    def reset(self, key: int = -1) -> None:
        """Resets the full data, to a keyframe if `key` is the number of one. The next push() resets the plain data."""
        if 0 <= key < self.scene.full.nkey:
            mujoco.mj_resetDataKeyframe(self.scene.full, self.full_data, key)
        else:
            mujoco.mj_resetData(self.scene.full, self.full_data)
        self._plugin_states.clear()
        self.full_is_newer = True

    def pull(self) -> bool:
        """Copies options and state that the viewer has changed into the full model. Returns true if the state changed.

        After a change, `sensordata` has the readings of the new state.
        """
        if self.scene.plain.opt != self._options:
            self.scene.full.opt = self.scene.plain.opt
            self._options = copy.deepcopy(self.scene.plain.opt)
        if self.full_is_newer:
            return False
        state = self._state(self.scene.plain, self.plain_data)
        if np.array_equal(state, self._pushed, equal_nan=True):
            return False
        mujoco.mj_setState(self.scene.full, self.full_data, state, self._mask)
        plugins = self._plugin_states.get(self.full_data.time)
        if plugins is not None:
            self.full_data.plugin_state[:] = plugins
        mujoco.mj_forward(self.scene.full, self.full_data)
        return True

    def push(self) -> None:
        """Copies the state of the full data to the plain data, and computes the poses of the bodies."""
        self._pushed = self._state(self.scene.full, self.full_data)
        mujoco.mj_setState(self.scene.plain, self.plain_data, self._pushed, self._mask)
        mujoco.mj_kinematics(self.scene.plain, self.plain_data)
        self.full_is_newer = False
        self._plugin_states[self.full_data.time] = self.full_data.plugin_state.copy()
        if len(self._plugin_states) > _REMEMBERED:
            self._plugin_states.popitem(last=False)

    def _state(self, model: mujoco.MjModel, data: mujoco.MjData) -> np.ndarray:
        state = np.empty(mujoco.mj_stateSize(model, self._mask))
        mujoco.mj_getState(model, data, state, self._mask)
        return state
