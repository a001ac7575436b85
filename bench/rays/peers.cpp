#include "rays/peers.h"

#include <span>

#include "core/mesh/query/bvh.h"
#include "core/mesh/query/triangle.h"

namespace taxel::bench {
namespace {

class Own final : public RayCaster {
 public:
  Own(const SensorModel& sensor, RayPath path) : sensor_(sensor), path_(path) {}
  [[nodiscard]] std::string name() const override {
    return path_ == RayPath::tet_table ? "tet table" : path_ == RayPath::raster ? "raster" : "BVH";
  }
  void cast(const std::vector<const ContactSurface*>& surfaces) override {
    cast_rays(sensor_, surfaces, path_, workspace_, hits_);
  }
  [[nodiscard]] std::vector<RayHit> hits() const override { return hits_.all(); }

 private:
  const SensorModel& sensor_;
  RayPath path_;
  CastWorkspace workspace_;
  RayHits hits_;
};

/// A tree over trees: several BVHs (BLAS) in one frame under one top-level BVH (TLAS). Refers to the BLAS, which must
/// outlive it and stay as they are until the next build.
class Tlas {
 public:
  /// Builds over the root boxes; empty trees are allowed and never hit. Keeps the memory of the last build.
  void build(std::span<const Bvh* const> blas) {
    blas_.assign(blas.begin(), blas.end());
    boxes_.clear();
    for (const Bvh* tree : blas_) boxes_.push_back(tree->empty() ? Aabb{} : tree->nodes()[0].box);
    top_.build(boxes_, 1);
  }

  /// Front-to-back walk through all trees. test(instance, primitive, t_max) returns the new t_max, as for Bvh::cast.
  template <class Test>
  double cast(const Ray& ray, const Test& test) const {
    return top_.cast(ray, [&](int instance, double t_max) {
      const Ray limited{ray.origin, ray.direction, t_max};
      return blas_[static_cast<std::size_t>(instance)]->cast(
          limited, [&](int primitive, double limit) { return test(instance, primitive, limit); });
    });
  }

 private:
  std::vector<const Bvh*> blas_;
  std::vector<Aabb> boxes_;
  Bvh top_;
};

class Paper final : public RayCaster {
 public:
  explicit Paper(const SensorModel& sensor) : sensor_(sensor), hits_(sensor.rays.size()) {}
  [[nodiscard]] std::string name() const override { return "paper"; }

  void cast(const std::vector<const ContactSurface*>& surfaces) override {
    triangles_.resize(surfaces.size());
    blas_.resize(surfaces.size());
    trees_.clear();
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      build(*surfaces[s], s);
      trees_.push_back(&blas_[s]);
    }
    tlas_.build(trees_);
    for (std::size_t r = 0; r < hits_.size(); ++r) hits_[r] = first_hit(sensor_.rays[r]);
  }
  [[nodiscard]] std::vector<RayHit> hits() const override { return hits_; }

 private:
  struct Triangle {
    std::array<dvec3, 3> x;
    std::array<double, 3> pressure;
    int polygon = 0;
  };

  void build(const ContactSurface& surface, std::size_t number) {
    auto& triangles = triangles_[number];
    triangles.clear();
    boxes_.clear();
    for (std::size_t i = 0; i < surface.polygons.size(); ++i) {
      const ContactPolygon& polygon = surface.polygons[i];
      for (int k = 0; k < polygon.count; ++k) {
        const auto a = static_cast<std::size_t>(polygon.first + k);
        const auto b = static_cast<std::size_t>(polygon.first + (k + 1) % polygon.count);
        triangles.push_back({{polygon.centroid, surface.vertices[a], surface.vertices[b]},
                             {polygon.pressure, surface.pressure[a], surface.pressure[b]},
                             static_cast<int>(i)});
        Aabb box;
        for (const dvec3& x : triangles.back().x) box.include(x);
        boxes_.push_back(box);
      }
    }
    blas_[number].build(boxes_);
  }

  [[nodiscard]] RayHit first_hit(const SensorRay& r) const {
    RayHit best;
    const Ray ray{r.origin, r.direction, r.max_depth};
    const RayTriangleTest test(ray);
    tlas_.cast(ray, [&](int surface, int number, double t_max) {
      const Triangle& t = triangles_[static_cast<std::size_t>(surface)][static_cast<std::size_t>(number)];
      const auto found = test(t.x[0], t.x[1], t.x[2], t_max);
      if (!found) return t_max;
      const dvec3 pressure(t.pressure[0], t.pressure[1], t.pressure[2]);
      const RayHit hit{surface, t.polygon, found->t, glm::dot(found->barycentric, pressure)};
      if (hit.before(best)) best = hit;
      return best.depth;
    });
    return best;
  }

  const SensorModel& sensor_;
  std::vector<RayHit> hits_;
  std::vector<std::vector<Triangle>> triangles_;
  std::vector<Bvh> blas_;
  std::vector<const Bvh*> trees_;
  std::vector<Aabb> boxes_;
  Tlas tlas_;
};

}  // namespace

std::unique_ptr<RayCaster> make_own(const SensorModel& sensor, RayPath path) {
  return std::make_unique<Own>(sensor, path);
}

std::unique_ptr<RayCaster> make_paper(const SensorModel& sensor) {
  return std::make_unique<Paper>(sensor);
}

#ifndef TAXEL_HAVE_EMBREE
std::vector<std::unique_ptr<RayCaster>> make_embree(const SensorModel&) {
  return {};
}
#endif

}  // namespace taxel::bench
