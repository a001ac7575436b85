// Where panels stand at first: left outliner and taxels, centre the view, right the inspector, below bars and plots.
#pragma once

#include "app/studio/app/ui_state.h"

namespace taxel::ui {

inline constexpr const char* kViewTitle = "View";
inline constexpr const char* kOutlinerTitle = "Outliner";
inline constexpr const char* kTaxelsTitle = "Taxels";
inline constexpr const char* kInspectorTitle = "Inspector";
inline constexpr const char* kControlsTitle = "Controls";
inline constexpr const char* kGenerateTitle = "Generate";
inline constexpr const char* kBarsTitle = "Pressure bars";
inline constexpr const char* kPlotTitle = "Taxels over travel";
/// The same panel where it shows time: an arrangement that is kept knows it by the other name.
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

/// Covers what menu, toolbar and status line leave free. Arranges anew at first or when ui.reset_arrangement is set.
void draw_dock_space(UiState& ui);

}  // namespace taxel::ui
