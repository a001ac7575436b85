// Other methods to find the first hits of a sensor's rays, with which the tet table is compared.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/sensor/rays/cast_rays.h"

namespace taxel::bench {

class RayCaster {
 public:
  virtual ~RayCaster() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  /// Does the work of a step after the contact surfaces: conversion, building structures, casting rays.
  virtual void cast(const std::vector<const ContactSurface*>& surfaces) = 0;
  /// Returns the hits of the last cast, one for each ray.
  [[nodiscard]] virtual std::vector<RayHit> hits() const = 0;
};

std::unique_ptr<RayCaster> make_own(const SensorModel& sensor, RayPath path);

/// Returns the paper's scheme: polygons are split into fans about their centroids, each step builds a BLAS per surface,
/// and rays are cast one after another through the TLAS.
std::unique_ptr<RayCaster> make_paper(const SensorModel& sensor);

/// Returns variants of Embree 3 with a reused dynamic scene; empty if Embree was missing at build time.
std::vector<std::unique_ptr<RayCaster>> make_embree(const SensorModel& sensor);

}  // namespace taxel::bench
