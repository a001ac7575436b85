#include "core/sim/compare/contact_again.h"

#include <fmt/format.h>

#include "core/hydro/kernel/workspace.h"
#include "core/sensor/readout/reading.h"

namespace taxel {

TouchedPoses touched_poses(const SimScene& scene, std::size_t sensor, std::span<const SensorStep> sensors,
                           std::span<const Pose> X_WG) {
  TouchedPoses poses;
  if (scene.touched.empty()) return poses;
  for (const TouchedBody& body : scene.touched[sensor]) {
    if (body.body == nullptr)
      poses.unknown = fmt::format("without geom \"{}\": its pose or its material is not known", body.name);
    poses.X_WB.push_back(body.sensor >= 0 ? sensors[static_cast<std::size_t>(body.sensor)].X_WM
                         : body.geom >= 0 ? X_WG[static_cast<std::size_t>(body.geom)]
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

}  // namespace taxel
