// The panel of data sets: episodes as a list, the curves of one, and its replay.
#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/data_set/data_set_state.h"
#include "app/studio/nouns/plot/plot_drawing.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "core/document/scenario/scenario.h"
#include "core/sensor/readout/reading.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {

namespace {

constexpr float kWidestLayout = 12, kSeedWidth = 9;  // in heights of text
constexpr std::size_t kMaxParameters = 40;           // of parameters that have a column

struct TableHead {
  EpisodeColumnId column;
  std::string title;
  std::string tip;
  float width;  ///< in heights of text
};

/// Returns whether all layouts have the same displayed unit.
bool has_one_unit(const OpenDataSet& set) {
  return std::all_of(set.layouts.begin(), set.layouts.end(), [&](const DataSetLayout& layout) {
    return same_unit(shown_unit(layout.aggregate), shown_unit(set.layouts.front().aggregate));
  });
}

std::vector<TableHead> heads_of(const OpenDataSet& set) {
  const float line = ImGui::GetFontSize();
  const auto width_of = [&](const std::string& text) {
    constexpr float kArrow = 1.3f;  // of the column by which the table is sorted, in heights of text
    return ImGui::CalcTextSize(text.c_str()).x / line + kArrow;
  };
  float layout = width_of("Layout");
  for (const DataSetLayout& one : set.layouts) layout = std::clamp(width_of(one.name), layout, kWidestLayout);
  std::vector<TableHead> heads{
      {EpisodeColumnId::episode, "Episode", "Number of the episode in the data set", width_of("Episode")},
      {EpisodeColumnId::layout, "Layout", "Name of the layout", layout},
      {EpisodeColumnId::scenario, "Scenario", "Kind of the scenario", width_of("Scenario")}};
  for (std::size_t i = 0; i < std::min(set.parameters.size(), kMaxParameters); ++i) {
    const DataSetParameter& parameter = set.parameters[i];
    heads.push_back({EpisodeColumnId::parameter, parameter.title, parameter.pointer, width_of(parameter.title)});
  }
  const bool has_unit = !set.layouts.empty() && has_one_unit(set);
  const std::string unit = has_unit ? fmt::format(" ({})", shown_unit(set.layouts.front().aggregate).text) : "";
  heads.push_back({EpisodeColumnId::peak, "Peak" + unit, "Largest reading of all taxels", width_of("Peak" + unit)});
  heads.push_back({EpisodeColumnId::force, "Force (N)", "Largest force on the sensor", width_of("Force (N)")});
  heads.push_back({EpisodeColumnId::rows, "Rows", "Number of recorded rows", width_of("Rows")});
  heads.push_back(
      {EpisodeColumnId::duration, "Duration (s)", "Time from the first row to the last", width_of("Duration (s)")});
  heads.push_back({EpisodeColumnId::seed, "Seed", "Seed of the job's random values", kSeedWidth});
  return heads;
}

void draw_heads(WindowUi& ui, EpisodeOrder& order, const std::vector<TableHead>& heads) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).dim);
  for (std::size_t i = 0; i < heads.size(); ++i) {
    if (!ImGui::TableSetColumnIndex(static_cast<int>(i))) continue;
    ImGui::TableHeader(heads[i].title.c_str());
    ui.widgets.note_item("Sort by " + heads[i].title);
    tooltip(heads[i].tip);
  }
  ImGui::PopStyleColor();
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  const bool is_sorted = specs != nullptr && specs->SpecsCount > 0;
  constexpr std::size_t kBeforeParameters = 3;
  const auto index = is_sorted ? static_cast<std::size_t>(specs->Specs[0].ColumnIndex) : 0;
  order.column = heads[index].column;
  order.parameter = order.column == EpisodeColumnId::parameter ? index - kBeforeParameters : 0;
  order.descending = is_sorted && specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
}

std::string cell_text(const OpenDataSet& set, const EpisodeRow& row, EpisodeColumnId column, bool has_unit) {
  switch (column) {
    case EpisodeColumnId::layout:
      return set.layouts[*row.layout].name;
    case EpisodeColumnId::scenario:
      return row.scenario;
    case EpisodeColumnId::peak: {
      const ReadingUnit unit = shown_unit(set.layouts[*row.layout].aggregate);
      return has_unit ? fmt::format("{:.4g}", unit.scale * row.peak) : in_unit(row.peak, unit);
    }
    case EpisodeColumnId::force:
      return fmt::format("{:.4g}", row.force);
    case EpisodeColumnId::rows:
      return fmt::format("{}", row.rows);
    case EpisodeColumnId::duration:
      return fmt::format("{:.4g}", row.duration);
    case EpisodeColumnId::seed:
      return fmt::format("{}", row.seed);
    default:
      return "";
  }
}

