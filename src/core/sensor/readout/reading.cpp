#include "core/sensor/readout/reading.h"

#include <limits>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/layout/tangent_frame.h"

namespace taxel {
namespace {

/// Calls body(ray, value of the ray, its share, use) for every entry of every ray that was hit.
template <class ValueOf, class Body>
void for_each_use(const ReadoutTable& table, const RayHits& hits, const ValueOf& value_of, const Body& body) {
  for (const std::int32_t ray : hits.hit_rays()) {
    const auto value = value_of(ray);
    const double share = table.share[at(ray)];
    for (std::int32_t u = table.first[at(ray)]; u < table.first[at(ray) + 1]; ++u)
      body(ray, value, share, table.uses[at(u)]);
  }
}

template <class V>
void divide(V* sums, const double* weights, std::size_t taxels) {
  for (std::size_t k = 0; k < taxels; ++k) sums[k] = weights[k] > 0.0 ? sums[k] / weights[k] : V(0);
}

/// Aggregates what value_of(ray) is where a ray hit. `sum` and `of_hits` (weights, or whatever decides which ray is
/// picked) are zeros, one per taxel.
template <class V, class ValueOf>
void aggregate(const SensorModel& model, const RayHits& hits, Aggregate how, const ValueOf& value_of, V* sum,
               double* of_hits) {
  const ReadoutTable& table = model.readout_table;
  const bool omit_misses = model.layout.readout.misses == Misses::omit;
  const std::size_t taxels = at(model.taxel_count());
  switch (how) {
    case Aggregate::weighted_mean:
    case Aggregate::weighted_sum:
      for_each_use(table, hits, value_of, [&](auto, const V& value, double, const ReadoutTable::Use& use) {
        sum[at(use.taxel)] += use.weight * value;
        of_hits[at(use.taxel)] += use.weight;
      });
      if (how == Aggregate::weighted_mean) divide(sum, omit_misses ? of_hits : table.weight_sum.data(), taxels);
      break;
    case Aggregate::mean:
      for_each_use(table, hits, value_of, [&](auto, const V& value, double share, const ReadoutTable::Use& use) {
        sum[at(use.taxel)] += share * value;
        of_hits[at(use.taxel)] += share;
      });
      divide(sum, omit_misses ? of_hits : table.share_sum.data(), taxels);
      break;
    case Aggregate::nearest:
      if (!omit_misses) {
        for (std::size_t k = 0; k < taxels; ++k) {
          const std::int32_t ray = table.nearest[k];
          if (ray >= 0 && hits[ray].hit()) sum[k] = value_of(ray);
        }
        break;
      }
      std::fill_n(of_hits, taxels, std::numeric_limits<double>::infinity());
      for_each_use(table, hits, value_of, [&](auto, const V& value, double, const ReadoutTable::Use& use) {
        const std::size_t k = at(use.taxel);
        if (use.distance < of_hits[k]) of_hits[k] = use.distance, sum[k] = value;
      });
      break;
    case Aggregate::max:
      for_each_use(table, hits, value_of, [&](std::int32_t ray, const V& value, double, const ReadoutTable::Use& use) {
        const std::size_t k = at(use.taxel);
        if (hits[ray].pressure > of_hits[k]) of_hits[k] = hits[ray].pressure, sum[k] = value;
      });
      break;
    case Aggregate::force:
      throw Error("force is an integral over contact polygons, not an aggregate of rays");
  }
}

}  // namespace

void aggregate(const SensorModel& model, const RayHits& hits, Aggregate how, std::vector<double>& readings) {
  const std::size_t taxels = at(model.taxel_count());
  readings.assign(2 * taxels, 0.0);
  aggregate(
      model, hits, how, [&](std::int32_t ray) { return hits[ray].pressure; }, readings.data(),
      readings.data() + taxels);
  readings.resize(taxels);
}

void aggregate_friction(const SensorModel& model, const RayHits& hits, std::span<const ContactSurface* const> surfaces,
                        std::span<const SurfaceMotion> motions, Aggregate how, TaxelFriction& friction) {
  const std::size_t taxels = at(model.taxel_count());
  friction.values.assign(taxels, dvec3(0));
  friction.scratch.assign(taxels, 0.0);
  const auto traction_of = [&](std::int32_t ray) {
    const RayHit& hit = hits[ray];
    const SensorRay& from = model.rays[at(ray)];
    const dvec3 x = from.origin + hit.depth * from.direction;
    const SurfaceMotion& motion = motions[at(hit.surface)];
    return friction_traction(hit.pressure, surfaces[at(hit.surface)]->polygons[at(hit.polygon)].normal,
                             motion.velocity(x), motion.properties);
  };
  aggregate(model, hits, how, traction_of, friction.values.data(), friction.scratch.data());
}

void read_sensor(const SensorModel& model, std::span<const ContactSurface* const> surfaces, SensorReading& out,
                 RayPath path, std::span<const SurfaceMotion> motions) {
  cast_rays(model, surfaces, path, out.workspace, out.hits);
  if (model.layout.readout.aggregate == Aggregate::force) {
    out.integral.integrate(model, *model.weights, surfaces, motions, out.force);
    out.values.assign(out.force.values.begin(), out.force.values.end());
  } else {
    aggregate(model, out.hits, model.layout.readout.aggregate, out.values);
  }
  if (model.layout.readout.shear) read_shear(model, surfaces, motions, out);
}

void read_shear(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
                std::span<const SurfaceMotion> motions, SensorReading& reading) {
  const std::vector<Taxel>& taxels = model.layout.taxels;
  reading.shear.assign(taxels.size(), dvec2(0));
  if (motions.empty()) return;
  if (model.layout.readout.aggregate == Aggregate::force)
    reading.friction.values.assign(reading.force.friction.begin(), reading.force.friction.end());
  else
    aggregate_friction(model, reading.hits, surfaces, motions, model.layout.readout.aggregate, reading.friction);
  for (std::size_t k = 0; k < taxels.size(); ++k) {
    const TangentFrame frame = tangent_frame(model.layout.frame, taxels[k].normal);
    reading.shear[k] = {glm::dot(reading.friction.values[k], frame.e1), glm::dot(reading.friction.values[k], frame.e2)};
  }
}

}  // namespace taxel
