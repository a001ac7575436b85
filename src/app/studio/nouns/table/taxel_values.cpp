#include "app/studio/nouns/table/taxel_values.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/nouns/table/taxel_cells.h"
#include "ui/theme.h"

namespace taxel::ui {

const char* value_tip(std::string_view title) {
  if (title == kShearTitle) return "Magnitude of the friction on the taxel, in the unit of its reading";
  return title == kSlipTitle ? "Share of the taxel's touched field that slips" : "";
}

void draw_values(const WindowUi& ui, const SensorStep* step, std::size_t taxel, const ReadingUnit& unit,
                 const ValueColumns& columns) {
  const Palette& colors = palette(ui.dark);
  const auto draw = [&](double value, const char* format) {
    draw_text(fmt::format(fmt::runtime(format), value), true, value > 0 ? colors.text : colors.dim);
  };
  ImGui::TableNextColumn();
  if (step != nullptr && taxel < step->readings.size()) draw(unit.scale * step->readings[taxel], "{:.2f}");
  if (columns.shear) {
    ImGui::TableNextColumn();
    if (step != nullptr && taxel < step->shear.size()) draw(unit.scale * glm::length(step->shear[taxel]), "{:.2f}");
  }
  if (columns.slip) {
    ImGui::TableNextColumn();
    if (step != nullptr && taxel < step->slip.size()) draw(kSlipUnit.scale * step->slip[taxel], "{:.0f} %");
  }
}

}  // namespace taxel::ui
