// Legends of the overlays of receptive fields and repair: the meaning of their colours, with numbers.
#pragma once

#include "app/studio/frame/feature.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/mesh/mesh_state.h"

namespace taxel::ui {

/// Draws the legends in the lower right corner of the view, one above the other. The lowest legend ends at `bottom`
/// [pixel of the window].
void draw_field_legends(const WindowUi& ui, const ViewPlace& place, const FieldNumbers& numbers,
                        const SensorModel& model, float bottom);

/// Draws the meaning of the colours of a repair's changes, in the upper right corner of the view, beginning at `top`
/// [pixel of the window].
void draw_repair_legend(const WindowUi& ui, const Viewer& viewer, const MeshState& mesh, const SensorModel& model,
                        float top);

/// The receptive fields of the taxels.
extern const Feature kFields;

}  // namespace taxel::ui
