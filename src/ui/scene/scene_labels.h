// Places of text in the 3-D view; the panel writes the text.
#pragma once

#include <string>
#include <vector>

#include "ui/scene/pick/camera.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct SceneLabel {
  std::string text;  ///< the taxel's id, or the name of a part of the scene
  /// Position from the upper left corner of the view: past the tip of a taxel's arrow, or at the place of a part.
  dvec2 pixel{0};
  bool occluded = false;  ///< the taxel faces away, or something solid hides it
  bool selected = false;
  int sensor = 0, taxel = -1;  ///< taxel in layout order; -1: of a part
};

/// Labels of the taxels in the view, farthest first: as many as fit without overlap when the selected taxel comes
/// first, then those that face the eye, in an order that does not change with the camera. Of many taxels only those in
/// sight have one: where overlays.taxel_labels is on. Parts that overlays.labels asks for come before all taxels, the
/// nearest first. `text_height` [pixel] is that of a digit's line. O(taxels), and a ray for each label.
std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     double text_height = 12);

}  // namespace taxel::ui
