// When the cameras turn to what their mode shows.
#include <utility>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/features/camera/camera_follow.h"
#include "app/studio/features/camera/sensor_in_view.h"
#include "app/studio/shell/studio.h"

namespace taxel::studio {

namespace {

/// In SIMULATE, a scene that runs or a recorded step; in LAYOUT, a mesh.
bool has_scene(const ui::UiState& ui, const ui::UiInput& input) {
  if (ui.mode == ui::Mode::simulate && !(input.frame && input.frame->scene)) return false;
  return !ui::scene_box(ui, input).empty();
}

}  // namespace

void Studio::frame_cameras() {
  const ui::Mode mode = ui_.mode;
  for (const ui::Mode each : {ui::Mode::layout, ui::Mode::simulate}) {
    const std::size_t i = each == ui::Mode::layout ? 0 : 1;
    ui_.mode = each;
    if (!turns_cameras_[i] || !has_scene(ui_, input_)) continue;
    turns_cameras_[i] = false;
    ui::frame_scene(ui_, input_);
    if (saved_cameras_[i]) ui_.cameras[i] = *std::exchange(saved_cameras_[i], std::nullopt);
  }
  ui_.mode = mode;
  if (!checks_view_ || !has_scene(ui_, input_)) return;
  checks_view_ = false;
  const bool follows = ui::looks_through_camera(ui_) || ui_.follow.body >= 0;
  if (!follows && ui::sensors_are_outside_view(ui_, input_)) ui::frame_scene(ui_, input_);
}

}  // namespace taxel::studio
