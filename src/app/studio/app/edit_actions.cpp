#include "app/studio/app/edit_actions.h"

#include <algorithm>
#include <cmath>

#include "app/studio/app/surface_place.h"
#include "app/studio/features/generate/generate.h"
#include "app/studio/features/scenario/path_tool.h"
#include "app/studio/features/table/taxel_order.h"
#include "app/studio/features/taxel/gesture.h"

namespace taxel::ui {

namespace {

/// The origin counts as the middle of a mesh that is as lopsided as this part of its width.
constexpr double kMiddle = 0.02;

void project_back(UiState& ui, const UiInput& input) {
  SetTaxels set;
  for (const int id : ui.selection.taxels) {
    const Taxel* taxel = find_taxel(input.editing.project->layout, id);
    if (taxel == nullptr) continue;
    const SurfacePlace place = place_near(*input.model->skin, taxel->center);
    TaxelChange change;
    change.id = id;
    change.center = place.position;
    change.normal = place.normal;
    set.changes.push_back(change);
  }
  ui.ask(EditProject{set, {}});
}

void hide(UiState& ui, const UiInput& input, bool others) {
  const Project& project = *input.editing.project;
  std::vector<int> hidden = others ? std::vector<int>{} : project.hidden;
  if (!others) {
    hidden.insert(hidden.end(), ui.selection.taxels.begin(), ui.selection.taxels.end());
  } else {
    for (const Taxel& taxel : project.layout.taxels) {
      if (!ui.selection.contains(taxel.id)) hidden.push_back(taxel.id);
    }
    std::vector<int> now = hidden;
    std::sort(now.begin(), now.end());
    if (now == project.hidden) hidden.clear();  // once more: all are shown again
  }
  ui.ask(EditProject{SetHidden{hidden}, {}});
  if (!others) ui.selection.clear();
}

/// Once more ends it.
void take_tool(Action action, UiState& ui) {
  const Tool tool = action == Action::place        ? Tool::place
                    : action == Action::box_select ? Tool::box
                    : action == Action::brush      ? Tool::brush
                                                   : Tool::lasso;
  const bool again = ui.tool.tool == tool;
  cancel_tool(ui);
  if (!again) ui.tool.tool = tool;
}

/// What is hidden is not selected unseen.
void keep_shown(UiState& ui, const UiInput& input) {
  if (ui.mode != Mode::layout || !input.editing.project) return;
  for (const int id : input.editing.project->hidden) ui.selection.remove(id);
}

bool perform_selection(Action action, UiState& ui, const UiInput& input) {
  switch (action) {
    case Action::select_all:
      ui.selection.set_all(*input.shown_layout(ui));
      keep_shown(ui, input);
      return true;
    case Action::select_none:
      ui.selection.clear();
      return true;
    case Action::invert_selection:
      ui.selection.invert(*input.shown_layout(ui));
      keep_shown(ui, input);
      return true;
    default:
      return false;
  }
}

bool perform_document(Action action, UiState& ui, bool scene) {
  switch (action) {
    case Action::save:
      ui.ask(SaveProject{});
      return true;
    case Action::save_as:
      scene ? ui.ask(SaveScene{}) : ui.ask(SaveProjectAs{});
      return true;
    case Action::export_layout:
      ui.ask(ExportFile{FileTask::export_layout, "", false, 0, 0});
      return true;
    case Action::export_taxels:
      ui.ask(ExportFile{FileTask::export_taxels, "", false, 0, 0});
      return true;
    case Action::export_samples:
      ui.ask(ExportFile{FileTask::export_samples, "", false, 0, 0});
      return true;
    case Action::export_sheet:
      ui.ask(ExportFile{FileTask::export_sheet, "", false, 0, 0});
      return true;
    case Action::export_picture:
      ui.ask(ExportFile{FileTask::export_picture, "", false, 0, 0});
      return true;
    case Action::export_recording:
      ui.ask(ExportFile{FileTask::export_recording, "", false, 0, 0});
      return true;
    case Action::export_video:
      ui.ask(ExportFile{FileTask::export_video, "", false, 0, 0});
      return true;
    case Action::import_recording:
      ui.ask(ReadRealRecording{});
      return true;
    case Action::export_frame:
      ui.ask(ExportFile{FileTask::export_frame, "", false, 0, 0});
      return true;
    case Action::undo:
      ui.ask(UndoStep{});
      return true;
    case Action::redo:
      ui.ask(RedoStep{});
      return true;
    case Action::copy:
      ui.ask(CopyTaxels{});
      return true;
    case Action::paste:
      ui.ask(PasteTaxels{});
      return true;
    default:
      return false;
  }
}

bool perform_gesture(Action action, UiState& ui, const UiInput& input) {
  switch (action) {
    case Action::move:
      begin_gesture(ui, input, Tool::move);
      return true;
    case Action::move_way_point:
      begin_gesture(ui, input, Tool::way_point);
      return true;
    case Action::turn:
      begin_gesture(ui, input, Tool::turn);
      return true;
    case Action::resize:
      begin_gesture(ui, input, Tool::resize);
      return true;
    case Action::duplicate:
      begin_gesture(ui, input, Tool::move, true);
      return true;
    case Action::gesture_x:
    case Action::gesture_y:
    case Action::gesture_z:
      constrain_gesture(ui, static_cast<int>(action) - static_cast<int>(Action::gesture_x));
      return true;
    case Action::gesture_accept:
      accept_gesture(ui, input);
      return true;
    case Action::gesture_cancel:
      cancel_tool(ui);
      return true;
    default:
      return false;
  }
}

}  // namespace

MirrorPlane mirror_plane_of(const Layout& layout, const Aabb& bounds) {
  MirrorPlane plane;
  plane.normal = glm::normalize(glm::cross(layout.frame.distal, layout.frame.pad));
  // Axes stay exact: what rounding left of a cross product is no tilt.
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(std::abs(plane.normal[axis]) - 1) < 1e-9) {
      const double sign = plane.normal[axis];
      plane.normal = dvec3(0);
      plane.normal[axis] = sign > 0 ? 1 : -1;
    }
  }
  const double width = glm::dot(glm::abs(plane.normal), bounds.extent());
  const double middle = glm::dot(plane.normal, bounds.center());
  if (std::abs(middle) > kMiddle * width) plane.point = middle * plane.normal;
  return plane;
}

