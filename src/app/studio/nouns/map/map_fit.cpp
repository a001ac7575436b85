#include "app/studio/nouns/map/map_fit.h"

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

std::vector<MapCell> map_cells(std::span<const FlatMap* const> maps, const ImVec2& origin, const ImVec2& size,
                               float line, float name) {
  std::vector<MapCell> best;
  double best_scale = -std::numeric_limits<double>::infinity();
  for (std::size_t columns = 1; columns <= maps.size(); ++columns) {
    const std::size_t rows = (maps.size() + columns - 1) / columns;
    const ImVec2 step(size.x / static_cast<float>(columns), size.y / static_cast<float>(rows));
    std::vector<MapCell> cells;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < maps.size(); ++i) {
      const ImVec2 at(origin.x + static_cast<float>(i % columns) * step.x,
                      origin.y + static_cast<float>(i / columns) * step.y);
      cells.push_back({at, {step.x, step.y - name}});
      smallest = std::min(smallest, fit_map(*maps[i], at, cells.back().size, line).scale);
    }
    if (smallest > best_scale) best_scale = smallest, best = std::move(cells);
  }
  return best;
}

}  // namespace taxel::ui
