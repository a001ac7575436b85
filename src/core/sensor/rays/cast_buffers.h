// Scratch memory of casting by polygons. It is reused, so that no step allocates after the largest surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/sensor/rays/edge_planes.h"

namespace taxel {

/// A contact polygon in a view (ray_view.h), whose rays are nearly parallel to its axis; in single precision.
struct RayTarget {
  static constexpr std::size_t kGroup = 4, kGroups = 2;
  std::array<float, 4> centroid{}, normal{};  ///< depth, u, v
  float slack = 0, tilt = 0;                  ///< error of edge distances: constant, and per 1 / |rise| [m^2]
  /// For a point at u, v from the centroid, du[k] v - dv[k] u + c[k] is the length of edge k times the distance of the
  /// point to the inside of the edge. Places after the last edge repeat other edges.
  struct Edges {
    std::array<float, kGroup> du{}, dv{}, c{};
  };
  std::array<Edges, kGroups> edges{};
};

/// The scratch memory.
struct CastBuffers {
  RayTarget target;                         ///< tested polygon
  NumberBuffer<std::int32_t> polygon, ray;  ///< pairs of a polygon and a ray that surely hits it
  std::vector<EdgePlane> planes;            ///< edges of a polygon whose rim is near a ray
  std::vector<dvec3> corners;               ///< corners of the last polygon of a surface, with padding
};

}  // namespace taxel
