// Triangles between two rows of points with different numbers of points.
//
// Each triangle is a step along one of the rows. The first walk takes the step with the shorter diagonal. Two
// neighbouring steps along different rows are the two triangles of a quadrilateral; where their diagonal is a valley,
// the steps are exchanged, which makes it a ridge and adds volume. So the loop ends, and round bodies have no dents.
// Differences below rounding count as flat, or the loop might not end. A surface of half rings is mirrored face by
// face, which makes it symmetric to the last bit.
#include "core/mesh/ring_surface.h"

#include <numeric>

#include "core/base/math.h"

namespace taxel {
namespace {

/// Steps along both rows, always along the shorter diagonal: true is a step of the lower row.
std::vector<bool> shortest_walk(std::span<const dvec3> points, std::span<const int> lower, std::span<const int> upper) {
  const auto gap = [&](std::size_t i, std::size_t j) {
    return glm::distance(points[at(lower[i])], points[at(upper[j])]);
  };
  std::vector<bool> walk;
  std::size_t i = 0, j = 0;
  while (i + 1 < lower.size() || j + 1 < upper.size()) {
    const bool can_low = i + 1 < lower.size(), can_high = j + 1 < upper.size();
    walk.push_back(can_low && (!can_high || gap(i + 1, j) < gap(i, j + 1)));
    (walk.back() ? i : j) += 1;
  }
  return walk;
}

/// Exchanges two neighbouring steps wherever the diagonal between them is a valley, until no valley is left. Each
/// exchange adds volume, so the loop ends. Returns whether anything changed.
bool raise_valleys(std::span<const dvec3> points, std::span<const int> lower, std::span<const int> upper,
                   std::vector<bool>& walk) {
  bool changed = false;
  std::size_t i = 0, j = 0;  // points at the begin of step k
  for (std::size_t k = 0; k + 1 < walk.size(); ++k) {
    if (walk[k] != walk[k + 1]) {
      const dvec3 &a = points[at(lower[i])], &b = points[at(lower[i + 1])];
      const dvec3 &c = points[at(upper[j + 1])], &d = points[at(upper[j])];
      const double volume = glm::dot(glm::cross(b - a, c - a), d - a);  // > 0: a c is a valley, b d a ridge
      const double size = std::max({glm::length(b - a), glm::length(c - a), glm::length(d - a)});
      const double flat = 64 * std::numeric_limits<double>::epsilon() * size * size * size;
      if (walk[k] ? volume < -flat : volume > flat) {
        walk[k] = !walk[k];
        walk[k + 1] = !walk[k + 1];
        changed = true;
      }
    }
    (walk[k] ? i : j) += 1;
  }
  return changed;
}

}  // namespace

void join_rows(std::span<const dvec3> points, std::span<const int> lower, std::span<const int> upper,
               std::vector<ivec3>& faces) {
  std::vector<bool> walk = shortest_walk(points, lower, upper);
  while (raise_valleys(points, lower, upper, walk)) {
  }
  std::size_t i = 0, j = 0;
  for (const bool low_step : walk) {
    if (low_step) {
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
      faces_.emplace_back(mirror_[at(face.x)], mirror_[at(face.z)], mirror_[at(face.y)]);
    }
  }
  last_ = std::move(row);
}

}  // namespace taxel
