#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "core/base/error.h"
#include "core/run/recording/npz_arrays.h"
#include "core/run/recording/recording_files.h"

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

namespace {

/// Returns the unit of a sensor's readings. In files of versions without this array, `units` (JSON text) has one unit
/// for all sensors.
std::string unit_of_readings(const NpzReader& npz, const std::string& prefix) {
  if (npz.has(prefix + "readings_unit")) return npz.text(prefix + "readings_unit");
  const std::string units = npz.text("units"), key = "\"readings\": \"";
  const std::size_t at = units.find(key);
  if (at == std::string::npos) throw Error(npz.file(), "units", "says nothing of \"readings\"");
  return units.substr(at + key.size(), units.find('"', at + key.size()) - at - key.size());
}

/// Reads the times of the rows, which must ascend.
std::vector<double> read_times(const NpzReader& npz) {
  std::vector<double> time = finite_doubles(npz, "time", {NpzReader::kAny});
  if (time.empty()) throw Error(npz.file(), "time", "has no rows");
  for (std::size_t r = 1; r < time.size(); ++r)
    if (!(time[r] > time[r - 1]))
      throw Error(npz.file(), "time",
                  fmt::format("row {} must be later than {} s of the row before, is {} s", r, time[r - 1], time[r]));
  return time;
}

/// Reads the steps of the rows: ascending indices into the mocap arrays.
std::vector<std::int64_t> read_steps(const NpzReader& npz, std::size_t rows, std::size_t steps) {
  std::vector<std::int64_t> step = bounded_integers(npz, "step", {rows}, 0, static_cast<std::int64_t>(steps) - 1);
  for (std::size_t r = 1; r < step.size(); ++r)
    if (step[r] <= step[r - 1])
      throw Error(npz.file(), "step",
                  fmt::format("row {} must be greater than {} of the row before, is {}", r, step[r - 1], step[r]));
  return step;
}

void read_mocap(const NpzReader& npz, Recording& recording) {
  const std::vector<double> pos = finite_doubles(npz, "mocap_pos", {NpzReader::kAny, 3}, kLargestCoordinate);
  const std::vector<double> quat = unit_quaternions(npz, "mocap_quat", {pos.size() / 3, 4});
  for (std::size_t i = 0; i < pos.size() / 3; ++i) recording.mocap.push_back(pose_of_row(pos, quat, i));
  recording.timestep = finite_doubles(npz, "timestep", {}).front();
  if (!(recording.timestep > 0))
    throw Error(npz.file(), "timestep", fmt::format("must be greater than 0, is {}", recording.timestep));
}

void read_rows(const NpzReader& npz, Recording& recording) {
  const std::vector<double> time = read_times(npz);
  const std::size_t n = time.size();
  const std::vector<double> travel = finite_doubles(npz, "travel", {n});
  const std::vector<std::int64_t> step = read_steps(npz, n, recording.mocap.size());
  recording.objects = npz.texts("object_names");
  const std::size_t m = recording.objects.size();
  const std::vector<double> pos = finite_doubles(npz, "object_pos", {n, m, 3}, kLargestCoordinate),
                            quat = unit_quaternions(npz, "object_quat", {n, m, 4});
  for (std::size_t r = 0; r < n; ++r) {
    RecordedRow& row = recording.rows.emplace_back();
    row.step = step[r], row.time = time[r], row.travel = travel[r];
    for (std::size_t o = 0; o < m; ++o) row.objects.push_back(pose_of_row(pos, quat, r * m + o));
  }
}

void read_tangents(const NpzReader& npz, const std::string& prefix, RecordedSensor& sensor) {
  const std::vector<double> values = finite_doubles(npz, prefix + "tangents", {sensor.taxel_ids.size(), 2, 3});
  for (std::size_t k = 0; k < sensor.taxel_ids.size(); ++k)
    sensor.tangents.push_back({vector_at(values, 6 * k), vector_at(values, 6 * k + 3)});
}

RecordedSensor read_sensor_columns(const NpzReader& npz, const std::string& prefix, const std::string& geom) {
  RecordedSensor sensor;
  sensor.geom = geom;
  using Id = std::numeric_limits<int>;
  for (const std::int64_t id : bounded_integers(npz, prefix + "taxel_ids", {NpzReader::kAny}, Id::min(), Id::max()))
    sensor.taxel_ids.push_back(static_cast<int>(id));
  sensor.taxel_names = npz.texts(prefix + "taxel_names");
  if (sensor.taxel_names.size() != sensor.taxel_ids.size())
    throw Error(npz.file(), prefix + "taxel_names", "has not one name per id");
  sensor.reading_unit = unit_of_readings(npz, prefix);
  sensor.layout_json = npz.text(prefix + "layout");
  sensor.seed = std::bit_cast<std::uint64_t>(npz.integers(prefix + "seed", {}).front());
  sensor.force = npz.has(prefix + "uncovered");
  sensor.shear = npz.has(prefix + "shear");
  sensor.errors = npz.has(prefix + "readings_error");
  sensor.slip = npz.has(prefix + "slip");
  if (sensor.shear) read_tangents(npz, prefix, sensor);
  if (npz.has(prefix + "calibrated_unit")) sensor.calibrated_unit = npz.text(prefix + "calibrated_unit");
  return sensor;
}

void read_sensor_rows(const NpzReader& npz, const std::string& prefix, Recording& recording) {
  const RecordedSensor& sensor = recording.sensors.back();
  const std::size_t n = recording.rows.size(), k = sensor.taxel_ids.size();
  const auto optional = [&](bool is_written, const char* name, const NpzReader::Shape& shape) {
    return is_written ? finite_doubles(npz, prefix + name, shape) : std::vector<double>();
  };
  const std::vector<double> force = finite_doubles(npz, prefix + "force", {n, 3}),
                            area = finite_doubles(npz, prefix + "area", {n}),
                            readings = finite_doubles(npz, prefix + "readings", {n, k}),
                            pos = finite_doubles(npz, prefix + "sensor_pos", {n, 3}, kLargestCoordinate),
                            quat = unit_quaternions(npz, prefix + "sensor_quat", {n, 4}),
                            calibrated = optional(sensor.calibrated_unit.has_value(), "calibrated", {n, k}),
                            errors = optional(sensor.errors, "readings_error", {n, k}),
                            shear = optional(sensor.shear, "shear", {n, k, 2}),
                            slip = optional(sensor.slip, "slip", {n, k}),
                            uncovered = optional(sensor.force, "uncovered", {n, 3}),
                            elastic = optional(npz.has(prefix + "elastic_force"), "elastic_force", {n, 3});
  const std::vector<std::int64_t> polygons =
      bounded_integers(npz, prefix + "polygons", {n}, 0, std::numeric_limits<int>::max());
  const auto row_of = [&](const std::vector<double>& values, std::size_t r) {
    return values.empty() ? std::vector<double>()
                          : std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(r * k),
                                                values.begin() + static_cast<std::ptrdiff_t>((r + 1) * k));
  };
  for (std::size_t r = 0; r < n; ++r) {
    SensorRecord record;
    record.force_W = vector_at(force, 3 * r);
    record.area = area[r];
    record.polygons = static_cast<int>(polygons[r]);
    record.readings = row_of(readings, r);
    record.X_WM = pose_of_row(pos, quat, r);
    record.calibrated = row_of(calibrated, r);
    record.errors = row_of(errors, r);
    for (std::size_t i = 0; !shear.empty() && i < k; ++i)
      record.shear.push_back({shear[2 * (r * k + i)], shear[2 * (r * k + i) + 1]});
    record.slip = row_of(slip, r);
    if (!elastic.empty()) record.elastic_force_W = vector_at(elastic, 3 * r);
    if (!uncovered.empty()) record.uncovered_W = vector_at(uncovered, 3 * r);
    recording.rows[r].sensors.push_back(std::move(record));
  }
}

}  // namespace

std::filesystem::path recording_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ? path / "readings.npz" : path;
}

Recording read_recording(const std::filesystem::path& path) {
  return read_recording(NpzReader(recording_file(path)));
}

Recording read_moved_recording(const std::filesystem::path& path) {
  Recording recording = read_recording(path);
  const auto at_rest = [](const Pose& X) { return X.p == dvec3(0) && X.q == dquat(1, 0, 0, 0); };
  if (std::all_of(recording.mocap.begin(), recording.mocap.end(), at_rest))
    throw Error(recording_file(path).string(), "mocap_pos",
                "holds no poses to replay: no mocap body moved in that run");
  return recording;
}

Recording read_recording(const NpzReader& npz) {
  Recording recording;
  read_mocap(npz, recording);
  read_rows(npz, recording);
  const std::vector<std::string> geoms = npz.texts("sensor_geoms");
  for (const std::string& geom : geoms) {
    const std::string prefix = geoms.size() > 1 ? geom + "/" : "";
    recording.sensors.push_back(read_sensor_columns(npz, prefix, geom));
    read_sensor_rows(npz, prefix, recording);
  }
  return recording;
}

}  // namespace taxel
