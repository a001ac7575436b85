#include "ui/scene/geometry/depth_order.h"

#include <algorithm>
#include <array>
#include <limits>

namespace taxel::ui {

void order_back_to_front(std::span<const glm::vec3> centroids, std::span<const std::uint32_t> indices,
                         const glm::vec3& direction, std::vector<std::uint32_t>& out) {
  constexpr std::size_t kDepths = 4096;
  std::vector<float> depth(centroids.size());
  float lo = std::numeric_limits<float>::infinity(), hi = -lo;
  for (std::size_t f = 0; f < centroids.size(); ++f) {
    depth[f] = glm::dot(centroids[f], direction);
    lo = std::min(lo, depth[f]);
    hi = std::max(hi, depth[f]);
  }
  const float scale = hi > lo ? static_cast<float>(kDepths - 1) / (hi - lo) : 0.0f;
  const auto bucket = [&](std::size_t f) { return static_cast<std::size_t>((hi - depth[f]) * scale); };
  std::array<std::size_t, kDepths + 1> first{};
  for (std::size_t f = 0; f < depth.size(); ++f) ++first[bucket(f) + 1];
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  out.resize(indices.size());
  for (std::size_t f = 0; f < depth.size(); ++f) {
    const auto slot = first[bucket(f)]++;
    std::copy_n(indices.begin() + static_cast<std::ptrdiff_t>(3 * f), 3,
                out.begin() + static_cast<std::ptrdiff_t>(3 * slot));
  }
}

}  // namespace taxel::ui
