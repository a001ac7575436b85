#include "core/sim/compare/contact_again.h"

#include <fmt/format.h>

#include <utility>

#include "core/sensor/readout/reading.h"

namespace taxel {

std::string missing_touched(const SimScene& scene) {
  if (scene.touched.size() == scene.sensors.size()) return "";
  return "the step was read from a file of a version that left out the bodies that are touched";
}

TouchedPoses touched_poses(const StepView& step, std::size_t sensor) {
  TouchedPoses poses;
  if (step.scene->touched.empty()) return poses;
  for (const TouchedBody& body : step.scene->touched[sensor]) {
    if (body.body == nullptr)
      poses.unknown = fmt::format("without geom \"{}\": its pose or its material is not known", body.name);
    poses.X_WB.push_back(body.sensor >= 0 ? step.sensors[static_cast<std::size_t>(body.sensor)].X_WM
                         : body.geom >= 0 ? step.geom_poses[static_cast<std::size_t>(body.geom)]
                                          : body.X_WB);
  }
  return poses;
}

void intersect_touched(const HydroBody& self, const TouchedBody& other, const Pose& X_WM, const Pose& X_WB,
                       ContactSurface& out, IntersectWorkspace& workspace) {
  if (!other.mirrored) return intersect(self, *other.body, X_WM, X_WB, out, workspace);
  ContactSurface theirs;
  intersect(*other.body, self, X_WB, X_WM, theirs, workspace);
  mirror(theirs, RigidTransform(X_WM.inverse() * X_WB), out);
}

std::vector<double> read_own_contact(const SensorModel& model, const std::vector<TouchedBody>& touched,
                                     const Pose& X_WM, std::span<const Pose> X_WB) {
  SensorStep step;
  step.surfaces.resize(touched.size());
  IntersectWorkspace workspace;
  for (std::size_t i = 0; i < touched.size(); ++i)
    if (touched[i].body != nullptr)
      intersect_touched(*model.body, touched[i], X_WM, X_WB[i], step.surfaces[i], workspace);
  SensorReading reading;
  read_sensor(model, surface_pointers(step), reading);
  return std::move(reading.values);
}

ModelReading read_in_place(ReadingModel as, const SensorModel& model, const std::vector<TouchedBody>& touched,
                           const StepView& step, std::size_t sensor) {
  TouchedPoses poses = touched_poses(step, sensor);
  return {as, read_own_contact(model, touched, step.sensors[sensor].X_WM, poses.X_WB), std::move(poses.unknown)};
}

}  // namespace taxel
