#include "core/hydro/kernel/polygon_ends.h"

#include "core/base/index.h"

namespace taxel {

CoveredRegion::Ends ends_of(const PackedTet& tet, std::span<const dvec3> x) {
  constexpr double kOnFace = 1e-5;  // of the tet's size: ten times the distance below which vertices are merged
  CoveredRegion::Ends ends;
  for (std::size_t face = 0; face < 4; ++face) {
    if (tet.neighbour[face] >= 0) continue;
    const bool is_skin = (tet.core_faces >> face & 1u) == 0;
    const dvec3 normal(tet.nx[face], tet.ny[face], tet.nz[face]);
    const auto on_face = [&](std::size_t i) {
      return std::abs(glm::dot(normal, x[i]) + tet.offset[face]) <= kOnFace * tet.size;
    };
    bool before = on_face(0);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const bool after = on_face((k + 1) % x.size());
      if (before && after) {
        ends.all |= 1u << k;
        if (is_skin) ends.at_skin |= 1u << k;
      }
      before = after;
    }
  }
  return ends;
}

}  // namespace taxel
