#include <fmt/format.h>

#include "core/run/recording/npz.h"
#include "core/run/recording/npz_rows.h"

namespace taxel {
namespace {

void add_rows(NpzWriter& npz, const Recording& recording) {
  const std::size_t n = recording.rows.size();
  std::vector<double> time, travel;
  std::vector<std::int64_t> step;
  for (const RecordedRow& row : recording.rows) {
    time.push_back(row.time);
    travel.push_back(row.travel);
    step.push_back(row.step);
  }
  npz.add("time", {n}, time);
  npz.add("travel", {n}, travel);
  npz.add("step", {n}, step);
}

std::vector<double> tangents_of(const RecordedSensor& sensor) {
  std::vector<double> values;
  for (const TangentFrame& frame : sensor.tangents) append(values, frame.e1), append(values, frame.e2);
  return values;
}

void add_sensor(NpzWriter& npz, const Recording& recording, std::size_t which) {
  const RecordedSensor& sensor = recording.sensors[which];
  const std::string prefix = recording.sensors.size() > 1 ? sensor.geom + "/" : "";
  const std::size_t n = recording.rows.size();
  std::vector<double> force, elastic, area, readings, errors, calibrated, shear, slip, uncovered, pos, quat;
  std::vector<std::int64_t> polygons;
  for (const RecordedRow& row : recording.rows) {
    const SensorRecord& record = row.sensors[which];
    append(force, record.force_W);
    if (record.elastic_force_W) append(elastic, *record.elastic_force_W);
    area.push_back(record.area);
    polygons.push_back(record.polygons);
    readings.insert(readings.end(), record.readings.begin(), record.readings.end());
    errors.insert(errors.end(), record.errors.begin(), record.errors.end());
    calibrated.insert(calibrated.end(), record.calibrated.begin(), record.calibrated.end());
    for (const dvec2& s : record.shear) append(shear, s);
    slip.insert(slip.end(), record.slip.begin(), record.slip.end());
    append(uncovered, record.uncovered_W);
    append(pos, quat, record.X_WM);
  }
  npz.add(prefix + "force", {n, 3}, force);
  if (elastic.size() == force.size()) npz.add(prefix + "elastic_force", {n, 3}, elastic);
  npz.add(prefix + "area", {n}, area);
  npz.add(prefix + "polygons", {n}, polygons);
  npz.add(prefix + "readings", {n, sensor.taxel_ids.size()}, readings);
  npz.add(prefix + "readings_unit", sensor.reading_unit);
  if (sensor.errors) npz.add(prefix + "readings_error", {n, sensor.taxel_ids.size()}, errors);
  if (sensor.calibrated_unit) {
    npz.add(prefix + "calibrated", {n, sensor.taxel_ids.size()}, calibrated);
    npz.add(prefix + "calibrated_unit", *sensor.calibrated_unit);
  }
  if (sensor.shear) npz.add(prefix + "shear", {n, sensor.taxel_ids.size(), 2}, shear);
  if (sensor.shear) npz.add(prefix + "tangents", {sensor.taxel_ids.size(), 2, 3}, tangents_of(sensor));
  if (sensor.slip) npz.add(prefix + "slip", {n, sensor.taxel_ids.size()}, slip);
  if (sensor.force) npz.add(prefix + "uncovered", {n, 3}, uncovered);
  npz.add(prefix + "sensor_pos", {n, 3}, pos);
  npz.add(prefix + "sensor_quat", {n, 4}, quat);
  const std::vector<std::int64_t> ids(sensor.taxel_ids.begin(), sensor.taxel_ids.end());
  npz.add(prefix + "taxel_ids", {ids.size()}, ids);
  npz.add(prefix + "taxel_names", sensor.taxel_names);
  npz.add(prefix + "layout", sensor.layout_json);
  const std::int64_t seed = std::bit_cast<std::int64_t>(sensor.seed);
  npz.add(prefix + "seed", {}, std::span(&seed, 1));
}

void add_objects(NpzWriter& npz, const Recording& recording) {
  const std::size_t n = recording.rows.size();
  const std::size_t m = recording.objects.size();
  std::vector<double> pos, quat;
  for (const RecordedRow& row : recording.rows)
    for (const Pose& pose : row.objects) append(pos, quat, pose);
  npz.add("object_names", recording.objects);
  npz.add("object_pos", {n, m, 3}, pos);
  npz.add("object_quat", {n, m, 4}, quat);
}

void add_mocap(NpzWriter& npz, const Recording& recording) {
  std::vector<double> pos, quat;
  for (const Pose& pose : recording.mocap) append(pos, quat, pose);
  npz.add("mocap_pos", {recording.mocap.size(), 3}, pos);
  npz.add("mocap_quat", {recording.mocap.size(), 4}, quat);
  npz.add("timestep", {}, std::span(&recording.timestep, 1));
}

}  // namespace

std::string recording_to_npz(const Recording& recording) {
  NpzWriter npz;
  add_rows(npz, recording);
  std::vector<std::string> geoms;
  for (std::size_t i = 0; i < recording.sensors.size(); ++i) {
    add_sensor(npz, recording, i);
    geoms.push_back(recording.sensors[i].geom);
  }
  add_objects(npz, recording);
  add_mocap(npz, recording);
  npz.add("sensor_geoms", geoms);
  const std::string readings = recording.sensors.empty() ? "Pa" : recording.sensors.front().reading_unit;
  npz.add("units", fmt::format(R"({{"time": "s", "travel": "m", "force": "N", "area": "m^2", "readings": "{}", )"
                               R"("pos": "m", "quat": "1", "timestep": "s"}})",
                               readings));
  return npz.bytes();
}

}  // namespace taxel
