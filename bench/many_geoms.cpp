// What sensors cost among many geoms that they do not touch: five balls, and boxes in a plane below them.
#include <benchmark/benchmark.h>

#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

/// `moving`: every box is a body of its own with a joint, else all belong to the world.
void run_steps(benchmark::State& state, int boxes, bool moving) {
  test::SensorScene s;
  const TriMesh ball = make_sphere(0.02, 0.008);
  std::string instances, declared, world, assets;
  for (int i = 0; i < 5; ++i) {
    const std::string name = "ball" + std::to_string(i);
    s.add_sensor(name, ball, {FieldKind::star, 5e4, 0, 5, 0.5});
    instances += "<instance name='" + name + "'>" + test::key("layout", name + ".taxels.json") +
                 test::key("geom", name) + "</instance>";
    declared += "<plugin plugin='taxel.sensor' instance='" + name + "'/>";
    assets += "<mesh name='" + name + "' file='" + name + ".obj'/>";
    world += "<body pos='" + std::to_string(0.1 * i) + " 0 1'><freejoint/><geom name='" + name +
             "' type='mesh' mesh='" + name + "' contype='1' conaffinity='2'/></body>";
  }
  for (int i = 0; i < boxes; ++i) {
    const std::string place = "pos='" + std::to_string(0.05 * (i % 40)) + " " + std::to_string(0.05 * (i / 40)) + " 0'";
    const std::string geom = " type='box' size='.01 .01 .01' contype='4' conaffinity='1'/>";
    world += moving ? "<body " + place + "><joint type='slide'/><geom" + geom + "</body>" : "<geom " + place + geom;
  }
  s.compile(
      "<mujoco><option gravity='0 0 0'><flag contact='disable'/></option><extension><plugin plugin='taxel.sensor'>" +
      instances + "</plugin></extension><asset>" + assets + "</asset><worldbody>" + world + "</worldbody><sensor>" +
      declared + "</sensor></mujoco>");
  if (s.model == nullptr) throw Error(s.error);
  s.step(10);
  for (auto _ : state) s.step();
  double seconds = 0;
  for (int i = 0; i < 5; ++i)
    seconds += s.sensor(i).contacts().times.surfaces + s.sensor(i).contacts().times.forces +
               s.sensor(i).contacts().times.readings;
  state.counters["sensors_us"] = 1e6 * seconds / static_cast<double>(state.iterations() + 10);
  state.counters["touchable"] = static_cast<double>(s.sensor().touched().size());
}

void BM_static_geoms(benchmark::State& state) {
  run_steps(state, static_cast<int>(state.range(0)), false);
}
void BM_moving_geoms(benchmark::State& state) {
  run_steps(state, static_cast<int>(state.range(0)), true);
}
BENCHMARK(BM_static_geoms)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_moving_geoms)->Arg(200)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace taxel

BENCHMARK_MAIN();
