// The settings of a video and the popup with its progress.
#include "app/studio/nouns/video/video_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>
#include <string_view>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/video/video_maker.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {

namespace {

constexpr int kMostEvery = 1'000'000, kMostRate = 240, kMostSide = 100'000;

void whole_number(WindowUi& ui, const char* label, int* value, int most, const char* tip) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", label);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(4 * ImGui::GetFontSize());
  ImGui::InputInt((std::string("##") + label).c_str(), value, 0);
  ui.widgets.note_item(label);
  tooltip(tip);
  *value = std::clamp(*value, 1, most);
}

/// Draws a field for one of a few choices, with its name before it. Returns the index of the user's new choice.
std::optional<std::size_t> short_choice(WindowUi& ui, const char* name, std::span<const std::string_view> choices,
                                        std::size_t chosen) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine();
  return choice_of(ui, name, choices, chosen, 8 * ImGui::GetFontSize());
}

/// Draws a field for a time, with its name before it.
void time_field(WindowUi& ui, const char* label, double* seconds, const char* tip) {
  ImGui::SameLine();
  ImGui::TextDisabled("%s", label);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(4.5f * ImGui::GetFontSize());
  ImGui::InputDouble((std::string("##") + label).c_str(), seconds, 0, 0, "%.6g");
  ui.widgets.note_item(label);
  tooltip(tip);
}

/// Draws the choice of the steps, and the fields of a period, which is the whole run at first.
void draw_steps(WindowUi& ui, VideoState& video) {
  constexpr std::array<std::string_view, 3> kSteps{"With contact", "All", "From ... to"};
  if (const auto made = short_choice(ui, "Steps", kSteps, static_cast<std::size_t>(video.steps))) {
    const bool is_first = video.from == 0 && video.to == 0;
    if (static_cast<VideoSteps>(*made) == VideoSteps::period && is_first)
      video.from = video.source.begin, video.to = video.source.end;
    video.steps = static_cast<VideoSteps>(*made);
  }
  tooltip(
      "With contact: from 0.1 s before the first touch to 0.1 s after the last one. From ... to: the seconds of the "
      "run that you type. A loop limits all choices.");
  if (video.steps == VideoSteps::period) {
    time_field(ui, "From (s)", &video.from, "Time of the run at which the video begins");
    time_field(ui, "To (s)", &video.to, "Time of the run at which the video ends");
  }
}

/// A format as the user sees it.
struct FormatChoice {
  VideoFormat format;
  const char *name, *missing;  ///< name, and name with the reason if ffmpeg, which makes the format, is missing
};
constexpr std::array kFormatChoices{
    FormatChoice{VideoFormat::webp, "WebP", nullptr},
    FormatChoice{VideoFormat::mp4, "MP4", "MP4: ffmpeg is not installed"},
    FormatChoice{VideoFormat::gif, "GIF", "GIF: ffmpeg is not installed"},
    FormatChoice{VideoFormat::png, "PNG frames", nullptr},
};

/// Draws the field for the format. Formats that cannot be made say why. Returns the user's new choice.
std::optional<VideoFormat> choose_format(WindowUi& ui, VideoFormat chosen, bool has_encoder) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Format");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(8 * ImGui::GetFontSize());
  if (!ImGui::BeginCombo("##Format", kFormatChoices[static_cast<std::size_t>(chosen)].name)) {
    ui.widgets.note_item("Format");
    tooltip(
        "WebP: a film that every browser plays, made without other programs. MP4 and GIF need ffmpeg. PNG frames go "
        "into a folder.");
    return std::nullopt;
  }
  std::optional<VideoFormat> made;
  for (const FormatChoice& choice : kFormatChoices) {
    const bool is_missing = choice.missing != nullptr && !has_encoder;
    const char* const label = is_missing ? choice.missing : choice.name;
    if (selectable(ui, label, choice.format == chosen, is_missing ? ImGuiSelectableFlags_Disabled : 0))
      made = choice.format;
  }
  ImGui::EndCombo();
  return made;
}

