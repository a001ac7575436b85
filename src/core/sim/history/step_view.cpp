#include "core/sim/history/step_view.h"

namespace taxel {

void fill_frame(const StepView& now, SimFrame& frame) {
  frame.scene = now.scene;
  frame.step = now.step;
  frame.time = now.time;
  frame.travel = now.travel;
  frame.finished = now.finished;
  frame.geom_poses = now.geom_poses;
  frame.held = now.held;
  frame.sensors.resize(now.sensors.size());
  for (std::size_t i = 0; i < now.sensors.size(); ++i) {
    const SensorView& sensor = now.sensors[i];
    SensorFrameState& state = frame.sensors[i];
    state.X_WM = sensor.X_WM;
    state.readings.assign(sensor.readings.begin(), sensor.readings.end());
    state.force_W = sensor.force_W;
    state.uncovered_W = sensor.uncovered_W;
    state.hits.assign(sensor.hits.begin(), sensor.hits.end());
    state.shear.assign(sensor.shear.begin(), sensor.shear.end());
    state.motions = sensor.motions;
    state.surfaces.clear();
    for (const ContactSurface* surface : sensor.surfaces) state.surfaces.push_back(*surface);
  }
}

StepView view_of(const SimFrame& frame) {
  StepView view{frame.scene, frame.step, frame.time, frame.travel, frame.finished, frame.geom_poses, {}, frame.held};
  for (const SensorFrameState& state : frame.sensors) {
    SensorView& sensor = view.sensors.emplace_back();
    sensor.X_WM = state.X_WM;
    sensor.force_W = state.force_W;
    sensor.uncovered_W = state.uncovered_W;
    sensor.readings = state.readings;
    sensor.motions = state.motions;
    sensor.hits = state.hits;
    sensor.shear = state.shear;
    for (const ContactSurface& surface : state.surfaces) sensor.surfaces.push_back(&surface);
  }
  return view;
}

}  // namespace taxel
