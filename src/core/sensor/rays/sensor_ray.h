// The rays of a sensor: fixed segments in its frame, their first hits, and their positions in a view along them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// The ray of one used sample: from the skin inward. Frame M. One cache line: rays are read out of order.
struct alignas(64) SensorRay {
  int sample = 0;        ///< index in SensorModel::samples
  dvec3 origin{0};       ///< sample; of a rigid sensor 1e-6 of the mesh size outside
  dvec3 direction{0};    ///< unit, opposite to the surface normal (or to the taxel's)
  double max_depth = 0;  ///< readout.max_depth, or half the way to the opposite skin [m]
};

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

/// The first hits of all rays of a sensor, and a list of the rays that hit, so that the cost of a step depends on the
/// contact only. The memory is reused from step to step.
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

// The positions of nearly parallel rays, seen along their mean direction. With them single precision decides for all
// rays but those near a rim whether they hit a contact polygon.

/// Upper bound of the rounding errors of coordinates in single precision and of the results computed from them here, as
/// a fraction of the coordinates.
inline constexpr double kSingleRounding = 4e-6;

/// The view along an axis. A ray at place p is at (p.u + h p.u_slope, p.v + h p.v_slope) in the depth h along `axis`.
/// It intersects the plane of a polygon at h = h_c - height / rise. Here h_c is the depth of the polygon's centroid,
/// height the height over the plane of the ray's point at h_c, and rise = n_h + n_u u_slope + n_v v_slope with the
/// components of the plane's normal. In single precision the error is at most (spread + kSingleRounding X) (1 + tilt /
/// |rise|), X being the coordinates of the polygon.
struct RayView {
  /// Components of the perpendicular unit axes: of `axis`, of the axes of u and v, and 0.
  std::array<float, 4> x{}, y{}, z{};
  float spread = 0;  ///< error of positions [m]; infinite if rays are not nearly parallel
  float tilt = 0;
};

/// The place of a ray in a view.
struct RayPlace {
  float u = 0, v = 0, u_slope = 0, v_slope = 0;
};

/// The rays of one vector, with their places in a view.
struct alignas(64) RayTile {
  static constexpr std::size_t kRays = 16;
  std::array<float, kRays> u{}, v{}, u_slope{}, v_slope{};  ///< RayPlace
  std::array<std::int32_t, kRays> ray{};                    ///< indices in SensorModel::rays, -1 for an empty place
};

/// Computes a view of rays, and the places of rays in the view.
class RayViewer {
 public:
  explicit RayViewer(std::span<const SensorRay* const> rays);
  [[nodiscard]] RayView view() const;
  [[nodiscard]] const dvec3& axis() const { return axis_; }  ///< mean direction
  [[nodiscard]] RayPlace place_of(const SensorRay& ray) const;
  /// Returns a tile of at most RayTile::kRays rays, given by their indices in `rays`.
  [[nodiscard]] RayTile tile_of(std::span<const SensorRay> rays, std::span<const std::int32_t> numbers) const;

 private:
  dvec3 axis_{0, 0, 1}, u_axis_{1, 0, 0}, v_axis_{0, 1, 0};
  double spread_ = 0, tilt_ = 0;
};

/// Returns the view with these axes, the first one along the rays.
RayView make_view(const dvec3& axis, const dvec3& u_axis, const dvec3& v_axis, double spread, double tilt);

}  // namespace taxel
