#include "app/studio/nouns/view/view_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/base/stopwatch.h"
#include "ui/scene/sample_use.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {

namespace {

constexpr float kPlate = 0.88f;  // opacity of the plate behind a label, on which text is readable

/// Draws a line from a mark to the nearest point of its label.
void draw_leader(const ViewPlace& place, const dvec2& mark, const Rect& label, const ImVec4& color, ImDrawList& list) {
  const ImVec2 from(place.rect.x0 + static_cast<float>(mark.x), place.rect.y0 + static_cast<float>(mark.y));
  const ImVec2 to(std::clamp(from.x, label.x0, label.x1), std::clamp(from.y, label.y0, label.y1));
  list.AddLine(from, to, to_u32(color, 0.9f));
}

/// Returns the file name of a title, because a scene's title may be a whole path.
std::string file_name_of(const std::string& title) {
  const std::size_t slash = title.find_last_of('/');
  return slash == std::string::npos || slash + 1 == title.size() ? title : title.substr(slash + 1);
}

std::string taxel_text(const Viewer& viewer, const Shown& shown, const SensorModel& model, int index) {
  const auto i = static_cast<std::size_t>(index);
  const Taxel& taxel = model.layout.taxels[i];
  std::string text = fmt::format("Taxel {}{}{}", taxel.id, taxel.name.empty() ? "" : ", ", taxel.name);
  text +=
      fmt::format("\n{} samples, radius {}", model.fields.first[i + 1] - model.fields.first[i], in_mm(taxel.radius));
  const SensorStep* sensor = shown.state(viewer);
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

}  // namespace

void render_if_changed(Viewer& viewer, ProfileState& profile, ViewShown& view, SceneInput scene,
                       SceneRenderer& renderer, int width, int height) {
  ViewPlace& place = viewer.view;
  const bool same = view.drawn && place.width == width && place.height == height && view.camera == viewer.camera() &&
                    view.input == scene;
  if (same) return;
  const Stopwatch watch(profile.scene_seconds);
  renderer.render(scene, viewer.camera(), width, height);
  const double text_height = static_cast<double>(kSmallText * ImGui::GetFontSize());
  view.numbers = renderer.field_numbers();
  view.labels = scene_labels(scene, viewer.camera(), width, height, text_height);
  view.input = std::move(scene);
  view.camera = viewer.camera();
  place.width = width;
  place.height = height;
  view.drawn = true;
  ++view.draws;
}

bool shows_pressure(const Viewer& viewer, const Shown& shown) {
  return shown.state(viewer) != nullptr;
}

void draw_heading(const WindowUi& ui, const Viewer& viewer, const Shown& shown, float legend_width, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const bool layout = viewer.mode == Mode::layout;
  const ImVec4& mode_color = layout ? colors.layout_mode : colors.simulate_mode;
  const float line = ImGui::GetFontSize();
  const ImVec2 at(viewer.view.rect.x0 + 0.8f * line, viewer.view.rect.y0 + 0.7f * line);
  const char* mode = layout ? "LAYOUT" : "SIMULATE";
  const float width = ImGui::CalcTextSize(mode).x + line;
  list.AddRectFilled(at, {at.x + width, at.y + 1.5f * line}, to_u32(mode_color), 3);
  list.AddText({at.x + 0.5f * line, std::round(at.y + 0.22f * line)}, to_u32(text_on(mode_color)), mode);
  std::string text = shown.document.name;
  if (!layout && shown.run.frame && shown.run.frame->scene && !shown.run.frame->scene->title.empty())
    text = file_name_of(shown.run.frame->scene->title);
  if (!layout && shown.run.frame && shown.run.frame->finished) text += "   (finished)";
  const float end = viewer.view.rect.x1 - (legend_width > 0 ? legend_width + line : 0.5f * line);
  const ImVec4 room(at.x, at.y, end, at.y + 2 * line);  // the legend begins there
  list.AddText(nullptr, 0, {at.x + width + 0.6f * line, std::round(at.y + 0.22f * line)}, to_u32(colors.text),
               text.c_str(), nullptr, 0, &room);
}

void draw_border(const WindowUi& ui, const Viewer& viewer, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const ImVec4& color = viewer.mode == Mode::layout ? colors.layout_mode : colors.simulate_mode;
  list.AddRect({viewer.view.rect.x0, viewer.view.rect.y0}, {viewer.view.rect.x1, viewer.view.rect.y1}, to_u32(color), 0,
               2);
}

void draw_hover_tooltip(const Viewer& viewer, const Shown& shown) {
  const SensorModelPtr model = shown.model(viewer);
  if (!viewer.hovered || !model) return;
  const Pick& under = *viewer.hovered;
  const bool shown_sensor = viewer.mode == Mode::layout || under.sensor == viewer.selection.sensor;
  std::string text;
  if (under.taxel >= 0 && under.taxel < model->taxel_count() && shown_sensor) {
    text = taxel_text(viewer, shown, *model, under.taxel);
  } else if (under.polygon >= 0) {
    text = fmt::format("Contact surface\n{}", in_kpa(under.pressure));
  } else if (under.sample >= 0 && shown_sensor && viewer.overlays().samples) {
    text = sample_text(*model, under.sample);
  }
  if (!text.empty()) ImGui::SetTooltip("%s", text.c_str());
}

void draw_labels(const WindowUi& ui, const ViewPlace& place, const ViewShown& view, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const float size = kSmallText * ImGui::GetFontSize();
  for (const SceneLabel& label : view.labels) {
    const float width = kSmallText * ImGui::CalcTextSize(label.text.c_str()).x;
    const ImVec2 at(std::round(place.rect.x0 + static_cast<float>(label.pixel.x) - 0.5f * width),
                    std::round(place.rect.y0 + static_cast<float>(label.pixel.y) - 0.5f * size));
    const ImVec4& plate = label.selected ? colors.accent : colors.panel;
    if (label.leader)
      draw_leader(place, *label.leader, {at.x - 3, at.y - 1, at.x + width + 3, at.y + size + 1},
                  label.occluded ? colors.dim : colors.text, list);
    list.AddRectFilled({at.x - 3, at.y - 1}, {at.x + width + 3, at.y + size + 1},
                       to_u32(plate, label.selected ? 1.0f : kPlate), 3);
    list.AddText(ImGui::GetFont(), size, at,
                 to_u32(label.selected   ? text_on(colors.accent)
                        : label.occluded ? colors.dim
                                         : colors.text),
                 label.text.c_str());
  }
}

LegendPlace legend_place(const ViewPlace& place, const LegendScales& scales) {
  const float margin = 0.7f * ImGui::GetFontSize();
  const ImVec2 size = legend_size(scales, {place.rect.width() - 2 * margin, place.rect.height() - 2 * margin});
  return {{place.rect.x1 - margin, place.rect.y0 + margin}, size.x, size.y};
}

}  // namespace taxel::ui
