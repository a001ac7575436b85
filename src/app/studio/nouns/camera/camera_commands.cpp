#include "app/studio/nouns/camera/camera_commands.h"

#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/nouns/camera/camera_follow.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/camera/sensor_in_view.h"
#include "ui/scene/pick/gizmo.h"

namespace taxel::ui {

namespace {

/// In SIMULATE, a scene that runs or a recorded step; in LAYOUT, a mesh.
bool has_scene(const App& app) {
  if (app.viewer->mode == Mode::simulate && !(app.shown->run.frame && app.shown->run.frame->scene)) return false;
  return !scene_box(*app.viewer, *app.shown).empty();
}

}  // namespace

void carry_out(const FrameCamera& command, App& app) {
  free_camera(*app.viewer, app.get<FollowState>());
  app.viewer->camera().frame(command.selection ? selection_box(*app.viewer, *app.shown)
                                               : scene_box(*app.viewer, *app.shown));
}

void carry_out(const AlignCamera&, App& app) {
  align_camera(*app.viewer, *app.shown, app.get<FollowState>());
}

void carry_out(const TakeStandardView& command, App& app) {
  free_camera(*app.viewer, app.get<FollowState>());
  take_standard_view(app.viewer->camera(), command.axis);
}

void carry_out(const ToggleOrthographic&, App& app) {
  free_camera(*app.viewer, app.get<FollowState>());
  app.viewer->camera().orthographic = !app.viewer->camera().orthographic;
}

void carry_out(const StepCamera& command, App& app) {
  look_through_next(*app.viewer, *app.shown, app.get<FollowState>(), command.direction);
}

void frame_cameras(App& app) {
  const Mode mode = app.viewer->mode;
  for (const Mode each : {Mode::layout, Mode::simulate}) {
    const std::size_t i = each == Mode::layout ? 0 : 1;
    app.viewer->mode = each;
    if (!app.get<Framing>().turns[i] || !has_scene(app)) continue;
    app.get<Framing>().turns[i] = false;
    show_scene_first(*app.viewer, *app.shown);
    if (app.get<Framing>().saved[i]) app.viewer->cameras[i] = *std::exchange(app.get<Framing>().saved[i], std::nullopt);
  }
  app.viewer->mode = mode;
  if (!app.get<Framing>().checks_view || !has_scene(app)) return;
  app.get<Framing>().checks_view = false;
  const bool follows = looks_through_camera(*app.viewer, app.get<FollowState>()) || app.get<FollowState>().body >= 0;
  if (!follows && sensors_are_outside_view(*app.viewer, *app.shown)) frame_scene(*app.viewer, *app.shown);
}

}  // namespace taxel::ui
