// What casting by polygons keeps from call to call, so that no step allocates once the largest surface was seen.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/edge_planes.h"

namespace taxel {

/// Polygons go in blocks through stages that only append to lists: pairs of a polygon and a ray that passes by it,
/// those of them that meet its plane, those inside its edges.
struct CastBuffers {
  /// A polygon's edge planes (edge_planes.h) side by side, for up to eight edges at a time.
  static constexpr std::size_t kEdges = 8;
  struct alignas(64) Edges {
    std::array<double, kEdges> mx, my, mz, c;  ///< all 0 beyond the last edge: everything is inside
    std::array<double, kEdges> length;         ///< of the edge, by its largest component [m]
  };
  std::vector<Edges> edges{1};
  std::vector<dvec3> corners;  ///< of a polygon at the end of its surface, with room behind them

  NumberBuffer<double> circle;                        ///< by polygon of the block: squared radius [m^2]
  NumberBuffer<std::int32_t> near_polygon, near_ray;  ///< pairs, with room behind the last for whole vectors
  NumberBuffer<double> t, x, y, z;                    ///< by pair: in the plane, along the ray, from the centroid [m]
  NumberBuffer<std::int32_t> met, inside;             ///< pairs that meet the plane; of those the ones inside
};

}  // namespace taxel
