#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/data_set/data_set.h"
#include "app/studio/nouns/data_set/data_set_commands.h"
#include "app/studio/nouns/data_set/data_set_job.h"
#include "app/studio/nouns/data_set/data_set_state.h"
#include "app/studio/nouns/data_set/episode_plots.h"
#include "app/studio/nouns/data_set/episode_table.h"
#include "app/studio/nouns/data_set/replay.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

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
