// The aggregate force: an integral over the contact polygons (force_integral.h), which takes no rays.
#include "core/base/math.h"
#include "core/sensor/readout/aggregate.h"
#include "core/sensor/reference/force_integral.h"
#include "core/sensor/sensor_model.h"

namespace taxel {
namespace {

ExactReading exact_force(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                         const ExactOptions&) {
  ForceIntegral integral;
  ForceReading force;
  integral.integrate(model, *model.skin_fields, surfaces, {}, force);
  ExactReading out;
  out.value = force.values[at(taxel)];
  out.error = ForceIntegral::kAccuracy * force.covered;
  return out;
}

}  // namespace

constinit const AggregateSpec kFieldForce{
    .contribution = [](const SampleUse& use) { return use.weight * use.pressure; },
    .exact = exact_force,
    .integral = IntegralKind::force};

}  // namespace taxel
