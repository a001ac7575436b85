// The list of all features of the window. A feature without a row here is not part of the program.
#include <array>

#include "app/studio/frame/feature.h"
#include "app/studio/nouns/bars/bars.h"
#include "app/studio/nouns/brush/brush_card.h"
#include "app/studio/nouns/camera/camera_follow.h"
#include "app/studio/nouns/camera/frame_tool.h"
#include "app/studio/nouns/compare/compare.h"
#include "app/studio/nouns/data_set/data_set.h"
#include "app/studio/nouns/demo/demo.h"
#include "app/studio/nouns/explain/explain.h"
#include "app/studio/nouns/fields/field_legend.h"
#include "app/studio/nouns/files/files.h"
#include "app/studio/nouns/generate/generate_panel.h"
#include "app/studio/nouns/heat/heat.h"
#include "app/studio/nouns/history/history.h"
#include "app/studio/nouns/inspector/inspector.h"
#include "app/studio/nouns/inspector/outliner.h"
#include "app/studio/nouns/map/map.h"
#include "app/studio/nouns/measure/measure.h"
#include "app/studio/nouns/menus/help.h"
#include "app/studio/nouns/menus/status_line.h"
#include "app/studio/nouns/menus/tour.h"
#include "app/studio/nouns/mesh/mesh_section.h"
#include "app/studio/nouns/messages/messages.h"
#include "app/studio/nouns/models/models.h"
#include "app/studio/nouns/perturb/perturb_tool.h"
#include "app/studio/nouns/plot/plot.h"
#include "app/studio/nouns/probe/probe.h"
#include "app/studio/nouns/profiler/profiler.h"
#include "app/studio/nouns/real/real_panel.h"
#include "app/studio/nouns/scenario/path_recorder.h"
#include "app/studio/nouns/scenario/path_tool.h"
#include "app/studio/nouns/scene/controls.h"
#include "app/studio/nouns/section/section_panel.h"
#include "app/studio/nouns/study/study.h"
#include "app/studio/nouns/table/table.h"
#include "app/studio/nouns/taxel/taxel_tools.h"
#include "app/studio/nouns/timeline/timeline.h"
#include "app/studio/nouns/video/video_card.h"
#include "app/studio/nouns/view/scene_overlay.h"
#include "app/studio/nouns/view/view_tools.h"

namespace taxel::ui {

namespace {

constexpr std::array kRows = {
    // The order in which the tools of the 3-D view get the pointer.
    &kClicks,
    &kProbe,
    &kMeasure,
    &kWheel,
    &kTaxelTools,
    &kPath,
    &kPerturb,
    &kCameraFollow,
    &kGizmo,
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
    &kDataSet,
    &kProfiler,
    &kMessages,
    &kHistory,
    &kMeshReport,
    &kGenerate,
    // Cards over the panels, the uppermost last.
    &kInfo,
    &kPathRecorder,
    &kDemo,
    &kBrush,
    &kTour,
    &kHelp,
    &kVideo,
    &kFiles,
};

}  // namespace

std::span<const Feature* const> features() {
  return kRows;
}

}  // namespace taxel::ui
