// Exactly N taxels spread over a region, each as far from the others along the skin as it can be.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

struct Spread {
  int count = 1;
  std::vector<int> faces;  ///< the region, each face once; empty: the whole mesh
  int candidates = 0;      ///< places to choose from; 0: 30 per taxel, at least 2000
  std::uint64_t seed = 42;
  double radius = 0.005;  ///< of the receptive fields [m]
};

struct SpreadTaxels {
  std::vector<Taxel> taxels;  ///< ids in the order of choice: the first k are a spread of k
  /// Least length of a path between two of them [m]; infinity for one taxel, or where no two are joined by a path.
  double least_distance = 0;
};

/// Farthest points first (Gonzalez 1985, "Clustering to minimize the maximum intercluster distance"), by exact geodesic
/// distance, among candidates that are even over the region's area. The least distance is at least half of the largest
/// that any `count` of the candidates can have. The seed makes the candidates and picks the first taxel; ties go to the
/// candidate of the lowest index. Paths may leave the region. Throws Error naming the parameter, Cancelled through
/// `progress`.
SpreadTaxels geodesic_spread(const Spread& spread, const MeshIndex& skin, Progress* progress = nullptr);

}  // namespace taxel
