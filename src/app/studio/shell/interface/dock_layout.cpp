#include "app/studio/shell/interface/dock_layout.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"

namespace taxel::ui {

namespace {

/// Width of the column in heights of text, in a window of a width; all that a window is wider, it shares with the
/// column.
constexpr float kColumn = 17, kWindow = 85, kWiderColumn = 0.3f;
constexpr float kMostColumn = 0.22f, kMostCompactColumn = 0.31f;  ///< fractions of the window's width
/// Share of the window's area that remains for the view, if the row below it can be that low.
constexpr float kViewShare = 0.556f;
constexpr float kLeastRow = 8.5f, kMostRow = 18;  ///< height of the row below the view, in heights of text
constexpr float kCompactRow = 0.29f;              ///< the same in a compact window, as fraction of its height

/// ANALYSE: share of the window's area that the plot has, with the least that it has if the column would be narrow, and
/// its largest share of the room.
constexpr float kPlotShare = 0.53f, kLeastPlotShare = 0.42f, kMostPlot = 0.7f;
/// ANALYSE: width of the column in heights of text that all its tabs fit into, and the share of it that the view has.
constexpr float kLeastColumn = 25, kSmallView = 0.45f;
constexpr int kLastTab = 100;  ///< place of tabs of ANALYSE that are not open at first

/// Parts of the column: of its height in a low window, in heights of text in a tall one. The inspector has the rest.
constexpr float kList = 0.42f, kOutline = 18, kTaxels = 22;

/// Sizes in heights of text: a window below them is compact, and one below kTall has the outliner and the taxels as
/// tabs.
constexpr float kCompactWidth = 60, kCompactHeight = 42, kTall = 75;

using Docks = std::array<ImGuiID, 7>;  ///< ImGui's dock node of each Dock; 0 for those that are not in the dock space

ImGuiID& node(Docks& docks, Dock dock) {
  return docks.at(static_cast<std::size_t>(dock));
}

bool is_compact(ImVec2 size, float line) {
  return size.x < kCompactWidth * line || size.y < kCompactHeight * line;
}

/// Splits a column of panels off the dock space, and divides it. Returns what remains at the left.
ImGuiID split_column(ImGuiID space, ImVec2 size, float line, Docks& docks) {
  const float wanted = kColumn * line + kWiderColumn * std::max(0.0f, size.x - kWindow * line);
  const float width = std::min(wanted, (is_compact(size, line) ? kMostCompactColumn : kMostColumn) * size.x);
  ImGuiID column = 0, rest = 0;
  ImGui::DockBuilderSplitNode(space, ImGuiDir_Right, width / size.x, &column, &rest);
  ImGuiID &outline = node(docks, Dock::outline), &taxels = node(docks, Dock::taxels),
          &inspector = node(docks, Dock::inspector);
  outline = taxels = inspector = column;
  if (is_compact(size, line)) return rest;
  if (size.y < kTall * line) {
    ImGui::DockBuilderSplitNode(column, ImGuiDir_Up, kList, &taxels, &inspector);
    outline = taxels;
    return rest;
  }
  const float outline_height = kOutline * line, taxels_height = kTaxels * line;
  ImGui::DockBuilderSplitNode(column, ImGuiDir_Up, outline_height / size.y, &outline, &column);
  ImGui::DockBuilderSplitNode(column, ImGuiDir_Up, taxels_height / (size.y - outline_height), &taxels, &inspector);
  return rest;
}

/// Returns the height of the row below the view as a fraction of `room`, the height of both.
float row_part(ImVec2 window, ImVec2 room, float line) {
  if (is_compact(window, line)) return kCompactRow;
  const float view = kViewShare * window.x * window.y / room.x;
  return std::clamp(room.y - view, kLeastRow * line, std::min(kMostRow * line, 0.5f * room.y)) / room.y;
}

/// Splits the dock space of ANALYSE: the large plot at the left, and a column at its right with the small view above
/// the tabs. Returns the place of the view.
ImGuiID split_for_analysis(ImGuiID space, ImVec2 window, ImVec2 size, Docks& docks) {
  const float of_window = window.x * window.y / (size.x * size.y), column_width = kLeastColumn * ImGui::GetFontSize();
  const float plot =
      std::min({kPlotShare * of_window, kMostPlot, std::max(kLeastPlotShare * of_window, 1 - column_width / size.x)});
  ImGuiID column = 0, view = 0, tabs = 0;
  ImGui::DockBuilderSplitNode(space, ImGuiDir_Left, plot, &node(docks, Dock::plot), &column);
  ImGui::DockBuilderSplitNode(column, ImGuiDir_Up, kSmallView, &view, &tabs);
  node(docks, Dock::outline) = node(docks, Dock::taxels) = node(docks, Dock::inspector) = node(docks, Dock::bottom) =
      tabs;
  return view;
}

/// Orders the tabs of ANALYSE as their rows say.
void order_tabs() {
  for (const Feature* row : features()) {
    const auto place = static_cast<short>(row->analyse.tab > 0 ? row->analyse.tab : kLastTab);
    if (ImGuiWindowSettings* settings = ImGui::FindWindowSettingsByID(ImHashStr(row->title)))
      settings->DockOrder = place;
    if (ImGuiWindow* window = ImGui::FindWindowByName(row->title)) window->DockOrder = place;
  }
}

void arrange_analysis(ImGuiID space, ImVec2 window, ImVec2 size) {
  ImGui::DockBuilderRemoveNode(space);
  ImGui::DockBuilderAddNode(space, static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_DockSpace));
  ImGui::DockBuilderSetNodeSize(space, size);
  Docks docks{};
  const ImGuiID view = split_for_analysis(space, window, size, docks);
  ImGui::DockBuilderDockWindow(kViewTitle, view);
  for (const Feature* row : features())
    if (const ImGuiID dock = node(docks, dock_in(Mode::analyse, *row)); dock != 0)
      ImGui::DockBuilderDockWindow(row->title, dock);
  order_tabs();
  const auto no_bar = static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_NoTabBar);
  ImGui::DockBuilderGetNode(view)->SetLocalFlags(no_bar);
  ImGui::DockBuilderGetNode(node(docks, Dock::plot))->SetLocalFlags(no_bar);
  for (const Feature* row : features())
    if (row->analyse.in_front)
      ImGui::DockBuilderGetNode(node(docks, Dock::inspector))->SelectedTabId =
          ImHashStr("#TAB", 0, ImHashStr(row->title));
  ImGui::DockBuilderFinish(space);
}

