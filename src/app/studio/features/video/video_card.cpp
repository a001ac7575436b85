#include "app/studio/features/video/video_card.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

constexpr int kMostEvery = 1'000'000, kMostRate = 240;

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

}  // namespace

void draw_video_settings(WindowUi& ui, VideoState& video) {
  whole_number(ui, "Frame every N steps", &video.every, kMostEvery, "Number of steps between two frames");
  ImGui::SameLine();
  whole_number(ui, "Frame rate (fps)", &video.rate, kMostRate, "Frames per second of the video");
  ImGui::SameLine();
  checkbox(ui, "Whole window", &video.window);
  tooltip("Record the whole window instead of the 3-D view");
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
  const std::string text =
      video.encoding ? "Encoding the video" : fmt::format("Frame {} of {}", video.done, video.total);
  ImGui::TextUnformatted(text.c_str());
  const float done = video.total > 0 ? static_cast<float>(video.done) / static_cast<float>(video.total) : 0.0f;
  ImGui::ProgressBar(done, ImVec2(16 * ImGui::GetFontSize(), 0));
  if (button(ui, "Cancel video", ImVec2(-1, 0))) ui.post(CancelVideo{});
  ImGui::End();
  ImGui::PopStyleColor(2);
}

}  // namespace taxel::ui
