// The camera or the body that the view of SIMULATE follows.
#pragma once

#include "ui/scene/pick/camera.h"

namespace taxel::ui {

struct FollowState {
  int camera = -1;               ///< index in SceneMarks::cameras of the view's camera, or -1
  double depth = 1;              ///< camera to the middle of the scene when it was chosen [m]
  Camera free;                   ///< the view's camera before a camera of the scene was chosen
  int body = -1;                 ///< body that the camera follows, or -1
  dvec3 point_B{0}, point_W{0};  ///< followed point: in the body frame, and in the world at the last frame
};

}  // namespace taxel::ui
