// The fixture of pictures of the finger on the box's edge, seen from above.
#pragma once

#include <gtest/gtest.h>

#include "ui/scene/finger_scene.h"
#include "ui/scene/picture.h"

namespace taxel::ui {

/// Holds the model and the frame, which are made once for all tests of a suite, and a renderer.
class FingerView : public ::testing::Test {
 protected:
  static constexpr int kWidth = 800, kHeight = 560;

  static void SetUpTestSuite() {
    test::context();
    model_ = test::finger_model();
    frame_ = test::finger_frame(model_, 0.003);
  }
  static void TearDownTestSuite() {
    model_.reset();
    frame_.reset();
  }
  gl::RgbImage draw(const SceneInput& input, const Camera& camera, int width = kWidth, int height = kHeight) {
    renderer_.render(input, camera, width, height);
    return renderer_.picture();
  }
  static Camera from_above() {
    Camera camera = test::finger_camera();
    camera.elevation_deg = 55;
    camera.target = {-0.022, 0, 0};
    camera.distance = 0.03;
    return camera;
  }

  inline static SensorModelPtr model_;
  inline static SimFramePtr frame_;
  SceneRenderer renderer_;
};

}  // namespace taxel::ui
