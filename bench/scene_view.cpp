// Time of one frame of the 3-D view while the contact moves, and the cost of its parts: 800 x 560 pixels, 16000
// samples.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include "ui/gl/offscreen_context.h"
#include "ui/scene/finger_scene.h"

namespace taxel {
namespace {

constexpr int kFrames = 4;

/// Draws a finger that slides; `change` switches parts off or moves the camera.
template <class Change>
void draw_view(benchmark::State& state, const Change& change) {
  const gl::OffscreenContext context;
  ui::SceneRenderer renderer;
  const SensorModelPtr model = test::finger_model(16000);
  std::vector<ui::SceneInput> inputs;
  for (int i = 0; i < kFrames; ++i) inputs.push_back(test::finger_input(test::finger_frame(model, 0.002 + 0.0005 * i)));
  int n = 0;
  for (auto _ : state) {
    ui::SceneInput input = inputs[static_cast<std::size_t>(n++ % kFrames)];
    ui::Camera camera = test::finger_camera();
    change(input.overlays, camera, n);
    renderer.render(input, camera, 800, 560);
    glFinish();
  }
  state.SetLabel(context.renderer());
}

using ui::Camera;
using ui::Overlays;

void BM_view(benchmark::State& s) {
  draw_view(s, [](Overlays&, Camera&, int) {});
}
void BM_view_orbiting(benchmark::State& s) {
  draw_view(s, [](Overlays&, Camera& camera, int n) { camera.orbit(n % 100, 0); });
}
void BM_view_without_samples(benchmark::State& s) {
  draw_view(s, [](Overlays& o, Camera&, int) { o.samples = false; });
}
void BM_view_without_rays(benchmark::State& s) {
  draw_view(s, [](Overlays& o, Camera&, int) { o.rays = false; });
}
void BM_view_without_rings(benchmark::State& s) {
  draw_view(s, [](Overlays& o, Camera&, int) { o.receptive_fields = false; });
}
void BM_view_bodies_only(benchmark::State& s) {
  draw_view(s, [](Overlays& o, Camera&, int) {
    o.samples = o.rays = o.contact_surface = o.taxels = o.receptive_fields = o.path = false;
  });
}

BENCHMARK(BM_view)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_view_orbiting)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_view_without_samples)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_view_without_rays)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_view_without_rings)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(BM_view_bodies_only)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace taxel

BENCHMARK_MAIN();
