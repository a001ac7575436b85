// The window with the user guide, and the buttons that open it at the section about a panel.
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/guide/guide_state.h"
#include "app/studio/nouns/guide/guide_text.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"

namespace taxel::ui {
namespace {

/// Scrolls to a heading. Tables have their final heights only after a few frames.
void show_heading(GuideState& guide, const std::string& heading) {
  constexpr int kFramesOfTables = 4;
  guide.sought = heading;
  guide.frames = kFramesOfTables;
}

void draw_guide_heading(const WindowUi& ui, GuideState& guide, const GuideBlock& block) {
  constexpr float kLarge = 1.5f, kMiddle = 1.25f, kLow = 1.1f;
  ImGui::Dummy({0, 0.4f * ImGui::GetFontSize()});
  if (guide.frames > 0 && block.text == guide.sought) ImGui::SetScrollHereY(0);
  constexpr float kAtTop = 2.2f;  // heights of text below the upper edge
  if (ImGui::GetCursorPosY() <= ImGui::GetScrollY() + kAtTop * ImGui::GetFontSize()) guide.section = block.text;
  ImGui::PushFont(nullptr, kTextHeight * (block.level == 1 ? kLarge : block.level == 2 ? kMiddle : kLow));
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).accent);
  ImGui::TextWrapped("%s", block.text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void draw_guide_table(const GuideBlock& block, int number) {
  const auto columns = static_cast<int>(block.rows.front().size());
  constexpr auto kFlags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_RowBg;
  if (columns == 0 || !ImGui::BeginTable(("table" + std::to_string(number)).c_str(), columns, kFlags)) return;
  // Columns of long texts are wide, but not so wide that short ones are cut.
  constexpr std::size_t kShort = 18, kLong = 60;
  for (std::size_t i = 0; i < block.rows.front().size(); ++i) {
    std::size_t longest = kShort;
    for (const auto& row : block.rows)
      if (i < row.size()) longest = std::max(longest, std::min(kLong, row[i].size()));
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, static_cast<float>(longest));
  }
  for (std::size_t r = 0; r < block.rows.size(); ++r) {
    const auto& cells = block.rows[r];
    if (std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); })) continue;
    ImGui::TableNextRow();
    for (const std::string& cell : block.rows[r]) {
      if (!ImGui::TableNextColumn()) continue;
      if (r == 0) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
      ImGui::TextWrapped("%s", cell.c_str());
      if (r == 0) ImGui::PopStyleColor();
    }
  }
  ImGui::EndTable();
}

/// Draws an item of a list. A numbered one begins with its number, and further lines begin below its text.
void draw_guide_item(const std::string& text) {
  const std::size_t end = text.find(". ");
  if (text.find_first_of("0123456789") == 0 && end != std::string::npos) {
    ImGui::Indent();
    ImGui::TextUnformatted(text.data(), text.data() + end + 1);
    ImGui::SameLine();
    ImGui::TextWrapped("%s", text.c_str() + end + 2);
    ImGui::Unindent();
  } else {
    ImGui::Bullet();
    ImGui::TextWrapped("%s", text.c_str());
  }
}

void draw_guide_block(const WindowUi& ui, GuideState& guide, const GuideBlock& block, int number) {
  switch (block.kind) {
    case GuideBlock::Kind::heading:
      return draw_guide_heading(ui, guide, block);
    case GuideBlock::Kind::table:
      return draw_guide_table(block, number);
    case GuideBlock::Kind::code:
      ImGui::Indent();
      ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).dim);
      ImGui::TextWrapped("%s", block.text.c_str());
      ImGui::PopStyleColor();
      ImGui::Unindent();
      return;
    case GuideBlock::Kind::item:
      return draw_guide_item(block.text);
    case GuideBlock::Kind::paragraph:
      ImGui::TextWrapped("%s", block.text.c_str());
      return;
  }
}

/// Draws the choice of the section, which follows the text.
void draw_guide_contents(WindowUi& ui, GuideState& guide) {
  const std::vector<std::string> headings = headings_of(user_guide());
  std::vector<std::string_view> choices(headings.begin(), headings.end());
  const auto at = std::find(choices.begin(), choices.end(), guide.section);
  const auto chosen = at == choices.end() ? 0 : static_cast<std::size_t>(at - choices.begin());
  if (const auto made = choice_of(ui, "Section of the guide", choices, chosen)) show_heading(guide, headings[*made]);
}

