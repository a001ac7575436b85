// Spreads N taxels over a region, with large distances between them along the skin.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/layout/layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Parameters of a spread.
struct Spread {
  int count = 1;
  std::vector<int> faces;  ///< faces of the region, each once; empty for the whole mesh
  int candidates = 0;      ///< number of candidates; 0 means 30 per taxel, but at least 2000
  std::uint64_t seed = 42;
  double radius = 0.005;  ///< radius of the receptive fields [m]
};

/// Result of a spread.
struct SpreadTaxels {
  std::vector<Taxel> taxels;  ///< taxels in the order of choice: the first k are a spread of k
  /// Smallest geodesic distance of two taxels [m]; infinity for one taxel, or if no path joins two taxels.
  double least_distance = 0;
};

/// Returns taxels chosen farthest point first (Gonzalez 1985, "Clustering to minimize the maximum intercluster
/// distance") by exact geodesic distance, among candidates that are even over the region's area. The least distance is
/// at least half of the largest one that any `count` candidates can have. The seed determines the candidates and the
/// first taxel; of equally far candidates the one of the lowest index is chosen. Paths may leave the region. Throws
/// Error that names the parameter, and Cancelled through `progress`.
SpreadTaxels geodesic_spread(const Spread& spread, const MeshIndex& skin, Progress* progress = nullptr);

}  // namespace taxel
