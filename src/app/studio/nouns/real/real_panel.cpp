// The dialog, the panel and the curves of a recording of a real sensor.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <implot.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/base/page/curve.h"
#include "core/base/text/rounded.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {
namespace {

void draw_what(WindowUi& ui, const RealShown& real) {
  const TaxelSeries& series = real.recording.series;
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("%s", real.file.c_str());
  ImGui::PopTextWrapPos();
  if (begin_properties("real")) {
    property("Rows", fmt::format("{}", series.time.size()));
    property("Lasts", fmt::format("{:.6g} s", series.time.back() - series.time.front()));
    property("Taxels", fmt::format("{}", series.taxel_ids.size()));
    begin_property("Shift (s)", "Added to its times, so that they are the run's");
    if (const auto typed = number_field(ui, "Shift", {real.shift}, {"s", 0, 6})) ui.post(ShiftReal{*typed});
    if (real.alignment) {
      property("Correlation", fmt::format("{:.4f}", real.alignment->correlation));
      property("Overlap", fmt::format("{:.4g} s", real.alignment->overlap));
    }
    end_properties();
  }
  for (const std::string& note : real.recording.notes) caption(note.c_str());
}

void draw_steps(WindowUi& ui, RealState& real) {
  if (button(ui, "Align")) ui.post(ActOnReal{RealTask::align});
  tooltip("Find the shift at which recording and run look most alike");
  ImGui::SameLine();
  if (button(ui, "Fit gains")) ui.post(ActOnReal{RealTask::fit});
  tooltip("recording = gain * reading + offset, by least squares");
  ImGui::SameLine();
  if (button(ui, "Remove")) ui.post(ActOnReal{RealTask::remove});
  checkbox(ui, "One gain for all", &real.options.common);
  checkbox(ui, "With offset", &real.options.offset);
}

/// Returns the id of a taxel with its name, if it has one.
std::string taxel_with_name(const Layout& layout, int id) {
  const int index = index_of(layout, id);
  const std::string name = index < 0 ? "" : layout.taxels[static_cast<std::size_t>(index)].name;
  return name.empty() ? std::to_string(id) : fmt::format("{} ({})", id, name);
}

/// Returns the relation that was fitted, with the units of the numbers in the table.
std::string fitted_relation(const std::string& unit_of_values, const ReadingUnit& unit) {
  return fmt::format("recording = gain x reading + offset; gain in {} per {}, offset and RMS in {}", unit_of_values,
                     unit.text, unit_of_values);
}

/// Draws a text in the next cell of a table. A long text breaks into lines, so that no name is cut.
void draw_cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

void draw_fit(const TaxelFit& fit, const Layout& layout, const ReadingUnit& unit) {
  ImGui::TableNextRow();
  draw_cell(taxel_with_name(layout, fit.taxel));
  if (!fit.refused.empty()) return draw_cell("-");
  draw_cell(fmt::format("{:.3g}", fit.gain / unit.scale));
  draw_cell(rounded(fit.offset, 3, 6));
  draw_cell(with_decimals(fit.r2, 3));
  draw_cell(rounded(fit.residual, 2, 6));
  tooltip("Root mean square of recording - (gain * reading + offset)");
}

/// Draws the gains, per displayed unit of the readings.
void draw_fits(WindowUi& ui, const RealShown& real, const Layout& layout) {
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
  constexpr float kNameShare = 2, kNumberShare = 1;  // of the width of the columns
  if (real.fits.empty()) return;
  const ReadingUnit unit = shown_unit(layout.readout.aggregate);
  const std::string of_values = real.unit.empty() ? "units of the recording" : real.unit;
  const std::string relation = fitted_relation(of_values, unit);
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("%s", relation.c_str());
  ImGui::PopTextWrapPos();
  ui.widgets.note_item(relation);
  constexpr std::array heads{"Taxel", "Gain", "Offset", "R\u00b2", "RMS"};
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  if (!ImGui::BeginTable("fits", static_cast<int>(heads.size()), kFlags)) return ImGui::PopFont();
  for (std::size_t i = 0; i < heads.size(); ++i)
    ImGui::TableSetupColumn(heads[i], 0, i == 0 ? kNameShare : kNumberShare);
  ImGui::TableHeadersRow();
  for (const TaxelFit& fit : real.fits) draw_fit(fit, layout, unit);
  ImGui::EndTable();
  ImGui::PopFont();
  for (const TaxelFit& fit : real.fits)
    if (!fit.refused.empty()) caption(fmt::format("taxel {} {}", fit.taxel, fit.refused).c_str());
}

void draw_apply(WindowUi& ui, const DocumentView& document, const RealState& real_state, const RealShown& real) {
  if (real.fits.empty()) return;
  ImGui::BeginDisabled(!document.editing.project);
  if (button(ui, "Apply as calibration")) ui.post(ActOnReal{RealTask::apply});
  ImGui::EndDisabled();
  tooltip("The gains, and offsets as tares, become the layout's calibration: an edit that can be undone");
  if (real_state.applied.empty()) return;
  ImGui::PushTextWrapPos();
  ImGui::TextColored(palette(ui.dark).error, "%s", real_state.applied.c_str());
  ImGui::PopTextWrapPos();
}

/// Returns the layout of the sensor that a recording is drawn over; an empty one if the run has no such sensor.
Layout layout_of_real(const RunView& run, const RealShown& real) {
  const auto sensor = static_cast<std::size_t>(real.sensor);
  const bool is_known = run.frame && sensor < run.frame->sensors.size() && run.frame->sensors[sensor].model;
  return is_known ? run.frame->sensors[sensor].model->layout : Layout{};
}

void draw_no_recording(WindowUi& ui) {
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("A recording of the real sensor is drawn as points over the curves of the run.");
  ImGui::PopTextWrapPos();
  if (button(ui, "Read a recording...")) ui.post(ReadRealRecording{});
  tooltip("A table with a column for each taxel");
}

void draw_real_panel(WindowUi& ui, const Viewer& viewer, const Shown& shown, RealState& real) {
  const bool stays = viewer.mode == Mode::analyse;
  if (!shows_run(viewer.mode) || (!real.shown && !stays)) return;
  if (std::exchange(real.comes_to_front, false)) ImGui::SetNextWindowFocus();
  bool open = true;
  if (begin_panel(ui, kReal.title, real.shown ? &open : nullptr)) {
    if (!real.shown) {
      draw_no_recording(ui);
      return ImGui::End();
    }
    draw_what(ui, *real.shown);
    draw_steps(ui, real);
    draw_apply(ui, shown.document, real, *real.shown);
    if (!real.shown->fits.empty()) draw_fits(ui, *real.shown, layout_of_real(shown.run, *real.shown));
  }
  ImGui::End();
  if (!open) ui.post(ActOnReal{RealTask::remove});
}

std::vector<PanelPart> real_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.get<RealState>().shown != nullptr ? nullptr : "Import a real recording first";
  };
  return {{"Shift", "", "Time shift of the real recording", kSimulate, kWhyNot},
          {"Align", "", "Find the time shift with the best agreement", kSimulate, kWhyNot},
          {"Fit gains", "", "Solve for gains and offsets by least squares", kSimulate, kWhyNot},
          {"One gain for all", "", "The same gain for all taxels", kSimulate, kWhyNot},
          {"With offset", "", "Fit offsets too", kSimulate, kWhyNot},
          {"Apply as calibration", "", "Make the gains the calibration of the layout", kSimulate, kWhyNot}};
}

}  // namespace

