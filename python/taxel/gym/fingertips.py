"""Simulations of one scene that run in step, as rows of arrays."""

from __future__ import annotations

import os
import typing

import numpy as np

from taxel.gym import channels
from taxel.gym.objects import SHAPES
from taxel.gym.scene import MAX_SPEED, REACH, STEPS_PER_ACTION, Scene

if typing.TYPE_CHECKING:
    import mujoco

#: Force that is 1 in an observation [N].
FORCE_SCALE = 2.0
_AREA_SCALE = 2e-4
_VELOCITY_SCALE = 0.05


class Fingertips:
    """n fingertips over their objects. Arrays have one row for each fingertip, in SI units and world axes.

    The state of a fingertip is a row of numbers. `mujoco.rollout` steps all rows, with one MjData for each thread, and
    takes no lock of Python between rows (docs/gym.md compares it with threads of Python).
    """

    def __init__(self, scene: Scene, count: int, threads: int) -> None:
        import mujoco
        import mujoco.rollout

        threads = min(threads, count)
        self.scene = scene
        self.channels = _channels_of(scene)
        self.shapes = np.zeros(count, dtype=np.int64)
        """Index in SHAPES of the object of each fingertip."""
        self._data = [mujoco.MjData(scene.model) for _ in range(threads)]
        self._rollout = mujoco.rollout.Rollout(nthread=threads if threads > 1 else 0)
        states, controls = _Columns(scene.model, "FULLPHYSICS"), _Columns(scene.model, "CTRL", "MOCAP_POS", "MOCAP_QUAT")
        self._states, self._controls = states, controls
        self._state = np.zeros((count, states.size))
        self._control = np.zeros((count, STEPS_PER_ACTION, controls.size))
        self._sensordata = np.zeros((count, scene.model.nsensordata))

    def close(self) -> None:
        """Ends the threads."""
        self._rollout.close()

    def place(self, i: int, shape: int, position: np.ndarray, quaternion: np.ndarray, start: np.ndarray) -> None:
        """Begins a simulation: the object at this pose, and the fingertip at rest at `start` [m]."""
        import mujoco

        model, data = self.scene.model, self._data[0]
        mujoco.mj_resetData(model, data)
        body = int(model.body(SHAPES[shape].name).mocapid.item())
        data.mocap_pos[body] = position
        data.mocap_quat[body] = quaternion
        data.qpos[:] = start
        data.act[:] = start
        mujoco.mj_forward(model, data)
        self.shapes[i] = shape
        mujoco.mj_getState(model, data, self._state[i], self._states.bits)
        row = np.zeros(self._controls.size)
        mujoco.mj_getState(model, data, row, self._controls.bits)
        self._control[i] = row
        self._sensordata[i] = data.sensordata

    def advance(self, actions: np.ndarray) -> None:
        """Simulates the time of one action. `actions` are fractions of the largest speed, shape (n, 3)."""
        count = len(self._state)
        self._control[:, :, self._controls.part("CTRL")] = (actions * MAX_SPEED)[:, None]
        states = np.empty((count, STEPS_PER_ACTION, self._states.size))
        sensordata = np.empty((count, STEPS_PER_ACTION, self._sensordata.shape[1]))
        # Chunks of one row, because rows with contact take longer.
        self._rollout.rollout([self.scene.model] * count, self._data, self._state, self._control,
                              control_spec=self._controls.bits, skip_checks=True, nstep=STEPS_PER_ACTION, state=states,
                              sensordata=sensordata, chunk_size=1)
        self._state = states[:, -1].copy()
        self._sensordata = sensordata[:, -1].copy()

    def data_of(self, i: int) -> mujoco.MjData:
        """Returns data in the state of a fingertip, which are valid until the next call."""
        import mujoco

        model, data = self.scene.model, self._data[0]
        mujoco.mj_setState(model, data, self._control[i, 0], self._controls.bits)
        mujoco.mj_setState(model, data, self._state[i], self._states.bits)
        mujoco.mj_forward(model, data)
        return data

    def _sensed(self, first: int, count: int) -> np.ndarray:
        first += self.scene.sensor.address
        return self._sensordata[:, first : first + count].copy()

    @property
    def readings(self) -> np.ndarray:
        """Readings of the taxels in the unit of the layout, shape (n, taxels)."""
        return self._sensed(0, len(self.scene.sensor.ids))

    @property
    def force(self) -> np.ndarray:
        """Force of the object on the fingertip [N], shape (n, 3)."""
        return self._sensed(len(self.scene.sensor.ids), 3)

    @property
    def area(self) -> np.ndarray:
        """Area of contact [m^2], shape (n,)."""
        return self._sensed(len(self.scene.sensor.ids) + 6, 1)[:, 0]

    @property
    def position(self) -> np.ndarray:
        """Position of the fingertip's lowest point [m], shape (n, 3)."""
        return self._state[:, self._states.part("QPOS")].copy()

    @property
    def velocity(self) -> np.ndarray:
        """Velocity of the fingertip [m/s], shape (n, 3)."""
        return self._state[:, self._states.part("QVEL")].copy()

    @property
    def setpoint(self) -> np.ndarray:
        """Position to which the servo leads the fingertip [m], shape (n, 3)."""
        return self._state[:, self._states.part("ACT")].copy()

    def quantities(self) -> np.ndarray:
        """Returns the values of `channels` in their units, shape (n, channels)."""
        return np.concatenate([self.readings, self.force, self.area[:, None], self.position, self.velocity,
                               self.setpoint], axis=1)


class _Columns:
    """Columns of a state in the order of MuJoCo: the parts by increasing bits of mjtState."""

    def __init__(self, model: mujoco.MjModel, *parts: str) -> None:
        import mujoco

        self._model = model
        self.bits = 0
        for part in parts:
            self.bits |= self._bit(part)
        self.size = mujoco.mj_stateSize(model, self.bits)

    @staticmethod
    def _bit(part: str) -> int:
        import mujoco

        return int(getattr(mujoco.mjtState, f"mjSTATE_{part}"))

    def part(self, name: str) -> slice:
        """Returns the columns of a part."""
        import mujoco

        bit = self._bit(name)
        first = mujoco.mj_stateSize(self._model, self.bits & (bit - 1))
        return slice(first, first + mujoco.mj_stateSize(self._model, bit))


def available_threads() -> int:
    """Returns the number of processors that this process may use."""
    return len(os.sched_getaffinity(0))


def _channels_of(scene: Scene) -> list[channels.Channel]:
    unit = scene.sensor.unit
    scale = scene.layout.value("/material/modulus") / 2 if unit == "Pa" else FORCE_SCALE
    readings = [channels.Channel(f"reading {name}", unit, scale, 0.0) for name in scene.sensor.names]
    return [
        *readings,
        *channels.of_axes("force", "N", FORCE_SCALE),
        channels.Channel("contact area", "m^2", _AREA_SCALE, 0.0),
        *channels.of_axes("position", "m", REACH),
        *channels.of_axes("velocity", "m/s", _VELOCITY_SCALE),
        *channels.of_axes("setpoint", "m", REACH),
    ]
