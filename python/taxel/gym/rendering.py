"""Images of a simulation, drawn by MuJoCo without a window."""

from __future__ import annotations

import typing

import numpy as np

from taxel.errors import Error

if typing.TYPE_CHECKING:
    import mujoco

_HEIGHT, _WIDTH = 480, 480


def checked_mode(render_mode: str | None) -> str | None:
    """Returns the mode. Raises ValueError for an unknown one."""
    if render_mode not in (None, "rgb_array"):
        raise ValueError(f'render_mode must be None or "rgb_array", is {render_mode!r}')
    return render_mode


class Camera:
    """Draws data of one model. The drawing library is loaded for the first image."""

    def __init__(self, model: mujoco.MjModel, camera: str | int = "side") -> None:
        """`camera` is a camera of the model, or -1 for the view of the scene."""
        self._name = camera
        self._model = model
        self._renderer: mujoco.Renderer | None = None

    def draw(self, data: mujoco.MjData) -> np.ndarray:
        """Returns an image, uint8, shape (480, 480, 3). Raises Error without OpenGL."""
        import mujoco

        if self._renderer is None:
            try:
                self._renderer = mujoco.Renderer(self._model, _HEIGHT, _WIDTH)
            except Exception as error:  # the libraries of OpenGL raise errors of many types
                raise Error("", "render_mode", f"MuJoCo cannot draw: {error}. Without a display, install pyopengl and "
                                               "set the environment variable MUJOCO_GL=egl before Python starts"
                            ) from error
        self._renderer.update_scene(data, camera=self._name)
        return self._renderer.render()

    def close(self) -> None:
        """Frees the drawing library."""
        if self._renderer is not None:
            self._renderer.close()
            self._renderer = None
