#include "app/studio/features/view/view_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/app/panel_spec.h"
#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/pointing/view_mouse.h"
#include "app/studio/features/fields/field_legend.h"
#include "app/studio/features/files/dialogs.h"
#include "app/studio/features/probe/probe_panel.h"
#include "app/studio/features/view/filtered_legend.h"
#include "app/studio/features/view/scene_overlay.h"
#include "app/studio/features/view/tool_overlay.h"
#include "core/base/stopwatch.h"
#include "ui/scene/sample_use.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

namespace {

/// Draws into the renderer's texture only when something that is seen has changed.
void render_if_changed(UiState& ui, const UiInput& input, SceneRenderer& renderer, int width, int height) {
  ViewShown& view = ui.view;
  SceneInput scene = scene_input(ui, input);
  const bool same =
      view.drawn && view.width == width && view.height == height && view.camera == ui.camera() && view.input == scene;
  if (same) return;
  const Stopwatch watch(ui.profile.scene_seconds);
  renderer.render(scene, ui.camera(), width, height);
  const double text_height = static_cast<double>(kSmallText * ImGui::GetFontSize());
  view.numbers = renderer.field_numbers();
  view.labels = scene_labels(scene, ui.camera(), width, height, text_height);
  view.input = std::move(scene);
  view.camera = ui.camera();
  view.width = width;
  view.height = height;
  view.drawn = true;
  ++view.draws;
}

bool shows_pressure(const UiState& ui, const UiInput& input) {
  return input.shown_state(ui) != nullptr;
}

/// A scene's title may be its whole path.
std::string file_name_of(const std::string& title) {
  const std::size_t slash = title.find_last_of('/');
  return slash == std::string::npos || slash + 1 == title.size() ? title : title.substr(slash + 1);
}

/// Mode and name in the upper left corner.
void draw_heading(const UiState& ui, const UiInput& input, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const bool layout = ui.mode == Mode::layout;
  const ImVec4& mode_color = layout ? colors.layout_mode : colors.simulate_mode;
  const float line = ImGui::GetFontSize();
  const ImVec2 at(ui.view.rect.x0 + 0.8f * line, ui.view.rect.y0 + 0.7f * line);
  const char* mode = layout ? "LAYOUT" : "SIMULATE";
  const float width = ImGui::CalcTextSize(mode).x + line;
  list.AddRectFilled(at, {at.x + width, at.y + 1.5f * line}, to_u32(mode_color), 3);
  list.AddText({at.x + 0.5f * line, std::round(at.y + 0.22f * line)}, IM_COL32_WHITE, mode);
  std::string text = input.name;
  if (!layout && input.frame && input.frame->scene && !input.frame->scene->title.empty())
    text = file_name_of(input.frame->scene->title);
  if (!layout && input.frame && input.frame->finished) text += "   (finished)";
  const float end = ui.view.rect.x1 - (shows_pressure(ui, input) ? pressure_legend_width() + line : 0.5f * line);
  const ImVec4 room(at.x, at.y, end, at.y + 2 * line);  // the legend begins there
  list.AddText(nullptr, 0, {at.x + width + 0.6f * line, std::round(at.y + 0.22f * line)}, to_u32(colors.text),
               text.c_str(), nullptr, 0, &room);
}

void draw_border(const UiState& ui, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const ImVec4& color = ui.mode == Mode::layout ? colors.layout_mode : colors.simulate_mode;
  list.AddRect({ui.view.rect.x0, ui.view.rect.y0}, {ui.view.rect.x1, ui.view.rect.y1}, to_u32(color), 0, 2);
}

std::string taxel_text(const UiState& ui, const UiInput& input, const SensorModel& model, int index) {
  const auto i = static_cast<std::size_t>(index);
  const Taxel& taxel = model.layout.taxels[i];
  std::string text = fmt::format("Taxel {}{}{}", taxel.id, taxel.name.empty() ? "" : ", ", taxel.name);
  text +=
      fmt::format("\n{} samples, radius {}", model.fields.first[i + 1] - model.fields.first[i], in_mm(taxel.radius));
  const SensorStep* sensor = input.shown_state(ui);
  if (sensor != nullptr && i < sensor->readings.size())
    text += fmt::format("\n{}", in_unit(sensor->readings[i], shown_unit(model.layout.readout.aggregate)));
  return text;
}

std::string sample_text(const SensorModel& model, int sample) {
  const std::vector<SampleUse> uses = uses_of_sample(model, sample);
  std::string text = fmt::format("Sample {}", sample);
  if (uses.empty()) return text + ", used by no taxel";
  for (const SampleUse& use : uses) {
    text += fmt::format("\nTaxel {}: distance {}, angle {:.1f}\u00b0, weight {:.3g} mm\u00b2",
                        model.layout.taxels[static_cast<std::size_t>(use.taxel)].id, in_mm(use.distance), use.angle_deg,
                        1e6 * use.weight);
  }
  return text;
}

void draw_hover_tooltip(const UiState& ui, const UiInput& input) {
  const SensorModelPtr model = input.shown_model(ui);
  if (!ui.hovered || !model) return;
  const Pick& under = *ui.hovered;
  const bool shown_sensor = ui.mode == Mode::layout || under.sensor == ui.selection.sensor;
  std::string text;
  if (under.taxel >= 0 && under.taxel < model->taxel_count() && shown_sensor) {
    text = taxel_text(ui, input, *model, under.taxel);
  } else if (under.polygon >= 0) {
    text = fmt::format("Contact surface\n{}", in_kpa(under.pressure));
  } else if (under.sample >= 0 && shown_sensor && ui.saved.overlays.samples) {
    text = sample_text(*model, under.sample);
  }
  if (!text.empty()) ImGui::SetTooltip("%s", text.c_str());
}

void draw_labels(const UiState& ui, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const float size = kSmallText * ImGui::GetFontSize();
  for (const SceneLabel& label : ui.view.labels) {
    const float width = kSmallText * ImGui::CalcTextSize(label.text.c_str()).x;
    const ImVec2 at(std::round(ui.view.rect.x0 + static_cast<float>(label.pixel.x) - 0.5f * width),
                    std::round(ui.view.rect.y0 + static_cast<float>(label.pixel.y) - 0.5f * size));
    const float alpha = label.occluded ? 0.4f : 1.0f;
    list.AddRectFilled({at.x - 3, at.y - 1}, {at.x + width + 3, at.y + size + 1},
                       to_u32(label.selected ? colors.accent : colors.panel, 0.75f * alpha), 3);
    list.AddText(ImGui::GetFont(), size, at, label.selected ? IM_COL32_WHITE : to_u32(colors.text, alpha),
                 label.text.c_str());
  }
}

LegendPlace legend_place(const UiState& ui) {
  const float line = ImGui::GetFontSize(), margin = 0.7f * line;
  return {{ui.view.rect.x1 - margin, ui.view.rect.y0 + margin},
          std::min(17 * line, ui.view.rect.height() - 2 * margin)};
}

/// Returns the first line below the heading that is free.
int draw_over_scene(UiState& ui, const UiInput& input) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_labels(ui, list);
  if (input.model || input.frame) draw_heading(ui, input, list);
  if (shows_pressure(ui, input)) draw_pressure_legend(ui, ui.range, legend_place(ui));
  float bottom = ui.view.rect.y1 - 0.7f * ImGui::GetFontSize();
  if (ui.saved.overlays.filtered_polygons && shows_pressure(ui, input)) {
    bottom = draw_filtered_legend(ui, *input.shown_state(ui)) - 0.5f * ImGui::GetFontSize();
  }
  if (const SensorModelPtr model = input.shown_model(ui)) draw_field_legends(ui, ui.view.numbers, *model, bottom);
  if (const SensorModelPtr model = input.shown_model(ui)) {
    const LegendPlace pressure = legend_place(ui);
    const float line = ImGui::GetFontSize();
    draw_repair_legend(ui, *model, pressure.corner.y + (shows_pressure(ui, input) ? pressure.height + line : 0));
  }
  draw_border(ui, list);
  draw_hover_tooltip(ui, input);
  const int row = draw_tool_overlay(ui, input);
  return draw_scene_overlay(ui, input, row);
}

}  // namespace

