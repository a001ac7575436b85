#include "app/studio/features/plot/plot_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>

#include "app/studio/app/panel_spec.h"
#include "app/studio/app/values/selection.h"
#include "app/studio/features/plot/plot_curves.h"
#include "app/studio/features/real/real_panel.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/dashed_curve.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

/// Space above and below the vertical axis, in heights of text. The name of the axis is left out if it does not fit.
constexpr float kAroundAxis = 3.5f;

/// Returns the index in a trace row at which the readings of the selected sensor begin.
std::size_t first_reading(const Selection& selection, const RunView& run) {
  std::size_t first = 0;
  for (int s = 0; s < selection.sensor; ++s) first += run.frame->sensors[static_cast<std::size_t>(s)].readings.size();
  return first;
}

ReadingUnit unit_of(const Selection& selection, const RunView& run) {
  return shown_unit(run.frame->scene->sensors[static_cast<std::size_t>(selection.sensor)]->layout.readout.aggregate);
}

void draw_options(WindowUi& ui, PlotOptions& options, const ReadingUnit& unit) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(6, 2));
  if (small_choice(ui, "Relative", options.relative)) options.relative = true;
  tooltip("Divided by the largest reading of the run");
  ImGui::SameLine(0, 2);
  if (small_choice(ui, unit.text, !options.relative)) options.relative = false;
  tooltip(std::string("Readings in ") + unit.text);
  ImGui::SameLine(0, 14);
  checkbox(ui, "Responding only", &options.responding_only);
  tooltip(fmt::format("Only taxels whose peak is above {:g} % of the largest", 100 * kTaxelResponds));
  ImGui::PopStyleVar();
}

void setup_axes(const RunView& run, const PlotOptions& options, const ReadingUnit& unit, double largest, float height) {
  const SimScene& scene = *run.frame->scene;
  const double end = run.by_travel() ? 1e3 * scene.duration * run.scenario.as<scenarios::Sweep>().speed
                                     : std::max(1.0, scene.duration > 0 ? scene.duration : run.frame->time);
  const std::string reading = options.relative ? "reading / largest" : fmt::format("reading ({})", unit.text);
  const bool tall = height - kAroundAxis * ImGui::GetFontSize() > ImGui::CalcTextSize(reading.c_str()).x;
  ImPlot::SetupAxes(run.by_travel() ? "travel (mm)" : "time (s)", tall ? reading.c_str() : nullptr,
                    ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight,
                    ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight);
  ImPlot::SetupAxisLimits(ImAxis_X1, 0, end, ImPlotCond_Always);
  const double top = options.relative ? 1.08 : 1.08 * (largest > 0 ? unit.scale * largest : 1.0);
  ImPlot::SetupAxisLimits(ImAxis_Y1, 0, top, ImPlotCond_Always);
  ImPlot::SetupLegend(ImPlotLocation_East, ImPlotLegendFlags_Outside | ImPlotLegendFlags_NoMenus);
  ImPlot::SetupFinish();
}

/// The role of a curve in a pair of coinciding curves. The follower is drawn dashed over the leader, which is wider.
enum class PairPart { none, leader, follower };

void draw_curve(WindowUi& ui, Selection& selection, PlotCurves& curves, std::size_t reading, double scale, int color,
                int id, PairPart part) {
  constexpr float kLine = 1.8f, kSelected = 3.2f, kWider = 1.7f;  // [pixels], and the factor of a leader
  constexpr DashLengths kDashes{5, 5};
  const ImVec2 pixels = ImPlot::GetPlotSize();
  const ImPlotRect limits = ImPlot::GetPlotLimits();
  const double column = limits.X.Size() / std::max(1.0f, pixels.x), height = limits.Y.Size() / std::max(1.0f, pixels.y);
  const CurvePoints& whole = drawn_curve(curves, reading, column, kCurveTolerance * height, scale);
  CurvePoints dashes;
  if (part == PairPart::follower)
    dashes = dashes_of(whole, 1 / column, 1 / height, {kDashes.dash * ui.pixel_scale, kDashes.gap * ui.pixel_scale});
  const CurvePoints& drawn = part == PairPart::follower ? dashes : whole;
  const glm::vec3 c = taxel_color(color);
  ImPlotSpec spec;
  spec.LineColor = ImVec4(c.x, c.y, c.z, 1);
  spec.LineWeight = (selection.contains(id) ? kSelected : kLine) * static_cast<float>(ui.pixel_scale) *
                    (part == PairPart::leader ? kWider : 1.0f);
  const std::string label = fmt::format("{}", id);
  ImPlot::PlotLine(label.c_str(), drawn.x.data(), drawn.y.data(), static_cast<int>(drawn.x.size()), spec);
  if (ImPlot::IsLegendEntryHovered(label.c_str()) && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
    click_taxel(selection, id, ImGui::GetIO().KeyShift);
}

/// Draws the curves. Curves that follow another curve are drawn last, so that they are on top.
void draw_curves(WindowUi& ui, Selection& selection, PlotState& plot, const SensorModel& model, double scale,
                 std::size_t first) {
  const PlotCurves& curves = plot.curves;
  std::vector<std::size_t> shown;
  for (std::size_t r = first; r < std::min(first + model.layout.taxels.size(), curves.readings.size()); ++r)
    if (!plot.options.responding_only || curves.peaks[r] > kTaxelResponds * curves.largest) shown.push_back(r);
  const std::vector<int>& leaders = leaders_among(plot.curves, shown);
  for (const bool followers : {false, true}) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if ((leaders[i] >= 0) != followers) continue;
      const std::size_t k = shown[i] - first;
      const bool leads = std::find(leaders.begin(), leaders.end(), static_cast<int>(i)) != leaders.end();
      draw_curve(ui, selection, plot.curves, shown[i], scale, model.color(static_cast<int>(k)),
                 model.layout.taxels[k].id,
                 followers ? PairPart::follower
                 : leads   ? PairPart::leader
                           : PairPart::none);
    }
  }
}