constinit const Feature kReal{
    .title = "Real",
    .dock = Dock::inspector,
    .draw = [](App& app) { draw_real_panel(*app.ui, *app.viewer, *app.shown, app.get<RealState>()); },
    .parts = real_parts,
    .guide = "Compare with a real recording",
    .analyse = {.tab = 6, .question = "Does the real sensor read the same?"},
    .draw_card = [](App& app) { draw_real_dialog(*app.ui, *app.viewer, *app.shown, app.get<RealState>()); },
    .dump = dump_real,
};

namespace {

constexpr std::array<std::string_view, 4> kSeparators{"comma", "semicolon", "tab", "blanks"};
constexpr std::array<const char*, 4> kSeparatorTexts{",", ";", "\t", " "};
constexpr std::array<std::string_view, 2> kDecimals{"point", "comma"};
constexpr std::uint64_t kMostHeaderLines = 1000;

std::size_t separator_of(const ColumnMapping& mapping) {
  const auto found = std::find(kSeparatorTexts.begin(), kSeparatorTexts.end(), mapping.separator);
  return found == kSeparatorTexts.end() ? 0 : static_cast<std::size_t>(found - kSeparatorTexts.begin());
}

void draw_format(WindowUi& ui, RealState& real) {
  ColumnMapping& m = real.mapping;
  const auto look = [&] { ui.post(ActOnReal{RealTask::look}); };
  begin_property("Separator", "Between the columns");
  if (const auto made = choice_of(ui, "Separator", kSeparators, separator_of(m))) {
    m.separator = kSeparatorTexts[*made];
    look();
  }
  begin_property("Decimal mark");
  if (const auto made = choice_of(ui, "Decimal mark", kDecimals, m.decimal == "," ? 1 : 0)) {
    m.decimal = *made == 1 ? "," : ".";
    look();
  }
  begin_property("Header lines", "Before the numbers; the last one names the columns");
  const auto lines = static_cast<std::uint64_t>(std::max(0, m.header_lines));
  if (const auto typed = whole_field(ui, "Header lines", lines, kMostHeaderLines)) {
    m.header_lines = static_cast<int>(*typed);
    look();
  }
}

void draw_values(WindowUi& ui, RealState& real) {
  ColumnMapping& m = real.mapping;
  if (m.time.empty()) {
    begin_property("Rows per second", "Where no column is the time");
    if (const auto typed = number_field(ui, "Rows per second", {m.rate}, {"", 0, -1})) m.rate = *typed;
  } else {
    begin_property("Unit of time");
    if (const auto made = choice_of(ui, "Unit of time", kTimeUnitWords, static_cast<std::size_t>(m.time_unit)))
      m.time_unit = static_cast<TimeUnit>(*made);
  }
  begin_property("Unit", "Of the values, as it is to be shown");
  if (const auto typed = text_field(ui, "Unit of values", {m.unit})) m.unit = *typed;
  begin_property("Gain", "value = gain * field + offset");
  if (const auto typed = number_field(ui, "Gain of values", {m.gain}, {"", 0, -1})) m.gain = *typed;
  begin_property("Offset", "value = gain * field + offset");
  if (const auto typed = number_field(ui, "Offset of values", {m.offset}, {"", 0, -1})) m.offset = *typed;
}

/// Returns the name of a column in a mapping: its number if another column has the same name.
std::string name_in_mapping(const TableLook& look, std::size_t column) {
  const bool single = std::count(look.columns.begin(), look.columns.end(), look.columns[column]) == 1;
  return single ? look.columns[column] : fmt::format("#{}", column + 1);
}

bool is_column(const std::string& named, const TableLook& look, std::size_t column) {
  return named == name_in_mapping(look, column) || named == fmt::format("#{}", column + 1);
}

/// Returns the meaning of a column: "-", "time", or the taxel.
std::string meaning_of(const ColumnMapping& m, const TableLook& look, std::size_t column) {
  if (!m.time.empty() && is_column(m.time, look, column)) return "time";
  for (const TaxelColumn& taxel : m.taxels)
    if (is_column(taxel.column, look, column)) return fmt::format("taxel {}", taxel.taxel);
  return "-";
}

/// Assigns the column to `taxel`, or to nothing if `taxel` is empty.
void give(ColumnMapping& m, const TableLook& look, std::size_t column, std::optional<int> taxel) {
  if (!m.time.empty() && is_column(m.time, look, column)) m.time.clear();
  std::erase_if(m.taxels, [&](const TaxelColumn& one) {
    return is_column(one.column, look, column) || (taxel && one.taxel == *taxel);
  });
  if (taxel) m.taxels.push_back({*taxel, name_in_mapping(look, column), {}, {}});
}

void draw_meaning(WindowUi& ui, RealState& real, std::size_t column, const std::vector<Taxel>& taxels) {
  ColumnMapping& m = real.mapping;
  const TableLook& look = real.look;
  const std::string label = fmt::format("##meaning{}", column), noted = "Meaning of " + name_in_mapping(look, column);
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo(label.c_str(), meaning_of(m, look, column).c_str());
  if (!open) return ui.widgets.note_item(noted);
  if (selectable(ui, "-", false)) give(m, look, column, std::nullopt);
  if (selectable(ui, "time", false)) {
    give(m, look, column, std::nullopt);
    m.time = name_in_mapping(look, column);
  }
  for (const Taxel& taxel : taxels) {
    const std::string name = fmt::format("taxel {}{}{}", taxel.id, taxel.name.empty() ? "" : " ", taxel.name);
    if (selectable(ui, name.c_str(), false)) give(m, look, column, taxel.id);
  }
  ImGui::EndCombo();
}

void draw_columns(WindowUi& ui, RealState& real, const std::vector<Taxel>& taxels, float height) {
  const TableLook& look = real.look;
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("columns", 3, kFlags, ImVec2(0, height))) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Column", ImGuiTableColumnFlags_WidthStretch, 0.25f);
  ImGui::TableSetupColumn("Means", ImGuiTableColumnFlags_WidthStretch, 0.3f);
  ImGui::TableSetupColumn("First values", ImGuiTableColumnFlags_WidthStretch, 0.45f);
  ImGui::TableHeadersRow();
  for (std::size_t c = 0; c < look.columns.size(); ++c) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(look.columns[c].c_str());
    ImGui::TableNextColumn();
    draw_meaning(ui, real, c, taxels);
    ImGui::TableNextColumn();
    std::string first;
    for (const std::vector<std::string>& row : look.rows) {
      const std::string longer = c < row.size() ? first + (first.empty() ? "" : "   ") + row[c] : first;
      const bool fits = ImGui::CalcTextSize(longer.c_str()).x <= ImGui::GetContentRegionAvail().x;
      if (fits || first.empty()) first = longer;
    }
    ImGui::TextDisabled("%s", first.c_str());
  }
  ImGui::EndTable();
}

}  // namespace

