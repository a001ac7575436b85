#include "core/sensor/error_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/layout/field/receptive_field.h"
#include "core/mesh/topology/remesh.h"
#include "core/sensor/rays/tet_table.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {

SensorModelPtr with_samples_times(double factor, const SensorModelPtr& model, SensorCache& cache, Progress* progress) {
  const double samples = factor * model->layout.sampling.density * model->sampled_area;
  if (!(samples <= kMaxSamples))
    throw Error("", "/sampling/density",
                fmt::format("{} times the samples are {:.4g}, the limit is {}", factor, samples, kMaxSamples));
  SensorBuild how(progress);
  how.cache = &cache;
  how.quality = model->quality;
  Layout layout = model->layout;
  multiply_densities(layout, factor);
  return build_sensor_model(layout, model->loaded, "", layout.name, how);
}

ConvergenceModels make_convergence_models(const SensorModelPtr& model, SensorCache& cache, Progress* progress) {
  ConvergenceModels models;
  models[Convergence::kAsked] = model;
  for (std::size_t i = models.size(); i-- > 0;)  // the largest first, because only it can have too many samples
    if (i != Convergence::kAsked) models[i] = with_samples_times(Convergence::kFactors[i], model, cache, progress);
  return models;
}

Convergence read_convergence(const ConvergenceModels& models, std::span<const ContactSurface* const> surfaces) {
  Convergence convergence;
  convergence.aggregate = models[Convergence::kAsked]->layout.readout.aggregate;
  SensorReading reading;
  for (std::size_t i = 0; i < models.size(); ++i) {
    read_sensor(*models[i], surfaces, reading);
    convergence.samples[i] = static_cast<int>(models[i]->samples.size());
    convergence.values[i] = reading.values;
  }
  return convergence;
}

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

namespace {

constexpr double kGapAccuracy = 0.01;  // relative accuracy of the exact reading of a SampleGap

std::vector<Aabb> boxes_of(std::span<const ContactSurface* const> surfaces) {
  std::vector<Aabb> boxes;
  for (const ContactSurface* surface : surfaces) {
    if (surface == nullptr || surface->empty()) continue;
    Aabb box;
    for (const dvec3& v : surface->vertices) box.include(v);
    boxes.push_back(box);
  }
  return boxes;
}

/// False only where no ray from the taxel's field can meet a surface: rays begin within the radius of a centre, and are
/// no longer than the model's.
bool in_reach(const SensorModel& model, const Taxel& taxel, std::span<const Aabb> boxes) {
  const std::vector<FieldDisc> discs = discs_of(taxel);
  const double lead = 1e-5 * model.skin->mesh().bounds().diagonal();  // rays of rigid sensors start outside
  return std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& box) {
    return std::any_of(discs.begin(), discs.end(), [&](const FieldDisc& disc) {
      // A field along the surface has its centre there, no farther from the disc's than the skin is.
      const double moved = glm::distance(disc.center, model.skin->closest_point(disc.center).position);
      const dvec3 nearest = glm::clamp(disc.center, box.lo, box.hi);
      return glm::distance(nearest, disc.center) <= disc.radius + moved + model.max_depth + lead;
    });
  });
}

}  // namespace

/// Computes the exact readings one by one. Without a sample that is hit, a largest pressure cannot be ruled out, so
/// all taxels near a surface are computed; a taxel without an exact reading has the bar 0, as its reading is 0.
void SamplingError::read_each(std::span<const ContactSurface* const> surfaces, std::span<const double> readings) {
  const std::vector<Aabb> boxes = boxes_of(surfaces);
  for (std::size_t k = 0; k < exact_.size(); ++k)
    if (readings[k] != 0 || in_reach(*model_, model_->layout.taxels[k], boxes))
      exact_[k] = exact_reading(*model_, static_cast<int>(k), surfaces).value.value_or(readings[k]);
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

double gap_of(double sampled, double exact, double error) {
  return std::max(0.0, std::abs(sampled - exact) - error);
}

std::optional<SampleGap> largest_sample_gap(const SensorModel& model, std::span<const ContactSurface* const> surfaces,
                                            std::span<const double> readings, std::span<const double> scales) {
  if (aggregate_spec(model.layout.readout.aggregate).fold == nullptr || readings.size() != model.layout.taxels.size())
    return std::nullopt;
  const std::vector<Aabb> boxes = boxes_of(surfaces);
  const int count = model.taxel_count();
  std::vector<std::optional<SampleGap>> gaps(readings.size());
  parallel_chunks(count, 1, [&](int taxel, int) {
    const auto k = static_cast<std::size_t>(taxel);
    if (!scales.empty() && std::isinf(scales[k])) return;
    ExactReading exact;
    exact.value = 0;
    if (readings[k] != 0 || in_reach(model, model.layout.taxels[k], boxes))
      exact = exact_reading(model, taxel, surfaces, {.accuracy = kGapAccuracy});
    if (!exact.value) return;
    gaps[k] = SampleGap{taxel, readings[k], *exact.value, gap_of(readings[k], *exact.value, exact.error)};
  });
  std::optional<SampleGap> largest;
  double largest_part = 0;
  for (const std::optional<SampleGap>& gap : gaps) {
    if (!gap) continue;
    const double scale = scales.empty() ? 1.0 : scales[static_cast<std::size_t>(gap->taxel)];
    const double part = scale > 0 ? gap->gap / scale : 0.0;
    if (largest && !(part > largest_part)) continue;
    largest = gap;
    largest_part = part;
  }
  return largest;
}

Shape finer_shape(Shape shape, const Material& material) {
  switch (shape.type) {
    case ShapeType::plane:
    case ShapeType::box:
    case ShapeType::tets:
      break;
    case ShapeType::mesh:
      if (!material.compliant()) break;
      shape.mesh = std::make_shared<const TriMesh>(subdivide(*shape.mesh, 1, SubdivisionScheme::midpoint));
      shape.face_numbers.clear();
      break;
    default:
      shape.resolution = 0.5 * tessellation_edge(shape);
  }
  return shape;
}

SensorModelPtr with_finer_body(const SensorModelPtr& model) {
  if (!model->body->soft()) return model;
  Shape shape;
  shape.type = ShapeType::mesh;
  shape.mesh = model->mesh;
  shape.refine = model->layout.mesh.repair.refine.value_or(kDefaultRefine);
  auto finer = std::make_shared<SensorModel>(*model);
  finer->body =
      make_body(finer_shape(std::move(shape), model->layout.material), model->layout.material, model->layout.name);
  finer->ray_tables.tets = nullptr;
  if (const auto* soft = std::get_if<SoftBody>(&finer->body->geometry))
    finer->ray_tables.tets = std::make_shared<const TetTable>(*soft->field, finer->rays);
  if (model->skin_fields != nullptr) finer->skin_fields = skin_fields_for(*finer, integral_of(model->layout.readout));
  return finer;
}

std::vector<double> richardson_bars(std::span<const double> coarse, std::span<const double> fine) {
  std::vector<double> bars;
  for (std::size_t k = 0; k < coarse.size(); ++k) bars.push_back(4.0 / 3.0 * std::abs(coarse[k] - fine[k]));
  return bars;
}

}  // namespace taxel
