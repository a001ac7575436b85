// The command palette, which finds commands, parts of panels, gestures and headings of the guide by typed words, and
// bodies of the running scene by the names of their parts.
#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/scene_filter.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/shell/menus/found.h"
#include "app/studio/shell/menus/menus.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

constexpr const char* kTitle = "Commands";
constexpr float kWidth = 42, kRows = 12, kFromTop = 0.14f;

void move_choice(PaletteState& palette, int count) {
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key) ? 1 : 0; };
  constexpr int kPage = 10;
  palette.chosen += pressed(ImGuiKey_DownArrow) - pressed(ImGuiKey_UpArrow) +
                    kPage * (pressed(ImGuiKey_PageDown) - pressed(ImGuiKey_PageUp));
  palette.chosen = std::clamp(palette.chosen, 0, std::max(0, count - 1));
}

/// Draws a text that ends with dots if it is wider than the room.
void draw_cut_text(const std::string& text, float room) {
  if (room <= 0) return;
  std::string shown = text;
  while (!shown.empty() && ImGui::CalcTextSize((shown + "...").c_str()).x > room) {
    shown.pop_back();
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xc0U) == 0x80U) shown.pop_back();
  }
  ImGui::TextUnformatted(ImGui::CalcTextSize(text.c_str()).x <= room ? text.c_str() : (shown + "...").c_str());
}

/// Draws one entry: its name, its place or the reason why it is not possible now, and its key. Returns whether it was
/// clicked.
bool draw_found(App& app, const Found& entry, std::size_t index, bool chosen) {
  const std::string why = why_not_now(entry, app);
  const SearchTexts& texts = entry.texts;
  const float gap = ImGui::GetFontSize(), right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  ImGui::BeginDisabled(!why.empty());
  const ImVec2 at = ImGui::GetCursorPos();
  const bool clicked = ImGui::Selectable(fmt::format("##entry{}", index).c_str(), chosen);
  app.ui->widgets.note_item(texts.name);
  tooltip(texts.help);
  if (chosen && (ImGui::IsKeyPressed(ImGuiKey_DownArrow) || ImGui::IsKeyPressed(ImGuiKey_UpArrow) ||
                 ImGui::IsKeyPressed(ImGuiKey_PageDown) || ImGui::IsKeyPressed(ImGuiKey_PageUp)))
    ImGui::SetScrollHereY();
  ImGui::SetCursorPos(at);
  const float keys = ImGui::CalcTextSize(texts.keys.c_str()).x;
  draw_cut_text(texts.name, right - at.x - (keys > 0 ? keys + gap : 0));
  ImGui::EndDisabled();
  ImGui::SameLine(0, gap);
  const float room = right - ImGui::GetCursorPosX() - (keys > 0 ? keys + gap : 0);
  const Palette& colors = palette(app.ui->dark);
  ImGui::PushStyleColor(ImGuiCol_Text, why.empty() ? colors.dim : colors.warning);
  draw_cut_text(why.empty() ? texts.place : why, room);
  ImGui::PopStyleColor();
  if (keys > 0) {
    ImGui::SameLine(right - keys);
    ImGui::TextDisabled("%s", texts.keys.c_str());
  }
  return clicked && why.empty();
}

/// The choice of the user: an entry, or a body to select, or neither.
struct PaletteChoice {
  const Found* entry = nullptr;
  int body = -1;
};

/// Returns the bodies of the running scene that the typed words find.
std::vector<int> find_bodies(const App& app) {
  constexpr std::size_t kMaxBodies = 20;
  std::vector<int> found;
  const std::string& typed = app.get<PaletteState>().typed;
  const SimFramePtr& frame = app.shown->run.frame;
  const bool is_searched =
      shows_run(app.viewer->mode) && frame && frame->scene && typed.find_first_not_of(' ') != std::string::npos;
  const int count = is_searched ? static_cast<int>(frame->scene->controls.bodies.size()) : 0;
  for (int body = 1; body < count && found.size() < kMaxBodies; ++body)
    if (finds(typed, names_of_body(*frame->scene, body))) found.push_back(body);
  return found;
}

