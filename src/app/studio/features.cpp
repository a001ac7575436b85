// The list of all features of the window. A feature without a row here is not part of the program.
#include <array>

#include "app/studio/frame/feature.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "app/studio/nouns/brush/brush.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/fields/fields.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/guide/guide_state.h"
#include "app/studio/nouns/heat/heat_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/map/map_panel.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/messages/messages.h"
#include "app/studio/nouns/models/models_state.h"
#include "app/studio/nouns/perturb/perturb_state.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/present/present.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/profiler/profiler_state.h"
#include "app/studio/nouns/real/real_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/scene/scene_layouts.h"
#include "app/studio/nouns/section/section_state.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/studio/nouns/table/table_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/timeline/timeline.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_state.h"

namespace taxel::ui {

namespace {

constexpr std::array kRows = {
    // The order in which the tools of the 3-D view get the pointer.
    &kClicks,
    &kGizmo,
    &kProbe,
    &kMeasure,
    &kWheel,
    &kTaxelTools,
    &kPath,
    &kPerturb,
    &kCameraFollow,
    &kMeshFrame,
    &kPlaceTaxel,
    &kSelection,
    &kFields,
    // Bars at the lower edge, from below.
    &kStatusLine,
    &kMessageLine,
    // The order of the menu Panels.
    &kOutliner,
    &kTaxelTable,
    &kInspector,
    &kControls,
    &kBars,
    &kTaxelMap,
    &kPlot,
    &kHeatMap,
    &kSection,
    &kTimeline,
    &kExplain,
    &kReal,
    &kModels,
    &kCompare,
    &kStudy,
    &kProfiler,
    &kMessages,
    &kHistory,
    &kMeshReport,
    &kGenerate,
    // Cards over the panels, the uppermost last.
    &kSceneLayouts,
    &kInfo,
    &kPathRecorder,
    &kDemo,
    &kPresent,
    &kBrush,
    &kTour,
    &kHelp,
    &kAbout,
    &kGuide,
    &kVideo,
    &kFiles,
};

}  // namespace

std::span<const Feature* const> features() {
  return kRows;
}

}  // namespace taxel::ui
