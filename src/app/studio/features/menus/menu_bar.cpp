#include "app/studio/features/menus/menu_bar.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "app/studio/app/perform.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

void draw_recent_files(UiState& ui) {
  if (ui.saved.recent.empty() || !begin_menu(ui, "Open recent")) return;
  for (const std::string& file : ui.saved.recent) {
    if (menu_item(ui, file.c_str(), "", false)) ui.ask(OpenFile{file});
  }
  ImGui::EndMenu();
}

std::string menu_label(const Binding& binding, const UiState& ui, const UiInput& input) {
  if (std::holds_alternative<UndoStep>(binding.command) && !input.editing.undo.empty()) return input.editing.undo;
  if (std::holds_alternative<RedoStep>(binding.command) && !input.editing.redo.empty()) return input.editing.redo;
  const Overlays& overlays = ui.saved.overlays;
  if (std::holds_alternative<CycleFrames>(binding.command)) return std::string("Frames: ") + to_word(overlays.frames);
  if (std::holds_alternative<CycleLabels>(binding.command)) return std::string("Labels: ") + to_word(overlays.labels);
  return binding.label;
}

void draw_entry(UiState& ui, const UiInput& input, const Binding& b) {
  if (b.separated) ImGui::Separator();
  const bool chosen = menu_item(ui, menu_label(b, ui, input).c_str(), chord_name(b.chord), is_checked(b, ui, input),
                                is_enabled(b, ui, input));
  ui.widgets.note_item(b.label);  // also where it says what would be undone
  if (chosen) perform(b, ui, input);
  if (std::holds_alternative<ShowOpenDialog>(b.command)) draw_recent_files(ui);
}

/// Entries of a menu in a row that are in one submenu of it stand in that. Returns where they end.
const Binding* draw_submenu(UiState& ui, const UiInput& input, const Binding* first, const Binding* end) {
  const std::string_view whole(first->menu);
  const Binding* last =
      std::find_if(first, end, [&](const Binding& b) { return b.menu == nullptr || whole != b.menu; });
  if (begin_menu(ui, first->menu + whole.find('/') + 1)) {
    for (const Binding* b = first; b != last; ++b) draw_entry(ui, input, *b);
    ImGui::EndMenu();
  }
  return last;
}

void draw_menu(UiState& ui, const UiInput& input, const char* menu) {
  if (!begin_menu(ui, menu)) return;
  const std::string below = std::string(menu) + "/";
  const Binding* end = bindings().data() + bindings().size();
  for (const Binding* b = bindings().data(); b != end;) {
    if (b->menu != nullptr && std::string_view(b->menu).starts_with(below)) {
      b = draw_submenu(ui, input, b, end);
      continue;
    }
    if (b->menu != nullptr && std::string_view(b->menu) == menu) draw_entry(ui, input, *b);
    ++b;
  }
  ImGui::EndMenu();
}

}  // namespace

void draw_menu_bar(UiState& ui, const UiInput& input) {
  ImGui::SetNextWindowBgAlpha(0);  // it has a colour of its own
  if (!ImGui::BeginMainMenuBar()) return;
  for (const char* menu : std::array{"File", "Edit", "Mode", "Simulation", "View", "Panels", "Help"})
    draw_menu(ui, input, menu);
  const std::string version = "Taxel Studio " + input.version;
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float start = right - ImGui::CalcTextSize(version.c_str()).x;
  if (start > at.x) {  // where the menus leave room
    ImGui::SetCursorScreenPos({start, at.y});
    ImGui::TextDisabled("%s", version.c_str());
  }
  ImGui::EndMainMenuBar();
}

}  // namespace taxel::ui
