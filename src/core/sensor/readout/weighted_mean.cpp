// The aggregate weighted_mean: sum w p / sum w, the paper's formula.
#include "core/sensor/readout/fold_inl.h"

namespace taxel {
namespace {

template <class V, class ValueOf>
void fold_weighted_mean(const SensorModel& model, const ValueOf& value_of, V* readings, double* scratch) {
  add_weighted(model.readout_table, value_of, readings, scratch);
  divide(model, readings, scratch, model.readout_table.weight_sum);
}

}  // namespace

constinit const AggregateSpec kWeightedMean{
    .fold = fold_weighted_mean<double, HitPressure>,
    .fold_friction = fold_weighted_mean<dvec3, HitFriction>,
    .contribution = [](const SampleUse& use) { return use.weight * use.pressure; },
    .exact =
        [](const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
           const ExactOptions& how) {
          return FieldIntegral(FieldRays(model, taxel, surfaces, how.rays), how.accuracy,
                               {.weighted = true, .divided = true})
              .read();
        },
    .integral = IntegralKind::weighted_mean};

}  // namespace taxel
