// The edit that a gesture makes from its initial taxels. The functions are pure: equal pointers and equal numbers give
// equal edits, whatever came in between.
#pragma once

#include <optional>
#include <string>

#include "app/studio/frame/pointer_event.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "core/document/edit.h"
#include "ui/scene/camera.h"

namespace taxel::ui {

/// The view of the taxels during a gesture.
struct GestureView {
  Camera camera;
  int width = 0, height = 0;  ///< [pixels]
  Pose X_WM;
  const MeshIndex* skin = nullptr;

  [[nodiscard]] Ray ray_M(const dvec2& pixel) const;
  [[nodiscard]] dvec2 pixel_of(const dvec3& p_M) const;
  [[nodiscard]] bool faces_eye(const Taxel& taxel) const;
};

struct GestureEdit {
  std::optional<Edit> edit;  ///< edit of the gesture; empty if none is possible at the pointer
  std::string value;         ///< displayed text, such as "1.50 mm along X"
};

/// Returns the number typed so far; empty if the text is not a number yet ("", "-", ".").
std::optional<double> typed_number(const std::string& typed);

/// Returns the distance by which the pointer, or the typed number, moves a point along an axis of frame M [m].
double distance_along(const GestureInput& input, const dvec2& pointer_start, const GestureView& view, const dvec3& p_M,
                      int axis);
/// Returns a length, snapped while Ctrl is held.
double snapped_length(double metres, const GestureInput& input);
std::string along_text(double metres, int axis);  ///< returns "1.500 mm along X"

GestureEdit gesture_edit(const ToolState& tool, const GestureView& view);

}  // namespace taxel::ui
