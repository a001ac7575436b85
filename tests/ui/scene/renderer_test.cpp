#include <gtest/gtest.h>

#include "ui/scene/finger_scene.h"
#include "ui/scene/picture.h"

namespace taxel {
namespace {

TEST(SceneRenderer, DrawsTheSweep) {
  test::context();
  ui::SceneRenderer renderer;
  const auto model = test::finger_model();
  ui::SceneInput input = test::finger_input(test::finger_frame(model, 0.003));
  renderer.render(input, test::finger_camera(), 800, 560);
  test::write_picture("sweep_dark", renderer.picture());
  input.dark = false;
  renderer.render(input, test::finger_camera(), 800, 560);
  test::write_picture("sweep_light", renderer.picture());
}

}  // namespace
}  // namespace taxel