void draw_real_dialog(WindowUi& ui, const Viewer& viewer, const Shown& shown, RealState& real) {
  constexpr const char* kTitle = "Map columns";
  if (real.asks && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const float line = ImGui::GetFontSize();
  place_dialog(44, 40);
  if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoDocking)) return;
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("%s", real.file.c_str());
  ImGui::PopTextWrapPos();
  if (begin_properties("format")) {
    draw_format(ui, real);
    draw_values(ui, real);
    end_properties();
  }
  const SensorModelPtr model = shown.model(viewer);
  const float below = (real.problem.empty() ? 1.0f : 3.0f) * ImGui::GetFrameHeightWithSpacing();
  draw_columns(ui, real, model ? model->layout.taxels : std::vector<Taxel>{},
               std::max(6 * line, ImGui::GetContentRegionAvail().y - below));
  if (!real.problem.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(palette(ui.dark).error, "%s", real.problem.c_str());
    ImGui::PopTextWrapPos();
  }
  const ImVec2 size(8 * line, 0);
  if (button(ui, "Save mapping", ImVec2(9 * line, 0))) ui.post(ActOnReal{RealTask::save_mapping});
  tooltip("Save it next to the table as NAME.recmap.json, for the next time");
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - 2 * size.x -
                  ImGui::GetStyle().ItemSpacing.x);
  if (button(ui, "Cancel", size) || escapes_dialog(ui)) real.asks = false;
  ImGui::SameLine();
  if (button(ui, "Overlay", size)) ui.post(ActOnReal{RealTask::overlay});
  if (!real.asks) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

