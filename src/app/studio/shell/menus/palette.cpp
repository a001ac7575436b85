// The command palette, which finds commands by parts of their names, and bodies of the running scene by those of their
// parts.
#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/keymap.h"
#include "app/studio/frame/scene_filter.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/shell/interface/carry_out.h"
#include "app/studio/shell/menus/menus.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

bool is_command(const Binding& b) {
  return b.context != Context::gesture && b.context != Context::widget && !b.command.is<Escape>() &&
         !b.command.is<OpenPalette>();
}

bool has_word_with(const std::string& name, const std::string& start) {
  for (std::size_t at = name.find(start); at != std::string::npos; at = name.find(start, at + 1))
    if (at == 0 || std::isalnum(static_cast<unsigned char>(name[at - 1])) == 0) return true;
  return false;
}

bool letters_in_order(const std::string& name, const std::string& letters) {
  std::size_t next = 0;
  for (const char c : name)
    if (next < letters.size() && c == letters[next]) ++next;
  return next == letters.size();
}

constexpr int kLettersOnly = 4, kNoMatch = 9;

/// How well a command is meant: 0 best.
int rank_of(const Binding& b, const std::string& typed, const KeyNames& names) {
  const std::string name = lower(b.label);
  if (name.starts_with(typed)) return 0;
  if (has_word_with(name, typed)) return 1;
  const std::string all = name + " " + lower(b.menu != nullptr ? b.menu : "") + " " + lower(chord_names(b, names)) +
                          " " + std::string(synonyms_of(b.label));
  std::istringstream words(typed);
  bool in_names = true, in_all = true;
  for (std::string word; words >> word;) {
    in_names = in_names && has_word_with(name, word);
    in_all = in_all && all.find(word) != std::string::npos;
  }
  if (in_names) return 2;
  if (in_all) return 3;
  std::string letters;
  std::copy_if(typed.begin(), typed.end(), std::back_inserter(letters), [](char c) { return c != ' '; });
  return letters_in_order(name, letters) ? kLettersOnly : kNoMatch;
}

}  // namespace

std::vector<const Binding*> find_commands(std::string_view typed, const KeyNames& names) {
  std::string text = lower(typed);
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  std::vector<std::pair<int, const Binding*>> found;
  for (const Binding& b : bindings()) {
    if (!is_command(b)) continue;
    if (const int rank = rank_of(b, text, names); rank < kNoMatch) found.emplace_back(rank, &b);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Binding*> commands;
  for (const auto& [rank, binding] : found)
    if (rank < kLettersOnly || found.front().first == kLettersOnly) commands.push_back(binding);
  return commands;
}

namespace {

constexpr const char* kTitle = "Commands";
constexpr float kWidth = 32, kRows = 12, kFromTop = 0.14f;

void move_choice(PaletteState& palette, int count) {
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(key) ? 1 : 0; };
  constexpr int kPage = 10;
  palette.chosen += pressed(ImGuiKey_DownArrow) - pressed(ImGuiKey_UpArrow) +
                    kPage * (pressed(ImGuiKey_PageDown) - pressed(ImGuiKey_PageUp));
  palette.chosen = std::clamp(palette.chosen, 0, std::max(0, count - 1));
}

/// Draws one command: its name, its menu and its chord. Returns whether it was clicked.
bool draw_command(App& app, const Binding& b, bool chosen) {
  const bool enabled = is_enabled(b, app);
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  ImGui::BeginDisabled(!enabled);
  const ImVec2 at = ImGui::GetCursorPos();
  const std::string id = fmt::format("##{}", b.label);
  const bool clicked = ImGui::Selectable(id.c_str(), chosen);
  app.ui->widgets.note_item(b.label);
  tooltip(why_disabled(b, app));
  if (chosen && (ImGui::IsKeyPressed(ImGuiKey_DownArrow) || ImGui::IsKeyPressed(ImGuiKey_UpArrow) ||
                 ImGui::IsKeyPressed(ImGuiKey_PageDown) || ImGui::IsKeyPressed(ImGuiKey_PageUp)))
    ImGui::SetScrollHereY();
  ImGui::SetCursorPos(at);
  ImGui::TextUnformatted(b.label);
  ImGui::SameLine(0, ImGui::GetFontSize());
  ImGui::TextDisabled("%s", b.menu != nullptr ? b.menu : "");
  if (const std::string chord = chord_names(b, app.ui->key_names); !chord.empty()) {
    ImGui::SameLine(right - ImGui::CalcTextSize(chord.c_str()).x);
    ImGui::TextDisabled("%s", chord.c_str());
  }
  ImGui::EndDisabled();
  return clicked && enabled;
}

/// The choice of the user: a command, or a body to select, or neither.
struct PaletteChoice {
  const Binding* command = nullptr;
  int body = -1;
};

/// Returns the bodies of the running scene that the typed words find.
std::vector<int> find_bodies(const App& app) {
  constexpr std::size_t kMaxBodies = 20;
  std::vector<int> found;
  const std::string& typed = app.get<PaletteState>().typed;
  const SimFramePtr& frame = app.shown->run.frame;
  const bool is_searched =
      app.viewer->mode == Mode::simulate && frame && frame->scene && typed.find_first_not_of(' ') != std::string::npos;
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

PaletteChoice draw_contents(App& app) {
  PaletteState& palette = app.get<PaletteState>();
  ImGui::SetNextItemWidth(-1);
  if (std::exchange(palette.wants_focus, false)) ImGui::SetKeyboardFocusHere();
  if (ImGui::InputTextWithHint("##command", "Part of the name of a command, or of a body, mesh, class, joint or site",
                               &palette.typed))
    palette.chosen = 0;
  app.ui->widgets.note_item("Command");
  const std::vector<const Binding*> found = find_commands(palette.typed, app.ui->key_names);
  const std::vector<int> bodies = find_bodies(app);
  move_choice(palette, static_cast<int>(found.size() + bodies.size()));
  PaletteChoice choice;
  const float height = kRows * ImGui::GetTextLineHeightWithSpacing();
  if (ImGui::BeginChild("found", ImVec2(0, height))) {
    for (std::size_t i = 0; i < found.size(); ++i)
      if (draw_command(app, *found[i], static_cast<int>(i) == palette.chosen)) choice.command = found[i];
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (draw_body(app, bodies[i], static_cast<int>(found.size() + i) == palette.chosen)) choice.body = bodies[i];
    if (found.empty() && bodies.empty()) ImGui::TextDisabled("No command of that name");
  }
  ImGui::EndChild();
  const bool entered = ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false);
  const auto chosen = static_cast<std::size_t>(palette.chosen);
  if (entered && chosen < found.size()) {
    if (is_enabled(*found[chosen], app)) choice.command = found[chosen];
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
  const PaletteChoice choice = draw_contents(app);
  if (choice.command != nullptr || choice.body >= 0 || ImGui::IsKeyPressed(ImGuiKey_Escape, false)) {
    palette.open = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (choice.body >= 0) app.viewer->selection.body = choice.body;
  if (choice.command != nullptr) carry_out_if_enabled(*choice.command, app);
}

}  // namespace taxel::ui
