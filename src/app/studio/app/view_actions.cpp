#include "app/studio/app/view_actions.h"

#include "app/studio/app/camera_tool.h"
#include "app/studio/features/camera/camera_follow.h"

namespace taxel::ui {

namespace {

/// The overlays of marks go through what there is; a scene of this mode is needed.
bool shows_scene(const UiState& ui, const UiInput& input) {
  return ui.mode == Mode::simulate && input.frame && input.frame->scene;
}

}  // namespace

bool* overlay_switch(Action action, Overlays& overlays) {
  switch (action) {
    case Action::toggle_transparent:
      return &overlays.sensor_transparent;
    case Action::toggle_wireframe:
      return &overlays.wireframe;
    case Action::toggle_rays:
      return &overlays.rays;
    case Action::toggle_all_rays:
      return &overlays.all_rays;
    case Action::toggle_contact:
      return &overlays.contact_surface;
    case Action::toggle_contact_edges:
      return &overlays.contact_edges;
    case Action::toggle_tractions:
      return &overlays.tractions;
    case Action::toggle_skin:
      return &overlays.readings_on_skin;
    case Action::toggle_ghost:
      return &overlays.ghost;
    case Action::toggle_filtered:
      return &overlays.filtered_polygons;
    case Action::toggle_samples:
      return &overlays.samples;
    case Action::toggle_normals:
      return &overlays.sample_normals;
    case Action::toggle_taxels:
      return &overlays.taxels;
    case Action::toggle_labels:
      return &overlays.taxel_labels;
    case Action::toggle_fields:
      return &overlays.receptive_fields;
    case Action::toggle_fields_filled:
      return &overlays.fields_filled;
    case Action::toggle_fields_compared:
      return &overlays.fields_compared;
    case Action::toggle_coverage:
      return &overlays.coverage;
    case Action::toggle_normal_angles:
      return &overlays.normal_angles;
    case Action::toggle_path:
      return &overlays.path;
    case Action::toggle_grid:
      return &overlays.grid;
    case Action::toggle_constraints:
      return &overlays.constraints;
    case Action::toggle_group_0:
    case Action::toggle_group_1:
    case Action::toggle_group_2:
    case Action::toggle_group_3:
    case Action::toggle_group_4:
    case Action::toggle_group_5:
      return &overlays.geom_groups.at(static_cast<std::size_t>(action) -
                                      static_cast<std::size_t>(Action::toggle_group_0));
    case Action::toggle_site_group_0:
    case Action::toggle_site_group_1:
    case Action::toggle_site_group_2:
    case Action::toggle_site_group_3:
    case Action::toggle_site_group_4:
    case Action::toggle_site_group_5:
      return &overlays.site_groups.at(static_cast<std::size_t>(action) -
                                      static_cast<std::size_t>(Action::toggle_site_group_0));
    default:
      return nullptr;
  }
}

bool perform_on_view(Action action, UiState& ui, const UiInput& input) {
  Overlays& overlays = ui.saved.overlays;
  switch (action) {
    case Action::toggle_clip:
      toggle_clip(ui, input);
      return true;
    case Action::flip_clip:
      ui.clip = ui.clip->flipped();
      return true;
    case Action::frame_all:
    case Action::frame_selection:
      free_camera(ui);
      ui.camera().frame(action == Action::frame_all ? scene_box(ui, input) : selection_box(ui, input));
      return true;
    case Action::align_camera:
      align_camera(ui, input);
      return true;
    case Action::next_camera:
    case Action::previous_camera:
      look_through_next(ui, input, action == Action::next_camera ? 1 : -1);
      return true;
    case Action::select_parent:
      select_parent(ui, input);
      return true;
    case Action::cycle_frames:
      overlays.frames = next(overlays.frames);
      return true;
    case Action::cycle_labels:
      overlays.labels = next(overlays.labels);
      return true;
    default:
      return false;
  }
}

std::optional<bool> is_view_enabled(Action action, const UiState& ui, const UiInput& input) {
  switch (action) {
    case Action::toggle_clip:
    case Action::frame_all:
    case Action::align_camera:
      return !scene_box(ui, input).empty();
    case Action::flip_clip:
      return ui.clip.has_value();
    case Action::frame_selection:
      return !selection_box(ui, input).empty();
    case Action::next_camera:
    case Action::previous_camera:
      return has_cameras(ui, input);
    case Action::select_parent:
      return can_select_parent(ui, input);
    case Action::cycle_frames:
    case Action::cycle_labels:
    case Action::toggle_info:
      return shows_scene(ui, input);
    default:
      return std::nullopt;
  }
}

}  // namespace taxel::ui
