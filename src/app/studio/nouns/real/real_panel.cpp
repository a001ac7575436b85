// The dialog, the panel and the curves of a recording of a real sensor.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/base/text/rounded.h"
#include "core/sensor/readout/reading.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"

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
    constexpr const char* kShiftTip =
        "Time of the run = time of the recording + shift.\nNegative: the recording shows the same event later than the "
        "run";
    begin_property("Shift (s)", kShiftTip);
    if (const auto typed = number_field(ui, "Shift", {real.shift}, {"s", 0, 4})) ui.post(ShiftReal{*typed});
    tooltip(kShiftTip);
    if (real.alignment) {
      property("Correlation", fmt::format("{:.4f}", real.alignment->correlation));
      property("Overlap", fmt::format("{:.4g} s", real.alignment->overlap));
    }
    end_properties();
  }
  for (const std::string& note : real.recording.notes) caption(note.c_str());
}

/// Draws the buttons, and the reason why the last one had no effect.
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
  if (real.shown->awaits_end) caption("The run is not over: the recording is aligned when it ends.");
  if (real.refused.empty()) return;
  ImGui::PushTextWrapPos();
  ImGui::TextColored(palette(ui.dark).error, "%s", real.refused.c_str());
  ImGui::PopTextWrapPos();
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

/// Draws a number in the next cell of a table, whose column is as wide as its numbers.
void draw_number(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

/// Returns a gain with four digits, without an exponent between 0.0001 and 100 000.
std::string gain_text(double gain) {
  const double size = std::abs(gain);
  return size == 0 || (size >= 1e-4 && size <= 1e5) ? rounded(gain, 4, 8) : fmt::format("{:.4g}", gain);
}

void draw_fit(const TaxelFit& fit, const Layout& layout, const ReadingUnit& unit) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(0);  // a long name breaks into lines, so that it is not cut
  ImGui::TextUnformatted(taxel_with_name(layout, fit.taxel).c_str());
  ImGui::PopTextWrapPos();
  if (!fit.refused.empty()) return draw_number("-");
  draw_number(gain_text(fit.gain / unit.scale));
  draw_number(rounded(fit.offset, 4, 6));
  draw_number(with_decimals(fit.r2, 3));
  draw_number(rounded(fit.residual, 3, 6));
  tooltip("Root mean square of recording - (gain * reading + offset)");
}

/// Names the taxel whose recording follows the run least, if several are fitted.
void draw_worst(WindowUi& ui, const std::vector<TaxelFit>& fits, const Layout& layout) {
  const TaxelFit* worst = nullptr;
  int fitted = 0;
  for (const TaxelFit& fit : fits) {
    if (!fit.refused.empty()) continue;
    ++fitted;
    if (worst == nullptr || fit.r2 < worst->r2) worst = &fit;
  }
  if (fitted < 2) return;
  const std::string text =
      fmt::format("Lowest R\u00b2: {}, taxel {}", with_decimals(worst->r2, 3), taxel_with_name(layout, worst->taxel));
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ui.widgets.note_item(text);
}

