// Taxels whose mesh was replaced under them: how far they are from the new one, and the edit that brings them back.
#pragma once

#include <string>

#include "core/document/edit.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Distances of the taxels' centres from a skin [m].
struct SurfaceDistances {
  int taxels = 0;
  double mean = 0, largest = 0;
  int farthest = 0;  ///< id of the taxel that is the farthest
};
SurfaceDistances distances_to(const MeshIndex& skin, const Layout& layout);

/// "12 taxels lie 0.31 mm from its surface on average, taxel 3 the farthest with 0.82 mm"; empty without taxels.
std::string distances_text(const SurfaceDistances& distances);

/// All taxels and subtaxels at the nearest points of the skin, with its normals there. Each goes its own way: twins are
/// not mirrored.
SetTaxels projected_onto(const MeshIndex& skin, const Layout& layout);

}  // namespace taxel
