#include "app/studio/nouns/view/scene_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/selection.h"
#include "app/studio/frame/view_drawing.h"
#include "app/studio/nouns/camera/camera_follow.h"
#include "app/studio/nouns/view/scene_info.h"
#include "ui/scene/scene_input.h"
#include "ui/scene/scene_places.h"
#include "ui/theme.h"

namespace taxel::ui {

namespace {

constexpr float kWideView = 36;  // width with room for two texts next to each other, in heights of text
constexpr float kBackground = 0.88f;

/// Returns the name of a kind, such as "sites", with a note if the scene has none of the kind.
std::string kind_text(const char* kind, bool none) {
  return none ? fmt::format("{} (none)", kind) : kind;
}

std::string frames_text(const Overlays& overlays, const ViewShown& view) {
  const FramesShown frames = overlays.frames;
  return frames == FramesShown::none ? "" : "Frames: " + kind_text(to_word(frames), shown_frames(view.input).empty());
}

std::string labels_text(const Overlays& overlays, const ViewShown& view) {
  const LabelsShown labels = overlays.labels;
  return labels == LabelsShown::none ? ""
                                     : "Labels: " + kind_text(to_word(labels), labelled_places(view.input).empty());
}

std::string body_text(const Selection& selection, const RunView& run) {
  const std::vector<SceneBody>& bodies = run.frame->scene->controls.bodies;
  const auto body = static_cast<std::size_t>(selection.body);
  return selection.body >= 0 && body < bodies.size() ? "Body: " + bodies[body].name : "";
}

/// Returns the height of a row whose value wraps at `width`.
float height_of(const InfoRow& row, float width) {
  return ImGui::CalcTextSize(row.value.c_str(), nullptr, false, width).y + ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace

int draw_scene_overlay(const WindowUi& ui, const Viewer& viewer, const RunView& run, const FollowState& follow,
                       const ViewShown& view, int row) {
  if (viewer.mode != Mode::simulate || !run.frame || !run.frame->scene) return row;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.dark);
  std::string frames = frames_text(viewer.overlays(), view), labels = labels_text(viewer.overlays(), view);
  if (viewer.view.rect.width() > kWideView * ImGui::GetFontSize() && !frames.empty() && !labels.empty())
    frames += "   " + std::exchange(labels, "");
  for (const std::string& text : {follow_text(viewer, run, follow), body_text(viewer.selection, run), frames, labels})
    if (!text.empty()) draw_view_line(ui, viewer.view, list, row++, text, colors.text);
  return row;
}

void draw_info_card(WindowUi& ui, const Viewer& viewer, const RunView& run, const PanelsShown& panels, int row) {
  if (!panels[kInfo] || viewer.mode != Mode::simulate) return;
  const std::vector<InfoRow> rows = scene_info(run);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const float line = ImGui::GetFontSize(), pad = 0.5f * line, margin = 0.6f * line;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0.25f * line});
  float name = 0, value = 0, height = 2 * pad;
  for (const InfoRow& r : rows) {
    name = std::max(name, ImGui::CalcTextSize(r.name.c_str()).x);
    value = std::max(value, ImGui::CalcTextSize(r.value.c_str()).x);
  }
  name += line;
  value = std::min(value + 1, viewer.view.rect.width() - name - 2 * (pad + margin) - ImGui::GetStyle().ScrollbarSize);
  for (const InfoRow& r : rows) height += height_of(r, value);
  const float top = view_line_top(viewer.view, row) + 0.2f * line, room = viewer.view.rect.y1 - margin - top;
  const bool scrolls = height > room;
  ImGui::SetNextWindowPos({viewer.view.rect.x0 + viewer.view.strip + margin, top});
  ImGui::SetNextWindowSize(
      {name + value + 2 * pad + (scrolls ? ImGui::GetStyle().ScrollbarSize : 0), std::min(height, room)});
  ImGui::SetNextWindowBgAlpha(kBackground);
  constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
  if (ImGui::Begin("Info", nullptr, scrolls ? kFlags : kFlags | ImGuiWindowFlags_NoInputs)) {
    ui.widgets.note_item("Info");
    for (const InfoRow& r : rows) {
      ImGui::TextDisabled("%s", r.name.c_str());
      ImGui::SameLine(pad + name);
      ImGui::PushTextWrapPos(pad + name + value);
      ImGui::TextUnformatted(r.value.c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

constinit const Feature kInfo{
    .opens = Opens::by_user,
    .key = "info",
    .dump = dump_view,
};

}  // namespace taxel::ui
