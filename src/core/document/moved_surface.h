// Taxels after a replacement of their mesh: their distances from the new skin, and the edit that moves them onto it.
#pragma once

#include <string>

#include "core/document/edit.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Distances of the taxels' centres from a skin [m].
struct SurfaceDistances {
  int taxels = 0;
  double mean = 0, largest = 0;
  int farthest = 0;  ///< id of the farthest taxel
};
SurfaceDistances distances_to(const MeshIndex& skin, const Layout& layout);

/// Returns a sentence: "12 taxels lie 0.31 mm from its surface on average, taxel 3 the farthest with 0.82 mm"; empty
/// without taxels.
std::string distances_text(const SurfaceDistances& distances);

/// Returns the edit that moves all taxels and subtaxels to the nearest points of the skin and gives them its normals
/// there. Mirrored taxels do not follow, because each taxel moves by itself.
SetTaxels projected_onto(const MeshIndex& skin, const Layout& layout);

}  // namespace taxel
