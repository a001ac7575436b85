#include "core/sensor/ray_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taxel {

RayViewer::RayViewer(std::span<const RayPiece> pieces) {
  dvec3 sum(0);
  for (const RayPiece& piece : pieces) sum += piece.ray->direction;
  const double length = glm::length(sum);
  if (length > 0) axis_ = sum / length;  // of opposite rays any is as good
  u_axis_ = any_perpendicular(axis_);
  v_axis_ = glm::cross(axis_, u_axis_);
  double coordinates = 0, widest = 0, steepest = 0;
  for (const RayPiece& piece : pieces) {
    const double along = glm::dot(piece.ray->direction, axis_),
                 across = glm::length(glm::cross(piece.ray->direction, axis_)),
                 half = 0.5 * (piece.t_max - piece.t_min);
    widest = std::max(widest, half * across);
    steepest = along > 0 ? std::max(steepest, across / along) : std::numeric_limits<double>::infinity();
    coordinates = std::max(coordinates, glm::length(piece.middle()) + half);
  }
  sloped_ = steepest <= 1.0;
  if (sloped_)
    stretch_ = 1.0 + steepest;  // no point of the disc is farther than r from c's depth
  else
    spread_ = widest;
  spread_ += kSingleRounding * (coordinates + widest);
}

RayView RayViewer::view() const {
  const auto components = [&](int i) {
    return std::array<float, 4>{static_cast<float>(axis_[i]), static_cast<float>(u_axis_[i]),
                                static_cast<float>(v_axis_[i]), 0.0F};
  };
  return {components(0), components(1), components(2), static_cast<float>(stretch_), static_cast<float>(spread_)};
}

RayPlace RayViewer::place_of(const RayPiece& piece) const {
  const dvec3 middle = piece.middle();
  const double along = glm::dot(axis_, piece.ray->direction), h = glm::dot(axis_, middle);
  double u = glm::dot(u_axis_, middle), v = glm::dot(v_axis_, middle), u_slope = 0, v_slope = 0;
  if (sloped_) {
    u_slope = glm::dot(u_axis_, piece.ray->direction) / along;
    v_slope = glm::dot(v_axis_, piece.ray->direction) / along;
    u -= h * u_slope;
    v -= h * v_slope;
  }
  return {static_cast<float>(u),       static_cast<float>(v),
          static_cast<float>(u_slope), static_cast<float>(v_slope),
          static_cast<float>(h),       static_cast<float>(0.5 * (piece.t_max - piece.t_min) * std::abs(along))};
}

}  // namespace taxel
