"""Episodes of a task in n simulations: the arithmetic that a single and a vector environment share."""

from __future__ import annotations

import dataclasses
import os
import typing

import numpy as np

import taxel
from taxel.gym import channels
from taxel.gym.fingertips import Fingertips
from taxel.gym.objects import SHAPES, choose_shapes
from taxel.gym.scene import scene_of
from taxel.gym.tasks import Task

Layout = typing.Union[taxel.Layout, str, "os.PathLike[str]", None]

# Limits of the random pose of an object and of the start of the fingertip above it.
_SHIFT = 0.002
_TILT = np.radians(5.0)
_GAP = (0.002, 0.004)


@dataclasses.dataclass
class Step:
    """The results of one step, shape (environments,) each."""

    reward: np.ndarray
    terminated: np.ndarray
    truncated: np.ndarray


class Episodes:
    """n environments of one task. All arithmetic is element by element, so a row never depends on n."""

    def __init__(self, task: type[Task], count: int, layout: Layout, objects: str | typing.Iterable[str] | None,
                 density: float | None, threads: int) -> None:
        self.shapes = choose_shapes(objects, "objects")
        self.fingertips = Fingertips(scene_of(layout, density), count, threads)
        self.task = task(count)
        self.steps = np.zeros(count, dtype=np.int64)
        self.channels = [*self.fingertips.channels, *task.channels]

    def begin(self, i: int, rng: np.random.Generator, options: typing.Mapping[str, typing.Any] | None) -> None:
        """Begins an episode with a random object, pose and goal. Raises ValueError or TypeError for a bad option."""
        options = checked_options(options, ("object", *self.task.options))
        shapes = choose_shapes(options["object"], "options['object']") if "object" in options else self.shapes
        shape = shapes[int(rng.integers(len(shapes)))]
        shift, gap = rng.uniform(-_SHIFT, _SHIFT, size=2), rng.uniform(*_GAP)
        quaternion = _quaternion(rng.uniform(-np.pi, np.pi), *rng.uniform(-_TILT, _TILT, size=2))
        start = self.task.begin(i, rng, options, gap)
        self.fingertips.place(i, shape, np.array([*shift, 0.0]), quaternion, start)
        self.steps[i] = 0

    def step(self, actions: np.ndarray) -> Step:
        """Carries out one step of all environments. `actions` has the shape (n, 3)."""
        self.steps += 1
        self.fingertips.advance(actions)
        outcome = self.task.judge(self.steps, self.fingertips)
        truncated = (self.steps >= self.task.duration) & ~outcome.terminated
        return Step(outcome.reward, outcome.terminated, truncated)

    def observe(self) -> np.ndarray:
        """Returns the observations, float32, shape (n, channels)."""
        values = [self.fingertips.quantities(), self.task.quantities(self.steps, self.fingertips)]
        return channels.normalise(self.channels, np.concatenate(values, axis=1))

    def information(self) -> dict[str, np.ndarray]:
        """Returns raw quantities in SI units by name, one row for each environment."""
        sensor = self.fingertips.scene.sensor
        count = len(self.steps)
        force = self.fingertips.force
        return {
            "readings": self.fingertips.readings,
            "taxels": np.tile(sensor.ids, (count, 1)),
            "force": force,
            "normal_force": force[:, 2].copy(),
            "area": self.fingertips.area,
            "position": self.fingertips.position,
            "object": np.array([SHAPES[shape].name for shape in self.fingertips.shapes], dtype=object),
            **self.task.information(self.steps, self.fingertips),
        }


def checked_actions(actions: typing.Any, shape: tuple[int, ...]) -> np.ndarray:
    """Returns actions as float64, cut off at -1 and 1.

    Raises ValueError for another shape and for NaN or infinity, TypeError for values that are not numbers.
    """
    array = np.asarray(actions)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"action must have real numbers, has values of the type {array.dtype}")
    if array.shape != shape:
        raise ValueError(f"action must have the shape {shape}, has {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"action must be finite, is {array.tolist()}")
    return np.clip(array.astype(np.float64), -1.0, 1.0)


def checked_options(options: typing.Any, allowed: tuple[str, ...]) -> typing.Mapping[str, typing.Any]:
    """Returns the options of reset(). Raises TypeError or ValueError for other values and names."""
    if options is None:
        return {}
    if not isinstance(options, typing.Mapping):
        raise TypeError(f"options must be a dict, is {options!r}")
    for name in options:
        if name not in allowed:
            raise ValueError(f"options: {name!r} is unknown; the options are {', '.join(allowed)}")
    return options


def _quaternion(yaw: float, about_x: float, about_y: float) -> np.ndarray:
    """Returns the quaternion of a tilt about the axis (about_x, about_y, 0) by its length [rad], after a turn by yaw."""
    import mujoco

    turn, tilt, both = np.zeros(4), np.zeros(4), np.zeros(4)
    mujoco.mju_axisAngle2Quat(turn, np.array([0.0, 0.0, 1.0]), yaw)
    axis = np.array([about_x, about_y, 0.0])
    length = float(np.sqrt(about_x * about_x + about_y * about_y))
    mujoco.mju_axisAngle2Quat(tilt, axis / length if length > 0 else axis, length)
    mujoco.mju_mulQuat(both, tilt, turn)
    return both
