#include "app/studio/nouns/taxel/taxel_commands.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/table/table_rows.h"
#include "app/studio/nouns/table/table_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/layout/field/receptive_field.h"
#include "core/layout/file/layout_json.h"
#include "ui/scene/scene_parts.h"

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

namespace taxel::ui {
namespace {

/// The origin is taken as the middle of a mesh if its distance to it is at most this fraction of the mesh's width.
constexpr double kMiddle = 0.02;

}  // namespace

MirrorPlane mirror_plane_of(const Layout& layout, const Aabb& bounds) {
  MirrorPlane plane;
  plane.normal = glm::normalize(glm::cross(layout.frame.distal, layout.frame.pad));
  // A normal along an axis becomes exact: the tilt is a rounding error of the cross product.
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

void carry_out(const BeginGesture& command, App& app) {
  begin_gesture(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<PathState>(), command.tool,
                command.copies);
}

void carry_out(const ConstrainGesture& command, App& app) {
  constrain_gesture(app.get<ToolState>(), command.axis);
}

void carry_out(const AcceptGesture&, App& app) {
  accept_gesture(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<PathState>());
}

void carry_out(const CancelTool&, App& app) {
  cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>());
}

void carry_out(const ToggleTool& command, App& app) {
  const bool active = app.get<ToolState>().tool == command.tool;
  cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>());
  if (!active) app.get<ToolState>().tool = command.tool;
}

void leave_tool(App& app) {
  if (app.get<ToolState>().tool != Tool::none) cancel_tool(*app.ui, app.viewer->selection, app.get<ToolState>());
}

void carry_out(const DeleteSelected&, App& app) {
  app.ui->post(EditProject{DeleteTaxels{app.viewer->selection.taxels}, {}});
}

void carry_out(const ProjectSelectedBack&, App& app) {
  SetTaxels set;
  for (const int id : app.viewer->selection.taxels) {
    const Taxel* taxel = find_taxel(app.shown->document.editing.project->layout, id);
    if (taxel == nullptr) continue;
    const SurfacePlace place = place_near(*app.shown->document.model->skin, taxel->center);
    TaxelChange change;
    change.id = id;
    change.center = place.position;
    change.normal = place.normal;
    set.changes.push_back(change);
  }
  app.ui->post(EditProject{set, {}});
}

void carry_out(const RenameSelected&, App& app) {
  app.get<PanelsShown>()[kTaxelTable] = true;
  app.get<TableState>().cell = {app.viewer->selection.taxels.back(), TableColumn::name, true, {}};
}

void carry_out(const MoveInOrder& command, App& app) {
  const Layout& layout = app.shown->document.editing.project->layout;
  app.ui->post(EditProject{ReorderTaxels{moved_by_one(layout, app.viewer->selection.taxels, command.earlier)}, {}});
}

void carry_out(const MirrorSelected&, App& app) {
  const MirrorPlane plane =
      mirror_plane_of(app.shown->document.editing.project->layout, app.shown->document.model->mesh->bounds());
  app.ui->post(EditProject{
      MirrorTaxels{app.viewer->selection.taxels, plane, MirrorTaxels{}.tolerance, app.shown->document.model->skin},
      {}});
}

void carry_out(const HideSelected&, App& app) {
  std::vector<int> hidden = app.shown->document.editing.project->hidden;
  hidden.insert(hidden.end(), app.viewer->selection.taxels.begin(), app.viewer->selection.taxels.end());
  app.ui->post(EditProject{SetHidden{hidden}, {}});
  app.viewer->selection.clear();
}

void carry_out(const ShowOnlySelected&, App& app) {
  const Project& project = *app.shown->document.editing.project;
  std::vector<int> hidden;
  for (const Taxel& taxel : project.layout.taxels) {
    if (!app.viewer->selection.contains(taxel.id)) hidden.push_back(taxel.id);
  }
  std::vector<int> ascending = hidden;
  std::sort(ascending.begin(), ascending.end());
  if (ascending == project.hidden) hidden.clear();
  app.ui->post(EditProject{SetHidden{hidden}, {}});
}

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::CopyTaxels&, Host& host) {
  if (!host.edits().is_open()) return;
  const Layout& layout = host.edits().project()->layout;
  std::vector<Taxel> taxels;
  for (const int index : ui::selected_indices(host.app.viewer->selection, layout))
    taxels.push_back(layout.taxels[static_cast<std::size_t>(index)]);
  if (!taxels.empty()) ImGui::SetClipboardText(taxels_to_json(taxels).c_str());
}

void carry_out(const ui::PasteTaxels&, Host& host) {
  edit_document(host, [&](EditSession& edits) {
    const char* const text = ImGui::GetClipboardText();
    const std::vector<Taxel> taxels =
        with_unused_ids(parse_taxels(text != nullptr ? text : ""), edits.project()->layout);
    edits.edit(AddTaxels{taxels, std::nullopt});
    host.app.viewer->selection.clear();
    for (const Taxel& taxel : taxels) host.app.viewer->selection.add(taxel.id);
  });
}

}  // namespace taxel::studio
