// Time of one evaluation of the fingertip sensor, by its parts: contact surface, traction, reading. In the same run,
// the time of the contact surface by the brute force of the tests (every tet against every triangle).
#include <benchmark/benchmark.h>

#include "core/hydro/hydro_body.h"
#include "core/hydro/intersect.h"
#include "core/hydro/traction.h"
#include "core/sensor/readout/reading.h"
#include "core/sensor/sensor_model.h"
#include "fixtures/brute_force_contact.h"

namespace {
using namespace taxel;

/// The finger tilted by 45 degrees, pressed onto a box's edge.
struct Press {
  SensorModelPtr model;
  HydroBodyPtr box = make_body({ShapeType::box, dvec3(0.025)}, Material{.friction = 0.5}, "box");
  Pose X_WM, X_WB;

  explicit Press(double depth, Aggregate aggregate = Aggregate::weighted_mean,
                 ReadingMethod method = ReadingMethod::samples)
      : model(load_sensor_model(TAXEL_SOURCE_DIR "/assets/layouts/fingertip.taxels.json")) {
    if (aggregate != model->layout.readout.aggregate || method != model->layout.readout.method) {
      Layout layout = model->layout;
      layout.readout.aggregate = aggregate;
      layout.readout.method = method;
      model = build_sensor_model(layout, model->mesh, layout.mesh.sha256, "fingertip");
    }
    X_WM.q = glm::angleAxis(0.75 * kPi, dvec3(1, 0, 0));  // tip (+z) and pad (-y) both face down
    double lowest = 1.0;
    dvec3 at{0};
    for (const dvec3& v : model->mesh->vertices()) {
      const dvec3 p = X_WM.rotate(v);
      if (p.z < lowest) {
        lowest = p.z;
        at = p;
      }
    }
    X_WM.p = dvec3(-at.x, -at.y, -lowest - depth);
    X_WB.p = dvec3(0, 0.023, -0.025);  // the edge is 2 mm from the lowest point
  }
};

void contact_surface(benchmark::State& state) {
  const Press press(1e-6 * static_cast<double>(state.range(0)));
  ContactSurface surface;
  IntersectWorkspace workspace;
  for (auto _ : state) intersect(*press.model->body, *press.box, press.X_WM, press.X_WB, surface, workspace);
  state.counters["polygons"] = static_cast<double>(surface.polygons.size());
}
BENCHMARK(contact_surface)->Arg(1500)->Arg(2600)->Unit(benchmark::kMicrosecond);

void contact_traction(benchmark::State& state) {
  const Press press(1e-6 * static_cast<double>(state.range(0)));
  ContactSurface surface;
  IntersectWorkspace workspace;
  intersect(*press.model->body, *press.box, press.X_WM, press.X_WB, surface, workspace);
  for (auto _ : state) benchmark::DoNotOptimize(traction(surface, {5.0, 0.5}, {{0.01, 0, -0.001}, {0, 0, 0}}));
}
BENCHMARK(contact_traction)->Arg(1500)->Arg(2600)->Unit(benchmark::kMicrosecond);

void read(benchmark::State& state, Aggregate aggregate, ReadingMethod method) {
  const Press press(1e-6 * static_cast<double>(state.range(0)), aggregate, method);
  ContactSurface surface;
  IntersectWorkspace workspace;
  intersect(*press.model->body, *press.box, press.X_WM, press.X_WB, surface, workspace);
  SensorReading result;
  const ContactSurface* surfaces[] = {&surface};
  for (auto _ : state) read_sensor(*press.model, surfaces, result);
  state.counters["points"] = static_cast<double>(result.force.evaluations + result.sums.points);
  state.counters["rays"] = static_cast<double>(press.model->rays.size());
  state.counters["polygons"] = static_cast<double>(surface.polygons.size());
}
void reading(benchmark::State& state) {
  read(state, Aggregate::weighted_mean, ReadingMethod::samples);
}
BENCHMARK(reading)->Arg(1500)->Arg(2600)->Unit(benchmark::kMicrosecond);

void reading_by_integral(benchmark::State& state, Aggregate aggregate) {
  read(state, aggregate, ReadingMethod::exact);
}
BENCHMARK_CAPTURE(reading_by_integral, weighted_mean, Aggregate::weighted_mean)
    ->Arg(1500)
    ->Arg(2600)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(reading_by_integral, mean, Aggregate::mean)->Arg(1500)->Arg(2600)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(reading_by_integral, force, Aggregate::force)->Arg(1500)->Arg(2600)->Unit(benchmark::kMicrosecond);

void model_build(benchmark::State& state) {
  const Press press(0.0015);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        build_sensor_model(press.model->layout, press.model->mesh, press.model->layout.mesh.sha256, "fingertip"));
  }
  state.counters["samples"] = static_cast<double>(press.model->samples.size());
}
BENCHMARK(model_build)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
