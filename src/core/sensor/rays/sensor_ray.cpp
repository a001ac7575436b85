// First hits of rays, and the view along rays that are nearly parallel.
//
// Hits are marked by one bit per ray, which gives the list of the rays that were hit in ascending order without
// sorting; clearing a step writes only the rays of that list. So the cost of a step depends on its contact, not on the
// number of rays.
//
// A view is taken along the mean direction of its rays, in which a ray is a place and a slope. The steepest ray bounds
// the error of single precision; a view with rays steeper than 45 degrees has an infinite error, and all of its rays
// are tested exactly. Opposite rays count as parallel.
#include "core/sensor/rays/sensor_ray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace taxel {

void RayHits::clear(std::size_t ray_count) {
  if (hits_.size() != ray_count) {
    hits_.assign(ray_count, RayHit{});
    marks_.assign((ray_count + kBits - 1) / kBits, 0);
    rays_.clear();
    rays_.reserve(ray_count);  // no step allocates, however many rays it hits
    return;
  }
  for (const std::int32_t ray : rays_) {
    hits_[static_cast<std::size_t>(ray)] = RayHit{};
    marks_[static_cast<std::size_t>(ray) / kBits] = 0;
  }
  rays_.clear();
}

void RayHits::finish() {
  rays_.clear();
  for (std::size_t word = 0; word < marks_.size(); ++word)
    for (std::uint64_t bits = marks_[word]; bits != 0; bits &= bits - 1)
      rays_.push_back(static_cast<std::int32_t>(word * kBits + static_cast<std::size_t>(std::countr_zero(bits))));
}

RayView make_view(const dvec3& axis, const dvec3& u_axis, const dvec3& v_axis, double spread, double tilt) {
  const auto components = [&](int i) {
    return std::array<float, 4>{static_cast<float>(axis[i]), static_cast<float>(u_axis[i]),
                                static_cast<float>(v_axis[i]), 0.0F};
  };
  return {components(0), components(1), components(2), static_cast<float>(spread), static_cast<float>(tilt)};
}

RayViewer::RayViewer(std::span<const SensorRay* const> rays) {
  dvec3 sum(0);
  for (const SensorRay* ray : rays)  // opposite rays run side by side, too
    sum += glm::dot(sum, ray->direction) < 0 ? -ray->direction : ray->direction;
  const double length = glm::length(sum);
  if (length > 0) axis_ = sum / length;
  u_axis_ = any_perpendicular(axis_);
  v_axis_ = glm::cross(axis_, u_axis_);
  double coordinates = 0, steepest = 0;
  for (const SensorRay* ray : rays) {
    const double along = std::abs(glm::dot(ray->direction, axis_)),
                 across = glm::length(glm::cross(ray->direction, axis_));
    steepest = std::max(steepest, along > 0 ? across / along : std::numeric_limits<double>::infinity());
    coordinates = std::max(coordinates, glm::length(ray->origin));
  }
  // The rounding of the height, and of the rise times the depth, is less than that of three coordinates.
  tilt_ = 3.0 * steepest;
  spread_ = steepest <= 1.0 ? kSingleRounding * coordinates : std::numeric_limits<double>::infinity();
}

RayView RayViewer::view() const {
  return make_view(axis_, u_axis_, v_axis_, spread_, tilt_);
}

RayPlace RayViewer::place_of(const SensorRay& ray) const {
  if (!std::isfinite(spread_)) return {};
  const double along = glm::dot(axis_, ray.direction), h = glm::dot(axis_, ray.origin);
  const double u_slope = glm::dot(u_axis_, ray.direction) / along, v_slope = glm::dot(v_axis_, ray.direction) / along;
  return {static_cast<float>(glm::dot(u_axis_, ray.origin) - h * u_slope),
          static_cast<float>(glm::dot(v_axis_, ray.origin) - h * v_slope), static_cast<float>(u_slope),
          static_cast<float>(v_slope)};
}

RayTile RayViewer::tile_of(std::span<const SensorRay> rays, std::span<const std::int32_t> numbers) const {
  RayTile tile;
  tile.ray.fill(-1);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const RayPlace place = place_of(rays[static_cast<std::size_t>(numbers[k])]);
    tile.u[k] = place.u;
    tile.v[k] = place.v;
    tile.u_slope[k] = place.u_slope;
    tile.v_slope[k] = place.v_slope;
    tile.ray[k] = numbers[k];
  }
  return tile;
}

}  // namespace taxel
