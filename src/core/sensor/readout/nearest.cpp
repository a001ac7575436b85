// The aggregate nearest: the pressure at the sample nearest to the taxel's centre, or at the nearest one that was hit
// if misses are omitted.
#include "core/sensor/readout/fold_inl.h"

namespace taxel {
namespace {

template <class V, class ValueOf>
void fold_nearest(const SensorModel& model, const ValueOf& value_of, V* readings, double* scratch) {
  const ReadoutTable& table = model.readout_table;
  const std::size_t taxels = at(model.taxel_count());
  if (model.layout.readout.misses != Misses::omit) {
    for (std::size_t k = 0; k < taxels; ++k) {
      const std::int32_t ray = table.nearest[k];
      if (ray >= 0 && value_of.hits[ray].hit()) readings[k] = value_of(ray);
    }
    return;
  }
  std::fill_n(scratch, taxels, std::numeric_limits<double>::infinity());
  for_each_use(table, value_of, [&](auto, const V& value, double, const ReadoutTable::Use& use) {
    const std::size_t k = at(use.taxel);
    if (use.distance < scratch[k]) scratch[k] = use.distance, readings[k] = value;
  });
}

ExactReading exact_nearest(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                           const ExactOptions& how) {
  const FieldRays rays(model, taxel, surfaces, how.rays);
  const Taxel& of = model.layout.taxels[at(taxel)];
  ExactReading out;
  if (!of.subtaxels.empty()) {
    out.missing = "the nearest sample of a taxel with subtaxels has no limit";
    return out;
  }
  const std::optional<FieldRays::Start> start = rays.nearest_start(of.center);
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

constinit const AggregateSpec kNearest{.fold = fold_nearest<double, HitPressure>,
                                       .fold_friction = fold_nearest<dvec3, HitFriction>,
                                       .rank = [](const SampleUse& use) { return -use.distance; },
                                       .exact = exact_nearest};

}  // namespace taxel
