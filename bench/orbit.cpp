// Time of one frame of the 3-D view while the camera orbits around a layout, by the numbers of taxels and samples, and
// the cost of its parts, including the labels next to the taxels. 704 x 474 pixels: the view in a window of 1280 x 800.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include "core/layout/generators/arrays.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/sensor_model.h"
#include "ui/gl/offscreen_context.h"
#include "ui/scene/scene_labels.h"
#include "ui/scene/scene_renderer.h"

namespace taxel {
namespace {

constexpr int kWidth = 704, kHeight = 474;

/// Returns taxels along a helix around the fingertip. Each field has three times the area of the skin per taxel.
SensorModelPtr make_model(int taxels, int samples) {
  const auto mesh = std::make_shared<const TriMesh>(make_fingertip());
  const MeshIndex skin(mesh);
  const Aabb& box = mesh->bounds();
  AroundAxis around;
  around.count = taxels;
  around.origin = dvec3(box.center().x, box.center().y, 0);
  around.radius = std::sqrt(3 * mesh->area() / (kPi * taxels));
  Layout layout;
  layout.mesh.file = "fingertip.obj";
  layout.sampling.density = samples / mesh->area();
  const double height = box.hi.z - box.lo.z;
  layout.taxels = helix(around, box.lo.z + 0.05 * height, box.lo.z + 0.97 * height, std::sqrt(0.3 * taxels), skin);
  SensorBuild how;
  how.quality = SampleQuality::preview;
  return build_sensor_model(layout, mesh, "", "helix.taxels.json", how);
}

using ui::Overlays;

template <class Change>
void orbit(benchmark::State& state, const Change& change) {
  const gl::OffscreenContext context;
  ui::SceneRenderer renderer;
  ui::SceneInput input;
  input.document_model = make_model(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  change(input.overlays);
  ui::Camera camera;
  camera.frame(input.document_model->mesh->bounds());
  const auto picture = [&] {
    camera.orbit(3, 0);
    renderer.render(input, camera, kWidth, kHeight);
    benchmark::DoNotOptimize(ui::scene_labels(input, camera, kWidth, kHeight));
    glFinish();
  };
  for (int i = 0; i < 3; ++i) picture();  // compiles shaders and fills buffers
  for (auto _ : state) picture();
  state.SetLabel(context.renderer());
}

void BM_orbit(benchmark::State& s) {
  orbit(s, [](Overlays&) {});
}
void BM_orbit_solid_skin(benchmark::State& s) {
  orbit(s, [](Overlays& o) { o.sensor_transparent = false; });
}
void BM_orbit_without_fields(benchmark::State& s) {
  orbit(s, [](Overlays& o) { o.receptive_fields = false; });
}
void BM_orbit_without_samples(benchmark::State& s) {
  orbit(s, [](Overlays& o) { o.samples = false; });
}
void BM_orbit_without_taxels(benchmark::State& s) {
  orbit(s, [](Overlays& o) { o.taxels = o.taxel_labels = false; });
}
void BM_orbit_skin_only(benchmark::State& s) {
  orbit(s, [](Overlays& o) { o.taxels = o.taxel_labels = o.receptive_fields = o.samples = false; });
}

void layouts(benchmark::internal::Benchmark* b) {
  b->ArgNames({"taxels", "samples"})->Args({12, 17'000})->Args({1000, 100'000})->Args({5000, 17'000});
  b->Unit(benchmark::kMillisecond)->Iterations(20)->UseRealTime()->MeasureProcessCPUTime();
}
BENCHMARK(BM_orbit)->Apply(layouts);
BENCHMARK(BM_orbit_solid_skin)->Apply(layouts);
BENCHMARK(BM_orbit_without_fields)->Apply(layouts);
BENCHMARK(BM_orbit_without_samples)->Apply(layouts);
BENCHMARK(BM_orbit_without_taxels)->Apply(layouts);
BENCHMARK(BM_orbit_skin_only)->Apply(layouts);

}  // namespace
}  // namespace taxel

BENCHMARK_MAIN();
