"""Finds MuJoCo's Studio, or says what is missing."""

from __future__ import annotations

import abc
import collections.abc
import importlib
import importlib.util
import os
import sys

import mujoco
import numpy as np

from taxel.errors import Error

#: The version of MuJoCo whose Studio this package is tested with.
STUDIO_VERSION = "4.0.0"


def require_studio() -> None:
    """Raises Error unless `mujoco.studio` can be imported."""
    version = mujoco.mj_versionString()
    advice = f"`pip install mujoco=={STUDIO_VERSION}` has it"
    if importlib.util.find_spec("mujoco.studio") is None:
        raise Error("", "", f"MuJoCo {version} has no Studio (the module mujoco.studio): {advice}")
    try:
        importlib.import_module("mujoco.studio.viewer_handle")
    except ImportError as error:
        raise Error("", "", f"the Studio of MuJoCo {version} cannot be imported: {error}; {advice}") from error


def require_window(graphics: str) -> None:
    """Raises Error unless Studio can open a window with this mode of graphics."""
    if graphics == "opengl" and mujoco.mj_versionString() == STUDIO_VERSION:
        raise Error("", "--gfx", f'the mode "opengl" of the Studio of MuJoCo {STUDIO_VERSION} ends with "Target not found": '
                                 "use opengl_headless, which also opens a window")
    if sys.platform == "linux" and not os.environ.get("DISPLAY") and not os.environ.get("WAYLAND_DISPLAY"):
        raise Error("", "", "there is no display for a window (DISPLAY is not set): set it, or use --gfx web for the browser")
    try:
        _import_renderer()
        importlib.import_module("mujoco.studio.native_viewer")
    except ImportError as error:
        raise Error("", "", f"the window of MuJoCo's Studio cannot be imported: {error}") from error


def _import_renderer() -> None:
    """Imports the renderer of MuJoCo's Studio. It needs collections.abc.Buffer, which Python 3.11 does not have yet."""
    if hasattr(collections.abc, "Buffer"):
        return

    class Buffer(abc.ABC):
        pass

    for kind in (np.ndarray, bytes, bytearray, memoryview):
        Buffer.register(kind)
    collections.abc.Buffer = Buffer  # type: ignore[attr-defined]
    try:
        importlib.import_module("mujoco.rendering.filament.renderer")
    finally:
        del collections.abc.Buffer
