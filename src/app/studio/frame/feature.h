// A feature of the window as one row: its panel, its tool, its marks in the 3-D view, its job, its settings and its
// part of each frame. A feature defines its row in its own folder, and features.cpp lists all rows.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/keymap.h"
#include "app/studio/frame/window_state.h"
#include "ui/scene/scene_input.h"

namespace taxel::studio {
class FeatureJob;
class JobExecutor;
}  // namespace taxel::studio

namespace taxel::ui {

struct SavedValue {
  std::string key;  ///< in the settings file
  std::variant<bool*, float*, std::vector<std::string>*, WindowPlace*, Overlays*, GroupsShown*, FramesShown*,
               LabelsShown*>
      value;
};

/// Returns all values of a window that are kept: those of the features too. They are valid as long as `app` is.
std::vector<SavedValue> saved_values(App& app);

struct PointerEvent;

inline constexpr const char* kViewTitle = "View";

/// Place of a panel in a new arrangement: a column at the right of the view and a row below it. Panels of one place are
/// tabs. In a low window the outliner and the taxels share a place; in a compact one, the whole column is one place.
enum class Dock {
  none,  ///< the feature has no panel that can be moved
  floating,
  outline,    ///< top of the column
  taxels,     ///< middle of the column
  inspector,  ///< lower part of the column
  bottom,     ///< row below the view
  plot        ///< the large plot of ANALYSE
};

/// Whether the user opens the panel of a feature, and whether the settings file keeps that.
enum class Opens {
  never,    ///< there is no panel, or it opens by the feature's own state
  by_user,  ///< the settings file keeps it under the row's key
  for_once  ///< it is closed at the next start
};

/// How a feature takes the pointer over the 3-D view, and how Esc ends it.
struct ToolSpec {
  const char* key = nullptr;      ///< or null if the feature is no tool
  Context context = kEverywhere;  ///< mode in which the tool gets the pointer
  /// Handles the pointer. Returns whether the event is consumed: later rows do not get it. Null if the tool has no use
  /// for the pointer.
  bool (*pointer)(App& app, const PointerEvent& event) = nullptr;
  int cancel_order = 0;                      ///< Esc cancels the active tool with the lowest number
  bool (*active)(const App& app) = nullptr;  ///< whether Esc can cancel the tool now
  void (*cancel)(App& app) = nullptr;        ///< function that ends the tool, or null
};

/// A field, choice or button of a panel that the command palette finds and shows.
struct PanelPart {
  std::string label;           ///< name in the palette
  std::string section;         ///< header above it, or empty
  std::string help;            ///< sentence of its tooltip
  Context mode = kEverywhere;  ///< mode in which it is drawn
  /// Returns why the widget cannot be shown now, or null if it can. The function is null if it always can.
  const char* (*why_not)(const App& app) = nullptr;
  std::string widget = {};                          ///< label of its widget, or empty if that is `label`
  std::string instead = {};                         ///< widget to show if the first is not drawn, or empty
  std::function<void(App& app)> prepare = nullptr;  ///< makes the panel draw the widget, or null
};

/// A line of text in the 3-D view.
struct ViewHint {
  std::string text;
  bool is_problem = false;
};

/// A panel in ANALYSE, where a large plot has half of the window, and a column at its right has a small view above
/// tabs.
struct InAnalyse {
  int tab = 0;                     ///< place among the tabs that are open at first, from 1; 0 if it is not open
  bool in_front = false;           ///< whether the tab is in front at first
  bool is_plot = false;            ///< whether the panel is the large plot
  const char* question = nullptr;  ///< command that brings the panel to the front in ANALYSE, or null
  /// Draws the answer of the panel into the large plot while the panel is in front. Returns false if there is none yet:
  /// the plot then has the readings. Null if its answer is always about the plot of the readings.
  bool (*draw_answer)(App& app) = nullptr;
  /// Looks for the answer when the command is carried out. Null if there is nothing to do.
  void (*answer)(App& app) = nullptr;
  bool magnifies = false;  ///< whether the plot of the readings has the close-up of a change for this panel
};

/// All members but the used ones keep their defaults.
struct Feature {
  // The panel.
  const char* title = "";  ///< title of its window
  Dock dock = Dock::none;
  bool in_front = false;  ///< whether it is in front of the other panels of its place at first
  Opens opens = Opens::never;
  bool open = false;            ///< whether it is open at the first start
  const char* key = nullptr;    ///< in the settings file
  const char* label = nullptr;  ///< entry of the menu Panels, or null if it has none there
  Context context = Context::everywhere;
  int chord = 0;
  /// Whether the panel displays readings. In LAYOUT it is drawn only while there is a probe.
  bool of_readings = false;
  bool (*gives_readings)(const App& app) = nullptr;  ///< whether there are readings in LAYOUT
  void (*draw)(App& app) = nullptr;
  /// Returns the parts of the panel that the command palette finds. Null if there are none.
  std::vector<PanelPart> (*parts)() = nullptr;
  const char* guide = nullptr;  ///< heading of the user guide about the panel, or null
  InAnalyse analyse = {};

