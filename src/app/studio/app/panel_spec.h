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
inline constexpr const char* kModelsTitle = "Models";
inline constexpr const char* kProfilerTitle = "Profiler";
inline constexpr const char* kStudyTitle = "Study";
inline constexpr const char* kSectionTitle = "Section";
inline constexpr const char* kMessagesTitle = "Messages";

/// Place of a panel in a new arrangement. A compact one has only left, right and bottom.
enum class Dock {
  floating,
  upper_left,
  left,
  right,
  bottom_left,
  bottom,
  bottom_right,
  lowest  ///< below the other panels, over the whole width
};

/// Returns the switch of a panel that can be open or closed.
using PanelSwitch = bool& (*)(App& app);

struct PanelSpec {
  const char* title;
  Dock dock = Dock::floating;
  void (*draw)(App& app) = nullptr;
  const char* key = nullptr;    ///< in the settings file, or null if the panel opens by itself
  PanelSwitch shown = nullptr;  ///< or null if the panel opens by itself
  const char* label = nullptr;  ///< menu entry, or null if the panel opens by itself
  Context context = Context::everywhere;
  int chord = 0;
};

}  // namespace taxel::ui