/// Draws a cell's text: numbers at the right end of the cell.
void draw_cell_text(const std::string& text, bool is_number) {
  if (is_number)
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                         std::max(0.0f, ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x));
  ImGui::TextUnformatted(text.c_str());
}

void draw_first_cell(WindowUi& ui, DataSetState& state, std::size_t index) {
  const EpisodeRow& row = state.set->rows[index];
  const std::string text = row.episode ? fmt::format("{}", *row.episode) : "failed";
  const std::string noted = row.episode ? fmt::format("Episode {}", *row.episode) : fmt::format("Failed job {}", index);
  constexpr auto kFlags = ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
  if (!row.episode) ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).error);
  if (ImGui::Selectable(fmt::format("{}##{}", text, index).c_str(), state.chosen == index, kFlags)) {
    state.chosen = index;
    if (row.episode && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
      ui.post(OpenEpisode{state.set->folder, *row.episode});
  }
  if (!row.episode) ImGui::PopStyleColor();
  ui.widgets.note_item(noted);
  tooltip(row.error);
}

void draw_row(WindowUi& ui, DataSetState& state, std::size_t index, const std::vector<TableHead>& heads,
              bool has_unit) {
  const EpisodeRow& row = state.set->rows[index];
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  draw_first_cell(ui, state, index);
  for (std::size_t i = 1, parameter = 0; i < heads.size(); ++i) {
    const EpisodeColumnId column = heads[i].column;
    const std::size_t p = column == EpisodeColumnId::parameter ? parameter++ : 0;
    if (!ImGui::TableNextColumn()) continue;
    if (column == EpisodeColumnId::parameter) {
      draw_cell_text(row.values[p].text, row.values[p].number.has_value());
    } else if (row.episode) {
      draw_cell_text(cell_text(*state.set, row, column, has_unit),
                     column != EpisodeColumnId::layout && column != EpisodeColumnId::scenario);
    } else if (column == EpisodeColumnId::layout) {
      ImGui::TextColored(palette(ui.dark).error, "%s", row.error.c_str());
    }
  }
}

/// Draws the filter and the table into the rest of the window. A click chooses an episode, a double click opens it.
void draw_episode_table(WindowUi& ui, DataSetState& state) {
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##filter", "Filter: number, layout, scenario, value, reason of a failure",
                           &state.order.filter);
  ui.widgets.note_item("Filter episodes", true);
  constexpr auto kFlags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                          ImGuiTableFlags_Sortable | ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingFixedFit |
                          ImGuiTableFlags_NoSavedSettings;
  const std::vector<TableHead> heads = heads_of(*state.set);
  const std::string id = fmt::format("episodes##{}", state.request ? state.request->number : 0);
  if (!ImGui::BeginTable(id.c_str(), static_cast<int>(heads.size()), kFlags)) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  for (const TableHead& head : heads)
    ImGui::TableSetupColumn(head.title.c_str(), ImGuiTableColumnFlags_WidthFixed, head.width * ImGui::GetFontSize());
  draw_heads(ui, state.order, heads);
  update_episode_list(state);
  const bool has_unit = !state.set->layouts.empty() && has_one_unit(*state.set);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(state.list.rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(ui, state, state.list.rows[static_cast<std::size_t>(i)], heads, has_unit);
  ImGui::EndTable();
}

constexpr auto kEpisodePlotFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect |
                                   ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
constexpr float kWidestLegend = 0.35f;  // largest part of a plot's width that its legend takes
constexpr std::size_t kTipLines = 8;    // largest number of curves in the tooltip
constexpr float kEpisodeLeastWidth = 22, kEpisodeLeastHeight = 7;  // sizes of one plot, in heights of text

/// Returns the number of a taxel's colour: that of the document if its layout has the same taxels.
int color_of(const DocumentView& document, const DataSetLayout& layout, std::size_t taxel) {
  const auto own = static_cast<int>(taxel);
  if (!document.model || document.model->layout.taxels.size() != layout.taxel_ids.size()) return own;
  return document.model->color(own);
}

