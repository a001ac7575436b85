// The demo: the start's fingertip sweep, played in a loop under a camera that sways around the contact.
#pragma once

#include <optional>

#include "ui/scene/pick/camera.h"

namespace taxel::ui {

struct DemoState {
  bool runs = false;            ///< whether the demo plays; the first key, click or turn of the wheel ends it
  double seconds = 0;           ///< time since the camera began to sway [s]
  std::optional<Camera> start;  ///< the camera when the sway began; empty before the contact is displayed
  bool invites = false;         ///< whether the caption with the next steps is displayed
  bool loops = false;           ///< whether the demo has begun the loop over the recorded steps
};

}  // namespace taxel::ui
