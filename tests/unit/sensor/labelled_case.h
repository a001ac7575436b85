// Contacts whose artifact is known by construction: a sensor, what it touches, and poses one after the other.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/hydro/intersect.h"
#include "core/mesh/primitives.h"
#include "core/sensor/explain/explanation.h"
#include "fixtures/pad_meshes.h"

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

/// A finger along z of radius 7 mm, 40 mm long.
inline TriMeshPtr finger_mesh(double edge = 0.002) {
  return std::make_shared<const TriMesh>(make_capsule(0.007, 0.013, edge));
}
inline TriMeshPtr egg_mesh() {
  return std::make_shared<const TriMesh>(make_ellipsoid(dvec3(0.007, 0.007, 0.018), 0.0015));
}

inline TriMesh round_ring(double radius, double tube) {
  return make_torus(radius, tube, 64, 32);
}

/// A finger of radius 6 mm bent to most of a half circle of radius 18 mm about (-18 mm, 0, 0): its inner side is turned
/// toward its centroid.
inline TriMeshPtr hook_mesh() {
  const TriMesh straight = make_capsule(0.006, 0.020, 0.0015);
  std::vector<dvec3> vertices = straight.vertices();
  constexpr double kBend = 0.018;
  for (dvec3& v : vertices)
    v = {(kBend + v.x) * std::cos(v.z / kBend) - kBend, v.y, (kBend + v.x) * std::sin(v.z / kBend)};
  return std::make_shared<const TriMesh>(std::move(vertices), straight.faces());
}

inline Layout layout_of(FieldKind field, double density, SampleWeights weights = SampleWeights::voronoi,
                        std::uint64_t seed = 42) {
  Layout layout;
  layout.mesh.file = "case";
  layout.material.field = field;
  layout.sampling.density = density;
  layout.sampling.weights = weights;
  layout.sampling.seed = seed;
  return layout;
}

/// A taxel at the skin's point nearest to p.
inline void add_taxel(Layout& layout, const TriMeshPtr& mesh, const dvec3& p, double radius) {
  const SurfacePoint s = MeshIndex(mesh).closest_point(p);
  const int id = static_cast<int>(layout.taxels.size()) + 1;
  layout.taxels.push_back({id, "", s.position, mesh->face_normals()[static_cast<std::size_t>(s.face)], radius, {}});
}
/// Five taxels in a row along z on the side +x of the finger.
inline void add_row(Layout& layout, const TriMeshPtr& mesh) {
  for (int i = -2; i <= 2; ++i) add_taxel(layout, mesh, dvec3(0.007, 0, 0.005 * i), 0.004);
}

inline SensorModelPtr preview_model(const Layout& layout, const TriMeshPtr& mesh) {
  SensorBuild how;
  how.quality = SampleQuality::preview;
  return build_sensor_model(layout, mesh, "", layout.mesh.file, how);
}

/// Led in a straight line.
inline std::vector<Pose> led(const dquat& q, const dvec3& from, const dvec3& step, int count) {
  std::vector<Pose> path;
  for (int i = 0; i < count; ++i) path.push_back({q, from + static_cast<double>(i) * step});
  return path;
}
/// A ball along z on the side +x of the finger.
inline std::vector<Pose> along_finger(double ball, double depth, double from, double step, int count) {
  return led({1, 0, 0, 0}, dvec3(0.007 + ball - depth, 0, from), dvec3(0, 0, step), count);
}
/// A ball pressed at the skin's point nearest to p, against its normal.
inline Pose tap(const TriMeshPtr& mesh, const dvec3& p, double ball, double depth) {
  const SurfacePoint s = MeshIndex(mesh).closest_point(p);
  return {{1, 0, 0, 0}, s.position + (ball - depth) * mesh->face_normals()[static_cast<std::size_t>(s.face)]};
}
/// Two taps, before and behind a taxel at p in the direction `across`.
inline std::vector<Pose> two_taps(const TriMeshPtr& mesh, const dvec3& p, const dvec3& across, double ball,
                                  double depth) {
  return {tap(mesh, p - across, ball, depth), tap(mesh, p + across, ball, depth)};
}
/// Taps, each as deep as it takes for a force.
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
