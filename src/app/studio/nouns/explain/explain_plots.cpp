#include "app/studio/nouns/explain/explain_plots.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/plot_click.h"

namespace taxel::ui {
namespace {

constexpr float kPlotLines = 7.5f;  // height of a plot, in lines of text
constexpr auto kPlotFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect |
                            ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
constexpr auto kAxisFlags = ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight | ImPlotAxisFlags_Lock;

bool begin_plot(const char* id) {
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, kPlotLines * ImGui::GetTextLineHeight());
  if (ImPlot::BeginPlot(id, size, kPlotFlags)) return true;
  ImGui::PopFont();
  return false;
}
void end_plot() {
  ImPlot::EndPlot();
  ImGui::PopFont();
}

void plot_level(const char* id, double y, const ImVec4& color) {
  ImPlotSpec spec;
  spec.LineColor = color;
  spec.LineWeight = 1.2f;
  spec.Flags = ImPlotInfLinesFlags_Horizontal;
  ImPlot::PlotInfLines(id, &y, 1, spec);
}

/// Areas [mm^2] and mean pressures [kPa] of a group of polygons.
struct Dots {
  std::vector<double> area, pressure;
  void add(const PolygonBehind& p) {
    area.push_back(1e6 * p.area);
    pressure.push_back(1e-3 * p.mean);
  }
};

void plot_dots(const char* id, const Dots& dots, const ImVec4& color, float size) {
  ImPlotSpec spec;
  spec.LineColor = color;
  spec.Marker = ImPlotMarker_Circle;
  spec.MarkerSize = size;
  spec.MarkerFillColor = color;
  ImPlot::PlotScatter(id, dots.area.data(), dots.pressure.data(), static_cast<int>(dots.area.size()), spec);
}

/// Selects the polygon whose dot is nearest to a click, within a few pixels.
void pick_dot(ExplainState& explain, const Explanation& e) {
  constexpr float kReach = 12;
  if (!plot_clicked()) return;
  const ImVec2 mouse = ImGui::GetMousePos();
  float nearest = kReach * kReach;
  for (const PolygonBehind& p : e.polygons) {
    const ImVec2 dot = ImPlot::PlotToPixels(1e6 * p.area, 1e-3 * p.mean);
    const float dx = dot.x - mouse.x, dy = dot.y - mouse.y, away = dx * dx + dy * dy;
    if (!(away < nearest)) continue;
    nearest = away;
    explain.polygon = PolygonNumber{p.surface, p.polygon};
  }
}

}  // namespace

void draw_convergence(WindowUi& ui, const Explanation& e) {
  if (!e.levels) {
    caption(e.no_levels.c_str());
    return;
  }
  const ReadingUnit unit = shown_unit(e.aggregate);
  const Palette& colors = palette(ui.dark);
  std::array<double, 3> x{}, y{};
  double lo = std::numeric_limits<double>::infinity(), hi = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = e.levels->samples[i];
    y[i] = unit.scale * e.levels->now[i];
    lo = std::min(lo, y[i]), hi = std::max(hi, y[i]);
  }
  const double exact = e.exact.value ? unit.scale * *e.exact.value : y[1];
  lo = std::min(lo, exact), hi = std::max(hi, exact);
  const double room = std::max(0.15 * (hi - lo), 0.02 * std::max(hi, 1e-9));
  caption("Reading by number of samples; the line is the exact one");
  if (!begin_plot("##convergence")) return;
  ImPlot::SetupAxes(nullptr, unit.text, kAxisFlags, kAxisFlags);
  ImPlot::SetupAxisScale(ImAxis_X1, ImPlotScale_Log10);
  ImPlot::SetupAxisLimits(ImAxis_X1, 0.7 * std::max(1.0, x[0]), 1.4 * std::max(1.0, x[2]), ImPlotCond_Always);
  std::array<std::string, 3> counts;
  std::array<const char*, 3> labels{};
  for (std::size_t i = 0; i < counts.size(); ++i) labels[i] = (counts[i] = grouped(e.levels->samples[i])).c_str();
  ImPlot::SetupAxisTicks(ImAxis_X1, x.data(), static_cast<int>(x.size()), labels.data());
  ImPlot::SetupAxisLimits(ImAxis_Y1, lo - room, hi + room, ImPlotCond_Always);
  ImPlot::SetupFinish();
  if (e.exact.value) plot_level("##exact", exact, colors.path);
  ImPlotSpec spec;
  spec.LineColor = colors.text;
  spec.LineWeight = 1.4f;
  spec.Marker = ImPlotMarker_Circle;
  ImPlot::PlotLine("##readings", x.data(), y.data(), static_cast<int>(x.size()), spec);
  end_plot();
  ui.widgets.note_item("Convergence plot");
}

void draw_scatter(WindowUi& ui, ExplainState& explain, const Explanation& e) {
  if (e.polygons.empty()) return;
  const Palette& colors = palette(ui.dark);
  Dots others, serving, selected;
  double area = 0, pressure = 0;
  for (const PolygonBehind& p : e.polygons) {
    (p.samples > 0 || p.exact_share > 0 ? serving : others).add(p);
    if (explain.polygon == PolygonNumber{p.surface, p.polygon}) selected.add(p);
    area = std::max(area, 1e6 * p.area), pressure = std::max(pressure, 1e-3 * p.mean);
  }
  if (!begin_plot("##scatter")) return;
  ImPlot::SetupAxes("area (mm\xc2\xb2)", "kPa", kAxisFlags, kAxisFlags);
  ImPlot::SetupAxisLimits(ImAxis_X1, 0, 1.08 * area, ImPlotCond_Always);
  ImPlot::SetupAxisLimits(ImAxis_Y1, 0, 1.08 * pressure, ImPlotCond_Always);
  ImPlot::SetupFinish();
  plot_dots("##others", others, colors.dim, 1.6f);
  plot_dots("##serving", serving, colors.accent, 2.4f);
  plot_dots("##selected", selected, colors.text, 5.0f);
  pick_dot(explain, e);
  const ImVec2 lo = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize();
  ui.widgets.note(kExplain.title, "Scatter dots", {lo.x, lo.y, lo.x + size.x, lo.y + size.y});
  end_plot();
  ui.widgets.note_item("Scatter");
}

}  // namespace taxel::ui
