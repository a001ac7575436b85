// A distance on the skin: the request and its result.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/mesh/query/closest_point.h"

namespace taxel::ui {

/// Frame M.
struct MeasureRequest {
  std::shared_ptr<const MeshIndex> skin;
  dvec3 a{0}, b{0};  ///< the path begins and ends at the points of the skin nearest to them
  bool operator==(const MeasureRequest&) const = default;
};

struct Measured {
  MeasureRequest request;
  double straight = 0;                                     ///< from a to b [m]
  double along = std::numeric_limits<double>::infinity();  ///< the surface; infinite where no path leads [m]
  std::vector<dvec3> path;                                 ///< on the surface; empty where none leads
};
using MeasuredPtr = std::shared_ptr<const Measured>;

}  // namespace taxel::ui
