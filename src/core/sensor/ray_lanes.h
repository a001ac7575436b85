// Rays side by side, to be read as many at a time as the machine has lanes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/sensor/sensor_ray.h"

namespace taxel {

struct RayLanes {
  const double *ox, *oy, *oz;   ///< origins [m]
  const double *dx, *dy, *dz;   ///< directions
  const double *t_min, *t_max;  ///< where a hit counts [m]
  const std::int32_t* ray;      ///< in SensorModel::rays
};

/// Holds them. Behind the last one stand kPadding that meet nothing.
class RayList {
 public:
  static constexpr std::size_t kPadding = 8;

  RayList() : RayList(0) {}
  /// All meet nothing until they are set.
  explicit RayList(std::size_t count) : ray_(count + kPadding, 0) {
    for (std::vector<double>& values : values_) values.assign(ray_.size(), 0.0);
    values_[kMaxT].assign(ray_.size(), -1.0);  // before the least one
  }

  void set(std::size_t i, const SensorRay& ray, std::int32_t number, double t_min, double t_max) {
    for (int axis = 0; axis < 3; ++axis) {
      values_[static_cast<std::size_t>(axis)][i] = ray.origin[axis];
      values_[static_cast<std::size_t>(3 + axis)][i] = ray.direction[axis];
    }
    values_[kMinT][i] = t_min;
    values_[kMaxT][i] = t_max;
    ray_[i] = number;
  }

  [[nodiscard]] RayLanes lanes() const {
    const auto& v = values_;
    return {v[0].data(), v[1].data(),     v[2].data(),     v[3].data(), v[4].data(),
            v[5].data(), v[kMinT].data(), v[kMaxT].data(), ray_.data()};
  }
  [[nodiscard]] std::size_t size() const { return ray_.size() - kPadding; }
  [[nodiscard]] std::size_t bytes() const {
    return ray_.size() * (sizeof(std::int32_t) + values_.size() * sizeof(double));
  }

 private:
  static constexpr std::size_t kMinT = 6, kMaxT = 7;
  std::array<std::vector<double>, 8> values_;
  std::vector<std::int32_t> ray_;
};

}  // namespace taxel
