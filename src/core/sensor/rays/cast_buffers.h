// What casting by polygons keeps from call to call, so that no step allocates once the largest surface was seen.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/rays/edge_planes.h"

namespace taxel {

/// A contact polygon as rays see it that run nearly along the axis of a view (ray_view.h), in single precision.
struct RayTarget {
  static constexpr std::size_t kGroup = 4, kGroups = 2;
  std::array<float, 4> centroid{}, normal{};  ///< depth, u, v
  float slack = 0, tilt = 0;                  ///< what rounding may do to what edges see, and per 1 / |rise| [m^2]
  /// Of a point at u, v from the centroid, edge k sees du[k] v - dv[k] u + c[k]: its length times how far inside of it
  /// the point is. Edges beyond the last one are others again.
  struct Edges {
    std::array<float, kGroup> du{}, dv{}, c{};
  };
  std::array<Edges, kGroups> edges{};
};

struct CastBuffers {
  RayTarget target;                         ///< the polygon that is tested
  NumberBuffer<std::int32_t> polygon, ray;  ///< pairs of which the ray runs through the polygon for certain
  std::vector<EdgePlane> planes;            ///< of a polygon that a ray may meet or miss by a rounding
  std::vector<dvec3> corners;               ///< of a polygon at the end of its surface, with room behind them
};

}  // namespace taxel
