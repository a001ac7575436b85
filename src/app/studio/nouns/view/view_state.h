// The image that the 3-D view drew last, as numbers.
#pragma once

#include <vector>

#include "ui/scene/field_numbers.h"
#include "ui/scene/pick/camera.h"
#include "ui/scene/scene_input.h"
#include "ui/scene/scene_labels.h"

namespace taxel::ui {

/// Number of clicks in the view since the start.
struct Clicks {
  int left = 0, left_double = 0, right = 0, right_double = 0;
};

/// The input of the last image. The view is drawn again when it changes.
struct ViewShown {
  SceneInput input;
  Camera camera;
  std::vector<SceneLabel> labels;  ///< labels of the image
  FieldNumbers numbers;            ///< figures of the image's overlays
  bool drawn = false;
  int draws = 0;
  Clicks clicks;
};

}  // namespace taxel::ui
