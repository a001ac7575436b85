"""A companion for MuJoCo's own Studio: tactile sensors in its window.

    python -m taxel.studio scene.xml

The simulation has the full model. The viewer has a copy without engine plugins, because its renderer crashes on them.
The window shows bars and colours of the taxels, the force on each sensor, and a plot of the readings.
"""

from __future__ import annotations

import os

__all__ = ["run"]


def run(
    path: str | os.PathLike[str], *, graphics: str = "opengl_headless", width: int = 1280, height: int = 860, port: int = 0
) -> None:
    """Opens a scene in MuJoCo's Studio and simulates it until the window is closed.

    `graphics` is the mode of Studio: "opengl_headless" for a window, "opengl_software" without a graphics card, "web" for
    a page in the browser at `port` (0: the first free one from 8080 on). Raises Error if the scene cannot be shown, or if
    the installed MuJoCo has no Studio.
    """
    from taxel.studio.launch import run as launch

    launch(path, graphics=graphics, width=width, height=height, port=port)
