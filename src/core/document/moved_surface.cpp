#include "core/document/moved_surface.h"

#include <fmt/format.h>

#include "core/document/taxel_fixes.h"

namespace taxel {

SurfaceDistances distances_to(const MeshIndex& skin, const Layout& layout) {
  SurfaceDistances distances;
  double sum = 0;
  for (const Taxel& taxel : layout.taxels) {
    if (!is_finite(taxel.center)) continue;
    const double distance = skin.closest_point(taxel.center).distance;
    sum += distance;
    if (distances.taxels++ == 0 || distance > distances.largest) {
      distances.largest = distance;
      distances.farthest = taxel.id;
    }
  }
  if (distances.taxels > 0) distances.mean = sum / distances.taxels;
  return distances;
}

std::string distances_text(const SurfaceDistances& distances) {
  constexpr double kMillimetres = 1e3;
  if (distances.taxels == 0) return {};
  if (distances.taxels == 1)
    return fmt::format("Taxel {} lies {:.3g} mm from its surface", distances.farthest,
                       kMillimetres * distances.largest);
  return fmt::format("{} taxels lie {:.3g} mm from its surface on average, taxel {} the farthest with {:.3g} mm",
                     distances.taxels, kMillimetres * distances.mean, distances.farthest,
                     kMillimetres * distances.largest);
}

SetTaxels projected_onto(const MeshIndex& skin, const Layout& layout) {
  SetTaxels edit;
  edit.twins_follow = false;
  for (const Taxel& taxel : layout.taxels) edit.changes.push_back(projected(taxel, skin));
  return edit;
}

}  // namespace taxel
