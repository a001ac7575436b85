#include "core/mesh/geodesic/geodesic_map.h"

#include <algorithm>

namespace taxel {

GeodesicMap::GeodesicMap(std::shared_ptr<const UnfoldedMesh> mesh, const GeodesicDistance& from, const dvec3& source)
    : mesh_(std::move(mesh)),
      radius_(from.radius()),
      source_face_(from.source_face()),
      source_(mesh_->flat(3 * from.source_face(), source)) {
  std::vector<int> reached = from.reached_faces();
  std::sort(reached.begin(), reached.end());
  windows_.reserve(static_cast<std::size_t>(from.window_count()));
  for (const int face : reached) {
    Face& kept = faces_.emplace_back();
    kept.face = face;
    for (std::size_t c = 0; c < 3; ++c) {
      const int h = 3 * face + static_cast<int>(c);
      kept.at_apex[c] = from.at_apex(h);
      kept.windows[c] = static_cast<std::uint32_t>(windows_.size());
      from.for_each_window(h, [&](const GeodesicWindow& w) { windows_.push_back(w); });
    }
    kept.windows[3] = static_cast<std::uint32_t>(windows_.size());
  }
}

double GeodesicMap::to(int face, const dvec3& target) const {
  constexpr double kUnreached = std::numeric_limits<double>::infinity();
  const auto found =
      std::lower_bound(faces_.begin(), faces_.end(), face, [](const Face& f, int number) { return f.face < number; });
  if (found == faces_.end() || found->face != face) return kUnreached;
  const double straight = face == source_face_ ? glm::distance(source_, mesh_->flat(3 * face, target)) : kUnreached;
  const auto corner = [&](int h) { return static_cast<std::size_t>(h - 3 * face); };
  const double best = shortest_in_face(
      *mesh_, face, target, straight, [&](int h) { return found->at_apex[corner(h)]; },
      [&](int h, const auto& f) {
        for (std::uint32_t i = found->windows[corner(h)]; i < found->windows[corner(h) + 1]; ++i) f(windows_[i]);
      });
  return best <= radius_ ? best : kUnreached;
}

}  // namespace taxel
