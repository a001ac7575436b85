// State of the window as JSON, which --dump-state writes and tests compare with the frame.
#pragma once

#include <optional>
#include <string>

#include "ui/scene/camera.h"

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Frame timing since the program began or since the last dump.
struct Pace {
  int pictures = 0;          ///< number of frames
  double seconds = 0;        ///< wall time of all frames
  double worst_seconds = 0;  ///< wall time of the slowest frame
  int scene_draws = 0;       ///< number of times that the 3-D view was drawn
};

/// Returns the state of the window. Pixels are relative to the window's top left corner. Values are in SI units; keys
/// carry full names.
std::string state_to_json(const ui::App& app, const Pace& pace);

/// Returns the camera of SIMULATE in the text of a state; empty if the state is of LAYOUT or the text is not a state.
std::optional<ui::Camera> camera_of_state(const std::string& json);

}  // namespace taxel::studio