void draw_guide(WindowUi& ui, PanelsShown& panels, GuideState& guide) {
  if (!panels[kGuide]) return;
  constexpr float kWidth = 50, kPart = 0.86f;
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(viewport->GetCenter(), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(
      {std::min(kWidth * ImGui::GetFontSize(), 0.94f * viewport->Size.x), kPart * viewport->Size.y},
      ImGuiCond_Appearing);
  constexpr auto kFlags = ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;
  if (guide.frames > 0) ImGui::SetNextWindowFocus();
  if (ImGui::Begin(kGuide.title, &panels[kGuide], kFlags)) {
    ui.widgets.note_item(kGuide.title);
    draw_guide_contents(ui, guide);
    if (ImGui::BeginChild("page")) {
      if (guide.frames > 0) ImGui::SetWindowFocus();  // arrow keys scroll the text
      guide.section.clear();
      int number = 0;
      for (const GuideBlock& block : user_guide()) draw_guide_block(ui, guide, block, number++);
      // Room below, so that the last heading can be at the top.
      ImGui::Dummy({0, std::max(0.0f, ImGui::GetWindowHeight() - 8 * ImGui::GetFontSize())});
    }
    ImGui::EndChild();
    guide.frames = std::max(0, guide.frames - 1);
    if (is_left_by_escape(ui)) panels[kGuide] = false;
  }
  ImGui::End();
}

/// Returns whether the tabs of a place leave room for a button behind them, so that no title is cut for it.
bool has_room_for_button(const ImGuiDockNode& node) {
  if (node.TabBar == nullptr) return false;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  float width = ImGui::TabItemCalcSize("?", false).x;
  for (const ImGuiTabItem& tab : node.TabBar->Tabs)
    if ((tab.Flags & ImGuiTabItemFlags_Button) == 0) width += gap + tab.ContentWidth;
  return width <= node.TabBar->BarRect.GetWidth();
}

/// Returns the panel under the pointer that the guide has a section about, or null.
const Feature* hovered_panel() {
  const ImGuiContext* context = ImGui::GetCurrentContext();
  const ImGuiWindow* hovered = context != nullptr ? context->HoveredWindow : nullptr;
  if (hovered == nullptr) return nullptr;
  const std::string name = panel_name(hovered);
  for (const Feature* row : features())
    if (row->guide != nullptr && name == row->title) return row;
  return nullptr;
}

}  // namespace

void carry_out(const ShowGuide& command, App& app) {
  app.get<PanelsShown>()[kGuide] = true;
  show_heading(app.get<GuideState>(), command.heading);
}

void carry_out(const ShowGuideOfPanel&, App& app) {
  const Feature* panel = hovered_panel();
  carry_out(ShowGuide{panel != nullptr ? panel->guide : headings_of(user_guide()).front()}, app);
}

bool is_left_by_escape(const WindowUi& ui) {
  return !ui.fields.had_keys && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
         ImGui::IsKeyPressed(ImGuiKey_Escape, false);
}

void draw_guide_buttons(App& app) {
  for (const Feature* row : features()) {
    if (row->guide == nullptr) continue;
    const ImGuiWindow* window = ImGui::FindWindowByName(row->title);
    if (window == nullptr || !window->WasActive || !window->DockIsActive || window->DockNode == nullptr) continue;
    ImGuiDockNode* node = window->DockNode;
    if (node->VisibleWindow != window || node->IsNoTabBar() || node->IsHiddenTabBar()) continue;
    if (!has_room_for_button(*node) || !ImGui::DockNodeBeginAmendTabBar(node)) continue;
    if (ImGui::TabItemButton("?", ImGuiTabItemFlags_Trailing | ImGuiTabItemFlags_NoTooltip))
      carry_out(ShowGuide{row->guide}, app);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    app.ui->widgets.note(row->title, "?", {low.x, low.y, high.x, high.y});
    tooltip(std::string("Guide: ") + row->guide);
    ImGui::DockNodeEndAmendTabBar();
  }
}

constinit const Feature kGuide{
    .title = "User guide",
    .opens = Opens::for_once,
    .draw_card = [](App& app) { draw_guide(*app.ui, app.get<PanelsShown>(), app.get<GuideState>()); },
    .tool = {"guide", kEverywhere, nullptr, 7, [](const App& app) { return app.get<PanelsShown>()[kGuide]; },
             [](App& app) { app.get<PanelsShown>()[kGuide] = false; }},
    .dump = dump_guide,
};

}  // namespace taxel::ui
