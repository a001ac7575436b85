"""Starts MuJoCo's Studio with the companion's plugins."""

from __future__ import annotations

import os

from taxel.errors import Error
from taxel.studio.requirements import require_studio, require_window
from taxel.studio.scene import load_scene

WEB = ("web", "webgl")


def run(path: str | os.PathLike[str], *, graphics: str, width: int, height: int, port: int) -> None:
    """Opens a scene, see taxel.studio.run."""
    require_studio()
    from mujoco.studio import viewer_protocol

    if graphics not in viewer_protocol.GFX_MODES:
        raise Error("", "--gfx", f'must be one of {", ".join(viewer_protocol.GFX_MODES)}, is "{graphics}"')
    if graphics not in WEB:
        require_window(graphics)
    scene = load_scene(path)
    from mujoco.studio import app, launch_passive

    from taxel.studio.sim_plugin import TactileSim
    from taxel.studio.viewer_plugin import TactileView

    config = viewer_protocol.ViewerConfig(
        title=f"{os.path.basename(scene.path)} - Taxel Studio", width=width, height=height, gfx=graphics, http_port=port
    )
    plugins = [app.App(), TactileView(graphics in WEB), TactileSim(scene, takes_more_scenes=graphics in WEB), *app.SIM_PLUGINS]
    launch_passive.run(config, model_path=scene.path, plugins=plugins)