void draw_view(UiState& ui, const UiInput& input, SceneRenderer& renderer) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  const bool visible =
      begin_panel(ui, kViewTitle, nullptr, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  int free_row = 0;
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const int width = static_cast<int>(size.x), height = static_cast<int>(size.y);
  if (visible && width > 0 && height > 0) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ui.view.rect = {corner.x, corner.y, corner.x + static_cast<float>(width), corner.y + static_cast<float>(height)};
    constexpr auto kButtons =
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle;
    if (shows_pressure(ui, input)) place_range_button(ui, ui.range, legend_place(ui));
    ImGui::SetCursorScreenPos(corner);
    ImGui::InvisibleButton("##view", size, kButtons);
    ui.widgets.note_item("View");
    handle_view_mouse(ui, input);
    render_if_changed(ui, input, renderer, width, height);
    const ImTextureRef texture(static_cast<ImTextureID>(renderer.texture()));
    const Rect& r = ui.view.rect;  // rows of GL textures run upward
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCallback(ImGui::GetPlatformIO().DrawCallback_SetSamplerNearest, nullptr);  // pixel by pixel
    list.AddImage(texture, {r.x0, r.y0}, {r.x1, r.y1}, {0, 1}, {1, 0});
    list.AddCallback(ImGui::GetPlatformIO().DrawCallback_SetSamplerLinear, nullptr);
    free_row = draw_over_scene(ui, input);
  }
  ImGui::End();
  if (visible) draw_info_card(ui, input, free_row);
  if (!input.model && !input.frame && !input.loading.active) draw_start_card(ui);
  draw_probe_panel(ui, input);
}

}  // namespace taxel::ui
