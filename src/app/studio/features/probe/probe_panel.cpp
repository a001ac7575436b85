#include "app/studio/features/probe/probe_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "app/studio/features/probe/probe_tool.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr double kSoftModulus = 100e3;  // of a probe that is made soft first [Pa]
constexpr double kThinnest = 1e-5, kSharpest = 1, kBluntest = 179;

/// A row with a choice out of names; the number of the one that was chosen now, or -1.
template <std::size_t N>
int choice_row(UiState& ui, const char* name, const std::array<const char*, N>& names, int chosen) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  int result = -1;
  const std::string id = std::string("##") + name;
  const bool open = ImGui::BeginCombo(id.c_str(), names[static_cast<std::size_t>(chosen)]);
  if (!open) ui.widgets.note_item(std::string("Probe/") + name);
  if (!open) return result;
  for (std::size_t i = 0; i < N; ++i) {
    if (selectable(ui, names[i], static_cast<int>(i) == chosen)) result = static_cast<int>(i);
  }
  ImGui::EndCombo();
  return result;
}

/// `size` of the sensor, which a probe may have as well [m].
void draw_shape(UiState& ui, double size) {
  constexpr std::array kKinds = {"Sphere", "Edge", "Point", "Mesh file"};
  ProbeSettings& s = ui.probe.settings;
  if (const int kind = choice_row(ui, "Shape", kKinds, static_cast<int>(s.kind)); kind >= 0)
    s.kind = static_cast<ProbeKind>(kind);
  switch (s.kind) {
    case ProbeKind::sphere:
      property_field(ui, "Radius", &s.sphere.radius, 1e3, "%.2f mm", kThinnest, size);
      break;
    case ProbeKind::edge:
      property_field(ui, "Length", &s.edge.length, 1e3, "%.2f mm", kThinnest, size);
      property_field(ui, "Angle", &s.edge.angle_deg, 1, "%.0f\u00b0", kSharpest, kBluntest);
      break;
    case ProbeKind::point:
      property_field(ui, "Height", &s.point.height, 1e3, "%.2f mm", kThinnest, size);
      property_field(ui, "Angle", &s.point.angle_deg, 1, "%.0f\u00b0", kSharpest, kBluntest);
      break;
    case ProbeKind::mesh:
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::AlignTextToFramePadding();
      ImGui::TextDisabled("File");
      ImGui::TableNextColumn();
      if (const auto file = text_field(ui, "Probe file", {s.mesh_file})) s.mesh_file = *file;
      tooltip("Path of a closed mesh, which is pressed along its -z");
      break;
  }
  if (s.kind == ProbeKind::edge || s.kind == ProbeKind::mesh)
    property_field(ui, "Turned", &s.roll_deg, 1, "%.0f\u00b0", -180, 180);
}

void draw_material(UiState& ui) {
  constexpr std::array kKinds = {"Rigid", "Soft"};
  Material& material = ui.probe.settings.material;
  const int kind = choice_row(ui, "Material", kKinds, material.compliant() ? 1 : 0);
  if (kind >= 0) material.modulus = kind == 1 ? kSoftModulus : 0;
  if (!material.compliant()) return;
  material.field = FieldKind::medial_axis;
  if (ui.probe.settings.kind != ProbeKind::sphere) material.field = FieldKind::pad;
  property_field(ui, "Modulus", &material.modulus, 1e-3, "%.0f kPa", 1e3, 1e8);
}

void draw_reading(const UiState& ui, const UiInput& input) {
  const PressedProbe* pressed = input.probe.get();
  const bool read = pressed != nullptr && pressed->problem.empty();
  property("Force", read ? fmt::format("{:.3f} N", pressed->force) : "\u2013");
  property("Contact area", read ? in_mm2(pressed->area) : "\u2013");
  property("Polygons", read ? grouped(pressed->polygons) : "\u2013");
  property("Peak pressure", read ? in_kpa(pressed->largest) : "\u2013");
  if (ui.probe.latency && input.performance.by_clock)
    property("After an edit in", fmt::format("{:.0f} ms", 1e3 * *ui.probe.latency));
}

}  // namespace

void draw_probe_panel(UiState& ui, const UiInput& input) {
  if (!ui.probe.on || ui.mode != Mode::layout || !input.model) return;
  const float line = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({ui.view.rect.x0 + 0.7f * line, ui.view.rect.y1 - 0.7f * line}, ImGuiCond_Appearing, {0, 1});
  ImGui::SetNextWindowSize({15.5f * line, 0});
  ImGui::SetNextWindowBgAlpha(0.92f);
  constexpr auto kFlags = ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                          ImGuiWindowFlags_NoScrollbar;
  bool open = true;
  if (ImGui::Begin("Probe", &open, kFlags)) {
    ui.widgets.note_item("Probe");
    if (begin_properties("probe")) {
      const double size = input.model->mesh->bounds().diagonal();
      draw_shape(ui, size);
      draw_material(ui);
      property_field(ui, "Depth", &ui.probe.settings.depth, 1e3, "%.2f mm", 0, kDeepestProbe * size);
      draw_reading(ui, input);
      end_properties();
    }
    if (!ui.probe.at) ImGui::TextDisabled("Point at the sensor.");
    if (input.probe && !input.probe->problem.empty()) {
      ImGui::PushTextWrapPos(0);
      ImGui::TextColored(palette(ui.dark).error, "%s", input.probe->problem.c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
  if (!open) leave_probe(ui);
}

}  // namespace taxel::ui
