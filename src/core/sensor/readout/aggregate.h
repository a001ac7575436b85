// Aggregates: functions that compute a taxel's reading from the hits of its rays. Each aggregate has one file in this
// folder and one row in the table.
#pragma once

#include <cstdint>
#include <iterator>
#include <span>

#include "core/hydro/contact_surface.h"
#include "core/layout/words.h"
#include "core/sensor/rays/sensor_ray.h"
#include "core/sensor/reference/exact_value.h"
#include "core/sensor/reference/skin_fields.h"
#include "core/sensor/surface_motion.h"

namespace taxel {

struct SensorModel;

/// The pressure at the hit of a ray [Pa].
struct HitPressure {
  const RayHits& hits;
  double operator()(std::int32_t ray) const { return hits[ray].pressure; }
};

/// The friction traction at the hit of a ray, frame M [Pa]: SurfaceMotion::friction().
struct HitFriction {
  const RayHits& hits;
  std::span<const SensorRay> rays;                  ///< rays of the model
  std::span<const ContactSurface* const> surfaces;  ///< contact surfaces as the hits number them
  std::span<const SurfaceMotion> motions;           ///< motion of each surface
  dvec3 operator()(std::int32_t ray) const {
    const RayHit& hit = hits[ray];
    const SensorRay& from = rays[static_cast<std::size_t>(ray)];
    const dvec3 x = from.origin + hit.depth * from.direction;
    const SurfaceMotion& motion = motions[static_cast<std::size_t>(hit.surface)];
    const ContactSurface& surface = *surfaces[static_cast<std::size_t>(hit.surface)];
    return motion.friction(hit.pressure, surface.polygons[static_cast<std::size_t>(hit.polygon)].normal, x);
  }
};

/// One sample of a taxel and the pressure that its ray reads.
struct SampleUse {
  double weight = 0;    ///< weight in the taxel's receptive field [m^2]
  double share = 0;     ///< SensorModel::sample_share()
  double distance = 0;  ///< distance from the taxel's centre [m]
  double pressure = 0;  ///< pressure at the hit, 0 for a miss [Pa]
};

/// The formulas of one aggregate. Files and menus name it by its AggregateRow.
struct AggregateSpec {
  /// Computes one pressure per taxel from the rays that were hit. `readings` and `scratch` are zeros, one per taxel.
  /// Null if the reading is an integral over the contact polygons (force_integral.h), which takes no rays.
  void (*fold)(const SensorModel&, const HitPressure&, double* readings, double* scratch) = nullptr;
  /// Computes one friction vector per taxel with the weights of `fold`. Null with `fold`.
  void (*fold_friction)(const SensorModel&, const HitFriction&, dvec3* friction, double* scratch) = nullptr;
  /// Returns the part of one sample in the reading, before any division. Null if one sample alone is the reading.
  double (*contribution)(const SampleUse&) = nullptr;
  /// Returns the rank of a sample where one sample alone is the reading: the first of the highest rank.
  double (*rank)(const SampleUse&) = nullptr;
  /// Computes the limit of the reading for ever more samples, see exact_reading().
  ExactReading (*exact)(const SensorModel&, int taxel, std::span<const ContactSurface* const> surfaces,
                        const ExactOptions& how) = nullptr;
  IntegralKind integral = IntegralKind::none;  ///< integral of ReadingMethod::exact
  bool grows_with_samples = false;             ///< true if the reading is proportional to the number of samples
};

extern const AggregateSpec kWeightedMean, kWeightedSum, kMean, kNearest, kMax, kFieldForce;

/// In the order of kAggregates.
inline constexpr const AggregateSpec* kAggregateSpecs[] = {&kWeightedMean, &kWeightedSum, &kMean,
                                                           &kNearest,      &kMax,         &kFieldForce};
static_assert(std::size(kAggregateSpecs) == std::size(kAggregates), "an aggregate has one row in each table");

/// Returns the formulas of an aggregate.
inline const AggregateSpec& aggregate_spec(Aggregate aggregate) {
  return *kAggregateSpecs[static_cast<std::size_t>(aggregate)];
}

/// Returns the integral that is the reading, or IntegralKind::none if the reading is made of samples.
inline IntegralKind integral_of(const Readout& readout) {
  const AggregateSpec& spec = aggregate_spec(readout.aggregate);
  return spec.fold == nullptr || readout.method == ReadingMethod::exact ? spec.integral : IntegralKind::none;
}

}  // namespace taxel
