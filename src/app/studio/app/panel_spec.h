// A panel as a row: its title, its key in the settings file, its menu entry and its place.
#pragma once

#include "app/studio/app/keymap.h"

namespace taxel::ui {

inline constexpr const char* kViewTitle = "View";
inline constexpr const char* kOutlinerTitle = "Outliner";
inline constexpr const char* kTaxelsTitle = "Taxels";
inline constexpr const char* kInspectorTitle = "Inspector";
inline constexpr const char* kControlsTitle = "Controls";
inline constexpr const char* kGenerateTitle = "Generate";
inline constexpr const char* kBarsTitle = "Pressure bars";
inline constexpr const char* kPlotTitle = "Taxels over travel";
/// Title of the same panel if it shows time. ImGui identifies both by the part after ###.
inline constexpr const char* kTimePlotTitle = "Taxels over time###Taxels over travel";
inline constexpr const char* kTimelineTitle = "Timeline";
inline constexpr const char* kExplainTitle = "Explain";
inline constexpr const char* kRealTitle = "Real recording";
inline constexpr const char* kMapTitle = "Taxel map";
inline constexpr const char* kHeatTitle = "Heat map";
inline constexpr const char* kModelsTitle = "Models";
inline constexpr const char* kCompareTitle = "Compare";
inline constexpr const char* kProfilerTitle = "Profiler";
inline constexpr const char* kStudyTitle = "Study";
inline constexpr const char* kDataSetTitle = "Data set";
inline constexpr const char* kSectionTitle = "Section";
inline constexpr const char* kHistoryTitle = "Undo history";
inline constexpr const char* kMessagesTitle = "Messages";

/// Place of a panel in a new arrangement: a column at the right of the view and a row below it. Panels of one place are
/// tabs. In a low window the outliner and the taxels share a place; in a compact one, the whole column is one place.
enum class Dock {
  floating,
  outline,    ///< top of the column
  taxels,     ///< middle of the column
  inspector,  ///< lower part of the column
  bottom,     ///< row below the view
  timeline    ///< below everything, over the whole width; not movable
};

/// Returns the switch of a panel that can be open or closed.
using PanelSwitch = bool& (*)(App& app);

struct PanelSpec {
  const char* title;
  Dock dock = Dock::floating;
  void (*draw)(App& app) = nullptr;  ///< or null for the timeline, which is no movable panel
  const char* key = nullptr;         ///< in the settings file, or null if the panel opens by itself
  PanelSwitch shown = nullptr;       ///< or null if the panel opens by itself
  const char* label = nullptr;       ///< entry of the menu Panels, or null if it opens by itself or from another menu
  Context context = Context::everywhere;
  int chord = 0;
  /// Whether the panel displays readings. In LAYOUT it is drawn only while there is a probe.
  bool of_readings = false;
};

}  // namespace taxel::ui
