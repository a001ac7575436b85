#include "app/studio/nouns/demo/demo_caption.h"

#include <imgui.h>

#include "app/studio/host/document/documents.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/probe/probe_tool.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

constexpr const char* kTouchTheFinger = "Press X and touch the finger";
constexpr const char* kShowTheJump = "Show the jumping taxel";

/// Draws a ball that touches a skin, as the probe does.
void draw_ball(const Palette& colors, float size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = 0.36f * size, y = at.y + 0.5f * ImGui::GetFrameHeight();
  const ImVec2 center(at.x + 0.5f * size, y - 0.1f * size);
  list.AddLine({at.x, center.y + radius}, {at.x + size, center.y + radius}, to_u32(colors.dim), 2);
  list.AddCircleFilled(center, radius, to_u32(colors.accent));
  list.AddCircleFilled({center.x - 0.3f * radius, center.y - 0.3f * radius}, 0.3f * radius,
                       IM_COL32(255, 255, 255, 170));
  ImGui::Dummy({size, ImGui::GetFrameHeight()});
}

}  // namespace

void draw_demo_caption(WindowUi& ui, const Viewer& viewer, DemoState& demo) {
  if (viewer.mode != Mode::simulate) demo.invites = false;
  if (!demo.invites || viewer.view.rect.empty()) return;
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize();
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                          ImGuiWindowFlags_NoNavInputs;
  ImGui::SetNextWindowPos({viewer.view.rect.center_x(), viewer.view.rect.y1 - 0.8f * line}, ImGuiCond_Always,
                          {0.5f, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.raised);
  if (ImGui::Begin("Demo", nullptr, kFlags)) {
    draw_ball(colors, 1.4f * line);
    ImGui::SameLine();
    if (small_choice(ui, kTouchTheFinger, true)) {
      ui.post(ProbeInLayout{});
      demo.invites = false;
    }
    ImGui::SameLine();
    if (button(ui, kShowTheJump)) {
      ui.post(OpenExample{std::string(studio::kJumpingTaxel)});
      demo.invites = false;
    }
    ImGui::SameLine();
    if (button(ui, "Close")) demo.invites = false;
    tooltip("Help > Examples and Help > Tour show more");
  }
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace taxel::ui
