// Tip and pad direction of the edited finger: arrows while the directions are a guess, and clicks that set them.
#include "app/studio/nouns/mesh/mesh_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/layout/sensor_frame.h"
#include "ui/theme.h"

namespace taxel::ui {

std::vector<FrameArrow> frame_arrows(const Viewer& viewer, const Shown& displayed, const MeshState& mesh) {
  const bool shown = mesh.frame_is_guess || mesh.pick != FramePick::none;
  if (!shown || viewer.mode != Mode::layout || !displayed.document.editing.project || !displayed.document.model)
    return {};
  constexpr double kBeyond = 1.3;  // arrow length as a fraction of the distance from the middle to the box
  const Aabb box = displayed.document.model->mesh->bounds();
  const Pose X_WM = shown_pose(viewer, displayed);
  const SensorFrame& frame = displayed.document.editing.project->layout.frame;
  const auto arrow = [&](const char* name, const dvec3& direction) {
    const double reach = 0.5 * glm::dot(glm::abs(direction), box.extent());
    return FrameArrow{name, X_WM * box.center(), X_WM * (box.center() + kBeyond * reach * direction)};
  };
  return {arrow("tip", frame.distal), arrow("pad", frame.pad)};
}

void set_frame(WindowUi& ui, MeshState& mesh, const SensorFrame& frame) {
  mesh.frame_is_guess = false;
  mesh.pick = FramePick::none;
  ui.post(EditProject{SetFrame{frame}, {}});
}

SensorFrame with_direction(SensorFrame frame, FramePick what, const dvec3& direction) {
  const SensorFrame before = frame;
  dvec3& set = what == FramePick::tip ? frame.distal : frame.pad;
  dvec3& other = what == FramePick::tip ? frame.pad : frame.distal;
  set = snapped_to_axis(direction);
  // If the new direction is nearly parallel to the other one, the two directions are exchanged.
  if (std::abs(glm::dot(set, other)) > 0.9) other = what == FramePick::tip ? before.distal : before.pad;
  other = glm::normalize(other - glm::dot(other, set) * set);
  return frame;
}

bool pick_frame(WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool, MeshState& mesh,
                double x, double y) {
  if (mesh.pick == FramePick::none || viewer.mode != Mode::layout) return false;
  const std::optional<PlacementGhost> under = placement_ghost(viewer, shown, tool, x, y);
  if (!under) return true;
  set_frame(ui, mesh, with_direction(shown.document.editing.project->layout.frame, mesh.pick, under->taxel.normal));
  return true;
}

namespace {

/// Draws the directions of the finger's tip and pad while the directions are a guess or are being set.
void draw_frame_arrows(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const MeshState& mesh,
                       ImDrawList& list) {
  for (const FrameArrow& arrow : frame_arrows(viewer, shown, mesh)) {
    const ImVec2 from = on_screen(viewer, arrow.from_W), to = on_screen(viewer, arrow.to_W);
    const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy), unit = ImGui::GetFontSize();
    const ImU32 color = to_u32(palette(ui.dark).accent);
    if (length > 1) {
      const ImVec2 ahead(dx / length, dy / length), base(to.x - 0.8f * unit * ahead.x, to.y - 0.8f * unit * ahead.y);
      list.AddLine(from, base, color, 0.2f * unit);
      list.AddTriangleFilled(to, {base.x - 0.35f * unit * ahead.y, base.y + 0.35f * unit * ahead.x},
                             {base.x + 0.35f * unit * ahead.y, base.y - 0.35f * unit * ahead.x}, color);
    }
    // A plate below the name: the arrow, taxels or a skin of the same colour may be behind it.
    const ImVec2 at(to.x + 0.6f * unit, to.y - 0.5f * unit), size = ImGui::CalcTextSize(arrow.name.c_str());
    list.AddRectFilled({at.x - 3, at.y - 1}, {at.x + size.x + 3, at.y + size.y + 1},
                       to_u32(palette(ui.dark).panel, 0.85f), 3);
    list.AddText(at, color, arrow.name.c_str());
  }
}

/// Returns the text about the next click. Empty if no direction of the finger is being set.
std::string pick_hint(const MeshState& mesh) {
  if (mesh.pick == FramePick::none) return "";
  return fmt::format("Click a face of the {}   Esc ends", mesh.pick == FramePick::tip ? "tip" : "pad");
}

bool point_mesh_frame(App& app, const PointerEvent& event) {
  return event.left().clicked() && pick_frame(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(),
                                              app.get<MeshState>(), event.at.x, event.at.y);
}

}  // namespace

constinit const Feature kMeshFrame{
    .tool = {"mesh_frame", kEverywhere, point_mesh_frame, 8,
             [](const App& app) { return app.get<MeshState>().pick != FramePick::none; },
             [](App& app) { app.get<MeshState>().pick = FramePick::none; }},
    .draw_on_view =
        [](const App& app) {
          draw_frame_arrows(*app.ui, *app.viewer, *app.shown, app.get<MeshState>(), *ImGui::GetWindowDrawList());
        },
    .hint =
        [](const App& app, std::vector<ViewHint>& lines) {
          if (app.viewer->mode == Mode::layout) lines.push_back({pick_hint(app.get<MeshState>())});
        },
};

}  // namespace taxel::ui
