// The active tool on the layout and its gesture. Each gesture is one step of the history.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/frame/viewer.h"
#include "core/layout/layout.h"

namespace taxel::ui {

enum class Tool {
  none,
  place,      ///< every click adds a taxel
  slide,      ///< drags a selected taxel along the surface
  move,       ///< moves taxels with the pointer along the surface, or along an axis
  turn,       ///< turns normals about the line of sight or an axis
  resize,     ///< changes radii
  way_point,  ///< moves the selected waypoint of a scenario's path
  box,        ///< selects the taxels in a rectangle
  lasso,      ///< selects the taxels in a closed path
  brush       ///< paints the sensing region
};

struct BrushState {
  double radius = 0;          ///< chosen radius [m], or 0
  bool painting = false;      ///< whether a stroke is being drawn
  bool erases = false;        ///< whether the stroke erases
  std::vector<int> region;    ///< region with the stroke so far
  std::optional<dvec2> last;  ///< pointer in the previous frame [pixels of the view]
};

/// The inputs of a gesture. A change of the inputs requests an edit.
struct GestureInput {
  dvec2 pointer{0};  ///< pointer [pixels of the view], slowed down while Shift is held
  int axis = -1;     ///< 0, 1, 2: x, y, z of the mesh file (waypoint: of the world); -1: free
  std::string typed;
  bool snap = false, precise = false;
  bool operator==(const GestureInput&) const = default;
};

struct ToolState {
  using PerDocument = ToolState;  ///< another document resets all of it
  Tool tool = Tool::none;
  std::uint64_t gesture = 0;  ///< number in the history of the present or last gesture
  GestureInput input;
  std::optional<GestureInput> done;  ///< inputs of the last edit
  dvec2 pointer_start{0};
  std::vector<Taxel> start;  ///< changed taxels before the gesture, the active one last
  bool adds = false;         ///< whether the taxels are copies that the gesture adds
  Selection selection;       ///< selection before the gesture
  std::string value;         ///< displayed text, such as "1.50 mm along X"
  std::string problem;       ///< reason why the edit is not possible

  int pressed_taxel = -1;   ///< id of the selected taxel under the left button's press, or -1
  bool released = true;     ///< whether the button that ended the gesture is released
  std::vector<dvec2> area;  ///< fixed corner of the box, or the lasso's path [pixels of the view]
  BrushState brush;
  double wheel_at = -1;  ///< interface time of the last change of the radius by the wheel [s]
  double radius = 0;     ///< radius of the last placed taxel [m], or 0

  /// Returns whether the tool follows pointer and keys until it is accepted or cancelled.
  [[nodiscard]] bool follows() const {
    return tool == Tool::slide || tool == Tool::move || tool == Tool::turn || tool == Tool::resize ||
           tool == Tool::way_point;
  }
};

}  // namespace taxel::ui
