// Where text belongs in the 3-D view; the panel writes it.
#pragma once

#include <string>
#include <vector>

#include "ui/scene/scene_renderer.h"

namespace taxel::ui {

struct SceneLabel {
  std::string text;       ///< the taxel's id
  dvec2 pixel{0};         ///< from the upper left corner of the view: just past the tip of the taxel's arrow
  bool occluded = false;  ///< the taxel faces away, or something solid stands before it
  bool selected = false;
  int sensor = 0, taxel = 0;  ///< taxel in layout order
};

/// Labels of the taxels in the view, farthest first: as many as have room beside each other when the selected one comes
/// first, then those that face the eye, in an order that does not change with the camera. Of many taxels only those in
/// sight have one. `text_height` [pixel] is that of a digit's line. Empty where overlays.taxel_labels is off.
/// O(taxels), and a ray for each label.
std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     double text_height = 12);

}  // namespace taxel::ui
