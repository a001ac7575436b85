// Legends of the overlays about receptive fields and repair: what their colours mean, with numbers.
#pragma once

#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/mesh/mesh_state.h"

namespace taxel::ui {

/// In the lower right corner of the view, one above the other, the lowest ending at `bottom` [pixel of the window].
void draw_field_legends(const WindowUi& ui, const ViewPlace& place, const FieldNumbers& numbers,
                        const SensorModel& model, float bottom);

/// What the colours of a repair's changes mean, in the upper right corner of the view, beginning at `top`.
void draw_repair_legend(const WindowUi& ui, const Viewer& viewer, const MeshState& mesh, const SensorModel& model,
                        float top);

}  // namespace taxel::ui
