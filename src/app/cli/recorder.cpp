#include "app/cli/recorder.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <set>

#include "core/layout/layout_json.h"

namespace taxel::cli {
namespace {

Recording describe(const SimScene& scene) {
  Recording recording;
  recording.timestep = scene.timestep;
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    const Layout& layout = scene.sensors[i]->layout;
    RecordedSensor sensor;
    sensor.geom = scene.sensor_geoms[i];
    for (const Taxel& taxel : layout.taxels) {
      sensor.taxel_ids.push_back(taxel.id);
      sensor.taxel_names.push_back(taxel.name);
    }
    sensor.layout_json = layout_to_json(layout);
    sensor.reading_unit = layout.readout.aggregate == Aggregate::force ? "N" : "Pa";
    sensor.seed = layout.sampling.seed;
    recording.sensors.push_back(std::move(sensor));
  }
  for (const SceneGeom& geom : scene.geoms) {
    if (geom.sensor < 0) recording.objects.push_back(geom.name);
  }
  return recording;
}

RecordedRow take_row(const Simulator& simulator, std::int64_t step, SimFrame& frame) {
  const SimRow row = simulator.row();
  simulator.fill_frame(frame);
  RecordedRow recorded;
  recorded.step = step;
  recorded.time = row.time;
  recorded.travel = row.travel;
  for (std::size_t s = 0; s < row.readings.size(); ++s) {
    recorded.sensors.push_back({row.force_W[s], row.area[s], row.polygons[s], row.readings[s], row.sensor_poses[s]});
  }
  const std::vector<SceneGeom>& geoms = simulator.scene()->geoms;
  for (std::size_t g = 0; g < geoms.size(); ++g) {
    if (geoms[g].sensor < 0) recorded.objects.push_back(frame.geom_poses[g]);
  }
  return recorded;
}

/// What the sensors have to say, as soon as they know it, each once.
class WarningsOfSensors {
 public:
  WarningsOfSensors(const Simulator& simulator, Console& console) : simulator_(simulator), console_(console) { tell(); }
  void tell() {
    for (std::string& text : simulator_.warnings()) {
      if (const auto [at, fresh] = told_.insert(std::move(text)); fresh) console_.warn(*at);
    }
  }

 private:
  const Simulator& simulator_;
  Console& console_;
  std::set<std::string> told_;
};

}  // namespace

Recording record(Simulator& simulator, double seconds, Console& console, RunCost& cost) {
  const SimScene& scene = *simulator.scene();
  Recording recording = describe(scene);
  const double limit = seconds > 0 ? seconds : scene.duration;
  const long last = seconds > 0 ? std::lround(seconds / scene.timestep) : -1;
  SimFrame frame;
  WarningsOfSensors warnings(simulator, console);
  const SensorTimes before = simulator.sensor_times();
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  for (long step = 0; step != last && !simulator.finished(); ++step) {
    simulator.step();
    warnings.tell();
    recording.mocap.push_back({simulator.mocap_quat(), simulator.mocap_pos()});
    if (simulator.row_due()) recording.rows.push_back(take_row(simulator, step, frame));
    cost.steps = step + 1;
    cost.simulated = static_cast<double>(cost.steps) * scene.timestep;
    if (limit > 0) console.progress(std::min(0.99, cost.simulated / limit));
  }
  console.progress(1);
  cost.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const SensorTimes after = simulator.sensor_times();
  cost.sensors = {after.surfaces - before.surfaces, after.forces - before.forces, after.readings - before.readings};
  cost.cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  return recording;
}

}  // namespace taxel::cli
