// What the sensor's rays met: one hit per ray, and which rays were hit at all, so that a step costs what the contact
// costs.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

namespace taxel {

struct RayHit {
  int surface = -1;  ///< -1: miss
  int polygon = -1;
  double depth = 0;     ///< along the ray [m]
  double pressure = 0;  ///< p0 there [Pa]; 0 for a miss
  [[nodiscard]] bool hit() const { return surface >= 0; }
  /// Nearest first; ties go to the lower surface, then the lower polygon. Any hit before a miss.
  [[nodiscard]] bool before(const RayHit& other) const {
    return !other.hit() || std::tie(depth, surface, polygon) < std::tie(other.depth, other.surface, other.polygon);
  }
};

/// The first hits of all rays of a sensor. Memory is kept from step to step.
class RayHits {
 public:
  /// Makes all of `ray_count` rays misses; touches only those that were hit, where the number stays.
  void clear(std::size_t ray_count);
  /// Keeps the hit if it is before what the ray met so far.
  void offer(std::int32_t ray, const RayHit& hit) {
    RayHit& best = hits_[static_cast<std::size_t>(ray)];
    if (!hit.before(best)) return;
    best = hit;
    marks_[static_cast<std::size_t>(ray) / kBits] |= std::uint64_t{1} << (static_cast<std::size_t>(ray) % kBits);
  }
  /// Lists the rays that were hit. Call after the last offer().
  void finish();

  [[nodiscard]] const std::vector<RayHit>& all() const { return hits_; }             ///< by ray
  [[nodiscard]] const std::vector<std::int32_t>& hit_rays() const { return rays_; }  ///< ascending
  /// What the ray met so far.
  [[nodiscard]] const RayHit& operator[](std::int32_t ray) const { return hits_[static_cast<std::size_t>(ray)]; }

 private:
  static constexpr std::size_t kBits = 64;
  std::vector<RayHit> hits_;
  std::vector<std::uint64_t> marks_;  // one bit per ray: turned into an ascending list without sorting
  std::vector<std::int32_t> rays_;
};

}  // namespace taxel
