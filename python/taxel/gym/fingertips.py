"""Simulations of one scene that run in step, each with MuJoCo data of its own."""

from __future__ import annotations

import collections
import concurrent.futures
import itertools
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
    """n fingertips over their objects. Arrays have one row for each fingertip, in SI units and world axes."""

    def __init__(self, scene: Scene, count: int, threads: int) -> None:
        import mujoco

        self.scene = scene
        self.data: list[mujoco.MjData] = [mujoco.MjData(scene.model) for _ in range(count)]
        self.shapes = np.zeros(count, dtype=np.int64)
        """Index in SHAPES of the object of each fingertip."""
        self.channels = _channels_of(scene)
        self._address = scene.sensor.address
        self._taxels = len(scene.sensor.ids)
        self._threads = min(threads, count)
        self._pool = concurrent.futures.ThreadPoolExecutor(self._threads) if self._threads > 1 else None

    def close(self) -> None:
        """Ends the threads."""
        if self._pool is not None:
            self._pool.shutdown()

    def place(self, i: int, shape: int, position: np.ndarray, quaternion: np.ndarray, start: np.ndarray) -> None:
        """Begins a simulation: the object at this pose, and the fingertip at rest at `start` [m]."""
        import mujoco

        data = self.data[i]
        mujoco.mj_resetData(self.scene.model, data)
        data.mocap_pos[:] = self.scene.parked
        body = int(self.scene.model.body(SHAPES[shape].name).mocapid.item())
        data.mocap_pos[body] = position
        data.mocap_quat[body] = quaternion
        data.qpos[:] = start
        data.act[:] = start
        self.shapes[i] = shape
        mujoco.mj_forward(self.scene.model, data)

    def advance(self, rows: typing.Sequence[int], actions: np.ndarray) -> None:
        """Simulates the time of one action for these rows. `actions` are fractions of the largest speed, shape (n, 3)."""
        for i in rows:
            self.data[i].ctrl[:] = actions[i] * MAX_SPEED
        if self._pool is None or len(rows) == 1:
            self._step(collections.deque(rows))
            return
        # Each thread takes the next row when it is ready, because rows with contact take longer.
        pending = collections.deque(rows)
        for _ in self._pool.map(self._step, itertools.repeat(pending, self._threads)):
            pass

    def _step(self, pending: collections.deque[int]) -> None:
        import mujoco

        while True:
            try:
                i = pending.popleft()
            except IndexError:
                return
            mujoco.mj_step(self.scene.model, self.data[i], STEPS_PER_ACTION)  # without Python's lock

    def _columns(self, first: int, count: int) -> np.ndarray:
        first += self._address
        return np.array([data.sensordata[first : first + count] for data in self.data])

    @property
    def readings(self) -> np.ndarray:
        """Readings of the taxels in the unit of the layout, shape (n, taxels)."""
        return self._columns(0, self._taxels)

    @property
    def force(self) -> np.ndarray:
        """Force of the object on the fingertip [N], shape (n, 3)."""
        return self._columns(self._taxels, 3)

    @property
    def area(self) -> np.ndarray:
        """Area of contact [m^2], shape (n,)."""
        return self._columns(self._taxels + 6, 1)[:, 0]

    @property
    def position(self) -> np.ndarray:
        """Position of the fingertip's lowest point [m], shape (n, 3)."""
        return np.array([data.qpos for data in self.data])

    @property
    def velocity(self) -> np.ndarray:
        """Velocity of the fingertip [m/s], shape (n, 3)."""
        return np.array([data.qvel for data in self.data])

    @property
    def setpoint(self) -> np.ndarray:
        """Position to which the servo leads the fingertip [m], shape (n, 3)."""
        return np.array([data.act for data in self.data])

    def quantities(self) -> np.ndarray:
        """Returns the values of `channels` in their units, shape (n, channels)."""
        return np.concatenate([self.readings, self.force, self.area[:, None], self.position, self.velocity,
                               self.setpoint], axis=1)


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
