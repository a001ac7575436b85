"""The two tasks: the goal of an episode, its reward and its end. All arrays have one row for each environment."""

from __future__ import annotations

import abc
import dataclasses
import typing

import numpy as np

from taxel.gym.channels import Channel
from taxel.gym.fingertips import FORCE_SCALE, Fingertips
from taxel.gym.scene import REACH

#: Normal force at which an episode ends as a failure [N]. Goals must be below.
FORCE_LIMIT = 2.0
#: Reward of a step that exceeds FORCE_LIMIT.
FAILURE_REWARD = -10.0

_LARGEST_GOAL = 1.5
_PATH_REWARD = 10.0
_PATH_WIDTH = 0.005
# At most 0.02 each in 200 steps: -8 in the worst episode, so that a failure never pays.
_OUTSIDE_PENALTY = 0.02
_DEVIATION_PENALTY = 0.02


@dataclasses.dataclass
class Outcome:
    """The end of one step, shape (environments,) each."""

    reward: np.ndarray
    terminated: np.ndarray


class Task(abc.ABC):
    """The goals of n environments."""

    duration: typing.ClassVar[int]
    """Number of steps after which an episode is truncated."""
    options: typing.ClassVar[tuple[str, ...]]
    """Options of reset() that set a goal."""
    channels: typing.ClassVar[list[Channel]]

    @abc.abstractmethod
    def __init__(self, count: int) -> None: ...

    @abc.abstractmethod
    def begin(self, i: int, rng: np.random.Generator, options: typing.Mapping[str, typing.Any], gap: float) -> np.ndarray:
        """Sets the goal of environment `i`, and returns the fingertip's start [m], `gap` above the object.

        Draws the same number of random values with any options. Raises ValueError or TypeError for a bad option.
        """

    @abc.abstractmethod
    def judge(self, steps: np.ndarray, fingertips: Fingertips) -> Outcome:
        """Returns the outcome of the step that ended. `steps` counts the steps of each episode, shape (n,)."""

    @abc.abstractmethod
    def quantities(self, steps: np.ndarray, fingertips: Fingertips) -> np.ndarray:
        """Returns the values of `channels` in their units, shape (n, channels)."""

    @abc.abstractmethod
    def information(self, steps: np.ndarray, fingertips: Fingertips) -> dict[str, np.ndarray]:
        """Returns goal and progress, by name with unit, one row for each environment."""


def normal_force(fingertips: Fingertips) -> np.ndarray:
    """Returns the upward part of the force on the fingertip [N], shape (n,)."""
    return fingertips.force[:, 2]


