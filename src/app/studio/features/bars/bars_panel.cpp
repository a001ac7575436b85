#include "app/studio/features/bars/bars_panel.h"

#include <imgui.h>

#include "app/studio/app/panel_spec.h"
#include "app/studio/app/reading_range.h"
#include "app/studio/features/bars/pressure_bars.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

void draw_bars_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, BarsShown& bars, bool& open) {
  if (begin_panel(ui, kBarsTitle, &open)) {
    const bool probed = viewer.mode == Mode::layout && shown.state(viewer) != nullptr;
    const SensorStep* sensor = probed ? shown.state(viewer) : shown.sensor(viewer);
    if (sensor == nullptr || sensor->readings.empty()) {
      bars.clear();
      ImGui::TextDisabled(sensor == nullptr ? "Run the simulation, or press X to probe."
                                            : "The selected geom has no taxels.");
    } else {
      const SensorModel& model =
          probed ? *shown.document.probe->model
                 : *shown.run.frame->scene->sensors[static_cast<std::size_t>(viewer.selection.sensor)];
      const Layout& layout = model.layout;
      std::vector<BarValue> values;
      for (std::size_t i = 0; i < sensor->readings.size() && i < layout.taxels.size(); ++i) {
        const double peak = !probed && i < shown.run.peaks.size() ? shown.run.peaks[i] : 0.0;
        values.push_back({layout.taxels[i].id, sensor->readings[i], peak, model.color(static_cast<int>(i))});
      }
      const ReadingUnit unit = shown_unit(layout.readout.aggregate);
      caption(
          (std::string(unit.text) + (probed ? " by taxel, of the probe" : " by taxel, the line is the peak")).c_str());
      const BarsScale scale{reading_range(viewer, shown), unit};
      const int clicked = draw_pressure_bars(ui, viewer, bars, values, scale, ImGui::GetContentRegionAvail());
      if (clicked >= 0)
        click_taxel(viewer.selection, values[static_cast<std::size_t>(clicked)].id, ImGui::GetIO().KeyShift);
    }
  } else {
    bars.clear();
  }
  ImGui::End();
}

}  // namespace taxel::ui
