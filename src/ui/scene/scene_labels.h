// Places of text in the 3-D view; the panel writes the text.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/scene/camera.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct SceneLabel {
  std::string text;  ///< id of a taxel, net force, or name of a part of the scene
  /// Middle of the text from the upper left corner of the view: past the tip of an arrow, or at the place of a part. A
  /// label with a leader is farther away, because another label is there.
  dvec2 pixel{0};
  dvec2 half{0};                ///< half of the text's box [pixel]
  std::optional<dvec2> leader;  ///< pixel that a line joins with the label, or nothing without a line
  int slot = 0;                 ///< place around the own one, or 0 without a leader
  double reading = 0;           ///< reading of the taxel that its order follows
  bool occluded = false;        ///< the taxel faces away, or something solid hides it
  bool selected = false;
  int sensor = 0, taxel = -1;  ///< taxel in layout order, or -1 for a force or a part of the scene
};

/// A box of the view [pixel].
struct LabelBox {
  dvec2 lo{0}, hi{0};
  bool operator==(const LabelBox&) const = default;
};

/// The room for labels: the size of texts, and the boxes that they have to avoid.
struct LabelRoom {
  double text_height = 12;                               ///< height of a line of text [pixel]
  std::function<double(const std::string&)> width = {};  ///< width of a text [pixel]; if empty, digits are assumed
  std::span<const LabelBox> covered = {};                ///< boxes that other texts of the view cover
  std::span<const SceneLabel> previous = {};             ///< labels of the previous frame; keep their places
};

/// Returns the labels in the view, farthest first. A label is whole inside of the view, and is placed only if it does
/// not overlap an earlier one or a covered box. The order is: hovered and selected taxels; the parts of the scene that
/// overlays.labels selects, the nearest first; the net forces, the largest first, without those below a hundredth of
/// the largest; then, if overlays.taxel_labels is on, the other taxels, those with the largest readings first. If all
/// taxels have marks, these are the taxels that face the eye, and where readings are equal their order does not depend
/// on the camera; if there are many, only visible ones. Otherwise these are marked_taxels(), which are moved and get
/// leaders where they would overlap. The order of labels of the previous frame follows a reading only
/// when it has changed by a third, and they yield only to a reading that is larger by a third and keep their places
/// around their taxels, so that labels do not jump while readings vary. The id of a taxel follows the
/// name of its sensor if there are several. Cost: O(taxels), and a ray for each label.
std::vector<SceneLabel> scene_labels(const SceneInput& input, const Camera& camera, int width, int height,
                                     const LabelRoom& room = {});

}  // namespace taxel::ui
