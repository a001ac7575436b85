// What leads the camera of SIMULATE beside the hand.
#pragma once

#include "ui/scene/pick/camera.h"

namespace taxel::ui {

struct FollowState {
  int camera = -1;               ///< of SceneMarks::cameras, through which the view looks; -1: none
  double depth = 1;              ///< from it to the middle of the scene, when it was chosen [m]
  Camera free;                   ///< as it was before that
  int body = -1;                 ///< that the camera goes along with; -1: none
  dvec3 point_B{0}, point_W{0};  ///< of that body: in its frame, and where it was in the last picture
};

}  // namespace taxel::ui
