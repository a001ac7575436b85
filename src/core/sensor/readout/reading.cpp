#include "core/sensor/readout/reading.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/layout/sensor_frame.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {
namespace {

/// Throws Error for an aggregate that takes no rays.
const AggregateSpec& spec_with_fold(Aggregate how) {
  const AggregateSpec& spec = aggregate_spec(how);
  if (spec.fold == nullptr) throw Error("force is an integral over contact polygons, not an aggregate of rays");
  return spec;
}

/// Divides the integrals of a mean by that of the weight: over the part that is hit if misses are omitted, otherwise
/// over the whole field. A taxel without weight reads 0.
template <class V>
void divide_sums(const SensorModel& model, const PressureSums& sums, const std::vector<V>& integrals,
                 std::vector<V>& means) {
  const std::vector<double>& weights =
      model.layout.readout.misses == Misses::omit ? sums.hit : model.skin_fields->whole;
  means.resize(integrals.size());
  for (std::size_t k = 0; k < integrals.size(); ++k) means[k] = weights[k] > 0.0 ? integrals[k] / weights[k] : V(0);
}

void read_mean(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
               std::span<const SurfaceMotion> motions, SensorReading& out) {
  const bool weighted = integral_of(model.layout.readout) == IntegralKind::weighted_mean;
  out.mean_integral.integrate(*model.skin_fields, model.taxel_count(), weighted, surfaces,
                              model.layout.readout.shear ? motions : std::span<const SurfaceMotion>(), out.sums);
  divide_sums(model, out.sums, out.sums.pressure, out.values);
}

}  // namespace

void aggregate(const SensorModel& model, const RayHits& hits, Aggregate how, std::vector<double>& readings) {
  const AggregateSpec& spec = spec_with_fold(how);
  const std::size_t taxels = at(model.taxel_count());
  readings.assign(2 * taxels, 0.0);
  spec.fold(model, {hits}, readings.data(), readings.data() + taxels);
  readings.resize(taxels);
}

void aggregate_friction(const SensorModel& model, const RayHits& hits, std::span<const ContactSurface* const> surfaces,
                        std::span<const SurfaceMotion> motions, Aggregate how, TaxelFriction& friction) {
  const AggregateSpec& spec = spec_with_fold(how);
  const std::size_t taxels = at(model.taxel_count());
  friction.values.assign(taxels, dvec3(0));
  friction.scratch.assign(taxels, 0.0);
  spec.fold_friction(model, {hits, model.rays, surfaces, motions}, friction.values.data(), friction.scratch.data());
}

void read_sensor(const SensorModel& model, std::span<const ContactSurface* const> surfaces, SensorReading& out,
                 RayPath path, std::span<const SurfaceMotion> motions) {
  cast_rays(model, surfaces, path, out.workspace, out.hits);
  switch (integral_of(model.layout.readout)) {
    case IntegralKind::none:
      aggregate(model, out.hits, model.layout.readout.aggregate, out.values);
      break;
    case IntegralKind::force:
      out.integral.integrate(model, *model.skin_fields, surfaces, motions, out.force);
      out.values.assign(out.force.values.begin(), out.force.values.end());
      break;
    case IntegralKind::weighted_mean:
    case IntegralKind::mean:
      read_mean(model, surfaces, motions, out);
      break;
  }
  if (model.layout.readout.shear) read_shear(model, surfaces, motions, out);
}

void read_shear(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
                std::span<const SurfaceMotion> motions, SensorReading& reading) {
  const std::vector<Taxel>& taxels = model.layout.taxels;
  reading.shear.assign(taxels.size(), dvec2(0));
  if (motions.empty()) return;
  switch (integral_of(model.layout.readout)) {
    case IntegralKind::none:
      aggregate_friction(model, reading.hits, surfaces, motions, model.layout.readout.aggregate, reading.friction);
      break;
    case IntegralKind::force:
      reading.friction.values.assign(reading.force.friction.begin(), reading.force.friction.end());
      break;
    case IntegralKind::weighted_mean:
    case IntegralKind::mean:
      divide_sums(model, reading.sums, reading.sums.friction, reading.friction.values);
      break;
  }
  for (std::size_t k = 0; k < taxels.size(); ++k) {
    const TangentFrame frame = tangent_frame(model.layout.frame, taxels[k].normal);
    reading.shear[k] = {glm::dot(reading.friction.values[k], frame.e1), glm::dot(reading.friction.values[k], frame.e2)};
  }
}

ExactReading exact_reading(const SensorModel& model, int taxel, std::span<const ContactSurface* const> surfaces,
                           const ExactOptions& how) {
  if (taxel < 0 || taxel >= model.taxel_count())
    throw Error(fmt::format("there is no taxel {}, the layout has {}", taxel, model.taxel_count()));
  return aggregate_spec(model.layout.readout.aggregate).exact(model, taxel, surfaces, how);
}

void read_slip(const SensorModel& model, const FieldWeights& weights,
               std::span<const StickingFriction* const> frictions, std::vector<double>& slip) {
  slip.assign(at(model.taxel_count()), 0.0);
  std::vector<double> touched(slip.size(), 0.0);
  std::vector<int> discs;
  FieldWeights::AtPoint fields;
  for (const StickingFriction* friction : frictions) {
    if (friction == nullptr) continue;
    for (const StickingFriction::Root& root : friction->roots) {
      const SurfacePoint s = model.skin->closest_point(root.place);
      weights.near(s.position, 0, discs);
      weights.at(s.face, s.position, discs, fields);
      for (const FieldWeights::Weight& w : fields.weights) {
        touched[at(w.taxel)] += w.value * root.area;
        if (root.slips) slip[at(w.taxel)] += w.value * root.area;
      }
    }
  }
  for (std::size_t k = 0; k < slip.size(); ++k)
    if (touched[k] > 0) slip[k] /= touched[k];
}

}  // namespace taxel
