// A small window over the 3-D view with the settings and the readings of the probe.
#include "app/studio/nouns/probe/probe_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr float kRoomBelowTools = 36;  ///< height of a view with room below the tools, in heights of text

constexpr double kSoftModulus = 100e3;  // initial modulus of a soft probe [Pa]
constexpr double kThinnest = 1e-5, kSharpest = 1, kBluntest = 179;

/// Draws a row with a choice of names. Returns the index of the name that the user chooses now.
std::optional<std::size_t> choice_row(WindowUi& ui, const char* name, const std::vector<const char*>& names,
                                      std::size_t chosen) {
  begin_property(name);
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo((std::string("##") + name).c_str(), names[chosen]);
  if (!open) ui.widgets.note_item(std::string("Probe/") + name);
  std::optional<std::size_t> result;
  if (!open) return result;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (selectable(ui, names[i], i == chosen)) result = i;
  ImGui::EndCombo();
  return result;
}

void draw_field(WindowUi& ui, const FieldSpec& field, double& value, double size) {
  if (field.quantity == FieldQuantity::angle)
    property_field(ui, field.label, &value, 1, "%.0f\u00b0", kSharpest, kBluntest);
  else
    property_field(ui, field.label, &value, 1e3, "%.2f mm", kThinnest, size);
}

void draw_field(WindowUi& ui, const FieldSpec& field, std::string& file, double /*size*/) {
  begin_property(field.label);
  if (const auto typed = text_field(ui, "Probe file", {file})) file = *typed;
  tooltip(field.help);
}

/// Draws the shape and its fields. `size` is the largest length of a probe: the size of the sensor [m].
void draw_shape(WindowUi& ui, ProbeState& probe, double size) {
  ProbeSettings& s = probe.settings;
  std::vector<const char*> labels;
  for (const ProbeShape& shape : s.shapes)
    labels.push_back(std::visit([](const auto& one) { return one.kLabel; }, shape));
  s.chosen = choice_row(ui, "Shape", labels, s.chosen).value_or(s.chosen);
  const auto draw = [&](auto& shape) {
    shape.visit([&](const FieldSpec& field, auto& value) { draw_field(ui, field, value, size); });
    if (!shape.kIsRound) property_field(ui, "Turned", &s.roll_deg, 1, "%.0f\u00b0", -180, 180);
  };
  std::visit(draw, s.shapes[s.chosen]);
}

void draw_material(WindowUi& ui, ProbeState& probe) {
  Material& material = probe.settings.material;
  const auto kind = choice_row(ui, "Material", {"Rigid", "Soft"}, material.compliant() ? 1 : 0);
  if (kind) material.modulus = *kind == 1 ? kSoftModulus : 0;
  if (!material.compliant()) return;
  material.field = std::visit([](const auto& shape) { return shape.kField; }, probe.settings.shape());
  property_field(ui, "Modulus", &material.modulus, 1e-3, "%.0f kPa", 1e3, 1e8);
}

void draw_reading(const Shown& shown, const ProbeState& probe) {
  const PressedProbe* pressed = shown.document.probe.get();
  const bool read = pressed != nullptr && pressed->problem.empty();
  property("Force", read ? fmt::format("{:.3f} N", pressed->force) : "\u2013");
  property("Contact area", read ? in_mm2(pressed->area) : "\u2013");
  property("Polygons", read ? grouped(pressed->polygons) : "\u2013");
  property("Peak pressure", read ? in_kpa(pressed->largest) : "\u2013");
  if (probe.latency && shown.run.performance.is_real_time)
    property("After an edit in", fmt::format("{:.0f} ms", 1e3 * *probe.latency));
}

}  // namespace

void draw_probe_panel(WindowUi& ui, const Viewer& viewer, const Shown& shown, ProbeState& probe) {
  if (!probe.on || viewer.mode != Mode::layout || !shown.document.model) return;
  const float line = ImGui::GetFontSize();
  // Below the strip of tools and the legend if there is room, else to the right of the strip.
  const Rect& view = viewer.view.rect;
  const bool below = view.height() > kRoomBelowTools * line;
  ImGui::SetNextWindowPos(
      {view.x0 + 0.8f * line + (below ? 0 : viewer.view.strip), view.y0 + (below ? 14.3f : 4.8f) * line},
      ImGuiCond_Appearing);
  ImGui::SetNextWindowSize({15.5f * line, 0});
  ImGui::SetNextWindowBgAlpha(0.92f);
  constexpr auto kFlags = ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                          ImGuiWindowFlags_NoScrollbar;
  bool open = true;
  if (ImGui::Begin("Probe", &open, kFlags)) {
    ui.widgets.note_item("Probe");
    if (begin_properties("probe")) {
      const double size = shown.document.model->mesh->bounds().diagonal();
      draw_shape(ui, probe, size);
      draw_material(ui, probe);
      property_field(ui, "Depth", &probe.settings.depth, 1e3, "%.2f mm", 0, kDeepestProbe * size);
      draw_reading(shown, probe);
      end_properties();
    }
    if (!probe.at) ImGui::TextDisabled("Point at the sensor.");
    if (shown.document.probe && !shown.document.probe->problem.empty()) {
      ImGui::PushTextWrapPos(0);
      ImGui::TextColored(palette(ui.dark).error, "%s", shown.document.probe->problem.c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
  if (!open) leave_probe(probe);
}

}  // namespace taxel::ui
