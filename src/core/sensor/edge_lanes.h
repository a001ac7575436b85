// What vectorised ray tests read of a polygon.
#pragma once

#include <array>
#include <vector>

#include "core/sensor/edge_planes.h"

namespace taxel {

/// A polygon's edge planes (edge_planes.h) side by side, for up to eight edges at a time; kept between calls.
struct EdgeLanes {
  static constexpr std::size_t kEdges = 8;
  struct alignas(64) Group {
    std::array<double, kEdges> mx, my, mz, c;  ///< all 0 beyond the last edge: everything is inside
    std::array<double, kEdges> length;         ///< of the edge, by its largest component [m]
  };
  std::vector<Group> groups{1};
  std::vector<dvec3> corners;  ///< of a polygon at the end of its surface, with room behind them
};

}  // namespace taxel
