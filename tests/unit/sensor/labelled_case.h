// Contacts with an artifact that is known by construction: a sensor, the touched body, and a sequence of poses.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/hydro/intersect.h"
#include "core/sensor/explain/explainer.h"
#include "fixtures/touches.h"

namespace taxel::test {

struct LabelledCase {
  SensorModelPtr model;
  HydroBodyPtr other;
  std::vector<Pose> path;  ///< poses X_MB of the touched body
  ExplainLimits limits{.jump = 0.1, .equal_force = 0.02, .largest = 0};

  /// Returns the contact at one pose, without damping and friction.
  [[nodiscard]] SensorStep sense(const Pose& X_MB, double time = 0) const {
    SensorStep out;
    IntersectWorkspace workspace;
    intersect(*model->body, *other, Pose{}, X_MB, out.surfaces.emplace_back(), workspace);
    SensorReading reading;
    read_sensor(*model, surface_pointers(out), reading);
    out.model = model;
    out.time = time;
    out.readings = reading.values;
    out.force_W = pressure_wrench(out.surfaces.front()).force;
    out.hits = reading.hits.all();
    return out;
  }
  [[nodiscard]] double force(const Pose& X_MB) const {
    ContactSurface surface;
    IntersectWorkspace workspace;
    intersect(*model->body, *other, Pose{}, X_MB, surface, workspace);
    return glm::length(pressure_wrench(surface).force);
  }
  /// Explains the largest change of a reading along the path.
  [[nodiscard]] Explanation explain_largest_jump() const {
    std::vector<SensorStep> steps;
    for (std::size_t i = 0; i < path.size(); ++i) steps.push_back(sense(path[i], 0.001 * static_cast<double>(i)));
    ExplainLimits at = limits;
    for (const SensorStep& s : steps)
      for (const double r : s.readings) at.largest = std::max(at.largest, r);
    double jump = -1;
    std::size_t step = 1;
    int taxel = 0;
    for (std::size_t i = 1; i < steps.size(); ++i)
      for (std::size_t k = 0; k < steps[i].readings.size(); ++k) {
        const double change = std::abs(steps[i].readings[k] - steps[i - 1].readings[k]);
        if (change > jump) jump = change, step = i, taxel = static_cast<int>(k);
      }
    return Explainer().explain(taxel, steps[step], &steps[step - 1], at);
  }
};

inline HydroBodyPtr rigid_ball(double radius) {
  return make_body(ball_shape(radius), {}, "ball");
}

inline SensorModelPtr preview_model(const Layout& layout, const TriMeshPtr& mesh) {
  SensorBuild how;
  how.quality = SampleQuality::preview;
  return build_sensor_model(layout, mesh, "", layout.mesh.file, how);
}

/// Returns a touch that is sensed with a preview of the samples.
inline LabelledCase sensed(const Touch& touch) {
  LabelledCase c;
  c.model = preview_model(touch.layout, touch.mesh);
  c.other = make_body(touch.other, {}, "other");
  c.path = touch.path;
  return c;
}
/// Returns presses that are each deep enough for a force.
inline std::vector<Pose> equal_taps(const LabelledCase& c, const TriMeshPtr& mesh, const std::vector<dvec3>& at,
                                    double ball, double force) {
  std::vector<Pose> path;
  for (const dvec3& p : at) {
    double low = 0, high = 0.0018;
    for (int i = 0; i < 30; ++i) {
      const double depth = 0.5 * (low + high);
      (c.force(tap(mesh, p, ball, depth)) < force ? low : high) = depth;
    }
    path.push_back(tap(mesh, p, ball, high));
  }
  return path;
}

}  // namespace taxel::test
