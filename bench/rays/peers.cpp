#include "rays/peers.h"

#include "core/mesh/ray_triangle.h"
#include "core/mesh/tlas.h"

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
