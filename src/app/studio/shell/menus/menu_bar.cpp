#include "app/studio/shell/menus/menu_bar.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/menus/menu_keys_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/shell/interface/perform.h"
#include "app/studio/shell/menus/menu_keys.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

constexpr std::array kMenus = {"File", "Edit", "Mode", "Simulation", "View", "Panels", "Help"};

bool begin_submenu(App& app, const char* title) {
  const bool open = begin_menu(*app.ui, title);
  note_submenu(app.get<MenuKeys>());
  return open;
}

void draw_recent_files(App& app) {
  if (app.get<FilesState>().recent.empty() || !begin_submenu(app, "Open recent")) return;
  for (const std::string& file : app.get<FilesState>().recent) {
    if (menu_item(*app.ui, file.c_str(), "", false)) app.ui->post(OpenFile{file});
  }
  ImGui::EndMenu();
}

std::string menu_label(const Binding& binding, const App& app) {
  if (binding.command.is<UndoStep>() && !app.shown->document.editing.undo.empty())
    return app.shown->document.editing.undo;
  if (binding.command.is<RedoStep>() && !app.shown->document.editing.redo.empty())
    return app.shown->document.editing.redo;
  const Overlays& overlays = app.viewer->overlays();
  if (binding.command.is<CycleFrames>()) return std::string("Frames: ") + to_word(overlays.frames);
  if (binding.command.is<CycleLabels>()) return std::string("Labels: ") + to_word(overlays.labels);
  return binding.label;
}

void draw_entry(App& app, const Binding& b) {
  if (b.separated) ImGui::Separator();
  const bool chosen = menu_item(*app.ui, menu_label(b, app).c_str(), chord_name(b.chord, app.ui->key_names),
                                is_checked(b, app), is_enabled(b, app));
  app.ui->widgets.note_item(b.label);  // also where it says what would be undone
  tooltip(why_disabled(b, app));
  if (chosen) perform(b, app);
  if (b.command.is<ShowOpenDialog>()) draw_recent_files(app);
}

/// Entries of a menu in a row that are in one submenu of it stand in that. Returns where they end.
const Binding* draw_submenu(App& app, const Binding* first, const Binding* end) {
  const std::string_view whole(first->menu);
  const Binding* last =
      std::find_if(first, end, [&](const Binding& b) { return b.menu == nullptr || whole != b.menu; });
  if (begin_submenu(app, first->menu + whole.find('/') + 1)) {
    for (const Binding* b = first; b != last; ++b) draw_entry(app, *b);
    ImGui::EndMenu();
  }
  return last;
}

/// Underlines the first letter of the title that was drawn last.
void underline_letter(ImDrawList& bar, const char* title) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(), size = ImGui::CalcTextSize(title);
  const float x = 0.5f * (low.x + high.x - size.x), y = std::floor(0.5f * (low.y + high.y + size.y)) - 1;
  bar.AddLine({x, y}, {x + ImGui::CalcTextSize(title, title + 1).x, y}, ImGui::GetColorU32(ImGuiCol_Text));
}

void draw_menu(App& app, int index) {
  const char* menu = kMenus.at(static_cast<std::size_t>(index));
  MenuKeys& keys = app.get<MenuKeys>();
  ImDrawList& bar = *ImGui::GetWindowDrawList();
  open_if_asked(keys, menu, index);
  const bool open = begin_menu(*app.ui, menu);
  if (underlines_letters(keys)) underline_letter(bar, menu);
  mark_menu(keys, index, open);
  if (!open) return;
  const std::string below = std::string(menu) + "/";
  const Binding* end = bindings().data() + bindings().size();
  for (const Binding* b = bindings().data(); b != end;) {
    if (b->menu != nullptr && std::string_view(b->menu).starts_with(below)) {
      b = draw_submenu(app, b, end);
      continue;
    }
    if (b->menu != nullptr && std::string_view(b->menu) == menu) draw_entry(app, *b);
    ++b;
  }
  ImGui::EndMenu();
}

}  // namespace

const char* open_menu(const App& app) {
  const MenuKeys& keys = app.get<MenuKeys>();
  return keys.open ? kMenus.at(static_cast<std::size_t>(keys.menu)) : "";
}

void draw_menu_bar(App& app) {
  ImGui::SetNextWindowBgAlpha(0);  // it has a colour of its own
  if (!ImGui::BeginMainMenuBar()) return;
  read_menu_keys(app.get<MenuKeys>(), kMenus, !app.ui->fields.had_keys && !app.get<ToolState>().follows());
  for (int i = 0; i < static_cast<int>(kMenus.size()); ++i) draw_menu(app, i);
  end_menu_keys(app.get<MenuKeys>());
  app.ui->fields.in_menus = app.get<MenuKeys>().on;
  const std::string version = "Taxel Studio " + app.shown->version;
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
