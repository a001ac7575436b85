#include "app/studio/nouns/brush/brush_card.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/view_drawing.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/brush/brush.h"
#include "app/studio/nouns/taxel/gesture.h"
#include "core/mesh/loaded_faces.h"
#include "ui/scene/geometry/field_ring.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr double kBrushAngleDeg = SurfaceBrush{}.max_angle_deg;

std::string painted_text(const SensorModel& model, const std::vector<int>& region) {
  if (region.empty()) return "Nothing painted: the whole skin senses";
  const double area = area_of_faces(*model.mesh, repaired_faces(*model.repaired, region)),
               whole = model.skin->mesh().area();
  return fmt::format("Painted: {} ({:.1f} % of the skin)", in_mm2(area), 100 * area / whole);
}

void draw_contents(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool) {
  const SensorModel& model = *shown.document.model;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Brush radius (mm)");
  ImGui::SameLine();
  const float field = 5 * ImGui::GetFontSize();
  if (const auto radius = number_field(ui, "Brush radius (mm)", {brush_radius(tool, model)}, kMillimetres, field))
    set_brush_radius(tool, model, *radius);
  tooltip("Faces within this distance of the pointer are painted [mm]. The wheel changes it by 10 %.");
  ImGui::TextUnformatted(painted_text(model, *shown.document.editing.project->layout.sampling.region).c_str());
  ui.widgets.note_item("Painted area");
  tooltip(
      "Samples lie on the painted faces only, and Generate > Spread evenly fills them;\n"
      "where none is painted, both take the whole skin. Saved with the layout.");
  if (button(ui, "Clear")) change_region(ui, viewer, shown, RegionChange::clear);
  tooltip("Nothing is painted any more");
  ImGui::SameLine();
  if (button(ui, "Invert")) change_region(ui, viewer, shown, RegionChange::invert);
  tooltip("Paint the unpainted faces, and clear the painted ones");
  ImGui::SameLine();
  if (button(ui, "All")) change_region(ui, viewer, shown, RegionChange::all);
  tooltip("Paint every face of the skin; Shift+drag then takes some away");
  ImGui::SameLine();
  if (button(ui, "Done")) cancel_tool(ui, viewer.selection, tool);
  tooltip("Put the brush away (Esc, Q)");
}

void draw_brush_card(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool) {
  if (tool.tool != Tool::brush || !can_edit(viewer, shown)) return;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  const float line = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(
      {viewer.view.rect.x0 + viewer.view.strip + 0.8f * line - 6, viewer.view.rect.y0 + 4.8f * line});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).panel);
  if (ImGui::Begin("Brush", nullptr, kFlags)) draw_contents(ui, viewer, shown, tool);
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace

void draw_brush_ring(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool) {
  if (tool.tool != Tool::brush || !(ImGui::IsItemHovered() || tool.brush.painting)) return;
  const ImGuiIO& io = ImGui::GetIO();
  const double x = static_cast<double>(io.MousePos.x - viewer.view.rect.x0);
  const double y = static_cast<double>(io.MousePos.y - viewer.view.rect.y0);
  const auto place = brush_place(viewer, shown, x, y);
  if (!place) return;
  const Palette& colors = palette(ui.dark);
  const bool erases = tool.brush.painting ? tool.brush.erases : io.KeyShift || io.KeyCtrl;
  const ImU32 color = to_u32(erases ? colors.error : colors.accent);
  const Pose X_WM = shown_pose(viewer, shown);
  const auto pixel_of = [&](const dvec3& p_M) { return on_screen(viewer, X_WM * p_M); };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double radius = brush_radius(tool, *shown.document.model);
  for (const RingPiece& piece :
       field_ring(*shown.document.model->skin, place->position, radius, place->normal, kBrushAngleDeg)) {
    const dvec3 normal = shown.document.model->skin->mesh().face_normals()[static_cast<std::size_t>(piece.face)];
    const dvec3 eye_M = X_WM.inverse() * viewer.camera().eye();
    if (glm::dot(normal, eye_M - piece.a) > 0) list.AddLine(pixel_of(piece.a), pixel_of(piece.b), color, 2.0f);
  }
  list.AddCircleFilled(pixel_of(place->position), 2.5f, color);
}

constinit const Feature kBrush{
    .draw_card = [](App& app) { draw_brush_card(*app.ui, *app.viewer, *app.shown, app.get<ToolState>()); },
    .draw_on_view = [](const App& app) { draw_brush_ring(*app.ui, *app.viewer, *app.shown, app.get<ToolState>()); },
};

}  // namespace taxel::ui
