// Tip and pad of the finger that is edited: arrows while they are a guess, and clicks on faces that set them.
#pragma once

#include <vector>

#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/mesh/mesh_state.h"
#include "app/studio/features/taxel/tool_state.h"

namespace taxel::ui {

struct FrameArrow {
  const char* name = "";     ///< "tip" or "pad"
  dvec3 from_W{0}, to_W{0};  ///< [m]
};

/// Arrows of tip and pad from the middle of the mesh to outside of it; empty unless they are a guess or are being set.
[[nodiscard]] std::vector<FrameArrow> frame_arrows(const Viewer& viewer, const Shown& displayed, const MeshState& mesh);

/// Makes an edit of both directions, which are then no guess any more.
void set_frame(WindowUi& ui, MeshState& mesh, const SensorFrame& frame);

/// The frame with the tip or the pad in a direction, or the file's axis within 25 degrees of the direction; the other
/// one stays at right angles.
[[nodiscard]] SensorFrame with_direction(SensorFrame frame, FramePick what, const dvec3& direction);

/// If a click is to set the tip or the pad, sets it to the direction of the face at a pixel of the view. Returns
/// whether the click was for that.
bool pick_frame(WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool, MeshState& mesh,
                double x, double y);

}  // namespace taxel::ui
