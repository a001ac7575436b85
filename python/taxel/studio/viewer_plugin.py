"""The part of the companion on the viewer's side of MuJoCo's Studio."""

from __future__ import annotations

from mujoco.studio import messages, plugin

from taxel.studio.marks import as_extra_geoms, show_in_model
from taxel.studio.messages import ReadingsEvent, SceneEvent
from taxel.studio.panel import build_panel
from taxel.studio.view_state import ViewState


class TactileView(plugin.ViewerPlugin):
    """Draws taxels and forces in the viewer's scene, and the window "Taxels"."""

    def __init__(self, in_browser: bool = False) -> None:
        self.in_browser = in_browser
        self.state: ViewState | None = None

    @messages.handler
    def on_post_model(self, _: messages.PostModelEvent) -> None:
        """Draws nothing in a new model before its SceneEvent comes, which may be in a later frame."""
        self.state = None

    @messages.handler
    def on_scene(self, event: SceneEvent) -> None:
        """Forgets all readings of the previous scene."""
        self.state = ViewState(event.scene)

    @messages.handler
    def on_readings(self, event: ReadingsEvent) -> None:
        """Takes the readings of one step."""
        if self.state is not None:
            self.state.take(event.time, event.sensordata, event.surface)

    @messages.handler
    def on_update(self, _: messages.UpdateEvent) -> None:
        """Moves the marks to the present places."""
        if self.state is None:
            return
        marks = self.state.marks(self.viewer.data)
        if self.in_browser:
            self.viewer.extra_geoms[:] = as_extra_geoms(marks)
        else:
            show_in_model(marks, self.state.scene.first_mark, self.viewer.model, self.viewer.data)

    @messages.handler
    def on_build_gui(self, _: messages.BuildGuiEvent) -> None:
        """Builds the window."""
        if self.state is not None:
            build_panel(self.state, self.viewer.vis_options.flags)
