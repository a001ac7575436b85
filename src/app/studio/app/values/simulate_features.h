// The states of the features that display or control a run.
#pragma once

#include "app/studio/features/bars/bars_state.h"
#include "app/studio/features/bars/error_bars_state.h"
#include "app/studio/features/camera/follow_state.h"
#include "app/studio/features/compare/compare_state.h"
#include "app/studio/features/data_set/data_set_state.h"
#include "app/studio/features/explain/explain_state.h"
#include "app/studio/features/explain/hunt_state.h"
#include "app/studio/features/heat/heat_state.h"
#include "app/studio/features/map/map_state.h"
#include "app/studio/features/models/models_state.h"
#include "app/studio/features/perturb/perturb_state.h"
#include "app/studio/features/plot/plot_state.h"
#include "app/studio/features/real/real_state.h"
#include "app/studio/features/scenario/path_state.h"
#include "app/studio/features/scene/controls_state.h"
#include "app/studio/features/section/section_state.h"
#include "app/studio/features/study/study_state.h"
#include "app/studio/features/timeline/timeline_state.h"
#include "app/studio/features/video/video_state.h"

namespace taxel::ui {

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
  DataSetState data_set;
  PlotState plot;
  SectionState section;
  Timeline timeline;
  BarsShown bars;
  ErrorBarsState error_bars;
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
  visit(of.data_set);
  visit(of.plot);
  visit(of.section);
  visit(of.timeline);
  visit(of.bars);
  visit(of.error_bars);
}

}  // namespace taxel::ui
