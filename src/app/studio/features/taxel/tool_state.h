// What the hand is doing to the layout: one gesture at a time, which is one step of the history.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/app/values/selection.h"
#include "core/layout/layout.h"

namespace taxel::ui {

enum class Tool {
  none,
  place,      ///< every click adds a taxel
  slide,      ///< a selected taxel is dragged along the surface
  move,       ///< follows the pointer along the surface, or along an axis
  turn,       ///< normals, about the line of sight or an axis
  resize,     ///< radii
  way_point,  ///< moves the selected one of a scenario's path
  box,        ///< selects what lies in a rectangle
  lasso,      ///< selects what lies in a closed path
  brush       ///< paints the region
};

struct BrushState {
  double radius = 0;          ///< [m]; 0: not chosen yet
  bool painting = false;      ///< a stroke is being drawn
  bool erases = false;        ///< what it does
  std::vector<int> region;    ///< as the stroke has left it so far
  std::optional<dvec2> last;  ///< where it was in the picture before [pixels of the view]
};

/// All that decides what a gesture does; an edit is made when it changes.
struct GestureInput {
  dvec2 pointer{0};  ///< in pixels of the view; slower than the hand while Shift is held
  int axis = -1;     ///< 0 x, 1 y, 2 z of the mesh file, or of the world for a way point; -1: free
  std::string typed;
  bool snap = false, precise = false;
  bool operator==(const GestureInput&) const = default;
};

struct ToolState {
  using PerDocument = ToolState;  ///< another document resets all of it
  Tool tool = Tool::none;
  std::uint64_t gesture = 0;  ///< as the history numbers them; of this tool, or of the one before
  GestureInput input;
  std::optional<GestureInput> done;  ///< what the last edit was made from
  dvec2 pointer_start{0};
  std::vector<Taxel> start;  ///< the taxels that it changes as they were, the active one last
  bool adds = false;         ///< they are copies that the gesture adds
  Selection selection;       ///< before it began
  std::string value;         ///< what it does now, for the eye: "1.50 mm along X"
  std::string problem;       ///< why that cannot be

  int pressed_taxel = -1;   ///< id of a selected taxel on which the left button went down; -1: none
  bool released = true;     ///< the button of a gesture that has ended is up again
  std::vector<dvec2> area;  ///< corner of the box that stays, or the lasso's path [pixels of the view]
  BrushState brush;
  double wheel_at = -1;  ///< when the radius was last changed by the wheel: interface time [s]
  double radius = 0;     ///< of the taxel that was placed last [m]; 0: none yet

  /// A gesture that follows pointer and keys until it is accepted or cancelled.
  [[nodiscard]] bool follows() const {
    return tool == Tool::slide || tool == Tool::move || tool == Tool::turn || tool == Tool::resize ||
           tool == Tool::way_point;
  }
};

}  // namespace taxel::ui
