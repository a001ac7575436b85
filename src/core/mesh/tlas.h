// A tree over trees: several BVHs (BLAS) in one frame under one top-level BVH (TLAS).
#pragma once

#include <span>
#include <vector>

#include "core/mesh/bvh.h"

namespace taxel {

/// Refers to the BLAS, which must outlive it and stay as they are until the next build.
class Tlas {
 public:
  /// Builds over the root boxes; empty trees are allowed and never hit. Keeps the memory of the last build.
  void build(std::span<const Bvh* const> blas);

  [[nodiscard]] const Bvh& top() const { return top_; }  ///< its primitives are the instances

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

}  // namespace taxel
