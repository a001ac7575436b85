// The geodesic distances from one source, kept: what GeodesicDistance knew after a propagation, in the memory that
// takes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/mesh/geodesic/geodesic_distance.h"

namespace taxel {

/// Immutable; safe to share between threads.
class GeodesicMap {
 public:
  GeodesicMap() = default;
  /// Of the last propagation of `from`. Memory: some 50 bytes per window of it.
  GeodesicMap(std::shared_ptr<const UnfoldedMesh> mesh, const GeodesicDistance& from, const dvec3& source);

  /// As GeodesicDistance::to, to the last bit.
  [[nodiscard]] double to(int face, const dvec3& target) const;

 private:
  struct Face {
    int face = -1;
    std::array<double, 3> at_apex{};         ///< by half-edge
    std::array<std::uint32_t, 4> windows{};  ///< of half-edge c: [windows[c], windows[c + 1])
  };
  std::shared_ptr<const UnfoldedMesh> mesh_;
  std::vector<Face> faces_;  ///< ascending
  std::vector<GeodesicWindow> windows_;
  double radius_ = 0;
  int source_face_ = -1;
  dvec2 source_{0};
};

}  // namespace taxel
