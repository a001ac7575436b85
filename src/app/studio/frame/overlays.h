// The overlays of the 3-D view that can be turned on and off: one row each.
#pragma once

#include <span>

#include "app/studio/frame/keymap.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

/// One overlay: its key in the settings file, its menu entry and its value. Its default is the member's own.
struct OverlaySpec {
  const char* key;
  const char* label;
  bool Overlays::*on;
  int chord = 0;
  Context context = Context::everywhere;
};
/// All overlays; the View menu lists them in this order.
std::span<const OverlaySpec> overlays();

}  // namespace taxel::ui
