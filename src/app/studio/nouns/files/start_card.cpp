#include "app/studio/nouns/files/start_card.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/file_dialog_tool.h"
#include "core/mesh/formats/mesh_format.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

// Lengths in heights of text.
constexpr float kWidestTile = 15, kNarrowestTile = 9.5f, kTileGap = 0.7f;
constexpr float kRoomForTexts = 13;  // of the card's height, without pictures and recent files

/// Draws a picture with its label below, as one button.
void draw_tile(WindowUi& ui, const ExampleTile& tile, float width) {
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize(), height = width / tile.aspect;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(tile.label.c_str(), {width, height + 1.5f * line})) ui.post(OpenExample{tile.name});
  ui.widgets.note_item(tile.label);
  const bool hovered = ImGui::IsItemHovered();
  tooltip(tile.tip);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, to_u32(colors.field), 4);
  list.AddImageRounded(ImTextureRef(static_cast<ImTextureID>(tile.picture)), at, {at.x + width, at.y + height}, {0, 0},
                       {1, 1}, IM_COL32_WHITE, 4);
  list.AddRect(at, {at.x + width, at.y + height}, to_u32(hovered ? colors.accent : colors.dim), 4,
               hovered ? 2.0f : 1.0f);
  list.AddText({at.x, at.y + height + 0.25f * line}, to_u32(hovered ? colors.accent : colors.text), tile.label.c_str());
}

/// Returns the width of a tile: two stand in a row, and two rows fit with the texts into the view's height.
float tile_width(const ViewPlace& place, const std::vector<ExampleTile>& examples, float taken) {
  const float line = ImGui::GetFontSize();
  const float by_width = 0.5f * (place.rect.width() - 5 * line);
  const float by_height = 0.5f * (place.rect.height() - taken * line) * examples.front().aspect;
  return std::clamp(std::min(by_width, by_height), kNarrowestTile * line, kWidestTile * line);
}

/// Returns the kinds of files that can be dropped, in lines of at most `room` pixels. Each kind stays whole: ImGui
/// would break ".npz" after its dot.
std::string formats_in_lines(float room) {
  std::string text, last_line;
  const auto add = [&](std::string_view kind) {
    const std::string longer = last_line.empty() ? std::string(kind) : last_line + "  " + std::string(kind);
    const bool fits = last_line.empty() || ImGui::CalcTextSize(longer.c_str()).x <= room;
    if (!fits) text += last_line + "\n";
    last_line = fits ? longer : std::string(kind);
  };
  for (const MeshFormat& format : kMeshFormats)
    if (can_read(format)) add(format.name);
  for (const char* kind : {".taxels.json", ".yaml", ".csv", ".urdf", ".npz", ".txt", ".taxelproj", "MuJoCo XML"})
    add(kind);
  return text + last_line;
}

void draw_invitation(WindowUi& ui, FileDialog& dialog, float room) {
  ImGui::PushFont(nullptr, 1.3f * kTextHeight);
  ImGui::TextUnformatted("Drop a mesh or a layout here");
  ImGui::PopFont();
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).dim);
  ImGui::TextUnformatted(formats_in_lines(room).c_str());
  ImGui::PopStyleColor();
  ImGui::Spacing();
  if (button(ui, "Open##start", ImVec2(9 * ImGui::GetFontSize(), 0))) open_dialog(ui, dialog);
}

}  // namespace

void draw_start_card(WindowUi& ui, const ViewPlace& place, const std::vector<ExampleTile>& examples, FileDialog& dialog,
                     const std::vector<std::string>& recent) {
  const float line = ImGui::GetFontSize();
  const std::size_t shown = std::min<std::size_t>(recent.size(), 5);
  const float taken = kRoomForTexts + (shown > 0 ? 1.6f * static_cast<float>(shown + 1) : 0);
  const float width = examples.empty() ? kWidestTile * line : tile_width(place, examples, taken);
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  const float height = taken * line + (examples.empty() ? 0 : 2 * width / examples.front().aspect);
  const bool fits = height < place.rect.height();  // otherwise it covers panels below the view, not the toolbar above
  ImGui::SetNextWindowPos({place.rect.center_x(), fits ? place.rect.center_y() : place.rect.y0 + 4}, ImGuiCond_Always,
                          ImVec2(0.5f, fits ? 0.5f : 0.0f));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).raised);
  ImGui::PushStyleColor(ImGuiCol_Button, palette(ui.dark).panel);  // the usual button colour equals the popup's
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(1.3f * line, 1.1f * line));
  ImGui::Begin("Start", nullptr, kFlags);
  const float room = 2 * width + kTileGap * line;
  ImGui::PushTextWrapPos(1.3f * line + room);
  draw_invitation(ui, dialog, room);
  ImGui::Spacing();
  if (!examples.empty()) ImGui::TextDisabled("Examples");
  for (std::size_t i = 0; i < examples.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine(0, kTileGap * line);
    draw_tile(ui, examples[i], width);
  }
  if (shown > 0) {
    ImGui::Spacing();
    ImGui::TextDisabled("Recent");
    for (std::size_t i = 0; i < shown; ++i) {
      if (selectable(ui, recent[i].c_str(), false)) ui.post(OpenFile{recent[i]});
    }
  }
  ImGui::PopTextWrapPos();
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
}

}  // namespace taxel::ui
