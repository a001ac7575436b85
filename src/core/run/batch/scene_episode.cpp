#include "core/run/batch/scene_episode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/run/recording/run_recorder.h"

namespace taxel {
namespace {

/// Returns a name that no other column has. Readers of data sets refuse a slash.
std::string column_name(std::string name, std::set<std::string>& taken) {
  std::ranges::replace(name, '/', '_');
  std::string free = name;
  for (int i = 2; !taken.insert(free).second; ++i) free = fmt::format("{}_{}", name, i);
  return free;
}

/// Returns the description of a sensor. Its layout has the name of its mesh alone: the batch does not hold the mesh.
EpisodeSensor describe(const RecordedSensor& from, const Layout& recorded) {
  Layout layout = recorded;
  layout.mesh.file = std::filesystem::path(layout.mesh.file).filename().string();
  EpisodeSensor made;
  made.layout_json = layout_to_json(layout);
  made.layout_key = sha256_hex(made.layout_json);
  made.layout_name = layout.name;
  made.taxel_ids.assign(from.taxel_ids.begin(), from.taxel_ids.end());
  made.taxel_names = from.taxel_names;
  made.unit = from.reading_unit;
  made.calibrated_unit = from.calibrated_unit.value_or("");
  return made;
}

std::vector<double> numbers_of(const dvec3& v) {
  return {v.x, v.y, v.z};
}

std::vector<double> numbers_of(const Pose& pose) {
  return {pose.p.x, pose.p.y, pose.p.z, pose.q.w, pose.q.x, pose.q.y, pose.q.z};
}

void check_finite(const std::vector<double>& values, const std::string& column, std::int64_t step) {
  if (std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) return;
  throw Error(fmt::format("{} is not finite at step {}: a modulus, velocity or size is too large", column, step));
}

std::string unit_of_joints(const std::vector<SceneJoint>& joints) {
  const auto hinges = std::ranges::count_if(joints, [](const SceneJoint& joint) { return joint.hinge; });
  if (hinges == 0) return joints.empty() ? "" : "m";
  return static_cast<std::size_t>(hinges) == joints.size() ? "rad" : "rad, m";
}

}  // namespace

SceneColumns::SceneColumns(const SimScene& scene, std::string key, std::string name, bool has_poses)
    : sensors_(describe_recording(scene).sensors), has_poses_(has_poses) {
  scene_.key = std::move(key);
  scene_.name = std::move(name);
  std::set<std::string> sensor_names, body_names;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    scene_.sensors.push_back(column_name(sensors_[i].geom, sensor_names));
    scene_.layouts.push_back(describe(sensors_[i], scene.sensors[i]->layout));
  }
  const SceneControls& controls = scene.controls;
  for (std::size_t b = 0; b < controls.bodies.size(); ++b)
    if (controls.bodies[b].free) bodies_.emplace_back(kPoseOf + column_name(controls.bodies[b].name, body_names), b);
  for (const SceneJoint& joint : controls.joints) scene_.state.push_back(joint.name);
  scene_.state_unit = unit_of_joints(controls.joints);
  for (const SceneActuator& actuator : controls.actuators) scene_.action.push_back(actuator.name);
  for (const std::string& mocap : controls.mocaps)
    for (const char* axis : {"x", "y", "z", "qw", "qx", "qy", "qz"}) scene_.action.push_back(mocap + " " + axis);
}

EpisodeColumn& SceneColumns::column(const std::string& name, std::size_t width) {
  const auto found = std::ranges::find(episode_.columns, name, &EpisodeColumn::name);
  if (found != episode_.columns.end()) return *found;
  episode_.columns.push_back({name, width, name != kTimestamp, {}});
  return episode_.columns.back();
}

void SceneColumns::append(const std::string& name, const std::vector<double>& values) {
  EpisodeColumn& to = column(name, values.size());
  to.values.insert(to.values.end(), values.begin(), values.end());
}

void SceneColumns::add_sensor(std::size_t sensor, const SceneRow& row) {
  const SensorRecord& record = row.recorded.sensors[sensor];
  const RecordedSensor& from = sensors_[sensor];
  const std::string& name = scene_.sensors[sensor];
  const auto add = [&](const char* column, const std::vector<double>& values) {
    check_finite(values, column + name, row.recorded.step);
    append(column + name, values);
  };
  if (!from.taxel_ids.empty()) add(kTactileOf, record.readings);
  if (!record.calibrated.empty()) add(kCalibratedOf, record.calibrated);
  if (from.shear) {
    std::vector<double> shear;
    for (const dvec2& value : record.shear) shear.insert(shear.end(), {value.x, value.y});
    add(kShearOf, shear);
  }
  add(kForceOf, numbers_of(record.force_W));
  add(kTorqueOf, numbers_of(row.torques_W[sensor]));
  if (has_poses_) add(kSensorPoseOf, numbers_of(record.X_WM));
  EpisodeSummary& summary = episode_.summary;
  summary.largest_force = std::max(summary.largest_force, glm::length(record.force_W));
  for (std::size_t k = 0; k < record.readings.size(); ++k) {
    if (record.readings[k] <= summary.peak) continue;
    summary.peak = record.readings[k];
    summary.peak_taxel = from.taxel_ids[k];
    summary.peak_sensor = name;
  }
}

void SceneColumns::add(const SceneRow& row) {
  append(kTimestamp, {row.recorded.time});
  for (std::size_t i = 0; i < sensors_.size(); ++i) add_sensor(i, row);
  for (const auto& [name, body] : bodies_) append(name, numbers_of(row.bodies[body]));
  if (!row.joints.empty()) append(kState, row.joints);
  std::vector<double> action = row.controls;
  for (const Pose& mocap : row.mocaps)
    for (const double value : numbers_of(mocap)) action.push_back(value);
  if (!action.empty()) append(kMocapPose, action);
  const std::vector<double>& times = episode_.columns.front().values;
  episode_.rows = static_cast<std::int64_t>(times.size());
  episode_.summary.duration = times.back() - times.front();
}

Episode SceneColumns::episode() const {
  if (episode_.rows == 0) throw Error("the run has no rows");
  return episode_;
}

}  // namespace taxel