class PressTask(Task):
    """Follow a commanded normal force that changes half way."""

    duration = 150
    options = ("force",)
    channels = [Channel("commanded force", "N", FORCE_SCALE, 0.0)]

    def __init__(self, count: int) -> None:
        self._levels: list[np.ndarray] = [np.ones(1)] * count

    def begin(self, i: int, rng: np.random.Generator, options: typing.Mapping[str, typing.Any], gap: float) -> np.ndarray:
        drawn = rng.uniform(0.2, 0.8, size=2)
        self._levels[i] = _levels_of(options["force"]) if "force" in options else drawn
        return np.array([0.0, 0.0, gap])

    def _commanded(self, steps: np.ndarray) -> np.ndarray:
        """Returns the command for the next step: each level has an equal share of the episode."""
        return np.array([levels[min(int(step) * len(levels) // self.duration, len(levels) - 1)]
                         for step, levels in zip(steps, self._levels)])

    def judge(self, steps: np.ndarray, fingertips: Fingertips) -> Outcome:
        force, commanded = normal_force(fingertips), self._commanded(steps - 1)
        error = (force - commanded) / commanded
        excess = np.clip(error - 0.1, 0.0, 1.0)
        failed = force > FORCE_LIMIT
        reward = 1.0 - np.minimum(np.abs(error), 1.0) - 2.0 * excess
        return Outcome(np.where(failed, FAILURE_REWARD, reward), failed)

    def quantities(self, steps: np.ndarray, fingertips: Fingertips) -> np.ndarray:
        return self._commanded(steps)[:, None]

    def information(self, steps: np.ndarray, fingertips: Fingertips) -> dict[str, np.ndarray]:
        return {"commanded_force": self._commanded(steps)}


class SlideTask(Task):
    """Slide a given way, with the normal force within bounds."""

    duration = 200
    options = ("bounds", "direction", "distance")
    channels = [
        Channel("direction x", "1", 1.0),
        Channel("direction y", "1", 1.0),
        Channel("remaining way", "m", REACH),
        Channel("farthest way", "m", REACH, 0.0),
        Channel("deviation", "m", _PATH_WIDTH),
        Channel("smallest force", "N", FORCE_SCALE, 0.0),
        Channel("largest force", "N", FORCE_SCALE, 0.0),
    ]

    def __init__(self, count: int) -> None:
        self._start = np.zeros((count, 3))
        self._direction = np.zeros((count, 2))
        self._distance = np.ones(count)
        self._bounds = np.ones((count, 2))
        self._farthest = np.zeros(count)

    def begin(self, i: int, rng: np.random.Generator, options: typing.Mapping[str, typing.Any], gap: float) -> np.ndarray:
        angle, distance, middle = rng.uniform(-np.pi, np.pi), rng.uniform(0.006, 0.012), rng.uniform(0.3, 0.6)
        if "direction" in options:
            angle = _number(options["direction"], "direction", -2 * np.pi, 2 * np.pi, "rad")
        if "distance" in options:
            distance = _number(options["distance"], "distance", 0.001, 1.6 * REACH, "m")
        bounds = _bounds_of(options["bounds"]) if "bounds" in options else np.array([0.6 * middle, 1.4 * middle])
        self._direction[i] = np.cos(angle), np.sin(angle)
        self._distance[i], self._bounds[i], self._farthest[i] = distance, bounds, 0.0
        self._start[i] = *(-0.5 * distance * self._direction[i]), gap
        return self._start[i]

    def _way(self, fingertips: Fingertips) -> tuple[np.ndarray, np.ndarray]:
        """Returns the ways along the direction and to its left [m], shape (n,)."""
        moved = fingertips.position - self._start
        x, y = self._direction[:, 0], self._direction[:, 1]
        return moved[:, 0] * x + moved[:, 1] * y, moved[:, 1] * x - moved[:, 0] * y

    def judge(self, steps: np.ndarray, fingertips: Fingertips) -> Outcome:
        force = normal_force(fingertips)
        along, aside = self._way(fingertips)
        smallest, largest = self._bounds[:, 0], self._bounds[:, 1]
        outside = np.maximum(smallest - force, 0.0) / smallest + np.maximum(force - largest, 0.0) / largest
        advance = np.minimum(along, self._distance) - self._farthest
        gained = np.where(outside == 0.0, np.maximum(advance, 0.0), 0.0) / self._distance
        self._farthest = np.maximum(self._farthest, np.minimum(along, self._distance))
        reward = (_PATH_REWARD * gained - _OUTSIDE_PENALTY * np.minimum(outside, 1.0)
                  - _DEVIATION_PENALTY * np.minimum(np.abs(aside) / _PATH_WIDTH, 1.0))
        failed = force > FORCE_LIMIT
        return Outcome(np.where(failed, FAILURE_REWARD, reward), failed | (along >= self._distance))

    def quantities(self, steps: np.ndarray, fingertips: Fingertips) -> np.ndarray:
        along, aside = self._way(fingertips)
        return np.stack([*self._direction.T, self._distance - along, self._farthest, aside, *self._bounds.T], axis=1)

    def information(self, steps: np.ndarray, fingertips: Fingertips) -> dict[str, np.ndarray]:
        along, aside = self._way(fingertips)
        return {"bounds": self._bounds.copy(), "direction": self._direction.copy(), "distance": self._distance.copy(),
                "along": along, "deviation": aside}


def _number(value: typing.Any, name: str, low: float, high: float, unit: str) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise TypeError(f"options[{name!r}] must be a number, is {value!r}")
    if not low <= value <= high:
        raise ValueError(f"options[{name!r}] must be from {low:g} to {high:g} {unit}, is {value!r}")
    return float(value)


def _numbers(value: typing.Any, name: str) -> list[float]:
    values = value if isinstance(value, (list, tuple, np.ndarray)) else [value]
    return [_number(x, name, 0.02, _LARGEST_GOAL, "N") for x in values]


def _levels_of(value: typing.Any) -> np.ndarray:
    levels = _numbers(value, "force")
    if not 1 <= len(levels) <= PressTask.duration:
        raise ValueError(f"options['force'] must have 1 to {PressTask.duration} levels, has {len(levels)}")
    return np.array(levels)


def _bounds_of(value: typing.Any) -> np.ndarray:
    bounds = _numbers(value, "bounds")
    if len(bounds) != 2 or bounds[0] >= bounds[1]:
        raise ValueError(f"options['bounds'] must be the smallest and the largest normal force [N], is {value!r}")
    return np.array(bounds)
