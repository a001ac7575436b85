// The states of the features that edit a layout.
#pragma once

#include "app/studio/features/generate/generate_state.h"
#include "app/studio/features/inspector/layout_problems.h"
#include "app/studio/features/inspector/material_state.h"
#include "app/studio/features/inspector/model_summary.h"
#include "app/studio/features/measure/measure_state.h"
#include "app/studio/features/mesh/mesh_state.h"
#include "app/studio/features/probe/probe_state.h"
#include "app/studio/features/table/table_state.h"
#include "app/studio/features/taxel/tool_state.h"

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
  MaterialState material;
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
  visit(of.material);
  visit(of.summary);
}

}  // namespace taxel::ui
