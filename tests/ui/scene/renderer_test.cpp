#include <epoxy/gl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>

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

TEST(SceneRenderer, DISABLED_FrameTime) {
  test::context();
  ui::SceneRenderer renderer;
  const auto model = test::finger_model(16000);
  std::vector<ui::SceneInput> inputs;
  for (int i = 0; i < 4; ++i) inputs.push_back(test::finger_input(test::finger_frame(model, 0.002 + 0.0005 * i)));
  fmt::print("faces {} samples {} rays {} polygons {}\n", model->mesh->face_count(), model->samples.size(), model->rays.size(),
             inputs[2].frame->sensors[0].surfaces[0].polygons.size());
  const auto run = [&](const std::string& name, auto change) {
    if (getenv("ONLY") && name != getenv("ONLY")) return;
    std::vector<double> ms;
    const auto cpu0 = std::clock();
    for (int i = 0; i < 60; ++i) {
      ui::SceneInput input = inputs[static_cast<std::size_t>(i % 4)];
      change(input.overlays);
      const auto start = std::chrono::steady_clock::now();
      renderer.render(input, test::finger_camera(), 800, 560);
      glFinish();
      ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(ms.begin(), ms.end());
    fmt::print("{:20} min {:6.2f} median {:6.2f} ms, cpu {:6.2f} ms\n", name, ms[0], ms[30], 1000.0 * static_cast<double>(std::clock() - cpu0) / CLOCKS_PER_SEC / 60);
  };
  using O = ui::Overlays;
  run("all", [](O&) {});
  run("no samples", [](O& o) { o.samples = false; });
  run("no rays", [](O& o) { o.rays = false; });
  run("no contact", [](O& o) { o.contact_surface = false; });
  run("no taxels", [](O& o) { o.taxels = false; });
  run("no rings", [](O& o) { o.receptive_fields = false; });
  run("no grid", [](O& o) { o.grid = false; });
  run("solid skin", [](O& o) { o.sensor_transparent = false; });
  run("none", [](O& o) { o.samples = o.rays = o.contact_surface = o.taxels = o.receptive_fields = o.grid = o.path = false; });
}

}  // namespace
}  // namespace taxel
