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

/// Labels of all taxels in the view, farthest first. Empty where overlays.taxel_labels is off.
std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height);

}  // namespace taxel::ui
