#include "core/run/step.h"

#include <algorithm>

namespace taxel {
namespace {

void fill_all_but_hits(const StepView& now, Step& to) {
  static_cast<StepState&>(to) = now;
  to.sensors.resize(now.sensors.size());
  for (std::size_t i = 0; i < now.sensors.size(); ++i) {
    const SensorView& sensor = now.sensors[i];
    SensorStep& state = to.sensors[i];
    state.model = now.scene->sensors[i];
    state.time = now.time;
    state.X_WM = sensor.X_WM;
    state.readings.assign(sensor.readings.begin(), sensor.readings.end());
    state.force_W = sensor.force_W;
    state.uncovered_W = sensor.uncovered_W;
    state.shear.assign(sensor.shear.begin(), sensor.shear.end());
    state.slip.assign(sensor.slip.begin(), sensor.slip.end());
    state.motions = sensor.motions;
    state.sticking.resize(sensor.sticking.size());
    for (std::size_t k = 0; k < state.sticking.size(); ++k) state.sticking[k] = *sensor.sticking[k];
    state.surfaces.resize(sensor.surfaces.size());
    for (std::size_t k = 0; k < state.surfaces.size(); ++k) state.surfaces[k] = *sensor.surfaces[k];
  }
}

void copy_hits(const SensorView& sensor, std::vector<std::int32_t>& filled, std::vector<RayHit>& hits) {
  if (hits.size() != sensor.hits.size()) {
    hits.assign(sensor.hits.begin(), sensor.hits.end());
  } else {
    for (const std::int32_t ray : filled) hits[static_cast<std::size_t>(ray)] = RayHit{};
    for (const std::int32_t ray : sensor.hit_rays)
      hits[static_cast<std::size_t>(ray)] = sensor.hits[static_cast<std::size_t>(ray)];
  }
  filled.assign(sensor.hit_rays.begin(), sensor.hit_rays.end());
}

}  // namespace

void fill_step(const StepView& now, Step& to) {
  fill_all_but_hits(now, to);
  for (std::size_t i = 0; i < now.sensors.size(); ++i)
    to.sensors[i].hits.assign(now.sensors[i].hits.begin(), now.sensors[i].hits.end());
}

void fill_step(const StepView& now, Step& to, FilledHits& hits) {
  fill_all_but_hits(now, to);
  if (hits.size() != now.sensors.size()) {
    for (SensorStep& sensor : to.sensors) sensor.hits.clear();
    hits.resize(now.sensors.size());
  }
  for (std::size_t i = 0; i < now.sensors.size(); ++i) copy_hits(now.sensors[i], hits[i], to.sensors[i].hits);
}

StepView view_of(const Step& step) {
  StepView view{step, {}};
  for (const SensorStep& state : step.sensors) {
    SensorView& sensor = view.sensors.emplace_back();
    sensor.X_WM = state.X_WM;
    sensor.force_W = state.force_W;
    sensor.uncovered_W = state.uncovered_W;
    sensor.readings = state.readings;
    sensor.motions = state.motions;
    sensor.hits = state.hits;
    sensor.shear = state.shear;
    sensor.slip = state.slip;
    for (const StickingFriction& friction : state.sticking) sensor.sticking.push_back(&friction);
    for (const ContactSurface& surface : state.surfaces) sensor.surfaces.push_back(&surface);
  }
  return view;
}

TraceRow trace_row_of(const StepView& step, SampleQuality quality) {
  const auto any = [&](const auto& has) { return std::ranges::any_of(step.sensors, has); };
  const bool has_shear = any([](const SensorView& sensor) { return !sensor.shear.empty(); });
  const bool has_slip = any([](const SensorView& sensor) { return !sensor.slip.empty(); });
  TraceRow row{step.time, step.travel, {}, quality};
  for (const SensorView& sensor : step.sensors) {
    row.readings.insert(row.readings.end(), sensor.readings.begin(), sensor.readings.end());
    if (has_shear) {
      for (const dvec2& shear : sensor.shear) row.shear.push_back(glm::length(shear));
      row.shear.resize(row.readings.size());
    }
    if (has_slip) {
      row.slip.insert(row.slip.end(), sensor.slip.begin(), sensor.slip.end());
      row.slip.resize(row.readings.size());
    }
  }
  return row;
}

}  // namespace taxel
