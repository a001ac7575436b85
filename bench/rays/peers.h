// Other ways to find the first hits of a sensor's rays: what the tet table is compared with.
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
  /// Everything that a step costs from the contact surfaces on: conversion, structures, rays.
  virtual void cast(const std::vector<const ContactSurface*>& surfaces) = 0;
  /// By ray, of the last cast.
  [[nodiscard]] virtual std::vector<RayHit> hits() const = 0;
};

std::unique_ptr<RayCaster> make_own(const SensorModel& sensor, RayPath path);

/// The paper's scheme: polygons fanned about their centroids, a BLAS per surface built in each step, one ray after
/// another through the TLAS.
std::unique_ptr<RayCaster> make_paper(const SensorModel& sensor);

/// Variants of Embree 3 with its scene reused and dynamic; empty where it was not there at build time.
std::vector<std::unique_ptr<RayCaster>> make_embree(const SensorModel& sensor);

}  // namespace taxel::bench