std::vector<ChosenCurve> chosen_readings(const DocumentView& document, const DataSetLayout& layout,
                                         const PlotCurves& curves) {
  std::vector<ChosenCurve> chosen;
  for (std::size_t k = 0; k < curves.readings.size() && k < layout.taxel_ids.size(); ++k) {
    if (!(curves.peaks[k] > kTaxelResponds * curves.largest)) continue;
    ChosenCurve curve;
    curve.key = {0, static_cast<int>(layout.taxel_ids[k])};
    curve.reading = k;
    curve.label = fmt::format("{}", layout.taxel_ids[k]);
    curve.color = color_of(document, layout, k);
    chosen.push_back(std::move(curve));
  }
  return chosen;
}

std::vector<ChosenCurve> chosen_forces(const PlotCurves& curves) {
  constexpr std::array kNames{"x", "y", "z"};
  constexpr std::array kColors{0, 2, 1};  // red, green and blue of the palette of taxels
  std::vector<ChosenCurve> chosen;
  for (std::size_t k = 0; k < kNames.size() && k < curves.readings.size(); ++k) {
    ChosenCurve curve;
    curve.key = {1, static_cast<int>(k)};
    curve.reading = k;
    curve.label = kNames[k];
    curve.color = kColors[k];
    chosen.push_back(std::move(curve));
  }
  return chosen;
}

/// One of the two plots.
struct EpisodePlot {
  const char* name;
  PlotCurves& curves;
  const std::vector<ChosenCurve>& chosen;
  ReadingUnit unit;
  std::string y_name;
  double low = 0, high = 1;  ///< ends of the vertical axis, in the displayed unit
  bool names_x = true;       ///< the horizontal axis has its name
};

void draw_value_tip(const WindowUi& ui, const EpisodePlot& plot, const std::vector<TaxelKey>& focus) {
  if (!ImPlot::IsPlotHovered()) return;
  PlotChoice choice;
  choice.curves = plot.chosen;
  choice.unit = plot.unit;
  const auto readout = read_curves(plot.curves, choice, focus, ImPlot::GetPlotMousePos().x, kTipLines);
  if (!readout || !ImGui::BeginTooltip()) return;
  ImGui::TextUnformatted(fmt::format("{:.4g} {}", readout->x, plot.curves.by_travel ? "mm" : "s").c_str());
  for (const PlotReadout::Line& line : readout->lines) {
    ImGui::TextColored(curve_color(line.color, ui.dark), "%s", line.label.c_str());
    ImGui::SameLine();
    ImGui::TextUnformatted(in_unit(line.value, plot.unit).c_str());
  }
  if (readout->omitted > 0) ImGui::TextDisabled("%zu more", readout->omitted);
  ImGui::EndTooltip();
}

void draw_plot(WindowUi& ui, const EpisodePlot& plot, std::vector<TaxelKey>& isolated, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorPos();
  const float legend = std::min(plot_legend_width(plot.chosen), kWidestLegend * size.x);
  ImGui::PushID(plot.name);
  ImGui::SetCursorPos({at.x + size.x - legend, at.y});
  const LegendPointer pointer = draw_plot_legend(
      ui, plot.chosen, isolated, {legend, size.y},
      [&](const ChosenCurve& curve) { return curve.label + "\nClick: keep the other curves dim. Shift adds."; });
  const std::vector<TaxelKey> focus = focus_of(plot.chosen, pointer.hovered, isolated);
  ImGui::SetCursorPos(at);
  if (ImPlot::BeginPlot("##plot", {size.x - legend, size.y}, kEpisodePlotFlags)) {
    constexpr auto kAxis = ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight;
    const double end = plot.curves.x.empty() ? 1 : std::max(1e-9, plot.curves.x.back());
    const char* const x_name = plot.curves.by_travel ? "travel (mm)" : "time (s)";
    ImPlot::SetupAxes(plot.names_x ? x_name : nullptr, plot.y_name.c_str(), kAxis, kAxis);
    ImPlot::SetupAxisLimits(ImAxis_X1, 0, end, ImPlotCond_Always);
    ImPlot::SetupAxisLimits(ImAxis_Y1, plot.low, plot.high, ImPlotCond_Always);
    ImPlot::SetupFinish();
    for (const std::size_t i : drawing_order(plot.chosen, focus))
      draw_plot_curve(ui, plot.curves, plot.chosen[i], style_of(plot.chosen[i], focus), plot.unit.scale);
    draw_value_tip(ui, plot, focus);
    ImPlot::EndPlot();
    ui.widgets.note_item(plot.name);
  }
  ImGui::PopID();
}

void update_plots(EpisodePlots& plots, const EpisodeCurvesPtr& curves, bool by_travel) {
  if (plots.from == curves) return;
  plots = {};
  plots.from = curves;
  update_curves(plots.readings, curves->readings, by_travel);
  update_curves(plots.forces, curves->forces, by_travel);
}