  // The frame: interface.cpp calls these of all rows, in the order of the rows.
  void (*begin_frame)(App& app) = nullptr;  ///< before keys are handled and anything is drawn
  void (*draw_bar)(App& app) = nullptr;     ///< a bar at an edge of the window
  void (*update)(App& app) = nullptr;       ///< before the panels
  void (*end_panels)(App& app) = nullptr;   ///< after the panels
  void (*draw_card)(App& app) = nullptr;    ///< over the panels

  // The 3-D view. The pointer goes through the rows in their order, until one of them consumes it.
  ToolSpec tool = {};
  void (*mark)(const App& app, SceneInput& scene) = nullptr;  ///< adds the feature's marks to the drawn scene
  void (*draw_on_view)(const App& app) = nullptr;             ///< draws over the scene
  void (*hint)(const App& app, std::vector<ViewHint>& lines) = nullptr;

  /// Returns the rows of the keymap about the feature alone. Each comes last in its menu.
  std::vector<Binding> (*commands)() = nullptr;
  /// Makes the job that computes in workers for the feature. Null if there is none.
  std::unique_ptr<studio::FeatureJob> (*make_job)(studio::JobExecutor& executor) = nullptr;
  /// Adds the feature to the state of the window that scripts see.
  void (*dump)(const App& app, nlohmann::ordered_json& state) = nullptr;
  /// Returns the values that the settings file keeps, besides whether the panel is open.
  std::vector<SavedValue> (*saved)(App& app) = nullptr;
};

/// Returns all rows. Panels are drawn, and listed in the menu Panels, in this order.
std::span<const Feature* const> features();

/// Returns whether the panel of a feature is open and has something to display in the mode. A panel that opens by its
/// own state counts as open.
[[nodiscard]] bool is_drawn(const Feature& feature, const App& app);

/// Returns whether the panel of a feature is left out while it is open: by the presentation, or for the demo.
[[nodiscard]] bool is_left_out(const Feature& feature, const App& app);

/// Ends the active tool that Esc ends first, as ToolSpec::cancel_order says.
void cancel_innermost(App& app);

/// Whether the panel of each feature is open: as its row says until it is changed. ANALYSE has choices of its own. A
/// value keeps its address.
class PanelsShown {
 public:
  /// Returns the value in the present mode.
  [[nodiscard]] bool& operator[](const Feature& feature) { return in(in_analyse_, feature); }
  [[nodiscard]] bool operator[](const Feature& feature) const {
    const std::map<const Feature*, bool>& open = open_[in_analyse_ ? 1 : 0];
    const auto found = open.find(&feature);
    return found == open.end() ? is_open_first(in_analyse_, feature) : found->second;
  }
  /// Returns the value in ANALYSE, or in the other modes.
  [[nodiscard]] bool& in(bool analyse, const Feature& feature) {
    return open_[analyse ? 1 : 0].try_emplace(&feature, is_open_first(analyse, feature)).first->second;
  }
  void enter(Mode mode) { in_analyse_ = mode == Mode::analyse; }
  /// Returns whether a panel is open at the first start.
  [[nodiscard]] static bool is_open_first(bool analyse, const Feature& feature) {
    const bool is_bar = feature.dock == Dock::none && feature.open;
    return analyse ? feature.analyse.tab > 0 || feature.analyse.is_plot || is_bar : feature.open;
  }

 private:
  std::array<std::map<const Feature*, bool>, 2> open_;
  bool in_analyse_ = false;
};

/// Displays a mode, with its panels.
void enter_mode(App& app, Mode mode);

/// Returns whether the user looks at a panel: it is open, and in ANALYSE its tab is in front. Work for hidden tabs
/// would slow down the others.
[[nodiscard]] bool is_in_use(const Feature& feature, const App& app);

/// Returns the place of a panel in a mode.
[[nodiscard]] Dock dock_in(Mode mode, const Feature& feature);

}  // namespace taxel::ui
