#include "app/studio/nouns/taxel/gesture.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studio/frame/shown_scene.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/scenario/path_tool.h"
#include "core/layout/field/field_disc.h"
#include "ui/scene/scene_cast.h"

namespace taxel::ui {

namespace {

/// Returns whether a linked mirrored taxel of the taxel is in the list. The taxel then follows the mirrored taxel and
/// must not be changed on its own.
bool twin_listed(const Project& project, int id, const std::vector<Taxel>& taxels) {
  const auto listed = [&](int other) {
    return std::any_of(taxels.begin(), taxels.end(), [other](const Taxel& taxel) { return taxel.id == other; });
  };
  for (const Mirror& mirror : project.mirrors) {
    for (const MirrorLink& link : mirror.links) {
      if ((link.taxel == id && listed(link.image)) || (link.image == id && listed(link.taxel))) return true;
    }
  }
  return false;
}

/// Returns the selected taxels, the active taxel last.
std::vector<Taxel> selected_taxels(const Selection& selection, const Project& project, bool without_twins) {
  std::vector<Taxel> taxels;
  for (auto id = selection.taxels.rbegin(); id != selection.taxels.rend(); ++id) {
    const Taxel* taxel = find_taxel(project.layout, *id);
    if (taxel == nullptr || (without_twins && twin_listed(project, *id, taxels))) continue;
    taxels.push_back(*taxel);
  }
  std::reverse(taxels.begin(), taxels.end());
  return taxels;
}

/// Starts to follow the pointer and the keys with the tool.
void follow_with(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool_state, const PathState& path,
                 Tool tool) {
  std::vector<Taxel> start = std::move(tool_state.start);
  end_tool(tool_state);
  tool_state.start = std::move(start);
  tool_state.tool = tool;
  ++tool_state.gesture;
  tool_state.selection = viewer.selection;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse(io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y);  // this frame still follows it
  tool_state.pointer_start = {static_cast<double>(mouse.x - viewer.view.rect.x0),
                              static_cast<double>(mouse.y - viewer.view.rect.y0)};
  tool_state.input = {};
  tool_state.input.pointer = tool_state.pointer_start;
  follow_gesture(ui, viewer, shown, tool_state, path);
}

/// Returns the radius of a taxel to be placed: as of the taxels around it, otherwise a fraction of the mesh's size.
double radius_for_new(const Selection& selection, const DocumentView& document, const ToolState& tool) {
  const Layout& layout = document.editing.project->layout;
  const std::optional<int> active = selection.active();
  if (const Taxel* taxel = active ? find_taxel(layout, *active) : nullptr) return taxel->radius;
  if (tool.radius > 0) return tool.radius;
  if (!layout.taxels.empty()) return layout.taxels.back().radius;
  constexpr double kPartOfMesh = 0.15;
  return std::min(Taxel{}.radius, kPartOfMesh * document.model->mesh->bounds().diagonal());
}

}  // namespace

void end_tool(ToolState& tool) {
  tool.tool = Tool::none;
  tool.start.clear();
  tool.done.reset();
  tool.area.clear();
  tool.value.clear();
  tool.problem.clear();
  tool.pressed_taxel = -1;
  tool.released = false;
}

void follow_gesture(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const PathState& path) {
  if (tool.done && *tool.done == tool.input) return;
  tool.done = tool.input;
  GestureEdit result = tool.tool == Tool::way_point ? moved_way_point(viewer, shown, tool, path)
                                                    : gesture_edit(tool, gesture_view(viewer, shown));
  if (!result.edit) return;
  tool.value = std::move(result.value);
  ui.post(EditProject{std::move(*result.edit), {tool.gesture, true}});
}

GestureView gesture_view(const Viewer& viewer, const Shown& shown) {
  return {viewer.camera(), viewer.view.width, viewer.view.height, shown_pose(viewer, shown),
          shown.document.model ? shown.document.model->skin.get() : nullptr};
}

void begin_gesture(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool_state, PathState& path, Tool tool,
                   bool copies) {
  if (tool == Tool::way_point && take_way_point(viewer, shown, path))
    return follow_with(ui, viewer, shown, tool_state, path, tool);
  if (!can_edit(viewer, shown)) return;
  const Project& project = *shown.document.editing.project;
  std::vector<Taxel> taxels = selected_taxels(viewer.selection, project, !copies);
  if (taxels.empty()) return;
  const Selection before = viewer.selection;
  if (copies) {
    const std::vector<int> ids = unused_ids(project.layout, taxels.size());
    for (std::size_t i = 0; i < taxels.size(); ++i) taxels[i].id = ids[i];
    viewer.selection.taxels = ids;
  }
  tool_state.start = std::move(taxels);
  tool_state.adds = copies;
  follow_with(ui, viewer, shown, tool_state, path, tool);
  tool_state.selection = before;
}

void accept_gesture(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const PathState& path) {
  follow_gesture(ui, viewer, shown, tool, path);  // applies text typed in the same frame as Enter
  ui.post(EndGesture{});
  end_tool(tool);
}

void cancel_tool(WindowUi& ui, Selection& selection, ToolState& tool) {
  if (tool.follows()) {
    ui.post(CancelGesture{tool.gesture});
    selection = tool.selection;
  }
  if (std::exchange(tool.brush.painting, false)) ui.post(CancelGesture{tool.gesture});
  end_tool(tool);
}

void type_number(ToolState& tool) {
  std::string& typed = tool.input.typed;
  for (const ImWchar c : ImGui::GetIO().InputQueueCharacters) {
    if (c >= '0' && c <= '9') typed += static_cast<char>(c);
    if ((c == '.' || c == ',') && typed.find('.') == std::string::npos) typed += '.';
    if (c == '-') typed = typed.starts_with('-') ? typed.substr(1) : "-" + typed;
  }
  if (ImGui::IsKeyPressed(ImGuiKey_Backspace) && !typed.empty()) typed.pop_back();
}

void constrain_gesture(ToolState& tool, int axis) {
  if (tool.tool == Tool::resize || tool.tool == Tool::slide) return;
  tool.input.axis = tool.input.axis == axis ? -1 : axis;
}

std::optional<PlacementGhost> placement_ghost(const Viewer& viewer, const Shown& displayed, const ToolState& tool,
                                              double x, double y) {
  if (!can_edit(viewer, displayed)) return std::nullopt;
  const SensorModel& model = *displayed.document.model;
  const auto shown = shown_part(viewer.clip, viewer.camera().pixel_ray(x, y, viewer.view.width, viewer.view.height));
  if (!shown) return std::nullopt;
  const auto place = place_under(*model.skin, in_frame(shown_pose(viewer, displayed), shown->ray));
  if (!place) return std::nullopt;
  PlacementGhost ghost;
  ghost.taxel.center = place->position;
  ghost.taxel.normal = place->normal;
  ghost.taxel.radius = radius_for_new(viewer.selection, displayed.document, tool);
  const FieldAngle angle(model.layout.receptive_field);
  for (const SurfaceSample& sample : model.samples) {
    const dvec3 d = sample.position - place->position;
    if (glm::dot(d, d) > ghost.taxel.radius * ghost.taxel.radius) continue;
    const dvec3 normal =
        field_normal(model.layout.receptive_field.normals, model.skin->mesh(), sample.face, sample.position);
    if (angle.factor(glm::dot(normal, glm::normalize(place->normal))) > 0) ++ghost.samples;
  }
  return ghost;
}

void place_taxel(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, double x, double y) {
  std::optional<PlacementGhost> ghost = placement_ghost(viewer, shown, tool, x, y);
  if (!ghost) return;
  ghost->taxel.id = unused_ids(shown.document.editing.project->layout, 1).front();
  tool.radius = ghost->taxel.radius;
  ui.post(EditProject{AddTaxels{{ghost->taxel}, std::nullopt}, {}});
  viewer.selection.set(ghost->taxel.id);
}

void resize_by_wheel(WindowUi& ui, const Selection& selection, const DocumentView& document, ToolState& tool,
                     double notches) {
  // Factor on the radius per notch, and the pause after which a new step of the history begins [s].
  constexpr double kPerNotch = 1.02, kPause = 1.0;
  const std::vector<Taxel> taxels = selected_taxels(selection, *document.editing.project, true);
  if (taxels.empty()) return;
  const double now = ImGui::GetTime();
  if (tool.wheel_at < 0 || now - tool.wheel_at > kPause || tool.selection != selection) ++tool.gesture;
  tool.wheel_at = now;
  tool.selection = selection;
  SetTaxels set;
  for (const Taxel& taxel : taxels) {
    TaxelChange change;
    change.id = taxel.id;
    change.radius = taxel.radius * std::pow(kPerNotch, notches);
    set.changes.push_back(change);
  }
  ui.post(EditProject{set, {tool.gesture, false}});
}

}  // namespace taxel::ui
