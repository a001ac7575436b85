// The window with all keys and mouse gestures, and a field that searches them.
#include "app/studio/nouns/menus/menus_state.h"

#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/keymap.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

constexpr const char* kHelpTitle = "Keys and mouse";

std::string in_lower_case(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

/// Returns whether a word of `text` begins with `start`. Keys such as "=" and "[" need not begin a word.
bool begins_a_word(const std::string& text, const std::string& start) {
  const bool is_sign = std::isalnum(static_cast<unsigned char>(start[0])) == 0;
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1))
    if (is_sign || at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0) return true;
  return false;
}

bool matches(const HelpRow& row, const std::string& typed) {
  const std::string all =
      in_lower_case(row.keys + "  " + row.label + "  " + row.where + "  " + std::string(synonyms_of(row.label)));
  std::istringstream words(typed);
  for (std::string word; words >> word;)
    if (!begins_a_word(all, word)) return false;
  return true;
}

void draw_row(const HelpRow& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", row.keys.c_str());
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", row.label.c_str());
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", row.where.c_str());
}

void draw_rows(WindowUi& ui, const std::vector<HelpRow>& rows) {
  if (rows.empty()) ImGui::TextDisabled("No key or gesture for this. Ctrl+K searches all commands.");
  if (!ImGui::BeginTable("keys", 3, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, 0.28f);
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch, 0.54f);
  ImGui::TableSetupColumn("where", ImGuiTableColumnFlags_WidthStretch, 0.18f);
  for (const HelpRow& row : rows) {
    draw_row(row);
    ui.widgets.note_item(row.label);
  }
  ImGui::EndTable();
}

void draw_help(WindowUi& ui, PanelsShown& panels, HelpState& help) {
  if (!panels[kHelp]) {
    help.typed.clear();
    return;
  }
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(viewport->GetCenter(), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(36 * ImGui::GetFontSize(), 0.8f * viewport->Size.y), ImGuiCond_Appearing);
  constexpr auto kFlags = ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNavInputs |
                          ImGuiWindowFlags_NoCollapse;
  if (ImGui::Begin(kHelpTitle, &panels[kHelp], kFlags)) {
    ui.widgets.note_item(kHelpTitle);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "Search keys and gestures", &help.typed);
    ui.widgets.note_item("Search help");
    // The field has the keyboard, so that these keys do not reach the keymap.
    if (ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGuiKey_F1, false)) panels[kHelp] = false;
    if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) panels[kHelp] = false;
    if (ImGui::BeginChild("rows")) draw_rows(ui, find_help(help.typed, ui.key_names));
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace

std::vector<HelpRow> find_help(std::string_view typed, const KeyNames& names) {
  std::vector<HelpRow> rows;
  for (const Gesture& g : gestures()) rows.push_back({g.gesture, to_string(g.context), g.label});
  for (const Binding& b : bindings())
    if (b.chord != 0) rows.push_back({chord_names(b, names), to_string(b.context), b.label});
  const std::string text = in_lower_case(typed);
  std::erase_if(rows, [&](const HelpRow& row) { return !matches(row, text); });
  return rows;
}

constinit const Feature kHelp{
    .title = "Keys and mouse",
    .opens = Opens::for_once,
    .draw_card = [](App& app) { draw_help(*app.ui, app.get<PanelsShown>(), app.get<HelpState>()); },
    .tool = {"help", kEverywhere, nullptr, 6, [](const App& app) { return app.get<PanelsShown>()[kHelp]; },
             [](App& app) { app.get<PanelsShown>()[kHelp] = false; }},
};

}  // namespace taxel::ui