bool perform_edit(Action action, UiState& ui, const UiInput& input) {
  if (perform_selection(action, ui, input) || perform_document(action, ui, input.is_scene) ||
      perform_gesture(action, ui, input)) {
    return true;
  }
  const std::vector<int>& ids = ui.selection.taxels;
  switch (action) {
    case Action::delete_taxels:
      ui.ask(EditProject{DeleteTaxels{ids}, {}});
      return true;
    case Action::project_back:
      project_back(ui, input);
      return true;
    case Action::rename_taxel:
      ui.saved.panels.taxels = true;
      ui.table.cell = {ids.back(), TableColumn::name, true, {}};
      return true;
    case Action::move_up:
    case Action::move_down:
      ui.ask(
          EditProject{ReorderTaxels{moved_by_one(input.editing.project->layout, ids, action == Action::move_up)}, {}});
      return true;
    case Action::mirror:
      ui.ask(EditProject{MirrorTaxels{ids, mirror_plane_of(input.editing.project->layout, input.model->mesh->bounds()),
                                      MirrorTaxels{}.tolerance, input.model->skin},
                         {}});
      return true;
    case Action::hide:
    case Action::isolate:
      hide(ui, input, action == Action::isolate);
      return true;
    case Action::show_all:
      ui.ask(EditProject{SetHidden{}, {}});
      return true;
    case Action::generate:
      toggle_generate(ui, input);
      return true;
    case Action::place:
    case Action::box_select:
    case Action::lasso_select:
    case Action::brush:
      take_tool(action, ui);
      return true;
    default:
      return false;
  }
}

bool is_edit_enabled(Action action, const UiState& ui, const UiInput& input) {
  const bool editable = can_edit(ui, input), selected = editable && !ui.selection.empty();
  switch (action) {
    case Action::select_all:
    case Action::invert_selection: {
      const Layout* layout = input.shown_layout(ui);
      return layout != nullptr && !layout->taxels.empty();
    }
    case Action::select_none:
      return !ui.selection.empty();
    case Action::save_as:
      return input.editing.project != nullptr || input.is_scene;
    case Action::save:
    case Action::export_layout:
    case Action::export_taxels:
    case Action::export_samples:
    case Action::export_sheet:
      return input.editing.project != nullptr;
    case Action::export_picture:
      return input.model != nullptr || input.frame != nullptr;
    case Action::export_frame:
      return input.frame != nullptr && !input.frame->sensors.empty();
    case Action::export_video:
      return input.frame != nullptr && input.frame->history.steps > 0 && !input.video.active;
    case Action::import_recording:
    case Action::export_recording:
      return input.frame != nullptr && input.frame->history.steps > 0 && !input.frame->sensors.empty();
    case Action::undo:
      return input.editing.undo_depth > 0;
    case Action::redo:
      return input.editing.redo_depth > 0;
    case Action::paste:
    case Action::place:
    case Action::brush:
    case Action::generate:
      return editable;
    case Action::lasso_select:
    case Action::box_select:
      return editable && !input.editing.project->layout.taxels.empty();
    case Action::show_all:
      return editable && !input.editing.project->hidden.empty();
    case Action::move_way_point:
      return has_way_point(ui, input);
    case Action::copy:
    case Action::duplicate:
    case Action::delete_taxels:
    case Action::move:
    case Action::turn:
    case Action::resize:
    case Action::project_back:
    case Action::rename_taxel:
    case Action::move_up:
    case Action::move_down:
    case Action::mirror:
    case Action::hide:
    case Action::isolate:
      return selected;
    default:
      return true;
  }
}

}  // namespace taxel::ui
