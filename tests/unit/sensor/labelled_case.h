// Contacts whose artifact is known by construction: a sensor, what it touches, and poses one after the other.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/rng.h"
#include "core/hydro/intersect.h"
#include "core/mesh/primitives.h"
#include "core/sensor/explain/explanation.h"

namespace taxel::test {

/// One pose of a case: what was sensed there.
struct CaseStep {
  ContactSurface surface;
  SensorReading reading;
  SensorStep step;
};

struct LabelledCase {
  SensorModelPtr model;
  HydroBodyPtr other;
  std::vector<Pose> path;  ///< X_MB of what is touched
  ExplainLimits limits{.jump = 0.1, .equal_force = 0.02, .largest = 0};

  [[nodiscard]] std::unique_ptr<CaseStep> sense(const Pose& X_MB, double time = 0) const {
    auto out = std::make_unique<CaseStep>();
    IntersectWorkspace workspace;
    intersect(*model->body, *other, Pose{}, X_MB, out->surface, workspace);
    out->step.surfaces = {&out->surface};
    read_sensor(*model, out->step.surfaces, out->reading);
    out->step.hits = &out->reading.hits.all();
    out->step.readings = out->reading.values;
    out->step.time = time;
    return out;
  }
  [[nodiscard]] double force(const Pose& X_MB) const {
    ContactSurface surface;
    IntersectWorkspace workspace;
    intersect(*model->body, *other, Pose{}, X_MB, surface, workspace);
    return glm::length(pressure_wrench(surface).force);
  }
  /// The largest change of a reading along the path, explained: what a user stops at.
  [[nodiscard]] Explanation explain_largest_jump() const {
    std::vector<std::unique_ptr<CaseStep>> steps;
    for (std::size_t i = 0; i < path.size(); ++i) steps.push_back(sense(path[i], 0.001 * static_cast<double>(i)));
    ExplainLimits at = limits;
    for (const auto& s : steps)
      for (const double r : s->step.readings) at.largest = std::max(at.largest, r);
    double jump = -1;
    std::size_t step = 1;
    int taxel = 0;
    for (std::size_t i = 1; i < steps.size(); ++i)
      for (std::size_t k = 0; k < steps[i]->step.readings.size(); ++k) {
        const double change = std::abs(steps[i]->step.readings[k] - steps[i - 1]->step.readings[k]);
        if (change > jump) jump = change, step = i, taxel = static_cast<int>(k);
      }
    return Explainer().explain(model, taxel, steps[step]->step, &steps[step - 1]->step, at);
  }
};

inline HydroBodyPtr rigid_ball(double radius) {
  Shape shape;
  shape.type = ShapeType::sphere;
  shape.size = dvec3(radius);
  shape.resolution = radius / 12;
  return make_body(shape, {}, "ball");
}
inline HydroBodyPtr rigid_box(const dvec3& half) {
  Shape shape;
  shape.type = ShapeType::box;
  shape.size = half;
  return make_body(shape, {}, "box");
}

/// A capsule along z of radius 7 mm, 40 mm long; each vertex moved outward by up to +-`bump`.
inline TriMeshPtr bumpy_capsule(double bump, std::uint64_t seed, double edge = 0.002) {
  const TriMesh smooth = make_capsule(0.007, 0.013, edge);
  std::vector<dvec3> vertices = smooth.vertices();
  const CounterRng rng(seed);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    vertices[v] += bump * (2 * rng.uniform(v) - 1) * smooth.vertex_normals()[v];
  return std::make_shared<const TriMesh>(std::move(vertices), smooth.faces());
}

/// Five taxels in a row along z on the side +x of a capsule.
inline Layout capsule_layout(FieldKind field, double density) {
  Layout layout;
  layout.mesh.file = "capsule";
  layout.material.field = field;
  layout.sampling.density = density;
  layout.sampling.weights = SampleWeights::voronoi;
  for (int i = 0; i < 5; ++i)
    layout.taxels.push_back({i + 1, "", dvec3(0.007, 0, 0.005 * (i - 2)), dvec3(1, 0, 0), 0.004, {}});
  return layout;
}

inline SensorModelPtr preview_model(const Layout& layout, const TriMeshPtr& mesh) {
  SensorBuild how;
  how.quality = SampleQuality::preview;
  return build_sensor_model(layout, mesh, "", layout.mesh.file, how);
}

/// A ball led along z on the side +x of the capsule, `depth` below its radius.
inline std::vector<Pose> along_side(double ball, double depth, double from, double step, int count, double y = 0) {
  std::vector<Pose> path;
  for (int i = 0; i < count; ++i) path.push_back({{1, 0, 0, 0}, dvec3(0.007 + ball - depth, y, from + step * i)});
  return path;
}

}  // namespace taxel::test
