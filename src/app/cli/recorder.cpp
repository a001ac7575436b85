#include "app/cli/recorder.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <set>

#include "core/layout/layout_json.h"
#include "core/layout/words.h"
#include "core/project/recording/csv.h"
#include "core/sensor/calibration.h"

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
    sensor.reading_unit = reading_unit(layout.readout.aggregate);
    sensor.force = layout.readout.aggregate == Aggregate::force;
    sensor.shear = layout.readout.shear;
    if (sensor.shear)
      for (const Taxel& taxel : layout.taxels) sensor.tangents.push_back(tangent_frame(layout.frame, taxel.normal));
    sensor.seed = layout.sampling.seed;
    if (layout.calibration) {
      const std::string& unit = layout.calibration->unit;
      sensor.calibrated_unit = unit.empty() ? sensor.reading_unit : unit;
    }
    recording.sensors.push_back(std::move(sensor));
  }
  for (const SceneGeom& geom : scene.geoms) {
    if (geom.sensor < 0) recording.objects.push_back(geom.name);
  }
  return recording;
}

/// The calibrations of a scene's sensors. They follow every step, not the recorded rows alone: a loop or a held value
/// depends on all that was felt.
class Calibrators {
 public:
  explicit Calibrators(const SimScene& scene) {
    for (const SensorModelPtr& sensor : scene.sensors) {
      all_.emplace_back();
      if (!sensor->layout.calibration) continue;
      all_.back().emplace(sensor->layout);
      any_ = true;
    }
    values_.resize(all_.size());
  }
  void follow(const Simulator& simulator) {
    if (!any_) return;
    const SimRow row = simulator.row();
    for (std::size_t s = 0; s < all_.size(); ++s)
      if (all_[s]) values_[s] = all_[s]->advance(row.time, row.readings[s]);
  }
  /// After the latest step, per sensor; empty without a calibration.
  [[nodiscard]] const std::vector<std::vector<double>>& values() const { return values_; }

 private:
  std::vector<std::optional<Calibrator>> all_;
  std::vector<std::vector<double>> values_;
  bool any_ = false;
};

RecordedRow take_row(const Simulator& simulator, const Calibrators& calibrators, std::int64_t step) {
  const SimRow row = simulator.row();
  RecordedRow recorded;
  recorded.step = step;
  recorded.time = row.time;
  recorded.travel = row.travel;
  for (std::size_t s = 0; s < row.readings.size(); ++s) {
    recorded.sensors.push_back({row.force_W[s], row.area[s], row.polygons[s], row.readings[s], row.sensor_poses[s],
                                calibrators.values()[s], row.shear[s], row.uncovered_W[s]});
  }
  const std::vector<SceneGeom>& geoms = simulator.scene()->geoms;
  for (std::size_t g = 0; g < geoms.size(); ++g) {
    if (geoms[g].sensor < 0) recorded.objects.push_back(simulator.pose_of_geom(static_cast<int>(g)));
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
  WarningsOfSensors warnings(simulator, console);
  Calibrators calibrators(scene);
  const SensorTimes before = simulator.sensor_times();
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  for (long step = 0; step != last && !simulator.finished(); ++step) {
    simulator.step();
    warnings.tell();
    recording.mocap.push_back({simulator.mocap_quat(), simulator.mocap_pos()});
    calibrators.follow(simulator);
    if (simulator.row_due()) recording.rows.push_back(take_row(simulator, calibrators, step));
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

void write_optional(OutputFolder& folder, const Recording& recording) {
  const auto write = [&](const char* name, const std::string& text) {
    if (text.empty())
      folder.leave_out(name);
    else
      folder.write(name, text);
  };
  write("calibrated.csv", calibrated_to_csv(recording));
  write("shear.csv", shear_to_csv(recording));
}

}  // namespace taxel::cli
