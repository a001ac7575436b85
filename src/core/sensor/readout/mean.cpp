// The aggregate mean: the mean of the pressures, each with the share of its sample.
#include "core/sensor/readout/fold_inl.h"

namespace taxel {
namespace {

template <class V, class ValueOf>
void fold_mean(const SensorModel& model, const ValueOf& value_of, V* readings, double* scratch) {
  for_each_use(model.readout_table, value_of, [&](auto, const V& value, double share, const ReadoutTable::Use& use) {
    readings[at(use.taxel)] += share * value;
    scratch[at(use.taxel)] += share;
  });
  divide(model, readings, scratch, model.readout_table.share_sum);
}

}  // namespace

constinit const AggregateSpec kMean{.fold = fold_mean<double, HitPressure>,
                                    .fold_friction = fold_mean<dvec3, HitFriction>,
                                    .contribution = [](const SampleUse& use) { return use.share * use.pressure; },
                                    .exact =
                                        [](const SensorModel& model, int taxel,
                                           std::span<const ContactSurface* const> surfaces, const ExactOptions& how) {
                                          return FieldIntegral(FieldRays(model, taxel, surfaces, how.rays),
                                                               how.accuracy, {.weighted = false, .divided = true})
                                              .read();
                                        },
                                    .integral = IntegralKind::mean};

}  // namespace taxel
