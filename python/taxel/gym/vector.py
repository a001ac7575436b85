"""Vector environments: n simulations of one model that are stepped by threads."""

from __future__ import annotations

import typing

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space

from taxel.gym import rendering, spaces
from taxel.gym.episodes import Episodes, Layout, checked_actions
from taxel.gym.fingertips import available_threads
from taxel.gym.tasks import PressTask, SlideTask, Task

Seeds = typing.Union[int, typing.Sequence[typing.Optional[int]], None]


class FingertipVectorEnv(gymnasium.vector.VectorEnv):
    """n environments as in FingertipEnv, with its arguments, which give the same bytes as n single ones.

    `threads` is the number of threads, that of the processors by default. `autoreset_mode` is "NextStep", "SameStep" or
    "Disabled", with the meaning that Gymnasium gives them. Environment i is seeded by seed + i, or by seed[i] of a list.
    """

    task: typing.ClassVar[type[Task]]

    def __init__(self, num_envs: int = 1, *, render_mode: str | None = None, layout: Layout = None,
                 objects: str | typing.Iterable[str] | None = None, density: float | None = None,
                 threads: int | None = None, autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP) -> None:
        self.num_envs = _count(num_envs, "num_envs")
        threads = available_threads() if threads is None else _count(threads, "threads")
        self.render_mode = rendering.checked_mode(render_mode)
        self._mode = AutoresetMode(autoreset_mode)
        self._episodes = Episodes(self.task, num_envs, layout, objects, density, threads)
        self.metadata = {**spaces.metadata_of(self._episodes.channels), "autoreset_mode": self._mode}
        self.single_observation_space = spaces.box_of(self._episodes.channels)
        self.single_action_space = spaces.box_of(spaces.ACTIONS)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._generators: list[np.random.Generator | None] = [None] * num_envs
        self._camera = rendering.Camera(self._episodes.fingertips.scene.model)
        self._ended = np.ones(num_envs, dtype=bool)
        self._has_begun = False

    def reset(self, *, seed: Seeds = None, options: dict[str, typing.Any] | None = None
              ) -> tuple[np.ndarray, dict[str, typing.Any]]:
        """Begins the episodes of all environments, or of those in options["reset_mask"], shape (n,), bool."""
        seeds = self._seeds(seed)
        mask, options = self._mask(options)
        rows = [int(i) for i in np.flatnonzero(mask)]
        for i in rows:
            if seeds[i] is not None or self._generators[i] is None:
                self._generators[i], _ = gymnasium.utils.seeding.np_random(seeds[i])
            self._episodes.begin(i, self._generators[i], options)
        self._ended[mask] = False
        self._has_begun = self._has_begun or bool(mask.all())
        return self._episodes.observe(), self._information(mask)

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, typing.Any]]:
        """Carries out one action in each environment. Raises ValueError or TypeError for bad actions."""
        if not self._has_begun:
            raise gymnasium.error.ResetNeeded("no episode has begun: call reset() before step()")
        if self._mode is AutoresetMode.DISABLED and self._ended.any():
            raise gymnasium.error.ResetNeeded(f"the episodes of {np.flatnonzero(self._ended).tolist()} have ended: call "
                                              'reset(options={"reset_mask": mask}) before step()')
        fresh = self._ended  # in the mode NextStep, these begin again, and their results are dropped
        result = self._episodes.step(checked_actions(actions, self.action_space.shape))
        for i in np.flatnonzero(fresh):
            self._begin_again(int(i))
        reward = np.where(fresh, 0.0, result.reward)
        terminated, truncated = result.terminated & ~fresh, result.truncated & ~fresh
        self._ended = terminated | truncated
        last = self._reset_ended() if self._mode is AutoresetMode.SAME_STEP and self._ended.any() else {}
        return self._episodes.observe(), reward, terminated, truncated, {**last, **self._information()}

    def _begin_again(self, i: int) -> None:
        self._episodes.begin(i, self._generators[i], None)

    def _reset_ended(self) -> dict[str, typing.Any]:
        """Begins new episodes where one has ended, and returns the last observations and information of those."""
        observations, information = self._episodes.observe(), self._episodes.information()
        infos: dict[str, typing.Any] = {}
        for i in (int(i) for i in np.flatnonzero(self._ended)):
            last = {name: values[i] for name, values in information.items()}
            self._add_info(infos, {"final_obs": observations[i].copy(), "final_info": last}, i)
            self._begin_again(i)
        self._ended[:] = False
        return infos

    def _information(self, mask: np.ndarray | None = None) -> dict[str, typing.Any]:
        """Returns raw quantities with a mask for each, as in all vector environments. Other rows than the mask's are 0."""
        infos = {}
        for name, values in self._episodes.information().items():
            if mask is not None:
                values[~mask] = None if values.dtype == object else 0
            infos[name] = values
            infos[f"_{name}"] = np.ones(self.num_envs, dtype=bool) if mask is None else mask.copy()
        return infos

    def _seeds(self, seed: Seeds) -> list[int | None]:
        if seed is None:
            return [None] * self.num_envs
        if isinstance(seed, (int, np.integer)):
            return [int(seed) + i for i in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise ValueError(f"seed must be a number or {self.num_envs} numbers, has {len(seed)}")
        return list(seed)

    def _mask(self, options: dict[str, typing.Any] | None) -> tuple[np.ndarray, dict[str, typing.Any] | None]:
        if not isinstance(options, typing.Mapping) or "reset_mask" not in options:
            return np.ones(self.num_envs, dtype=bool), options
        mask = np.asarray(options["reset_mask"])
        if mask.dtype != bool or mask.shape != (self.num_envs,) or not mask.any():
            raise ValueError(f"options['reset_mask'] must have {self.num_envs} truth values, at least one of them true")
        return mask, {name: value for name, value in options.items() if name != "reset_mask"}

    def render(self) -> tuple[np.ndarray, ...] | None:
        """Returns an image of each environment, or None without a render mode. Raises Error without OpenGL."""
        if self.render_mode is None:
            return None
        return tuple(self._camera.draw(self._episodes.fingertips.data_of(i)) for i in range(self.num_envs))

    def close_extras(self, **_: typing.Any) -> None:
        """Ends the threads, and frees the drawing library."""
        self._camera.close()
        self._episodes.fingertips.close()


def _count(value: typing.Any, name: str) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < 1:
        raise ValueError(f"{name} must be a whole number above 0, is {value!r}")
    return int(value)


class PressVector(FingertipVectorEnv):
    """n environments taxel/Press-v0."""

    task = PressTask


class SlideVector(FingertipVectorEnv):
    """n environments taxel/Slide-v0."""

    task = SlideTask