/// Returns the smallest and the largest component of the force, with 0 between them [N].
std::pair<double, double> range_of(const PlotCurves& forces) {
  double low = 0, high = 0;
  for (const std::vector<double>& component : forces.readings)
    for (const double value : component) low = std::min(low, value), high = std::max(high, value);
  const double margin = 0.08 * std::max(high - low, 1e-6);
  return {low < 0 ? low - margin : 0, high > 0 ? high + margin : low < 0 ? margin : 1};
}

/// Draws both plots of the chosen episode side by side, or one below the other in a narrow area. Draws nothing until
/// the rows are read.
void draw_episode_plots(WindowUi& ui, const DocumentView& document, DataSetState& state, ImVec2 size) {
  const EpisodeRow& row = state.set->rows[*state.chosen];
  const EpisodeCurvesPtr& curves = state.curves;
  if (!row.layout || !curves || curves->from.episode != row.episode || curves->from.folder != state.set->folder) return;
  update_plots(state.plots, curves, row.scenario == scenarios::Sweep::kWord);
  const DataSetLayout& layout = state.set->layouts[*row.layout];
  EpisodePlots& plots = state.plots;
  const ReadingUnit unit = shown_unit(layout.aggregate), newton{"N", 1, false};
  const auto [low, high] = range_of(plots.forces);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const float line = ImGui::GetFontSize();
  const bool is_wide = 0.5f * size.x > kEpisodeLeastWidth * line || size.y < 2 * kEpisodeLeastHeight * line;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 one = is_wide ? ImVec2(0.5f * (size.x - gap), size.y) : ImVec2(size.x, 0.5f * (size.y - gap));
  const std::vector<ChosenCurve> readings = chosen_readings(document, layout, plots.readings),
                                 forces = chosen_forces(plots.forces);
  const double top = unit.scale * axis_top(plots.readings.largest, unit);
  const ImVec2 at = ImGui::GetCursorPos();
  draw_plot(ui,
            {"Readings of the episode", plots.readings, readings, unit, fmt::format("reading ({})", unit.text), 0, top,
             is_wide},
            plots.isolated, one);
  ImGui::SetCursorPos(is_wide ? ImVec2(at.x + one.x + gap, at.y) : ImVec2(at.x, at.y + one.y + gap));
  draw_plot(ui, {"Force of the episode", plots.forces, forces, newton, "force (N)", low, high, true}, plots.isolated,
            one);
  ImGui::PopFont();
}

/// Part of the width that the table takes. In a narrow panel it is the part of the height.
constexpr float kTablePart = 0.5f;

std::string head_text(const OpenDataSet& set) {
  std::string text = fmt::format("{} episodes", grouped(static_cast<long long>(set.rows.size() - set.failed)));
  if (set.failed > 0) text += fmt::format(", {} failed jobs", set.failed);
  if (set.broken > 0) text += fmt::format(", {} broken {} of the list", set.broken, set.broken == 1 ? "line" : "lines");
  return text + fmt::format(", float{}", set.bits);
}

void draw_wrapped(const std::string& text, const ImVec4& color) {
  ImGui::PushTextWrapPos();
  ImGui::TextColored(color, "%s", text.c_str());
  ImGui::PopTextWrapPos();
}

/// Returns why an episode cannot be opened, or an empty text.
std::string obstacle(const DataSetState& state, const Loading& loading) {
  if (!state.chosen) return "Choose an episode in the list first";
  if (!state.set->rows[*state.chosen].episode) return "The job failed: there is no run to repeat";
  if (loading.active) return "Another document is being loaded";
  return "";
}

void draw_open_button(WindowUi& ui, const DataSetState& state, const Loading& loading) {
  const std::string why_not = obstacle(state, loading);
  ImGui::BeginDisabled(!why_not.empty());
  if (button(ui, "Open in the studio"))
    ui.post(OpenEpisode{state.set->folder, *state.set->rows[*state.chosen].episode});
  ImGui::EndDisabled();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled))
    ImGui::SetTooltip(
        "%s", why_not.empty() ? "Open layout and scenario of the episode, run it again, and compare" : why_not.c_str());
}

void draw_replay(const WindowUi& ui, const Shown& shown, const DataSetState& state) {
  const Palette& colors = palette(ui.dark);
  const std::string text = replay_text(shown, state);
  if (text.empty()) return;
  const ReplayVerdict verdict = replay_verdict(shown, state);
  draw_wrapped(text, verdict == ReplayVerdict::equal       ? colors.run
                     : verdict == ReplayVerdict::different ? colors.error
                                                           : colors.dim);
}

