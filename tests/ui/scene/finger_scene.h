// A fingertip over the edge of a box without MuJoCo, with the frames that a simulation would publish.
#pragma once

#include "ui/scene/scene_renderer.h"

namespace taxel::test {

/// Returns a model of twelve taxels on the project's fingertip with about `samples` samples.
SensorModelPtr finger_model(int samples = 15000);

/// Returns the frame of a finger tilted by 45 degrees, with its lowest point `travel` past the box's edge and 1.5 mm
/// below the box's top. The core computes contact, rays and readings.
SimFramePtr finger_frame(const SensorModelPtr& model, double travel);

/// Returns the scene of a frame of the sweep as in the window, with the pressure range fitted to the contact.
ui::SceneInput finger_input(const SimFramePtr& frame);

/// Returns a camera that looks at the contact from above and the side.
ui::Camera finger_camera();

}  // namespace taxel::test
