#include "app/studio/nouns/real/real_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/real/real_commands.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

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
    begin_property("Shift", "Added to its times, so that they are the run's");
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
  ImGui::SameLine();
  checkbox(ui, "With offset", &real.options.offset);
}

constexpr std::array<std::pair<const char*, float>, 5> kFitColumns{
    {{"Taxel", 0.16f}, {"Gain", 0.24f}, {"Offset", 0.2f}, {"R^2", 0.18f}, {"RMS residual", 0.22f}}};

void draw_fits(const RealShown& real) {
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
  if (real.fits.empty() || !ImGui::BeginTable("fits", 5, kFlags)) return;
  for (const auto& [head, width] : kFitColumns)
    ImGui::TableSetupColumn(head, ImGuiTableColumnFlags_WidthStretch, width);
  ImGui::TableHeadersRow();
  for (const TaxelFit& fit : real.fits) {
    ImGui::TableNextRow();
    const auto cell = [](const std::string& text) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(text.c_str());
    };
    cell(fmt::format("{}", fit.taxel));
    if (!fit.refused.empty()) {
      cell("-");
      continue;
    }
    cell(fmt::format("{:.3g}", fit.gain));
    cell(fmt::format("{:.3g}", fit.offset));
    cell(fmt::format("{:.3f}", fit.r2));
    cell(fmt::format("{:.2g}", fit.residual));
    tooltip("Root mean square of recording - (gain * reading + offset)");
  }
  ImGui::EndTable();
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

void draw_real_panel(WindowUi& ui, const Viewer& viewer, const DocumentView& document, RealState& real) {
  if (!real.shown || viewer.mode != Mode::simulate) return;
  const ImGuiWindow* before = ImGui::FindWindowByName(kReal.title);
  if (before == nullptr || !before->WasActive) ImGui::SetNextWindowFocus();  // the panel opens by itself
  bool open = true;
  if (begin_panel(ui, kReal.title, &open)) {
    draw_what(ui, *real.shown);
    draw_steps(ui, real);
    draw_fits(*real.shown);
    draw_apply(ui, document, real, *real.shown);
  }
  ImGui::End();
  if (!open) ui.post(ActOnReal{RealTask::remove});
}

}  // namespace

constinit const Feature kReal{
    .title = "Real recording",
    .dock = Dock::inspector,
    .draw = [](App& app) { draw_real_panel(*app.ui, *app.viewer, app.shown->document, app.get<RealState>()); },
    .draw_card = [](App& app) { draw_real_dialog(*app.ui, *app.viewer, *app.shown, app.get<RealState>()); },
    .dump = dump_real,
};

}  // namespace taxel::ui
