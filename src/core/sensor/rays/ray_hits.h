// The first hits of a sensor's rays, and a list of the rays that hit, so that the cost of a step depends on the contact
// only.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

namespace taxel {

/// The hit of one ray, or a miss.
struct RayHit {
  int surface = -1;  ///< index of the contact surface, -1 for a miss
  int polygon = -1;
  double depth = 0;     ///< depth along the ray [m]
  double pressure = 0;  ///< pressure p0 at the hit [Pa]; 0 for a miss
  [[nodiscard]] bool hit() const { return surface >= 0; }
  /// Orders hits by depth, then surface, then polygon. A miss comes last.
  [[nodiscard]] bool before(const RayHit& other) const {
    return !other.hit() || std::tie(depth, surface, polygon) < std::tie(other.depth, other.surface, other.polygon);
  }
};

/// The first hits of all rays of a sensor. The memory is reused from step to step.
class RayHits {
 public:
  /// Makes all of `ray_count` rays misses. If the number of rays is unchanged, writes only rays that were hit.
  void clear(std::size_t ray_count);
  /// Stores the hit if it is before the ray's hit so far.
  void offer(std::int32_t ray, const RayHit& hit) {
    RayHit& best = hits_[static_cast<std::size_t>(ray)];
    if (!hit.before(best)) return;
    best = hit;
    marks_[static_cast<std::size_t>(ray) / kBits] |= std::uint64_t{1} << (static_cast<std::size_t>(ray) % kBits);
  }
  /// Builds the list of rays that were hit. Call after the last offer().
  void finish();

  [[nodiscard]] const std::vector<RayHit>& all() const { return hits_; }             ///< one per ray
  [[nodiscard]] const std::vector<std::int32_t>& hit_rays() const { return rays_; }  ///< ascending
  /// Returns the ray's hit so far.
  [[nodiscard]] const RayHit& operator[](std::int32_t ray) const { return hits_[static_cast<std::size_t>(ray)]; }

 private:
  static constexpr std::size_t kBits = 64;
  std::vector<RayHit> hits_;
  std::vector<std::uint64_t> marks_;  // one bit per ray, which becomes an ascending list without sorting
  std::vector<std::int32_t> rays_;
};

}  // namespace taxel
