"""Single environments."""

from __future__ import annotations

import typing

import gymnasium
import numpy as np

from taxel.gym import rendering, spaces
from taxel.gym.episodes import Episodes, Layout, checked_actions
from taxel.gym.tasks import PressTask, SlideTask, Task


class FingertipEnv(gymnasium.Env):
    """A fingertip on a servo over an object that changes with each episode. See Press and Slide.

    The action is the velocity of the servo's setpoint along the axes of the world, as fractions of 20 mm/s; a value
    outside of -1 to 1 is cut off. One step is 20 ms. `metadata["observation"]` and `metadata["action"]` list name, unit
    and scale of each number, in order; a number is the quantity divided by its scale, cut off at the limits of the space.
    Readings and forces are those at the beginning of the last time step of 2 ms, as everywhere in MuJoCo.

    `layout` is a Layout or its file, the built-in fingertip by default. `objects` names the objects of the episodes:
    sphere, cylinder, edge, grip, or single ones such as "sphere 8 mm". `density` is the number of samples of the layout
    per m^2: 2e6 by default, so that an environment is made quickly.

    The options of reset() are "object" and those of the task. An episode depends on seed and options alone. `info` has
    readings and forces in SI units, the ids of the taxels, the object and the goal.
    """

    metadata: dict[str, typing.Any] = {"render_modes": ["rgb_array"], "render_fps": spaces.RATE}
    task: typing.ClassVar[type[Task]]

    def __init__(self, *, render_mode: str | None = None, layout: Layout = None,
                 objects: str | typing.Iterable[str] | None = None, density: float | None = None) -> None:
        self.render_mode = rendering.checked_mode(render_mode)
        self._episodes = Episodes(self.task, 1, layout, objects, density, threads=1)
        self.metadata = spaces.metadata_of(self._episodes.channels)
        self.observation_space = spaces.box_of(self._episodes.channels)
        self.action_space = spaces.box_of(spaces.ACTIONS)
        self._camera = rendering.Camera(self._episodes.fingertips.scene.model)
        self._running = False

    def reset(self, *, seed: int | None = None, options: dict[str, typing.Any] | None = None
              ) -> tuple[np.ndarray, dict[str, typing.Any]]:
        """Begins an episode. Raises ValueError or TypeError for a bad option."""
        super().reset(seed=seed)
        self._episodes.begin(0, self.np_random, options)
        self._running = True
        return self._episodes.observe()[0], self._information()

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, typing.Any]]:
        """Carries out one action. Raises ValueError or TypeError for a bad action, ResetNeeded outside of an episode."""
        if not self._running:
            raise gymnasium.error.ResetNeeded("the episode has ended or not begun: call reset() before step()")
        step = self._episodes.step(checked_actions(action, self.action_space.shape)[None])
        terminated, truncated = bool(step.terminated[0]), bool(step.truncated[0])
        self._running = not (terminated or truncated)
        return self._episodes.observe()[0], float(step.reward[0]), terminated, truncated, self._information()

    def _information(self) -> dict[str, typing.Any]:
        rows = {name: values[0] for name, values in self._episodes.information().items()}
        return {name: row.item() if isinstance(row, np.generic) else row for name, row in rows.items()}

    def render(self) -> np.ndarray | None:
        """Returns an image, uint8, shape (480, 480, 3), or None without a render mode. Raises Error without OpenGL."""
        return None if self.render_mode is None else self._camera.draw(self._episodes.fingertips.data_of(0))

    def close(self) -> None:
        """Frees the drawing library."""
        self._camera.close()
        self._episodes.fingertips.close()


class Press(FingertipEnv):
    """taxel/Press-v0: press with a commanded force that changes half way, and do not exceed it.

    With the normal force F (upward part of the force on the fingertip), the command C, both in N, and e = (F - C) / C,

        reward = 1 - min(|e|, 1) - 2 min(max(e - 0.1, 0), 1)

    so a step gives 1 at the command, 0 without contact, and down to -2 above it. A normal force above 2 N ends the
    episode (terminated) with a reward of -10; it is truncated after 150 steps. Each command is from 0.2 to 0.8 N.

    Option "force": one command, or a list of commands that have equal shares of the episode [N], from 0.02 to 1.5.
    """

    task = PressTask


class Slide(FingertipEnv):
    """taxel/Slide-v0: slide a given way over the object, with the normal force within bounds.

    With the normal force F, its bounds A and B, the way s along the given direction, the largest s before this step s',
    the given distance D, and the deviation d from the straight line,

        reward = 10 max(min(s, D) - s', 0) / D, if A <= F <= B, else 0
                 - 0.02 min(max(A - F, 0) / A + max(F - B, 0) / B, 1) - 0.02 min(|d| / 5 mm, 1)

    so the whole way within the bounds gives 10, and each part of the way counts once. The episode ends (terminated) at
    s >= D, and with a reward of -10 at a normal force above 2 N; it is truncated after 200 steps. The fingertip begins
    D / 2 before the middle of the object. D is from 6 to 12 mm; A and B are 0.6 and 1.4 times a force from 0.3 to 0.6 N.

    Options: "direction", the angle from the x axis [rad]; "distance" [m], from 0.001 to 0.024; "bounds", the pair
    (A, B) [N].
    """

    task = SlideTask
