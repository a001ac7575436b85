#include "core/mesh/ring_surface.h"

#include <numeric>

namespace taxel {
namespace {
std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}
}  // namespace

void join_rows(std::span<const dvec3> points, std::span<const int> lower, std::span<const int> upper,
               std::vector<ivec3>& faces) {
  const auto gap = [&](std::size_t i, std::size_t j) {
    return glm::distance(points[at(lower[i])], points[at(upper[j])]);
  };
  std::size_t i = 0, j = 0;
  while (i + 1 < lower.size() || j + 1 < upper.size()) {
    const bool can_low = i + 1 < lower.size(), can_high = j + 1 < upper.size();
    if (can_low && (!can_high || gap(i + 1, j) < gap(i, j + 1))) {
      faces.emplace_back(lower[i], lower[i + 1], upper[j]);
      ++i;
    } else {
      faces.emplace_back(lower[i], upper[j + 1], upper[j]);
      ++j;
    }
  }
}

void RingSurface::add_ring(const std::vector<dvec3>& ring) {
  std::vector<int> row(ring.size());
  std::iota(row.begin(), row.end(), static_cast<int>(vertices_.size()));
  if (ring.size() > 1) row.push_back(row.front());
  vertices_.insert(vertices_.end(), ring.begin(), ring.end());
  if (!last_.empty()) join_rows(vertices_, last_, row, faces_);
  last_ = std::move(row);
}

void MirroredRingSurface::add_half_ring(const std::vector<dvec3>& half_ring) {
  std::vector<int> row;
  for (const dvec3& p : half_ring) {
    const int index = static_cast<int>(vertices_.size());
    row.push_back(index);
    vertices_.push_back(p);
    mirror_.push_back(p.x == 0 ? index : index + 1);
    if (p.x == 0) continue;
    vertices_.emplace_back(-p.x, p.y, p.z);
    mirror_.push_back(index);
  }
  if (!last_.empty()) {
    const std::size_t first_new = faces_.size();
    join_rows(vertices_, last_, row, faces_);
    const std::size_t end = faces_.size();
    for (std::size_t f = first_new; f < end; ++f) {
      const ivec3 face = faces_[f];
      faces_.emplace_back(mirrored(face.x), mirrored(face.z), mirrored(face.y));
    }
    bridge(last_.front(), row.front(), true);
    bridge(last_.back(), row.back(), false);
  }
  last_ = std::move(row);
}

// The triangle across the plane where one of the two rows stays off it.
void MirroredRingSurface::bridge(int low, int high, bool front) {
  const bool low_off = mirrored(low) != low, high_off = mirrored(high) != high;
  if (low_off) faces_.emplace_back(front ? mirrored(low) : low, front ? low : mirrored(low), high);
  if (high_off) faces_.emplace_back(low, front ? high : mirrored(high), front ? mirrored(high) : high);
}

}  // namespace taxel
