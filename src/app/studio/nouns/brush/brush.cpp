#include "app/studio/nouns/brush/brush.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "core/mesh/repair/repaired_mesh.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

constexpr double kPartOfMesh = 0.06, kPerNotch = 1.1, kLeastPart = 1e-3;
/// The distance between two places of a fast stroke, in brush radii on the screen, and the largest number of places in
/// one frame.
constexpr double kStrokeStep = 0.5;
constexpr int kMostSteps = 64;

/// Returns the number of pixels of the view that the brush's radius covers at a place.
double radius_in_pixels(const Viewer& viewer, const GestureView& view, const SurfacePlace& place, double radius) {
  const Camera& camera = viewer.camera();
  const double depth = std::max(1e-9, glm::distance(camera.eye(), view.X_WM * place.position));
  return radius / camera.pixel_size(depth, viewer.view.height);
}

SurfacePoint surface_point(const SurfacePlace& place) {
  SurfacePoint point;
  point.position = place.position;
  point.face = place.face;
  return point;
}

/// Paints from the last place of the stroke to the pointer.
void stroke_to(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, const dvec2& to) {
  BrushState& brush = tool.brush;
  const SensorModel& model = *shown.document.model;
  const GestureView view = gesture_view(viewer, shown);
  const double radius = brush_radius(tool, model);
  const dvec2 from = brush.last.value_or(to);
  if (brush.last == to) return;
  const auto first = place_under(*model.skin, view.ray_M(from));
  const double step = first ? std::max(1.0, kStrokeStep * radius_in_pixels(viewer, view, *first, radius)) : 1.0;
  const int steps = std::clamp(static_cast<int>(std::ceil(glm::distance(from, to) / step)), 1, kMostSteps);
  std::vector<int> region = brush.region;
  for (int i = brush.last ? 1 : steps; i <= steps; ++i) {
    const dvec2 pixel = glm::mix(from, to, static_cast<double>(i) / steps);
    const auto place = place_under(*model.skin, view.ray_M(pixel));
    if (!place) continue;
    const std::vector<int> faces = mesh_faces(model, faces_under_brush(*model.skin, surface_point(*place), {radius}));
    region = brush.erases ? without_faces(region, faces) : with_faces(region, faces);
  }
  brush.last = to;
  if (region == brush.region) return;
  brush.region = std::move(region);
  ui.post(EditProject{SetRegion{brush.region}, {tool.gesture, true}});
}

void begin_stroke(const DocumentView& document, ToolState& tool) {
  const ImGuiIO& io = ImGui::GetIO();
  BrushState& brush = tool.brush;
  brush.painting = true;
  brush.erases = io.KeyShift || io.KeyCtrl;
  brush.region = *document.editing.project->layout.sampling.region;
  brush.last.reset();
  ++tool.gesture;
}

}  // namespace

double brush_radius(const ToolState& tool, const SensorModel& model) {
  const double size = model.mesh->bounds().diagonal();
  return tool.brush.radius > 0 ? tool.brush.radius : kPartOfMesh * size;
}

void set_brush_radius(ToolState& tool, const SensorModel& model, double radius) {
  const double size = model.mesh->bounds().diagonal();
  if (!(radius > 0) || !std::isfinite(radius)) {
    tool.problem = "Brush radius: must be greater than 0";
    return;
  }
  tool.brush.radius = std::min(radius, size);
}

void resize_brush(ToolState& tool, const SensorModel& model, double notches) {
  const double least = kLeastPart * model.mesh->bounds().diagonal();
  set_brush_radius(tool, model, std::max(least, brush_radius(tool, model) * std::pow(kPerNotch, notches)));
}

bool brush_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, ToolState& tool, double x, double y,
                 bool hovered) {
  BrushState& brush = tool.brush;
  if (!brush.painting) {
    const bool pressed = hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (!pressed || !brush_place(viewer, shown, x, y)) return false;  // off the skin, a drag turns the camera
    begin_stroke(shown.document, tool);
  }
  stroke_to(ui, viewer, shown, tool, {x, y});
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return true;
  brush.painting = false;
  brush.region.clear();
  ui.post(EndGesture{});
  return true;
}

std::optional<SurfacePlace> brush_place(const Viewer& viewer, const Shown& shown, double x, double y) {
  if (!can_edit(viewer, shown)) return std::nullopt;
  return place_under(*shown.document.model->skin, gesture_view(viewer, shown).ray_M({x, y}));
}

void change_region(WindowUi& ui, const Viewer& viewer, const Shown& shown, RegionChange change) {
  if (!can_edit(viewer, shown)) return;
  const SensorModel& model = *shown.document.model;
  std::vector<int> all(static_cast<std::size_t>(model.skin->mesh().face_count()));
  std::iota(all.begin(), all.end(), 0);
  all = mesh_faces(model, all);
  const std::vector<int>& region = *shown.document.editing.project->layout.sampling.region;
  std::vector<int> changed;
  if (change == RegionChange::all) changed = all;
  if (change == RegionChange::invert) changed = without_faces(all, region);
  if (changed != region) ui.post(EditProject{SetRegion{changed}, {}});
}

std::vector<int> mesh_faces(const SensorModel& model, const std::vector<int>& skin_faces) {
  std::vector<int> faces;
  faces.reserve(skin_faces.size());
  for (const int face : skin_faces) faces.push_back(model.skin_face_of[static_cast<std::size_t>(face)]);
  return loaded_faces(*model.repaired, faces);
}

std::vector<int> skin_faces(const SensorModel& model, const std::vector<int>& mesh_faces) {
  std::vector<int> faces;
  for (std::size_t i = 0; i < model.skin_face_of.size(); ++i) {
    const int face = model.repaired->loaded_face(model.skin_face_of[i]);
    if (std::binary_search(mesh_faces.begin(), mesh_faces.end(), face)) faces.push_back(static_cast<int>(i));
  }
  return faces;
}

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