std::string episode_text(const OpenDataSet& set, const EpisodeRow& row) {
  if (!row.episode) return fmt::format("Failed job of line {}", row.line);
  return fmt::format("Episode {}: {}, {}", *row.episode, row.scenario, set.layouts[*row.layout].name);
}

/// Draws the chosen episode: the button, its name, the replay, and the curves.
void draw_chosen(WindowUi& ui, const Shown& shown, DataSetState& state) {
  draw_open_button(ui, state, shown.document.loading);
  if (state.chosen) {
    const EpisodeRow& row = state.set->rows[*state.chosen];
    ImGui::SameLine();
    ImGui::TextUnformatted(episode_text(*state.set, row).c_str());
    if (!row.error.empty()) draw_wrapped(row.error, palette(ui.dark).error);
  }
  draw_replay(ui, shown, state);
  if (!state.chosen) return;
  if (state.curves && !state.curves->problem.empty())
    return draw_wrapped(state.curves->problem, palette(ui.dark).error);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float least = 5 * ImGui::GetFontSize();
  draw_episode_plots(ui, shown.document, state, {room.x, std::max(room.y, least)});
}

void draw_set(WindowUi& ui, const Shown& shown, DataSetState& state) {
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  ImGui::TextUnformatted(state.set->folder.c_str());
  tooltip("Written by " + state.set->program);
  ImGui::SameLine();
  ImGui::TextDisabled("%s", head_text(*state.set).c_str());
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool is_wide = room.x > 1.3f * room.y;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 table = is_wide ? ImVec2(kTablePart * room.x, room.y) : ImVec2(room.x, kTablePart * room.y);
  if (ImGui::BeginChild("list", table)) draw_episode_table(ui, state);
  ImGui::EndChild();
  if (is_wide) ImGui::SameLine(0, gap);
  if (ImGui::BeginChild("episode", ImGui::GetContentRegionAvail())) draw_chosen(ui, shown, state);
  ImGui::EndChild();
  ImGui::PopFont();
}

void place_at_first(const ViewPlace& place) {
  constexpr float kWidth = 66, kHeight = 26, kBelow = 4.5f;  // in heights of text; kBelow: timeline and status line
  const float line = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetMainViewport()->WorkPos, room = ImGui::GetMainViewport()->WorkSize;
  const float width = std::max(kWidth * line, place.rect.width() - 2 * line);
  const ImVec2 size(std::min(width, room.x), std::min(kHeight * line, room.y));
  const float lowest = corner.y + room.y - size.y - kBelow * line;
  ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
  const float left = std::min(place.rect.x0 + line, corner.x + room.x - size.x);
  ImGui::SetNextWindowPos(ImVec2(left, std::max(corner.y, lowest)), ImGuiCond_FirstUseEver);
}

void draw_invitation(const DataSetState& state) {
  ImGui::PushTextWrapPos(0);
  if (state.is_reading)
    ImGui::TextDisabled("Reading %s", state.request->folder.c_str());
  else
    ImGui::TextDisabled(
        "No data set is open. Drop the folder of a data set of `taxel batch` here, or open its meta/info.json by "
        "File > Open...");
  ImGui::PopTextWrapPos();
}

void draw_data_set_panel(WindowUi& ui, const ViewPlace& place, const Shown& shown, DataSetState& state, bool& open) {
  if (std::exchange(state.wants_focus, false)) ImGui::SetNextWindowFocus();
  place_at_first(place);
  if (begin_panel(ui, kDataSet.title, &open)) state.set ? draw_set(ui, shown, state) : draw_invitation(state);
  ImGui::End();
}

}  // namespace

constinit const Feature kDataSet{
    .title = "Data set",
    .dock = Dock::floating,
    .opens = Opens::by_user,
    .key = "panel_data_set",
    .label = "Data set panel",
    .draw =
        [](App& app) {
          draw_data_set_panel(*app.ui, app.viewer->view, *app.shown, app.get<DataSetState>(),
                              app.get<PanelsShown>()[kDataSet]);
        },
    .begin_frame = [](App& app) { app.get<DataSetState>().replayed = app.shown->document.episode; },
    .update = [](App& app) { follow_replay(*app.shown, app.get<DataSetState>()); },
    .make_job = studio::make_data_set_job,
    .dump = dump_data_set,
};

}  // namespace taxel::ui
