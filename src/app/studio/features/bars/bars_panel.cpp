#include "app/studio/features/bars/bars_panel.h"

#include <imgui.h>

#include "app/studio/app/panel_spec.h"
#include "app/studio/features/bars/pressure_bars.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

void draw_bars_panel(UiState& ui, const UiInput& input) {
  if (begin_panel(ui, kBarsTitle, &ui.saved.panels.bars)) {
    const bool probed = ui.mode == Mode::layout && input.shown_state(ui) != nullptr;
    const SensorStep* sensor = probed ? input.shown_state(ui) : input.sensor(ui);
    if (sensor == nullptr || sensor->readings.empty()) {
      ui.bars.clear();
      ImGui::TextDisabled(sensor == nullptr ? "Run the simulation, or press X to probe."
                                            : "The selected geom has no taxels.");
    } else {
      const SensorModel& model =
          probed ? *input.probe->model : *input.frame->scene->sensors[static_cast<std::size_t>(ui.selection.sensor)];
      const Layout& layout = model.layout;
      std::vector<BarValue> values;
      for (std::size_t i = 0; i < sensor->readings.size() && i < layout.taxels.size(); ++i) {
        const double peak = !probed && i < input.peaks.size() ? input.peaks[i] : 0.0;
        values.push_back({layout.taxels[i].id, sensor->readings[i], peak, model.color(static_cast<int>(i))});
      }
      const ReadingUnit unit = shown_unit(layout.readout.aggregate);
      caption(
          (std::string(unit.text) + (probed ? " by taxel, of the probe" : " by taxel, the line is the peak")).c_str());
      const int clicked = draw_pressure_bars(ui, values, unit, ImGui::GetContentRegionAvail());
      if (clicked >= 0) click_taxel(ui, values[static_cast<std::size_t>(clicked)].id, ImGui::GetIO().KeyShift);
    }
  } else {
    ui.bars.clear();
  }
  ImGui::End();
}

}  // namespace taxel::ui
