// Nearest points of queries that follow each other closely.
#pragma once

#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Finds the same points as MeshIndex::closest_point, faster if each query is near the one before: by the triangle
/// inequality the last distance bounds the next one. Each thread needs its own.
class NearestInTurn {
 public:
  /// The index must outlive this object.
  explicit NearestInTurn(const MeshIndex& index) : index_(&index) {}

  [[nodiscard]] SurfacePoint closest_point(const dvec3& p) {
    constexpr double kRounding = 1 + 1e-9;
    const double most = kRounding * (last_distance_ + glm::distance(p, last_point_));
    SurfacePoint point = index_->closest_point(p, most);
    if (point.face < 0) point = index_->closest_point(p);
    last_point_ = p;
    last_distance_ = point.distance;
    return point;
  }

 private:
  const MeshIndex* index_;
  dvec3 last_point_{0};
  double last_distance_ = std::numeric_limits<double>::infinity();
};

}  // namespace taxel