void draw_video_card(WindowUi& ui, const ViewPlace& place, const VideoState& video_state) {
  const VideoProgress& video = video_state.progress;
  if (!video.active || video_state.window) return;  // the popup would be in the video
  ImGui::SetNextWindowPos({place.rect.center_x(), place.rect.y0 + 2 * ImGui::GetFontSize()}, ImGuiCond_Always,
                          ImVec2(0.5f, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).raised);
  ImGui::PushStyleColor(ImGuiCol_Button, palette(ui.dark).panel);
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::Begin("Video", nullptr, kFlags);
  const std::string text = video.checking   ? "Trying the encoder"
                           : video.encoding ? "Encoding the video"
                                            : fmt::format("Frame {} of {}", video.done, video.total);
  ImGui::TextUnformatted(text.c_str());
  const float done = video.total > 0 ? static_cast<float>(video.done) / static_cast<float>(video.total) : 0.0f;
  progress_bar(ui, done, 16 * ImGui::GetFontSize());
  if (button(ui, "Cancel video", ImVec2(-1, 0))) ui.post(CancelVideo{});
  ImGui::End();
  ImGui::PopStyleColor(2);
}

/// Draws the line that says which video would be made, or `why_not`.
void draw_plan(WindowUi& ui, const VideoState& video, const std::string& path, const std::string& why_not) {
  std::string text =
      why_not.empty() ? studio::plan_text(studio::plan_video(path, studio::chosen_steps(video), video)) : why_not;
  if (why_not.empty() && video.steps == VideoSteps::contact && !video.source.contact) text += "; no contact: all steps";
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  ImGui::AlignTextToFramePadding();
  const Palette& colors = palette(ui.dark);
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::TextColored(why_not.empty() ? colors.dim : colors.error, "%s", shortened(text, room, 1).c_str());
  ui.widgets.note_item("Video: " + text);
  if (ImGui::CalcTextSize(text.c_str()).x > room) tooltip(text);
}

}  // namespace

std::string draw_video_settings(WindowUi& ui, VideoState& video, std::string& path) {
  using studio::format_of, studio::with_format;
  constexpr std::array<std::string_view, 4> kSizes{"As the view", "1280 x 720", "1920 x 1080", "Custom"};
  if (const auto made = choose_format(ui, format_of(path), video.source.has_encoder)) path = with_format(path, *made);
  ImGui::BeginDisabled(video.window);
  ImGui::SameLine();
  if (const auto made = short_choice(ui, "Size", kSizes, static_cast<std::size_t>(video.size)))
    video.size = static_cast<VideoSize>(*made);
  tooltip(video.window ? "The whole window is recorded in its own size." : "Width x height in pixels");
  if (video.size == VideoSize::custom) {
    ImGui::SameLine();
    whole_number(ui, "Video width", &video.width, kMostSide, "Width in pixels");
    ImGui::SameLine();
    whole_number(ui, "Video height", &video.height, kMostSide, "Height in pixels");
  }
  ImGui::EndDisabled();
  draw_steps(ui, video);
  ImGui::SameLine();
  checkbox(ui, "Whole window", &video.window);
  tooltip("Record the whole window instead of the 3-D view");
  whole_number(ui, "Frame every N steps", &video.every, kMostEvery, "Number of steps between two frames");
  ImGui::SameLine();
  whole_number(ui, "Frame rate (fps)", &video.rate, kMostRate, "Frames per second of the video");
  ImGui::BeginDisabled(video.window);
  checkbox(ui, "Time, force and legend", &video.annotated);
  tooltip("Draw the time and the contact force of each step, and the legend of both ranges, into the video");
  ImGui::SameLine();
  checkbox(ui, "Bars of readings", &video.bars);
  tooltip("Draw the readings of the taxels as bars into the video");
  ImGui::SameLine();
  checkbox(ui, "Turn around the contact", &video.orbit);
  tooltip("Turn the camera once around the contact during the video");
  ImGui::EndDisabled();
  const std::string why_not = studio::why_no_video(video, path);
  draw_plan(ui, video, path, why_not);
  return why_not;
}

constinit const Feature kVideo{
    .draw_card = [](App& app) { draw_video_card(*app.ui, app.viewer->view, app.get<VideoState>()); },
    .tool = {"video", kEverywhere, nullptr, 1, [](const App& app) { return app.get<VideoState>().progress.active; },
             [](App& app) { app.ui->post(CancelVideo{}); }},
    .dump = dump_video,
};

}  // namespace taxel::ui
