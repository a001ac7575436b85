// The pointer over the 3-D view in one frame, read from Dear ImGui in one place.
#pragma once

#include <array>

#include "app/studio/frame/viewer.h"
#include "core/base/math.h"

namespace taxel::ui {

/// One mouse button in one frame.
struct ButtonState {
  bool down = false;
  bool pressed = false;         ///< went down in this frame
  bool double_pressed = false;  ///< went down in this frame, shortly after an earlier press
  bool released = false;        ///< went up in this frame
  bool moved = false;           ///< has left the place where it went down, by more than a click tolerates

  [[nodiscard]] bool dragged() const { return down && moved; }
  /// Returns whether the button was pressed and released at the same place.
  [[nodiscard]] bool clicked() const { return released && !moved; }
};

struct PointerEvent {
  dvec2 at{0};            ///< position [pixels of the view]
  dvec2 delta{0};         ///< motion since the previous frame [pixels]
  double wheel = 0;       ///< notches of the wheel
  bool hovered = false;   ///< whether the pointer is over the view
  bool grabbed = false;   ///< whether a button went down over the view and is still down
  bool any_down = false;  ///< whether any button is down
  bool ctrl = false, shift = false, alt = false;
  std::array<ButtonState, 3> buttons;  ///< left, right, middle

  [[nodiscard]] const ButtonState& left() const { return buttons[0]; }
  [[nodiscard]] const ButtonState& right() const { return buttons[1]; }
  [[nodiscard]] const ButtonState& middle() const { return buttons[2]; }
};

/// Reads the pointer over the view's item, which is the last one that was laid out.
[[nodiscard]] PointerEvent read_pointer(const ViewPlace& place);

/// Returns whether the pointer rests over the view's item long enough for a tooltip, with no button down.
[[nodiscard]] bool is_pointer_resting();

}  // namespace taxel::ui
