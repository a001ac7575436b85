// From hits to numbers: one value per taxel.
#pragma once

#include <vector>

#include "core/sensor/rays/cast_rays.h"
#include "core/sensor/readout/force_integral.h"
#include "core/sensor/surface_motion.h"

namespace taxel {

/// A taxel responds where its peak, or its range, is above this part of the largest one.
inline constexpr double kTaxelResponds = 0.05;

/// One value per taxel in layout order, pascals; Aggregate::force is no sum over rays (force_integral.h). A taxel
/// without samples reads 0. weighted_mean: sum w p / sum w (the paper); weighted_sum: sum w p (its released code);
/// mean; nearest; max. Sums run over the rays that were hit, in ascending order: the same bits whatever was read
/// before.
void aggregate(const SensorModel& model, const RayHits& hits, Aggregate how, std::vector<double>& readings);

/// One vector per taxel; keeps its memory.
struct TaxelFriction {
  std::vector<dvec3> values;
  std::vector<double> scratch;
};

/// The same of the friction that the taxel feels, frame M, in the unit of the reading: friction_traction() where the
/// rays hit, with the weights of the reading; of max the friction where the pressure is largest. `motions` is parallel
/// to the surfaces.
void aggregate_friction(const SensorModel& model, const RayHits& hits, std::span<const ContactSurface* const> surfaces,
                        std::span<const SurfaceMotion> motions, Aggregate how, TaxelFriction& friction);

/// Everything one evaluation needs and produces, reused from step to step.
struct SensorReading {
  CastWorkspace workspace;
  RayHits hits;                ///< of model.rays
  std::vector<double> values;  ///< layout.readout.aggregate
  ForceIntegral integral;
  ForceReading force;  ///< for Aggregate::force
  TaxelFriction friction;
  std::vector<dvec2> shear;  ///< for readout.shear: see read_shear()
};
/// As cast_rays(), then aggregate(), or integrate() for Aggregate::force; then read_shear() for readout.shear. Without
/// motions nothing slides.
void read_sensor(const SensorModel& model, std::span<const ContactSurface* const> surfaces, SensorReading& out,
                 RayPath path = RayPath::fastest, std::span<const SurfaceMotion> motions = {});

/// The friction on each taxel along e1 and e2 of its tangent frame (tangent_frame.h), from what read_sensor() saw of
/// the same surfaces and motions: the layout's aggregate, in the unit of the reading.
void read_shear(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
                std::span<const SurfaceMotion> motions, SensorReading& reading);

}  // namespace taxel