void arrange(ImGuiID space, ImVec2 window, ImVec2 size) {
  const float line = ImGui::GetFontSize();
  ImGui::DockBuilderRemoveNode(space);
  ImGui::DockBuilderAddNode(space, static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_DockSpace));
  ImGui::DockBuilderSetNodeSize(space, size);
  Docks docks{};
  ImGuiID center = split_column(space, window, line, docks);
  const ImVec2 room(ImGui::DockBuilderGetNode(center)->Size.x, size.y);
  ImGui::DockBuilderSplitNode(center, ImGuiDir_Down, row_part(window, room, line), &node(docks, Dock::bottom), &center);
  ImGui::DockBuilderDockWindow(kViewTitle, center);
  for (const Feature* row : features())
    if (const ImGuiID dock = node(docks, row->dock); dock != 0) ImGui::DockBuilderDockWindow(row->title, dock);
  ImGui::DockBuilderGetNode(center)->SetLocalFlags(static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_NoTabBar));
  // ImGui names a tab by the hash of its window's title.
  for (const Feature* row : features())
    if (row->in_front)
      ImGui::DockBuilderGetNode(node(docks, row->dock))->SelectedTabId = ImHashStr("#TAB", 0, ImHashStr(row->title));
  ImGui::DockBuilderFinish(space);
}

/// Gives the whole dock space to one panel.
void arrange_alone(ImGuiID space, ImVec2 size, const char* title) {
  ImGui::DockBuilderRemoveNode(space);
  ImGui::DockBuilderAddNode(space, static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_DockSpace));
  ImGui::DockBuilderSetNodeSize(space, size);
  ImGui::DockBuilderDockWindow(title, space);
  if (std::string_view(title) == kViewTitle)
    ImGui::DockBuilderGetNode(space)->SetLocalFlags(static_cast<ImGuiDockNodeFlags>(ImGuiDockNodeFlags_NoTabBar));
  ImGui::DockBuilderFinish(space);
}

