// A compact copy of the geodesic distances from one source.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/mesh/geodesic/geodesic_distance.h"

namespace taxel {

/// Distances from the source of one propagation. Immutable; safe to share between threads.
class GeodesicMap {
 public:
  GeodesicMap() = default;
  /// Copies the result of the last propagation of `from`, about 50 bytes per window.
  GeodesicMap(std::shared_ptr<const UnfoldedMesh> mesh, const GeodesicDistance& from, const dvec3& source);

  /// Returns the same bits as GeodesicDistance::to.
  [[nodiscard]] double to(int face, const dvec3& target) const;

 private:
  struct Face {
    int face = -1;
    std::array<double, 3> at_apex{};         ///< distance of the apex of each half-edge [m]
    std::array<std::uint32_t, 4> windows{};  ///< half-edge c has the windows [windows[c], windows[c + 1])
  };
  std::shared_ptr<const UnfoldedMesh> mesh_;
  std::vector<Face> faces_;  ///< reached faces, ascending
  std::vector<GeodesicWindow> windows_;
  double radius_ = 0;
  int source_face_ = -1;
  dvec2 source_{0};
};

}  // namespace taxel
