// The readings of a sensor: one value per taxel from the hits of its rays or as an integral, the shear and the slip of
// each taxel, and the exact reading of one taxel.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/bristles.h"
#include "core/sensor/rays/cast_rays.h"
#include "core/sensor/reference/exact_value.h"
#include "core/sensor/reference/force_integral.h"
#include "core/sensor/reference/pressure_integral.h"
#include "core/sensor/sensor_model.h"
#include "core/sensor/surface_motion.h"

namespace taxel {

/// A taxel responds if its peak, or its range, is above this fraction of the largest peak or range.
inline constexpr double kTaxelResponds = 0.05;

/// Computes one value per taxel in layout order, in reading_unit() of the aggregate (readout/aggregate.h). A taxel
/// without samples reads 0. The sums run over the rays that were hit, in ascending order, so that the same hits give
/// the same bits. Throws Error for Aggregate::force, which takes no rays.
void aggregate(const SensorModel& model, const RayHits& hits, Aggregate how, std::vector<double>& readings);

/// One vector per taxel. The memory is reused from step to step.
struct TaxelFriction {
  std::vector<dvec3> values;
  std::vector<double> scratch;
};

/// Computes the friction on each taxel, frame M, in the unit of the reading: SurfaceMotion::friction() at the hits,
/// with the weights of the reading. Aggregate::max takes the friction at the largest pressure. `motions` is parallel to
/// the surfaces. Throws Error for Aggregate::force.
void aggregate_friction(const SensorModel& model, const RayHits& hits, std::span<const ContactSurface* const> surfaces,
                        std::span<const SurfaceMotion> motions, Aggregate how, TaxelFriction& friction);

/// Results and scratch memory of one evaluation, reused from step to step.
struct SensorReading {
  CastWorkspace workspace;
  RayHits hits;                ///< hits of model.rays
  std::vector<double> values;  ///< readings by layout.readout.aggregate, one per taxel
  ForceIntegral integral;
  ForceReading force;  ///< forces on the taxels, for Aggregate::force only
  PressureIntegral mean_integral;
  PressureSums sums;  ///< integrals of the means with ReadingMethod::exact
  TaxelFriction friction;
  std::vector<dvec2> shear;  ///< friction along the tangents, for readout.shear only: see read_shear()
};

/// Reads a sensor: cast_rays(), then aggregate(), or the integral of integral_of() that is the reading, then
/// read_shear() for readout.shear. Surfaces are in frame M; null ones are empty. Without motions the shear is zero.
void read_sensor(const SensorModel& model, std::span<const ContactSurface* const> surfaces, SensorReading& out,
                 RayPath path = RayPath::fastest, std::span<const SurfaceMotion> motions = {});

/// Computes the friction on each taxel along e1 and e2 of its tangent frame (sensor_frame.h), in the unit of the
/// reading. `reading` is the result of read_sensor() for the same surfaces and motions.
void read_shear(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
                std::span<const SurfaceMotion> motions, SensorReading& reading);

/// Computes the exact reading of one taxel. Surfaces are in frame M; null ones are empty. The quadrature is adaptive: a
/// rule of degree 5 is compared with one of degree 2 until the error is how.accuracy of the reading or kExactRays are
/// cast. The result depends on the arguments alone. Throws Error for an unknown taxel.
ExactReading exact_reading(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                           const ExactOptions& how = {});

/// Computes, per taxel, the share of its touched field that slips, from 0 (all sticks, or no contact) to 1: the sum of
/// w A over the slipping roots divided by that over all roots, with the weight w of the receptive field at the root and
/// the area A of contact that the root bears. The frictions are in frame M; null ones have no contact.
void read_slip(const SensorModel& model, const FieldWeights& weights,
               std::span<const StickingFriction* const> frictions, std::vector<double>& slip);

}  // namespace taxel