/// Draws the row of a body. Returns whether it was clicked.
bool draw_body(App& app, int body, bool chosen) {
  const SceneBody& scene_body = app.shown->run.frame->scene->controls.bodies[static_cast<std::size_t>(body)];
  const std::string label = fmt::format("Select {}", scene_body.name);
  const bool clicked = ImGui::Selectable(fmt::format("{}##body {}", label, body).c_str(), chosen);
  app.ui->widgets.note_item(label);
  ImGui::SameLine(0, ImGui::GetFontSize());
  ImGui::TextDisabled("Body of the scene");
  return clicked;
}

/// Searches again if the text or the names of the keys have changed.
void search_again_if_changed(PaletteState& palette, const KeyNames& names) {
  if (!palette.entries || palette.key_names != names) {
    palette.entries = std::make_shared<const std::vector<Found>>(all_found(names));
    palette.key_names = names;
    palette.searched.reset();
  }
  if (palette.searched == palette.typed) return;
  palette.found = find_entries(palette.typed, *palette.entries);
  palette.searched = palette.typed;
}

/// Draws the sentence about the chosen entry below the list. Shorter sentences leave the same room, so that the window
/// keeps its height from entry to entry.
void draw_sentence(const Found* entry) {
  constexpr float kLines = 2;
  const std::string text = entry != nullptr && !entry->texts.help.empty() ? entry->texts.help : " ";
  const float top = ImGui::GetCursorPosY(), height = kLines * ImGui::GetTextLineHeightWithSpacing();
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", text.substr(0, text.find('\n')).c_str());
  ImGui::PopStyleColor();
  ImGui::Dummy({0, std::max(0.0f, top + height - ImGui::GetCursorPosY())});
}

PaletteChoice draw_contents(App& app) {
  PaletteState& palette = app.get<PaletteState>();
  ImGui::SetNextItemWidth(-1);
  if (std::exchange(palette.wants_focus, false)) ImGui::SetKeyboardFocusHere();
  if (ImGui::InputTextWithHint(
          "##command", "Command, field, button, gesture, chapter of the guide, or body of the scene", &palette.typed))
    palette.chosen = 0;
  app.ui->widgets.note_item("Command");
  search_again_if_changed(palette, app.ui->key_names);
  const std::vector<Found>& entries = *palette.entries;
  const std::vector<std::size_t>& found = palette.found;
  const std::vector<int> bodies = find_bodies(app);
  move_choice(palette, static_cast<int>(found.size() + bodies.size()));
  const auto chosen = static_cast<std::size_t>(palette.chosen);
  PaletteChoice choice;
  const float height = kRows * ImGui::GetTextLineHeightWithSpacing();
  if (ImGui::BeginChild("found", ImVec2(0, height))) {
    for (std::size_t i = 0; i < found.size(); ++i)
      if (draw_found(app, entries[found[i]], i, i == chosen)) choice.entry = &entries[found[i]];
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (draw_body(app, bodies[i], found.size() + i == chosen)) choice.body = bodies[i];
    if (found.empty() && bodies.empty()) ImGui::TextDisabled("Nothing of that name");
  }
  ImGui::EndChild();
  draw_sentence(chosen < found.size() ? &entries[found[chosen]] : nullptr);
  const bool entered = ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false);
  if (entered && chosen < found.size()) {
    if (why_not_now(entries[found[chosen]], app).empty()) choice.entry = &entries[found[chosen]];
  } else if (entered && chosen < found.size() + bodies.size()) {
    choice.body = bodies[chosen - found.size()];
  }
  return choice;
}

}  // namespace

void draw_palette(App& app) {
  PaletteState& palette = app.get<PaletteState>();
  if (!palette.open) return;
  if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const float width = std::min(kWidth * ImGui::GetFontSize(), 0.9f * viewport->Size.x);
  ImGui::SetNextWindowPos({viewport->GetCenter().x, viewport->Pos.y + kFromTop * viewport->Size.y}, ImGuiCond_Appearing,
                          ImVec2(0.5f, 0));
  ImGui::SetNextWindowSize({width, 0});
  constexpr auto kFlags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove;
  if (!ImGui::BeginPopup(kTitle, kFlags)) {
    palette.open = palette.wants_focus;  // a click outside has closed it
    return;
  }
  const PaletteChoice choice = draw_contents(app);  // its entry is one of the state
  if (choice.entry != nullptr || choice.body >= 0 || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) {
    palette.open = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (choice.body >= 0) app.viewer->selection.body = choice.body;
  if (choice.entry != nullptr) choose(*choice.entry, app);
}

}  // namespace taxel::ui
