// The menus, made from the table of bindings.
#include "app/studio/shell/menus/menus.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/keymap.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/shell/interface/carry_out.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

bool is_pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(key, false);
}

bool has_other_modifier() {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyCtrl || io.KeyShift || io.KeySuper;
}

/// Returns whether a key but the left Alt, a mouse button or the wheel was pressed in this frame.
bool is_other_key_pressed() {
  for (int key = ImGuiKey_NamedKey_BEGIN; key < ImGuiKey_NamedKey_END; ++key) {
    if (key != ImGuiKey_LeftAlt && key != ImGuiKey_ReservedForModAlt && is_pressed(static_cast<ImGuiKey>(key)))
      return true;
  }
  return !ImGui::GetIO().InputQueueCharacters.empty();
}

/// Returns whether the left Alt was pressed and let go alone. The right one writes characters on many keyboards.
bool is_alt_tapped(MenuKeys& keys) {
  if (is_pressed(ImGuiKey_LeftAlt)) keys.alt_alone = true;
  if (has_other_modifier() || is_other_key_pressed() || ImGui::GetIO().AppFocusLost) keys.alt_alone = false;
  const bool let_go = ImGui::IsKeyReleased(ImGuiKey_LeftAlt);
  return let_go && std::exchange(keys.alt_alone, false);
}

/// Keeps ImGui from its own use of Alt, which is to go from the widgets of a panel to its tabs.
void keep_alt() {
  const ImGuiID owner = ImGui::GetID("menu keys");
  for (const ImGuiKey key : {ImGuiKey_LeftAlt, ImGuiKey_RightAlt})
    if (ImGui::IsKeyDown(key)) ImGui::SetKeyOwner(key, owner);
}

/// Returns the index of the menu whose first letter was pressed, or -1.
int menu_of_letter(std::span<const char* const> menus) {
  for (std::size_t i = 0; i < menus.size(); ++i) {
    const auto letter = static_cast<ImGuiKey>(ImGuiKey_A + (menus[i][0] - 'A'));
    if (is_pressed(letter)) return static_cast<int>(i);
  }
  return -1;
}

/// Returns whether Alt with the first letter of a menu has another meaning.
bool is_bound_with_alt(const char* title) {
  const int chord = ImGuiMod_Alt | (ImGuiKey_A + (title[0] - 'A'));
  return std::any_of(bindings().begin(), bindings().end(),
                     [&](const Binding& row) { return row.chord == chord || row.also == chord; });
}

void enter(MenuKeys& keys, int menu) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  if (!keys.on) keys.window = g.NavWindow != nullptr ? g.NavWindow->ID : 0;
  keys.on = true;
  keys.menu = menu;
}

void leave(MenuKeys& keys) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  if (g.OpenPopupStack.Size > 0 && keys.open) ImGui::ClosePopupToLevel(0, true);
  keys.on = false;
  if (g.NavWindow != g.CurrentWindow) return;  // a dialog that the entry opened keeps the keyboard
  ImGui::FocusWindow(ImGui::FindWindowByID(keys.window));
  ImGui::SetNavCursorVisible(false);
}

/// Opens a menu in this frame. All menus share one window, which marks its first entry only if it does not display
/// another menu in the same frame: an open one closes first.
void open(MenuKeys& keys, int menu) {
  keys.menu = keys.asked = menu;
  if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) ImGui::ClosePopupToLevel(0, true);
  ImGui::NavMoveRequestCancel();
}

/// Walks while no menu is open.
void walk_along_bar(MenuKeys& keys, std::span<const char* const> menus) {
  const int count = static_cast<int>(menus.size());
  const auto step = [](ImGuiKey key) { return ImGui::IsKeyPressed(key, true) ? 1 : 0; };
  const int steps = step(ImGuiKey_RightArrow) - step(ImGuiKey_LeftArrow);
  keys.menu = (keys.menu + steps + count) % count;
  if (is_pressed(ImGuiKey_Home)) keys.menu = 0;
  if (is_pressed(ImGuiKey_End)) keys.menu = count - 1;
  ImGui::NavMoveRequestCancel();  // ImGui would walk as well
  const int lettered = ImGui::GetIO().KeyMods == 0 ? menu_of_letter(menus) : -1;
  if (lettered >= 0) {
    open(keys, lettered);
  } else if (is_pressed(ImGuiKey_DownArrow) || is_pressed(ImGuiKey_UpArrow) || is_pressed(ImGuiKey_Enter) ||
             is_pressed(ImGuiKey_KeypadEnter) || is_pressed(ImGuiKey_Space)) {
    open(keys, keys.menu);
  }
}

/// Walks from one open menu to the next. ImGui walks within a menu, and into and out of its submenus.
void walk_between_menus(MenuKeys& keys, int menus, int popups) {
  if (ImGui::IsKeyPressed(ImGuiKey_RightArrow, true) && !keys.on_submenu) open(keys, (keys.menu + 1) % menus);
  if (ImGui::IsKeyPressed(ImGuiKey_LeftArrow, true) && popups == 1) open(keys, (keys.menu + menus - 1) % menus);
  // ImGui may take the first Esc to show the mark of an entry.
  const bool still_open = popups == keys.after && keys.after > 0;
  if (is_pressed(ImGuiKey_Escape) && still_open) ImGui::ClosePopupToLevel(popups - 1, true);
}

