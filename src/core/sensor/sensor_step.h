// One sensor at one step: its pose, its contact surfaces and its readings. Plain values.
#pragma once

#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/rays/sensor_ray.h"
#include "core/sensor/sensor_model.h"
#include "core/sensor/surface_motion.h"

namespace taxel {

/// One sensor at one step. Surfaces, motions and hits are in the frame M of the sensor's mesh file.
struct SensorStep {
  SensorModelPtr model;
  double time = 0;               ///< time of the evaluated state [s]
  Pose X_WM;                     ///< pose of the sensor in the world
  std::vector<double> readings;  ///< one value per taxel, as in MuJoCo's sensordata
  dvec3 force_W{0};              ///< contact force on the sensor, with damping and friction [N]
  /// Elastic normal force that no taxel reaches [N]; zero unless the readings are forces.
  dvec3 uncovered_W{0};
  std::vector<ContactSurface> surfaces;  ///< surfaces with the bodies near the sensor
  std::vector<SurfaceMotion> motions;    ///< parallel to `surfaces`; empty if unknown
  std::vector<RayHit> hits;              ///< parallel to model->rays; hits index `surfaces`
  std::vector<dvec2> shear;              ///< parallel to `readings`, in their unit; empty without readout.shear
  std::vector<double> slip;              ///< share of each field that slips; empty unless friction sticks
  /// Friction that sticks, frame M, parallel to `surfaces`; without roots where it is regularised. Empty if no friction
  /// sticks.
  std::vector<StickingFriction> sticking;
};

/// Returns pointers to the surfaces of a step, in order. They are valid as long as `step` is not changed.
inline std::vector<const ContactSurface*> surface_pointers(const SensorStep& step) {
  std::vector<const ContactSurface*> pointers;
  pointers.reserve(step.surfaces.size());
  for (const ContactSurface& surface : step.surfaces) pointers.push_back(&surface);
  return pointers;
}

}  // namespace taxel