namespace {

/// Returns the plot's x for a time of the run: the travel [mm] in a sweep, otherwise the time [s]. NaN outside of the
/// run.
double x_at(const std::vector<TraceRow>& rows, bool sweep, double time) {
  if (rows.size() < 2 || time < rows.front().time || time > rows.back().time)
    return std::numeric_limits<double>::quiet_NaN();
  if (!sweep) return time;
  const auto next = std::upper_bound(rows.begin() + 1, rows.end() - 1, time,
                                     [](double t, const TraceRow& row) { return t < row.time; });
  const TraceRow &a = *(next - 1), &b = *next;
  const double part = b.time > a.time ? (time - a.time) / (b.time - a.time) : 0;
  return 1e3 * ((1 - part) * a.travel + part * b.travel);
}

/// The conversion from a recorded value to the reading that gave it.
struct AsReading {
  double gain = 1, offset = 0;
  [[nodiscard]] double operator()(double value) const { return (value - offset) / gain; }
};

/// Returns the conversion of a taxel. Without a gain, the largest of all values is scaled to the largest reading.
AsReading as_reading(const RealShown& real, int taxel, double largest) {
  for (const TaxelFit& fit : real.fits)
    if (fit.taxel == taxel && fit.refused.empty()) return {fit.gain, fit.offset};
  double most = 0;
  for (const std::vector<double>& values : real.recording.series.values)
    for (const double value : values) most = std::max(most, std::isnan(value) ? 0.0 : std::abs(value));
  return {largest > 0 && most > 0 ? most / largest : 1, 0};
}

void rebuild(RealCurves& kept, const RunView& run, const RealState& real_state, double largest, std::size_t first) {
  const RealShown& real = *real_state.shown;
  const Trace& trace = *run.frame->trace;
  kept = {real_state.shown, trace.edition, trace.rows.size(), first, {}};
  const TaxelSeries& series = real.recording.series;
  for (std::size_t k = 0; k < series.taxel_ids.size(); ++k) {
    RealCurves::Curve& curve = kept.curves.emplace_back();
    curve.taxel = series.taxel_ids[k];
    const AsReading reading = as_reading(real, curve.taxel, largest);
    for (std::size_t i = 0; i < series.time.size(); ++i) {
      const double x = x_at(trace.rows, run.by_travel(), series.time[i] + real.shift);
      const double y = series.values[k][i];
      if (std::isnan(x) || std::isnan(y)) continue;
      curve.x.push_back(x);
      curve.y.push_back(reading(y));
    }
  }
}

/// Draws the samples of a recording as rings, as far as they are apart on the screen. Returns their number.
int draw_points(const RealCurves::Curve& curve, double scale, ImU32 color, float weight, float pixel) {
  constexpr float kApart = 7, kRadius = 2.6f;  // [pixels at scale 1]
  ImVec2 last(-1e9f, 0);
  int drawn = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const ImVec2 at = ImPlot::PlotToPixels(curve.x[i], scale * curve.y[i]);
    if (std::hypot(at.x - last.x, at.y - last.y) < kApart * pixel) continue;
    ImPlot::GetPlotDrawList()->AddCircle(at, kRadius * pixel, color, 0, weight);
    last = at;
    ++drawn;
  }
  return drawn;
}

