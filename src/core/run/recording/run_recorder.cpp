#include "core/run/recording/run_recorder.h"

#include <algorithm>

#include "core/hydro/traction.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

RecordedSensor describe_sensor(const Layout& layout, const std::string& geom) {
  RecordedSensor sensor;
  sensor.geom = geom;
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
  return sensor;
}

SensorRecord record_of(const SensorView& sensor) {
  SensorRecord record;
  record.force_W = sensor.force_W;
  dvec3 elastic(0);
  std::size_t polygons = 0;
  for (const ContactSurface* surface : sensor.surfaces) {
    elastic += pressure_wrench(*surface).force;
    record.area += surface->area();
    polygons += surface->polygons.size();
  }
  record.elastic_force_W = sensor.X_WM.rotate(elastic);
  record.polygons = static_cast<int>(polygons);
  record.readings.assign(sensor.readings.begin(), sensor.readings.end());
  record.X_WM = sensor.X_WM;
  record.shear.assign(sensor.shear.begin(), sensor.shear.end());
  record.slip.assign(sensor.slip.begin(), sensor.slip.end());
  record.uncovered_W = sensor.uncovered_W;
  return record;
}

std::size_t bytes_of(const RecordedRow& row) {
  std::size_t bytes = sizeof row + row.objects.size() * sizeof(Pose);
  for (const SensorRecord& sensor : row.sensors)
    bytes += sizeof sensor + sensor.shear.size() * sizeof(dvec2) +
             (sensor.readings.size() + sensor.errors.size() + sensor.calibrated.size() + sensor.slip.size()) *
                 sizeof(double);
  return bytes;
}

}  // namespace

Recording describe_recording(const SimScene& scene) {
  Recording recording;
  recording.timestep = scene.timestep;
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    recording.sensors.push_back(describe_sensor(scene.sensors[i]->layout, scene.sensor_geoms[i]));
    recording.sensors.back().slip = i < scene.sensor_slips.size() && scene.sensor_slips[i];
  }
  for (const SceneGeom& geom : scene.geoms)
    if (geom.sensor < 0) recording.objects.push_back(geom.name);
  return recording;
}

std::size_t recorded_row_bytes(const SimScene& scene) {
  RecordedRow row;
  row.objects.resize(static_cast<std::size_t>(
      std::count_if(scene.geoms.begin(), scene.geoms.end(), [](const SceneGeom& geom) { return geom.sensor < 0; })));
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    const Layout& layout = scene.sensors[i]->layout;
    SensorRecord& record = row.sensors.emplace_back();
    if (i < scene.sensor_slips.size() && scene.sensor_slips[i]) record.slip.resize(layout.taxels.size());
    record.readings.resize(layout.taxels.size());
    if (layout.calibration) record.calibrated.resize(layout.taxels.size());
    if (layout.readout.shear) record.shear.resize(layout.taxels.size());
  }
  return bytes_of(row) + sizeof(Pose);
}

RecordedRow row_of(const StepView& step) {
  RecordedRow row;
  row.time = step.time;
  row.travel = step.travel;
  for (const SensorView& sensor : step.sensors) row.sensors.push_back(record_of(sensor));
  for (std::size_t g = 0; g < step.scene->geoms.size(); ++g)
    if (step.scene->geoms[g].sensor < 0) row.objects.push_back(step.geom_poses[g]);
  return row;
}

RunRecorder::RunRecorder(const SimScene& scene, std::shared_ptr<ErrorBarSource> errors)
    : recording_(describe_recording(scene)), sensors_(scene.sensors), errors_(std::move(errors)) {
  for (std::size_t s = 0; errors_ != nullptr && s < sensors_.size(); ++s)
    recording_.sensors[s].errors = errors_->missing(s).empty();
  begin_calibrations();
}

void RunRecorder::begin_calibrations() {
  calibrators_.clear();
  for (const SensorModelPtr& sensor : sensors_) {
    calibrators_.emplace_back();
    if (!sensor->layout.calibration) continue;
    calibrators_.back().emplace(sensor->layout, recording_.timestep);
    any_calibration_ = true;
  }
  calibrated_.assign(calibrators_.size(), {});
}

void RunRecorder::pass(const Pose& mocap) {
  recording_.mocap.push_back(mocap);
  bytes_ += sizeof mocap;
}

void RunRecorder::follow(const StepView& view, const Pose& mocap, bool keep) {
  const auto step = static_cast<std::int64_t>(recording_.mocap.size());
  pass(mocap);
  for (std::size_t s = 0; any_calibration_ && s < calibrators_.size(); ++s)
    if (calibrators_[s]) calibrated_[s] = calibrators_[s]->advance(view.time, view.sensors[s].readings);
  if (!keep) return;
  RecordedRow row = row_of(view);
  row.step = step;
  for (std::size_t s = 0; s < row.sensors.size(); ++s) {
    row.sensors[s].calibrated = calibrated_[s];
    if (recording_.sensors[s].errors) row.sensors[s].errors = errors_->measure(view, s);
  }
  bytes_ += bytes_of(row);
  recording_.rows.push_back(std::move(row));
}

void RunRecorder::cut_after(std::size_t steps) {
  std::vector<RecordedRow>& rows = recording_.rows;
  while (!rows.empty() && rows.back().step >= static_cast<std::int64_t>(steps)) {
    bytes_ -= bytes_of(rows.back());
    rows.pop_back();
  }
  while (recording_.mocap.size() > steps) {
    bytes_ -= sizeof(Pose);
    recording_.mocap.pop_back();
  }
  if (!any_calibration_) return;
  begin_calibrations();
  for (const RecordedRow& row : rows)
    for (std::size_t s = 0; s < calibrators_.size(); ++s)
      if (calibrators_[s]) calibrated_[s] = calibrators_[s]->advance(row.time, row.sensors[s].readings);
}

}  // namespace taxel
