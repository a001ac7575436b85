// Simulated readings of displaced poses as a function of the geometry that a fit varies.
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "core/run/fit/fit_values.h"
#include "core/sensor/contact_case/pose_readings.h"
#include "core/sensor/sensor_cache.h"

namespace taxel {

/// Values of radius, object_radius, thickness and k, in the order of FitName.
using FitGeometry = std::array<double, 4>;

/// The sensor and the object of a fit, prepared again only when their geometry changes.
class FitModel {
 public:
  /// Throws Error if the layout or the shape cannot be compiled.
  FitModel(const FitSubject& subject, int threads, Progress* progress);

  /// Returns the values of layout and case. A radius is that of the first taxel; a value that is missing is 0.
  [[nodiscard]] const FitGeometry& geometry() const { return given_; }
  /// Returns the place of a taxel in the layout. Throws Error if there is none, naming `file`.
  [[nodiscard]] std::size_t place_of(int taxel, const std::string& file) const;
  /// Returns the centre of a taxel, world frame [m].
  [[nodiscard]] dvec3 center_of(std::size_t taxel) const;
  /// Returns the object's position without displacement, world frame [m].
  [[nodiscard]] dvec3 object_position() const { return case_.b.X_WB.p; }
  /// Returns the readings at each displacement [m], rows in the order of the layout's taxels. Throws Cancelled.
  [[nodiscard]] PoseReadings read(const FitGeometry& geometry, std::span<const dvec3> displacements);

 private:
  struct Parts {
    SensorModelPtr model;
    HydroBodyPtr object;
  };
  const Parts& parts_of(const FitGeometry& geometry);

  SensorSource source_;
  ContactCase case_;
  int threads_;
  Progress* progress_;
  SensorCache cache_;
  FitGeometry given_{};
  std::map<FitGeometry, Parts> parts_;
  std::vector<dvec3> centers_W_;
};

}  // namespace taxel
