#include "app/studio/features/map/map_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/studio/app/panel_spec.h"
#include "app/studio/app/reading_range.h"
#include "app/studio/app/values/selection.h"
#include "app/studio/features/map/map_fit.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {
namespace {

constexpr float kRimFrom = 6.0f;  // smallest radius with a rim [pixels]; on smaller discs a rim hides the colour

void draw_text(ImVec2 center, ImU32 color, const std::string& text) {
  const float size = kSmallText * ImGui::GetFontSize();
  const float width = kSmallText * ImGui::CalcTextSize(text.c_str()).x;
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), size,
                                      {std::round(center.x - 0.5f * width), std::round(center.y - 0.5f * size)}, color,
                                      text.c_str());
}

void draw_disc(WindowUi& ui, const Selection& selection, const MapDisc& disc, bool read, const PressureRange& range) {
  const Palette& colors = palette(ui.dark);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at(static_cast<float>(disc.x), static_cast<float>(disc.y));
  const auto radius = static_cast<float>(disc.radius);
  const bool selected = selection.contains(disc.taxel_id);
  list.AddCircleFilled(at, radius, read ? pressure_color(range, disc.value) : to_u32(colors.field));
  if (selected || radius > kRimFrom)
    list.AddCircle(at, radius, to_u32(selected ? colors.accent : colors.line), 0, (selected ? 3.0f : 1.0f));
  const std::string id = std::to_string(disc.taxel_id);
  if (kSmallText * ImGui::CalcTextSize(id.c_str()).x > 1.8f * radius) return;
  const glm::vec3 fill = range.color(disc.value);
  draw_text(at, to_u32(read ? text_on({fill.x, fill.y, fill.z, 1}) : colors.text), id);
}

std::string hover_text(const Taxel& taxel, const MapDisc& disc, bool read, const ReadingUnit& unit) {
  std::string text = fmt::format("Taxel {}{}{}", taxel.id, taxel.name.empty() ? "" : ", ", taxel.name);
  return read ? text + "\n" + in_unit(disc.value, unit) : text;
}

void draw_map(WindowUi& ui, Viewer& viewer, const Shown& shown, MapState& map, const SensorModel& model) {
  const SensorStep* state = shown.state(viewer);
  const std::vector<Taxel>& taxels = model.layout.taxels;
  const bool read = state != nullptr && state->readings.size() == taxels.size();
  const ReadingUnit unit = shown_unit(model.layout.readout.aggregate);
  const PressureRange range = reading_range(viewer, shown);
  caption((std::string(read ? unit.text : "Taxels") +
           (map.map.unrolled ? ", unrolled: the pad in the middle, distal up" : ", seen along their mean normal"))
              .c_str());
  const ImVec2 origin = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  if (!(size.x > 8 && size.y > 8)) return;
  ImGui::InvisibleButton("##map", size);
  ui.widgets.note_item("Map");
  const bool hovered = ImGui::IsItemHovered(), pressed = ImGui::IsItemClicked();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const MapFit place = fit_map(map.map, origin, size, ImGui::GetFontSize());
  int under = -1;
  for (std::size_t k = 0; k < taxels.size(); ++k) {
    const ImVec2 at = place.at(map.map.places[k]);
    map.discs.push_back({taxels[k].id, read ? state->readings[k] : 0.0, static_cast<double>(at.x),
                         static_cast<double>(at.y), static_cast<double>(place.radius)});
    draw_disc(ui, viewer.selection, map.discs.back(), read, range);
    const float r = place.radius;
    ui.widgets.note(kMapTitle, fmt::format("Disc {}", taxels[k].id), {at.x - r, at.y - r, at.x + r, at.y + r});
    if (hovered && std::hypot(mouse.x - at.x, mouse.y - at.y) <= place.radius) under = static_cast<int>(k);
  }
  if (under < 0) return;
  const auto k = static_cast<std::size_t>(under);
  ImGui::SetTooltip("%s", hover_text(taxels[k], map.discs[k], read, unit).c_str());
  if (pressed) click_taxel(viewer.selection, taxels[k].id, ImGui::GetIO().KeyShift);
}

}  // namespace

void draw_map_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, MapState& map, bool& open) {
  if (begin_panel(ui, kMapTitle, &open)) {
    const SensorModelPtr model = shown.model(viewer);
    if (!model || model->layout.taxels.empty()) {
      ImGui::TextDisabled("There are no taxels.");
    } else {
      if (map.model != model) map = {model, flat_map(model->layout, model->skin->mesh().centroid()), {}};
      draw_map(ui, viewer, shown, map, *model);
    }
  }
  ImGui::End();
}

}  // namespace taxel::ui
