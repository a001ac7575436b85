#include "core/sensor/error_bars/sampling_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/layout/field/dense_fields.h"
#include "core/sensor/explain/exact_reading.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {

bool SamplingError::takes_samples(const Readout& readout) {
  return integral_of(readout) == IntegralKind::none;
}

std::string SamplingError::why_none(const Readout& readout) {
  if (!takes_samples(readout)) return "the readings are integrals: no samples are taken";
  if (readout.ray == RayDirection::taxel_normal)
    return "rays along the taxel's normal have no integral: /readout/ray must be \"surface_normal\"";
  return "";
}

SamplingError::SamplingError(SensorModelPtr model) : model_(std::move(model)) {
  const Readout& readout = model_->layout.readout;
  if (const std::string why = why_none(readout); !why.empty()) throw Error(model_->layout.name, "/readout", why);
  const AggregateSpec& spec = aggregate_spec(readout.aggregate);
  divided_ = !spec.grows_with_samples;
  const IntegralKind kind = divided_ ? spec.integral : IntegralKind::weighted_mean;
  weighted_ = kind == IntegralKind::weighted_mean;
  if (kind == IntegralKind::none) return;
  fields_ = skin_fields_for(*model_, kind);
  whole_.resize(at(model_->taxel_count()));
  for (std::size_t ray = 0; ray < model_->rays.size(); ++ray) add_uses(static_cast<std::int32_t>(ray), 0.0, whole_);
}

/// Adds a ray to the sums of the taxels that use it.
void SamplingError::add_uses(std::int32_t ray, double pressure, std::vector<Sums>& sums) const {
  const ReadoutTable& table = model_->readout_table;
  for (std::int32_t u = table.first[at(ray)]; u < table.first[at(ray + 1)]; ++u) {
    const ReadoutTable::Use& use = table.uses[at(u)];
    const double c = weighted_ ? use.weight : table.share[at(ray)];
    Sums& sum = sums[at(use.taxel)];
    sum.c += c, sum.c2 += c * c;
    sum.c2p += c * c * pressure, sum.c2p2 += c * c * pressure * pressure;
    ++sum.samples;
  }
}

void SamplingError::integrate(std::span<const ContactSurface* const> surfaces) {
  integral_.integrate(*fields_, model_->taxel_count(), weighted_, surfaces, {}, sums_);
  const std::vector<double>& over = model_->layout.readout.misses == Misses::omit ? sums_.hit : fields_->whole;
  const double samples_per_area =
      uniform_samples(model_->layout, model_->samples.size(), model_->sampled_area) / model_->sampled_area;
  for (std::size_t k = 0; k < exact_.size(); ++k) {
    if (!divided_) {
      exact_[k] = samples_per_area * sums_.pressure[k];
    } else if (over[k] > 0) {
      exact_[k] = sums_.pressure[k] / over[k];
    }
  }
}

// For independent samples, a mean r = sum c p / sum c has the variance sum c^2 (p - r)^2 / (sum c)^2, and a sum of n
// terms c p the variance sum (c p)^2 - (sum c p)^2 / n.
void SamplingError::measure_noise(std::span<const RayHit> hits, std::span<const double> readings) {
  of_hits_.assign(exact_.size(), {});
  for (std::size_t ray = 0; ray < hits.size(); ++ray)
    if (hits[ray].hit()) add_uses(static_cast<std::int32_t>(ray), hits[ray].pressure, of_hits_);
  const bool omit = model_->layout.readout.misses == Misses::omit;
  for (std::size_t k = 0; k < noise_.size(); ++k) {
    const Sums& hit = of_hits_[k];
    const Sums& over = omit ? hit : whole_[k];
    const double r = readings[k];
    if (hit.samples == 0) continue;
    const double variance = divided_ ? (hit.c2p2 - 2 * r * hit.c2p + r * r * over.c2) / (over.c * over.c)
                                     : hit.c2p2 - r * r / whole_[k].samples;
    noise_[k] = std::sqrt(std::max(0.0, variance));
  }
}

/// Computes the exact readings one by one. Without a sample that is hit, a largest pressure cannot be ruled out, so
/// all taxels near a surface are computed; a taxel without an exact reading has the bar 0, as its reading is 0.
void SamplingError::read_each(std::span<const ContactSurface* const> surfaces, std::span<const double> readings) {
  Aabb touched;
  for (const ContactSurface* surface : surfaces)
    if (surface != nullptr)
      for (std::size_t i = 0; i < surface->vertices.size(); ++i) touched.include(surface->vertices[i]);
  for (std::size_t k = 0; k < exact_.size(); ++k) {
    const Taxel& taxel = model_->layout.taxels[k];
    const double reach = taxel.radius + model_->max_depth;
    const bool near = !touched.empty() && glm::all(glm::lessThanEqual(touched.lo, taxel.center + reach)) &&
                      glm::all(glm::greaterThanEqual(touched.hi, taxel.center - reach));
    if (!near && taxel.subtaxels.empty()) continue;
    exact_[k] = exact_reading(*model_, static_cast<int>(k), surfaces).value.value_or(readings[k]);
  }
}

void SamplingError::measure(std::span<const ContactSurface* const> surfaces, std::span<const RayHit> hits,
                            std::span<const double> readings) {
  exact_.assign(at(model_->taxel_count()), 0.0);
  noise_.assign(exact_.size(), 0.0);
  bars_.assign(exact_.size(), 0.0);
  if (readings.size() != exact_.size()) throw Error("a reading is needed for each taxel");
  if (fields_ != nullptr) {
    integrate(surfaces);
    measure_noise(hits, readings);
  } else {
    read_each(surfaces, readings);
  }
  for (std::size_t k = 0; k < exact_.size(); ++k)
    bars_[k] = kWidening * std::abs(readings[k] - exact_[k]) + kAccuracy * std::max(readings[k], exact_[k]) +
               kNoise * noise_[k];
}

}  // namespace taxel
