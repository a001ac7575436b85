// The aggregate weighted_sum: sum w p, the formula of the paper's released code. The reading grows with the density of
// the samples.
#include "core/sensor/readout/fold_inl.h"

namespace taxel {

constinit const AggregateSpec kWeightedSum{
    .fold = [](const SensorModel& model, const HitPressure& value_of, double* readings,
               double* scratch) { add_weighted(model.readout_table, value_of, readings, scratch); },
    .fold_friction = [](const SensorModel& model, const HitFriction& value_of, dvec3* friction,
                        double* scratch) { add_weighted(model.readout_table, value_of, friction, scratch); },
    .contribution = [](const SampleUse& use) { return use.weight * use.pressure; },
    .exact =
        [](const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
           const ExactOptions& how) {
          return FieldIntegral(FieldRays(model, taxel, surfaces, how.rays), how.accuracy,
                               {.weighted = true, .divided = false})
              .read();
        },
    .grows_with_samples = true};

}  // namespace taxel
