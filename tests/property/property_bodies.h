// Bodies of similar size, and poses in which most of them touch.
#pragma once

#include "fixtures/hydro_bodies.h"
#include "fixtures/random_pose.h"

namespace taxel {

inline constexpr double kSize = 0.01;  ///< approximate size of all bodies here [m]
inline constexpr int kPoses = 200;

/// Returns a pad on an asymmetric ellipsoid.
inline HydroBodyPtr soft_body() {
  static const HydroBodyPtr body = [] {
    TriMesh mesh = make_ellipsoid(kSize * dvec3(1.3, 1.0, 0.8), 0.9 * kSize);
    return make_mesh_body(std::move(mesh), soft_material(1e5, 0.3 * kSize));
  }();
  return body;
}

inline const PressureField& field_of(const HydroBody& body) {
  return *std::get<SoftBody>(body.geometry).field;
}

/// Returns a sphere with dents and bumps.
inline TriMesh lumpy_mesh() {
  const TriMesh sphere = make_icosphere(kSize, 2);
  std::vector<dvec3> vertices = sphere.vertices();
  const CounterRng rng(5);
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] *= 0.6 + 0.6 * rng.uniform(v);
  return {std::move(vertices), sphere.faces()};
}

/// Returns the same shapes as soft bodies with a material.
inline HydroBodyPtr shape_body(ShapeType type, const Material& material) {
  switch (type) {
    case ShapeType::plane:
      return make_simple_body(type, dvec3(0), material);
    case ShapeType::sphere:
      return make_simple_body(type, dvec3(kSize), material, 0.7 * kSize);
    case ShapeType::box:
      return make_simple_body(type, kSize * dvec3(1.0, 0.8, 0.6), material);
    case ShapeType::capsule:
      return make_simple_body(type, kSize * dvec3(0.6, 0.7, 0), material, 0.7 * kSize);
    case ShapeType::cylinder:
      return make_simple_body(type, kSize * dvec3(0.7, 0.8, 0), material, 0.7 * kSize);
    case ShapeType::ellipsoid:
      return make_simple_body(type, kSize * dvec3(1.2, 0.7, 0.5), material, 0.7 * kSize);
    default:
      return make_mesh_body(lumpy_mesh(), material);
  }
}

inline HydroBodyPtr rigid_body(ShapeType type) {
  return shape_body(type, {});
}

inline Pose soft_pose(int i) {
  return random_pose(11, i, 10 * kSize);
}

/// Returns a pose near the soft body. About three quarters of these poses touch it.
inline Pose rigid_pose(const Pose& X_WS, int i) {
  return X_WS * random_pose(12, i, 1.2 * kSize);
}

}  // namespace taxel