/// Draws the gains, per displayed unit of the readings.
void draw_fits(WindowUi& ui, const RealShown& real, const Layout& layout) {
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
  if (real.fits.empty()) return;
  const ReadingUnit unit = shown_unit(layout.readout.aggregate);
  const std::string of_values = real.unit.empty() ? "units of the recording" : real.unit;
  const std::string relation = fitted_relation(of_values, unit);
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("%s", relation.c_str());
  ImGui::PopTextWrapPos();
  ui.widgets.note_item(relation);
  draw_worst(ui, real.fits, layout);
  constexpr std::array heads{"Taxel", "Gain", "Offset", "R\u00b2", "RMS"};
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  if (!ImGui::BeginTable("fits", static_cast<int>(heads.size()), kFlags)) return ImGui::PopFont();
  for (std::size_t i = 0; i < heads.size(); ++i)
    ImGui::TableSetupColumn(heads[i], i == 0 ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableHeadersRow();
  for (const TaxelFit& fit : real.fits) draw_fit(fit, layout, unit);
  ImGui::EndTable();
  ImGui::PopFont();
  for (const TaxelFit& fit : real.fits)
    if (!fit.refused.empty()) caption(fmt::format("taxel {} {}", fit.taxel, fit.refused).c_str());
}

void draw_apply(WindowUi& ui, const DocumentView& document, const RealShown& real) {
  if (real.fits.empty()) return;
  ImGui::BeginDisabled(!document.editing.project);
  if (button(ui, "Apply as calibration")) ui.post(ActOnReal{RealTask::apply});
  ImGui::EndDisabled();
  tooltip("The gains, and offsets as tares, become the layout's calibration: an edit that can be undone");
  if (button(ui, "Export fit (CSV)...")) ui.post(ExportFile{FileTask::export_fits});
  tooltip("Write gain, offset, R\u00b2 and RMS of each taxel as a table");
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

void draw_real_panel(WindowUi& ui, const Shown& shown, RealState& real, bool& open) {
  if (std::exchange(real.comes_to_front, false)) ImGui::SetNextWindowFocus();
  if (begin_panel(ui, kReal.title, &open)) {
    if (!real.shown) {
      draw_no_recording(ui);
      return ImGui::End();
    }
    draw_what(ui, *real.shown);
    draw_steps(ui, real);
    draw_apply(ui, shown.document, *real.shown);
    if (!real.shown->fits.empty()) draw_fits(ui, *real.shown, layout_of_real(shown.run, *real.shown));
  }
  ImGui::End();
}

void align_at_end(App& app) {
  const RealShownPtr& shown = app.get<RealState>().shown;
  if (shown && shown->awaits_end && is_over(app.shown->run)) app.ui->post(ActOnReal{RealTask::align_at_end});
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

std::vector<Binding> real_commands() {
  return {{.command = ExportFile{FileTask::export_fits},
           .label = "Export fit of real recording (CSV)...",
           .enabled = has_fits,
           .menu = "File/Export",
           .needs = "Fit the gains of a real recording first, in the panel Real"}};
}

}  // namespace

bool is_over(const RunView& run) {
  if (!run.frame || !run.frame->trace || run.frame->trace->rows.empty()) return false;
  const SimScene& scene = *run.frame->scene;
  return run.frame->finished || (scene.duration > 0 && run.frame->trace->rows.back().time >= scene.duration);
}

bool has_fits(const App& app) {
  const RealShownPtr& shown = app.get<RealState>().shown;
  return shown && !shown->fits.empty();
}

std::string table_of_fits(const App& app) {
  const RealShown& real = *app.get<RealState>().shown;
  const Layout layout = layout_of_real(app.shown->run, real);
  return fits_csv(real.fits, real.mapping, reading_unit(layout.readout.aggregate), real.shift);
}

constinit const Feature kReal{
    .title = "Real",
    .dock = Dock::inspector,
    .opens = Opens::for_once,
    .label = "Real",
    .context = kSimulate,
    .draw = [](App& app) { draw_real_panel(*app.ui, *app.shown, app.get<RealState>(), app.get<PanelsShown>()[kReal]); },
    .parts = real_parts,
    .guide = "Compare with a real recording",
    .analyse = {.tab = 6, .question = "Does the real sensor read the same?"},
    .update = align_at_end,
    .draw_card = [](App& app) { draw_real_dialog(*app.ui, *app.viewer, *app.shown, app.get<RealState>()); },
    .commands = real_commands,
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
  constexpr const char *kUnitTip =
                           "Unit of the values after gain and offset, such as kPa or V: a name only, nothing is "
                           "converted",
                       *kGainTip = "value = gain * number in the table + offset, such as 0.001 for mV shown in V",
                       *kOffsetTip = "Added after the gain, in the unit of the values";
  begin_property("Unit", kUnitTip);
  if (const auto typed = text_field(ui, "Unit of values", {m.unit})) m.unit = *typed;
  tooltip(kUnitTip);
  begin_property("Gain", kGainTip);
  if (const auto typed = number_field(ui, "Gain of values", {m.gain}, {"", 0, -1})) m.gain = *typed;
  tooltip(kGainTip);
  begin_property("Offset", kOffsetTip);
  if (const auto typed = number_field(ui, "Offset of values", {m.offset}, {"", 0, -1})) m.offset = *typed;
  tooltip(kOffsetTip);
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

}  // namespace taxel::ui
