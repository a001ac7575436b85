#include "core/hydro/kernel/workspace.h"

#include <algorithm>

namespace taxel {

void IntersectWorkspace::begin_call(std::size_t vertices, std::size_t tets_of_field) {
  if (placed.size() < vertices) placed.resize(vertices);
  if (seen_in.size() < tets_of_field) seen_in.resize(tets_of_field, 0);
  constexpr std::uint32_t kNearEnd = 0x80000000u;  // from here on the counters restart without marks
  if (++call > kNearEnd) {
    placed.assign(placed.size(), {});
    met.clear();
    call = 1;
  }
  if (facet > kNearEnd) {
    std::fill(seen_in.begin(), seen_in.end(), 0u);
    facet = 0;
  }
}

}  // namespace taxel
