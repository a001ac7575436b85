// Tip and pad direction of the edited finger: arrows while the directions are a guess, and clicks on faces set them.
#pragma once

#include <vector>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/taxel/tool_state.h"

namespace taxel::ui {

struct FrameArrow {
  const char* name = "";     ///< "tip" or "pad"
  dvec3 from_W{0}, to_W{0};  ///< [m]
};

/// Returns the arrows of tip and pad from the middle of the mesh to outside of the mesh. Empty unless the directions
/// are a guess or are being set.
[[nodiscard]] std::vector<FrameArrow> frame_arrows(const Viewer& viewer, const Shown& displayed, const MeshState& mesh);

/// Posts an edit that sets both directions. After the edit, the directions are no longer a guess.
void set_frame(WindowUi& ui, MeshState& mesh, const SensorFrame& frame);

/// Returns the frame with the tip or the pad in a direction, or along the file's axis if that axis is within 25 degrees
/// of the direction. The other direction stays at right angles.
[[nodiscard]] SensorFrame with_direction(SensorFrame frame, FramePick what, const dvec3& direction);

/// Sets the tip or the pad to the direction of the face at a pixel of the view, if the next click is to set one of
/// them. Returns whether the click was used.
bool pick_frame(WindowUi& ui, const Viewer& viewer, const Shown& shown, const ToolState& tool, MeshState& mesh,
                double x, double y);

/// The directions of the finger, which a click on a face sets.
extern const Feature kMeshFrame;

}  // namespace taxel::ui
