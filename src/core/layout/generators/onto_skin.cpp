#include "core/layout/generators/onto_skin.h"

#include <fmt/format.h>

#include "core/layout/generators/place.h"

namespace taxel {
namespace {

template <class T>
void bring(T& disc, const MeshIndex& skin, double farthest, const std::string& where) {
  require_finite("points", where, disc.center);
  const SurfacePoint at = skin.closest_point(disc.center);
  if (at.distance > farthest)
    throw Error("points", where,
                fmt::format("is {:.4g} m from the surface, more than {:.4g} m: is the unit another one?", at.distance,
                            farthest));
  disc.center = at.position;
  disc.normal = smooth_normal(skin.mesh(), at);
}

}  // namespace

std::vector<Taxel> onto_skin(std::vector<Taxel> taxels, const MeshIndex& skin, double farthest) {
  for (Taxel& taxel : taxels) {
    bring(taxel, skin, farthest, fmt::format("taxel {}", taxel.id));
    for (std::size_t i = 0; i < taxel.subtaxels.size(); ++i)
      bring(taxel.subtaxels[i], skin, farthest, fmt::format("taxel {}, subtaxel {}", taxel.id, i));
  }
  return taxels;
}

}  // namespace taxel
