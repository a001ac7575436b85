// The state of the window as JSON: what --dump-state writes and tests compare with the picture.
#pragma once

#include <optional>
#include <string>

#include "ui/scene/pick/camera.h"

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Pictures since the program began or since the last dump.
struct Pace {
  int pictures = 0;
  double seconds = 0;        ///< wall time they took
  double worst_seconds = 0;  ///< of one picture
  int scene_draws = 0;       ///< of the 3-D view
};

/// Pixels are of the window, from its top left corner. SI units; keys carry full names.
std::string state_to_json(const ui::App& app, const Pace& pace);

/// The camera of SIMULATE in such a text; none: it is of LAYOUT, or no such text.
std::optional<ui::Camera> camera_of_state(const std::string& json);

}  // namespace taxel::studio
