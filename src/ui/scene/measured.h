// A distance on the skin: the request and its result.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "core/mesh/query/closest_point.h"

namespace taxel::ui {

/// Request for the distance of two points, frame M.
struct MeasureRequest {
  std::shared_ptr<const MeshIndex> skin;
  dvec3 a{0}, b{0};  ///< the path connects the nearest points of the skin
  bool operator==(const MeasureRequest&) const = default;
};

struct Measured {
  MeasureRequest request;
  double straight = 0;                                     ///< Euclidean distance from a to b [m]
  double along = std::numeric_limits<double>::infinity();  ///< geodesic distance [m]; infinite without a path
  std::vector<dvec3> path;                                 ///< path on the surface; empty if there is none
};
using MeasuredPtr = std::shared_ptr<const Measured>;

}  // namespace taxel::ui
