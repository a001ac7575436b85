#include "core/sensor/explain/disagreement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/sensor/explain/exact_reading.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {
namespace {

constexpr double kAccuracy = 0.01;  // relative accuracy of the exact reading

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
      exact = exact_reading(model, taxel, surfaces, {.accuracy = kAccuracy});
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

}  // namespace taxel
