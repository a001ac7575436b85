// The states of all features, in the groups that they belong to.
#pragma once

#include "app/studio/app/values/arrangement.h"
#include "app/studio/app/values/panels_shown.h"
#include "app/studio/app/values/window_place.h"
#include "app/studio/features/bars/bars_state.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/compare/compare_state.h"
#include "app/studio/features/demo/demo_state.h"
#include "app/studio/features/explain/explain_state.h"
#include "app/studio/features/explain/hunt_state.h"
#include "app/studio/features/files/file_dialog_state.h"
#include "app/studio/features/files/files_state.h"
#include "app/studio/features/generate/generate_state.h"
#include "app/studio/features/heat/heat_state.h"
#include "app/studio/features/inspector/layout_problems.h"
#include "app/studio/features/inspector/model_summary.h"
#include "app/studio/features/map/map_state.h"
#include "app/studio/features/measure/measure_state.h"
#include "app/studio/features/menus/help_state.h"
#include "app/studio/features/menus/menu_keys_state.h"
#include "app/studio/features/menus/palette_state.h"
#include "app/studio/features/menus/tour_state.h"
#include "app/studio/features/mesh/mesh_state.h"
#include "app/studio/features/messages/message_list.h"
#include "app/studio/features/models/models_state.h"
#include "app/studio/features/perturb/perturb_state.h"
#include "app/studio/features/plot/plot_state.h"
#include "app/studio/features/probe/probe_state.h"
#include "app/studio/features/profiler/profile_state.h"
#include "app/studio/features/real/real_state.h"
#include "app/studio/features/scenario/path_state.h"
#include "app/studio/features/scene/controls_state.h"
#include "app/studio/features/section/section_state.h"
#include "app/studio/features/study/study_state.h"
#include "app/studio/features/table/table_state.h"
#include "app/studio/features/taxel/tool_state.h"
#include "app/studio/features/timeline/timeline_state.h"
#include "app/studio/features/video/video_state.h"
#include "app/studio/features/view/view_state.h"

namespace taxel::ui {

/// States of the features that edit a layout.
struct LayoutFeatures {
  ToolState tool;
  TableState table;
  LayoutProblems problems;  ///< problems of the edited layout
  GenerateState generate;
  ProbeState probe;
  MeasureState measure;
  MeshState mesh;
  ModelSummary summary;  ///< numbers about the displayed layout
};

/// Calls visit(state) for each state.
template <class Visit>
void visit_features(LayoutFeatures& of, const Visit& visit) {
  visit(of.tool);
  visit(of.table);
  visit(of.problems);
  visit(of.generate);
  visit(of.probe);
  visit(of.measure);
  visit(of.mesh);
  visit(of.summary);
}

/// States of the features that display or control a run.
struct SimulateFeatures {
  ExplainState explain;
  HuntState hunt;
  MapState map;
  HeatState heat;
  ModelsState models;
  CompareState compare;
  PerturbState perturb;
  FollowState follow;
  ControlsState controls;
  RealState real;
  VideoState video;
  PathState path;
  StudyState study;
  PlotState plot;
  SectionState section;
  Timeline timeline;
  BarsShown bars;
};

/// Calls visit(state) for each state.
template <class Visit>
void visit_features(SimulateFeatures& of, const Visit& visit) {
  visit(of.explain);
  visit(of.hunt);
  visit(of.map);
  visit(of.heat);
  visit(of.models);
  visit(of.compare);
  visit(of.perturb);
  visit(of.follow);
  visit(of.controls);
  visit(of.real);
  visit(of.video);
  visit(of.path);
  visit(of.study);
  visit(of.plot);
  visit(of.section);
  visit(of.timeline);
  visit(of.bars);
}

/// States of the window itself.
struct WindowFeatures {
  Appearance appearance;
  Arrangement arrangement;
  PanelsShown panels;
  MenuKeys menu_keys;
  PaletteState palette;
  HelpState help;
  TourState tour;
  DemoState demo;
  ProfileState profile;
  ViewShown view;
  Messages messages;
  FileDialog dialog;
  std::vector<FileNotice> notices;  ///< oldest first
  Recovery recovery;
  std::vector<ExampleTile> examples;  ///< examples with a picture, for the start card
  std::vector<std::string> recent;    ///< recently opened files, newest first; kept in the settings file
  WindowPlace place;                  ///< place on the screen; kept in the settings file
  std::string title;                  ///< title of the window
  bool full_screen = false;           ///< whether the window has no frame
  bool asks_unsaved = false;          ///< whether it asks to save before the document is left
};

/// Calls visit(state) for each state.
template <class Visit>
void visit_features(WindowFeatures& of, const Visit& visit) {
  visit(of.appearance);
  visit(of.arrangement);
  visit(of.panels);
  visit(of.menu_keys);
  visit(of.palette);
  visit(of.help);
  visit(of.tour);
  visit(of.demo);
  visit(of.profile);
  visit(of.view);
  visit(of.messages);
  visit(of.dialog);
  visit(of.notices);
  visit(of.recovery);
  visit(of.recent);
  visit(of.place);
  visit(of.title);
  visit(of.full_screen);
  visit(of.asks_unsaved);
}

}  // namespace taxel::ui
