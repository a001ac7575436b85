#include "app/studio/nouns/study/study_plots.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>

#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/study/study_varied.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"
#include "ui/widgets/plot_click.h"

namespace taxel::ui {

namespace {

constexpr float kLeastPlotHeight =
    9;  // smallest height of a run's plot, in heights of text; below it the panel scrolls

std::string title_of(const Study& study, const StudyRun& run) {
  const std::vector<FieldSpec> all = varied_in(study.scenario);
  std::string title;
  for (std::size_t i = 0; i < run.values.size(); ++i) {
    const auto varied =
        std::find_if(all.begin(), all.end(), [&](const FieldSpec& one) { return one.key == study.parameters[i].key; });
    if (varied != all.end()) title += (title.empty() ? "" : ", ") + value_text(*varied, run.values[i]);
  }
  return title;
}

/// Applies the values of a run to the document and runs the scenario.
void load_run(WindowUi& ui, const Project& project, const StudyRun& run) {
  if (run.density || run.seed) {
    Sampling sampling = project.layout.sampling;
    sampling.density = run.density.value_or(sampling.density);
    sampling.seed = run.seed.value_or(sampling.seed);
    ui.post(EditProject{SetSampling{sampling}, {}});
  }
  ui.post(RunScenario{run.scenario});
}

void draw_curves(const DocumentView& document, const StudyCurves& curves, const StudyCurve& curve,
                 const std::vector<bool>& responds, double scale, double pixel_scale) {
  for (std::size_t k = 0; k < curve.readings.size(); ++k) {
    if (!responds[k]) continue;
    std::vector<double> shown;
    for (const double reading : curve.readings[k]) shown.push_back(scale * reading);
    const glm::vec3 c = taxel_color(document.model && k < document.model->layout.taxels.size()
                                        ? document.model->color(static_cast<int>(k))
                                        : static_cast<int>(k));
    ImPlotSpec spec;
    spec.LineColor = ImVec4(c.x, c.y, c.z, 1);
    spec.LineWeight = static_cast<float>(1.4 * pixel_scale);
    ImPlot::PlotLine(fmt::format("{}", curves.taxel_ids[k]).c_str(), curve.time.data(), shown.data(),
                     static_cast<int>(shown.size()), spec);
  }
}

/// Returns, for each taxel, whether the taxel responds in any run.
std::vector<bool> responding(const StudyCurves& curves) {
  std::vector<bool> responds(curves.taxel_ids.size(), false);
  for (const StudyCurve& curve : curves.runs)
    for (std::size_t k = 0; k < curve.readings.size(); ++k)
      for (const double reading : curve.readings[k])
        responds[k] = responds[k] || reading > kTaxelResponds * curves.largest_reading;
  return responds;
}

}  // namespace

void draw_study_plots(WindowUi& ui, const DocumentView& document, const Project& project, const StudyCurves& curves) {
  const int count = static_cast<int>(curves.runs.size());
  const bool grid = curves.study.parameters.size() == 2;
  const int columns =
      grid ? static_cast<int>(curves.study.parameters[1].values.size()) : static_cast<int>(std::ceil(std::sqrt(count)));
  const int rows = (count + columns - 1) / columns;
  const ReadingUnit unit = shown_unit(curves.aggregate);
  const std::vector<bool> responds = responding(curves);
  constexpr auto kFlags = ImPlotSubplotFlags_NoResize | ImPlotSubplotFlags_NoMenus;
  constexpr auto kPlot = ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect | ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size(room.x, std::max(room.y, static_cast<float>(rows) * kLeastPlotHeight * ImGui::GetFontSize()));
  if (ImPlot::BeginSubplots("##runs", rows, columns, size, kFlags)) {
    for (int i = 0; i < count; ++i) {
      const StudyCurve& curve = curves.runs[static_cast<std::size_t>(i)];
      const std::string title = title_of(curves.study, curve.run) + fmt::format("##{}", i);
      if (!ImPlot::BeginPlot(title.c_str(), ImVec2(0, 0), kPlot)) continue;
      ImPlot::SetupAxes("time (s)", i % columns == 0 ? unit.text : nullptr, ImPlotAxisFlags_NoMenus,
                        ImPlotAxisFlags_NoMenus);
      ImPlot::SetupAxisLimits(ImAxis_X1, 0, std::max(1e-3, curves.longest), ImPlotCond_Always);
      const double top = unit.scale * (curves.largest_reading > 0 ? curves.largest_reading : 1);
      ImPlot::SetupAxisLimits(ImAxis_Y1, 0, 1.08 * top, ImPlotCond_Always);
      draw_curves(document, curves, curve, responds, unit.scale, ui.pixel_scale);
      if (!curve.error.empty()) ImPlot::PlotText("failed", 0.5 * curves.longest, 0.5 * top);
      if (plot_clicked()) load_run(ui, project, curve.run);
      ImPlot::EndPlot();
      ui.widgets.note_item(fmt::format("Run {}", i));
    }
    ImPlot::EndSubplots();
  }
  ImGui::PopFont();
}

}  // namespace taxel::ui