/// Text has become too large for the arrangement, or small enough for the other one. A window that becomes small keeps
/// its own, for it may become large again.
bool scale_wants_another(App& app, ImVec2 size) {
  // The scale matters when all panels are displayed: a presentation has another scale, and ends with the earlier one.
  if (!app.get<Arrangement>().maximised.empty()) return false;
  const double before = std::exchange(app.get<Arrangement>().scale, app.ui->pixel_scale);
  const float line = ImGui::GetFontSize(), line_before = line * static_cast<float>(before / app.ui->pixel_scale);
  return before > 0 && is_compact(size, line) != is_compact(size, line_before);
}

std::string text_now() {
  std::size_t size = 0;
  const char* text = ImGui::SaveIniSettingsToMemory(&size);
  return {text, size};
}

/// Restores the kept arrangement of the displayed mode, or requests a new one.
void restore(Arrangement& arrangement) {
  const std::string& kept = arrangement.kept.at(*arrangement.displayed);
  if (kept.empty()) {
    arrangement.reset = true;
  } else {
    ImGui::LoadIniSettingsFromMemory(kept.data(), kept.size());
  }
}

}  // namespace

void switch_arrangement(App& app) {
  Arrangement& a = app.get<Arrangement>();
  const auto mode = static_cast<std::size_t>(app.viewer->mode);
  if (a.displayed != mode) {
    if (a.displayed && a.filling.empty()) a.kept.at(*a.displayed) = text_now();
    a.displayed = mode;
    a.maximised.clear();
  } else if (!a.maximised.empty() || a.filling.empty()) {
    return;  // draw_dock_space() lets a panel fill the window
  }
  a.filling.clear();
  restore(a);
}

std::array<std::string, 3> arrangement_texts(const App& app) {
  const Arrangement& a = app.get<Arrangement>();
  std::array<std::string, 3> texts = a.kept;
  if (a.displayed && a.filling.empty()) texts.at(*a.displayed) = text_now();
  return texts;
}

void draw_dock_space(App& app) {
  Arrangement& a = app.get<Arrangement>();
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  // The bars at the edges of this frame count, which WorkSize learns of in the next frame.
  const ImVec2 size = static_cast<const ImGuiViewportP*>(viewport)->GetBuildWorkRect().GetSize();
  const ImGuiID space = ImGui::GetID("Taxel Studio");
  a.width = viewport->Size.x;
  a.height = viewport->Size.y;
  a.reset = a.reset || std::exchange(a.resets_twice, false);
  if (scale_wants_another(app, viewport->Size)) {
    a.kept = {};
    a.reset = a.resets_twice = true;  // the bars at the edges have their new rows in the next frame
  }
  if (a.reset || ImGui::DockBuilderGetNode(space) == nullptr) {
    a.maximised.clear();
    a.filling.clear();
    app.viewer->mode == Mode::analyse ? arrange_analysis(space, viewport->Size, size)
                                      : arrange(space, viewport->Size, size);
  } else if (!a.maximised.empty() && a.maximised != a.filling) {
    if (a.filling.empty()) a.kept.at(*a.displayed) = text_now();
    a.filling = a.maximised;
    arrange_alone(space, size, a.filling.c_str());
  }
  a.reset = false;
  if (app.get<WindowParts>().is_presenting) a.maximised = kViewTitle;  // also after the mode has changed
  ImGui::SetNextWindowBgAlpha(0);                                      // the window is cleared to this colour already
  ImVec2 padding = ImGui::GetStyle().FramePadding, spacing = ImGui::GetStyle().ItemInnerSpacing;
  const bool is_compact_column = has_narrow_tabs(app) && app.viewer->mode != Mode::analyse;
  if (has_narrow_tabs(app)) padding.x *= is_compact_column ? 0.3f : 0.5f, spacing.x = is_compact_column ? 0 : 2;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, spacing);
  ImGui::DockSpaceOverViewport(space, viewport);
  ImGui::PopStyleVar(2);
}

bool has_narrow_tabs(const App& app) {
  const Arrangement& a = app.get<Arrangement>();
  return app.viewer->mode == Mode::analyse || is_compact({a.width, a.height}, ImGui::GetFontSize());
}

bool has_room(const Arrangement& arrangement, const char* title, Dock dock) {
  return arrangement.filling.empty() || dock == Dock::floating || arrangement.filling == title;
}

}  // namespace taxel::ui
