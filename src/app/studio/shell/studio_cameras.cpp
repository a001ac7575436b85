// When the cameras turn to what their mode shows.
#include <utility>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/camera/camera_follow.h"
#include "app/studio/nouns/camera/follow_state.h"
#include "app/studio/nouns/camera/sensor_in_view.h"
#include "app/studio/shell/studio.h"

namespace taxel::studio {

namespace {

/// In SIMULATE, a scene that runs or a recorded step; in LAYOUT, a mesh.
bool has_scene(const ui::App& app) {
  if (app.viewer->mode == ui::Mode::simulate && !(app.shown->run.frame && app.shown->run.frame->scene)) return false;
  return !ui::scene_box(*app.viewer, *app.shown).empty();
}

}  // namespace

void Studio::frame_cameras() {
  const ui::Mode mode = app_.viewer->mode;
  for (const ui::Mode each : {ui::Mode::layout, ui::Mode::simulate}) {
    const std::size_t i = each == ui::Mode::layout ? 0 : 1;
    app_.viewer->mode = each;
    if (!framing_.turns[i] || !has_scene(app_)) continue;
    framing_.turns[i] = false;
    ui::show_scene_first(*app_.viewer, *app_.shown);
    if (framing_.saved[i]) app_.viewer->cameras[i] = *std::exchange(framing_.saved[i], std::nullopt);
  }
  app_.viewer->mode = mode;
  if (!framing_.checks_view || !has_scene(app_)) return;
  framing_.checks_view = false;
  const bool follows =
      ui::looks_through_camera(*app_.viewer, app_.get<ui::FollowState>()) || app_.get<ui::FollowState>().body >= 0;
  if (!follows && ui::sensors_are_outside_view(*app_.viewer, *app_.shown)) ui::frame_scene(*app_.viewer, *app_.shown);
}

}  // namespace taxel::studio
