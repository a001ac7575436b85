#include "core/sensor/explain/exact_reading.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/hydro/quadrature.h"
#include "core/sensor/explain/field_integral.h"
#include "core/sensor/readout/force_integral.h"

namespace taxel {
namespace {

/// The reading of the polygons' forces, which takes no samples.
ExactReading force_reading(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces) {
  ForceIntegral integral;
  ForceReading force;
  const FieldWeights* weights = model.weights.get();
  std::optional<FieldWeights> own;
  if (weights == nullptr) weights = &own.emplace(model.layout, *model.skin);
  integral.integrate(model, *weights, surfaces, {}, force);
  ExactReading out;
  out.value = force.values[at(taxel)];
  out.error = ForceIntegral::kAccuracy * force.covered;
  return out;
}

ExactReading nearest_reading(const FieldRays& rays, const Taxel& taxel) {
  ExactReading out;
  if (!taxel.subtaxels.empty()) {
    out.missing = "the nearest sample of a taxel with subtaxels has no limit";
    return out;
  }
  const std::optional<FieldRays::Start> start = rays.nearest_start(taxel.center);
  if (!start) {
    out.missing = "the skin nearest to the centre is outside of the field";
    return out;
  }
  const RayHit hit = rays.cast(start->face, start->point);
  if (!hit.hit() && rays.omit_misses()) {
    out.missing = "the ray of the centre misses, and misses are left out";
    return out;
  }
  out.value = hit.pressure;
  out.rays = 1;
  return out;
}

}  // namespace

ExactReading exact_reading(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                           double accuracy) {
  if (taxel < 0 || taxel >= model.taxel_count())
    throw Error(fmt::format("there is no taxel {}, the layout has {}", taxel, model.taxel_count()));
  if (model.layout.readout.aggregate == Aggregate::force) return force_reading(model, taxel, surfaces);
  FieldRays rays(model, taxel, surfaces);
  if (model.layout.readout.aggregate == Aggregate::nearest)
    return nearest_reading(rays, model.layout.taxels[at(taxel)]);
  return FieldIntegral(std::move(rays), accuracy).read();
}

}  // namespace taxel
