// Places of text in the 3-D view; the panel writes the text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/scene/camera.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct SceneLabel {
  std::string text;  ///< id of a taxel, net force, or name of a part of the scene
  /// Position from the upper left corner of the view: past the tip of an arrow, or at the place of a part. A label with
  /// a leader is farther away, because another label is there.
  dvec2 pixel{0};
  std::optional<dvec2> leader;  ///< pixel that a line joins with the label, or nothing without a line
  bool occluded = false;        ///< the taxel faces away, or something solid hides it
  bool selected = false;
  int sensor = 0, taxel = -1;  ///< taxel in layout order, or -1 for a force or a part of the scene
};

/// Returns the labels in the view, farthest first. Labels are placed as long as they do not overlap others: first the
/// parts of the scene that overlays.labels selects, the nearest first; then the net forces; then, if
/// overlays.taxel_labels is on, taxels. If all taxels have marks, these are the selected taxel and the taxels that face
/// the eye, in an order that does not depend on the camera; if there are many, only visible ones. Otherwise these are
/// marked_taxels(), the hovered and selected ones first, then those with the largest readings; where labels would
/// overlap they are moved and get leaders. The id of a taxel follows the name of its sensor if there are several.
/// `text_height` is the height of a line of digits [pixel]. Cost: O(taxels), and a ray for each label.
std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     double text_height = 12);

}  // namespace taxel::ui
