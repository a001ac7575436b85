// Scenes for the paths of ray casting: soft and rigid bodies, rays around their contact, and the hits by all paths.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "core/hydro/intersect.h"
#include "core/sensor/rays/cast_rays.h"
#include "core/sensor/rays/ray_tiles.h"
#include "core/sensor/rays/surface_caster.h"
#include "core/sensor/rays/tet_table.h"
#include "fixtures/random_pose.h"
#include "unit/sensor/ray_oracles.h"

namespace taxel {

inline const PressureField& field_of(const HydroBody& body) {
  return *std::get<SoftBody>(body.geometry).field;
}

inline HydroBodyPtr soft(ShapeType type, const dvec3& size, double resolution) {
  const Shape shape{type, size, nullptr, resolution};
  Material material;
  material.field = FieldKind::medial_axis;
  material.modulus = 1e5;
  return make_body(shape, material, "sensor");
}
inline HydroBodyPtr rigid(ShapeType type, const dvec3& size) {
  return make_body({type, size, nullptr, 0}, Material{}, "object");
}

/// Returns a sensor with only a body and rays.
inline SensorModel model_of(const HydroBodyPtr& body, std::vector<SensorRay> rays) {
  SensorModel model;
  model.body = body;
  model.rays = std::move(rays);
  model.ray_tables.tets = std::make_shared<TetTable>(field_of(*body), model.rays);
  model.ray_tables.tiles = std::make_shared<RayTiles>(model.rays);
  return model;
}

/// The hits by all paths on the same surfaces.
struct AllPaths {
  CastWorkspace workspace;
  RayHits table, tiles, bvh, raster;
  long nodes_beside_bvh = 0;  ///< nodes of trees visited by the other paths
  long nodes = 0;             ///< nodes of trees visited by the bvh path
  void cast(const SensorModel& model, const std::vector<const ContactSurface*>& surfaces) {
    cast_rays(model, surfaces, RayPath::tet_table, workspace, table);
    nodes_beside_bvh += static_cast<long>(workspace.caster->node_count());
    cast_rays(model, surfaces, RayPath::tiles, workspace, tiles);
    nodes_beside_bvh += static_cast<long>(workspace.caster->node_count());
    if (model.ray_tables.grid) {
      cast_rays(model, surfaces, RayPath::raster, workspace, raster);
      nodes_beside_bvh += static_cast<long>(workspace.caster->node_count());
    }
    cast_rays(model, surfaces, RayPath::bvh, workspace, bvh);
    nodes += static_cast<long>(workspace.caster->node_count());
  }
};

inline ::testing::AssertionResult same(const RayHit& a, const RayHit& b) {
  if (a.surface == b.surface && a.polygon == b.polygon && a.depth == b.depth && a.pressure == b.pressure)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "surface " << a.surface << " and " << b.surface << ", polygon " << a.polygon
                                       << " and " << b.polygon << ", depth " << a.depth << " and " << b.depth;
}

/// Scenes of one soft body and two objects, by number.
class RandomScenes {
 public:
  static constexpr double kSize = 0.02;
  [[nodiscard]] const HydroBodyPtr& body(int scene) const { return bodies_[static_cast<std::size_t>(scene % 2)]; }
  /// Returns one surface per object.
  [[nodiscard]] std::vector<ContactSurface> surfaces(int scene) const {
    std::vector<ContactSurface> surfaces(objects_.size());
    IntersectWorkspace workspace;
    const Pose X_WA = random_pose(1, scene, kSize);
    for (std::size_t o = 0; o < objects_.size(); ++o)
      intersect(*body(scene), *objects_[o], X_WA, random_pose(2 + o, scene, kSize), surfaces[o], workspace);
    return surfaces;
  }

 private:
  std::array<HydroBodyPtr, 2> bodies_{soft(ShapeType::sphere, dvec3(kSize), 0.02),
                                      soft(ShapeType::box, dvec3(kSize, 0.7 * kSize, 0.5 * kSize), 0.02)};
  std::array<HydroBodyPtr, 2> objects_{rigid(ShapeType::box, dvec3(kSize)), rigid(ShapeType::sphere, dvec3(kSize))};
};

/// Returns the target of ray i: corner k for every fourth ray, the middle of the edge from there for every fourth ray,
/// and `inside` for the others.
inline dvec3 aim_of(int i, const ContactSurface& surface, const ContactPolygon& polygon, std::size_t k,
                    const dvec3& inside) {
  const auto corner = [&](std::size_t n) {
    return surface.vertices[static_cast<std::size_t>(polygon.first) + n % static_cast<std::size_t>(polygon.count)];
  };
  return i % 4 == 0 ? corner(k) : i % 4 == 1 ? 0.5 * (corner(k) + corner(k + 1)) : inside;
}

/// Returns random segments around the contact. Every fourth aims at a corner, every fourth at the middle of an edge.
inline std::vector<SensorRay> random_rays(const std::vector<ContactSurface>& surfaces, double size, int count,
                                          std::uint64_t seed) {
  const CounterRng rng(seed);
  std::uint64_t next = 0;
  const auto pick = [&](std::size_t n) {
    return static_cast<std::size_t>(rng.uniform(next++) * static_cast<double>(n));
  };
  const auto vector = [&] {
    const double x = rng.uniform(next++), y = rng.uniform(next++), z = rng.uniform(next++);
    return dvec3(x, y, z) - 0.5;
  };
  std::vector<SensorRay> rays;
  for (int i = 0; i < count; ++i) {
    const ContactSurface& surface = surfaces[pick(surfaces.size())];
    if (surface.empty()) continue;
    const ContactPolygon& polygon = surface.polygons[pick(surface.polygons.size())];
    const std::size_t k = pick(static_cast<std::size_t>(polygon.count));
    const dvec3 aim = aim_of(i, surface, polygon, k, polygon.centroid + size * 0.5 * vector());
    const dvec3 from = aim + 0.6 * size * vector();
    rays.push_back({i, from, glm::normalize(aim - from), (0.4 + rng.uniform(next++)) * size});
  }
  return rays;
}

}  // namespace taxel
