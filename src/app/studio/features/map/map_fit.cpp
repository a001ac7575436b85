#include "app/studio/features/map/map_fit.h"

#include <algorithm>
#include <limits>

namespace taxel::ui {

MapFit fit_map(const FlatMap& map, const ImVec2& origin, const ImVec2& size, float line) {
  constexpr float kMargins = 0.6f, kMaxRadius = 2.2f;  // in heights of text
  constexpr float kMinRadius = 1.5f;                   // [pixels]
  dvec2 lo(std::numeric_limits<double>::infinity()), hi(-lo);
  for (const dvec2& p : map.places) lo = glm::min(lo, p), hi = glm::max(hi, p);
  MapFit fit;
  fit.middle = {origin.x + 0.5f * size.x, origin.y + 0.5f * size.y};
  fit.center = 0.5 * (lo + hi);
  const dvec2 extent = hi - lo + dvec2(2 * kDiscRadiusFraction * map.apart);  // with the discs at the rim
  const dvec2 room(static_cast<double>(size.x - kMargins * line), static_cast<double>(size.y - kMargins * line));
  fit.scale = std::min(extent.x > 0 ? room.x / extent.x : room.x, extent.y > 0 ? room.y / extent.y : room.y);
  const double radius = map.apart > 0 ? kDiscRadiusFraction * map.apart * fit.scale : 0.5 * std::min(room.x, room.y);
  fit.radius = std::clamp(static_cast<float>(radius), kMinRadius, kMaxRadius * line);
  return fit;
}

}  // namespace taxel::ui
