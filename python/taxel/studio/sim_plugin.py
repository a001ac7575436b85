"""The part of the companion on the simulation's side of MuJoCo's Studio."""

from __future__ import annotations

import logging

import mujoco
from mujoco.studio import messages, plugin

from taxel.errors import Error
from taxel.studio.messages import ReadingsEvent, SceneEvent
from taxel.studio.scene import Scene, load_scene
from taxel.studio.simulation import Simulation
from taxel.studio.surface import SurfaceReader

_log = logging.getLogger("taxel.studio")


class TactileSim(plugin.SimPlugin):
    """Steps the full model of a scene, while Studio and its viewer have the model without engine plugins.

    Put it before a plugin that steps, such as Studio's StepControl: that plugin then steps the full model.
    """

    def __init__(self, scene: Scene, *, takes_more_scenes: bool = True) -> None:
        """Shows `scene`. Without `takes_more_scenes`, the scene cannot be replaced.

        The window of MuJoCo 4.0.0 crashes some frames after it got a second model. The page in the browser does not.
        """
        self._takes_more_scenes = takes_more_scenes
        self._next: Scene | None = scene
        self.simulation: Simulation | None = None
        # MuJoCo 4.0.0 crashes in one of four starts if this memory is taken while its window opens.
        self._surface = SurfaceReader(scene.full)

    @messages.handler
    def on_load_model(self, event: messages.LoadModelEvent) -> bool:
        """Shows the scene of the constructor first, and later each scene that the user opens or reloads."""
        path = event.path or self.handle.model_path
        if self._next is None and not self._takes_more_scenes:
            _log.error(
                "%s is not loaded, because the window of MuJoCo %s crashes on a second model. Close the window and open the "
                "scene again, or use --gfx web.",
                path,
                mujoco.mj_versionString(),
            )
            return True
        scene, self._next = self._next, None
        if scene is None or (path and path != scene.path):
            try:
                scene = load_scene(path)
            except Error as error:
                _log.error("%s. The present scene stays.", error)
                return True
        self.simulation = Simulation(scene)
        if self._surface.model is not scene.full:
            self._surface = SurfaceReader(scene.full)
        self.handle.set_model(scene.plain, path=scene.path, data=self.simulation.plain_data)
        self.handle.send_to_viewer(SceneEvent(scene))
        return True

    @messages.handler
    def on_step(self, event: messages.StepEvent) -> bool:
        """Lets the other plugins step the full model instead of the plain one."""
        simulation = self.simulation
        if simulation is None or event.model is not simulation.scene.plain:
            return False
        full = simulation.full_data
        changed = simulation.pull()
        before = full.time
        self.handle.dispatch(messages.StepEvent(model=simulation.scene.full, data=full))
        if changed or simulation.full_is_newer or full.time != before:
            simulation.push()
            self.handle.send_to_viewer(ReadingsEvent(float(full.time), full.sensordata.copy(), self._surface.read(full)))
        return True

    @messages.handler
    def on_reset(self, event: messages.ResetEvent) -> None:
        """Resets the full data too."""
        if self.simulation is not None:
            self.simulation.reset(-1 if event.key is None else event.key)

    @messages.handler
    def on_keyframe(self, event: messages.KeyframeEvent) -> None:
        """Stores a keyframe in the full model too."""
        if self.simulation is None:
            return
        full = self.simulation.scene.full
        if 0 <= event.key < full.nkey and len(event.state) == mujoco.mj_stateSize(full, messages.KEYFRAME_STATE_SIG):
            data = mujoco.MjData(full)
            mujoco.mj_setState(full, data, event.state, messages.KEYFRAME_STATE_SIG)
            mujoco.mj_setKeyframe(full, data, event.key)

    @messages.handler
    def on_thread_pool(self, event: messages.ThreadPoolEvent) -> bool:
        """Gives the threads to the full data."""
        if self.simulation is not None:
            mujoco.mju_threadpool(self.simulation.full_data, event.nthread)
        return True
