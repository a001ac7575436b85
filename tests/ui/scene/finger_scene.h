// A fingertip over the edge of a box, without MuJoCo: the same frames that a simulation would publish.
#pragma once

#include "ui/scene/scene_renderer.h"

namespace taxel::test {

/// Twelve taxels on the project's fingertip; about `samples` samples.
SensorModelPtr finger_model(int samples = 15000);

/// The finger tilted by 45 degrees, its lowest point `travel` past the box's edge and 1.5 mm below its top: contact,
/// rays and readings as computed by the core.
SimFramePtr finger_frame(const SensorModelPtr& model, double travel);

/// A frame of the sweep as the window shows it: pressure range fitted to the contact.
ui::SceneInput finger_input(const SimFramePtr& frame);

/// Looks at the contact from above and the side.
ui::Camera finger_camera();

}  // namespace taxel::test
