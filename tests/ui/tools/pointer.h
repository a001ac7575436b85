// Events of a pointer over the 3-D view, for tools that are called without a window.
#pragma once

#include "app/studio/frame/pointer_event.h"

namespace taxel::ui::test {

/// A pointer over the view with no button down.
inline PointerEvent hover(const dvec2& at) {
  PointerEvent event;
  event.at = at;
  event.hovered = true;
  return event;
}

/// A button that goes down.
inline PointerEvent press(const dvec2& at, std::size_t button = 0) {
  PointerEvent event = hover(at);
  event.grabbed = event.any_down = true;
  event.buttons.at(button).down = event.buttons.at(button).pressed = true;
  return event;
}

/// A pointer that has moved by `delta` with a button down.
inline PointerEvent drag(const dvec2& at, const dvec2& delta, std::size_t button = 0) {
  PointerEvent event = press(at, button);
  event.delta = delta;
  event.buttons.at(button).pressed = false;
  event.buttons.at(button).moved = true;
  return event;
}

/// A button that goes up; `moved` after a drag.
inline PointerEvent release(const dvec2& at, bool moved = false, std::size_t button = 0) {
  PointerEvent event = hover(at);
  event.buttons.at(button).released = true;
  event.buttons.at(button).moved = moved;
  return event;
}

/// A wheel that turns by a number of notches.
inline PointerEvent wheel(const dvec2& at, double notches) {
  PointerEvent event = hover(at);
  event.wheel = notches;
  return event;
}

}  // namespace taxel::ui::test
