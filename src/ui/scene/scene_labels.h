// Places of text in the 3-D view; the panel writes the text.
#pragma once

#include <string>
#include <vector>

#include "ui/scene/pick/camera.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct SceneLabel {
  std::string text;  ///< id of a taxel, or name of a part of the scene
  /// Position from the upper left corner of the view: past the tip of a taxel's arrow, or at the place of a part.
  dvec2 pixel{0};
  bool occluded = false;  ///< the taxel faces away, or something solid hides it
  bool selected = false;
  int sensor = 0, taxel = -1;  ///< taxel in layout order, or -1 for a part of the scene
};

/// Returns the labels in the view, farthest first. Labels are placed as long as they do not overlap others: first the
/// parts of the scene that overlays.labels selects, the nearest first; then, if overlays.taxel_labels is on, the
/// selected taxel and the taxels that face the eye, in an order that does not depend on the camera. If there are many
/// taxels, only visible ones have labels. `text_height` is the height of a line of digits [pixel]. Cost: O(taxels), and
/// a ray for each label.
std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     double text_height = 12);

}  // namespace taxel::ui
