// The 3-D view as the user set it: mode, cameras, selection, overlays, range of colours and clip plane.
#pragma once

#include <array>
#include <optional>

#include "app/studio/app/command.h"
#include "app/studio/app/values/selection.h"
#include "ui/scene/pick/camera.h"
#include "ui/scene/pick/picking.h"
#include "ui/scene/scene_input.h"
#include "ui/widgets/widget_registry.h"

namespace taxel::ui {

/// The place of the 3-D view in the window, and the size of its texture.
struct ViewPlace {
  Rect rect;
  int width = 0, height = 0;  ///< size of the texture [pixels]
};

struct Viewer {
  Mode mode = Mode::simulate;
  std::array<Camera, 2> cameras;  ///< one per mode
  Selection selection;
  Overlays overlays;
  PressureRange range;
  std::optional<ClipPlane> clip;
  std::optional<Pick> hovered;  ///< the object under the resting pointer
  ViewPlace view;

  [[nodiscard]] Camera& camera() { return cameras[mode == Mode::layout ? 0 : 1]; }
  [[nodiscard]] const Camera& camera() const { return cameras[mode == Mode::layout ? 0 : 1]; }
  /// Returns the pixel of the view that shows a point, and the depth of the point.
  [[nodiscard]] dvec3 project(const dvec3& p_W) const { return camera().project(p_W, view.width, view.height); }
};

/// Selects a taxel that was clicked: alone, or with Shift in addition, or no longer if it was selected.
inline void click_taxel(Selection& selection, int id, bool shift) {
  shift ? selection.toggle(id) : selection.set(id);
}

}  // namespace taxel::ui