/// Returns whether the keyboard leaves the menus: an entry was chosen, which may have opened a dialog, or the mouse was
/// pressed elsewhere.
bool is_over(const MenuKeys& keys, int popups) {
  if (ImGui::GetIO().AppFocusLost) return true;
  if (popups > 0) return !keys.open;
  const bool closed = std::max(keys.before, keys.after) > 0;
  if (is_pressed(ImGuiKey_Escape)) return !closed;  // the first Esc closes the menu, the next one leaves the bar
  const bool mouse = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
  return closed || mouse;
}

/// Reads the keys of this frame and decides which menu is marked, opened or closed. Call it in the window of the menu
/// bar, before its menus are drawn. `menus` are the titles from left to right, each with another first letter. `free`
/// is false while a field, a gesture or a dialog has the keyboard: then the menus do not take it.
void read_menu_keys(MenuKeys& keys, std::span<const char* const> menus, bool free) {
  const int popups = ImGui::GetCurrentContext()->OpenPopupStack.Size;
  const bool toggled = is_alt_tapped(keys) || (is_pressed(ImGuiKey_F10) && ImGui::GetIO().KeyMods == 0);
  keep_alt();
  keys.asked = -1;
  if (keys.on && (toggled || is_over(keys, popups))) {
    leave(keys);
  } else if (keys.on && popups == 0) {
    walk_along_bar(keys, menus);
  } else if (keys.on) {
    walk_between_menus(keys, static_cast<int>(menus.size()), popups);
  } else if (free && toggled) {
    enter(keys, 0);
  } else if (free && ImGui::GetIO().KeyMods == ImGuiMod_Alt) {
    const int lettered = menu_of_letter(menus);
    if (lettered >= 0 && !is_bound_with_alt(menus[static_cast<std::size_t>(lettered)])) {
      enter(keys, lettered);
      open(keys, lettered);
    }
  }
  keys.before = popups;
  keys.open = keys.on_submenu = false;
}

/// Opens menu `index` if a key asked for it. Call it before the menu is begun.
void open_if_asked(MenuKeys& keys, const char* title, int index) {
  if (keys.asked != index) return;
  ImGuiWindow* bar = ImGui::GetCurrentWindow();
  if (ImGui::GetCurrentContext()->NavWindow != bar) ImGui::FocusWindow(bar);  // Esc in the menu returns to the bar
  ImGui::OpenPopup(title);
  ImGui::SetNavCursorVisibleAfterMove();
}

/// Marks the title of menu `index`, which was drawn last, if it is the keyboard's. `open` says whether the menu is
/// open.
void mark_menu(MenuKeys& keys, int index, bool open) {
  if (open) {
    keys.open = true;
    keys.menu = index;  // also where the mouse opened it
  }
  if (open || !keys.on || keys.menu != index || keys.asked >= 0) return;
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  ImGuiWindow* bar = ImGui::GetCurrentWindow();
  if (g.OpenPopupStack.Size > 0) return;
  if (g.NavWindow != bar) ImGui::FocusWindow(bar);
  ImGui::SetNavID(g.LastItemData.ID, ImGuiNavLayer_Menu, g.CurrentFocusScopeId,
                  ImGui::WindowRectAbsToRel(bar, g.LastItemData.NavRect));
  ImGui::SetNavCursorVisibleAfterMove();
}

/// Takes notes about a submenu whose title was drawn last.
void note_submenu(MenuKeys& keys) {
  if (ImGui::IsItemFocused()) keys.on_submenu = true;
}

/// Call it after all menus.
void end_menu_keys(MenuKeys& keys) {
  keys.after = ImGui::GetCurrentContext()->OpenPopupStack.Size;
  if (keys.on) ImGui::SetNavCursorVisible(true);  // Home and End would hide it
}

/// Returns whether the first letters of the titles are underlined: while the menu bar has the keyboard or Alt is down.
bool underlines_letters(const MenuKeys& keys) {
  return keys.on || ImGui::IsKeyDown(ImGuiKey_LeftAlt);
}

constexpr const char* kExamplesMenu = "Help/Examples";
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
  if (chosen) carry_out_if_enabled(b, app);
}

/// Draws the list of Help > Examples in the menu File too, where users look for something to open.
void draw_examples(App& app) {
  if (!begin_submenu(app, "Examples")) return;
  for (const Binding& row : bindings())
    if (row.menu != nullptr && std::string_view(row.menu) == kExamplesMenu) draw_entry(app, row);
  ImGui::EndMenu();
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
    if (b->command.is<ShowOpenDialog>() && menu == kMenus.front()) {
      draw_recent_files(app);
      draw_examples(app);
    }
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