/// Names the look of a recording in the upper left corner of the plot.
void draw_points_key(const WindowUi& ui) {
  constexpr const char* kText = "real recording";
  const float line = ImGui::GetFontSize();
  const auto pixel = static_cast<float>(ui.pixel_scale);
  const Palette& colors = palette(ui.dark);
  const ImVec2 at(ImPlot::GetPlotPos().x + 0.5f * line, ImPlot::GetPlotPos().y + 0.3f * line);
  ImDrawList& list = *ImPlot::GetPlotDrawList();
  const float text = 1.3f * line;
  list.AddRectFilled(at, {at.x + text + ImGui::CalcTextSize(kText).x + 0.3f * line, at.y + 1.2f * line},
                     to_u32(colors.raised, 0.85f), 3);
  list.AddCircle({at.x + 0.7f * line, at.y + 0.6f * line}, 2.6f * pixel, to_u32(colors.text), 0, 1.4f * pixel);
  list.AddText({at.x + text, at.y + 0.1f * line}, to_u32(colors.text), kText);
}

/// Returns whether the plot leaves the taxel out because it leaves out the taxel's reading.
bool is_left_out(const PlotState& plot, std::size_t reading) {
  if (!plot.options.responding_only || reading >= plot.curves.readings.size()) return false;
  return !(plot.curves.peaks[reading] > kTaxelResponds * plot.curves.largest);
}

}  // namespace

void draw_real_curves(WindowUi& ui, const Selection& selection, const RunView& run, RealState& real,
                      const PlotState& plot, double scale, double largest, std::size_t first) {
  if (!real.shown || !run.frame->trace || real.shown->sensor != selection.sensor) return;
  RealCurves& kept = real.curves;
  const Trace& trace = *run.frame->trace;
  if (kept.shown != real.shown || kept.edition != trace.edition || kept.rows != trace.rows.size() ||
      kept.first != first)
    rebuild(kept, run, real, largest, first);
  const SensorModel& model = *run.frame->scene->sensors[static_cast<std::size_t>(selection.sensor)];
  real.points = 0;
  ImPlot::PushPlotClipRect();
  for (const RealCurves::Curve& curve : kept.curves) {
    for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
      if (model.layout.taxels[k].id != curve.taxel || is_left_out(plot, first + k)) continue;
      const glm::vec3 c = taxel_color(model.color(static_cast<int>(k)));
      const float weight = (selection.contains(curve.taxel) ? 2.4f : 1.4f) * static_cast<float>(ui.pixel_scale);
      real.points += draw_points(curve, scale, ImGui::GetColorU32(ImVec4(c.x, c.y, c.z, 1)), weight,
                                 static_cast<float>(ui.pixel_scale));
    }
  }
  draw_points_key(ui);
  ImPlot::PopPlotClipRect();
}

}  // namespace taxel::ui
