// The settings of a video and the popup with its progress.
#include "app/studio/nouns/video/video_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
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
  ImGui::ProgressBar(done, ImVec2(16 * ImGui::GetFontSize(), 0));
  if (button(ui, "Cancel video", ImVec2(-1, 0))) ui.post(CancelVideo{});
  ImGui::End();
  ImGui::PopStyleColor(2);
}

}  // namespace

void draw_video_settings(WindowUi& ui, VideoState& video, std::string& path) {
  using studio::format_of, studio::with_format;
  constexpr std::array<std::string_view, 3> kFormats{"MP4", "GIF", "PNG frames"};
  constexpr std::array<std::string_view, 4> kSizes{"As the view", "1280 x 720", "1920 x 1080", "Custom"};
  const auto format = static_cast<std::size_t>(format_of(path)), size = static_cast<std::size_t>(video.size);
  if (const auto made = short_choice(ui, "Format", kFormats, format))
    path = with_format(path, static_cast<VideoFormat>(*made));
  tooltip("MP4 and GIF need ffmpeg. PNG frames go into a folder.");
  ImGui::BeginDisabled(video.window);
  ImGui::SameLine();
  if (const auto made = short_choice(ui, "Size", kSizes, size)) video.size = static_cast<VideoSize>(*made);
  tooltip(video.window ? "The whole window is recorded in its own size." : "Width x height in pixels");
  if (video.size == VideoSize::custom) {
    ImGui::SameLine();
    whole_number(ui, "Video width", &video.width, kMostSide, "Width in pixels");
    ImGui::SameLine();
    whole_number(ui, "Video height", &video.height, kMostSide, "Height in pixels");
  }
  ImGui::EndDisabled();
  whole_number(ui, "Frame every N steps", &video.every, kMostEvery, "Number of steps between two frames");
  ImGui::SameLine();
  whole_number(ui, "Frame rate (fps)", &video.rate, kMostRate, "Frames per second of the video");
  ImGui::SameLine();
  checkbox(ui, "Whole window", &video.window);
  tooltip("Record the whole window instead of the 3-D view");
  ImGui::BeginDisabled(video.window);
  checkbox(ui, "Time and legend", &video.annotated);
  tooltip("Draw the time of each step and the pressure legend into the video");
  ImGui::SameLine();
  checkbox(ui, "Turn around the contact", &video.orbit);
  tooltip("Turn the camera once around the contact during the video");
  ImGui::EndDisabled();
  const std::uint64_t last = video.source.steps > 0 ? video.source.steps - 1 : 0;
  const std::string text = studio::plan_text(studio::plan_video(path, {0, last}, video));
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text.c_str());
  ui.widgets.note_item("Video: " + text);
}

constinit const Feature kVideo{
    .draw_card = [](App& app) { draw_video_card(*app.ui, app.viewer->view, app.get<VideoState>()); },
    .tool = {"video", kEverywhere, nullptr, 1, [](const App& app) { return app.get<VideoState>().progress.active; },
             [](App& app) { app.ui->post(CancelVideo{}); }},
    .dump = dump_video,
};

}  // namespace taxel::ui
