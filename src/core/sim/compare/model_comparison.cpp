#include "core/sim/compare/model_comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/sensor/explain/exact_reading.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/compare/contact_again.h"
#include "core/sim/compare/mujoco_sensors.h"

namespace taxel {
namespace {

/// Returns the reading of the paper's released code, sum of w p, over the layout's own hits.
std::vector<double> weighted_sum_of(const SensorModel& model, const std::vector<RayHit>& hits) {
  RayHits again;
  again.clear(model.rays.size());
  for (std::size_t ray = 0; ray < hits.size(); ++ray)
    if (hits[ray].hit()) again.offer(static_cast<std::int32_t>(ray), hits[ray]);
  again.finish();
  std::vector<double> sums;
  aggregate(model, again, Aggregate::weighted_sum, sums);
  return sums;
}

}  // namespace

ModelComparison::~ModelComparison() = default;

ModelComparison::ModelComparison(std::shared_ptr<const SimScene> scene, std::size_t sensor, Progress* progress)
    : scene_(std::move(scene)), sensor_(sensor) {
  if (sensor_ >= scene_->sensors.size() || !scene_->sensors[sensor_])
    throw Error(fmt::format("there is no sensor {}, the scene has {}", sensor_, scene_->sensors.size()));
  const SensorModel& model = *scene_->sensors[sensor_];
  if (scene_->touched.size() != scene_->sensors.size()) {
    no_star_ = no_mujoco_ = "the step was read from a file of a version that left out the bodies that are touched";
    return;
  }
  try {
    if (!model.layout.material.compliant()) throw Error("the sensor is rigid: it has no pressure field");
    Layout layout = model.layout;
    layout.material.field = FieldKind::star;
    SensorBuild how(progress);
    how.quality = model.quality;
    star_ = build_sensor_model(layout, model.loaded, "", layout.name, how);
  } catch (const Error& error) {
    no_star_ = error.message();
  }
  try {
    if (model.layout.taxels.empty()) throw Error("there are no taxels");
    mujoco_ = std::make_unique<MujocoSensors>(model, scene_->touched[sensor_], scene_->sensors);
  } catch (const Error& error) {
    no_mujoco_ = error.message();
  }
}

void ModelComparison::read_star(std::span<const SensorStep> sensors, std::span<const Pose> X_WB, ModelReading& out) {
  out.missing = no_star_;
  if (star_) out.values = read_own_contact(*star_, scene_->touched[sensor_], sensors[sensor_].X_WM, X_WB);
}

void ModelComparison::read_exact(const SensorStep& state, ModelReading& out) const {
  const SensorModel& model = *scene_->sensors[sensor_];
  const std::vector<const ContactSurface*> surfaces = surface_pointers(state);
  std::vector<ExactReading> found(model.layout.taxels.size());
  parallel_chunks(model.taxel_count(), 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) found[static_cast<std::size_t>(k)] = exact_reading(model, k, surfaces);
  });
  for (std::size_t k = 0; k < found.size(); ++k) {
    out.values.push_back(found[k].value.value_or(std::nan("")));
    if (!found[k].value && out.missing.empty())
      out.missing = fmt::format("taxel {}: {}", model.layout.taxels[k].id, found[k].missing);
  }
}

void ModelComparison::read_mujoco(const SensorStep& state, std::span<const SensorStep> sensors,
                                  const std::vector<Pose>& X_WB, ModelReadings& out) {
  ModelReading &depth = out[ReadingModel::tactile], &touch = out[ReadingModel::touch];
  depth.missing = touch.missing = no_mujoco_;
  if (!mujoco_) return;
  const std::vector<TouchedBody>& touched = scene_->touched[sensor_];
  std::vector<dvec3> load_W(touched.size(), dvec3(0));
  IntersectWorkspace workspace;
  ContactSurface surface;
  const SensorModel& model = *scene_->sensors[sensor_];
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (touched[i].body == nullptr) continue;
    intersect_touched(*model.body, touched[i], sensors[sensor_].X_WM, X_WB[i], surface, workspace);
    load_W[i] = state.X_WM.rotate(pressure_wrench(surface).force);
  }
  MujocoReadings found = mujoco_->read(state.X_WM, X_WB, load_W);
  depth.values = std::move(found.depth);
  touch.values = std::move(found.touch);
}

ModelReadings ModelComparison::read(std::span<const SensorStep> sensors, std::span<const Pose> X_WG) {
  ModelReadings out;
  const SensorStep& state = sensors[sensor_];
  const auto [X_WB, unknown] = touched_poses(*scene_, sensor_, sensors, X_WG);
  out[ReadingModel::reading].values = state.readings;
  out[ReadingModel::weighted_sum].values = weighted_sum_of(*scene_->sensors[sensor_], state.hits);
  read_exact(state, out[ReadingModel::exact]);
  read_star(sensors, X_WB, out[ReadingModel::star]);
  read_mujoco(state, sensors, X_WB, out);
  for (const ReadingModel m : {ReadingModel::star, ReadingModel::tactile, ReadingModel::touch})
    if (out[m].missing.empty()) out[m].missing = unknown;
  return out;
}

}  // namespace taxel