void draw_cursor(const WindowUi& ui, const RunView& run) {
  const double x = run.by_travel() ? 1e3 * run.frame->travel : run.frame->time;
  ImPlotSpec spec;
  spec.LineColor = palette(ui.dark).path;
  spec.LineWeight = 1.2f;
  spec.Flags = ImPlotItemFlags_NoLegend | ImPlotItemFlags_NoFit;
  ImPlot::PlotInfLines("##now", &x, 1, spec);
}

/// Draws a marker where the samples were polished while the simulation ran. Earlier readings are of preview samples.
void draw_polish_mark(const WindowUi& ui, const PlotCurves& curves) {
  if (!curves.polished_from) return;
  const double x = *curves.polished_from;
  ImPlotSpec spec;
  spec.LineColor = palette(ui.dark).dim;
  spec.LineWeight = 1.0f;
  spec.Flags = ImPlotItemFlags_NoLegend | ImPlotItemFlags_NoFit;
  ImPlot::PlotInfLines("##polished", &x, 1, spec);
  const ImVec2 away(-0.6f * ImGui::GetFontSize(), 0.6f * ImGui::GetFontSize());
  ImPlot::Annotation(x, ImPlot::GetPlotLimits().Y.Max, palette(ui.dark).raised, away, true, "polished samples");
}

/// Displays the recorded step under a click or a drag.
void scrub_in_plot(WindowUi& ui, const RunView& run) {
  const HistoryLanes* lanes = run.frame->history.lanes.get();
  const ImVec2 lo = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize(), at = ImGui::GetIO().MouseClickedPos[0];
  const bool began_here = at.x >= lo.x && at.y >= lo.y && at.x < lo.x + size.x && at.y < lo.y + size.y &&
                          ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (lanes == nullptr || lanes->rows() == 0 || !began_here ||
      !(ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseDragging(ImGuiMouseButton_Left)))
    return;
  const double x = ImPlot::GetPlotMousePos().x;
  const std::size_t row =
      run.by_travel() ? nearest_row(*lanes, &StepMark::travel, 1e-3 * x) : nearest_row(*lanes, &StepMark::time, x);
  const std::uint64_t step = lanes->steps[row].step;
  if (step != run.frame->step || run.playing) ui.post(ScrubTo{step});
}

void draw_plot(WindowUi& ui, Selection& selection, const RunView& run, RealState& real, PlotState& plot) {
  PlotCurves& curves = plot.curves;
  const SensorModel& model = *run.frame->scene->sensors[static_cast<std::size_t>(selection.sensor)];
  const ReadingUnit unit = unit_of(selection, run);
  constexpr auto kFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect | ImPlotFlags_NoMouseText;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const ImVec2 size = ImGui::GetContentRegionAvail();
  if (ImPlot::BeginPlot("##taxels", size, kFlags)) {
    setup_axes(run, plot.options, unit, curves.largest, size.y);
    const double scale = plot.options.relative ? (curves.largest > 0 ? 1 / curves.largest : 1.0) : unit.scale;
    const std::size_t first = first_reading(selection, run);
    draw_curves(ui, selection, plot, model, scale, first);
    draw_real_curves(ui, selection, run, real, plot, scale, curves.largest, first);
    draw_polish_mark(ui, plot.curves);
    draw_cursor(ui, run);
    scrub_in_plot(ui, run);
    ImPlot::EndPlot();
    ui.widgets.note_item("Plot");
  }
  ImGui::PopFont();
}

}  // namespace

void draw_plot_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, RealState& real, PlotState& plot, bool& open) {
  if (begin_panel(ui, shown.run.by_travel() ? kPlotTitle : kTimePlotTitle, &open)) {
    if (shown.sensor(viewer) == nullptr || !shown.run.frame->trace) {
      ImGui::TextDisabled("No sensor is simulated.");
    } else {
      update_curves(plot.curves, *shown.run.frame->trace, shown.run.by_travel());
      draw_options(ui, plot.options, unit_of(viewer.selection, shown.run));
      draw_plot(ui, viewer.selection, shown.run, real, plot);
    }
  }
  ImGui::End();
}

}  // namespace taxel::ui
