// The panel with the time of simulation steps and of frames, split into parts.
#include "app/studio/nouns/profiler/profiler_state.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <numeric>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr float kLeastHeight = 7;           // smallest height of a plot, in heights of text; below it the panel scrolls
constexpr float kLeastWidth = 62;           // smallest width of the panel for plots side by side, in heights of text
constexpr std::size_t kSpikesLeftOut = 50;  // one value in this number may reach beyond the plot

/// One part of the time, as a series.
struct Part {
  const char* name;
  std::vector<double> milliseconds;  ///< time of each frame or step [ms], oldest first
};

template <class Costs, class Value>
Part part(const char* name, const Costs& costs, Value(Costs::value_type::*member)) {
  Part part{name, {}};
  for (const auto& cost : costs) part.milliseconds.push_back(1e3 * static_cast<double>(cost.*member));
  return part;
}

std::vector<Part> step_parts(const std::vector<StepCost>& costs) {
  return {part("MuJoCo", costs, &StepCost::mujoco), part("contact surfaces", costs, &StepCost::surfaces),
          part("forces", costs, &StepCost::forces), part("rays, readings", costs, &StepCost::readings),
          part("history", costs, &StepCost::history)};
}

std::vector<Part> picture_parts(const std::deque<PictureCost>& costs) {
  return {part("panels", costs, &PictureCost::panels), part("3-D view", costs, &PictureCost::scene),
          part("window", costs, &PictureCost::window)};
}

/// Returns the top of a plot's axis, which leaves out the highest spikes.
double top_of(std::vector<double> sums) {
  const std::size_t last = sums.size() - 1 - sums.size() / kSpikesLeftOut;
  std::nth_element(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(last), sums.end());
  return nice_ceiling(std::max(1e-3, sums[last]));
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Draws the parts stacked above each other, with the mean of each part in the legend.
void draw_parts(const std::vector<Part>& parts, const std::vector<double>& sums) {
  const auto count = static_cast<int>(sums.size());
  const double mean = mean_of(sums), first = 1.0 - static_cast<double>(count);
  std::vector<double> x(sums.size()), below(sums.size(), 0.0), above;
  std::iota(x.begin(), x.end(), first);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    above = below;
    for (std::size_t i = 0; i < above.size(); ++i) above[i] += parts[p].milliseconds[i];
    const glm::vec3 c = taxel_color(static_cast<int>(p));
    ImPlotSpec spec;
    spec.FillColor = spec.LineColor = ImVec4(c.x, c.y, c.z, 1);
    const double own = mean_of(parts[p].milliseconds);
    const std::string label = fmt::format("{}: {} ({:.0f} %)###{}", parts[p].name, duration_text(1e-3 * own),
                                          mean > 0 ? 100 * own / mean : 0.0, p);
    ImPlot::PlotShaded(label.c_str(), x.data(), below.data(), above.data(), count, spec);
    below = above;
  }
}

void draw_costs(WindowUi& ui, const char* title, const char* unit, const std::vector<Part>& parts, ImVec2 size) {
  std::vector<double> sums(parts.front().milliseconds.size(), 0.0);
  for (const Part& one : parts)
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += one.milliseconds[i];
  ImGui::BeginGroup();
  const std::string mean = sums.empty() ? "none yet" : duration_text(1e-3 * mean_of(sums));
  caption(fmt::format("{}: {}", title, mean).c_str());
  constexpr auto kFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect | ImPlotFlags_NoMouseText;
  constexpr auto kAxis = ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight | ImPlotAxisFlags_Lock;
  const float height = std::max(kLeastHeight * ImGui::GetFontSize(), size.y - ImGui::GetTextLineHeightWithSpacing());
  if (sums.size() > 1 && ImPlot::BeginPlot(fmt::format("##{}", title).c_str(), {size.x, height}, kFlags)) {
    ImPlot::SetupAxes(unit, "ms", kAxis, kAxis);
    ImPlot::SetupAxisLimits(ImAxis_X1, 1.0 - static_cast<double>(sums.size()), 0, ImPlotCond_Always);
    ImPlot::SetupAxisLimits(ImAxis_Y1, 0, top_of(sums), ImPlotCond_Always);
    ImPlot::SetupLegend(ImPlotLocation_East, ImPlotLegendFlags_Outside | ImPlotLegendFlags_NoMenus);
    ImPlot::SetupFinish();
    draw_parts(parts, sums);
    ImPlot::EndPlot();
    ui.widgets.note_item(title);
  }
  ImGui::EndGroup();
}

void draw_all(WindowUi& ui, const RunView& run, const ProfileState& profile) {
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool beside = room.x > kLeastWidth * ImGui::GetFontSize();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 size = beside ? ImVec2(0.5f * (room.x - gap), room.y) : ImVec2(room.x, 0.5f * room.y);
  draw_costs(ui, "A step", "steps ago", step_parts(run.frame ? run.frame->costs : std::vector<StepCost>{}), size);
  if (beside) ImGui::SameLine();
  draw_costs(ui, "A picture", "pictures ago", picture_parts(profile.pictures), size);
  ImGui::PopFont();
}

void draw_profiler_panel(WindowUi& ui, const RunView& run, bool& open, const ProfileState& profile) {
  if (begin_panel(ui, kProfiler.title, &open)) {
    if (run.performance.is_real_time) {
      draw_all(ui, run, profile);
    } else {
      ImGui::PushTextWrapPos();
      ImGui::TextDisabled("Times are not shown where pictures follow a script: those are the same every time.");
      ui.widgets.note_item("No times");
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
}

}  // namespace

constinit const Feature kProfiler{
    .title = "Profiler",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .key = "panel_profiler",
    .label = "Profiler",
    .chord = ImGuiKey_F3,
    .draw =
        [](App& app) {
          draw_profiler_panel(*app.ui, app.shown->run, app.get<PanelsShown>()[kProfiler], app.get<ProfileState>());
        },
    .guide = "Run it",
    .dump = dump_profile,
};

}  // namespace taxel::ui
