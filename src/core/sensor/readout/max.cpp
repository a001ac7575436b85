// The aggregate max: the largest pressure, and the friction at that sample.
#include "core/sensor/readout/fold_inl.h"

namespace taxel {
namespace {

template <class V, class ValueOf>
void fold_max(const SensorModel& model, const ValueOf& value_of, V* readings, double* scratch) {
  for_each_use(model.readout_table, value_of,
               [&](std::int32_t ray, const V& value, double, const ReadoutTable::Use& use) {
                 const std::size_t k = at(use.taxel);
                 const double pressure = value_of.hits[ray].pressure;
                 if (pressure > scratch[k]) scratch[k] = pressure, readings[k] = value;
               });
}

}  // namespace

constinit const AggregateSpec kMax{
    .fold = fold_max<double, HitPressure>,
    .fold_friction = fold_max<dvec3, HitFriction>,
    .rank = [](const SampleUse& use) { return use.pressure; },
    .exact =
        [](const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
           const ExactOptions& how) {
          return FieldIntegral(FieldRays(model, taxel, surfaces, how.rays), how.accuracy).read_largest();
        }};

}  // namespace taxel
