// Memory that a caller of the contact kernel keeps between calls.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/hydro/kernel/depth_workspace.h"
#include "core/hydro/kernel/index/met_pairs.h"

namespace taxel {

/// A vertex in the frame of the other body.
struct PlacedVertex {
  dvec3 x{0};
  std::int32_t tet = -1;   ///< tet that contains the point, or -1 if none was found
  std::uint32_t call = 0;  ///< number of the call that wrote this entry
};

/// Memory of intersect(). No step allocates memory after the first steps, except where bodies
/// reach new places beyond the tets of a pad. Each thread needs its own; the content has no
/// meaning between calls.
struct IntersectWorkspace {
  /// Finds pairs only by trees, without tet-to-tet traversal: the same polygons in another order. For tests.
  bool tree_form = false;
  DepthPieceSize piece_size;

  std::vector<std::int32_t> facets;    ///< facets of the rigid mesh, or tets or faces of B, that may touch A
  std::vector<std::int32_t> tets;      ///< tets that may touch one facet
  std::vector<std::int32_t> found;     ///< faces of the boundary that may
  std::vector<PlacedVertex> placed;    ///< vertices of the rigid mesh, or of B
  std::vector<std::uint32_t> seen_in;  ///< for each tet: last facet that touched it, counted over all calls
  MetPairs met;
  DepthWorkspace depth;  ///< memory for pairs that reach beyond a pad's tets
  std::uint32_t call = 0, facet = 0;

  /// Makes room for this number of vertices and tets, and begins a new call.
  void begin_call(std::size_t vertices, std::size_t tets_of_field = 0);
};

}  // namespace taxel
