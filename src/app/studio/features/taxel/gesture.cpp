#include "app/studio/features/taxel/gesture.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/features/scenario/path_tool.h"
#include "ui/scene/scene_cast.h"

namespace taxel::ui {

namespace {

/// Whether a linked twin of the taxel stands in the list: it would follow, and must not be changed on its own.
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

/// The selected taxels, the active one last.
std::vector<Taxel> selected_taxels(const UiState& ui, const Project& project, bool without_twins) {
  std::vector<Taxel> taxels;
  for (auto id = ui.selection.taxels.rbegin(); id != ui.selection.taxels.rend(); ++id) {
    const Taxel* taxel = find_taxel(project.layout, *id);
    if (taxel == nullptr || (without_twins && twin_listed(project, *id, taxels))) continue;
    taxels.push_back(*taxel);
  }
  std::reverse(taxels.begin(), taxels.end());
  return taxels;
}

/// From here on pointer and keys say what the tool does.
void follow_with(UiState& ui, const UiInput& input, Tool tool) {
  ToolState& state = ui.tool;
  std::vector<Taxel> start = std::move(state.start);
  end_tool(ui);
  state.start = std::move(start);
  state.tool = tool;
  ++state.gesture;
  state.selection = ui.selection;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 mouse(io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y);  // this picture follows it yet
  state.pointer_start = {static_cast<double>(mouse.x - ui.view.rect.x0),
                         static_cast<double>(mouse.y - ui.view.rect.y0)};
  state.input = {};
  state.input.pointer = state.pointer_start;
  follow_gesture(ui, input);
}

/// Radius of a taxel to be placed: as those around it, else a part of the mesh.
double radius_for_new(const UiState& ui, const UiInput& input) {
  const Layout& layout = input.editing.project->layout;
  const std::optional<int> active = ui.selection.active();
  if (const Taxel* taxel = active ? find_taxel(layout, *active) : nullptr) return taxel->radius;
  if (ui.tool.radius > 0) return ui.tool.radius;
  if (!layout.taxels.empty()) return layout.taxels.back().radius;
  constexpr double kPartOfMesh = 0.15;
  return std::min(Taxel{}.radius, kPartOfMesh * input.model->mesh->bounds().diagonal());
}

}  // namespace

void end_tool(UiState& ui) {
  ToolState& tool = ui.tool;
  tool.tool = Tool::none;
  tool.start.clear();
  tool.done.reset();
  tool.area.clear();
  tool.value.clear();
  tool.problem.clear();
  tool.pressed_taxel = -1;
  tool.released = false;
}

void follow_gesture(UiState& ui, const UiInput& input) {
  ToolState& tool = ui.tool;
  if (tool.done && *tool.done == tool.input) return;
  tool.done = tool.input;
  GestureEdit result =
      tool.tool == Tool::way_point ? moved_way_point(ui, input) : gesture_edit(tool, gesture_view(ui, input));
  if (!result.edit) return;
  tool.value = std::move(result.value);
  ui.ask(EditProject{std::move(*result.edit), {tool.gesture, true}});
}

GestureView gesture_view(const UiState& ui, const UiInput& input) {
  return {ui.camera(), ui.view.width, ui.view.height, shown_pose(ui, input),
          input.model ? input.model->skin.get() : nullptr};
}

void begin_gesture(UiState& ui, const UiInput& input, Tool tool, bool copies) {
  if (tool == Tool::way_point && take_way_point(ui, input)) return follow_with(ui, input, tool);
  if (!can_edit(ui, input)) return;
  const Project& project = *input.editing.project;
  std::vector<Taxel> taxels = selected_taxels(ui, project, !copies);
  if (taxels.empty()) return;
  ToolState& state = ui.tool;
  const Selection before = ui.selection;
  if (copies) {
    const std::vector<int> ids = unused_ids(project.layout, taxels.size());
    for (std::size_t i = 0; i < taxels.size(); ++i) taxels[i].id = ids[i];
    ui.selection.taxels = ids;
  }
  state.start = std::move(taxels);
  state.adds = copies;
  follow_with(ui, input, tool);
  state.selection = before;
}

void accept_gesture(UiState& ui, const UiInput& input) {
  follow_gesture(ui, input);  // what was typed together with Enter
  ui.ask(EndGesture{});
  end_tool(ui);
}

void cancel_tool(UiState& ui) {
  if (ui.tool.follows()) {
    ui.ask(CancelGesture{ui.tool.gesture});
    ui.selection = ui.tool.selection;
  }
  if (std::exchange(ui.tool.brush.painting, false)) ui.ask(CancelGesture{ui.tool.gesture});
  end_tool(ui);
}

void type_number(UiState& ui) {
  std::string& typed = ui.tool.input.typed;
  for (const ImWchar c : ImGui::GetIO().InputQueueCharacters) {
    if (c >= '0' && c <= '9') typed += static_cast<char>(c);
    if ((c == '.' || c == ',') && typed.find('.') == std::string::npos) typed += '.';
    if (c == '-') typed = typed.starts_with('-') ? typed.substr(1) : "-" + typed;
  }
  if (ImGui::IsKeyPressed(ImGuiKey_Backspace) && !typed.empty()) typed.pop_back();
}

void constrain_gesture(UiState& ui, int axis) {
  if (ui.tool.tool == Tool::resize || ui.tool.tool == Tool::slide) return;
  ui.tool.input.axis = ui.tool.input.axis == axis ? -1 : axis;
}

std::optional<PlacementGhost> placement_ghost(const UiState& ui, const UiInput& input, double x, double y) {
  if (!can_edit(ui, input)) return std::nullopt;
  const SensorModel& model = *input.model;
  const auto shown = shown_part(ui.clip, ui.camera().pixel_ray(x, y, ui.view.width, ui.view.height));
  if (!shown) return std::nullopt;
  const auto place = place_under(*model.skin, in_frame(shown_pose(ui, input), shown->ray));
  if (!place) return std::nullopt;
  PlacementGhost ghost;
  ghost.taxel.center = place->position;
  ghost.taxel.normal = place->normal;
  ghost.taxel.radius = radius_for_new(ui, input);
  const double cosine = std::cos(glm::radians(model.layout.receptive_field.max_angle_deg));
  for (const SurfaceSample& sample : model.samples) {
    const dvec3 d = sample.position - place->position;
    if (glm::dot(d, d) > ghost.taxel.radius * ghost.taxel.radius) continue;
    if (glm::dot(sample.normal, place->normal) >= cosine) ++ghost.samples;
  }
  return ghost;
}

void place_taxel(UiState& ui, const UiInput& input, double x, double y) {
  std::optional<PlacementGhost> ghost = placement_ghost(ui, input, x, y);
  if (!ghost) return;
  ghost->taxel.id = unused_ids(input.editing.project->layout, 1).front();
  ui.tool.radius = ghost->taxel.radius;
  ui.ask(EditProject{AddTaxels{{ghost->taxel}, std::nullopt}, {}});
  ui.selection.set(ghost->taxel.id);
}

void resize_by_wheel(UiState& ui, const UiInput& input, double notches) {
  constexpr double kPerNotch = 1.02, kPause = 1.0;  // [s]
  const std::vector<Taxel> taxels = selected_taxels(ui, *input.editing.project, true);
  if (taxels.empty()) return;
  ToolState& tool = ui.tool;
  const double now = ImGui::GetTime();
  if (tool.wheel_at < 0 || now - tool.wheel_at > kPause || tool.selection != ui.selection) ++tool.gesture;
  tool.wheel_at = now;
  tool.selection = ui.selection;
  SetTaxels set;
  for (const Taxel& taxel : taxels) {
    TaxelChange change;
    change.id = taxel.id;
    change.radius = taxel.radius * std::pow(kPerNotch, notches);
    set.changes.push_back(change);
  }
  ui.ask(EditProject{set, {tool.gesture, false}});
}

}  // namespace taxel::ui
