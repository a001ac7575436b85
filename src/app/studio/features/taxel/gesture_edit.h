// What a gesture makes of the taxels it began with: pure, so that the same pointer and the same numbers give the same
// edit, whatever way they took.
#pragma once

#include <optional>
#include <string>

#include "app/studio/app/pointing/surface_place.h"
#include "app/studio/features/taxel/tool_state.h"
#include "core/document/edit.h"
#include "ui/scene/pick/camera.h"

namespace taxel::ui {

/// How the taxels are seen while they are changed.
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
  std::optional<Edit> edit;  ///< none: the pointer is where nothing can be done
  std::string value;         ///< for the eye: "1.50 mm along X"
};

/// The number typed so far; none: nothing or no number yet ("-", ".").
std::optional<double> typed_number(const std::string& typed);

/// How far the pointer, or the number typed, takes a point along an axis of frame M [m].
double distance_along(const GestureInput& input, const dvec2& pointer_start, const GestureView& view, const dvec3& p_M,
                      int axis);
/// A length as Ctrl snaps it.
double snapped_length(double metres, const GestureInput& input);
std::string along_text(double metres, int axis);  ///< "1.500 mm along X"

GestureEdit gesture_edit(const ToolState& tool, const GestureView& view);

}  // namespace taxel::ui
